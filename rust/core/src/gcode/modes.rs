//! What a text leaves behind for the one that follows it: modes, the head's place, E's reading.

use glam::DVec3;

use super::extrusion;
use super::machine::{Machine, MachineSettings};
use super::reader::Commands;

/// What moves that are put into a text must find, and leave as they found it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modes {
    /// Where the head is, mm.
    pub at: DVec3,
    /// Reading of the extruder's axis, in the unit that the text feeds in.
    pub extruder: f64,
    /// Whether E counts from the last move (M83).
    pub relative_extrusion: bool,
    /// Feed as it is written, mm/s.
    pub feed: f64,
    /// Whether a move means what it says: coordinates count from the machine's origin (G90, no G92
    /// of axes), in mm, and neither feed nor filament is scaled.
    pub plain: bool,
}

impl Modes {
    /// What a text leaves behind.
    #[must_use]
    pub fn after(text: &[u8], settings: MachineSettings) -> Self {
        let relative_extrusion = settings.relative_extrusion || extrusion::is_relative(text);
        let mut machine = Machine::new(MachineSettings { relative_extrusion, ..settings });
        for (line, command) in Commands::new(text) {
            machine.apply(line, &command, |_| {});
        }
        let (extruder, relative_extrusion) = machine.extruder();
        let (at, feed, plain) = (machine.position(), machine.feed(), machine.is_plain());
        Self { at, extruder, relative_extrusion, feed, plain }
    }
}

#[cfg(test)]
mod tests {
    use super::Modes;
    use crate::gcode::arc::Fineness;
    use crate::gcode::dialect::Dialect;
    use crate::gcode::homing::Homing;
    use crate::gcode::machine::MachineSettings;
    use crate::gcode::retraction::Retraction;

    fn after(text: &str) -> Modes {
        let settings = MachineSettings {
            dialect: Dialect::Marlin,
            arcs: Fineness { resolution: 1.0, sagitta: None },
            homing: Homing::AT_ORIGIN,
            retraction: Retraction::MARLIN,
            relative_extrusion: false,
        };
        Modes::after(text.as_bytes(), settings)
    }

    #[test]
    fn a_place_a_reading_and_a_feed_are_those_of_the_last_words() {
        let modes = after("G28\nG90\nM82\nG1 X10 Y5 Z2 F1200\nG1 X20 E3.5\nG92 E1\nG1 E1.5 F600\n");
        assert_eq!(modes.at.to_array(), [20.0, 5.0, 2.0]);
        assert!((modes.extruder - 1.5).abs() < 1e-9 && (modes.feed - 10.0).abs() < 1e-9);
        assert!(modes.plain && !modes.relative_extrusion);
    }

    #[test]
    fn whatever_shifts_or_scales_what_follows_is_not_plain() {
        for text in ["G91\n", "G20\n", "G92 X5\n", "M220 S50\n", "M221 S90\n", "M200 D1.75\n"] {
            assert!(!after(&format!("G28\nG1 X10\n{text}")).plain, "{text}");
        }
        assert!(after("G28\nG1 X10\nM83\n").relative_extrusion);
    }
}
