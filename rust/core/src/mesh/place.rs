//! Where a model stands: scaled, turned, centred on the bed.

use glam::{DMat3, DQuat, DVec3};

use super::Mesh;
use crate::{CoreError, Result};

/// Which axis of the file points up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Up {
    /// The file's x axis.
    X,
    /// The file's y axis.
    Y,
    /// The file's z axis.
    Z,
}

/// How a model is brought from its file to the bed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// Millimetres per unit of the file, times the wanted scale.
    pub scale: f64,
    /// Axis of the file that points up.
    pub up: Up,
    /// Rotation about x, then y, then z after `up` was applied, radians.
    pub rotate: DVec3,
    /// Height to which the model is scaled in the end, mm.
    pub height: Option<f64>,
}

/// Largest extent that a model may have, mm; anything larger is a mistaken unit.
const LARGEST_MM: f64 = 10_000.0;
/// Smallest extent that a model may have, mm: less than a nozzle's width is a mistaken unit.
const SMALLEST_MM: f64 = 0.5;

impl Placement {
    fn matrix(&self) -> DMat3 {
        let upright = match self.up {
            Up::X => DMat3::from_cols(DVec3::Z, DVec3::X, DVec3::Y),
            Up::Y => DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y),
            Up::Z => DMat3::IDENTITY,
        };
        let turn = DQuat::from_rotation_z(self.rotate.z)
            * DQuat::from_rotation_y(self.rotate.y)
            * DQuat::from_rotation_x(self.rotate.x);
        DMat3::from_quat(turn) * upright * self.scale
    }
}

impl Mesh {
    /// The mesh scaled and turned, its bounding box centred at x = y = 0, its lowest point at z = 0.
    ///
    /// # Errors
    /// [`CoreError::Setting`] for a scale or height that is not positive,
    /// [`CoreError::Unreadable`] where the placed model is too large or too small.
    pub fn placed(mut self, placement: &Placement) -> Result<Self> {
        let positive = |v: f64| v.is_finite() && v > 0.0;
        if !positive(placement.scale) || placement.height.is_some_and(|h| !positive(h)) {
            return Err(CoreError::Setting("scale and height must be positive".into()));
        }
        let matrix = placement.matrix();
        for vertex in &mut self.vertices {
            *vertex = matrix * *vertex;
        }
        let (low, high) = self.bounds();
        let factor = match placement.height {
            Some(height) if high.z > low.z => height / (high.z - low.z),
            Some(_) => {
                return Err(CoreError::Unreadable("the model is flat: it has no height".into()));
            }
            None => 1.0,
        };
        let size = (high - low) * factor;
        let text = format!("{:.6} × {:.6} × {:.6} mm", size.x, size.y, size.z);
        if !size.is_finite() || size.max_element() > LARGEST_MM {
            return Err(CoreError::Unreadable(format!(
                "the model is too large: {text}; set --scale, --units or --height"
            )));
        }
        if size.max_element() < SMALLEST_MM {
            return Err(CoreError::Unreadable(format!(
                "the model is tiny: {text}; set --units (m, inch …), --scale or --height"
            )));
        }
        let foot = DVec3::new((low.x + high.x) / 2.0, (low.y + high.y) / 2.0, low.z);
        for vertex in &mut self.vertices {
            *vertex = (*vertex - foot) * factor;
        }
        Ok(self)
    }
}
