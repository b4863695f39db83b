//! Strands and moves, and what they are for: the one list of kinds, below every stage that names them.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What a strand is for; the discriminants are the codes of every `kind` array.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
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

/// A row of the table of kinds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KindRow {
    /// The kind; its code is the row's index.
    pub kind: Kind,
    /// What users call it.
    pub name: &'static str,
    /// What follows `;TYPE:` in G-code; empty for moves that viewers know by themselves.
    pub type_word: &'static str,
    /// The role of PrusaSlicer that comes nearest, as it writes it: its viewer knows no others.
    pub prusa_word: &'static str,
}

/// All kinds, by their codes: the one table that names them.
pub const KINDS: [KindRow; 12] = [
    row(Kind::Travel, "travel", "", ""),
    row(Kind::Contour, "contour", "CONTOUR", "External perimeter"),
    row(Kind::Post, "post", "POST", "Perimeter"),
    row(Kind::Diagonal, "diagonal", "DIAGONAL", "Bridge infill"),
    row(Kind::Cap, "cap", "CAP", "Top solid infill"),
    row(Kind::LayerWise, "layer-wise", "LAYER-WISE", "Solid infill"),
    row(Kind::Support, "support", "SUPPORT", "Support material"),
    row(Kind::Skirt, "skirt", "SKIRT", "Skirt/Brim"),
    row(Kind::Brim, "brim", "BRIM", "Skirt/Brim"),
    row(Kind::Retract, "retract", "", ""),
    row(Kind::Unretract, "unretract", "", ""),
    row(Kind::LayerFill, "layer-fill", "LAYER-FILL", "Internal infill"),
];

const fn row(
    kind: Kind,
    name: &'static str,
    type_word: &'static str,
    prusa_word: &'static str,
) -> KindRow {
    KindRow { kind, name, type_word, prusa_word }
}

impl Kind {
    /// The kind with this code.
    #[must_use]
    pub fn of_code(code: u8) -> Option<Self> {
        KINDS.get(usize::from(code)).map(|row| row.kind)
    }

    /// Whether it is part of a stacked layer.
    #[must_use]
    pub fn is_layered(self) -> bool {
        matches!(self, Self::LayerWise | Self::LayerFill)
    }
}

/// One extruded stroke, in printing order within its wireframe.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_stands_in_the_order_of_codes() {
        for (code, row) in (0_u8..).zip(&KINDS) {
            assert_eq!(row.kind as u8, code);
            assert_eq!(Kind::of_code(code), Some(row.kind));
        }
        assert_eq!(Kind::of_code(KINDS.len() as u8), None);
    }

    #[test]
    fn no_two_kinds_share_a_name_or_a_type_word() {
        for (i, row) in KINDS.iter().enumerate() {
            let others = || KINDS[..i].iter();
            assert!(others().all(|other| other.name != row.name));
            assert!(row.type_word.is_empty() || others().all(|o| o.type_word != row.type_word));
        }
    }
}
