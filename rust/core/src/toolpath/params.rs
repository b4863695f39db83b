//! What the toolpath depends on.

use glam::DVec2;
use serde::Deserialize;

use crate::climb::Climb;

/// The bed, about its centre.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BedShape {
    /// A disc of this radius, mm.
    Round(f64),
    /// A rectangle that reaches this far along x and y, mm.
    Rectangle(DVec2),
}

impl BedShape {
    /// Whether a point, relative to the bed's centre, lies on it.
    #[must_use]
    pub fn holds(&self, p: DVec2) -> bool {
        match *self {
            Self::Round(radius) => p.length() <= radius,
            Self::Rectangle(half) => p.abs().cmple(half).all(),
        }
    }
}

/// What makes a stroke that ends in the air hold its shape (paper, "Experimentation").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Strategy {
    /// Full speed, then a pause at the end of each floating stroke: the paper's choice.
    Pause,
    /// Slow motion and no pause.
    Slow,
    /// Full speed, then up past the end and back: anticipates the sag (the paper's figure 14).
    Overshoot,
}

/// How strands are cooled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CoolingMethod {
    /// An air jet behind a valve that the firmware opens and closes in step with the moves.
    Valve,
    /// An air jet behind a valve that the firmware works only when the head stands still.
    HaltingValve,
    /// A part fan: too slow for strokes, so it stays on above the first contours.
    Fan,
    /// Still air.
    #[serde(rename = "none")]
    Still,
}

/// For which strokes the firmware itself makes up for the pressure in the nozzle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PressureAdvance {
    /// For all.
    All,
    /// For those that move along x or y.
    Sideways,
    /// For none.
    None,
}

/// What the toolpath depends on; lengths in mm, speeds in mm/s, times in s.
#[derive(Debug, Clone, Copy, Deserialize)]
pub struct PathParams {
    /// The bed's centre, where the model's stands.
    #[serde(rename = "centre_mm")]
    pub centre: DVec2,
    /// The bed; rings that leave it are not printed.
    pub plate: BedShape,
    /// Diameter of a free strand.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// Diameter of the filament.
    #[serde(rename = "filament_diameter_mm")]
    pub filament: f64,
    /// Height of the first contours.
    #[serde(rename = "first_layer_height_mm")]
    pub first_layer: f64,
    /// Speed of extruding.
    #[serde(rename = "print_mm_s")]
    pub print_speed: f64,
    /// Speed of extruding onto the bed.
    #[serde(rename = "first_layer_mm_s")]
    pub bed_speed: f64,
    /// Speed of extruding layers.
    #[serde(rename = "layer_mm_s")]
    pub layer_speed: f64,
    /// Speed of floating strokes under [`Strategy::Slow`].
    #[serde(rename = "slow_mm_s")]
    pub slow_speed: f64,
    /// Speed of travelling.
    #[serde(rename = "travel_mm_s")]
    pub travel_speed: f64,
    /// What makes floating strokes hold.
    pub strategy: Strategy,
    /// How strands are cooled.
    pub cooling: CoolingMethod,
    /// Pause at the end of a floating stroke under [`Strategy::Pause`].
    #[serde(rename = "pause_s")]
    pub pause: f64,
    /// What the pause of a rising stroke may be shortened by; None where it is to be kept as it is.
    pub climb: Option<Climb>,
    /// Way past the end of a floating stroke under [`Strategy::Overshoot`].
    #[serde(rename = "overshoot_mm")]
    pub overshoot: f64,
    /// Time by which the flow lags behind the feed.
    #[serde(rename = "pressure_lag_s")]
    pub pressure_lag: f64,
    /// For which strokes the firmware makes up for that lag.
    #[serde(rename = "pressure_advance")]
    pub advance: PressureAdvance,
    /// Filament pulled back before a travel.
    #[serde(rename = "retract_mm")]
    pub retract: f64,
    /// Straight travels between a layer's lines that are no longer need no retraction.
    #[serde(rename = "layer_retract_over_mm")]
    pub layer_retract_over: f64,
    /// Speed of pulling back.
    #[serde(rename = "retract_speed_mm_s")]
    pub retract_speed: f64,
    /// Speed of pushing forward again.
    #[serde(rename = "unretract_speed_mm_s")]
    pub unretract_speed: f64,
    /// Filament fed before the first strand, to fill the nozzle.
    #[serde(rename = "prime_mm")]
    pub prime: f64,
    /// Height of what stands before the print begins; 0 where nothing does.
    #[serde(rename = "standing_mm")]
    pub standing: f64,
    /// Height of a travel above all that is printed.
    #[serde(rename = "travel_lift_mm")]
    pub travel_lift: f64,
    /// Rings around the print that prime the nozzle.
    pub skirt_rings: u32,
    /// Distance of the skirt from the print.
    #[serde(rename = "skirt_gap_mm")]
    pub skirt_gap: f64,
    /// Flat rings around each first contour; none given: as many as a small foot wants.
    pub brim_rings: Option<u32>,
}

impl PathParams {
    /// Filament for each mm of strand, mm: volume π/4·strand² over the filament's cross-section.
    #[must_use]
    pub fn feed_per_mm(&self) -> f64 {
        (self.strand / self.filament).powi(2)
    }

    /// Whether something at this height lies on the bed.
    #[must_use]
    pub fn is_on_bed(&self, z: f64) -> bool {
        z <= self.first_layer + 1e-9
    }
}
