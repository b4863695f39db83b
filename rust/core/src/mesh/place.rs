//! Where a model stands: scaled, turned, centred on the bed.

use glam::{DAffine3, DMat3, DQuat, DVec3};
use rayon::prelude::*;

use super::indexed::Mesh;
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
pub struct MeshPlacement {
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

impl MeshPlacement {
    fn check(&self) -> Result<()> {
        let positive = |v: f64| v.is_finite() && v > 0.0;
        let refused = |what: &str, value: f64, rule: &str| {
            Err(CoreError::Setting(format!("{what} is {value}; it must be {rule}")))
        };
        match self.height {
            _ if !positive(self.scale) => refused("scale", self.scale, "positive"),
            Some(height) if !positive(height) => refused("height", height, "positive"),
            _ if !self.rotate.is_finite() => refused("rotate", f64::NAN, "finite"),
            _ => Ok(()),
        }
    }

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
    /// [`CoreError::Setting`] for a scale or height that is not positive or a rotation that is
    /// not finite, [`CoreError::Unreadable`] where the placed model is too large.
    pub fn placed(mut self, placement: &MeshPlacement) -> Result<Self> {
        placement.check()?;
        let matrix = placement.matrix();
        self.vertices.par_iter_mut().for_each(|vertex| *vertex = matrix * *vertex);
        let (low, high) = self.bounds();
        let factor = match placement.height {
            Some(height) if high.z > low.z => height / (high.z - low.z),
            Some(_) => {
                return Err(CoreError::Unreadable("the model is flat: it has no height".into()));
            }
            None => 1.0,
        };
        check_size((high - low) * factor)?;
        let foot = DVec3::new((low.x + high.x) / 2.0, (low.y + high.y) / 2.0, low.z);
        self.vertices.par_iter_mut().for_each(|vertex| *vertex = (*vertex - foot) * factor);
        let applied = DAffine3::from_mat3_translation(matrix * factor, -foot * factor);
        self.placement = applied * self.placement;
        Ok(self)
    }
}

fn check_size(size: DVec3) -> Result<()> {
    if size.is_finite() && size.max_element() <= LARGEST_MM {
        return Ok(());
    }
    Err(CoreError::Unreadable(format!(
        "the model measures {} × {} × {} mm and is too large: shrink it by --scale, --units or \
         --height",
        rounded(size.x),
        rounded(size.y),
        rounded(size.z)
    )))
}

/// The length with four significant digits.
fn rounded(length: f64) -> String {
    let digits = (3.0 - length.abs().max(1e-9).log10().floor()).clamp(0.0, 12.0);
    format!("{length:.*}", digits as usize)
}
