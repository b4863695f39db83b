//! The compliance of open nodes: how each moves under forces on any of them.

use rayon::prelude::*;

use super::six::{Six, ZERO, inverse};

/// From so many rows on, an update is shared by all threads.
const SHARED: usize = 384;

/// Rows that a thread updates at a time.
const ROWS: usize = 32;

/// Six rows over all open nodes.
type Rows = [Vec<f64>; 6];

/// Compliance matrix of the open nodes, six rows and columns each, by slots that are used again.
/// Only what lies on and below the diagonal is kept up.
#[derive(Debug, Default)]
pub(super) struct Compliance {
    values: Vec<f64>,
    /// Slots that there is room for.
    room: usize,
    /// Free slots below `end`, the lowest last.
    free: Vec<u32>,
    /// Slots from here on are not in use.
    end: u32,
}

impl Compliance {
    /// Room for so many nodes that are open at a time.
    pub(super) fn with_room(nodes: usize) -> Self {
        let stride = 6 * nodes;
        Self { values: vec![0.0; stride * stride], room: nodes, ..Self::default() }
    }

    /// Memory that takes, bytes.
    pub(super) fn bytes(nodes: usize) -> u64 {
        let stride = 6 * nodes as u64;
        stride.saturating_mul(stride).saturating_mul(size_of::<f64>() as u64)
    }

    /// Number of rows in use.
    pub(super) fn rows(&self) -> usize {
        6 * self.end as usize
    }

    fn stride(&self) -> usize {
        6 * self.room
    }

    /// Rows of a slot, or of nothing that moves, over all columns.
    fn rows_of(&self, slot: Option<u32>) -> Rows {
        let (n, stride) = (self.rows(), self.stride());
        std::array::from_fn(|k| {
            let Some(slot) = slot else { return vec![0.0; n] };
            let row = 6 * slot as usize + k;
            let left = &self.values[row * stride..row * stride + row + 1];
            let below = (row + 1..n).map(|other| self.values[other * stride + row]);
            left.iter().copied().chain(below).collect()
        })
    }

    /// A slot's own block.
    pub(super) fn block(&self, slot: u32) -> Six {
        let (first, stride) = (6 * slot as usize, self.stride());
        std::array::from_fn(|i| {
            std::array::from_fn(|j| self.values[(first + i.max(j)) * stride + first + i.min(j)])
        })
    }

    /// Opens a node at the free end of a beam from an open node, or from one that does not move.
    pub(super) fn open(&mut self, from: Option<u32>, transport: &Six, flexibility: &Six) -> u32 {
        let slot = self.take();
        let mut carried = times(transport, &self.rows_of(from));
        let mut own = times_transposed(&carried, from, transport);
        for (own, flexible) in own.as_flattened_mut().iter_mut().zip(flexibility.as_flattened()) {
            *own += flexible;
        }
        let (first, n, stride) = (6 * slot as usize, self.rows(), self.stride());
        for (k, row) in carried.iter_mut().enumerate() {
            row[first..first + 6].copy_from_slice(&own[k]);
            let at = (first + k) * stride;
            self.values[at..at + first + 6].copy_from_slice(&row[..first + 6]);
            for (other, &value) in row.iter().enumerate().take(n).skip(first + 6) {
                self.values[other * stride + first + k] = value;
            }
        }
        slot
    }

    /// Joins the end of a beam from one node to another; None for a node that does not move.
    ///
    /// An update of rank six in Joseph's symmetric form, which keeps the matrix positive where the
    /// plain one loses all digits: with `R = B·C` and `M = f + R·Bᵀ`, `K = M⁻¹·R` and
    /// `U = R − ½·M·K`, `C` becomes `C − Kᵀ·U − Uᵀ·K`.
    pub(super) fn close(
        &mut self,
        from: Option<u32>,
        to: Option<u32>,
        transport: &Six,
        flexibility: &Six,
    ) {
        let carried = times(transport, &self.rows_of(from));
        let mut gap = self.rows_of(to);
        for (gap, carried) in gap.iter_mut().zip(&carried) {
            gap.iter_mut().zip(carried).for_each(|(gap, carried)| *gap -= carried);
        }
        let own = to.map_or(ZERO, |slot| columns(&gap, slot));
        let other = times_transposed(&gap, from, transport);
        let middle: Six = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let [a, b] = [[i, j], [j, i]].map(|[i, j]| own[i][j] - other[i][j]);
                flexibility[i][j] + a.midpoint(b)
            })
        });
        let Some(solved) = inverse(&middle) else { return };
        let gain = times(&solved, &gap);
        let half: Six = middle.map(|row| row.map(|value| value / 2.0));
        let mut rest = times(&half, &gain);
        for (rest, gap) in rest.iter_mut().zip(&gap) {
            rest.iter_mut().zip(gap).for_each(|(rest, gap)| *rest = gap - *rest);
        }
        self.update(&gain, &rest);
    }

    /// Subtracts `Kᵀ·U + Uᵀ·K`.
    fn update(&mut self, gain: &Rows, rest: &Rows) {
        let (n, stride) = (self.rows(), self.stride());
        let rows = |(chunk, values): (usize, &mut [f64])| {
            for (row, values) in (ROWS * chunk..n).zip(values.chunks_mut(stride)) {
                subtract(&mut values[..=row], row, gain, rest);
            }
        };
        let all = &mut self.values[..n * stride];
        if n < SHARED {
            all.chunks_mut(ROWS * stride).enumerate().for_each(rows);
        } else {
            all.par_chunks_mut(ROWS * stride).enumerate().for_each(rows);
        }
    }

    /// Gives a node's slot back.
    pub(super) fn drop(&mut self, slot: u32) {
        let place = self.free.partition_point(|&free| free > slot);
        self.free.insert(place, slot);
        while self.free.first().is_some_and(|&last| last + 1 == self.end) {
            self.free.remove(0);
            self.end -= 1;
        }
    }

    /// Takes the lowest free slot.
    fn take(&mut self) -> u32 {
        if let Some(slot) = self.free.pop() {
            return slot;
        }
        self.end += 1;
        self.end - 1
    }
}

/// Six rows times a matrix from the left.
fn times(matrix: &Six, rows: &Rows) -> Rows {
    std::array::from_fn(|i| {
        let mut sum = vec![0.0; rows[0].len()];
        for (&factor, row) in matrix[i].iter().zip(rows) {
            if factor != 0.0 {
                sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += factor * value);
            }
        }
        sum
    })
}

/// The columns of a slot.
fn columns(rows: &Rows, slot: u32) -> Six {
    let first = 6 * slot as usize;
    std::array::from_fn(|i| std::array::from_fn(|j| rows[i][first + j]))
}

/// The columns of a slot times a transposed matrix; nothing where the slot is.
fn times_transposed(rows: &Rows, slot: Option<u32>, matrix: &Six) -> Six {
    let Some(slot) = slot else { return ZERO };
    let own = columns(rows, slot);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| own[i].iter().zip(&matrix[j]).map(|(a, b)| a * b).sum())
    })
}

/// Subtracts row `row` of `Kᵀ·U + Uᵀ·K` up to the diagonal.
fn subtract(values: &mut [f64], row: usize, gain: &Rows, rest: &Rows) {
    let n = values.len();
    let [k0, k1, k2, k3, k4, k5] = std::array::from_fn(|k| &gain[k][..n]);
    let [u0, u1, u2, u3, u4, u5] = std::array::from_fn(|k| &rest[k][..n]);
    let a: [f64; 6] = std::array::from_fn(|k| gain[k][row]);
    let b: [f64; 6] = std::array::from_fn(|k| rest[k][row]);
    for j in 0..n {
        let first = a[0] * u0[j] + a[1] * u1[j] + a[2] * u2[j] + a[3] * u3[j];
        let second = a[4] * u4[j] + a[5] * u5[j] + b[0] * k0[j] + b[1] * k1[j];
        let third = b[2] * k2[j] + b[3] * k3[j] + b[4] * k4[j] + b[5] * k5[j];
        values[j] -= first + second + third;
    }
}
