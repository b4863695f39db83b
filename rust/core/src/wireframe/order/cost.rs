//! What a print costs, so that orders can be compared.

use glam::DVec3;

use crate::wireframe::lay::journal::{Entries, SAME};
use crate::wireframe::params::Times;

/// Sag over a strand's diameter is worth so many times its length of strand: a post where it takes some
/// mm² away. Doubled, orders are taken that follow the model more closely, and print for longer.
const SAG: f64 = 2.0;
/// A column is worth a strand of so many diameters: some slabs' zigzags around it. Doubled, orders
/// are taken that need fewer columns, whatever they cost.
const COLUMN: f64 = 700.0;

/// What to make least of, the gravest first.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Cost {
    /// Surface that is not printed, mm².
    pub area: f64,
    /// Time to print with sag and wanted columns in the same coin, s.
    pub whole: f64,
    /// The same without sag, s.
    pub plain: f64,
}

/// What entries of strands with some diameter, mm, cost that begin where the head came from.
#[must_use]
pub fn cost(from: Option<DVec3>, entries: &Entries, strand: f64, times: &Times) -> Cost {
    let strands = &entries.strands;
    let area = entries.left_out();
    let ends = from.into_iter().chain(strands.iter().map(|s| s.to));
    let begins = strands.iter().skip(usize::from(from.is_none())).map(|s| s.from);
    let gaps = ends.zip(begins).map(|(end, begin)| end.distance(begin));
    let travels: f64 =
        gaps.filter(|&gap| gap > SAME).map(|gap| times.hop + gap / times.travel_speed).sum();
    let pauses = strands.iter().filter(|s| s.floating).count() as f64 * times.pause;
    let length: f64 = strands.iter().map(|s| s.from.distance(s.to)).sum();
    let columns = COLUMN * strand * entries.columns.len() as f64;
    let plain = (length + columns) / times.print_speed + pauses + travels;
    Cost {
        area: area.round(),
        whole: plain + SAG * entries.sag / strand / times.print_speed,
        plain,
    }
}

#[cfg(test)]
mod tests;
