//! Stage 5, the toolpath: every move of the head, with speed, filament, pause and air.

use glam::DVec3;

use crate::wireframe::Kind;

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
