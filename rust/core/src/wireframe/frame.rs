//! The wire print as geometry: what the stage hands on.

use glam::DVec3;

use crate::strand::{Kind, Strand};
use crate::wireframe::place::posts::Post;
use crate::wireframe::plan::sliced::Sliced;

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
