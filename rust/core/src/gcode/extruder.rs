//! The extruder's axis: what E words feed, be they lengths or volumes (M200), and of it M221's share.

use std::f64::consts::PI;

use super::command::Words;

/// Marlin's `DEFAULT_NOMINAL_FILAMENT_DIA`, mm: for an M200 that states none.
const FILAMENT_DIAMETER: f64 = 1.75;

/// The axis, and how its words are read.
#[derive(Debug, Clone)]
pub(super) struct Extruder {
    /// Its reading in the file's coordinates, before M200 and M221.
    pub(super) reading: f64,
    /// Whether E counts from the last move.
    pub(super) relative: bool,
    flow_factor: f64,
    /// Cross-section of the filament where E is a volume, mm².
    volumetric: Option<f64>,
    /// Diameter that M200 stated last, mm.
    filament_diameter: f64,
}

impl Extruder {
    pub(super) fn new(relative: bool) -> Self {
        let (reading, flow_factor, filament_diameter) = (0.0, 1.0, FILAMENT_DIAMETER);
        Self { reading, relative, flow_factor, volumetric: None, filament_diameter }
    }

    /// Whether words of E are lengths of filament, unscaled.
    pub(super) fn is_plain(&self) -> bool {
        self.volumetric.is_none() && self.flow_factor == 1.0
    }

    /// Moves the axis by, or to, a value and returns the filament that this feeds, mm.
    #[inline]
    pub(super) fn feed(&mut self, value: f64, relative: bool) -> f64 {
        let feed = if self.relative || relative { value } else { value - self.reading };
        self.reading += feed;
        match self.volumetric {
            None => feed * self.flow_factor,
            Some(section) => feed * self.flow_factor / section,
        }
    }

    /// M221: S sets.
    pub(super) fn scale(&mut self, words: Words<'_>) {
        self.flow_factor = words.share().unwrap_or(self.flow_factor);
    }

    /// M200: with a diameter E is a volume from here on, with D0 or S0 a length again.
    pub(super) fn set_volumetric(&mut self, words: Words<'_>) {
        let (diameter, switch) = (words.get(b'D'), words.get(b'S'));
        if let Some(diameter) = diameter.filter(|diameter| *diameter > 0.0) {
            self.filament_diameter = diameter;
        }
        let on = switch.or(diameter).is_some_and(|value| value > 0.0);
        let radius = self.filament_diameter / 2.0;
        self.volumetric = on.then_some(PI * radius * radius);
    }
}
