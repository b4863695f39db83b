//! Small rings: whether the wall up to one is a coil, a strand that winds up from the ring below, turn
//! upon turn. What slabs cost and what is laid in them go by the same rules, which stand here.
//!
//! Where a ring is so small that no three posts find room on it, a wall of posts is a reed: one leg,
//! or two, from ring to ring. A coil needs neither posts nor pauses, since each turn lies on the last
//! one, and it is a closed tube, which neither bends nor twists easily.
//!
//! Rings that stand near each other are coiled in lifts: a few turns of one, as many of the next, so
//! that none ever stands higher above the tip than the head may come near it.

use glam::DVec2;

use crate::climb::{Climb, strokes_take};
use crate::geometry::polyline::segment_distance;

/// Turns lie this many diameters from each other, middle to middle: they must weld. Doubled, they no
/// longer touch; halved, a coil takes twice as long.
const PITCH: f64 = 0.75;
/// The most that a wall may lean, horizontally for a step up: turns still lie on each other, and rise by
/// two fifths of a diameter. Doubled, they would lie beside each other.
pub const LEAN: f64 = 1.5;
/// A ring stands on so many posts.
const FEET: f64 = 3.0;
/// Fine, in seconds, for a contour that stands on fewer posts than that: times the square of the
/// number it lacks. Doubled, more rings are coiled, and slabs are lower where there are small rings.
const WOBBLE_FINE: f64 = 4.0;
/// Rings shorter than so many strands are dots: no turn would find room within them.
pub const DOT: f64 = 6.0;

/// A coil of strands with some diameter; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct Coil {
    /// Height of the wall.
    pub height: f64,
    /// Diameter of the strand.
    pub strand: f64,
    /// How far the wall leans, horizontally for a step up.
    pub lean: f64,
}

impl Coil {
    /// Number of turns that rise; a level one closes the coil.
    #[must_use]
    pub fn turns(&self) -> usize {
        (self.height * self.lean.hypot(1.0) / (PITCH * self.strand)).ceil().max(1.0) as usize
    }

    /// How long a coil round a ring of `length` mm takes at `speed` mm/s, s.
    #[must_use]
    pub fn takes(&self, length: f64, speed: f64) -> f64 {
        (self.turns() + 1) as f64 * length / speed
    }
}

/// Fine, in seconds, for a ring of `length` mm whose posts stand `spacing` mm apart.
#[must_use]
pub fn wobble(length: f64, spacing: f64) -> f64 {
    WOBBLE_FINE * (FEET - (length / spacing).floor()).max(0.0).powi(2)
}

/// Rings of this length, mm, and longer ones have room for all posts that they stand on.
#[must_use]
pub fn roomy(spacing: f64) -> f64 {
    FEET * spacing
}

/// How long the head takes; speeds in mm/s, times in s.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    /// Speed of printing.
    pub speed: f64,
    /// Pause at each post.
    pub pause: f64,
    /// What a travel takes besides its way.
    pub hop: f64,
    /// The axis that raises the head; None where it is as fast as the others.
    pub climb: Option<Climb>,
}

/// The walls of small rings within one slab; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct SmallWalls {
    /// Height of the slab.
    pub height: f64,
    /// How far apart posts stand.
    pub spacing: f64,
    /// Diameter of the strand.
    pub strand: f64,
    /// How long the head takes.
    pub pace: Pace,
}

impl SmallWalls {
    /// What the zigzag of a ring costs, s: posts with a hop and a pause each, for it is a lone one or
    /// two, the contour, and the fine.
    #[must_use]
    pub fn zigzag(&self, length: f64) -> f64 {
        let Pace { speed, pause, hop, climb } = self.pace;
        let post = pause + hop + strokes_take(climb, speed, self.height, self.spacing);
        let posts = (length / self.spacing).floor().max(1.0);
        posts * post + length / speed + wobble(length, self.spacing)
    }

    /// What a coil round a ring takes, s, if its wall by itself is better coiled than not: slim
    /// enough, and no steeper than turns can lean.
    #[must_use]
    pub fn coiled(&self, length: f64, lean: f64) -> Option<f64> {
        if length < DOT * self.strand || length >= roomy(self.spacing) || lean > LEAN {
            return None;
        }
        let coil = Coil { height: self.height, strand: self.strand, lean };
        let takes = coil.takes(length, self.pace.speed);
        (takes < self.zigzag(length)).then_some(takes)
    }

    /// How far an upright coil rises in a turn.
    #[must_use]
    pub fn rise(&self) -> f64 {
        self.height / Coil { height: self.height, strand: self.strand, lean: 0.0 }.turns() as f64
    }

    /// How many of so many turns are coiled at once round rings whose gaps are some mm, where `clearance`
    /// tells how far the head must keep from what stands so high above its tip. None where they are
    /// too near for a single one.
    #[must_use]
    pub fn turns_at_once(
        &self,
        turns: usize,
        gap: f64,
        clearance: impl Fn(f64) -> f64,
    ) -> Option<usize> {
        let rise = self.height / turns as f64;
        (1..=turns).rev().find(|&count| clearance(count as f64 * rise) <= gap)
    }
}

/// Two walls that stand so near each other that the head cannot print the foot of one beside the other.
#[derive(Debug, Clone, Copy)]
pub struct NearWalls {
    /// Their numbers.
    pub walls: [usize; 2],
    /// The gap between them, mm.
    pub gap: f64,
}

/// Of walls that could be coiled by themselves, keeps those that others do not keep from it: walls near
/// each other are all coiled, or none is; and none is where a gap is less than `least` mm.
pub fn keep_groups(able: &mut [bool], near: &[NearWalls], least: f64) {
    for &NearWalls { walls: [a, b], .. } in near.iter().filter(|near| near.gap < least) {
        (able[a], able[b]) = (false, false);
    }
    while let Some(&NearWalls { walls: [a, b], .. }) =
        near.iter().find(|near| able[near.walls[0]] != able[near.walls[1]])
    {
        (able[a], able[b]) = (false, false);
    }
}

/// How near two polylines of the plan come to each other, mm, or less; infinite beyond `reach`. `closed`
/// tells whether the last point of the second one joins its first.
///
/// Where a line across the way between their middles parts them, it is how far it does. Else one may
/// lie within the other, and there is no gap between them where it comes within reach.
#[must_use]
pub fn gap(small: &[DVec2], other: &[DVec2], closed: bool, reach: f64) -> f64 {
    let ([low, high], [left, right]) = (extent(small), extent(other));
    if (left - high).max(low - right).max_element() > reach {
        return f64::INFINITY;
    }
    let towards = (0.5 * (left + right) - 0.5 * (low + high)).normalize_or_zero();
    let ahead = |points: &[DVec2], way: DVec2| {
        points.iter().map(|p| p.dot(way)).fold(f64::NEG_INFINITY, f64::max)
    };
    let parted = -ahead(other, -towards) - ahead(small, towards);
    if parted > 0.0 {
        return if parted > reach { f64::INFINITY } else { parted };
    }
    let count = other.len() - usize::from(!closed && other.len() > 1);
    let segments = (0..count).map(|i| [other[i], other[(i + 1) % other.len()]]);
    let is_near =
        |[a, b]: &[DVec2; 2]| (a.min(*b) - high).max(low - a.max(*b)).max_element() <= reach;
    let mut near = segments.filter(is_near);
    let meets = |[a, b]: [DVec2; 2]| small.iter().any(|&p| segment_distance(p, a, b) <= reach);
    if near.any(meets) { 0.0 } else { f64::INFINITY }
}

/// Corners of the box around points.
fn extent(points: &[DVec2]) -> [DVec2; 2] {
    points.iter().fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[l, h], &p| [l.min(p), h.max(p)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_lie_on_each_other_whatever_the_lean() {
        for lean in [0.0, 0.5, LEAN] {
            for height in [0.1, 1.4, 4.0, 6.0] {
                let coil = Coil { height, strand: 0.4, lean };
                let rise = height / coil.turns() as f64;
                assert!(rise.hypot(lean * rise) <= 0.75 * 0.4 + 1e-12);
            }
        }
    }

    #[test]
    fn a_ring_with_room_for_three_posts_does_not_wobble() {
        assert_eq!(wobble(30.1, 10.0), 0.0);
        assert_eq!(wobble(29.9, 10.0), 4.0);
        assert_eq!(wobble(5.0, 10.0), 36.0);
        assert_eq!(roomy(10.0), 30.0);
    }

    /// Slabs of 4 mm with posts 7 mm apart.
    const SLAB: SmallWalls = SmallWalls {
        height: 4.0,
        spacing: 7.0,
        strand: 0.7,
        pace: Pace { speed: 30.0, pause: 1.0, hop: 0.3, climb: None },
    };

    #[test]
    fn slim_walls_are_coiled_that_neither_lean_far_nor_have_room_for_posts() {
        let takes = SLAB.coiled(14.0, 0.0).unwrap_or_default();
        assert!((takes - 9.0 * 14.0 / 30.0).abs() < 1e-12, "eight turns and a level one");
        let posts = 2.0 * (1.3 + (4.0 + 65_f64.sqrt()) / 30.0);
        assert!((SLAB.zigzag(14.0) - (posts + 14.0 / 30.0 + 4.0)).abs() < 1e-12);
        assert!(SLAB.coiled(14.0, LEAN + 0.01).is_none());
        assert!(SLAB.coiled(21.0, 0.0).is_none(), "three posts stand as well");
        assert!(SLAB.coiled(4.1, 0.0).is_none(), "a dot");
    }

    #[test]
    fn nearer_walls_are_coiled_fewer_turns_at_once() {
        let clearance = |rise: f64| 0.5 + 1.6 * rise;
        let at_once = |gap: f64| SLAB.turns_at_once(8, gap, clearance);
        assert_eq!(at_once(6.9), Some(8));
        assert_eq!(at_once(6.8), Some(7));
        assert_eq!(at_once(2.2), Some(2));
        assert_eq!(at_once(1.31), Some(1));
        assert_eq!(at_once(1.29), None, "one turn of half a millimetre is too high");
        assert!((SLAB.rise() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn walls_near_each_other_are_coiled_together_or_not_at_all() {
        let kept = |able: &[bool], near: &[(usize, usize, f64)]| {
            let near: Vec<NearWalls> =
                near.iter().map(|&(a, b, gap)| NearWalls { walls: [a, b], gap }).collect();
            let mut able = able.to_vec();
            keep_groups(&mut able, &near, 1.0);
            able
        };
        assert_eq!(kept(&[true; 3], &[(0, 1, 2.0), (1, 2, 3.0)]), [true; 3]);
        assert_eq!(kept(&[true; 3], &[(0, 1, 2.0), (1, 2, 0.9)]), [false; 3]);
        let row = [(2, 3, 2.0), (1, 2, 2.0), (0, 1, 2.0)];
        let able = [true, true, true, false, true];
        assert_eq!(kept(&able, &row), [false, false, false, false, true]);
    }

    #[test]
    fn gaps_are_those_beside_each_other_and_none_within() {
        let square = |x: f64, half: f64| {
            [(-1, -1), (1, -1), (1, 1), (-1, 1)]
                .map(|(i, j)| DVec2::new(x + half * f64::from(i), half * f64::from(j)))
        };
        let (one, two) = (square(0.0, 2.0), square(7.0, 1.5));
        assert!((gap(&one, &two, true, 5.0) - 3.5).abs() < 1e-12);
        assert_eq!(gap(&one, &two, true, 3.0), f64::INFINITY);
        let around = square(0.5, 6.0);
        assert_eq!(gap(&one, &around, true, 5.0), 0.0);
        assert_eq!(gap(&one, &around, true, 3.0), f64::INFINITY);
        // Without its last side the one around is open to the left.
        assert_eq!(gap(&one, &around, true, 3.7), 0.0);
        assert_eq!(gap(&one, &around, false, 3.7), f64::INFINITY);
    }
}
