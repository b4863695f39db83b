//! What a print costs, so that orders can be compared.

use glam::DVec3;

use crate::wireframe::lay::journal::{Entries, SAME};

/// A stroke that ends in the air takes as long as this much more of it, mm: its pause.
const PAUSE: f64 = 30.0;
/// The head travels so many times as fast as it prints …
const TRAVEL: f64 = 5.0;
/// … but to pull filament back, rise, sink and push it forward again takes as long as this, mm.
const HOP: f64 = 25.0;
/// A mm² of sag is worth this much strand, mm: a post where it takes some mm² away.
const SAG: f64 = 3.0;
/// A column is worth this much strand, mm: some slabs' zigzags around it.
const COLUMN: f64 = 500.0;

/// What to make least of, the gravest first.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Cost {
    /// Surface that is not printed, mm².
    pub area: f64,
    /// Length to print with pauses, travels, sag and wanted columns in the same coin, mm.
    pub whole: f64,
    /// The same without sag, mm.
    pub plain: f64,
}

/// What entries cost that begin where the head came from.
#[must_use]
pub fn cost(from: Option<DVec3>, entries: &Entries) -> Cost {
    let strands = &entries.strands;
    let area: f64 = entries.unprinted.iter().map(|part| part.area).sum();
    let ends = from.into_iter().chain(strands.iter().map(|s| s.to));
    let begins = strands.iter().skip(usize::from(from.is_none())).map(|s| s.from);
    let gaps = ends.zip(begins).map(|(end, begin)| end.distance(begin));
    let travels: f64 = gaps.filter(|&gap| gap > SAME).map(|gap| HOP + gap / TRAVEL).sum();
    let length: f64 =
        strands.iter().map(|s| s.from.distance(s.to) + if s.floating { PAUSE } else { 0.0 }).sum();
    let plain = length + travels + COLUMN * entries.columns.len() as f64;
    Cost { area: area.round(), whole: plain + SAG * entries.sag, plain }
}

#[cfg(test)]
mod tests;
