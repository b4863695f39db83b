//! What prints cost, reckoned by hand.

use super::*;
use crate::strand::{Kind, Strand};
use crate::wireframe::frame::{Reason, Unprinted};
use crate::wireframe::plan::columns::Need;

fn strand(from: f64, to: f64, floating: bool) -> Strand {
    let (from, to) = (DVec3::X * from, DVec3::X * to);
    Strand { from, to, kind: Kind::Contour, slab: 0, floating, flow: 1.0, direct: false }
}

fn entries(strands: Vec<Strand>) -> Entries {
    Entries { strands, ..Entries::default() }
}

#[test]
fn strands_cost_their_length_pauses_and_travels_what_they_take() {
    let plain = |from: Option<f64>, strands: Vec<Strand>| {
        cost(from.map(|x| DVec3::X * x), &entries(strands)).plain
    };
    assert_eq!(plain(None, vec![strand(0.0, 10.0, false)]), 10.0);
    assert_eq!(plain(None, vec![strand(0.0, 10.0, true)]), 10.0 + PAUSE);
    // On from where the last one ended, and across a gap.
    let on = vec![strand(0.0, 10.0, false), strand(10.0, 4.0, false)];
    assert_eq!(plain(None, on.clone()), 16.0);
    assert_eq!(plain(Some(0.0), on.clone()), 16.0);
    assert_eq!(plain(Some(-5.0), on), 16.0 + HOP + 5.0 / TRAVEL);
    let apart = vec![strand(0.0, 10.0, false), strand(30.0, 34.0, false)];
    assert_eq!(plain(None, apart), 14.0 + HOP + 20.0 / TRAVEL);
    assert_eq!(plain(None, Vec::new()), 0.0);
}

#[test]
fn what_is_left_out_weighs_more_than_anything_and_sag_more_than_its_strand() {
    let mut short = entries(vec![strand(0.0, 1.0, false)]);
    let long = entries(vec![strand(0.0, 1000.0, true)]);
    assert!(cost(None, &short) < cost(None, &long));
    short.sag = 2.0;
    let of = cost(None, &short);
    assert_eq!((of.whole, of.plain), (1.0 + SAG * 2.0, 1.0));
    let part = |area: f64| Unprinted {
        low: 0.0,
        high: 1.0,
        area,
        place: DVec3::ZERO,
        reason: Reason::MidAir,
    };
    short.unprinted = vec![part(3.2), part(4.1)];
    assert_eq!(cost(None, &short).area, 7.0);
    assert!(cost(None, &long) < cost(None, &short));
}

#[test]
fn every_column_costs_as_much_as_zigzags_around_it() {
    let need = Need { level: 3, place: glam::DVec2::ZERO, urgent: false };
    let with = Entries { columns: vec![need; 2], ..entries(vec![strand(0.0, 1.0, false)]) };
    assert_eq!(cost(None, &with).plain, 1.0 + 2.0 * COLUMN);
}
