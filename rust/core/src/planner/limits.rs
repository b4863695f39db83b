//! What a machine can do, as its configuration states it.

use glam::DVec3;
use serde::Deserialize;

use crate::error::{CoreError, Result};
use crate::gcode::arc::Fineness;
use crate::gcode::dialect::Dialect;
use crate::gcode::homing::{Homing, Way};
use crate::gcode::machine::MachineSettings;
use crate::gcode::retraction::Retraction;

/// Whose planner is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Firmware {
    /// Klipper: square corner velocity, minimum cruise ratio.
    Klipper,
    /// Marlin 2.1 with junction deviation.
    #[serde(rename = "marlin")]
    MarlinJunctionDeviation,
    /// Marlin 2.1 with classic jerk.
    #[serde(rename = "marlin-jerk")]
    MarlinJerk,
}

/// How motors move the head.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kinematics {
    /// A motor for each axis.
    Cartesian,
    /// Two motors that move x + y and x − y.
    CoreXy,
    /// Three towers.
    Delta(DeltaGeometry),
}

/// The measures of a delta printer, mm.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct DeltaGeometry {
    /// Horizontal distance from the effector's joints to the towers when centred.
    #[serde(rename = "delta_radius")]
    pub radius: f64,
    /// Length of the arms.
    pub arm_length: f64,
    /// Travel of a carriage in one microstep.
    pub step_distance: f64,
    /// Height of the nozzle at the endstops.
    pub endstop_height: f64,
}

impl DeltaGeometry {
    /// Squared distance from the centre beyond which a carriage moves `ratio` times as fast as the
    /// head, mm² (Klipper's R(q)).
    pub(super) fn taper_radius_squared(&self, ratio: f64) -> f64 {
        let half_step = self.step_distance / 2.0;
        let reach = self.arm_length * self.arm_length / (ratio * ratio + 1.0);
        let radius =
            ratio * (reach - half_step * half_step).max(0.0).sqrt() + half_step - self.radius;
        radius * radius
    }
}

/// Limits that only Marlin has; arrays are X, Y, Z, E.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct MarlinLimits {
    /// M203, mm/s.
    pub max_velocity: [f64; 4],
    /// M201, mm/s².
    pub max_accel: [f64; 4],
    /// M205 X Y Z E, mm/s.
    pub jerk: [f64; 4],
    /// M205 J, mm.
    pub junction_deviation: f64,
    /// M204 P, mm/s².
    pub print_accel: f64,
    /// M204 T, mm/s².
    pub travel_accel: f64,
    /// M204 R, mm/s².
    pub retract_accel: f64,
    /// M92.
    pub steps_per_mm: [f64; 4],
}

/// The limits of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct Limits {
    /// How motors move the head.
    pub kinematics: Kinematics,
    /// Greatest speed of the head, mm/s.
    pub max_velocity: f64,
    /// Greatest acceleration of the head, mm/s².
    pub max_accel: f64,
    /// Speed through a right angle, mm/s.
    pub square_corner_velocity: f64,
    /// Share of a move that must be cruised, 0 up to below 1.
    pub minimum_cruise_ratio: f64,
    /// Greatest speed along z, mm/s.
    pub max_z_velocity: f64,
    /// Greatest acceleration along z, mm/s².
    pub max_z_accel: f64,
    /// Greatest speed of the filament while the head stands or rises, mm/s.
    pub max_extrude_only_velocity: f64,
    /// Greatest acceleration of the filament then, mm/s².
    pub max_extrude_only_accel: f64,
    /// Greatest jump of the extruder's speed at a corner, mm/s.
    pub instantaneous_corner_velocity: f64,
    /// Length of the chords of an arc, mm.
    pub arc_resolution: f64,
    /// What G10 and G11 do until a file says otherwise; `None`: the firmware's defaults.
    pub retraction: Option<Retraction>,
    /// What only Marlin reads.
    pub marlin: MarlinLimits,
}

impl Limits {
    /// Checks every figure.
    ///
    /// # Errors
    /// [`CoreError::Setting`] names the figure that is not finite, not positive or out of bounds.
    pub fn validate(&self) -> Result<()> {
        for (name, value) in self.positives() {
            if !(value.is_finite() && value > 0.0) {
                return Err(CoreError::Setting(format!(
                    "motion limit {name} is {value}; it must be a positive number"
                )));
            }
        }
        let corners = [
            ("square_corner_velocity", self.square_corner_velocity),
            ("instantaneous_corner_velocity", self.instantaneous_corner_velocity),
        ];
        if let Some((name, value)) = corners.iter().find(|(_, v)| !(v.is_finite() && *v >= 0.0)) {
            return Err(CoreError::Setting(format!(
                "motion limit {name} is {value}; it must not be negative"
            )));
        }
        if !(0.0..1.0).contains(&self.minimum_cruise_ratio) {
            return Err(CoreError::Setting(format!(
                "motion limit minimum_cruise_ratio is {}; it must be at least 0 and below 1",
                self.minimum_cruise_ratio
            )));
        }
        if let Kinematics::Delta(delta) = self.kinematics
            && delta.arm_length <= delta.radius
        {
            return Err(CoreError::Setting(format!(
                "motion limit arm_length is {}; it must exceed delta_radius, {}",
                delta.arm_length, delta.radius
            )));
        }
        Ok(())
    }

    /// Every figure that must be positive, with the name it has in a configuration.
    fn positives(&self) -> Vec<(&'static str, f64)> {
        let mut figures = vec![
            ("max_velocity", self.max_velocity),
            ("max_accel", self.max_accel),
            ("max_z_velocity", self.max_z_velocity),
            ("max_z_accel", self.max_z_accel),
            ("max_extrude_only_velocity", self.max_extrude_only_velocity),
            ("max_extrude_only_accel", self.max_extrude_only_accel),
            ("arc_resolution", self.arc_resolution),
            ("junction_deviation", self.marlin.junction_deviation),
            ("print_accel", self.marlin.print_accel),
            ("travel_accel", self.marlin.travel_accel),
            ("retract_accel", self.marlin.retract_accel),
        ];
        figures.extend(self.marlin.max_velocity.map(|v| ("max_axis_velocity", v)));
        figures.extend(self.marlin.max_accel.map(|a| ("max_axis_accel", a)));
        figures.extend(self.marlin.jerk.map(|j| ("jerk", j)));
        figures.extend(self.marlin.steps_per_mm.map(|s| ("steps_per_mm", s)));
        if let Kinematics::Delta(delta) = self.kinematics {
            figures.extend([
                ("delta_radius", delta.radius),
                ("arm_length", delta.arm_length),
                ("step_distance", delta.step_distance),
                ("endstop_height", delta.endstop_height),
            ]);
        }
        figures
    }

    /// How a machine with these limits reads G-code.
    pub(super) fn machine_settings(
        &self,
        firmware: Firmware,
        relative_extrusion: bool,
    ) -> MachineSettings {
        let homing = match self.kinematics {
            Kinematics::Delta(DeltaGeometry {
                radius, arm_length: arm, endstop_height, ..
            }) => Homing { at: DVec3::Z * endstop_height, way: Way::Delta { radius, arm } },
            Kinematics::Cartesian | Kinematics::CoreXy => Homing::AT_ORIGIN,
        };
        let (dialect, default) = match firmware {
            Firmware::Klipper => (Dialect::Klipper, Retraction::KLIPPER),
            Firmware::MarlinJunctionDeviation | Firmware::MarlinJerk => {
                (Dialect::Marlin, Retraction::MARLIN)
            }
        };
        let arcs = Fineness { resolution: self.arc_resolution, sagitta: None };
        let retraction = self.retraction.unwrap_or(default);
        MachineSettings { dialect, arcs, homing, retraction, relative_extrusion }
    }
}

/// Takes a limit from a word of the file; firmwares refuse what is not positive.
pub(super) fn set_positive(limit: &mut f64, value: Option<f64>) {
    if let Some(value) = value.filter(|value| *value > 0.0 && value.is_finite()) {
        *limit = value;
    }
}
