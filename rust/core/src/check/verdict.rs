//! What a certificate says: every breach of the rules, with the line that commands it.

use std::borrow::Cow;
use std::collections::BTreeMap;

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What the head ran into.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Obstacle {
    /// The bed.
    Bed,
    /// The strand that this line printed.
    Strand {
        /// Line of the G-code.
        line: u64,
    },
}

/// A move that drives the head into material or bed: its deepest place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Collision {
    /// Line that commands the move.
    pub line: u64,
    /// Where the tip is, mm.
    pub tip: DVec3,
    /// Where the material is, mm.
    pub material: DVec3,
    /// How deep the material is in the head, mm.
    pub depth: f64,
    /// What is hit.
    pub obstacle: Obstacle,
}

/// A chain that starts or ends at a point without contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LooseEnd {
    /// Line of the strand that starts or ends here.
    pub line: u64,
    /// The point, mm.
    pub at: DVec3,
}

/// A stretch of a chain that hangs farther than its limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Span {
    /// Line of the strand at whose end the stretch ends.
    pub line: u64,
    /// Last contact before the stretch, mm.
    pub from: DVec3,
    /// Where the stretch ends, mm.
    pub to: DVec3,
    /// Length along the strands, mm.
    pub length: f64,
    /// Whether it is held at one end only.
    pub free_end: bool,
}

/// What is out of bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Bound {
    /// The tip leaves the build volume; in mm outside it.
    Volume,
    /// The feed; mm/s.
    Feed,
    /// Molten filament; mm³/s.
    Flow,
    /// Filament moved while the tip stands still; mm.
    FilamentOnly,
}

/// A move that asks more than the machine has.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct OutOfBounds {
    /// Line that commands the move.
    pub line: u64,
    /// Where the move ends, mm.
    pub at: DVec3,
    /// Which bound.
    pub bound: Bound,
    /// The value found, in the bound's unit.
    pub value: f64,
    /// The limit, in the bound's unit.
    pub limit: f64,
}

/// A run of strands that gets too little filament.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Underfed {
    /// Line of its first strand.
    pub line: u64,
    /// Where it starts, mm.
    pub at: DVec3,
    /// Length of the run, mm.
    pub length: f64,
    /// What it gets, as a share of what a free strand takes.
    pub share: f64,
    /// What it needs at least.
    pub least: f64,
}

/// The end of a stroke in the air that the head leaves before it holds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Hurried {
    /// Line of the stroke.
    pub line: u64,
    /// Where it ends, mm.
    pub at: DVec3,
    /// How long the head dwells there, s.
    pub dwell: f64,
}

/// Filament fed through a nozzle that is too cold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Cold {
    /// Line of the first strand of a run.
    pub line: u64,
    /// Where it starts, mm.
    pub at: DVec3,
    /// What the nozzle was told last, °C: too cold, or hot enough but not waited for.
    pub target: f64,
}

/// A move along an axis that was not homed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Unhomed {
    /// Line of the first move of a run.
    pub line: u64,
    /// Where it ends, mm, by the file's reckoning.
    pub at: DVec3,
    /// Which of X, Y and Z.
    pub axes: [bool; 3],
}

/// A command from which on the file cannot be judged.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unjudged {
    /// Its line.
    pub line: u64,
    /// The command.
    pub command: String,
    /// Why.
    pub why: Cow<'static, str>,
}

/// The verdict on a file: every breach, in the order of its lines.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Certificate {
    /// Breaches of rule 1, one for each move that collides.
    pub collisions: Vec<Collision>,
    /// Breaches of rule 2: chains that start in the air.
    pub floating_starts: Vec<LooseEnd>,
    /// Breaches of rule 2: chains that end in the air where nothing meets them later.
    pub dangling_ends: Vec<LooseEnd>,
    /// Breaches of rule 3.
    pub spans_over: Vec<Span>,
    /// Breaches of rule 4.
    pub out_of_bounds: Vec<OutOfBounds>,
    /// Breaches of rule 5: runs of strands with too little filament.
    pub underfed: Vec<Underfed>,
    /// Breaches of rule 5: strokes whose free ends are left before they hold.
    pub hurried: Vec<Hurried>,
    /// Breaches of rule 6: extrusions through a cold nozzle.
    pub cold: Vec<Cold>,
    /// Breaches of rule 6: moves along axes that are not home.
    pub unhomed: Vec<Unhomed>,
    /// Commands of a text that were not carried out as its firmware would, in order: from the first
    /// on nothing is certain, and what follows was judged as if they did nothing.
    pub unjudged: Vec<Unjudged>,
    /// Commands of a text that move nothing, and how often each stands there, by name.
    pub harmless: BTreeMap<String, usize>,
    /// Commands before the print that prepare it and were not carried out, likewise.
    pub preparing: BTreeMap<String, usize>,
    /// Whether E was taken as relative though the text does not say so, since it runs backwards.
    pub relative_assumed: bool,
    /// Longest stretch held at both ends, mm.
    pub max_span: f64,
    /// Longest stretch held at one end, mm.
    pub max_free_end: f64,
    /// Number of moves, arcs counted by their chords, ways home left out.
    pub moves: usize,
    /// Number of lines of a text that no firmware executes.
    pub garbage_lines: usize,
    /// Strands as commanded, mm.
    pub strands: Vec<[DVec3; 2]>,
    /// Line of each strand.
    pub strand_lines: Vec<u64>,
    /// Feature of each strand, an index into `features`.
    pub strand_features: Vec<u16>,
    /// The `;TYPE:` labels of a text, in small letters; the first is empty.
    pub features: Vec<String>,
    /// What the strands relax to: chords where they hang, else as commanded; mm.
    pub relaxed: Vec<Relaxed>,
}

/// A straight piece of what a chain relaxes to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Relaxed {
    /// Its ends, mm.
    pub ends: [DVec3; 2],
    /// The strand in which it ends.
    pub strand: u32,
}

impl Certificate {
    /// Whether all of it was judged, and no rule is broken.
    #[must_use]
    pub fn ok(&self) -> bool {
        self.unjudged.is_empty() && self.breaches() == 0
    }

    /// The same verdict without breaches up to a line: of what is taken as it stands.
    #[must_use]
    pub fn after(&self, line: u64) -> Self {
        let mut left = self.clone();
        left.collisions.retain(|one| one.line > line);
        left.floating_starts.retain(|one| one.line > line);
        left.dangling_ends.retain(|one| one.line > line);
        left.spans_over.retain(|one| one.line > line);
        left.out_of_bounds.retain(|one| one.line > line);
        left.underfed.retain(|one| one.line > line);
        left.hurried.retain(|one| one.line > line);
        left.cold.retain(|one| one.line > line);
        left.unhomed.retain(|one| one.line > line);
        left.unjudged.retain(|one| one.line > line);
        left
    }

    /// Number of breaches.
    #[must_use]
    pub fn breaches(&self) -> usize {
        self.collisions.len()
            + self.floating_starts.len()
            + self.dangling_ends.len()
            + self.spans_over.len()
            + self.out_of_bounds.len()
            + self.underfed.len()
            + self.hurried.len()
            + self.cold.len()
            + self.unhomed.len()
    }
}
