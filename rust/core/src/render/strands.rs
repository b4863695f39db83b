//! What is laid, as a picture needs it: strands with their labels and diameters, and travels.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::scene::{DrawnStroke, Rgb, Scene, Width};
use crate::error::{CoreError, Result};
use crate::gcode::arc::Fineness;
use crate::gcode::command::Command;
use crate::gcode::dialect::Dialect;
use crate::gcode::event::{Event, Step};
use crate::gcode::extrusion;
use crate::gcode::homing::Homing;
use crate::gcode::machine::{Machine, MachineSettings};
use crate::gcode::number::decimal;
use crate::gcode::reader::Commands;
use crate::gcode::retraction::Retraction;
use crate::toolpath::Toolpath;

/// Filament of a file that does not state its own, mm.
const FILAMENT_DIAMETER: f64 = 1.75;
/// Strand diameters are drawn within these bounds, mm; a prime that stands almost still, or a
/// file with a stray unit, lies beyond.
const THINNEST: f64 = 0.1;
const THICKEST: f64 = 3.0;
/// Length of an arc's chords in a picture, mm.
const ARC_CHORD: f64 = 0.5;
/// By which chords may stray from an arc in a picture, mm: less than a pixel.
const ARC_SAGITTA: f64 = 0.01;
/// Width of a travel, pixels.
const TRAVEL_PX: f64 = 1.0;

/// Strands in printing order, as parallel arrays, and travels.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Strands {
    /// Start and end of each strand, mm.
    pub segments: Vec<[DVec3; 2]>,
    /// Diameter of a round strand of the same volume, mm.
    pub diameters: Vec<f64>,
    /// Index of each strand's label.
    pub features: Vec<u16>,
    /// Line of the G-code that lays each strand, from 1; empty where there is no text.
    pub lines: Vec<u64>,
    /// Labels in small letters (`contour`), as they are met; strands before any have an empty one.
    pub labels: Vec<String>,
    /// Start and end of each move without extrusion, mm.
    pub travels: Vec<[DVec3; 2]>,
    /// Number of strands laid before each travel.
    pub travel_after: Vec<u32>,
}

impl Strands {
    /// Replays a G-code file, any program's.
    ///
    /// # Errors
    /// [`CoreError::Gcode`] where it lays no strand.
    pub fn from_gcode(text: &[u8]) -> Result<Self> {
        // The dialects differ in dwells and in G90's effect on E, which files restate by M82/M83.
        let settings = MachineSettings {
            dialect: Dialect::Marlin,
            arcs: Fineness { resolution: ARC_CHORD, sagitta: Some(ARC_SAGITTA) },
            homing: Homing::AT_ORIGIN,
            retraction: Retraction::MARLIN,
            relative_extrusion: extrusion::is_relative(text),
        };
        let mut machine = Machine::new(settings);
        let mut strands = Self::default();
        let mut filament_diameter = FILAMENT_DIAMETER;
        for (line, command) in Commands::new(text) {
            if let Command::Comment(comment) = command {
                filament_diameter = stated_diameter(comment).unwrap_or(filament_diameter);
            }
            machine.apply(line, &command, |event| {
                if let Event::Step(step) = event {
                    strands.add_step(&step);
                    strands.lines.resize(strands.segments.len(), line);
                }
            });
        }
        if strands.segments.is_empty() {
            return Err(CoreError::Gcode("the file lays no strand".into()));
        }
        strands.labels = machine.features().to_vec();
        strands.finish_diameters(filament_diameter);
        Ok(strands)
    }

    /// The strands and travels of a toolpath; a label for each kind, `filament_diameter` in mm.
    #[must_use]
    pub fn from_toolpath(toolpath: &Toolpath, labels: Vec<String>, filament_diameter: f64) -> Self {
        let moves = toolpath.to.len();
        let mut strands = Self {
            segments: Vec::with_capacity(moves),
            diameters: Vec::with_capacity(moves),
            features: Vec::with_capacity(moves),
            labels,
            ..Self::default()
        };
        let mut from = toolpath.start;
        for ((&to, &kind), &filament) in
            toolpath.to.iter().zip(&toolpath.kind).zip(&toolpath.filament)
        {
            strands.add(from, to, filament, kind as u16);
            from = to;
        }
        strands.finish_diameters(filament_diameter);
        strands
    }

    /// Strand length per label, mm.
    #[must_use]
    pub fn lengths(&self) -> Vec<f64> {
        let mut lengths = vec![0.0; self.labels.len()];
        for ([from, to], &feature) in self.segments.iter().zip(&self.features) {
            if let Some(length) = lengths.get_mut(usize::from(feature)) {
                *length += from.distance(*to);
            }
        }
        lengths
    }

    /// Lowest and highest corner of the strands with these labels, mm; `None` without any.
    #[must_use]
    pub fn bounds(&self, labels: &[String]) -> Option<(DVec3, DVec3)> {
        let counts: Vec<bool> = self.labels.iter().map(|label| labels.contains(label)).collect();
        let strands = self.segments.iter().zip(&self.features);
        strands
            .filter(|(_, feature)| counts.get(usize::from(**feature)) == Some(&true))
            .map(|([a, b], _)| (a.min(*b), a.max(*b)))
            .reduce(|(low, high), (a, b)| (low.min(a), high.max(b)))
    }

    /// Adds to a scene the strands whose label has a colour, and the travels if they have one.
    pub fn add_to(&self, scene: &mut Scene, palette: &[Option<Rgb>], travel: Option<Rgb>) {
        let strands = self.segments.iter().zip(&self.diameters).zip(&self.features);
        scene.strokes.reserve(self.segments.len());
        for ((&[from, to], diameter), &feature) in strands {
            if let Some(colour) = palette.get(usize::from(feature)).copied().flatten() {
                let width = Width::Tube(diameter / 2.0);
                scene.strokes.push(DrawnStroke { from, to, width, colour });
            }
        }
        if let Some(colour) = travel {
            let width = Width::Line(TRAVEL_PX);
            let lines =
                self.travels.iter().map(|&[from, to]| DrawnStroke { from, to, width, colour });
            scene.strokes.extend(lines);
        }
    }

    fn add_step(&mut self, step: &Step) {
        self.add(step.from, step.to, step.filament, step.feature);
    }

    /// Adds a move; the diameter is that of the filament spread along the strand, in units of the
    /// filament's own, until [`Self::finish_diameters`] knows it.
    fn add(&mut self, from: DVec3, to: DVec3, filament: f64, feature: u16) {
        let length = from.distance(to);
        if length == 0.0 {
            return;
        }
        if filament > 0.0 {
            self.segments.push([from, to]);
            self.diameters.push((filament / length).sqrt());
            self.features.push(feature);
        } else {
            self.travels.push([from, to]);
            self.travel_after.push(self.segments.len() as u32);
        }
    }

    fn finish_diameters(&mut self, filament_diameter: f64) {
        for diameter in &mut self.diameters {
            *diameter = (*diameter * filament_diameter).clamp(THINNEST, THICKEST);
        }
    }
}

/// The filament's diameter in a comment such as `filament_diameter = 1.75`, mm.
fn stated_diameter(comment: &[u8]) -> Option<f64> {
    let rest = comment.strip_prefix(b"filament_diameter")?.trim_ascii_start();
    let (value, _) = decimal(rest.strip_prefix(b"=")?.trim_ascii_start())?;
    (0.5..=5.0).contains(&value).then_some(value)
}
