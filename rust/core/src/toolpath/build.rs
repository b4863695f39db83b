//! From strands to moves: travels that clear what stands, retractions, skirt and brim.

use glam::{DVec2, DVec3};

use super::bed::{brim, skirt};
use super::mechanics::print;
use super::{PathParams, Toolpath};
use crate::strand::{Kind, Strand};

/// Travels shorter than this, mm, need no retraction: nothing oozes far enough to matter.
const SHORT: f64 = 1.0;

/// The moves that print `strands` in their order.
#[must_use]
pub fn toolpath(strands: &[Strand], p: &PathParams) -> Toolpath {
    let mut path = Toolpath::default();
    let mut top = p.first_layer;
    let bed: Vec<Strand> = bed_lines(strands, p);
    for strand in bed.iter().chain(strands) {
        let strand = placed(strand, p.centre);
        approach(&mut path, &strand, top, p);
        print(&mut path, &strand, p);
        top = top.max(strand.from.z).max(strand.to.z);
    }
    leave(&mut path, top, p);
    path
}

fn placed(strand: &Strand, centre: DVec2) -> Strand {
    let shift = centre.extend(0.0);
    Strand { from: strand.from + shift, to: strand.to + shift, ..*strand }
}

/// Brim and skirt as strands, the skirt first.
fn bed_lines(strands: &[Strand], p: &PathParams) -> Vec<Strand> {
    let first: Vec<&Strand> = strands
        .iter()
        .take_while(|s| s.from.z <= p.first_layer + 1e-9 && s.to.z <= p.first_layer + 1e-9)
        .collect();
    let brim = brim(&first, p);
    let skirt = skirt(&first, &brim, p);
    let rings = skirt.iter().map(|r| (r, Kind::Skirt)).chain(brim.iter().map(|r| (r, Kind::Brim)));
    rings
        .flat_map(|(ring, kind)| {
            let count = ring.len();
            (0..count).map(move |i| Strand {
                from: ring[i].extend(p.first_layer),
                to: ring[(i + 1) % count].extend(p.first_layer),
                kind,
                slab: 0,
                floating: false,
                flow: 1.0,
                direct: false,
            })
        })
        .collect()
}

/// Brings the head to the strand's beginning: back, up over all that stands, across, down; or
/// straight, where nothing is in the way.
fn approach(path: &mut Toolpath, strand: &Strand, top: f64, p: &PathParams) {
    let (at, slab) = (path.at(), strand.slab);
    if path.to.is_empty() {
        path.start = strand.from.truncate().extend(top + p.travel_lift);
        path.travel(path.start, p.travel_speed, slab);
        path.travel(strand.from, p.travel_speed, slab);
        if p.prime > 0.0 {
            path.add(strand.from, Kind::Unretract, p.unretract_speed, p.prime, slab);
        }
        return;
    }
    if at == strand.from {
        return;
    }
    let over = top + p.travel_lift;
    let short = if strand.direct { p.layer_retract_over } else { SHORT };
    let far = at.distance(strand.from) > short && p.retract > 0.0;
    if far {
        path.add(at, Kind::Retract, p.retract_speed, -p.retract, slab);
    }
    if !strand.direct {
        path.travel(DVec3::new(at.x, at.y, over.max(at.z)), p.travel_speed, slab);
        path.travel(strand.from.truncate().extend(over.max(at.z)), p.travel_speed, slab);
    }
    path.travel(strand.from, p.travel_speed, slab);
    if far {
        path.add(strand.from, Kind::Unretract, p.unretract_speed, p.retract, slab);
    }
}

/// Ends above all that stands, the filament pulled back.
fn leave(path: &mut Toolpath, top: f64, p: &PathParams) {
    let Some(&slab) = path.slab.last() else { return };
    let at = path.at();
    if p.retract > 0.0 {
        path.add(at, Kind::Retract, p.retract_speed, -p.retract, slab);
    }
    path.travel(DVec3::new(at.x, at.y, top + p.travel_lift), p.travel_speed, slab);
}
