//! A small ring's wall as a coil: a strand that winds up from the ring below, turn upon turn.
//!
//! Where a ring is so small that no three posts find room on it, a wall of posts is a reed: one leg,
//! or two, from ring to ring. A coil needs neither posts nor pauses, since each turn lies on the last
//! one, and it is a closed tube, which neither bends nor twists easily.

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
    }
}
