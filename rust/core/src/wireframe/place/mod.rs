//! Where the posts of a contour stand.

pub mod averaging;
pub mod candidates;
pub mod chain;
pub mod fold;
pub mod gaps;
pub mod guide;
pub mod posts;
pub mod rim;
pub mod through;
pub mod tuning;
pub mod walls;
pub mod weave;
pub mod zigzag;
