//! Stage 2, slices: where to cut, and the cut itself.

mod bare_crests;
pub mod crests;
mod cut;
pub mod features;
mod headroom;
pub mod heights;
mod hollows;
mod level;
mod masks;
mod outlines;
mod plane;
mod profile;
mod ranks;
mod shown;
mod trace;
mod tuning;

pub use cut::{cut, cut_map};
pub use outlines::Loop;
pub use plane::{Plane, Side};
