//! What comes of a command.

use glam::DVec3;

use super::command::Command;

/// One straight move of the head or the filament.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Line of the file, from 1.
    pub line: u64,
    /// Where the head starts, mm, in the machine's coordinates.
    pub from: DVec3,
    /// Where the head arrives, mm.
    pub to: DVec3,
    /// Filament fed, mm; negative where it is pulled back.
    pub filament: f64,
    /// Feed asked for, mm/s: along the path, or of the filament where the head stands.
    pub speed: f64,
    /// Whether the move was written as G0.
    pub rapid: bool,
    /// Whether it is part of the way home of a G28, at a speed of the firmware's own.
    pub homing: bool,
    /// Index into [`Machine::features`](super::machine::Machine::features).
    pub feature: u16,
}

/// What a command asks for beside moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<'a> {
    /// A straight move; one that moves nothing is not reported.
    Step(Step),
    /// A straight piece of the way home.
    Homing(Step),
    /// G28 is done: which of X, Y and Z are home.
    Home([bool; 3]),
    /// The head stands still, s.
    Dwell(f64),
    /// A tool is chosen; whether it was another before.
    Tool {
        /// Its number.
        number: u32,
        /// Whether another tool was chosen before.
        changed: bool,
    },
    /// A layer begins (`;LAYER_CHANGE` or `;LAYER:n`).
    Layer,
    /// A comment states the layer's height (`;Z:`), mm.
    LayerHeight(f64),
    /// A command that moves nothing as far as is known here, for those whom it concerns.
    Other(Command<'a>),
    /// A command that was carried out as if its words said no more, but one of them does: its
    /// letter.
    Word(u8),
    /// An arc that was cut to one chord, since the arcs before it took all that a text of its
    /// length may have.
    CoarseArc,
    /// A line that is not executed.
    Garbage(&'a [u8]),
}
