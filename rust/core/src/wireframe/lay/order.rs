//! In which order the contours of a slab are printed.

/// The order in which the contours of a slab are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// Always the one nearest to the head.
    Nearest,
    /// Along a short way through all of them.
    Tour,
    /// The smallest first: what lies within others before these.
    InsideOut,
    /// The largest first.
    OutsideIn,
    /// As in the plain print.
    Guided,
}
