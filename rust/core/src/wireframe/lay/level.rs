//! One level: from the contours that end a slab to those that begin the next, and the faces
//! that are closed there.

use std::f64::consts::FRAC_PI_4;

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::hatch::hatch;
use crate::geometry::polygon;
use crate::slices::heights::Level;
use crate::strand::Kind;
use crate::wireframe::build::{Build, Ground};
use crate::wireframe::frame::Reason;
use crate::wireframe::lay::hang::LEDGE;
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::{Stretch, closed_rim, rim_of};
use crate::wireframe::regions::lids::outside;

/// A contour printed on top of another lies higher by this part of the strand's diameter.
const LIFT: f64 = 0.4;
/// Faces this near to a level lie in it, mm.
const FLAT: f64 = 0.05;

/// What is left of a cap's strand beside layers is at least so many strands long.
const LEAST: f64 = 2.0;

/// A strand's end this near to a rim, as a part of the strand's diameter, lies on it.
pub const HELD: f64 = 0.25;

impl Build<'_> {
    /// From the contours that end a slab to those that begin the next: the same rim where they
    /// are the same curve; where they are not (a split, a merge, a step), printed on top.
    pub(in crate::wireframe) fn transition(&mut self, level: usize, mut printed: Ground) -> Ground {
        let Some(ledges) = &self.sliced.ledges[level] else { return printed };
        let contours = &self.sliced.upper[level];
        let z = self.sliced.levels[level].z;
        let mut ground = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
        let below = &self.sliced.lower[level];
        let ends = |l: &&Strip| {
            l.upper.is_empty() && l.closes(below, &l.lower) && !self.are_layers(level, &l.lower)
        };
        let ending: Vec<&Strip> = ledges.iter().filter(ends).collect();
        for ledge in ending {
            self.close(level, &ledge.lower, &mut printed);
        }
        // What is held goes first, for what begins in the air hangs on it.
        let held = ledges.iter().filter(|l| !l.lower.is_empty() && !l.upper.is_empty());
        let born = ledges.iter().filter(|l| l.lower.is_empty());
        for ledge in held.chain(born) {
            for &u in &ledge.upper {
                let contour = &contours[u as usize];
                let Some(curve) = Curve::new(&contour.points, contour.closed) else { continue };
                let rim = self.on_top(&curve, level, contour, ledge, &mut printed);
                match &rim {
                    _ if contour.support => {}
                    Some(rim) => printed.lines.push(rim.clone()),
                    None => self.leave_out(z, z, ledge.area, curve.position(0.0), Reason::MidAir),
                }
                ground.rims[u as usize] = rim;
            }
            if ledge.lower.is_empty() {
                if ledge.closes(contours, &ledge.upper) {
                    self.close(level, &ledge.upper, &mut ground);
                }
            } else {
                self.fill_ledge(level, ledge, &mut printed, &ground);
            }
        }
        ground.lines.append(&mut printed.lines);
        ground
    }

    /// One upper contour of a ledge: on the rims that the ledge touches or, if it begins in the
    /// air, beside the rims around it.
    fn on_top(
        &mut self,
        curve: &Curve,
        level: usize,
        contour: &Contour,
        ledge: &Strip,
        printed: &mut Ground,
    ) -> Option<Rim> {
        let z = self.sliced.levels[level].z;
        let carriers: Vec<Rim> =
            ledge.lower.iter().filter_map(|&i| printed.rims[i as usize].clone()).collect();
        let carriers: Vec<&Rim> = carriers.iter().collect();
        if let ([rim], [_], [_]) = (&carriers[..], &ledge.lower[..], &ledge.upper[..])
            && follows(curve, rim, self.p.strand)
        {
            return Some((*rim).clone());
        }
        if ledge.lower.is_empty() {
            let rim = self.hang(curve, z, level, contour, printed);
            if rim.is_none() && !contour.support {
                self.want_columns(curve, level);
            }
            return rim;
        }
        if self.are_layers(level, &ledge.lower) && self.is_within(curve, level)
            || self.is_on_layers(curve, level)
        {
            return Some(closed_rim(curve, z));
        }
        let lifted = z + LIFT * self.p.strand;
        let standing = self.spokes(curve, lifted, &carriers, Kind::Cap, LEDGE, |_| true)?;
        let standing = self.tighten(curve, lifted, level, standing, printed, self.wide_gap());
        Some(self.follow(curve, &standing, lifted, Kind::Contour))
    }

    /// Whether the contours that end the slab below a level are layers all around, and so is the
    /// surface between them: the last layer has closed it.
    fn are_layers(&self, level: usize, lower: &[u32]) -> bool {
        let Some(layers) = level.checked_sub(1).and_then(|slab| self.layered.slab(slab)) else {
            return false;
        };
        let strips = layers.strips.iter().map(|&s| &self.sliced.strips[level - 1][s as usize]);
        let all: Vec<u32> = strips.flat_map(|strip| &strip.upper).copied().collect();
        lower.iter().all(|i| all.contains(i))
    }

    /// Whether a contour lies on what is solid where the slab below ends, or on its contours.
    fn is_within(&self, curve: &Curve, level: usize) -> bool {
        let below = || self.sliced.lower[level].iter().filter(|c| !c.support);
        let rims: Vec<Rim> = below()
            .filter_map(|c| Curve::new(&c.points, c.closed))
            .map(|curve| closed_rim(&curve, 0.0))
            .collect();
        let rims: Vec<&Rim> = rims.iter().collect();
        let footing = Footing::new(&rims);
        curve.points().iter().all(|&p| {
            let around = below().filter(|c| c.closed && polygon::contains(&c.points, p)).count();
            around % 2 == 1 || footing.nearest(p).is_some_and(|f| f.distance < 0.5 * self.p.strand)
        })
    }

    /// Whether a contour lies all around on what the slab below a level prints as layers of
    /// contours that are layers in part.
    fn is_on_layers(&self, curve: &Curve, level: usize) -> bool {
        let Some(layers) = level.checked_sub(1).and_then(|slab| self.layered.slab(slab)) else {
            return false;
        };
        let rim = |stretch: &Stretch| {
            let contour = &self.sliced.lower[level][stretch.contour as usize];
            let whole = Curve::new(&contour.points, contour.closed)?;
            Some(rim_of(&whole, stretch.from, stretch.length, 0.0))
        };
        let rims: Vec<Rim> = layers.stretches.iter().filter_map(rim).collect();
        let rims: Vec<&Rim> = rims.iter().collect();
        let footing = Footing::new(&rims);
        let near = 0.5 * self.p.strand;
        places(curve, self.p.strand).all(|p| {
            let around = layers.lids.iter().filter(|ring| polygon::contains(ring, p)).count();
            around % 2 == 1 || footing.holds(p, near)
        })
    }

    /// Closes what ends at the foot of this slab.
    pub(in crate::wireframe) fn roofs_of_slab(&mut self, slab: usize, ground: &mut Ground) {
        for (s, strip) in self.sliced.strips[slab].iter().enumerate() {
            if self.layered.has(slab, s) {
                continue;
            }
            let contours = &self.sliced.upper[slab];
            if strip.roofed || strip.upper.is_empty() && strip.closes(contours, &strip.lower) {
                self.close(slab, &strip.lower, ground);
            }
        }
    }

    /// Closes the region within an odd number of the given contours, as they were printed.
    pub(in crate::wireframe) fn close(&mut self, level: usize, which: &[u32], ground: &mut Ground) {
        if !self.p.caps || which.iter().any(|&i| ground.rims[i as usize].is_none()) {
            return;
        }
        let rings: Vec<&Rim> =
            which.iter().filter_map(|&i| ground.rims[i as usize].as_ref()).collect();
        let lines = self.fill(&rings, level);
        ground.lines.extend(lines);
    }

    /// Closes a ledge so wide that the strokes between its two sides leave it open.
    fn fill_ledge(&mut self, level: usize, ledge: &Strip, printed: &mut Ground, ground: &Ground) {
        let length: f64 = ledge
            .upper
            .iter()
            .map(|&i| &self.sliced.upper[level][i as usize])
            .map(|c| polygon::length(&c.points, c.closed))
            .sum();
        if !self.p.caps
            || self.are_layers(level, &ledge.lower)
            || ledge.area < 2.0 * self.p.cap_spacing * length
        {
            return;
        }
        let below = ledge.lower.iter().map(|&i| &printed.rims[i as usize]);
        let above = ledge.upper.iter().map(|&i| &ground.rims[i as usize]);
        let Some(rings) = below.chain(above).map(Option::as_ref).collect::<Option<Vec<&Rim>>>()
        else {
            return;
        };
        let lines = self.fill(&rings, level);
        printed.lines.extend(lines);
    }

    /// Prints strands from rim to rim in the region within an odd number of rims.
    fn fill(&mut self, rings: &[&Rim], level: usize) -> Vec<Rim> {
        let rings: Vec<&Rim> =
            rings.iter().filter(|rim| rim.closed && rim.points.len() > 2).copied().collect();
        let Some(first) = rings.first().map(|rim| rim.points[0]) else { return Vec::new() };
        let plan: Vec<Vec<DVec2>> =
            rings.iter().map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect();
        let longest = if level == 0 { f64::INFINITY } else { self.p.span_limit };
        let whole = rings.iter().all(|rim| rim.gaps.is_empty());
        let footing = Footing::new(&rings);
        let held = |end: DVec2| whole || footing.holds(end, HELD * self.p.strand);
        let (spacing, kind) = self.lid(&plan, level);
        let (lines, dropped) = hatch(&plan, spacing, longest, held);
        let layers = level.checked_sub(1).and_then(|slab| self.layered.slab(slab));
        let lids = layers.map_or(&[][..], |layers| &layers.lids);
        let rims: Vec<Rim> = lines
            .iter()
            .flat_map(|line| outside(line, lids, LEAST * self.p.strand))
            .map(|line| Rim::line(line.into_iter().map(|p| p.extend(first.z)).collect()))
            .collect();
        for rim in &rims {
            self.out.polyline(&rim.points, kind);
        }
        if dropped > 0.0 {
            let area = dropped * spacing;
            self.leave_out(first.z, first.z, area, first.truncate(), Reason::WideRoof);
        }
        rims
    }

    /// How the strands of a face lie apart, and what they are: side by side where it is marked.
    fn lid(&self, rims: &[Vec<DVec2>], level: usize) -> (f64, Kind) {
        let Level { z, low, high } = self.sliced.levels[level];
        let (low, high) = if level == 0 { (f64::NEG_INFINITY, low) } else { (low, high) };
        if !self.layered.has_flat(rims, low - FLAT, high + FLAT) {
            return (self.p.cap_spacing, Kind::Cap);
        }
        // On the bed a strand is squeezed to its height, and wider in turn.
        let strand = self.p.strand;
        let width = if level == 0 { FRAC_PI_4 * strand * strand / z } else { strand };
        (width.max(strand), Kind::LayerWise)
    }

    /// Notes a strip that cannot be printed.
    pub(in crate::wireframe) fn give_up(&mut self, slab: usize, strip: usize, reason: Reason) {
        let piece = &self.sliced.strips[slab][strip];
        let (low, high) = (self.sliced.levels[slab].z, self.sliced.levels[slab + 1].z);
        let start = |contours: &[Contour], which: &[u32]| {
            which.first().and_then(|&i| contours[i as usize].points.first().copied())
        };
        let place = start(&self.sliced.lower[slab + 1], &piece.upper)
            .or_else(|| start(&self.sliced.upper[slab], &piece.lower));
        self.leave_out(low, high, piece.area, place.unwrap_or_default(), reason);
    }
}

/// Whether a printed rim lies under the whole contour.
fn follows(curve: &Curve, rim: &Rim, strand: f64) -> bool {
    let rims = [rim];
    let footing = Footing::new(&rims);
    places(curve, strand).all(|place| footing.nearest(place).is_some_and(|f| f.distance < strand))
}

/// Places along a curve, at most `pitch` mm apart.
fn places(curve: &Curve, pitch: f64) -> impl Iterator<Item = DVec2> + '_ {
    let count = (curve.length() / pitch).ceil().max(4.0) as usize;
    (0..count).map(move |i| curve.position(curve.length() * i as f64 / count as f64))
}
