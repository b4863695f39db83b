//! Loops become contours: united where they overlap, nested, in order.

use super::Contour;
use super::polygon::{length, signed_area};
use super::sweep::{Found, Ring, sweep};
use super::union::union;
use crate::slices::Loop;

/// A closed loop whose area is below this share of its squared length is a line.
const LINE: f64 = 1e-12;

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

/// The loops that are long enough, and their areas.
fn measured(loops: Vec<Loop>, min_length: f64) -> (Vec<Loop>, Vec<f64>) {
    let measure = |l: Loop| {
        let length = length(&l.points, l.closed);
        (length >= min_length).then(|| (area(&l, length), l))
    };
    let (areas, loops) = loops.into_iter().filter_map(measure).unzip();
    (loops, areas)
}

/// Signed area of a loop; none for open polylines and lines there and back.
fn area(l: &Loop, length: f64) -> f64 {
    let area = if l.closed { signed_area(&l.points) } else { 0.0 };
    if area.abs() > LINE * length.powi(2) { area } else { 0.0 }
}

fn nest(loops: &[Loop], areas: &[f64]) -> Found {
    let rings = loops.iter().zip(areas).map(|(l, &area)| Ring { points: &l.points, area });
    sweep(&rings.collect::<Vec<_>>())
}

/// Contours depth first, with parents renumbered.
fn tree(loops: Vec<Loop>, areas: &[f64], parents: &[Option<u32>]) -> Vec<Contour> {
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
        contours.push(Contour { points, faces, closed, parent, depth, area: areas[index] });
    }
    contours
}
