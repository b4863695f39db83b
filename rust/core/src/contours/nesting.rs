//! Loops become contours: united where they overlap, nested, in order.

use glam::DVec2;

use super::contour::Contour;
use super::ring::Ring;
use super::sweep::{SweptRings, sweep};
use super::union::union;
use crate::geometry::polygon::{length, signed_area};
use crate::slices::Loop;

/// The contours of one slice.
///
/// Loops shorter than `min_length` mm are dropped. Where loops cross, overlap, or wind around a
/// place otherwise than 0 or 1 times, they are replaced by their non-zero [`union`]; all others
/// keep their points exactly. Contours come depth first: each is followed at once by those that
/// it encloses, and siblings keep the order of their loops.
#[must_use]
pub fn contours(loops: Vec<Loop>, min_length: f64) -> Vec<Contour> {
    let (loops, areas) = measured(loops, min_length);
    let found = nest(&loops, &areas);
    if found.sound {
        return tree(loops, &areas, &found.parents);
    }
    let (loops, areas) = measured(union(loops), min_length);
    let parents = nest(&loops, &areas).parents;
    tree(loops, &areas, &parents)
}

/// The loops that are long enough, and the areas of those that enclose something.
fn measured(loops: Vec<Loop>, min_length: f64) -> (Vec<Loop>, Vec<Option<f64>>) {
    let long = |l: &Loop| length(&l.points, l.closed) >= min_length;
    let loops: Vec<Loop> = loops.into_iter().filter(long).collect();
    let areas = loops.iter().map(enclosed).collect();
    (loops, areas)
}

/// Signed area of a loop, unless it is an open polyline or a line there and back.
fn enclosed(l: &Loop) -> Option<f64> {
    let area = if l.closed { signed_area(&l.points) } else { return None };
    (area != 0.0 || !returns(&l.points)).then_some(area)
}

/// Whether a loop goes back the way it came, as around a ridge that lies in the plane.
fn returns(points: &[DVec2]) -> bool {
    let n = points.len();
    let tip = (0..n).find(|&i| points[(i + 1) % n] == points[(i + n - 1) % n]);
    tip.is_some_and(|tip| (1..n).all(|k| points[(tip + k) % n] == points[(tip + n - k) % n]))
}

fn nest(loops: &[Loop], areas: &[Option<f64>]) -> SweptRings {
    let rings = loops.iter().zip(areas).map(|(l, &area)| Ring { points: &l.points, area });
    sweep(&rings.collect::<Vec<_>>())
}

/// Contours depth first, with parents renumbered.
fn tree(loops: Vec<Loop>, areas: &[Option<f64>], parents: &[Option<u32>]) -> Vec<Contour> {
    let mut children = vec![Vec::new(); loops.len()];
    let mut stack = Vec::new();
    for (index, parent) in parents.iter().enumerate().rev() {
        match parent {
            Some(parent) => children[*parent as usize].push(index),
            None => stack.push((index, None, 0)),
        }
    }
    let mut loops: Vec<Option<Loop>> = loops.into_iter().map(Some).collect();
    let mut contours = Vec::with_capacity(loops.len());
    while let Some((index, parent, depth)) = stack.pop() {
        let here = contours.len() as u32;
        stack.extend(children[index].iter().map(|&child| (child, Some(here), depth + 1)));
        let Some(Loop { points, faces, closed }) = loops[index].take() else { continue };
        let area = areas[index].unwrap_or(0.0);
        contours.push(Contour { points, faces, closed, parent, depth, area, support: false });
    }
    contours
}
