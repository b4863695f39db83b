//! The certificate: what a file would do on the machine, judged by the rules of a printable file.
//!
//! Of the generator this module shares nothing but [`Head`]. It takes the moves that the G-code
//! reader gets from a text (arcs as chords; the way home of a G28 is the firmware's own and not
//! judged) and reports every breach with the line that commands it:
//!
//! 1. **No collision** ([`collide`]): each move of the whole head, extruding or not, against every
//!    strand laid before it, against the strand that it lays itself, and against the bed. Material
//!    may reach half a strand's diameter into the head, the squash of a joint.
//! 2. **Anchored** ([`stretch`]): a **chain** is a run of extruding moves without a travel between
//!    them (retractions and dwells in place do not break it). It must start in contact, and end in
//!    contact or where a later strand comes into contact.
//! 3. **Bounded spans** ([`stretch`]): the stretches of a chain between contacts are limited.
//! 4. **In bounds** ([`bounds`]): the build volume, feeds, flow and filament-only moves.
//!
//! A **strand** is a move that feeds filament forward over a distance. A point of it is in
//! **contact** where the tip stood no higher than [`Rules::bed_contact`] over the bed, or where
//! material laid earlier passes within one strand diameter, centreline to centreline ([`contact`]).
//! Of its own chain only material at least three diameters back along the strand counts: what is
//! nearer touches by mere continuity, and holds nothing.

mod bounds;
mod chain;
mod collide;
mod contact;
mod deposit;
mod file;
mod grid;
mod stretch;

use glam::DVec3;

use crate::gcode::machine::Step;
use crate::head::Head;

pub use bounds::{Bed, Limits};
pub use file::certify_text;

/// What the file is judged by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// The head that moves.
    pub head: Head,
    /// Diameter of a free strand, mm.
    pub strand: f64,
    /// A strand printed with the tip at or below this height lies on the bed, mm.
    pub bed_contact: f64,
    /// Longest stretch held at both ends, mm.
    pub span_limit: f64,
    /// Longest stretch held at one end, mm.
    pub free_end_limit: f64,
    /// The bed and the height above it.
    pub bed: Bed,
    /// What machine and firmware allow.
    pub limits: Limits,
}

impl Rules {
    /// How far material may reach into the head, mm: the squash of a joint.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.strand / 2.0
    }
}

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

/// Judges moves by the rules; after those with an index in `dwells`, ascending, the head dwells.
///
/// The work grows as n log n with the moves of a print that goes upwards, and is shared among all
/// cores; the verdict does not depend on their number.
#[must_use]
pub fn certify(moves: &[Step], dwells: &[usize], rules: &Rules) -> Certificate {
    let deposit = deposit::Deposit::of(moves, dwells, &rules.bed);
    let (collisions, (held, out_of_bounds)) = rayon::join(
        || collide::collisions(moves, &deposit, rules),
        || rayon::join(|| stretch::hold(&deposit, rules), || bounds::breaches(moves, rules)),
    );
    Certificate {
        collisions,
        floating_starts: held.floating_starts,
        dangling_ends: held.dangling_ends,
        spans_over: held.spans_over,
        out_of_bounds,
        max_span: held.max_span,
        max_free_end: held.max_free_end,
        moves: moves.len(),
        garbage_lines: 0,
        relaxed: held.relaxed,
        strands: deposit.strands,
        strand_lines: deposit.lines,
        strand_features: deposit.features,
        features: Vec::new(),
    }
}
