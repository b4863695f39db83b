//! How far a print gives way while it grows: a frame of beams, from the written text alone.
//!
//! Strands are straight beams of one diameter, cold and as stiff as their material; where they are
//! in contact (as the certificate means it) they are joined rigidly, and what lies on the bed does
//! not move. Of the certificate this module shares what it calls strands and contacts, of the
//! generator nothing. Joints are ideal and strands cold, so every figure is a lower bound: it
//! tells prints and places apart, and promises nothing.

mod beam;
mod closest;
mod compliance;
mod frame;
mod growth;
mod six;

pub use growth::{Elastic, Growth, Peak, grow_text};
