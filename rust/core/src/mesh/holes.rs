//! Boundary loops: small ones are closed, large ones are rims of an open model.

use glam::DVec3;

use super::surface::Surface;
use super::topology::{NO_FACE, ends};

/// Most corners of a hole that is triangulated at least area; the work grows with their cube.
const MOST_CORNERS: usize = 100;

/// A boundary loop.
#[derive(Debug)]
pub struct BoundaryLoop {
    /// Its vertices in the order in which a face that fills it would have them.
    pub vertices: Vec<u32>,
    /// One of the faces along it.
    pub face: u32,
}

impl BoundaryLoop {
    /// Positions of its vertices.
    pub fn points(&self, surface: &Surface) -> Vec<DVec3> {
        self.vertices.iter().map(|&v| surface.vertices[v as usize]).collect()
    }

    /// Triangles that join it to its centre.
    pub fn fan(&self, surface: &Surface) -> Vec<[DVec3; 3]> {
        let points = self.points(surface);
        let hub = centre(&points);
        (0..points.len()).map(|i| [points[i], points[(i + 1) % points.len()], hub]).collect()
    }
}

/// What became of the boundary loops.
#[derive(Debug, Default)]
pub struct Holes {
    /// Number of loops that were closed.
    pub closed: usize,
    /// Facets that close them.
    pub facets: usize,
}

/// Closes every loop of three edges (but not around a single facet) and those whose perimeter is at most `perimeter` (file
/// units).
pub fn close(surface: &mut Surface, perimeter: f64) -> Holes {
    let mut holes = Holes::default();
    let before = surface.faces.len();
    for rim in rims(surface) {
        let points = rim.points(surface);
        let (rim, along) = (rim.vertices, surface.faces[rim.face as usize]);
        let single = rim.len() == 3 && sorted([rim[0], rim[1], rim[2]]) != sorted(along);
        let small = rim.len() > 3 && length(&points) <= perimeter;
        if !single && !small {
            continue;
        }
        if rim.len() <= MOST_CORNERS {
            let fill = least_area(&points);
            surface.faces.extend(fill.into_iter().map(|face| face.map(|i| rim[i])));
        } else {
            let hub = surface.vertices.len() as u32;
            surface.vertices.push(centre(&points));
            let spoke = |i: usize| [rim[i], rim[(i + 1) % rim.len()], hub];
            surface.faces.extend((0..rim.len()).map(spoke));
        }
        holes.closed += 1;
    }
    holes.facets = surface.faces.len() - before;
    if holes.facets > 0 {
        surface.connect();
    }
    holes
}

fn sorted(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}

fn length(points: &[DVec3]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a.distance(*b)).sum()
}

fn centre(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// The boundary loops of a consistently oriented surface, in the order of their first edges.
pub fn rims(surface: &Surface) -> Vec<BoundaryLoop> {
    let open = surface.open_halves();
    let mut seen = vec![false; open.len()];
    let mut rims = Vec::new();
    for start in 0..open.len() {
        let (mut at, mut vertices) = (start, Vec::new());
        while !std::mem::replace(&mut seen[at], true) {
            vertices.push(ends(&surface.faces, open[at]).1);
            match before(surface, open[at]).and_then(|h| open.binary_search(&h).ok()) {
                Some(next) => at = next,
                None => break,
            }
        }
        if vertices.len() > 2 {
            rims.push(BoundaryLoop { vertices, face: open[start] / 3 });
        }
    }
    rims
}

/// The open half-edge that ends where open half-edge `h` begins, found by turning about that
/// vertex; none where the faces about it are not oriented alike.
fn before(surface: &Surface, h: u32) -> Option<u32> {
    let (mut f, mut i) = (h as usize / 3, (h as usize + 2) % 3);
    for _ in 0..surface.faces.len() {
        let across = surface.neighbours[f][i];
        if across == NO_FACE {
            return Some((3 * f + i) as u32);
        }
        let (from, hub) = ends(&surface.faces, (3 * f + i) as u32);
        let face = surface.faces[across as usize];
        let j = (0..3).find(|&j| face[j] == hub && face[(j + 1) % 3] == from)?;
        (f, i) = (across as usize, (j + 2) % 3);
    }
    None
}

/// Triangles over a loop of points whose total area is least, by dynamic programming.
///
/// Source: Barequet and Sharir, Filling gaps in the boundary of a polyhedron, 1995.
fn least_area(points: &[DVec3]) -> Vec<[usize; 3]> {
    let n = points.len();
    let area = |i: usize, j: usize, k: usize| {
        (points[j] - points[i]).cross(points[k] - points[i]).length()
    };
    let mut cost = vec![vec![0.0; n]; n];
    let mut split = vec![vec![0; n]; n];
    for span in 2..n {
        for i in 0..n - span {
            let k = i + span;
            let through = |j: usize| cost[i][j] + cost[j][k] + area(i, j, k);
            let best = (i + 1..k).min_by(|&a, &b| through(a).total_cmp(&through(b)));
            let j = best.unwrap_or(i + 1);
            (cost[i][k], split[i][k]) = (through(j), j);
        }
    }
    let (mut triangles, mut open) = (Vec::with_capacity(n), vec![(0, n - 1)]);
    while let Some((i, k)) = open.pop() {
        if k - i > 1 {
            let j = split[i][k];
            triangles.push([i, j, k]);
            open.extend([(i, j), (j, k)]);
        }
    }
    triangles
}
