//! Weights of placing posts. Costs are counted per post; a chord that strays by the tolerated error all
//! along costs one.

/// Weight of uneven spacing, (spacing ÷ ideal − 1)²: half a spacing too much costs as much as a chord
/// that strays by 0.4 of what is tolerated. Doubled, corners lose posts.
pub const EVEN: f64 = 0.6;
/// Weight of footholds beside the peaks below, (distance ÷ ideal)². Doubled, spacing gets uneven.
pub const ALIGN: f64 = 1.2;
/// Weight of a post to which no diagonal leads: it costs a retraction, a hop and a brace. Doubled,
/// chains rather leave corners out.
pub const LONE: f64 = 12.0;
/// Weight of a woven wall that waits for its turn, (way ÷ two runs − 1)²: by turns it costs nothing.
/// Doubled, weaves keep to their turns where corners want otherwise.
pub const TURN: f64 = 6.0;
