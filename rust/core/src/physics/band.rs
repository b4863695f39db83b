//! Symmetric systems of equations whose entries lie near the diagonal.

/// Entries kept on each side of the diagonal: what two nodes of three unknowns each couple.
const REACH: usize = 5;

/// A symmetric matrix by rows, from the diagonal leftwards.
#[derive(Debug, Clone, Default)]
pub(super) struct Band {
    rows: Vec<[f64; REACH + 1]>,
}

impl Band {
    /// A matrix of zeros.
    pub(super) fn zeros(n: usize) -> Self {
        Self { rows: vec![[0.0; REACH + 1]; n] }
    }

    /// Adds to an entry and to the one opposite; what lies above the diagonal is ignored.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64) {
        if column <= row {
            self.rows[row][row - column] += value;
        }
    }

    /// Holds an unknown at zero.
    pub(super) fn hold(&mut self, unknown: usize) {
        self.rows[unknown] = [0.0; REACH + 1];
        self.rows[unknown][0] = 1.0;
        for (back, row) in self.rows[unknown..].iter_mut().enumerate().take(REACH + 1).skip(1) {
            row[back] = 0.0;
        }
    }

    /// Solves for a right side, in its place, by `L·D·Lᵀ`; false where that breaks down.
    pub(super) fn solve(mut self, right: &mut [f64]) -> bool {
        for i in 0..self.rows.len() {
            let reach = REACH.min(i);
            for back in (1..=reach).rev() {
                let j = i - back;
                let mut sum = self.rows[i][back];
                for k in back + 1..=reach.min(back + REACH) {
                    let common = i - k;
                    sum -= self.rows[i][k] * self.rows[j][j - common] * self.rows[common][0];
                }
                self.rows[i][back] = sum / self.rows[j][0];
            }
            for back in 1..=reach {
                let factor = self.rows[i][back];
                self.rows[i][0] -= factor * factor * self.rows[i - back][0];
                right[i] -= factor * right[i - back];
            }
            if !self.rows[i][0].is_normal() {
                return false;
            }
        }
        for i in (0..self.rows.len()).rev() {
            right[i] /= self.rows[i][0];
            for (back, row) in self.rows[i..].iter().enumerate().take(REACH + 1).skip(1) {
                right[i] -= row[back] * right[i + back];
            }
        }
        right.iter().all(|value| value.is_finite())
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_solution_gives_the_right_side(
            entries in prop::collection::vec(-1.0..1.0_f64, 6 * 12),
            right in prop::collection::vec(-1.0..1.0_f64, 12),
        ) {
            let mut band = Band::zeros(12);
            let mut full = [[0.0; 12]; 12];
            for i in 0..12_usize {
                for j in i.saturating_sub(REACH)..=i {
                    let value = entries[6 * i + i - j] + if i == j { 12.0 } else { 0.0 };
                    band.add(i, j, value);
                    full[i][j] = value;
                    full[j][i] = value;
                }
            }
            let mut found = right.clone();
            prop_assert!(band.solve(&mut found));
            for (row, right) in full.iter().zip(&right) {
                let sum: f64 = row.iter().zip(&found).map(|(a, x)| a * x).sum();
                prop_assert!((sum - right).abs() < 1e-12);
            }
        }
    }
}
