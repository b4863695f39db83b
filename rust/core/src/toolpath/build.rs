//! From strands to moves: travels that clear what stands, retractions, skirt and brim.

use std::collections::HashSet;

use glam::{DVec2, DVec3};

use super::Toolpath;
use super::bed::{brim, rings, skirt};
use super::mechanics::{air, airy_share, pause, speed};
use super::params::{PathParams, Strategy};
use super::pressure::{Pressure, wanted};
use super::tuning::{LEAST_PAUSE, SHORT};
use crate::strand::{Kind, Strand};

/// The moves that print `strands` in their order.
#[must_use]
pub fn toolpath(strands: &[Strand], p: &PathParams) -> Toolpath {
    let (brim_rings, lines) = bed_lines(strands, p);
    let all: Vec<Strand> =
        lines.iter().chain(strands).map(|strand| placed(strand, p.centre)).collect();
    let mut builder = Builder::new(p);
    for (i, strand) in all.iter().enumerate() {
        builder.approach(strand);
        builder.print(strand, all.get(i + 1));
    }
    builder.leave();
    Toolpath { brim_rings, ..builder.path }
}

fn placed(strand: &Strand, centre: DVec2) -> Strand {
    let shift = centre.extend(0.0);
    Strand { from: strand.from + shift, to: strand.to + shift, ..*strand }
}

/// Brim and skirt as strands, the skirt first, and the number of the brim's rings.
fn bed_lines(strands: &[Strand], p: &PathParams) -> (u32, Vec<Strand>) {
    let first: Vec<&Strand> =
        strands.iter().take_while(|s| p.is_on_bed(s.from.z.max(s.to.z))).collect();
    let height = strands.iter().map(|s| s.from.z.max(s.to.z)).fold(0.0, f64::max);
    let count = rings(&first, height, p);
    let brim = brim(&first, count, p);
    let skirt = skirt(&first, &brim, p);
    let rings = skirt.iter().map(|r| (r, Kind::Skirt)).chain(brim.iter().map(|r| (r, Kind::Brim)));
    let lines = rings
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
        .collect();
    (if brim.is_empty() { 0 } else { count }, lines)
}

/// A toolpath under way.
struct Builder<'a> {
    p: &'a PathParams,
    path: Toolpath,
    /// Greatest height of what stands, mm.
    top: f64,
    pressure: Pressure,
    /// Where strands ended so far; only ever asked whether a point is among them.
    ends: HashSet<[u64; 3]>,
}

impl<'a> Builder<'a> {
    fn new(p: &'a PathParams) -> Self {
        Self {
            p,
            path: Toolpath::default(),
            top: p.first_layer.max(p.standing),
            pressure: Pressure::default(),
            ends: HashSet::new(),
        }
    }

    /// Brings the head to the strand's beginning, the nozzle full.
    fn approach(&mut self, strand: &Strand) {
        let wanted = wanted(strand, speed(strand, self.p), self.p);
        if self.path.to.is_empty() {
            self.begin(strand);
            self.pressure.fill(wanted);
        } else if self.path.at() != strand.from {
            self.travel(strand);
        }
        if let Some(feed) = self.pressure.prepare(wanted) {
            self.feed(strand, feed, 0.0);
        }
    }

    /// Comes down to the first strand and fills the nozzle.
    fn begin(&mut self, strand: &Strand) {
        let (p, path, slab) = (self.p, &mut self.path, strand.slab);
        path.start = strand.from.truncate().extend(self.top + p.travel_lift);
        path.travel(path.start, p.travel_speed, slab);
        path.travel(strand.from, p.travel_speed, slab);
        if p.prime > 0.0 {
            path.add(strand.from, Kind::Unretract, p.unretract_speed, p.prime, slab);
        }
    }

    /// Travels: back, up over all that stands, across, down; or straight, where nothing is in the
    /// way.
    fn travel(&mut self, strand: &Strand) {
        let (p, path, slab) = (self.p, &mut self.path, strand.slab);
        let (at, over) = (path.at(), self.top + p.travel_lift);
        let short = if strand.direct { p.layer_retract_over } else { SHORT };
        // How far the head goes, the lift aside: over whatever stands higher than both ends.
        let climb = if strand.direct { 0.0 } else { self.top - at.z.max(strand.from.z) };
        let far = at.distance(strand.from) + climb.max(0.0) > short && p.retract > 0.0;
        let pulled = self.pressure.left_of(p.retract, p);
        if far {
            path.add(at, Kind::Retract, p.retract_speed, -pulled, slab);
        }
        if !strand.direct {
            path.travel(DVec3::new(at.x, at.y, over.max(at.z)), p.travel_speed, slab);
            path.travel(strand.from.truncate().extend(over.max(at.z)), p.travel_speed, slab);
        }
        path.travel(strand.from, p.travel_speed, slab);
        if far {
            path.add(strand.from, Kind::Unretract, p.unretract_speed, pulled, slab);
        }
    }

    /// Prints a strand, which `next` may go on from.
    fn print(&mut self, strand: &Strand, next: Option<&Strand>) {
        let p = self.p;
        let speed = speed(strand, p);
        let feed = strand.from.distance(strand.to) * p.feed_per_mm() * strand.flow;
        let airy = airy_share(strand, self.lands(strand, next), p);
        let blows = air(strand, p);
        if airy < 1.0 {
            let to = strand.from.lerp(strand.to, airy);
            self.path.push(strand, to, speed, airy * feed, 0.0, blows);
            self.path.push(strand, strand.to, speed, (1.0 - airy) * feed, 0.0, false);
        } else {
            self.path.push(strand, strand.to, speed, feed, 0.0, blows);
        }
        match p.strategy {
            Strategy::Pause if strand.floating => self.pause(strand),
            Strategy::Overshoot if strand.floating => {
                // The head draws the soft strand on without feeding it: what is fed up there
                // would stand in the way back.
                let beyond = strand.to + DVec3::Z * p.overshoot;
                self.path.travel(beyond, speed, strand.slab);
                self.path.travel(strand.to, p.travel_speed, strand.slab);
            }
            _ => {}
        }
        self.top = self.top.max(strand.from.z).max(strand.to.z);
        self.ends.extend([bits(strand.from), bits(strand.to)]);
    }

    /// Whether a strand ends on printed material, rather than goes on in the air.
    fn lands(&self, strand: &Strand, next: Option<&Strand>) -> bool {
        let goes_on = next.is_some_and(|n| n.from == strand.to && n.kind == strand.kind);
        !strand.floating && (!goes_on || self.ends.contains(&bits(strand.to)))
    }

    /// Stands still at the end of a strand until it holds.
    fn pause(&mut self, strand: &Strand) {
        let (p, pause) = (self.p, pause(strand, self.p));
        match self.pressure.ease() {
            // To pull filament back and to give it again takes time in which the strand holds, too.
            Some(eased) => {
                let standing = eased * (p.retract_speed.recip() + p.unretract_speed.recip());
                self.feed(strand, -eased, (pause - standing).max(LEAST_PAUSE * pause));
            }
            None => {
                if let Some(last) = self.path.pause.last_mut() {
                    *last = pause;
                }
            }
        }
    }

    /// Feeds filament in place as part of a strand, or pulls it back, and then stands still.
    fn feed(&mut self, strand: &Strand, feed: f64, pause: f64) {
        let (p, path) = (self.p, &mut self.path);
        let speed = if feed > 0.0 { p.unretract_speed } else { p.retract_speed };
        path.add(path.at(), strand.kind, speed, feed, strand.slab);
        if let Some(last) = path.pause.last_mut() {
            *last = pause;
        }
    }

    /// Ends above all that stands, the filament pulled back.
    fn leave(&mut self) {
        let (p, path) = (self.p, &mut self.path);
        let Some(&slab) = path.slab.last() else { return };
        let at = path.at();
        let pulled = self.pressure.left_of(p.retract, p);
        if p.retract > 0.0 {
            path.add(at, Kind::Retract, p.retract_speed, -pulled, slab);
        }
        let over = (self.top + p.travel_lift).max(at.z);
        path.travel(at.with_z(over), p.travel_speed, slab);
    }
}

/// A point as what can be looked up: strands that meet do so in the very same point.
fn bits(p: DVec3) -> [u64; 3] {
    p.to_array().map(f64::to_bits)
}
