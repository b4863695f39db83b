//! What all planners of a pass go by; nothing in it changes while strands are laid.

use crate::head::Head;
use crate::wireframe::lay::tops::Tops;
use crate::wireframe::params::WireParams;
use crate::wireframe::place::guide::Guide;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::regions::layered::Layered;

/// The model, what of it is layers, and how it is to be wired.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// Slices, contours and strips.
    pub sliced: &'a Sliced,
    /// The parts that are printed as layers.
    pub layered: &'a Layered,
    /// What the wireframe depends on.
    pub p: &'a WireParams,
    /// The head.
    pub head: &'a Head,
    /// What ends each slab.
    pub tops: &'a Tops<'a>,
    /// Whether columns may still be asked for.
    pub columns: bool,
    /// The plain print that wire beside layers goes by; empty for that print itself.
    pub guide: &'a Guide,
}
