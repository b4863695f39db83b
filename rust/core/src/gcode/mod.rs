//! Stage: gcode.
