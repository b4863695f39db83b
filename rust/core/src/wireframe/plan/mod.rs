//! What there is to print: levels, contours, strips.

pub mod sliced;
pub mod strips;
