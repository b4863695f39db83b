//! A flat face that is to be closed, and what its strands may be.

use glam::DVec2;

use crate::wireframe::flat::holds::Holds;

/// A face to be closed, or crossed.
#[derive(Clone, Copy)]
pub struct Face<'a> {
    /// Closed rings; lines run within an odd number of them.
    pub rings: &'a [Vec<DVec2>],
    /// Whether all of the rings are printed, so that whatever ends on them is held.
    pub whole: bool,
    /// What is printed at the face's height.
    pub holds: &'a Holds,
    /// The middles of columns that end or pass there, mm.
    pub tops: &'a [DVec2],
    /// The lines that are wanted.
    pub wanted: LinesWanted<'a>,
}

/// Which lines of a face are wanted.
#[derive(Clone, Copy)]
pub enum LinesWanted<'a> {
    /// All of them.
    All,
    /// Those nearest to some places.
    Near(&'a [DVec2]),
    /// Two at least that cross the place of a figure.
    Under(&'a [DVec2]),
}

/// What lines of a face may be; lengths in mm.
#[derive(Debug, Clone, Copy)]
pub struct LineLimits {
    /// Distance between lines.
    pub spacing: f64,
    /// Longest stretch between two holds; infinite on the bed.
    pub span: f64,
    /// A strand this near holds an end.
    pub touch: f64,
}

impl Face<'_> {
    /// Where a polyline is held, as arc lengths from its beginning, ascending, mm; `length` is all of
    /// it, and its ends lie on the face's rings.
    #[must_use]
    pub fn stops(&self, line: &[DVec2], length: f64, touch: f64) -> Vec<f64> {
        let mut stops = self.holds.stops(line, touch);
        if self.whole {
            stops.retain(|s| *s > 0.0 && *s < length);
            stops.insert(0, 0.0);
            stops.push(length);
        }
        stops
    }
}
