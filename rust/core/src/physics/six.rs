//! Matrices of six: three shifts and three turns.

use glam::DVec3;

/// A matrix by rows.
pub(super) type Six = [[f64; 6]; 6];

pub(super) const ZERO: Six = [[0.0; 6]; 6];

pub(super) fn identity() -> Six {
    let mut one = ZERO;
    for (i, row) in one.iter_mut().enumerate() {
        row[i] = 1.0;
    }
    one
}

/// The matrix of the cross product with a vector.
pub(super) fn skew(v: DVec3) -> [[f64; 3]; 3] {
    [[0.0, -v.z, v.y], [v.z, 0.0, -v.x], [-v.y, v.x, 0.0]]
}

/// The lower Cholesky factor of a symmetric positive matrix; None where it is none.
pub(super) fn lower_factor(matrix: &Six) -> Option<Six> {
    let mut lower = ZERO;
    for i in 0..6 {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = matrix[i][j] - sum;
            lower[i][j] = if i == j { rest.sqrt() } else { rest / lower[j][j] };
        }
        if !(lower[i][i] > 0.0 && lower[i][i].is_finite()) {
            return None;
        }
    }
    Some(lower)
}

/// The product of two matrices.
pub(super) fn product(a: &Six, b: &Six) -> Six {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| a[i][k] * b[k][j]).sum()))
}

/// A matrix, its rows as columns.
pub(super) fn transposed(a: &Six) -> Six {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// Six rows times the inverse of a lower triangular matrix, from the left.
pub(super) fn solve_lower(lower: &Six, rows: &mut [Vec<f64>; 6]) {
    for (i, factors) in lower.iter().enumerate() {
        let (known, rest) = rows.split_at_mut(i);
        let Some(own) = rest.first_mut() else { return };
        for (&factor, row) in factors.iter().zip(known) {
            own.iter_mut().zip(row.iter()).for_each(|(own, value)| *own -= factor * value);
        }
        own.iter_mut().for_each(|own| *own /= factors[i]);
    }
}

/// Sweeps after which a symmetric matrix of three is diagonal to the last digit.
const SWEEPS: usize = 8;

/// The greatest eigenvalue of the symmetric 3 × 3 block in the corner, by Jacobi's rotations: they
/// are exact where two eigenvalues are alike, as those of an upright post, and closed forms are not.
pub(super) fn greatest_of_shifts(m: &Six) -> f64 {
    let mut a: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|j| m[i][j]));
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            let sine = tangent * cosine;
            for row in &mut a {
                (row[p], row[q]) =
                    (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
            }
            let (above, below) = (a[p], a[q]);
            a[p] = std::array::from_fn(|k| cosine * above[k] - sine * below[k]);
            a[q] = std::array::from_fn(|k| sine * above[k] + cosine * below[k]);
        }
    }
    a[0][0].max(a[1][1]).max(a[2][2])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A symmetric matrix whose eigenvalues of shifts are those given.
    fn turned(values: [f64; 3]) -> Six {
        let axes = [DVec3::new(1.0, 2.0, 3.0), DVec3::new(3.0, 0.0, -1.0)].map(DVec3::normalize);
        let axes = [axes[0], axes[1], axes[0].cross(axes[1])].map(|axis| axis.to_array());
        let entry = |i: usize, j: usize| (0..3).map(|k| values[k] * axes[k][i] * axes[k][j]).sum();
        std::array::from_fn(|i| {
            std::array::from_fn(|j| if i.max(j) < 3 { entry(i, j) } else { 0.0 })
        })
    }

    fn product(a: &Six, b: &Six) -> Six {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| a[i][k] * b[k][j]).sum()))
    }

    #[test]
    fn the_greatest_eigenvalue_is_exact_also_where_two_are_alike() {
        for values in [[3.0, 2.0, 1.0], [5.0, 5.0, 1e-4], [2.0, 7.0, 2.0], [1.0, 1.0, 1.0]] {
            let greatest = values.iter().copied().fold(0.0, f64::max);
            assert!((greatest_of_shifts(&turned(values)) / greatest - 1.0).abs() < 1e-14);
        }
        assert!(greatest_of_shifts(&ZERO).abs() < 1e-300);
    }

    #[test]
    fn a_factor_makes_its_matrix_and_solving_undoes_it() {
        let one = identity();
        let six: Six = std::array::from_fn(|i| {
            std::array::from_fn(|j| one[i][j] + 1.0 / f64::from((1 + i + j) as u32))
        });
        let lower = lower_factor(&six).unwrap();
        let turned: Six = std::array::from_fn(|i| std::array::from_fn(|j| lower[j][i]));
        let found = product(&lower, &turned);
        let alike = |a: &Six, b: &Six| {
            a.as_flattened().iter().zip(b.as_flattened()).all(|(a, b)| (a - b).abs() < 1e-14)
        };
        assert!(alike(&found, &six), "{found:?}");
        let mut rows = lower.map(|row| row.to_vec());
        solve_lower(&lower, &mut rows);
        let solved: Six = std::array::from_fn(|i| std::array::from_fn(|j| rows[i][j]));
        assert!(alike(&solved, &one), "{solved:?}");
        assert!(lower_factor(&ZERO).is_none());
    }
}
