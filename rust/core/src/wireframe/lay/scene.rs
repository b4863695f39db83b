//! A model of bare slices, for tests of planners.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use glam::{DVec2, DVec3};

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::polygon;
use crate::printer::Printer;
use crate::slices::heights::Level;
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::obstacles::Obstacles;
use crate::wireframe::lay::tops::Tops;
use crate::wireframe::place::guide::Guide;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::Layered;

/// Slices, what of them is layers, and the printer.
pub struct Scene {
    /// The slices.
    pub sliced: Sliced,
    /// What of them is layers.
    pub layered: Layered,
    /// The printer.
    pub printer: Printer,
}

impl Scene {
    /// A slab of `height` mm on the bed whose slices both have these contours, each upon itself.
    pub fn slab(height: f64, contours: &[Contour]) -> Self {
        let level = |z: f64| Level { z, low: z, high: z, between: Vec::new() };
        let strip = |i: u32| Strip { lower: vec![i], upper: vec![i], ..Strip::default() };
        let sliced = Sliced {
            levels: vec![level(0.35), level(0.35 + height)],
            lower: vec![Vec::new(), contours.to_vec()],
            sheets: vec![Vec::new(); 2],
            upper: vec![contours.to_vec(), Vec::new()],
            strips: vec![(0..contours.len() as u32).map(strip).collect()],
            ledges: vec![None, None],
            columns: Vec::new(),
        };
        Self { sliced, layered: Layered::default(), printer: Printer::paper() }
    }

    /// Asks a planner, which may print into a journal.
    pub fn ask<T>(&self, planner: impl FnOnce(&Context, &mut Journal) -> T) -> T {
        let Self { sliced, layered, printer } = self;
        let tops = Tops::new(sliced, layered, &printer.head);
        let (head, p, guide) = (&printer.head, &printer.wire, &Guide::default());
        let cx = Context { sliced, layered, p, head, tops: &tops, columns: true, guide };
        let (low, high) = (DVec2::splat(-200.0), DVec2::splat(200.0));
        planner(&cx, &mut Journal::new(Obstacles::new(head, p.strand, 10.0, low, high)))
    }
}

/// A square around the origin, its corners `half` mm from the axes.
pub fn square(half: f64) -> Contour {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    closed(corners.iter().map(|&(x, y)| DVec2::new(x, y) * half).collect())
}

/// A closed contour through some points.
pub fn closed(points: Vec<DVec2>) -> Contour {
    let area = polygon::signed_area(&points);
    Contour { points, closed: true, area, ..Contour::default() }
}

/// A contour as a curve.
pub fn curve(contour: &Contour) -> Curve {
    Curve::new(&contour.points, contour.closed).unwrap()
}

/// A contour as what is printed at a height, mm.
pub fn rim(contour: &Contour, z: f64) -> Rim {
    let points: Vec<DVec3> = contour.points.iter().map(|p| p.extend(z)).collect();
    Rim { points, closed: contour.closed, printed: true, ..Rim::default() }
}
