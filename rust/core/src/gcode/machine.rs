//! The state that G-code acts on: commands become straight physical steps.
//!
//! Firmwares differ in a few readings; [`Dialect`] chooses. What both agree on: `M220` also rescales
//! the feed that is already set, `M221` the filament, a rejected feed (not positive) leaves the old
//! one, G28 clears the G92 offset of the axes it homes. Klipper itself refuses G20, G53, M200 and
//! arcs given by R; all are read here, since other firmwares print them. What may not be known is
//! reported beside ([`Event::Word`], [`Event::Other`]), for those who must be sure.

use glam::DVec3;

use super::arc::{self, Fineness};
use super::command::{ArcPlane, Axes, CentreWords, Command, Words};
use super::coordinates::Coordinates;
use super::dialect::Dialect;
use super::event::{Event, Step};
use super::extruder::Extruder;
use super::features::{Features, Remark};
use super::feedrate::Feedrate;
use super::homing::Homing;
use super::line::parse_line;
use super::retraction::Retraction;

/// Chords that the arcs of a text may come to where only their shape matters: so many, and so many
/// more for each line, so that memory grows with the text and not with the radii in it.
const CHORDS: u64 = 1 << 18;
const CHORDS_PER_LINE: u64 = 32;

/// What the interpreter must know of the printer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachineSettings {
    /// Whose reading applies.
    pub dialect: Dialect,
    /// How finely arcs are cut.
    pub arcs: Fineness,
    /// What G28 does.
    pub homing: Homing,
    /// What G10 and G11 do until the file says otherwise.
    pub retraction: Retraction,
    /// Whether E counts from the last move until the file says otherwise.
    pub relative_extrusion: bool,
}

/// Interprets commands one after another.
#[derive(Debug, Clone)]
pub struct Machine {
    settings: MachineSettings,
    coordinates: Coordinates,
    /// Filament that G10 holds back, mm.
    retracted: Option<f64>,
    retraction: Retraction,
    extruder: Extruder,
    plane: ArcPlane,
    feed: Feedrate,
    tool: u32,
    chords: u64,
    features: Features,
}

impl Machine {
    /// A machine that has just been switched on, the head at the origin.
    #[must_use]
    pub fn new(settings: MachineSettings) -> Self {
        Self {
            settings,
            coordinates: Coordinates::new(),
            retracted: None,
            retraction: settings.retraction,
            extruder: Extruder::new(settings.relative_extrusion),
            plane: ArcPlane::Xy,
            feed: Feedrate::new(),
            tool: 0,
            chords: 0,
            features: Features::new(),
        }
    }

    /// The `;TYPE:` labels met so far, in small letters; the first, empty one is that of what came
    /// before any.
    #[must_use]
    pub fn features(&self) -> &[String] {
        &self.features.names
    }

    /// Where the head is, mm.
    #[must_use]
    pub fn position(&self) -> DVec3 {
        self.coordinates.at
    }

    /// Reading of the extruder's axis, in the unit that the text feeds in, and whether E counts from
    /// the last move (M83).
    #[must_use]
    pub fn extruder(&self) -> (f64, bool) {
        (self.extruder.reading, self.extruder.relative)
    }

    /// Feed as it is written, mm/s.
    #[must_use]
    pub fn feed(&self) -> f64 {
        self.feed.written
    }

    /// Whether a move means what it says: coordinates count from the machine's origin (G90, no G92 of
    /// axes), in mm, and neither feed nor filament is scaled.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.coordinates.is_plain() && self.feed.factor == 1.0 && self.extruder.is_plain()
    }

    /// Whether coordinates count from the last move (G91).
    #[must_use]
    pub fn is_relative(&self) -> bool {
        self.coordinates.relative
    }

    /// Which of X, Y and Z were homed, and have kept their motors on since.
    #[must_use]
    pub fn homed(&self) -> [bool; 3] {
        self.coordinates.homed
    }

    /// Something that is not known here has homed all axes.
    pub fn assume_homed(&mut self) {
        self.coordinates.homed = [true; 3];
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
            Command::Linear { rapid, ref axes, other } => {
                self.straight(line, rapid, axes, &mut report);
                if let Some(word) = other {
                    report(Event::Word(word));
                }
            }
            _ => self.rare(line, command, &mut report),
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
        if !self.feed.set(axes.f, self.coordinates.mm_per_unit) {
            report(Event::Word(b'F'));
        }
        let to = self.coordinates.target(axes);
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
        let from = self.coordinates.at;
        if from == to && filament == 0.0 {
            return;
        }
        self.coordinates.at = to;
        let speed = self.feed.speed();
        let feature = self.features.current;
        report(Event::Step(Step {
            line,
            from,
            to,
            filament,
            speed,
            rapid,
            homing: false,
            feature,
        }));
    }

    fn arc<'a>(
        &mut self,
        line: u64,
        clockwise: bool,
        axes: &Axes,
        centre: CentreWords,
        report: &mut impl FnMut(Event<'a>),
    ) {
        if !self.feed.set(axes.f, self.coordinates.mm_per_unit) {
            report(Event::Word(b'F'));
        }
        let from = self.coordinates.at;
        let to = self.coordinates.target(axes);
        let filament = self.feed_filament(axes.e);
        let centre = arc::Centre::new(centre, self.coordinates.mm_per_unit);
        let path = arc::Arc { from, to, centre, clockwise, plane: self.plane };
        let points = path.chords(self.settings.arcs);
        let pieces = points.pieces();
        self.chords = self.chords.saturating_add(u64::from(pieces));
        let most = CHORDS.saturating_add(CHORDS_PER_LINE.saturating_mul(line));
        if self.settings.arcs.sagitta.is_some() && self.chords > most {
            self.step(line, false, to, filament, report);
            report(Event::CoarseArc);
            return;
        }
        let share = filament / f64::from(pieces);
        for to in points {
            self.step(line, false, to, share, report);
        }
    }

    /// Whatever is no straight move.
    fn rare<'a>(&mut self, line: u64, command: &Command<'a>, report: &mut impl FnMut(Event<'a>)) {
        match *command {
            Command::Arc { clockwise, ref axes, centre, other } => {
                self.arc(line, clockwise, axes, centre, report);
                if let Some(word) = other {
                    report(Event::Word(word));
                }
            }
            Command::Comment(text) => match self.features.comment(text) {
                Remark::None => {}
                Remark::Layer => report(Event::Layer),
                Remark::Height(height) => report(Event::LayerHeight(height)),
            },
            Command::Dwell { p_ms, s, .. } => report(Event::Dwell(self.dwell(p_ms, s))),
            Command::Home { x, y, z, if_needed, .. } => {
                let mut named = [x, y, z];
                // Klipper knows no O, and homes.
                if if_needed && self.settings.dialect == Dialect::Marlin {
                    named
                        .iter_mut()
                        .zip(self.coordinates.homed)
                        .for_each(|(axis, home)| *axis &= !home);
                }
                if named != [false; 3] {
                    self.home(line, named, report);
                }
            }
            Command::G(53, words) => self.native(line, command, words, report),
            Command::G(10, words) if words.letters().all(|word| word == b'S') => {
                self.retract(line, words, report);
            }
            Command::G(11, words) if words.letters().all(|word| word == b'S') => {
                self.unretract(line, report);
            }
            Command::Tool(number, _) => {
                let changed = std::mem::replace(&mut self.tool, number) != number;
                report(Event::Tool { number, changed });
            }
            Command::Garbage(text) => report(Event::Garbage(text)),
            _ => self.modal(command, report),
        }
    }

    /// Everything that changes a mode or is somebody else's.
    fn modal<'a>(&mut self, command: &Command<'a>, report: &mut impl FnMut(Event<'a>)) {
        match *command {
            Command::ArcPlane(plane, _) => self.plane = plane,
            Command::Units { inches, .. } => {
                self.coordinates.count_in(inches);
                report(Event::Other(*command));
            }
            Command::Positioning { relative, .. } => {
                self.coordinates.relative = relative;
                // Of E that must be relative G90 says nothing: a macro did, before or behind it.
                if self.settings.dialect == Dialect::Marlin {
                    self.extruder.relative = relative || self.settings.relative_extrusion;
                }
            }
            Command::Extrusion { relative, .. } => self.extruder.relative = relative,
            Command::SetPosition { axes, other } => {
                self.set_position(&axes, other.is_some());
                if let Some(word) = other {
                    report(Event::Word(word));
                }
            }
            Command::M(200, words) => {
                self.extruder.set_volumetric(words);
                report(Event::Other(*command));
            }
            Command::M(18 | 84, words) => {
                self.release(words);
                report(Event::Other(*command));
            }
            // Without power no motor keeps its place.
            Command::M(81, _) => {
                self.coordinates.homed = [false; 3];
                report(Event::Other(*command));
            }
            // Refused, or a standstill: firmwares differ in what nothing or less per cent is.
            Command::M(220 | 221, words)
                if words.get(b'S').is_some_and(|percent| percent <= 0.0) =>
            {
                report(Event::Other(*command));
            }
            Command::M(220, words) => self.feed.scale(words, self.settings.dialect),
            Command::M(221, words) => self.extruder.scale(words),
            ref other => {
                self.retraction.command(other);
                report(Event::Other(*other));
            }
        }
    }

    /// G53: the move that follows it in the line, in the machine's own coordinates. Who must be sure
    /// learns of it where firmwares differ: Klipper has none, and what G92 did to these coordinates
    /// is not the same for all.
    fn native<'a>(
        &mut self,
        line: u64,
        command: &Command<'a>,
        words: Words<'a>,
        report: &mut impl FnMut(Event<'a>),
    ) {
        if self.settings.dialect == Dialect::Klipper || self.coordinates.is_shifted() {
            report(Event::Other(*command));
        }
        let origin = self.coordinates.count_natively();
        match parse_line(words.0) {
            Some(Command::Linear { rapid, axes, other: None }) => {
                self.straight(line, rapid, &axes, report);
            }
            Some(Command::Arc { clockwise, axes, centre, other: None }) => {
                self.arc(line, clockwise, &axes, centre, report);
            }
            _ => report(Event::Other(*command)),
        }
        self.coordinates.count_from(origin);
    }

    fn retract<'a>(&mut self, line: u64, words: Words<'_>, report: &mut impl FnMut(Event<'a>)) {
        if self.retracted.is_some() {
            return;
        }
        let Retraction { length, swap_length, speed, hop, .. } = self.retraction;
        let swaps = words.get(b'S').is_some_and(|swaps| swaps > 0.0);
        let length = if swaps { swap_length } else { length };
        self.retracted = Some(length);
        self.filament_only(line, -length, speed, report);
        self.lift(line, hop, report);
    }

    fn unretract<'a>(&mut self, line: u64, report: &mut impl FnMut(Event<'a>)) {
        if let Some(length) = self.retracted.take() {
            let Retraction { extra, recover_speed, .. } = self.retraction;
            self.lift(line, -self.coordinates.hop(), report);
            self.filament_only(line, length + extra, recover_speed, report);
        }
    }

    /// Feeds filament at a speed of its own while the head stands.
    fn filament_only<'a>(
        &mut self,
        line: u64,
        filament: f64,
        speed: f64,
        report: &mut impl FnMut(Event<'a>),
    ) {
        let (at, feature) = (self.coordinates.at, self.features.current);
        if filament != 0.0 {
            let (from, to, rapid, homing) = (at, at, false, false);
            report(Event::Step(Step { line, from, to, filament, speed, rapid, homing, feature }));
        }
    }

    /// Lifts the head, and with it all that follows.
    fn lift<'a>(&mut self, line: u64, by: f64, report: &mut impl FnMut(Event<'a>)) {
        let to = self.coordinates.raise(by);
        self.step(line, false, to, 0.0, report);
    }

    fn dwell(&self, p_ms: Option<f64>, s: Option<f64>) -> f64 {
        let from_p = p_ms.map(|ms| ms / 1000.0);
        let seconds = match self.settings.dialect {
            Dialect::Klipper => from_p,
            Dialect::Marlin => s.or(from_p),
        };
        seconds.unwrap_or(0.0).max(0.0)
    }

    /// Moves the extruder's axis and returns the filament that this feeds, mm.
    #[inline]
    fn feed_filament(&mut self, word: Option<f64>) -> f64 {
        let Some(value) = word else { return 0.0 };
        let value = value * self.coordinates.mm_per_unit;
        self.extruder
            .feed(value, self.coordinates.relative && self.settings.dialect == Dialect::Klipper)
    }

    fn home<'a>(&mut self, line: u64, named: [bool; 3], report: &mut impl FnMut(Event<'a>)) {
        let homing = self.settings.homing;
        let (speed, feature) = (self.feed.written, self.features.current);
        for to in homing.strokes(self.coordinates.at, named).iter() {
            let from = std::mem::replace(&mut self.coordinates.at, to);
            if from != to {
                let (filament, rapid, homing) = (0.0, true, true);
                report(Event::Homing(Step {
                    line,
                    from,
                    to,
                    filament,
                    speed,
                    rapid,
                    homing,
                    feature,
                }));
            }
        }
        let home = homing.homes(named);
        self.coordinates.reach_home(home);
        report(Event::Home(home));
    }

    /// M18 and M84: motors that are off lose their place. With S alone a time is set; Klipper reads no
    /// words.
    fn release(&mut self, words: Words<'_>) {
        let all = words.letters().next().is_none() || self.settings.dialect == Dialect::Klipper;
        self.coordinates.release(words, all);
    }

    /// G92; without a word every axis reads zero.
    fn set_position(&mut self, axes: &Axes, others: bool) {
        let words = [axes.x, axes.y, axes.z];
        let bare = !others && axes.e.is_none() && words.iter().all(Option::is_none);
        self.coordinates.set(if bare { [Some(0.0); 3] } else { words });
        if let Some(value) = if bare { Some(0.0) } else { axes.e } {
            self.extruder.reading = value * self.coordinates.mm_per_unit;
        }
    }
}
