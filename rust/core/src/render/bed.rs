//! The piece of the bed under a print: a plate with a grid and the print's shadow.

use glam::{DVec2, DVec3};

use super::camera::Camera;
use super::scene::{DrawnStroke, Facet, Rgb, Scene, Width, bounds};

/// Distance of the grid's lines, mm.
const GRID_MM: f64 = 10.0;
/// The plate reaches at least this far beyond the print, mm.
const MARGIN_MM: f64 = 4.0;
/// A print wider than this many grid lines has a coarser grid.
const MOST_LINES: f64 = 60.0;
/// What lies on the bed is drawn this far apart, mm, so that the order is plain.
const LAYER_MM: f64 = 0.02;

const PLATE: Rgb = [240, 242, 245];
const LINE: Rgb = [219, 223, 229];
const SHADOW: Rgb = [208, 212, 219];

/// The bed below a scene; `None` where that is empty or seen from below.
pub(super) fn below(scene: &Scene, camera: &Camera) -> Option<Scene> {
    if camera.elevation < 0.0 {
        return None;
    }
    let (low, high) = bounds(scene.framed_points().into_iter())?;
    let (low, high) = (low.truncate(), high.truncate());
    let coarser = ((high - low).max_element() / GRID_MM / MOST_LINES).log10().ceil().max(0.0);
    let step = GRID_MM * 10_f64.powf(coarser);
    let low = ((low - MARGIN_MM) / step).floor() * step;
    let high = ((high + MARGIN_MM) / step).ceil() * step;
    let strokes = shadows(scene).chain(grid(low, high, step)).collect();
    Some(Scene { strokes, facets: plate(low, high).to_vec(), floor: false })
}

/// Strands seen by a lamp straight above, on the bed.
fn shadows(scene: &Scene) -> impl Iterator<Item = DrawnStroke> {
    let flat = |p: DVec3| p.with_z(-LAYER_MM);
    scene.strokes.iter().filter(|s| matches!(s.width, Width::Tube(_))).map(move |s| DrawnStroke {
        from: flat(s.from),
        to: flat(s.to),
        width: Width::Line(1.5),
        colour: SHADOW,
    })
}

fn grid(low: DVec2, high: DVec2, step: f64) -> Vec<DrawnStroke> {
    let line = |from: DVec2, to: DVec2| {
        let [from, to] = [from, to].map(|p| p.extend(-2.0 * LAYER_MM));
        DrawnStroke { from, to, width: Width::Line(1.2), colour: LINE }
    };
    let ticks = |low: f64, high: f64| {
        let count = ((high - low) / step).round() as usize;
        (0..=count).map(move |i| low + i as f64 * step)
    };
    let across = ticks(low.x, high.x).map(|x| line(DVec2::new(x, low.y), DVec2::new(x, high.y)));
    let along = ticks(low.y, high.y).map(|y| line(DVec2::new(low.x, y), DVec2::new(high.x, y)));
    across.chain(along).collect()
}

fn plate(low: DVec2, high: DVec2) -> [Facet; 2] {
    let corner = |x, y| DVec3::new(x, y, -3.0 * LAYER_MM);
    let [a, b, c, d] = [
        corner(low.x, low.y),
        corner(high.x, low.y),
        corner(high.x, high.y),
        corner(low.x, high.y),
    ];
    [[a, b, c], [a, c, d]].map(|corners| Facet { corners, colour: PLATE, lit: false })
}
