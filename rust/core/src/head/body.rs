//! The bodies that make a head, each to be looked for where it is: a duct that hangs low on one side
//! is no reason to look all around.

use glam::{DVec2, DVec3};

use super::{Head, HeadPart, Hit};

/// The round body, or a part beside it.
#[derive(Debug, Clone, Copy)]
pub enum Body<'a> {
    /// Tip, flank, block and carriage.
    Round(&'a Head),
    /// A box or a cylinder.
    Part(&'a HeadPart),
}

impl Head {
    /// The round body, then the parts.
    pub fn bodies(&self) -> impl Iterator<Item = Body<'_>> {
        std::iter::once(Body::Round(self)).chain(self.parts.iter().map(Body::Part))
    }

    /// Greatest height of material that is out of the reach of all parts while neither it nor the
    /// tip leaves a rectangle of this size over xy, mm; infinite where no part comes over it.
    #[must_use]
    pub fn height_below_parts(&self, size: DVec2) -> f64 {
        let over = self.parts.iter().filter(|part| part.meets(size));
        over.map(HeadPart::bottom).fold(f64::INFINITY, f64::min)
    }
}

impl Body<'_> {
    /// Where its middle stands, seen from the tip, mm.
    #[must_use]
    pub fn middle(&self) -> DVec2 {
        match self {
            Self::Round(_) => DVec2::ZERO,
            Self::Part(part) => part.middle(),
        }
    }

    /// Height above the tip below which there is nothing of it, mm.
    #[must_use]
    pub fn bottom(&self) -> f64 {
        match self {
            Self::Round(_) => 0.0,
            Self::Part(part) => part.bottom(),
        }
    }

    /// Largest horizontal distance from its middle at which material `height` mm above the tip can
    /// touch it, mm.
    #[must_use]
    pub fn reach_at(&self, height: f64) -> f64 {
        match self {
            Self::Round(head) => head.round_reach_at(height),
            Self::Part(part) => part.radius(),
        }
    }

    /// Half the size along x and y of the rectangle about its middle in which material `height` mm above
    /// the tip can touch it, mm.
    #[must_use]
    pub fn half_at(&self, height: f64) -> DVec2 {
        match self {
            Self::Round(head) => DVec2::splat(head.round_reach_at(height)),
            Self::Part(part) => part.half(),
        }
    }

    /// As [`Head::deeper_than`], of this body alone.
    #[must_use]
    pub fn deeper_than(&self, tolerance: f64, tip: [DVec3; 2], strand: [DVec3; 2]) -> Option<Hit> {
        match self {
            Self::Round(head) => head.round_deeper_than(tolerance, tip, strand),
            Self::Part(part) => part.deeper_than(tolerance, tip, strand),
        }
    }
}
