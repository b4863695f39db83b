//! Stage 5, the toolpath: every move of the head, with speed, filament, pause and air.

mod bed;
mod build;
mod mechanics;
mod params;
mod pressure;
mod tuning;

use glam::DVec3;
use serde::{Deserialize, Serialize};

pub use build::toolpath;
pub use params::{BedShape, CoolingMethod, PathParams, PressureAdvance, Strategy};

use crate::strand::{Kind, Strand};

/// A toolpath as parallel arrays, one entry a move; each move begins where the last one ended.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Toolpath {
    /// Where the head stands before the first move, mm.
    pub start: DVec3,
    /// Rings of the brim.
    pub brim_rings: u32,
    /// End of each move, mm.
    pub to: Vec<DVec3>,
    /// What each move is for.
    pub kind: Vec<Kind>,
    /// Speed along the path (or of the filament for a retraction), mm/s.
    pub speed: Vec<f64>,
    /// Filament fed, mm; negative where it is pulled back, as for a retraction, or in place under
    /// a strand's kind to take pressure off the nozzle.
    pub filament: Vec<f64>,
    /// Dwell at the end of the move, s.
    pub pause: Vec<f64>,
    /// Whether the cooling air blows during the move.
    pub air: Vec<bool>,
    /// Index of the slab that the move belongs to.
    pub slab: Vec<u32>,
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
