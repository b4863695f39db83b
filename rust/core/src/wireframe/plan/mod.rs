//! What there is to print: levels, contours, strips.

pub mod columns;
pub mod interval;
pub mod ledges;
pub mod raise;
pub mod section;
pub mod sheets;
pub mod sliced;
pub mod standing_room;
pub mod strips;
