//! Weights of choosing heights. Costs are times, s. Fines are the time that who waits for the print would
//! give for what they are for, the same whatever the printer's pace: counted in its own posts instead,
//! a printer with short pauses would skip features that it has the time for (tried: of 33 models one
//! lost half of its posts, and two a part of their surface).

/// Candidate heights lie about this part of the longest free end apart: 0.5 of 20 mm. Halved, the choice
/// takes four times as long and gains little …
pub const STEP: f64 = 0.025;
/// … but there are no more than about this many. Doubled, tall models take four times as long to plan.
pub const MOST_CANDIDATES: f64 = 400.0;
/// Fine, s, for a skipped feature as large as the longest free end; others in proportion.
/// Doubled, more features get a slice of their own, and slabs are lower.
pub const SKIP_FINE: f64 = 400.0;
/// A feature's size counts up to this many greatest slabs. Doubled, a large one pulls a slice to itself
/// from farther away; what lies beyond that is skipped as rarely.
pub const LARGEST: f64 = 4.0;
/// What straying from the surface costs is told in the time of a printer that waits so long at a post,
/// s: on one that takes longer, slabs are not lower for that. With the paper's second, prints take 3 %
/// longer, and stray as much less.
pub const QUICK_PAUSE: f64 = 0.5;
/// … but no less than this part of the printer's own time. Doubled, slow printers' slabs are as low as
/// those of quick ones; halved, shallow slopes are left bare between slices.
pub const WORTH: f64 = 0.35;
/// A small ring that cannot be coiled is fined this part of what it wobbles: lower slabs make it little
/// sturdier. Quadrupled, slabs beside small holes are lower, and prints take 3 % longer.
pub const UNCOILED: f64 = 0.25;
/// Walls that lean more than this part of the longest free end are fined …
pub const LEAN: f64 = 0.4;
/// … by so many seconds for as much as the square of that end. Doubled, slabs under overhangs are lower.
pub const LEAN_FINE: f64 = 80.0;
/// Fine, s, for a slab as high as the longest free end, with the square of its height: of
/// chains that cost the same the more even one is taken. Doubled, nothing else changes.
pub const HEIGHT_FINE: f64 = 0.4;
/// Turning is measured between strokes of at least this part of the longest free end: 1.5 of 20 mm, so that
/// the noise of a scan does not count. Doubled, small rounds count as straight.
pub const STROKE: f64 = 0.075;
/// Fine, s, for a slab lower than the least height (only where nothing else fits). Graver than
/// anything else: doubled, nothing changes.
pub const LOW_FINE: f64 = 1e4;
/// Slabs lower than this part of the least height are never made. Doubled, low parts between two
/// features are rather held by one level.
pub const LOWEST: f64 = 0.2;
/// A level takes in the features within this part of the least height of a slab. Doubled, features that
/// could have levels of their own share one …
pub const REACH: f64 = 0.5;
/// … and wide horizontal faces and high ends that none takes in are lost: a fine, s, as
/// grave as a low slab's.
pub const LOST_FINE: f64 = 1e4;
/// Faces wider than this part of the longest free end are wide, and ends higher than it are high.
/// Doubled, ledges of some millimetres are no longer held.
pub const WIDE: f64 = 0.2;
/// Faces within this part of the first contour's height lie on the bed. Doubled, a sheet that thin is
/// lost.
pub const ON_BED: f64 = 0.1;
/// A flat within this part of the longest free end of a top or bottom makes it flat, not round: 0.05 of
/// 20 mm. Doubled, domes as low as that are cut at their very height.
pub const FLAT: f64 = 0.0025;
/// Features within this part of a strand's diameter are one: a micrometre of 0.7 mm, far below what
/// is printed, and far above rounding. Doubled, nothing changes.
pub const SAME: f64 = 1e-3 / 0.7;
