//! Stage 4, the wireframe: strips, posts, strands.

mod ahead;
mod build;
mod builder;
mod columns;
pub mod curve;
mod detours;
mod guide;
mod hang;
mod hatch;
pub mod layered;
mod layers;
mod level;
mod lids;
pub mod posts;
pub mod rim;
mod segments;
mod slab;
mod sliced;
pub mod strips;
mod tops;
mod tour;
mod trial;
mod waiting;
mod walls;
pub mod zigzag;

use glam::DVec3;

pub use build::build;
pub use layered::Layered;
pub use layers::{Layer, cut_layers};
pub use sliced::{Sliced, slice_model};
pub use zigzag::Placement;

use posts::Post;

/// What a strand is for; the discriminants are the codes of every `kind` array.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Kind {
    /// A move without extrusion.
    Travel = 0,
    /// Part of a horizontal contour.
    Contour = 1,
    /// Upward stroke of a zigzag.
    Post = 2,
    /// Downward stroke of a zigzag.
    Diagonal = 3,
    /// Strand that closes a horizontal face.
    Cap = 4,
    /// Part of a stacked layer.
    LayerWise = 5,
    /// Strand that carries what would hang in the air.
    Support = 6,
    /// Line around the print that primes the nozzle.
    Skirt = 7,
    /// Flat rings that hold the first contour to the bed.
    Brim = 8,
    /// Filament pulled back (no displacement).
    Retract = 9,
    /// Filament pushed forward again (no displacement).
    Unretract = 10,
    /// Part of a stacked layer behind the outer wall.
    LayerFill = 11,
}

impl Kind {
    /// Whether it is part of a stacked layer.
    #[must_use]
    pub fn is_layered(self) -> bool {
        matches!(self, Self::LayerWise | Self::LayerFill)
    }
}

/// One extruded stroke, in printing order within its wireframe.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strand {
    /// Where it begins, mm.
    pub from: DVec3,
    /// Where it ends, mm.
    pub to: DVec3,
    /// What it is for.
    pub kind: Kind,
    /// Index of the slab (0 at the bed) it belongs to.
    pub slab: u32,
    /// Whether it ends in the air, where it must hold by itself.
    pub floating: bool,
    /// Filament that it takes, as a share of what a free strand of its length would.
    pub flow: f64,
    /// Whether the head may come to it straight, with nothing in the way.
    pub direct: bool,
}

impl Strand {
    /// Whether it climbs or falls between two heights: most of it floats.
    #[must_use]
    pub fn slab_rises(&self) -> bool {
        matches!(self.kind, Kind::Post | Kind::Diagonal | Kind::Support)
    }
}

/// How slabs are filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pattern {
    /// Contours joined by zigzags (paper, figure 4).
    Zigzag,
    /// Zigzags alone: the peaks of one carry the bases of the next (paper, figure 7c).
    Peaks,
}

/// What the wireframe depends on; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct WireParams {
    /// Diameter of a strand.
    pub strand: f64,
    /// How slabs are filled.
    pub pattern: Pattern,
    /// How posts are placed.
    pub placement: Placement,
    /// Whether flat faces are closed.
    pub caps: bool,
    /// Whether what begins in the air is supported.
    pub supports: bool,
    /// Distance between the strands of a cap.
    pub cap_spacing: f64,
    /// Longest stretch between two supports.
    pub span_limit: f64,
    /// Longest stroke that ends in the air.
    pub free_end_limit: f64,
}

/// A post with its slab and the contour (of the slice at the slab's top) that it carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedPost {
    /// The post.
    pub post: Post,
    /// Index of the slab.
    pub slab: u32,
    /// Index of the contour in the slice from below at the slab's top.
    pub contour: u32,
}

/// Why a part of the surface is not printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reason {
    /// It begins in the air with nothing below.
    MidAir,
    /// Neighbouring walls leave the head no room for a post.
    NoFoothold,
    /// A stretch of its contour is longer than a strand can span.
    WideSpan,
    /// Its flat roof is wider than a strand can span.
    WideRoof,
}

/// A part of the surface that is not printed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unprinted {
    /// Lower end, mm.
    pub low: f64,
    /// Upper end, mm.
    pub high: f64,
    /// Area of the surface, mm².
    pub area: f64,
    /// A point on it, mm.
    pub place: DVec3,
    /// Why.
    pub reason: Reason,
}

/// The wire print as geometry: strands in printing order and what they were made from.
#[derive(Debug)]
pub struct Wireframe {
    /// Slices, contours and strips.
    pub sliced: Sliced,
    /// Every post that stands.
    pub posts: Vec<PlacedPost>,
    /// Every strand, in printing order.
    pub strands: Vec<Strand>,
    /// What is not printed, bottom up.
    pub unprinted: Vec<Unprinted>,
}

impl Wireframe {
    /// Length of all strands of a kind, mm.
    #[must_use]
    pub fn length_of(&self, kind: Kind) -> f64 {
        let found = self.strands.iter().filter(|s| s.kind == kind);
        found.map(|s| s.from.distance(s.to)).fold(0.0, std::ops::Add::add)
    }
}
