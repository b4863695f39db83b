//! How far a print gives way while it grows: a frame of beams, from the written text alone.
//!
//! Strands are straight beams of one diameter, cold and as stiff as their material; where they are
//! in contact (as the certificate means it) they are joined rigidly, and what lies on the bed does
//! not move. Of the certificate this module shares what it calls strands and contacts, of the
//! generator nothing. Joints are ideal and strands cold, so every figure is a lower bound: it
//! tells prints and places apart, and promises nothing.

mod band;
mod beam;
mod beams;
mod blocks;
mod climate;
mod clock;
mod closest;
mod compliance;
mod conditions;
mod contacts;
pub mod cooling;
pub mod flow;
mod flows;
mod forecast;
mod frame;
mod growing;
mod growth;
mod hanging;
pub mod holds;
mod joints;
mod ooze;
mod opening;
mod rod;
pub mod sag;
mod sagging;
mod scene;
mod six;
mod weld;

pub use beams::{Beams, beams_of_text};
pub use clock::StrandTimes;
pub use conditions::Switch;
pub use forecast::{Forecast, PerStrand, forecast_text};
pub use growth::{Elastic, Growth, Peak, grow_text};
pub use scene::{Found, SagShare, Terms, Worst};
