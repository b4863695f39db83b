//! Edges with more than two faces: their faces are paired so that manifold sheets remain.
//!
//! Around such an edge the faces are sorted by angle. The solid lies counter-clockwise of a face
//! that runs down the edge and clockwise of one that runs up, so each downward face is paired
//! with the upward face that closes its wedge of solid: bodies that touch along the edge stay
//! apart, and every contour through it stays closed.

use std::f64::consts::TAU;

use glam::DVec3;

use super::topology::ends;

/// What pairing the fans did.
#[derive(Debug, Default, Clone, Copy)]
pub struct Paired {
    /// Half-edges that found no partner.
    pub single: usize,
    /// Pairs of faces that traverse the edge in the same direction.
    pub opposed: usize,
}

/// Pairs the half-edges of each fan and enters the pairs into `neighbours`.
pub fn pair(
    vertices: &[DVec3],
    faces: &[[u32; 3]],
    fans: &[Vec<u32>],
    neighbours: &mut [[u32; 3]],
) -> Paired {
    let mut paired = Paired::default();
    for fan in fans {
        let sorted = by_angle(vertices, faces, fan);
        let (pairs, single) = wedges(&sorted);
        paired.single += single;
        for (g, h) in pairs {
            neighbours[g as usize / 3][g as usize % 3] = h / 3;
            neighbours[h as usize / 3][h as usize % 3] = g / 3;
            paired.opposed += usize::from(ends(faces, g) == ends(faces, h));
        }
    }
    paired
}

/// Faces that lie upon each other differ by rounding, rad: far less than walls ever do.
const SAME_ANGLE: f64 = 1e-5;

/// The half-edges by angle around the edge, upward ones first at equal angles, each with
/// whether it runs from the edge's lower-numbered vertex to the higher one.
///
/// Angles count from the first face, so that none of the faces that lie upon it is taken for one a
/// whole turn away.
fn by_angle(vertices: &[DVec3], faces: &[[u32; 3]], fan: &[u32]) -> Vec<(u32, bool)> {
    let point = |v: u32| vertices[v as usize];
    let (a, b) = ends(faces, fan[0]);
    let (low, high) = (point(a.min(b)), point(a.max(b)));
    let axis = (high - low).normalize_or(DVec3::Z);
    let (x, y) = axis.any_orthonormal_pair();
    // The pair's handedness follows from the axis' sign; make it right-handed about the axis.
    let y = if x.cross(y).dot(axis) < 0.0 { -y } else { y };
    let angle = |h: u32| {
        let apex = faces[h as usize / 3][(h as usize + 2) % 3];
        let arm = point(apex) - low;
        arm.dot(y).atan2(arm.dot(x))
    };
    let first = angle(fan[0]) - SAME_ANGLE;
    let is_down = |h: u32| ends(faces, h).0 > ends(faces, h).1;
    let mut sorted: Vec<(f64, u32)> =
        fan.iter().map(|&h| ((angle(h) - first).rem_euclid(TAU), h)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let groups = sorted.chunk_by_mut(|a, b| b.0 - a.0 < SAME_ANGLE);
    groups.for_each(|group| group.sort_by_key(|&(_, h)| (is_down(h), h)));
    sorted.into_iter().map(|(_, h)| (h, !is_down(h))).collect()
}

/// Pairs of half-edges, and how many are left: downward faces open a wedge, upward ones close
/// it, as brackets do; what is left over is paired in order of angle.
fn wedges(sorted: &[(u32, bool)]) -> (Vec<(u32, u32)>, usize) {
    let (mut pairs, mut open) = (Vec::new(), Vec::new());
    let mut unmatched = Vec::new();
    // Twice round, so that a wedge across the first angle closes too.
    for (turn, &(h, up)) in sorted.iter().map(|s| (0, s)).chain(sorted.iter().map(|s| (1, s))) {
        match (turn, up) {
            (0, false) => open.push(h),
            (0, true) => match open.pop() {
                Some(g) => pairs.push((g, h)),
                None => unmatched.push(h),
            },
            (_, true) if unmatched.contains(&h) => {
                if let Some(g) = open.pop() {
                    pairs.push((g, h));
                    unmatched.retain(|&u| u != h);
                }
            }
            _ => {}
        }
    }
    unmatched.extend(open);
    let rest = unmatched.chunks_exact(2);
    let single = rest.remainder().len();
    pairs.extend(rest.map(|pair| (pair[0], pair[1])));
    (pairs, single)
}
