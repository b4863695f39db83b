//! What there is to print: levels, contours, strips.

pub mod columns;
pub mod ledges;
pub mod section;
pub mod sheets;
pub mod sliced;
pub mod strips;
