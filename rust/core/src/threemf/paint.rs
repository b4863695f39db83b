//! Painting of triangles, as `PrusaSlicer`, `Bambu Studio` and `OrcaSlicer` keep it.
//!
//! A triangle's painting is a string of hexadecimal digits that is read from its end. Each digit is
//! a node of a tree. Its lower two bits tell into how many triangles less one the node is split.
//! Where they are 0 the node is a leaf, and the upper two bits are its state: 0 unpainted, 1 and 2
//! the first two extruders; 3 means that another digit follows, which is the state less 3. Where the
//! node is split, the upper two bits tell which corner the split is counted from, and its children
//! follow, the last one first.
//!
//! Counted from corner a of a triangle a, b, c, with m between two corners their middle, the
//! children are
//!
//! | split | children |
//! |-------|----------|
//! | in 2  | (a, b, m_bc), (m_bc, c, a) |
//! | in 3  | (a, m_ab, m_ca), (m_ab, b, m_ca), (b, c, m_ca) |
//! | in 4  | (a, m_ab, m_ca), (m_ab, b, m_bc), (m_bc, c, m_ca), (m_ab, m_bc, m_ca) |
//!
//! `PrusaSlicer`'s makers describe the digits in <https://github.com/prusa3d/PrusaSlicer/issues/5294>;
//! the geometry was found by slicing painted triangles with `PrusaSlicer` 2.5.

use glam::DVec3;

use crate::xml::shown;
use crate::{CoreError, Result};

/// A leaf whose state stands in the next digit.
const EXTENDED: u8 = 3;

/// Most digits of all paintings of a part.
pub const MOST_DIGITS: usize = 1 << 22;

/// A triangle by its corners.
pub type Triangle = [DVec3; 3];

/// The paintings of a mesh's triangles.
#[derive(Debug, Default)]
pub struct Painting {
    triangles: Vec<u32>,
    /// All paintings, one after another, and where each ends.
    text: String,
    ends: Vec<usize>,
}

/// What paintings amount to.
#[derive(Debug, Default, PartialEq)]
pub struct Leaves {
    /// Triangles that are not split, and their states.
    pub whole: Vec<u32>,
    /// State of each of those: 0 unpainted, else the number of an extruder.
    pub whole_states: Vec<u8>,
    /// For each leaf of the other ones, in order, the triangle that it is part of.
    pub owners: Vec<u32>,
    /// Corners of each leaf.
    pub corners: Vec<Triangle>,
    /// State of each leaf.
    pub states: Vec<u8>,
}

impl Painting {
    /// Adds a triangle's painting; an empty one is none.
    pub fn add(&mut self, triangle: u32, digits: &str) {
        if !digits.is_empty() {
            self.triangles.push(triangle);
            self.text.push_str(digits);
            self.ends.push(self.text.len());
        }
    }

    /// Number of digits, and so the most triangles that they split into.
    #[must_use]
    pub fn digits(&self) -> usize {
        self.text.len()
    }

    /// Lays out what is painted on the triangles of a mesh.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] that names the first triangle whose painting is none, or that the
    /// mesh does not have.
    pub fn leaves(&self, vertices: &[DVec3], faces: &[[u32; 3]]) -> Result<Leaves> {
        // What is damaged is refused before memory is taken for the leaves.
        let (mut whole, mut parts) = (0, 0);
        for (triangle, digits) in self.paintings() {
            let checked = walk(digits, DVec3::AXES, |leaf| {
                *(if leaf.whole { &mut whole } else { &mut parts }) += 1;
            });
            checked.map_err(|what| unreadable(triangle, digits, what))?;
        }
        let mut leaves = Leaves::of(whole, parts);
        for (triangle, digits) in self.paintings() {
            let corners = corners(triangle, vertices, faces)
                .ok_or_else(|| unreadable(triangle, digits, "is on no triangle"))?;
            let visited = walk(digits, corners, |leaf| leaves.add(triangle, leaf));
            visited.map_err(|what| unreadable(triangle, digits, what))?;
        }
        Ok(leaves)
    }

    /// Each painted triangle, and its digits.
    fn paintings(&self) -> impl Iterator<Item = (u32, &str)> {
        let begins = std::iter::once(0).chain(self.ends.iter().copied());
        let ranges = begins.zip(&self.ends).map(|(begin, &end)| &self.text[begin..end]);
        self.triangles.iter().copied().zip(ranges)
    }
}

/// A part of a painted triangle that has one state.
struct Leaf {
    corners: Triangle,
    state: u8,
    /// Whether it is all of the triangle.
    whole: bool,
}

impl Leaves {
    /// None yet, with room for so many whole triangles and parts of triangles.
    fn of(whole: usize, parts: usize) -> Self {
        Self {
            whole: Vec::with_capacity(whole),
            whole_states: Vec::with_capacity(whole),
            owners: Vec::with_capacity(parts),
            corners: Vec::with_capacity(parts),
            states: Vec::with_capacity(parts),
        }
    }

    fn add(&mut self, triangle: u32, leaf: Leaf) {
        if leaf.whole {
            self.whole.push(triangle);
            self.whole_states.push(leaf.state);
        } else {
            self.owners.push(triangle);
            self.corners.push(leaf.corners);
            self.states.push(leaf.state);
        }
    }
}

fn unreadable(triangle: u32, digits: &str, what: &str) -> CoreError {
    let digits = shown(digits);
    CoreError::Unreadable(format!("the painting of triangle {triangle}: '{digits}' {what}"))
}

/// The corners of a triangle of a mesh, if it has one.
fn corners(triangle: u32, vertices: &[DVec3], faces: &[[u32; 3]]) -> Option<Triangle> {
    let corner = |v: u32| vertices.get(v as usize).copied();
    let [a, b, c] = faces.get(triangle as usize)?.map(corner);
    Some([a?, b?, c?])
}

/// Visits the leaves of a painted triangle.
fn walk(
    digits: &str,
    triangle: Triangle,
    mut visit: impl FnMut(Leaf),
) -> std::result::Result<(), &'static str> {
    let mut digits = digits.bytes().rev();
    let mut next = || match digits.next() {
        Some(digit) => char::from(digit).to_digit(16).ok_or("has other digits than base 16"),
        None => Err("has fewer digits than its tree has nodes"),
    };
    let (mut open, mut whole) = (vec![triangle], true);
    while let Some(corners) = open.pop() {
        let node = next()?;
        let (upper, split) = ((node >> 2) as u8, node & 3);
        if split == 0 {
            let state = if upper == EXTENDED { next()? as u8 + EXTENDED } else { upper };
            visit(Leaf { corners, state, whole });
        } else if upper == EXTENDED {
            return Err("splits a triangle from a corner it lacks");
        } else {
            split_into(split, upper, corners, &mut open);
            whole = false;
        }
    }
    if digits.next().is_some() {
        return Err("has more digits than its tree has nodes");
    }
    Ok(())
}

/// Opens the triangles into which one is split, counted from its corner `from`.
fn split_into(split: u32, from: u8, corners: Triangle, open: &mut Vec<Triangle>) {
    let mut turned = corners;
    turned.rotate_left(usize::from(from));
    let [a, b, c] = turned;
    let (ab, bc, ca) = (a.midpoint(b), b.midpoint(c), c.midpoint(a));
    match split {
        1 => open.extend([[a, b, bc], [bc, c, a]]),
        2 => open.extend([[a, ab, ca], [ab, b, ca], [b, c, ca]]),
        _ => open.extend([[a, ab, ca], [ab, b, bc], [bc, c, ca], [ab, bc, ca]]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [DVec3; 3] = [DVec3::ZERO, DVec3::new(8.0, 0.0, 0.0), DVec3::new(0.0, 8.0, 0.0)];

    fn leaves(digits: &str) -> Result<Leaves> {
        let mut painting = Painting::default();
        painting.add(1, digits);
        painting.leaves(&CORNERS, &[[2, 1, 0], [0, 1, 2]])
    }

    #[test]
    fn the_children_are_read_last_first_and_counted_from_the_corner_that_the_split_names() {
        // Read from its end: split in two from corner b, the last child 2, the first one 16.
        let found = leaves("DC85").unwrap();
        let middle = DVec3::new(0.0, 4.0, 0.0);
        let [a, b, c] = CORNERS;
        assert_eq!(found.owners, [1, 1]);
        assert_eq!(found.corners, [[middle, a, b], [b, c, middle]]);
        assert_eq!(found.states, [2, 16]);
        assert!(found.whole.is_empty());
    }

    #[test]
    fn a_triangle_that_is_not_split_stays_whole() {
        let found = leaves("4").unwrap();
        assert_eq!((found.whole, found.whole_states, found.corners), (vec![1], vec![1], vec![]));
    }

    #[test]
    fn what_is_no_tree_names_its_triangle() {
        for (digits, what) in [("83", "fewer"), ("44", "more"), ("4g", "base 16"), ("D", "corner")]
        {
            let text = leaves(digits).unwrap_err().to_string();
            assert!(text.starts_with(&format!("the painting of triangle 1: '{digits}'")), "{text}");
            assert!(text.contains(what), "{text}");
        }
        let mut painting = Painting::default();
        painting.add(2, "4");
        assert!(painting.leaves(&CORNERS, &[[0, 1, 2]]).is_err());
    }
}
