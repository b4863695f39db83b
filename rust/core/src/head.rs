//! The print head as bodies that open upwards, one of them round about the nozzle, and the exact
//! test of a straight head move against a straight strand.
//!
//! Both the generator and the checker use this file; it is all that they share.

mod body;
mod clip;
mod depth;
mod part;
mod sweep;

use serde::Deserialize;

use crate::error::{CoreError, Result};

pub use body::Body;
pub use part::{HeadPart, Shape};
pub use sweep::Hit;

/// The head: a flat tip, a conical flank, the heater block, the carriage, and what is not round.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(try_from = "HeadTable")]
pub struct Head {
    /// Radius of the nozzle's flat tip, mm.
    pub tip_radius: f64,
    /// Tangent of the flank's slant angle from the horizontal.
    pub slope: f64,
    /// Height above the tip at which the heater block begins, mm.
    pub cone_height: f64,
    /// Radius of the heater block with its fan ducts, mm.
    pub block_radius: f64,
    /// Height above the tip at which the carriage begins, mm.
    pub carriage_height: f64,
    /// Radius of the carriage, mm.
    pub carriage_radius: f64,
    /// Fan ducts, probes, shrouds: what is beside the round body, or lower than it.
    pub parts: Vec<HeadPart>,
}

/// The tip and the flank around it, which alone decide how the strokes of a zigzag may lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flank {
    /// Radius of the nozzle's flat tip, mm.
    pub tip_radius: f64,
    /// Tangent of the flank's slant angle from the horizontal.
    pub slope: f64,
}

impl Flank {
    /// Horizontal distance that a base point must keep from material `height` mm above it, mm.
    #[must_use]
    pub fn clearance(&self, height: f64) -> f64 {
        self.tip_radius + height.max(0.0) / self.slope
    }
}

/// A head's figures by the names of a profile's `[head]` table: mm, and degrees from the horizontal.
#[derive(Deserialize)]
#[allow(clippy::struct_field_names, reason = "the profile's names carry the unit")]
struct HeadTable {
    tip_radius_mm: f64,
    slant_deg: f64,
    cone_height_mm: f64,
    block_radius_mm: f64,
    carriage_height_mm: f64,
    carriage_radius_mm: f64,
    #[serde(default)]
    parts: Vec<HeadPart>,
}

impl TryFrom<HeadTable> for Head {
    type Error = CoreError;

    fn try_from(of: HeadTable) -> Result<Self> {
        Self::new(
            of.tip_radius_mm,
            of.slant_deg,
            of.cone_height_mm,
            of.block_radius_mm,
            of.carriage_height_mm,
            of.carriage_radius_mm,
        )
        .map(|head| head.with_parts(of.parts))
    }
}

impl Head {
    /// A round head from its profile's figures; `slant_deg` is the flank's angle from the horizontal.
    ///
    /// # Errors
    /// [`CoreError::Setting`] where a figure is not finite or out of its bounds.
    pub fn new(
        tip_radius: f64,
        slant_deg: f64,
        cone_height: f64,
        block_radius: f64,
        carriage_height: f64,
        carriage_radius: f64,
    ) -> Result<Self> {
        let positive = [tip_radius, cone_height, block_radius, carriage_height, carriage_radius];
        if positive.iter().any(|v| !v.is_finite() || *v <= 0.0) {
            return Err(CoreError::Setting("the head's radii and heights must be positive".into()));
        }
        if !(1.0..=89.0).contains(&slant_deg) {
            return Err(CoreError::Setting(format!(
                "the head's slant is {slant_deg}°; it must lie in 1–89°"
            )));
        }
        if carriage_height < cone_height {
            return Err(CoreError::Setting("the head's carriage must lie above its cone".into()));
        }
        let slope = slant_deg.to_radians().tan();
        let flank = tip_radius + cone_height / slope;
        if block_radius < flank {
            return Err(CoreError::Setting(format!(
                "head.block_radius_mm is {block_radius}: the block ends inside the head's own flank, which \
                 reaches {flank:.2} mm where it begins; give {:.2} or more, or a steeper head.slant_deg, \
                 or a lower head.cone_height_mm",
                (flank * 100.0).ceil() / 100.0
            )));
        }
        Ok(Self {
            tip_radius,
            slope,
            cone_height,
            block_radius,
            carriage_height,
            carriage_radius,
            parts: Vec::new(),
        })
    }

    /// The same head with these parts, and no others, beside its round body.
    #[must_use]
    pub fn with_parts(self, parts: Vec<HeadPart>) -> Self {
        Self { parts, ..self }
    }

    /// The tip and the flank.
    #[must_use]
    pub fn flank(&self) -> Flank {
        Flank { tip_radius: self.tip_radius, slope: self.slope }
    }

    /// Horizontal distance that a base point must keep from material `height` mm above it, mm.
    #[must_use]
    pub fn clearance(&self, height: f64) -> f64 {
        self.flank().clearance(height)
    }
}
