//! Print time: the look-ahead planners of firmwares, computed from G-code.
//!
//! [`estimate`](estimate()) streams a file through [`crate::gcode`] into a planner. A planner
//! queues moves until their speeds are certain: a backward pass finds how fast each may start so
//! that what follows can still be braked, a forward pass what can be reached. Queues are cut where
//! that changes nothing, so memory is bounded.

mod estimate;
mod klipper;
mod limits;
mod marlin;
mod queue;
mod tally;
mod trapezoid;

pub use estimate::{Allowances, Estimate, Options, estimate, estimate_files};
pub use limits::{DeltaGeometry, Firmware, Kinematics, Limits, MarlinLimits};
pub use tally::{LayerTime, Moves};
