//! The state that G-code acts on: commands become straight physical steps.
//!
//! Firmwares differ in a few readings; [`Dialect`] chooses. What both agree on: `M220` also rescales
//! the feed that is already set, `M221` the filament, a rejected feed (not positive) leaves the old
//! one, G28 clears the G92 offset of the axes it homes. Klipper itself refuses G20, and arcs given
//! by R; both are read here, since other firmwares print them.

use glam::DVec3;

use super::arc;
use super::command::{Axes, Command, Plane};
use super::number::decimal;

/// Feed before the first F word, mm/s (both Klipper and Marlin).
const INITIAL_SPEED: f64 = 25.0;

const MM_PER_INCH: f64 = 25.4;

/// Different `;TYPE:` labels told apart; later ones count as the first, unnamed one.
const MAX_FEATURES: usize = 1 << 10;

/// Whose reading of ambiguous commands applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dialect {
    /// G4 reads P only; G91 makes E relative while it lasts, G90 leaves M83 standing.
    Klipper,
    /// G4 lets S win over P; G90 and G91 set E too, as M82 and M83 do. Also `RepRapFirmware`'s
    /// and Repetier's kin, as far as files have both.
    Marlin,
}

/// What the interpreter must know of the printer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachineSettings {
    /// Whose reading applies.
    pub dialect: Dialect,
    /// Length of the chords of an arc, mm.
    pub arc_resolution: f64,
    /// Where G28 leaves the head, mm.
    pub home: DVec3,
    /// Whether G28 homes all axes whatever it names, as a delta does.
    pub home_all: bool,
}

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
    /// Index into [`Machine::features`].
    pub feature: u16,
}

/// What a command asks for beside moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Event<'a> {
    /// A straight move; one that moves nothing is not reported.
    Step(Step),
    /// The head stands still, s.
    Dwell(f64),
    /// G28 has put the head at a new place.
    Home,
    /// A layer begins (`;LAYER_CHANGE` or `;LAYER:n`).
    Layer,
    /// A comment states the layer's height (`;Z:`), mm.
    LayerHeight(f64),
    /// A command that moves nothing, for those whom it concerns.
    Other(Command<'a>),
    /// A line that is not executed.
    Garbage,
}

/// Interprets commands one after another.
#[derive(Debug, Clone)]
pub struct Machine {
    settings: MachineSettings,
    /// Where the head is, mm.
    position: DVec3,
    /// What G92 added: machine coordinate minus the file's, mm.
    offset: DVec3,
    /// Reading of the extruder's axis in the file's coordinates, mm before M221.
    extruder: f64,
    relative: bool,
    relative_extrusion: bool,
    plane: Plane,
    mm_per_unit: f64,
    /// Feed as written, mm/s.
    feed: f64,
    feed_factor: f64,
    flow_factor: f64,
    features: Vec<String>,
    feature: u16,
}

impl Machine {
    /// A machine that has just been switched on, the head at the origin.
    #[must_use]
    pub fn new(settings: MachineSettings) -> Self {
        Self {
            settings,
            position: DVec3::ZERO,
            offset: DVec3::ZERO,
            extruder: 0.0,
            relative: false,
            relative_extrusion: false,
            plane: Plane::Xy,
            mm_per_unit: 1.0,
            feed: INITIAL_SPEED,
            feed_factor: 1.0,
            flow_factor: 1.0,
            features: vec![String::new()],
            feature: 0,
        }
    }

    /// The `;TYPE:` labels met so far, in small letters; the first, empty one is that of what came
    /// before any.
    #[must_use]
    pub fn features(&self) -> &[String] {
        &self.features
    }

    /// Where the head is, mm.
    #[must_use]
    pub fn position(&self) -> DVec3 {
        self.position
    }

    /// Applies one command and reports what comes of it.
    #[inline]
    pub fn apply<'a>(
        &mut self,
        line: u64,
        command: &Command<'a>,
        mut report: impl FnMut(Event<'a>),
    ) {
        match *command {
            Command::Linear { rapid, ref axes } => self.straight(line, rapid, axes, &mut report),
            Command::Arc { clockwise, ref axes, centre } => {
                self.set_feed(axes.f);
                let from = self.position;
                let to = self.target(axes);
                let filament = self.feed_filament(axes.e);
                let centre = arc::Centre::new(centre, self.mm_per_unit);
                let path = arc::Arc { from, to, centre, clockwise, plane: self.plane };
                let points = path.chords(self.settings.arc_resolution);
                let share = filament / f64::from(points.pieces());
                for to in points {
                    self.step(line, false, to, share, &mut report);
                }
            }
            Command::Comment(text) => self.comment(text, &mut report),
            _ => self.modal(*command, &mut report),
        }
    }

    #[inline]
    fn straight<'a>(
        &mut self,
        line: u64,
        rapid: bool,
        axes: &Axes,
        report: &mut impl FnMut(Event<'a>),
    ) {
        self.set_feed(axes.f);
        let to = self.target(axes);
        let filament = if axes.e.is_some() { self.feed_filament(axes.e) } else { 0.0 };
        self.step(line, rapid, to, filament, report);
    }

    #[inline]
    fn step<'a>(
        &mut self,
        line: u64,
        rapid: bool,
        to: DVec3,
        filament: f64,
        report: &mut impl FnMut(Event<'a>),
    ) {
        let from = self.position;
        if from == to && filament == 0.0 {
            return;
        }
        self.position = to;
        let speed = self.feed * self.feed_factor;
        let feature = self.feature;
        report(Event::Step(Step { line, from, to, filament, speed, rapid, feature }));
    }

    /// Everything that changes a mode or is somebody else's.
    fn modal<'a>(&mut self, command: Command<'a>, report: &mut impl FnMut(Event<'a>)) {
        match command {
            Command::Dwell { p_ms, s } => report(Event::Dwell(self.dwell(p_ms, s))),
            Command::ArcPlane(plane) => self.plane = plane,
            Command::Units { inches } => {
                self.mm_per_unit = if inches { MM_PER_INCH } else { 1.0 };
            }
            Command::Home { x, y, z } => {
                self.home([x, y, z]);
                report(Event::Home);
            }
            Command::Positioning { relative } => {
                self.relative = relative;
                if self.settings.dialect == Dialect::Marlin {
                    self.relative_extrusion = relative;
                }
            }
            Command::Extrusion { relative } => self.relative_extrusion = relative,
            Command::SetPosition(axes) => self.set_position(&axes),
            Command::M(220, words) => set_percent(&mut self.feed_factor, words.get(b'S')),
            Command::M(221, words) => set_percent(&mut self.flow_factor, words.get(b'S')),
            Command::Garbage(_) => report(Event::Garbage),
            other => report(Event::Other(other)),
        }
    }

    fn dwell(&self, p_ms: Option<f64>, s: Option<f64>) -> f64 {
        let from_p = p_ms.map(|ms| ms / 1000.0);
        let seconds = match self.settings.dialect {
            Dialect::Klipper => from_p,
            Dialect::Marlin => s.or(from_p),
        };
        seconds.unwrap_or(0.0).max(0.0)
    }

    /// Zero or less is refused, as firmwares do.
    #[inline]
    fn set_feed(&mut self, per_minute: Option<f64>) {
        let Some(per_minute) = per_minute else { return };
        let speed = per_minute * self.mm_per_unit / 60.0;
        if speed > f64::EPSILON {
            self.feed = speed;
        }
    }

    #[inline]
    fn target(&self, axes: &Axes) -> DVec3 {
        DVec3::new(
            self.coordinate(axes.x, self.position.x, self.offset.x),
            self.coordinate(axes.y, self.position.y, self.offset.y),
            self.coordinate(axes.z, self.position.z, self.offset.z),
        )
    }

    #[inline]
    fn coordinate(&self, word: Option<f64>, position: f64, offset: f64) -> f64 {
        match word {
            None => position,
            Some(value) if self.relative => position + value * self.mm_per_unit,
            Some(value) => value * self.mm_per_unit + offset,
        }
    }

    /// Moves the extruder's axis and returns the filament that this feeds, mm.
    #[inline]
    fn feed_filament(&mut self, word: Option<f64>) -> f64 {
        let Some(value) = word else { return 0.0 };
        let value = value * self.mm_per_unit;
        let klipper = self.settings.dialect == Dialect::Klipper;
        let feed = if self.relative_extrusion || (klipper && self.relative) {
            value
        } else {
            value - self.extruder
        };
        self.extruder += feed;
        feed * self.flow_factor
    }

    fn home(&mut self, named: [bool; 3]) {
        for (axis, named) in named.into_iter().enumerate() {
            if named || self.settings.home_all {
                self.position[axis] = self.settings.home[axis];
                self.offset[axis] = 0.0;
            }
        }
    }

    /// G92; without a word every axis reads zero.
    fn set_position(&mut self, axes: &Axes) {
        let words = [axes.x, axes.y, axes.z];
        let bare = axes.e.is_none() && words.iter().all(Option::is_none);
        for (axis, word) in words.into_iter().enumerate() {
            if let Some(value) = if bare { Some(0.0) } else { word } {
                self.offset[axis] = self.position[axis] - value * self.mm_per_unit;
            }
        }
        if let Some(value) = if bare { Some(0.0) } else { axes.e } {
            self.extruder = value * self.mm_per_unit;
        }
    }

    fn comment<'a>(&mut self, text: &[u8], report: &mut impl FnMut(Event<'a>)) {
        if let Some(label) = text.strip_prefix(b"TYPE:") {
            self.feature = self.feature_of(label);
        } else if text.starts_with(b"LAYER_CHANGE") || is_layer_number(text) {
            report(Event::Layer);
        } else if let Some(height) = text.strip_prefix(b"Z:")
            && let Some((height, _)) = decimal(height.trim_ascii())
        {
            report(Event::LayerHeight(height));
        }
    }

    fn feature_of(&mut self, label: &[u8]) -> u16 {
        let label = String::from_utf8_lossy(label.trim_ascii()).to_lowercase();
        let known = self.features.iter().position(|name| *name == label);
        let index = known.unwrap_or_else(|| {
            if self.features.len() == MAX_FEATURES {
                return 0;
            }
            self.features.push(label);
            self.features.len() - 1
        });
        u16::try_from(index).unwrap_or(0)
    }
}

fn is_layer_number(text: &[u8]) -> bool {
    text.strip_prefix(b"LAYER:")
        .is_some_and(|rest| rest.trim_ascii().iter().all(|b| b.is_ascii_digit() || *b == b'-'))
}

/// Only a positive percentage changes a factor.
fn set_percent(factor: &mut f64, percent: Option<f64>) {
    if let Some(percent) = percent.filter(|p| *p > 0.0 && p.is_finite()) {
        *factor = percent / 100.0;
    }
}
