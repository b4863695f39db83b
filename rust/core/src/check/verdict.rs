//! What a certificate says: every breach of the rules, with the line that commands it.

use glam::DVec3;

/// What the head ran into.
#[derive(Debug, Clone, Copy, PartialEq)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LooseEnd {
    /// Line of the strand that starts or ends here.
    pub line: u64,
    /// The point, mm.
    pub at: DVec3,
}

/// A stretch of a chain that hangs farther than its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
#[derive(Debug, Clone, Copy, PartialEq)]
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

/// The verdict on a file: every breach, in the order of its lines.
#[derive(Debug, Clone, Default)]
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
    /// Longest stretch held at both ends, mm.
    pub max_span: f64,
    /// Longest stretch held at one end, mm.
    pub max_free_end: f64,
    /// Number of moves, arcs counted by their chords.
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxed {
    /// Its ends, mm.
    pub ends: [DVec3; 2],
    /// The strand in which it ends.
    pub strand: u32,
}

impl Certificate {
    /// Whether no rule is broken.
    #[must_use]
    pub fn ok(&self) -> bool {
        self.breaches() == 0
    }

    /// Number of breaches.
    #[must_use]
    pub fn breaches(&self) -> usize {
        self.collisions.len()
            + self.floating_starts.len()
            + self.dangling_ends.len()
            + self.spans_over.len()
            + self.out_of_bounds.len()
    }
}
