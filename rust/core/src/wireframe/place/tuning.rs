//! Weights of placing posts. Costs are counted per post; a chord that strays by the tolerated error all
//! along costs one.

/// A corner's turn is measured between the places so many strands before and behind it: 1 of 0.7 mm.
/// Doubled, roundings of a few millimetres count as corners.
pub const CORNER_REACH: f64 = 10.0 / 7.0;
/// Candidates stand at least so many strands apart, 1.2 of 0.7 mm: nearer ones differ by less than joints
/// do. Halved, low slabs take four times as long to plan.
pub const FINEST: f64 = 12.0 / 7.0;
/// … and so many times as near as posts may. Doubled, posts take four times as long to place, and stand
/// a few percent nearer to where they are wanted.
pub const PLACES: f64 = 6.0;
/// Weight of uneven spacing, (spacing ÷ ideal − 1)²: half a spacing too much costs as much as a chord
/// that strays by 0.4 of what is tolerated. Doubled, corners lose posts.
pub const EVEN: f64 = 0.6;
/// Weight of footholds beside the peaks below, (distance ÷ ideal)². Doubled, spacing gets uneven.
pub const ALIGN: f64 = 1.2;
/// Weight of a post to which no diagonal leads: it costs a retraction, a hop and a brace. It outweighs all
/// else, so that a slim head, which gets to more places than a bulkier one, never takes to such posts
/// where that one's chain has none. At a thousandth, heads whose tips ask for long runs print a twentieth
/// fewer diagonals and take a fiftieth longer; corners lose no posts by it.
pub const LONE: f64 = 1e4;
/// Weight of posts nearer to each other than the paper's, (1 − spacing ÷ the paper's)²: a slim head gets
/// there, and every post more takes its time. Doubled, slim heads print corners no better than
/// bulky ones; without it, they print for longer.
pub const CLOSE: f64 = 100.0;
/// Weight of a woven wall that waits for its turn, (way ÷ two runs − 1)²: by turns it costs nothing.
/// Doubled, weaves keep to their turns where corners want otherwise.
pub const TURN: f64 = 6.0;
