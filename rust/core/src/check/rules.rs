//! What a file is judged by.

use glam::{DVec2, DVec3};
use serde::Deserialize;

use crate::head::Head;

/// The bed's outline and the height of the build volume.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Bed {
    /// Centre of the bed, mm.
    #[serde(rename = "centre_mm")]
    pub centre: DVec2,
    /// Half of its extent along x and y, mm.
    #[serde(rename = "half_mm")]
    pub half: DVec2,
    /// Whether it is the ellipse in that rectangle.
    pub round: bool,
    /// Greatest height of the tip, mm.
    #[serde(rename = "height_mm")]
    pub height: f64,
    /// How far the axes reach beyond that rectangle towards low and high x and y, mm, not negative:
    /// where machines home, park and purge. Only travels and what lies on the bed may go there.
    #[serde(rename = "margins_mm")]
    pub margins: [DVec2; 2],
}

/// Limits of machine and firmware; infinite where there is none.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Limits {
    /// Greatest feed, mm/s.
    #[serde(rename = "feed_mm_s")]
    pub feed: f64,
    /// What the hot end melts, mm³/s.
    #[serde(rename = "flow_mm3_s")]
    pub flow: f64,
    /// Most filament moved by one command while the tip stands still, mm.
    #[serde(rename = "filament_only_mm")]
    pub filament_only: f64,
    /// Filament that may stay pulled back and is not missed, mm.
    #[serde(rename = "pulled_back_mm")]
    pub pulled_back: f64,
    /// Cross-section of the filament, mm².
    #[serde(rename = "filament_area_mm2")]
    pub filament_area: f64,
}

impl Bed {
    /// A bed to whose edge the axes reach, and no farther.
    #[must_use]
    pub fn new(centre: DVec2, half: DVec2, round: bool, height: f64) -> Self {
        Self { centre, half, round, height, margins: [DVec2::ZERO; 2] }
    }

    /// How far a point lies outside what the axes reach, mm; 0 inside.
    pub(super) fn beyond(&self, p: DVec3) -> f64 {
        let [low, high] = self.margins;
        if low == DVec2::ZERO && high == DVec2::ZERO {
            return self.outside(p);
        }
        let offset = p.truncate() - self.centre;
        let beside = (-self.half - low - offset).max(offset - self.half - high).max_element();
        beside.max(p.z - self.height).max(0.0)
    }

    /// How far a point lies outside the build volume, mm; 0 inside. Depth below the bed does not
    /// count: that is a collision.
    pub(super) fn outside(&self, p: DVec3) -> f64 {
        let offset = p.truncate() - self.centre;
        let beside = if self.round {
            let scaled = (offset / self.half).length();
            offset.length() * (1.0 - 1.0 / scaled.max(1.0))
        } else {
            (offset.abs() - self.half).max_element()
        };
        beside.max(p.z - self.height).max(0.0)
    }
}

/// What the file is judged by.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Rules {
    /// The head that moves.
    pub head: Head,
    /// Diameter of a free strand, mm.
    #[serde(rename = "strand_mm")]
    pub strand: f64,
    /// A strand printed with the tip at or below this height lies on the bed, mm.
    #[serde(rename = "bed_contact_mm")]
    pub bed_contact: f64,
    /// Longest stretch held at both ends, mm.
    #[serde(rename = "span_limit_mm")]
    pub span_limit: f64,
    /// Longest stretch held at one end, mm.
    #[serde(rename = "free_end_limit_mm")]
    pub free_end_limit: f64,
    /// The bed and the height above it.
    pub bed: Bed,
    /// What machine and firmware allow.
    pub limits: Limits,
    /// What lets a free end hold by itself.
    pub settling: Settling,
    /// Below this a nozzle must not extrude, °C.
    #[serde(rename = "coldest_c")]
    pub coldest: f64,
}

/// What lets the end of a stroke in the air hold by itself: the head stays until it has set, or has
/// been so slow that it sets as it is laid.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Settling {
    /// Shortest dwell that does, s; 0: none is asked for.
    #[serde(rename = "dwell_s")]
    pub dwell: f64,
    /// At this speed and below, none is needed, mm/s.
    #[serde(rename = "slow_mm_s")]
    pub slow: f64,
}

impl Rules {
    /// How far material may reach into the head, mm: the squash of a joint.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.strand / 2.0
    }
}
