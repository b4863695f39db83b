//! What prints cost, reckoned by hand.

use super::*;
use crate::strand::{Kind, Strand};
use crate::wireframe::frame::{Reason, Unprinted};
use crate::wireframe::plan::columns::Need;

fn strand(from: f64, to: f64, floating: bool) -> Strand {
    let (from, to) = (DVec3::X * from, DVec3::X * to);
    Strand { from, to, kind: Kind::Contour, slab: 0, floating, flow: 1.0, direct: false }
}

const STRAND: f64 = 0.7;
const TIMES: Times =
    Times { print_speed: 30.0, travel_speed: 150.0, pause: 1.0, hop: 0.25, climb: None };

/// What entries cost on the paper's printer.
fn costs(from: Option<f64>, entries: &Entries) -> Cost {
    cost(from.map(|x| DVec3::X * x), entries, STRAND, &TIMES)
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

fn entries(strands: Vec<Strand>) -> Entries {
    Entries { strands, ..Entries::default() }
}

#[test]
fn strands_cost_their_length_pauses_and_travels_what_they_take() {
    let costs = |from: Option<f64>, strands: Vec<Strand>, expected: f64| {
        let plain = costs(from, &entries(strands)).plain;
        assert!(is_near(plain, expected), "{plain} s, not {expected}");
    };
    costs(None, vec![strand(0.0, 15.0, false)], 0.5);
    costs(None, vec![strand(0.0, 15.0, true)], 1.5);
    // On from where the last one ended, and across a gap.
    let on = vec![strand(0.0, 15.0, false), strand(15.0, 9.0, false)];
    costs(None, on.clone(), 0.7);
    costs(Some(0.0), on.clone(), 0.7);
    costs(Some(-15.0), on, 0.7 + 0.25 + 0.1);
    let apart = vec![strand(0.0, 15.0, false), strand(45.0, 51.0, false)];
    costs(None, apart, 0.7 + 0.25 + 0.2);
    costs(None, Vec::new(), 0.0);
}

#[test]
fn a_slow_travel_and_a_long_pause_cost_what_they_take() {
    let lone = entries(vec![strand(0.0, 15.0, true), strand(45.0, 51.0, true)]);
    let slow = Times { travel_speed: 30.0, pause: 3.0, ..TIMES };
    assert!(is_near(cost(None, &lone, STRAND, &slow).plain, 0.7 + 6.0 + 0.25 + 1.0));
}

#[test]
fn what_is_left_out_weighs_more_than_anything_and_sag_more_than_its_strand() {
    let mut short = entries(vec![strand(0.0, 1.0, false)]);
    let long = entries(vec![strand(0.0, 1000.0, true)]);
    assert!(costs(None, &short) < costs(None, &long));
    short.sag = 2.0;
    let of = costs(None, &short);
    assert!(is_near(of.plain, 1.0 / 30.0), "{of:?}");
    assert!(is_near(of.whole, (1.0 + SAG * 2.0 / STRAND) / 30.0), "{of:?}");
    let part = |area: f64| Unprinted {
        low: 0.0,
        high: 1.0,
        area,
        place: DVec3::ZERO,
        reason: Reason::MidAir,
    };
    short.unprinted = vec![part(3.2), part(4.1)];
    assert_eq!(costs(None, &short).area, 7.0);
    assert!(costs(None, &long) < costs(None, &short));
}

#[test]
fn every_column_costs_as_much_as_zigzags_around_it() {
    let need = Need { level: 3, place: glam::DVec2::ZERO, urgent: false };
    let with = Entries { columns: vec![need; 2], ..entries(vec![strand(0.0, 1.0, false)]) };
    assert!(is_near(costs(None, &with).plain, (1.0 + 2.0 * COLUMN * STRAND) / 30.0));
}
