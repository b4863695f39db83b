//! The planes in order, and on which side of each of them a vertex lies.

use glam::DVec3;
use rayon::prelude::*;

use super::plane::{Plane, Side};

/// Cells of the look-up table per plane: enough that a cell rarely holds two planes.
const CELLS_PER_PLANE: usize = 4;

/// The distinct planes in the order of a sweep upwards.
pub(super) struct Ranks {
    /// Distinct planes, sorted by height, then side.
    pub planes: Vec<Plane>,
    /// For each plane asked for, its index in `planes`.
    pub position: Vec<u32>,
    cells: Vec<u32>,
    cells_per_mm: f64,
}

impl Ranks {
    /// Sorts the planes and drops repetitions.
    pub fn new(asked: &[Plane]) -> Self {
        let mut order: Vec<usize> = (0..asked.len()).collect();
        order.sort_by(|&i, &j| {
            asked[i].z.total_cmp(&asked[j].z).then(asked[i].side.cmp(&asked[j].side))
        });
        let mut planes: Vec<Plane> = Vec::with_capacity(asked.len());
        let mut position = vec![0; asked.len()];
        for i in order {
            if planes.last() != Some(&asked[i]) {
                planes.push(asked[i]);
            }
            position[i] = (planes.len() - 1) as u32;
        }
        let (cells, cells_per_mm) = table(&planes);
        Self { planes, position, cells, cells_per_mm }
    }

    /// How many planes each vertex lies above: it is above plane `k` where its rank exceeds `k`.
    pub fn ranks(&self, vertices: &[DVec3]) -> Vec<u32> {
        vertices.par_iter().with_min_len(1 << 13).map(|vertex| self.rank(vertex.z)).collect()
    }

    fn rank(&self, z: f64) -> u32 {
        let Some(first) = self.planes.first() else { return 0 };
        // The cast saturates: heights below the first plane fall in cell 0, NaN too.
        let cell = (((z - first.z) * self.cells_per_mm) as usize).min(self.cells.len() - 2);
        let (from, to) = (self.cells[cell] as usize, self.cells[cell + 1] as usize);
        let passed = self.planes[from..to].partition_point(|plane| is_above(z, plane));
        (from + passed) as u32
    }
}

/// Whether a vertex at height `z` counts as above the plane: the rule of [`Side`].
fn is_above(z: f64, plane: &Plane) -> bool {
    match plane.side {
        Side::Below => z >= plane.z,
        Side::Above => z > plane.z,
    }
}

/// For each of evenly spaced cells of height, the planes that a rank within it may come to.
///
/// Cell `i` holds the planes `cells[i]..cells[i + 1]`; a plane is put into its cell by the very
/// expression that looks a vertex up, which is monotone in z, so rounding cannot part the two.
fn table(planes: &[Plane]) -> (Vec<u32>, f64) {
    let (Some(first), Some(last)) = (planes.first(), planes.last()) else {
        return (vec![0, 0], 0.0);
    };
    let count = CELLS_PER_PLANE * planes.len();
    let scale = count as f64 / (last.z - first.z);
    let cells_per_mm = if scale.is_finite() { scale } else { 0.0 };
    let mut cells = vec![0; count + 2];
    for plane in planes {
        let cell = (((plane.z - first.z) * cells_per_mm) as usize).min(count);
        cells[cell + 1] += 1;
    }
    for i in 0..=count {
        cells[i + 1] += cells[i];
    }
    (cells, cells_per_mm)
}
