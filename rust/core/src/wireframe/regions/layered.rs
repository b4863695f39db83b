//! The part of a print that is stacked layers, as the wire part sees it: which stretches of the
//! contours it takes over, and the lines that are printed there (paper, "Additional detail").

use glam::{DVec2, DVec3};

use crate::error::{CoreError, Result};
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::geometry::polyline::simplify;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::plan::sliced::Sliced;

/// A stretch of a contour; it may run on past the contour's first point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// The contour's number in `Sliced::lower` at the slab's top.
    pub contour: u32,
    /// Arc length at which it begins, from the contour's first point, mm.
    pub from: f64,
    /// Its length, mm.
    pub length: f64,
}

/// A line of a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its points, mm, all at the layer's height.
    pub points: Vec<DVec3>,
    /// Filament that it takes, as a share of what a free strand of its length would.
    pub flow: f64,
    /// Whether it lies behind the outer wall.
    pub inside: bool,
}

/// What is layers in one slab.
#[derive(Debug, Clone, Default)]
pub struct LayeredSlab {
    /// Strips of the slab that are layers through and through.
    pub strips: Vec<u32>,
    /// Stretches of the contours of all other strips.
    pub stretches: Vec<Stretch>,
    /// Lines in printing order, the lowest first.
    pub lines: Vec<Line>,
    /// Closed rings: what lies within an odd number of them, the last layer fills behind walls.
    pub lids: Vec<Vec<DVec2>>,
}

/// What is layers in a wire print; slab by slab from the bed, none beyond the list's end.
#[derive(Debug, Clone, Default)]
pub struct Layered {
    /// The slabs.
    pub slabs: Vec<LayeredSlab>,
    /// Points on level faces, mm, each standing for an equal area, and whether it is marked.
    pub flats: Vec<(DVec3, bool)>,
}

impl Layered {
    /// Whether nothing is layers, and no face is closed side by side.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.slabs.iter().all(|s| s.strips.is_empty() && s.stretches.is_empty())
            && !self.flats.iter().any(|(_, marked)| *marked)
    }

    /// What is layers in a slab, if anything is.
    #[must_use]
    pub fn slab(&self, slab: usize) -> Option<&LayeredSlab> {
        self.slabs.get(slab).filter(|s| !(s.strips.is_empty() && s.stretches.is_empty()))
    }

    /// Checks that all that is named is there.
    ///
    /// # Errors
    /// [`CoreError::Setting`] that names the first slab, strip or contour that is not.
    pub fn fits(&self, sliced: &Sliced) -> Result<()> {
        let missing = |what: &str, number: u32, slab: usize| {
            Err(CoreError::Setting(format!("layered: there is no {what} {number} in slab {slab}")))
        };
        for (number, slab) in self.slabs.iter().enumerate() {
            let Some(strips) = sliced.strips.get(number) else {
                return Err(CoreError::Setting(format!("layered: there is no slab {number}")));
            };
            if let Some(&strip) = slab.strips.iter().find(|&&s| s as usize >= strips.len()) {
                return missing("strip", strip, number);
            }
            let contours = sliced.lower[number + 1].len();
            if let Some(s) = slab.stretches.iter().find(|s| s.contour as usize >= contours) {
                return missing("contour", s.contour, number);
            }
        }
        Ok(())
    }

    /// Whether at least half of the points on level faces between two heights, in the region
    /// within an odd number of the closed `rims`, are marked.
    #[must_use]
    pub fn has_flat(&self, rims: &[Vec<DVec2>], low: f64, high: f64) -> bool {
        let level = || self.flats.iter().filter(|(p, _)| (low..=high).contains(&p.z));
        let bounds = rims.iter().flatten().fold(None, |found: Option<[DVec2; 2]>, &p| {
            let [low, high] = found.unwrap_or([p, p]);
            Some([low.min(p), high.max(p)])
        });
        let Some([first, last]) = bounds else { return false };
        let within = |p: DVec2| {
            p.cmpge(first).all()
                && p.cmple(last).all()
                && rims.iter().filter(|rim| polygon::contains(rim, p)).count() % 2 == 1
        };
        let count =
            |of: bool| level().filter(|(p, marked)| *marked == of && within(p.truncate())).count();
        // Strokes mark few level faces, and without any the others need not be counted.
        let marked = count(true);
        marked > 0 && marked >= count(false)
    }

    /// Whether a strip is layers through and through.
    #[must_use]
    pub fn has(&self, slab: usize, strip: usize) -> bool {
        self.slabs.get(slab).is_some_and(|s| s.strips.contains(&(strip as u32)))
    }
}

/// A piece of a contour between two regions, or a region.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    /// The contour.
    pub contour: usize,
    /// Where it begins, mm.
    pub from: f64,
    /// Its length, mm.
    pub length: f64,
    /// Its number among the curves, if it is wire.
    pub curve: Option<usize>,
    /// Whether a region lies before its beginning and behind its end.
    pub meets: [bool; 2],
}

/// The vertices of a region's rim lie at most so many strands apart, 2 of 0.7 mm, so that posts find
/// them. Doubled, fewer posts stand upon vertices.
const FOOTHOLDS: f64 = 20.0 / 7.0;
/// A region's rim follows the contour to this part of a strand: 0.05 of 0.7 mm. Doubled, posts on
/// rounds stand beside them.
const FOLLOW: f64 = 1.0 / 14.0;
/// Pieces shorter than this are rounding, mm.
const NOTHING: f64 = 1e-6;

/// Takes the layers out of the curves of a slab's top: contours that are layers in part are
/// replaced by their pieces of wire, which are appended as open curves. Gives all pieces of those
/// contours, in order along each.
pub fn take_out(curves: &mut Vec<Option<Curve>>, stretches: &[Stretch]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for contour in 0..curves.len() {
        let mut own: Vec<&Stretch> =
            stretches.iter().filter(|s| s.contour as usize == contour).collect();
        if own.is_empty() {
            continue;
        }
        let Some(whole) = curves[contour].take() else { continue };
        own.sort_by(|a, b| a.from.total_cmp(&b.from));
        let (first, lap) = (own[0].from, whole.length());
        let begin = if whole.is_closed() { first } else { 0.0 };
        let ends = own.iter().skip(1).map(|s| s.from).chain([begin + lap]);
        let closed = whole.is_closed();
        let mut wire = |from: f64, to: f64, pieces: &mut Vec<Piece>| {
            if let Some(curve) = part(&whole, from, to - from) {
                curves.push(Some(curve));
                let curve = Some(curves.len() - 1);
                let meets = [closed || from > 0.0, closed || to < lap];
                pieces.push(Piece { contour, from, length: to - from, curve, meets });
            }
        };
        wire(begin, first, &mut pieces);
        for (stretch, next) in own.iter().zip(ends) {
            let Stretch { from, length, .. } = **stretch;
            pieces.push(Piece { contour, from, length, curve: None, meets: [false; 2] });
            wire(from + length, next, &mut pieces);
        }
    }
    pieces
}

/// The open curve of a stretch of a contour.
fn part(whole: &Curve, from: f64, length: f64) -> Option<Curve> {
    (length > NOTHING).then(|| Curve::new(&whole.arc(from, length), false)).flatten()
}

/// The top of a region's last layer along a stretch of a contour, as what the next slab stands on: at
/// height `z`, for a `strand`, mm.
#[must_use]
pub fn rim_of(whole: &Curve, from: f64, length: f64, z: f64, strand: f64) -> Rim {
    let all = whole.arc(from, length);
    let kept: Vec<DVec2> = simplify(&all, FOLLOW * strand).into_iter().map(|i| all[i]).collect();
    let mut rim = Rim { printed: true, held: true, ..Rim::default() };
    for pair in kept.windows(2) {
        let count = (pair[0].distance(pair[1]) / (FOOTHOLDS * strand)).ceil().max(1.0) as usize;
        let step = |i: usize| pair[0].lerp(pair[1], i as f64 / count as f64).extend(z);
        rim.points.extend((0..count).map(step));
    }
    rim.points.extend(kept.last().map(|p| p.extend(z)));
    rim
}

/// The rim of a whole contour that is layers.
#[must_use]
pub fn closed_rim(curve: &Curve, z: f64, strand: f64) -> Rim {
    let mut rim = rim_of(curve, 0.0, curve.length(), z, strand);
    if curve.is_closed() {
        rim.closed = true;
        rim.points.pop();
    }
    rim
}

/// One rim from the rims of a contour's pieces, in order along it; where one is missing, the
/// rim has a gap. `closed` tells whether the contour is.
#[must_use]
pub fn joined(pieces: Vec<Option<Rim>>, closed: bool) -> Rim {
    let mut rim = Rim { closed, printed: true, ..Rim::default() };
    for piece in pieces {
        let Some(mut piece) = piece else {
            rim.gaps.extend(rim.points.len().checked_sub(1));
            continue;
        };
        let meets = rim.points.last().zip(piece.points.first());
        let skip = usize::from(meets.is_some_and(|(a, b)| a.distance(*b) < NOTHING));
        let shift = rim.points.len() - skip;
        rim.gaps.extend(piece.gaps.iter().map(|gap| gap + shift));
        rim.points.extend(piece.points.drain(skip..));
    }
    if closed && rim.points.len() > 1 && rim.points.first() == rim.points.last() {
        rim.points.pop();
    }
    rim.gaps.sort_unstable();
    rim.gaps.dedup();
    rim
}

/// An open rim in the other direction.
#[must_use]
pub fn reversed(mut rim: Rim) -> Rim {
    rim.points.reverse();
    let last = rim.points.len().saturating_sub(2);
    rim.gaps.iter_mut().for_each(|gap| *gap = last.saturating_sub(*gap));
    rim.gaps.reverse();
    rim
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Option<Curve> {
        let points = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)].map(DVec2::from);
        Curve::new(&points, true)
    }

    #[test]
    fn regions_and_wire_share_a_contour_without_a_remainder() {
        let mut curves = vec![square(), square()];
        let stretch = |from: f64, length: f64| Stretch { contour: 1, from, length };
        let pieces = take_out(&mut curves, &[stretch(35.0, 10.0), stretch(12.0, 4.0)]);
        let whole: f64 = pieces.iter().map(|p| p.length).sum();
        assert!((whole - 40.0).abs() < 1e-12);
        assert!(curves[0].is_some() && curves[1].is_none() && curves.len() == 4);
        let wire: Vec<f64> = curves[2..].iter().flatten().map(Curve::length).collect();
        assert!((wire[0] - 19.0).abs() < 1e-12 && (wire[1] - 7.0).abs() < 1e-12, "{wire:?}");
    }

    #[test]
    fn wire_meets_a_region_on_the_sides_where_there_is_one() {
        let line = Curve::new(&[DVec2::ZERO, DVec2::X * 60.0], false);
        let meets = |stretches: &[(f64, f64)]| -> Vec<(f64, f64, [bool; 2])> {
            let stretch = |&(from, length)| Stretch { contour: 0, from, length };
            let stretches: Vec<Stretch> = stretches.iter().map(stretch).collect();
            let pieces = take_out(&mut vec![line.clone()], &stretches);
            let wire = pieces.iter().filter(|piece| piece.curve.is_some());
            wire.map(|piece| (piece.from, piece.length, piece.meets)).collect()
        };
        let (first, last) = ((0.0, 20.0, [false, true]), (50.0, 10.0, [true, false]));
        assert_eq!(meets(&[(20.0, 30.0)]), [first, last]);
        let between = (30.0, 10.0, [true, true]);
        assert_eq!(meets(&[(20.0, 10.0), (40.0, 10.0)]), [first, between, last]);
        assert_eq!(meets(&[(0.0, 50.0)]), [last]);
        assert_eq!(meets(&[(20.0, 40.0)]), [first]);
        // Around a closed contour wire lies between regions everywhere.
        let pieces =
            take_out(&mut vec![square()], &[Stretch { contour: 0, from: 5.0, length: 30.0 }]);
        let wire: Vec<&Piece> = pieces.iter().filter(|piece| piece.curve.is_some()).collect();
        assert_eq!((wire.len(), wire[0].from, wire[0].meets), (1, 35.0, [true, true]));
    }

    #[test]
    fn a_rim_is_joined_from_its_pieces() {
        let whole = square().unwrap();
        let region = rim_of(&whole, 35.0, 10.0, 1.0, 0.7);
        let wire = rim_of(&whole, 5.0, 30.0, 1.0, 0.7);
        let rim = joined(vec![Some(region.clone()), Some(wire)], true);
        let length: f64 = rim.segments().map(|(a, b)| a.distance(b)).sum();
        assert!((length - 40.0).abs() < 1e-9);
        let open = joined(vec![Some(region), None], true);
        let length: f64 = open.segments().map(|(a, b)| a.distance(b)).sum();
        assert!((length - 10.0).abs() < 1e-9);
    }
}
