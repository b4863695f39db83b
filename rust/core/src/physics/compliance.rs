//! The compliance of open nodes: how each moves under forces on any of them.

use ndarray::linalg::general_mat_mul;
use ndarray::{ArrayView2, ArrayViewMut2, Axis, Slice};
use rayon::prelude::*;

use super::six::{Six, ZERO, identity, lower_factor, solve_lower};

/// Loops that are closed before the matrix is written anew: their rows fit beside the blocks of
/// it that they change, and reading past so many is cheap against that.
const PENDING_LOOPS: usize = 12;
/// Rows of a panel of them.
const PENDING_ROWS: usize = 6 * PENDING_LOOPS;

/// From so many rows on, a matrix is written anew by all threads.
const SHARED: usize = 384;

/// Rows that a thread writes anew at a time.
const ROWS: usize = 96;

/// Six rows over all open nodes.
type Rows = [Vec<f64>; 6];

/// Compliance matrix of the open nodes, six rows and columns each, by slots without a gap.
///
/// Closing a loop subtracts a product of rank six, `Gᵀ·G`. Those of some loops wait in a panel and
/// are subtracted together, which is one product of matrices instead of many of vectors.
#[derive(Debug, Default)]
pub(super) struct Compliance {
    /// What was there before the loops that wait; of it only what lies on and below the diagonal.
    values: Vec<f64>,
    /// `G` of the loops that wait, by rows.
    panel: Vec<f64>,
    /// Rows of the panel that are in use.
    waiting: usize,
    /// Slots that there is room for.
    room: usize,
    /// Slots in use.
    slots: usize,
}

impl Compliance {
    /// Room for so many nodes that are open at a time.
    pub(super) fn with_room(nodes: usize) -> Self {
        let stride = 6 * nodes;
        let (values, panel) = (vec![0.0; stride * stride], vec![0.0; PENDING_ROWS * stride]);
        Self { values, panel, room: nodes, ..Self::default() }
    }

    /// Memory that takes, bytes.
    pub(super) fn bytes(nodes: usize) -> u64 {
        let stride = 6 * nodes as u64;
        let numbers = stride.saturating_mul(stride + PENDING_ROWS as u64);
        numbers.saturating_mul(size_of::<f64>() as u64)
    }

    /// Number of rows in use.
    fn rows(&self) -> usize {
        6 * self.slots
    }

    fn stride(&self) -> usize {
        6 * self.room
    }

    /// Row of the panel, over the columns in use.
    fn waiting(&self, row: usize) -> &[f64] {
        &self.panel[row * self.stride()..][..self.rows()]
    }

    /// Rows of a slot, or of nothing that moves, over all columns, without the loops that wait.
    fn stored(&self, slot: Option<u32>) -> Rows {
        let (n, stride) = (self.rows(), self.stride());
        let mut rows: Rows = std::array::from_fn(|_| vec![0.0; n]);
        let Some(slot) = slot else { return rows };
        let first = 6 * slot as usize;
        for (k, row) in rows.iter_mut().enumerate() {
            let own = first + k;
            row[..=own].copy_from_slice(&self.values[own * stride..][..=own]);
        }
        for other in first + 1..n {
            let below = &self.values[other * stride + first..][..6.min(other - first)];
            rows.iter_mut().zip(below).for_each(|(row, &value)| row[other] = value);
        }
        rows
    }

    /// The sum of matrices times the rows of slots, less what the loops wait with.
    fn combined(&self, parts: &[(Option<u32>, &Six)]) -> Rows {
        let mut sum: Rows = std::array::from_fn(|_| vec![0.0; self.rows()]);
        for &(slot, matrix) in parts.iter().filter(|part| part.0.is_some()) {
            add_product(&mut sum, matrix, &self.stored(slot));
        }
        for waiting in 0..self.waiting {
            let waiting = self.waiting(waiting);
            let mut factors = [0.0; 6];
            for &(slot, matrix) in parts {
                let Some(slot) = slot else { continue };
                let own = &waiting[6 * slot as usize..][..6];
                for (factor, row) in factors.iter_mut().zip(matrix) {
                    *factor += row.iter().zip(own).map(|(a, b)| a * b).sum::<f64>();
                }
            }
            for (sum, factor) in sum.iter_mut().zip(factors) {
                sum.iter_mut().zip(waiting).for_each(|(sum, value)| *sum -= factor * value);
            }
        }
        sum
    }

    /// A slot's own block.
    pub(super) fn block(&self, slot: u32) -> Six {
        let (first, stride) = (6 * slot as usize, self.stride());
        let mut block: Six = std::array::from_fn(|i| {
            std::array::from_fn(|j| self.values[(first + i.max(j)) * stride + first + i.min(j)])
        });
        for waiting in 0..self.waiting {
            let own = &self.waiting(waiting)[first..first + 6];
            for (row, a) in block.iter_mut().zip(own) {
                row.iter_mut().zip(own).for_each(|(value, b)| *value -= a * b);
            }
        }
        block
    }

    /// Opens a node at the free end of a beam from an open node, or from one that does not move,
    /// in the next slot.
    pub(super) fn open(&mut self, from: Option<u32>, transport: &Six, flexibility: &Six) -> u32 {
        let carried = self.combined(&[(from, transport)]);
        let mut own = times_transposed(&carried, from, transport);
        for (own, flexible) in own.as_flattened_mut().iter_mut().zip(flexibility.as_flattened()) {
            *own += flexible;
        }
        let (first, stride) = (self.rows(), self.stride());
        for (k, (row, own)) in carried.iter().zip(own).enumerate() {
            let place = &mut self.values[(first + k) * stride..][..first + 6];
            place[..first].copy_from_slice(row);
            place[first..].copy_from_slice(&own);
        }
        // What waits does not concern what was made after it.
        for waiting in 0..self.waiting {
            self.panel[waiting * stride + first..][..6].fill(0.0);
        }
        self.slots += 1;
        (self.slots - 1) as u32
    }

    /// Joins the end of a beam from one node to another; None for a node that does not move.
    ///
    /// With `R = B·C`, by which the gap between them closes under forces on any node, and
    /// `M = f + R·Bᵀ = L·Lᵀ`, `C` becomes `C − Gᵀ·G` with `G = L⁻¹·R`. That is symmetric whatever
    /// is rounded, which the same with an inverse of `M` is not: it loses all digits.
    pub(super) fn close(
        &mut self,
        from: Option<u32>,
        to: Option<u32>,
        transport: &Six,
        flexibility: &Six,
    ) {
        if self.waiting == PENDING_ROWS {
            self.settle();
        }
        let carried = transport.map(|row| row.map(|value| -value));
        let mut gap = self.combined(&[(to, &identity()), (from, &carried)]);
        let own = to.map_or(ZERO, |slot| columns(&gap, slot));
        let other = times_transposed(&gap, from, transport);
        let middle: Six = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let [a, b] = [[i, j], [j, i]].map(|[i, j]| own[i][j] - other[i][j]);
                flexibility[i][j] + a.midpoint(b)
            })
        });
        let Some(lower) = lower_factor(&middle) else { return };
        solve_lower(&lower, &mut gap);
        let (n, stride) = (self.rows(), self.stride());
        for (k, row) in gap.iter().enumerate() {
            self.panel[(self.waiting + k) * stride..][..n].copy_from_slice(row);
        }
        self.waiting += 6;
    }

    /// Subtracts what the loops wait with.
    fn settle(&mut self) {
        let (n, stride) = (self.rows(), self.stride());
        let panel = &self.panel[..self.waiting * stride];
        let settle = |(chunk, values): (usize, &mut [f64])| {
            let first = chunk * ROWS;
            let last = n.min(first + ROWS);
            let shape = (last - first, stride);
            let all = ArrayView2::from_shape((panel.len() / stride, stride), panel);
            if let (Ok(all), Ok(mut own)) = (all, ArrayViewMut2::from_shape(shape, values)) {
                let [left, right] =
                    [first, 0].map(|from| all.slice_axis(Axis(1), Slice::from(from..last)));
                let mut own = own.slice_axis_mut(Axis(1), Slice::from(..last));
                general_mat_mul(-1.0, &left.t(), &right, 1.0, &mut own);
            }
        };
        let values = &mut self.values[..n * stride];
        if n < SHARED {
            values.chunks_mut(ROWS * stride).enumerate().for_each(settle);
        } else {
            values.par_chunks_mut(ROWS * stride).enumerate().for_each(settle);
        }
        self.waiting = 0;
    }

    /// Gives a node's slot back: the node of the last slot moves there.
    pub(super) fn drop(&mut self, slot: u32) {
        let Some(last) = self.slots.checked_sub(1) else { return };
        let (first, from, stride) = (6 * slot as usize, 6 * last, self.stride());
        if first < from {
            let moved = self.values[from * stride..(from + 6) * stride].to_vec();
            for (k, row) in moved.chunks(stride).enumerate() {
                let own = (first + k) * stride;
                self.values[own..own + first].copy_from_slice(&row[..first]);
                self.values[own + first..own + first + 6].copy_from_slice(&row[from..from + 6]);
                for (other, &value) in row.iter().enumerate().take(from).skip(first + 6) {
                    self.values[other * stride + first + k] = value;
                }
            }
            for waiting in 0..self.waiting {
                let row = waiting * stride;
                self.panel.copy_within(row + from..row + from + 6, row + first);
            }
        }
        self.slots = last;
    }
}

/// Adds six rows times a matrix from the left.
fn add_product(sum: &mut Rows, matrix: &Six, rows: &Rows) {
    for (sum, factors) in sum.iter_mut().zip(matrix) {
        for (&factor, row) in factors.iter().zip(rows) {
            if factor != 0.0 {
                sum.iter_mut().zip(row).for_each(|(sum, value)| *sum += factor * value);
            }
        }
    }
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
