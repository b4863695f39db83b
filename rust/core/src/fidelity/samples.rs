//! An even pattern of samples on a triangle, and which of them lie side by side.
//!
//! `cuts − 1` lines along each side divide a triangle into `cuts²` congruent ones. Row `r`, counted
//! from the side between the first two corners, has `cuts − r` that point as the whole does and,
//! between them, `cuts − r − 1` inverted ones. They are numbered row by row.

use glam::DVec3;
use rayon::prelude::*;

use super::triangle::{Triangle, area};
use crate::mesh::Mesh;

/// Area that one sample stands for, mm²; faces smaller than that have one sample.
const SAMPLE_MM2: f64 = 1.0;

/// Samples beyond one a face; on larger surfaces each stands for more.
const MOST_SAMPLES: f64 = 2e6;

/// Faces that one task measures.
const CHUNK: usize = 1 << 14;

/// Square of the longest side of a triangle, mm².
fn longest_squared([a, b, c]: Triangle) -> f64 {
    a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a))
}

/// How finely a surface is sampled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pitch {
    /// Greatest area of a sample, mm².
    area: f64,
    /// Greatest length of a sample, mm: a long and narrow triangle has as long and narrow samples.
    length: f64,
}

impl Pitch {
    /// The pitch for a mesh of `area` mm², so that no sample is longer than `length` mm.
    pub(super) fn of(mesh: &Mesh, area: f64, length: f64) -> Self {
        let squared = |face| longest_squared(mesh.corners(face));
        let chunks = (0..mesh.faces.len().div_ceil(CHUNK)).into_par_iter();
        let sums: Vec<f64> = chunks
            .map(|c| (c * CHUNK..mesh.faces.len().min((c + 1) * CHUNK)).map(squared).sum())
            .collect();
        let least = (sums.iter().sum::<f64>() / MOST_SAMPLES).sqrt();
        Self { area: SAMPLE_MM2.max(area / MOST_SAMPLES), length: length.max(least) }
    }

    /// The samples of a triangle.
    pub(super) fn samples(self, corners: Triangle) -> Samples {
        let area = area(corners);
        let long = longest_squared(corners).sqrt() / self.length;
        let cuts = (area / self.area).sqrt().max(long).ceil().max(1.0);
        Samples { corners, cuts: cuts as u32, share: area / (cuts * cuts) }
    }
}

/// The samples of a triangle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Samples {
    corners: Triangle,
    /// Pieces of each side.
    pub cuts: u32,
    /// Area of each sample, mm².
    pub share: f64,
}

/// A sample by its row and its place in it: upright ones at even places, inverted ones at odd.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cell {
    row: u32,
    place: u32,
}

impl Samples {
    /// Number of samples.
    pub(super) fn count(self) -> u32 {
        self.cuts * self.cuts
    }

    /// Centroids of all samples, by their numbers.
    pub(super) fn points(self) -> impl Iterator<Item = DVec3> {
        let rows = (0..self.cuts).map(move |row| (row, 2 * (self.cuts - row) - 1));
        rows.flat_map(move |(row, count)| {
            (0..count).map(move |place| self.centroid(Cell { row, place }))
        })
    }

    /// Centroid of sample `number`.
    pub(super) fn point(self, number: u32) -> DVec3 {
        self.centroid(self.cell(number))
    }

    fn centroid(self, Cell { row, place }: Cell) -> DVec3 {
        let third = f64::from(1 + place % 2) / 3.0;
        self.at(f64::from(place / 2) + third, f64::from(row) + third)
    }

    /// The point `u` pieces along the first side and `v` along the last one.
    fn at(self, u: f64, v: f64) -> DVec3 {
        let [a, b, c] = self.corners;
        let cuts = f64::from(self.cuts);
        a + (b - a) / cuts * u + (c - a) / cuts * v
    }

    /// Corners of sample `number`.
    pub(super) fn corners(self, number: u32) -> Triangle {
        let Cell { row, place } = self.cell(number);
        let (u, v) = (f64::from(place / 2), f64::from(row));
        let near = if place.is_multiple_of(2) { (u, v) } else { (u + 1.0, v + 1.0) };
        [self.at(near.0, near.1), self.at(u + 1.0, v), self.at(u, v + 1.0)]
    }

    /// Row and place of sample `number`.
    pub(super) fn cell(self, number: u32) -> Cell {
        // From row r on there are (cuts − r)² samples.
        let left = self.count() - number;
        let root = left.isqrt();
        let rows = if root * root == left { root } else { root + 1 };
        let row = self.cuts - rows;
        Cell { row, place: rows * rows - left }
    }

    fn number(self, Cell { row, place }: Cell) -> u32 {
        let rows = self.cuts - row;
        self.count() - rows * rows + place
    }

    /// The samples before `number` that share a side with it.
    pub(super) fn before(self, number: u32) -> impl Iterator<Item = u32> {
        let Cell { row, place } = self.cell(number);
        let beside = place.checked_sub(1).map(|place| Cell { row, place });
        let upright = place.is_multiple_of(2);
        // The base of an upright one is the side of an inverted one in the row before.
        let under = row.checked_sub(1).filter(|_| upright);
        let under = under.map(|row| Cell { row, place: place + 1 });
        beside.into_iter().chain(under).map(move |cell| self.number(cell))
    }

    /// Which of the `cuts` pieces of a side, counted along it, sample `number` lies on.
    pub(super) fn on_side(self, side: usize, number: u32) -> Option<u32> {
        let Cell { row, place } = self.cell(number);
        let column = place / 2;
        let on = match side {
            0 => row == 0,
            1 => column + row + 1 == self.cuts,
            _ => column == 0,
        };
        let along = match side {
            0 => column,
            1 => row,
            _ => self.cuts - 1 - row,
        };
        (on && place.is_multiple_of(2)).then_some(along)
    }

    /// The sample on a piece of a side, counted along it.
    pub(super) fn of_side(self, side: usize, piece: u32) -> u32 {
        let (row, column) = match side {
            0 => (0, piece),
            1 => (piece, self.cuts - 1 - piece),
            _ => (self.cuts - 1 - piece, 0),
        };
        self.number(Cell { row, place: 2 * column })
    }
}

#[cfg(test)]
mod tests {
    use super::super::triangle::distance_squared;
    use super::*;

    const CORNERS: Triangle =
        [DVec3::new(0.0, 0.0, 1.0), DVec3::new(4.0, 1.0, 0.0), DVec3::new(1.0, 3.0, 2.0)];

    fn samples(cuts: u32) -> Samples {
        Samples { corners: CORNERS, cuts, share: area(CORNERS) / f64::from(cuts * cuts) }
    }

    #[test]
    fn there_are_k_squared_samples_inside_and_their_mean_is_the_centroid() {
        for k in 1..9 {
            let found: Vec<_> = samples(k).points().collect();
            assert_eq!(found.len() as u32, k * k);
            assert!(found.iter().all(|&p| distance_squared(p, CORNERS) < 1e-12));
            let mean = found.iter().sum::<DVec3>() / f64::from(k * k);
            assert!(mean.distance((CORNERS[0] + CORNERS[1] + CORNERS[2]) / 3.0) < 1e-12);
        }
    }

    #[test]
    fn a_number_names_the_same_sample_everywhere() {
        for k in 1..9 {
            let samples = samples(k);
            for (number, point) in (0..).zip(samples.points()) {
                assert_eq!(samples.number(samples.cell(number)), number);
                let [a, b, c] = samples.corners(number);
                assert!(point.distance(samples.point(number)) < 1e-12);
                assert!(point.distance((a + b + c) / 3.0) < 1e-12);
                assert!((area([a, b, c]) - samples.share).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn samples_side_by_side_are_those_that_share_two_corners() {
        let samples = samples(5);
        let shared = |one: u32, other: u32| {
            let other = samples.corners(other);
            let near = |p: &DVec3| other.iter().any(|q| p.distance(*q) < 1e-9);
            samples.corners(one).iter().filter(|p| near(p)).count()
        };
        for one in 0..samples.count() {
            let before: Vec<u32> = samples.before(one).collect();
            for other in 0..one {
                assert_eq!(before.contains(&other), shared(one, other) == 2, "{one} {other}");
            }
        }
    }

    #[test]
    fn pieces_of_a_side_follow_each_other_along_it() {
        for k in 1..6 {
            let samples = samples(k);
            for side in 0..3 {
                let (from, to) = (CORNERS[side], CORNERS[(side + 1) % 3]);
                for piece in 0..k {
                    let number = samples.of_side(side, piece);
                    assert_eq!(samples.on_side(side, number), Some(piece));
                    let middle = from.lerp(to, (f64::from(piece) + 0.5) / f64::from(k));
                    let on = [0, 1, 2].map(|i| {
                        let corners = samples.corners(number);
                        corners[i].midpoint(corners[(i + 1) % 3]).distance(middle)
                    });
                    assert!(on.into_iter().any(|d| d < 1e-9), "{k} {side} {piece}");
                }
            }
        }
    }
}
