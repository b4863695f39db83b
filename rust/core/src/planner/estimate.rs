//! From text to time: reader, machine, planner and tally in one pass.

use std::fs::File;
use std::io::{Read, Seek};
use std::ops::ControlFlow;
use std::path::Path;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::klipper::Klipper;
use super::limits::{Firmware, Limits};
use super::marlin::{Junction, Marlin};
use super::tally::{Feed, LayerTime, Moves, Tally};
use crate::error::{CoreError, Result};
use crate::gcode::command::{Command, Words};
use crate::gcode::event::{Event, Step};
use crate::gcode::extrusion::ImpliedMode;
use crate::gcode::machine::Machine;
use crate::gcode::reader::stream;

/// Time for what G-code only commands but does not describe, s.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Allowances {
    /// For each G28.
    pub homing_s: f64,
    /// For each M109 to a higher temperature than the last.
    pub nozzle_heating_s: f64,
    /// For each M190 to a higher temperature than the last.
    pub bed_heating_s: f64,
    /// For each change of tool, and each M600.
    pub tool_change_s: f64,
}

/// How to estimate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Whose planner.
    pub firmware: Firmware,
    /// What homing and heating count.
    pub allowances: Allowances,
    /// Whether to keep one row for each move.
    pub per_move: bool,
}

/// The time that a file takes, and where it goes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Time in motion, s.
    pub moving_s: f64,
    /// Time of G4, s.
    pub dwell_s: f64,
    /// Time of moves of the head that extrude nothing, s; part of `moving_s`.
    pub travel_s: f64,
    /// Allowed for homing, s.
    pub homing_s: f64,
    /// Allowed for heating, s.
    pub heating_s: f64,
    /// Allowed for changes of tool or filament, s.
    pub tool_change_s: f64,
    /// Number of these changes.
    pub tool_changes: u64,
    /// Time by feature, s: `travel`, `retract`, `dwell`, then `;TYPE:` labels in small letters in
    /// the order of the file, `other` for strands without; adds up to moving and dwelling.
    pub by_feature: Vec<(String, f64)>,
    /// Time by layer; the first entry is what comes before the first layer, if anything does.
    pub by_layer: Vec<LayerTime>,
    /// Filament used, mm: the furthest that it was ever fed.
    pub filament_mm: f64,
    /// Moves, arcs counted by their chords.
    pub moves: u64,
    /// Lines that no firmware would execute.
    pub garbage_lines: u64,
    /// Whether E was taken as relative though the file does not say so, since it runs backwards.
    pub relative_assumed: bool,
    /// One row for each move, where asked for.
    pub per_move: Option<Moves>,
}

impl Estimate {
    /// Everything: motion, dwells and allowances, s.
    #[must_use]
    pub fn total_s(&self) -> f64 {
        self.moving_s + self.dwell_s + self.homing_s + self.heating_s + self.tool_change_s
    }
}

/// Estimates G-code in memory.
///
/// # Errors
/// [`CoreError::Setting`] for a limit out of bounds.
pub fn estimate(text: &[u8], limits: &Limits, options: &Options) -> Result<Estimate> {
    EstimateInput { limits, options }.over(|| Ok(text))
}

/// Estimates files in parallel, the results in their order, in memory that does not grow with their
/// length (beyond one entry for each layer, and the rows that [`Options::per_move`] asks for).
///
/// # Errors
/// For each file: [`CoreError::Setting`] for a limit out of bounds, [`CoreError::Gcode`] where it
/// cannot be read.
#[must_use]
pub fn estimate_files<P: AsRef<Path> + Sync>(
    paths: &[P],
    limits: &Limits,
    options: &Options,
) -> Vec<Result<Estimate>> {
    let one = |path: &P| {
        let path = path.as_ref();
        let named = |e: std::io::Error| CoreError::Gcode(format!("{}: {e}", path.display()));
        let mut file = File::open(path).map_err(named)?;
        EstimateInput { limits, options }.over(|| {
            file.rewind().map_err(named)?;
            file.try_clone().map_err(named)
        })
    };
    paths.par_iter().map(one).collect()
}

/// What a text is estimated with.
struct EstimateInput<'a> {
    limits: &'a Limits,
    options: &'a Options,
}

impl EstimateInput<'_> {
    /// Estimates what `open` opens: once for the mode of E, up to where the text states it, and once
    /// for its time.
    fn over<R: Read>(&self, mut open: impl FnMut() -> Result<R>) -> Result<Estimate> {
        self.limits.validate()?;
        let mut mode = ImpliedMode::default();
        stream(open()?, |_, command| mode.see(command))?;
        let relative = mode.is_relative();
        let settings = self.limits.machine_settings(self.options.firmware, relative);
        let mut machine = Machine::new(settings);
        let mut run = TimedFile::new(self.limits, self.options);
        stream(open()?, |line, command| {
            machine.apply(line, command, |event| run.take(line, event));
            ControlFlow::Continue(())
        })?;
        Ok(Estimate { relative_assumed: relative, ..run.finish(machine.features()) })
    }
}

enum Planner {
    Klipper(Box<Klipper>),
    Marlin(Box<Marlin>),
}

/// A file under way.
struct TimedFile {
    planner: Planner,
    tally: Tally,
    allowances: Allowances,
    /// Temperatures that nozzle and bed have been waited for, °C.
    nozzle_temperature: f64,
    bed_temperature: f64,
    homing_s: f64,
    heating_s: f64,
    tool_changes: u64,
    moves: u64,
    garbage_lines: u64,
}

impl TimedFile {
    fn new(limits: &Limits, options: &Options) -> Self {
        let marlin = |junction| Planner::Marlin(Box::new(Marlin::new(limits, junction)));
        let planner = match options.firmware {
            Firmware::Klipper => Planner::Klipper(Box::new(Klipper::new(limits))),
            Firmware::MarlinJerk => marlin(Junction::Jerk),
            Firmware::MarlinJunctionDeviation => marlin(Junction::Deviation),
        };
        Self {
            planner,
            tally: Tally::new(options.per_move),
            allowances: options.allowances,
            nozzle_temperature: 0.0,
            bed_temperature: 0.0,
            homing_s: 0.0,
            heating_s: 0.0,
            tool_changes: 0,
            moves: 0,
            garbage_lines: 0,
        }
    }

    #[inline]
    fn take(&mut self, line: u64, event: Event<'_>) {
        match event {
            Event::Step(step) => self.step(&step),
            Event::Dwell(seconds) => {
                self.stop();
                self.tally.dwell(line, seconds);
            }
            Event::Homing(_) | Event::Word(_) | Event::CoarseArc => {}
            Event::Home(_) => {
                self.stop();
                self.homing_s += self.allowances.homing_s;
            }
            Event::Layer => self.tally.begin_layer(),
            Event::LayerHeight(z) => self.tally.set_layer_height(z),
            Event::Garbage(_) => self.garbage_lines += 1,
            Event::Tool { changed: true, .. } => self.change_tool(),
            Event::Tool { .. } => {}
            Event::Other(command) => self.command(command),
        }
    }

    #[inline]
    fn step(&mut self, step: &Step) {
        let feed = if step.from == step.to {
            Feed::Standing(step.filament)
        } else if step.filament == 0.0 {
            Feed::None
        } else {
            Feed::Moving { filament: step.filament, z: step.to.z }
        };
        let tag = self.tally.tag(step.line, step.feature, feed);
        self.moves += 1;
        match &mut self.planner {
            Planner::Klipper(planner) => planner.push(step, tag, &mut self.tally),
            Planner::Marlin(planner) => planner.push(step, tag, &mut self.tally),
        }
    }

    fn stop(&mut self) {
        match &mut self.planner {
            Planner::Klipper(planner) => planner.stop(&mut self.tally),
            Planner::Marlin(planner) => planner.stop(&mut self.tally),
        }
    }

    /// What the printer does then is a macro of its own; it takes what is allowed for it.
    fn change_tool(&mut self) {
        self.stop();
        self.tool_changes += 1;
    }

    fn command(&mut self, command: Command<'_>) {
        match command {
            Command::M(600, _) => self.change_tool(),
            Command::M(400, _) => self.stop(),
            Command::M(109, words) => {
                let seconds = self.allowances.nozzle_heating_s;
                if rises(&mut self.nozzle_temperature, words) {
                    self.heat(seconds);
                }
            }
            Command::M(190, words) => {
                let seconds = self.allowances.bed_heating_s;
                if rises(&mut self.bed_temperature, words) {
                    self.heat(seconds);
                }
            }
            _ => {}
        }
        match &mut self.planner {
            Planner::Klipper(planner) => planner.command(&command, &mut self.tally),
            Planner::Marlin(planner) => planner.command(&command),
        }
    }

    /// Waits; a heater that is allowed no time is taken as hot already and stops nothing.
    fn heat(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.stop();
            self.heating_s += seconds;
        }
    }

    fn finish(mut self, labels: &[String]) -> Estimate {
        self.stop();
        let totals = self.tally.finish(labels);
        Estimate {
            moving_s: totals.moving_s,
            dwell_s: totals.dwell_s,
            travel_s: totals.travel_s,
            homing_s: self.homing_s,
            heating_s: self.heating_s,
            tool_change_s: self.tool_changes as f64 * self.allowances.tool_change_s,
            tool_changes: self.tool_changes,
            by_feature: totals.by_feature,
            by_layer: totals.by_layer,
            filament_mm: totals.filament_mm,
            moves: self.moves,
            garbage_lines: self.garbage_lines,
            relative_assumed: false,
            per_move: totals.moves,
        }
    }
}

/// Whether a wait is for a higher temperature than the last one; remembers it.
fn rises(last: &mut f64, words: Words<'_>) -> bool {
    let Some(target) = words.get(b'S').or(words.get(b'R')) else { return false };
    let rises = target > *last;
    *last = target;
    rises
}
