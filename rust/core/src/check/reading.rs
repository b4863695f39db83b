//! What a text commands: its moves, and whatever keeps them from being certain.

use std::collections::BTreeMap;

use super::deposit::Dwell;
use super::nozzle::Nozzle;
use super::verdict::{Cold, Unhomed, Unjudged};
use crate::gcode::command::{Axes, Command};
use crate::gcode::dialect::Dialect;
use crate::gcode::event::{Event, Step};
use crate::gcode::extrusion;
use crate::gcode::machine::{Machine, MachineSettings};
use crate::gcode::reader::Commands;
use crate::gcode::vocabulary::{self, Effect};

/// Unjudged commands that are kept; one of them is enough to refuse a file.
const MOST_UNJUDGED: usize = 100;
/// Characters of a command that are shown.
const SHOWN: usize = 60;

const PLACE: &str = "where the head is then is not known: a macro or a probe moved it before";
const TOOL: &str = "it changes the tool";
const GRAMMAR: &str = "firmwares refuse it, or read it in different ways";
const ARCS: &str = "the arcs up to here have more chords than a text of this length may have";

/// What macros of the printer's do: name, and G-code that calls no others.
pub type Macros = [(String, String)];

/// A text as it was read.
pub(crate) struct Reading {
    pub(crate) notes: ReadingNotes,
    /// The `;TYPE:` labels that the moves refer to.
    pub(crate) features: Vec<String>,
    /// Whether E was taken as relative though the text does not say so.
    pub(super) relative_assumed: bool,
}

impl Reading {
    pub(crate) fn of(
        text: &[u8],
        settings: MachineSettings,
        macros: &Macros,
        coldest: f64,
    ) -> Self {
        let relative_assumed = !settings.relative_extrusion && extrusion::is_relative(text);
        let relative_extrusion = settings.relative_extrusion || relative_assumed;
        let mut machine = Machine::new(MachineSettings { relative_extrusion, ..settings });
        let mut notes = ReadingNotes::new(settings.dialect, coldest);
        for (line, command) in Commands::new(text) {
            match expansion(&command, macros) {
                None => notes.carry_out(line, &command, &mut machine),
                Some(text) => Commands::new(text.as_bytes())
                    .for_each(|(_, inner)| notes.carry_out(line, &inner, &mut machine)),
            }
        }
        Self { notes, features: machine.features().to_vec(), relative_assumed }
    }
}

/// What a macro does, if it is one that is known.
fn expansion<'a>(command: &Command<'_>, macros: &'a Macros) -> Option<&'a str> {
    let Command::Named(name, _) = command else { return None };
    let known = macros.iter().find(|(known, _)| name.eq_ignore_ascii_case(known.as_bytes()));
    known.map(|(_, text)| text.as_str())
}

/// What is noted on the way through a text.
pub(crate) struct ReadingNotes {
    dialect: Dialect,
    nozzle: Nozzle,
    /// Which of X, Y and Z are where the machine says that they are.
    placed: [bool; 3],
    /// Whether anything was printed yet.
    begun: bool,
    /// Whether a macro has just done what is not known, homing perhaps.
    prepared: bool,
    /// Whether the last extrusion was cold, the last move unhomed: a run is named once.
    was_cold: bool,
    was_unhomed: bool,
    pub(crate) moves: Vec<Step>,
    pub(crate) dwells: Vec<Dwell>,
    pub(super) cold: Vec<Cold>,
    pub(super) unhomed: Vec<Unhomed>,
    pub(super) unjudged: Vec<Unjudged>,
    pub(super) harmless: BTreeMap<String, usize>,
    pub(super) preparing: BTreeMap<String, usize>,
    pub(super) garbage_lines: usize,
}

impl ReadingNotes {
    fn new(dialect: Dialect, coldest: f64) -> Self {
        Self {
            dialect,
            nozzle: Nozzle::new(coldest),
            placed: [true; 3],
            begun: false,
            prepared: false,
            was_cold: false,
            was_unhomed: false,
            moves: Vec::new(),
            dwells: Vec::new(),
            cold: Vec::new(),
            unhomed: Vec::new(),
            unjudged: Vec::new(),
            harmless: BTreeMap::new(),
            preparing: BTreeMap::new(),
            garbage_lines: 0,
        }
    }

    #[inline]
    fn carry_out(&mut self, line: u64, command: &Command<'_>, machine: &mut Machine) {
        if vocabulary::has_second_command(command) {
            self.doubt(line, &vocabulary::name(command), vocabulary::SECOND);
        }
        if self.begun && vocabulary::homes_otherwise(command) {
            self.doubt(line, "G28", vocabulary::HOMING_WORD);
        }
        if self.placed != [true; 3] {
            self.place(line, command, machine.is_relative());
        }
        let homed = machine.homed();
        machine.apply(line, command, |event| match event {
            Event::Step(step) => self.step(step, homed),
            event => self.other(line, command, event),
        });
        if std::mem::take(&mut self.prepared) {
            machine.assume_homed();
        }
    }

    /// A move to a place that it names knows it again.
    fn place(&mut self, line: u64, command: &Command<'_>, relative: bool) {
        match command {
            Command::Linear { axes, .. } | Command::Arc { axes, .. } if !relative => {
                for (placed, word) in self.placed.iter_mut().zip([axes.x, axes.y, axes.z]) {
                    *placed |= word.is_some();
                }
            }
            Command::SetPosition { axes, .. } if sets_a_place(axes) => {
                self.doubt(line, "G92", PLACE);
            }
            _ => {}
        }
    }

    #[inline]
    fn step(&mut self, step: Step, homed: [bool; 3]) {
        if homed != [true; 3] {
            self.unhomed(&step, homed);
        }
        if step.filament > 0.0 {
            self.extrude(&step);
        }
        self.moves.push(step);
    }

    fn unhomed(&mut self, step: &Step, homed: [bool; 3]) {
        let (from, to) = (step.from.to_array(), step.to.to_array());
        let axes = [0, 1, 2].map(|axis| from[axis] != to[axis] && !homed[axis]);
        let unhomed = axes != [false; 3];
        if unhomed && !self.was_unhomed {
            self.unhomed.push(Unhomed { line: step.line, at: step.to, axes });
        }
        self.was_unhomed |= unhomed;
    }

    #[inline]
    fn extrude(&mut self, step: &Step) {
        let cold = self.nozzle.is_cold();
        if cold && !self.was_cold {
            let target = self.nozzle.target();
            self.cold.push(Cold { line: step.line, at: step.from, target });
        }
        self.was_cold = cold;
        if step.from != step.to {
            self.begun = true;
            if self.placed != [true; 3] {
                self.doubt(step.line, "G1", PLACE);
                self.placed = [true; 3];
            }
        }
    }

    fn other(&mut self, line: u64, command: &Command<'_>, event: Event<'_>) {
        match event {
            Event::Homing(step) => self.moves.push(step),
            Event::Home(axes) => {
                self.placed.iter_mut().zip(axes).for_each(|(placed, home)| *placed |= home);
                self.was_unhomed = false;
            }
            Event::Dwell(seconds) if !self.moves.is_empty() => {
                self.dwells.push(Dwell { after: self.moves.len() - 1, seconds });
            }
            Event::Tool { changed: true, .. } => self.doubt(line, &vocabulary::name(command), TOOL),
            Event::Tool { .. } => count(&mut self.harmless, command),
            Event::Other(command) => self.effect(line, &command),
            Event::Word(word) => {
                let text = format!("a word {} in a move", char::from(word));
                self.doubt(line, &text, GRAMMAR);
            }
            Event::CoarseArc => self.doubt(line, "an arc", ARCS),
            Event::Garbage(text) => {
                self.garbage_lines += 1;
                self.doubt(line, &String::from_utf8_lossy(text), GRAMMAR);
            }
            Event::Step(_) | Event::Dwell(_) | Event::Layer | Event::LayerHeight(_) => {}
        }
    }

    /// A command that the machine does not carry out.
    fn effect(&mut self, line: u64, command: &Command<'_>) {
        match vocabulary::effect(command, self.dialect) {
            Effect::Harmless => {
                self.nozzle.command(command);
                count(&mut self.harmless, command);
            }
            Effect::Prepares if !self.begun => {
                count(&mut self.preparing, command);
                self.placed = [false; 3];
                if vocabulary::homes_by_itself(command) {
                    self.prepared = true;
                    self.nozzle.forget();
                }
            }
            Effect::Prepares => {
                let why = vocabulary::within_a_print(command);
                self.doubt(line, &vocabulary::name(command), why);
            }
            Effect::Unknown(why) => self.doubt(line, &vocabulary::name(command), why),
        }
    }

    /// Nothing is certain from here on.
    fn doubt(&mut self, line: u64, command: &str, why: &'static str) {
        if self.unjudged.len() < MOST_UNJUDGED {
            let command = command.trim().chars().take(SHOWN).collect();
            self.unjudged.push(Unjudged { line, command, why: why.into() });
        }
    }
}

fn sets_a_place(axes: &Axes) -> bool {
    axes.x.or(axes.y).or(axes.z).is_some() || axes.e.is_none()
}

fn count(counts: &mut BTreeMap<String, usize>, command: &Command<'_>) {
    *counts.entry(vocabulary::name(command)).or_default() += 1;
}
