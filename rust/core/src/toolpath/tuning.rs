//! Weights of the toolpath: how strokes bond, cool and follow each other, and what holds them to the bed.

/// A stroke that must bond to what it ends on is printed without air for this many strand
/// diameters at its end. Doubled, joints are no stronger, and more of each strand sags …
pub const BOND: f64 = 2.0;
/// … if it is this many times as long: a valve needs its time, and air along a stroke is worth more
/// than none at its joint. Doubled, the joints of short strokes are cold.
pub const LONG_ENOUGH: f64 = 3.0;
/// Whether a stroke holds is decided by so many strand diameters at its end: what of them is soft
/// bends under the pull. In the model of a rod that must not lean by half its diameter, 9 of 0.7 mm
/// or 6 of 0.4 mm may be soft; the pause that is left at 5, 10, 30 and 60 mm/s says the same.
/// Doubled, strokes of slow axes would be left while they are softer than the others'.
pub const SOFT: f64 = 6.0;
/// No pause is shortened to less than this part of it: twice what the certificate asks for. Doubled,
/// none is shortened.
pub const LEAST_PAUSE: f64 = 0.5;
/// Travels shorter than this, mm, the lift aside, need no retraction. In mm whatever the strand: what
/// oozes meanwhile follows from the time that a travel takes. Doubled, hairs hang across gaps.
pub const SHORT: f64 = 1.0;
/// Largest angle between two strokes of an outline's rounded corner, rad. Doubled, rings of a brim cut
/// into each other at corners.
pub const ROUND: f64 = 0.3;
/// A print stands safely on a foot as wide as this part of its height; estimated. Doubled, most prints
/// get a brim.
pub const SAFE: f64 = 0.25;
/// Most rings of a brim that follows from the foot: a wider one lifts the foot no better. Doubled, slender
/// prints take longer to begin.
pub const MOST_RINGS: f64 = 10.0;
