//! What of a head is not round about its nozzle: fan ducts and shrouds as boxes, probes as cylinders.
//!
//! A part reaches up from its bottom without end, as all of the head does: what carries it is there,
//! and no material ever is above a head without having been below it.

use glam::{DVec2, DVec3};
use serde::Deserialize;

use super::clip::{self, Rectangle};
use super::sweep::{Hit, Parallelogram, Tier, are_near};
use crate::error::{CoreError, Result};

/// A part by the names of a profile's `[[head.parts]]`: mm from the tip, and degrees.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(tag = "shape", rename_all = "lowercase")]
pub enum Shape {
    /// A box with upright sides.
    Box {
        /// Where it begins and ends along x, mm.
        x_mm: [f64; 2],
        /// Where it begins and ends along y, mm.
        y_mm: [f64; 2],
        /// Its lowest height, mm.
        bottom_mm: f64,
        /// How far these extents are turned about the nozzle, anticlockwise from above, degrees.
        turn_deg: f64,
    },
    /// An upright cylinder.
    Cylinder {
        /// Where its axis stands, mm.
        centre_mm: [f64; 2],
        /// Its radius, mm.
        radius_mm: f64,
        /// Its lowest height, mm.
        bottom_mm: f64,
    },
}

/// A convex part of the head that opens upwards.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "Shape")]
pub struct HeadPart {
    footprint: Footprint,
    bottom: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Footprint {
    Rectangle(Rectangle),
    Disc { middle: DVec2, radius: f64 },
}

impl TryFrom<Shape> for HeadPart {
    type Error = CoreError;

    fn try_from(shape: Shape) -> Result<Self> {
        let part = match shape {
            Shape::Box { x_mm, y_mm, bottom_mm, turn_deg } => {
                let (low, high) = (DVec2::new(x_mm[0], y_mm[0]), DVec2::new(x_mm[1], y_mm[1]));
                let axis = DVec2::from_angle(turn_deg.to_radians());
                let middle = axis.rotate((low + high) / 2.0);
                let rectangle = Rectangle { middle, axis, half: (high - low) / 2.0 };
                Self { footprint: Footprint::Rectangle(rectangle), bottom: bottom_mm }
            }
            Shape::Cylinder { centre_mm, radius_mm, bottom_mm } => {
                let footprint =
                    Footprint::Disc { middle: DVec2::from_array(centre_mm), radius: radius_mm };
                Self { footprint, bottom: bottom_mm }
            }
        };
        part.is_sound().then_some(part).ok_or_else(|| {
            CoreError::Setting(
                "each of the head's parts must have positive extents, and its bottom above the tip"
                    .into(),
            )
        })
    }
}

impl HeadPart {
    fn is_sound(&self) -> bool {
        let extent = match self.footprint {
            Footprint::Rectangle(on) if on.axis.is_finite() => on.half.min_element(),
            Footprint::Rectangle(_) => f64::NAN,
            Footprint::Disc { radius, .. } => radius,
        };
        let figures = [extent, self.bottom];
        self.middle().is_finite() && figures.iter().all(|v| v.is_finite() && *v > 0.0)
    }

    /// Height of its underside above the tip, mm.
    #[must_use]
    pub fn bottom(&self) -> f64 {
        self.bottom
    }

    /// Where its middle stands, seen from the tip, mm.
    #[must_use]
    pub fn middle(&self) -> DVec2 {
        match self.footprint {
            Footprint::Rectangle(on) => on.middle,
            Footprint::Disc { middle, .. } => middle,
        }
    }

    /// Distance from its middle to its farthest point over xy, mm.
    #[must_use]
    pub fn radius(&self) -> f64 {
        match self.footprint {
            Footprint::Rectangle(on) => on.half.length(),
            Footprint::Disc { radius, .. } => radius,
        }
    }

    /// Half of its extent along x and y, mm.
    #[must_use]
    pub fn half(&self) -> DVec2 {
        match self.footprint {
            Footprint::Rectangle(on) => on.extent(),
            Footprint::Disc { radius, .. } => DVec2::splat(radius),
        }
    }

    /// Whether material up to `half` mm from the tip along x and y may be below it.
    #[must_use]
    pub fn meets(&self, half: DVec2) -> bool {
        match self.footprint {
            Footprint::Rectangle(on) => on.meets(half),
            Footprint::Disc { middle, radius } => {
                (middle.abs() - half).max(DVec2::ZERO).length() <= radius
            }
        }
    }

    /// The deepest that a straight move of the tip drives this part into a straight strand, if that
    /// is more than `tolerance` (mm, not negative); exact to rounding.
    #[must_use]
    pub fn deeper_than(&self, tolerance: f64, tip: [DVec3; 2], strand: [DVec3; 2]) -> Option<Hit> {
        let top = strand[0].z.max(strand[1].z) - tip[0].z.min(tip[1].z);
        let middle = self.middle().extend(0.0);
        if top - self.bottom <= tolerance
            || !are_near(tip.map(|p| p + middle), strand, self.radius() * (1.0 + 1e-9))
        {
            return None;
        }
        let mut worst = Hit::none(tolerance);
        match self.footprint {
            Footprint::Rectangle(on) => {
                clip::deepen(&Parallelogram::new(tip, strand), &on, self.bottom, &mut worst);
            }
            Footprint::Disc { radius, .. } => {
                let (height, flat, reach) = (self.bottom, radius, radius);
                let tier = Tier { height, flat, slope: 0.0, reach };
                Parallelogram::new(tip.map(|p| p + middle), strand).deepen(&tier, &mut worst);
            }
        }
        worst.found()
    }
}
