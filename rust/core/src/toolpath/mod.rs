//! Stage 5, the toolpath: every move of the head, with speed, filament, pause and air.

mod bed;
mod build;
mod mechanics;

use std::f64::consts::FRAC_PI_4;

use glam::{DVec2, DVec3};

pub use build::toolpath;
pub use mechanics::{Cooling, Strategy};

use crate::strand::{Kind, Strand};

/// A toolpath as parallel arrays, one entry a move; each move begins where the last one ended.
#[derive(Debug, Clone, Default)]
pub struct Toolpath {
    /// Where the head stands before the first move, mm.
    pub start: DVec3,
    /// End of each move, mm.
    pub to: Vec<DVec3>,
    /// What each move is for.
    pub kind: Vec<Kind>,
    /// Speed along the path (or of the filament for a retraction), mm/s.
    pub speed: Vec<f64>,
    /// Filament fed, mm; negative for a retraction.
    pub filament: Vec<f64>,
    /// Dwell at the end of the move, s.
    pub pause: Vec<f64>,
    /// Whether the cooling air blows during the move.
    pub air: Vec<bool>,
    /// Index of the slab that the move belongs to.
    pub slab: Vec<u32>,
}

/// The bed, about its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Plate {
    /// A disc of this radius, mm.
    Round(f64),
    /// A rectangle that reaches this far along x and y, mm.
    Rectangle(DVec2),
}

impl Plate {
    /// Whether a point, relative to the bed's centre, lies on it.
    #[must_use]
    pub fn holds(&self, p: DVec2) -> bool {
        match *self {
            Self::Round(radius) => p.length() <= radius,
            Self::Rectangle(half) => p.abs().cmple(half).all(),
        }
    }
}

/// What the toolpath depends on; lengths in mm, speeds in mm/s, times in s.
#[derive(Debug, Clone, Copy)]
pub struct PathParams {
    /// The bed's centre, where the model's stands.
    pub centre: DVec2,
    /// The bed; rings that leave it are not printed.
    pub plate: Plate,
    /// Diameter of a free strand.
    pub strand: f64,
    /// Diameter of the filament.
    pub filament: f64,
    /// Height of the first contours.
    pub first_layer: f64,
    /// Speed of extruding.
    pub print_speed: f64,
    /// Speed of extruding onto the bed.
    pub bed_speed: f64,
    /// Speed of extruding layers.
    pub layer_speed: f64,
    /// Speed of floating strokes under [`Strategy::Slow`].
    pub slow_speed: f64,
    /// Speed of travelling.
    pub travel_speed: f64,
    /// What makes floating strokes hold.
    pub strategy: Strategy,
    /// How strands are cooled.
    pub cooling: Cooling,
    /// Pause at the end of a floating stroke under [`Strategy::Pause`].
    pub pause: f64,
    /// Way past the end of a floating stroke under [`Strategy::Overshoot`].
    pub overshoot: f64,
    /// Filament pulled back before a travel.
    pub retract: f64,
    /// Straight travels between a layer's lines that are no longer need no retraction.
    pub layer_retract_over: f64,
    /// Speed of pulling back.
    pub retract_speed: f64,
    /// Speed of pushing forward again.
    pub unretract_speed: f64,
    /// Filament fed before the first strand, to fill the nozzle.
    pub prime: f64,
    /// Height of a travel above all that is printed.
    pub travel_lift: f64,
    /// Rings around the print that prime the nozzle.
    pub skirt_rings: u32,
    /// Distance of the skirt from the print.
    pub skirt_gap: f64,
    /// Flat rings around each first contour.
    pub brim_rings: u32,
}

impl PathParams {
    /// Filament for each mm of strand, mm: volume π/4·strand² over the filament's cross-section.
    #[must_use]
    pub fn feed_per_mm(&self) -> f64 {
        (self.strand / self.filament).powi(2)
    }

    /// Cross-section of the filament, mm².
    #[must_use]
    pub fn filament_area(&self) -> f64 {
        FRAC_PI_4 * self.filament * self.filament
    }
}

/// Sums over a toolpath.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Figures {
    /// Length of all strands, mm.
    pub strand: f64,
    /// Length of all travels, mm.
    pub travel: f64,
    /// Number of dwells.
    pub pauses: u64,
    /// Sum of the dwells, s.
    pub pause: f64,
    /// Filament used, mm.
    pub filament: f64,
}

impl Toolpath {
    /// Where the head stands after the last move so far, mm.
    #[must_use]
    pub fn at(&self) -> DVec3 {
        self.to.last().copied().unwrap_or(self.start)
    }

    fn push(
        &mut self,
        strand: &Strand,
        to: DVec3,
        speed: f64,
        filament: f64,
        pause: f64,
        air: bool,
    ) {
        self.to.push(to);
        self.kind.push(strand.kind);
        self.speed.push(speed);
        self.filament.push(filament);
        self.pause.push(pause);
        self.air.push(air);
        self.slab.push(strand.slab);
    }

    fn travel(&mut self, to: DVec3, speed: f64, slab: u32) {
        if to != self.at() || self.to.is_empty() {
            self.add(to, Kind::Travel, speed, 0.0, slab);
        }
    }

    fn add(&mut self, to: DVec3, kind: Kind, speed: f64, filament: f64, slab: u32) {
        let air = self.air.last().copied().unwrap_or(false);
        self.to.push(to);
        self.kind.push(kind);
        self.speed.push(speed);
        self.filament.push(filament);
        self.pause.push(0.0);
        self.air.push(air);
        self.slab.push(slab);
    }

    /// Sums the toolpath up.
    #[must_use]
    pub fn figures(&self) -> Figures {
        let mut figures = Figures::default();
        let mut from = self.start;
        for (i, &to) in self.to.iter().enumerate() {
            let length = from.distance(to);
            match self.kind[i] {
                Kind::Travel => figures.travel += length,
                Kind::Retract | Kind::Unretract => {}
                _ => figures.strand += length,
            }
            figures.filament += self.filament[i];
            if self.pause[i] > 0.0 {
                figures.pauses += 1;
                figures.pause += self.pause[i];
            }
            from = to;
        }
        figures
    }
}
