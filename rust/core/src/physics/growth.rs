//! The frame while it grows: how far each post's peak gives way when it has just been laid.
//!
//! Beams are added in the order of printing. Kept is the compliance of those nodes alone that
//! later beams will touch: a free end adds a node, an end that meets another closes a loop.

use glam::DVec3;

use super::beam::{Section, transport};
use super::compliance::Compliance;
use super::frame::{Beam, Frame, contacts};
use super::six::greatest_of_shifts;
use crate::check::deposit::Deposit;
use crate::check::reading::{Macros, Reading};
use crate::check::rules::Rules;
use crate::error::Result;
use crate::gcode::machine::MachineSettings;
use crate::memory;

/// Labels of strands that carry nothing.
const ASIDE: [&str; 3] = ["skirt", "brim", "prime"];

/// What strands are made of, and how much work may be spent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elastic {
    /// Young's modulus of the cold material, MPa.
    pub modulus: f64,
    /// Floating-point operations after which a print is not judged.
    pub most_work: f64,
}

/// The peak of a post, when it has just been laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Line of the stroke that ends there.
    pub line: u64,
    /// Where it is, mm.
    pub at: DVec3,
    /// How far a force moves it, whatever the force's direction, mm/N.
    pub compliance: f64,
}

/// What was found about a print while it grows.
#[derive(Debug, Clone, Default)]
pub struct Growth {
    /// The posts' peaks, in the order of printing.
    pub peaks: Vec<Peak>,
    /// Whether it was judged: it is not where that would take too much work.
    pub judged: bool,
    /// Floating-point operations that it takes, about.
    pub work: f64,
}

/// Lets a G-code text grow, and tells how far the peaks of its posts give way.
///
/// A **post's peak** is where a stroke ends that rises by half a strand or more, touches nothing
/// there, and is not carried on upwards.
///
/// # Errors
/// [`CoreError::Memory`](crate::CoreError::Memory) where more of its ends are loose at a time than
/// the memory that is allowed has room for.
pub fn grow_text(
    text: &[u8],
    settings: MachineSettings,
    macros: &Macros,
    rules: &Rules,
    elastic: &Elastic,
) -> Result<Growth> {
    let read = Reading::of(text, settings, macros, rules.coldest);
    let deposit = Deposit::of(&read.notes.moves, &read.notes.dwells, &rules.bed);
    let counts = carrying(&read.features, &deposit);
    let counts = |strand: usize| counts[strand];
    let frame = Frame::of(&deposit, rules, contacts(&deposit, rules, counts), counts).on_the_bed();
    let open = Opening::of(&frame);
    let Effort { work, most_open } = open.effort(&frame);
    if work > elastic.most_work {
        return Ok(Growth { peaks: Vec::new(), judged: false, work });
    }
    memory::claim(Compliance::bytes(most_open), || format!("a frame with {most_open} loose ends"))?;
    let section = Section::new(rules.strand, elastic.modulus);
    let mut peaks = Vec::new();
    grow(&frame, &open, most_open, section, |laid| {
        if let Some(compliance) = laid.tip
            && rises(&deposit, laid.strand, rules.tolerance())
        {
            let (line, [_, at]) = (deposit.lines[laid.strand], deposit.strands[laid.strand]);
            peaks.push(Peak { line, at, compliance });
        }
    });
    Ok(Growth { peaks, judged: true, work })
}

/// For each strand, whether it carries anything, by the labels of a text.
pub(super) fn carrying(labels: &[String], deposit: &Deposit) -> Vec<bool> {
    let aside: Vec<bool> = labels.iter().map(|name| ASIDE.contains(&name.as_str())).collect();
    let is_aside = |&feature: &u16| aside.get(usize::from(feature)).copied().unwrap_or(false);
    deposit.features.iter().map(|feature| !is_aside(feature)).collect()
}

/// A strand that has just been laid, and how far things give way where it ends, mm/N.
#[derive(Debug, Clone, Copy)]
pub(super) struct Laid {
    pub strand: usize,
    /// Its own end, if that is new and hangs freely.
    pub tip: Option<f64>,
    /// The softest place that it met, before it held it.
    pub met: Option<f64>,
}

/// Whether a strand rises by `least` mm and its chain goes on no higher.
pub(super) fn rises(deposit: &Deposit, strand: usize, least: f64) -> bool {
    let rise = |[from, to]: [DVec3; 2]| to.z - from.z;
    let next = strand + 1;
    let goes_on = deposit.links.get(next).is_some_and(|link| {
        link.chain == deposit.links[strand].chain && rise(deposit.strands[next]) > 0.0
    });
    rise(deposit.strands[strand]) >= least && !goes_on
}

/// What a print's growth takes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Effort {
    /// Floating-point operations.
    pub work: f64,
    /// Nodes that are open at a time.
    pub most_open: usize,
}

/// Until when each node is open, and how the beams of each strand follow.
pub(super) struct Opening {
    /// The last strand that touches each node.
    last: Vec<u32>,
}

impl Opening {
    pub(super) fn of(frame: &Frame) -> Self {
        let mut last = vec![0; frame.places.len()];
        for &Beam { from, to, strand } in &frame.beams {
            for node in [from, to] {
                let last = &mut last[node as usize];
                *last = strand.max(*last);
            }
        }
        Self { last }
    }

    /// What it takes: 6 floating-point operations for each pair of rows of a loop that closes.
    pub(super) fn effort(&self, frame: &Frame) -> Effort {
        let mut seen = frame.fixed.clone();
        let mut opened = Vec::new();
        let mut effort = Effort::default();
        for beams in frame.beams.chunk_by(|a, b| a.strand == b.strand) {
            for &Beam { from, to, .. } in beams {
                let [a, b] = [from, to].map(|node| seen[node as usize]);
                let rows = 6.0 * opened.len() as f64;
                effort.work += if a && b { 6.0 * rows * rows } else { 24.0 * rows };
                for node in [from, to] {
                    if !std::mem::replace(&mut seen[node as usize], true) {
                        opened.push(node);
                    }
                }
            }
            effort.most_open = effort.most_open.max(opened.len());
            opened.retain(|&node| self.last[node as usize] > beams[0].strand);
        }
        effort
    }
}

/// Adds the beams one after the other; `told` is told each strand when it has just been laid.
pub(super) fn grow(
    frame: &Frame,
    open: &Opening,
    most_open: usize,
    section: Section,
    mut told: impl FnMut(Laid),
) {
    let mut compliance = Compliance::with_room(most_open);
    let mut slots: Vec<Option<u32>> = vec![None; frame.places.len()];
    // The node in each slot.
    let mut opened: Vec<usize> = Vec::new();
    for beams in frame.beams.chunk_by(|a, b| a.strand == b.strand) {
        let strand = beams[0].strand;
        let mut tip = None;
        let mut met: Option<f64> = None;
        for beam in beams {
            let [from, to] = [beam.from as usize, beam.to as usize];
            let is_held = |node: usize| frame.fixed[node] || slots[node].is_some();
            // A beam is laid from what holds it; one that nothing holds is loose, and left out.
            let (from, to) = if is_held(from) { (from, to) } else { (to, from) };
            if !is_held(from) {
                continue;
            }
            let run = frame.places[to] - frame.places[from];
            let (transport, flexibility) = (transport(run), section.flexibility(run));
            if is_held(to) {
                if let Some(slot) = slots[to] {
                    let gives = greatest_of_shifts(&compliance.block(slot));
                    met = Some(met.map_or(gives, |most| most.max(gives)));
                }
                compliance.close(slots[from], slots[to], &transport, &flexibility);
                tip = None;
            } else {
                slots[to] = Some(compliance.open(slots[from], &transport, &flexibility));
                opened.push(to);
                tip = Some(to);
            }
        }
        let end = frame.ends[strand as usize].map(|[_, end]| end as usize);
        let tip = tip.filter(|&node| Some(node) == end).and_then(|node| slots[node]);
        let tip = tip.map(|slot| greatest_of_shifts(&compliance.block(slot)));
        told(Laid { strand: strand as usize, tip, met });
        for slot in (0..opened.len()).rev() {
            if open.last[opened[slot]] > strand {
                continue;
            }
            compliance.drop(slot as u32);
            slots[opened.swap_remove(slot)] = None;
            if let Some(&moved) = opened.get(slot) {
                slots[moved] = Some(slot as u32);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::super::six::{Six, identity, lower_factor, solve_lower};
    use super::*;

    fn inverse(matrix: &Six) -> Six {
        let lower = lower_factor(matrix).unwrap();
        let mut rows = identity().map(|row| row.to_vec());
        solve_lower(&lower, &mut rows);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..6).map(|k| rows[k][i] * rows[k][j]).sum())
        })
    }

    /// Shifts of a node of a frame under unit forces there, by Gauss on the whole stiffness matrix.
    fn direct(frame: &Frame, beams: &[Beam], section: Section, node: usize) -> Six {
        let n = 6 * frame.places.len();
        let mut rows = vec![vec![0.0; n + 6]; n];
        for &Beam { from, to, .. } in beams {
            let [a, b] = [from, to].map(|node| node as usize);
            let run = frame.places[b] - frame.places[a];
            let stiff = inverse(&section.flexibility(run));
            let carried = transport(run);
            // The beam is strained by how far its end is off where its start carries it.
            let strain: [[f64; 12]; 6] = std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    if j < 6 { -carried[i][j] } else { f64::from(u8::from(i == j - 6)) }
                })
            });
            let at = |i: usize| if i < 6 { 6 * a + i } else { 6 * b + i - 6 };
            for i in 0..12 {
                for j in 0..12 {
                    for k in 0..6 {
                        for l in 0..6 {
                            rows[at(i)][at(j)] += strain[k][i] * stiff[k][l] * strain[l][j];
                        }
                    }
                }
            }
        }
        let touched = |node: usize| {
            beams.iter().any(|beam| beam.from as usize == node || beam.to as usize == node)
        };
        for i in (0..n).filter(|i| frame.fixed[i / 6] || !touched(i / 6)) {
            rows[i].fill(0.0);
            rows.iter_mut().for_each(|row| row[i] = 0.0);
            rows[i][i] = 1.0;
        }
        for k in 0..6 {
            rows[6 * node + k][n + k] = 1.0;
        }
        for column in 0..n {
            let best = (column..n)
                .max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()));
            rows.swap(column, best.unwrap());
            let pivot = rows[column].clone();
            for (i, row) in rows.iter_mut().enumerate() {
                let factor = row[column] / pivot[column];
                if i != column && factor != 0.0 {
                    row.iter_mut().zip(&pivot).for_each(|(value, pivot)| *value -= factor * pivot);
                }
            }
        }
        std::array::from_fn(|i| {
            let row = &rows[6 * node + i];
            std::array::from_fn(|j| row[n + j] / row[6 * node + i])
        })
    }

    /// A ring of posts on the bed with a zigzag, `levels` high; contours are closed.
    fn tower(levels: u32, corners: u32) -> Frame {
        let mut frame = Frame::default();
        let node = |level: u32, corner: u32| level * corners + corner % corners;
        for level in 0..=levels {
            for corner in 0..corners {
                let around = std::f64::consts::TAU * f64::from(corner) / f64::from(corners);
                let radius = 10.0 + 2.0 * f64::from(level % 2);
                let place =
                    dvec3(radius * around.cos(), radius * around.sin(), 5.0 * f64::from(level));
                frame.places.push(place);
                frame.fixed.push(level == 0);
            }
        }
        let mut strand = |from: u32, to: u32| {
            let strand = frame.ends.len() as u32;
            frame.beams.push(Beam { from, to, strand });
            frame.ends.push(Some([from, to]));
        };
        for level in 0..levels {
            for corner in 0..corners {
                strand(node(level, corner), node(level + 1, corner));
                if corner + 1 < corners {
                    strand(node(level + 1, corner), node(level, corner + 1));
                }
            }
            for corner in 0..corners {
                strand(node(level + 1, corner), node(level + 1, corner + 1));
            }
        }
        frame
    }

    fn grow_all(frame: &Frame, section: Section, mut free: impl FnMut(usize, f64)) {
        let open = Opening::of(frame);
        grow(frame, &open, open.effort(frame).most_open, section, |laid| {
            if let Some(tip) = laid.tip {
                free(laid.strand, tip);
            }
        });
    }

    #[test]
    fn a_single_post_gives_way_as_a_cantilever() {
        let mut frame = tower(1, 3);
        frame.beams.truncate(1);
        frame.places[3] = frame.places[0] + 6.0 * DVec3::Z;
        let mut found = Vec::new();
        let section = Section::new(0.7, 2200.0);
        grow_all(&frame, section, |strand, c| found.push((strand, c)));
        let moment = std::f64::consts::PI * 0.7_f64.powi(4) / 64.0;
        let expected = 6.0_f64.powi(3) / (3.0 * 2200.0 * moment);
        assert_eq!(found.len(), 1);
        assert!((found[0].1 / expected - 1.0).abs() < 1e-12, "{found:?} {expected}");
    }

    #[test]
    fn every_peak_gives_way_as_the_frame_up_to_it_does() {
        let section = Section::new(0.7, 2200.0);
        for (levels, corners) in [(1, 4), (3, 5), (5, 3)] {
            let frame = tower(levels, corners);
            let mut found = Vec::new();
            grow_all(&frame, section, |strand, c| found.push((strand, c)));
            assert_eq!(found.len() as u32, levels * corners, "each post ends freely");
            for (strand, compliance) in found {
                let end = frame.ends[strand].unwrap()[1] as usize;
                let laid = &frame.beams[..=strand];
                let expected = greatest_of_shifts(&direct(&frame, laid, section, end));
                assert!((compliance / expected - 1.0).abs() < 1e-8, "{compliance} {expected}");
            }
        }
    }

    /// Many loops close at once here, and many nodes go while loops wait.
    #[test]
    fn a_wide_front_gives_way_as_the_frame_up_to_it_does() {
        let section = Section::new(0.4, 3300.0);
        let frame = tower(2, 24);
        let mut found = Vec::new();
        grow_all(&frame, section, |strand, c| found.push((strand, c)));
        for &(strand, compliance) in found.iter().step_by(9) {
            let end = frame.ends[strand].unwrap()[1] as usize;
            let laid = &frame.beams[..=strand];
            let expected = greatest_of_shifts(&direct(&frame, laid, section, end));
            assert!((compliance / expected - 1.0).abs() < 1e-8, "{compliance} {expected}");
        }
    }

    #[test]
    fn a_tall_tower_loses_no_digits() {
        let frame = tower(60, 4);
        let mut found = Vec::new();
        let section = Section::new(0.7, 2200.0);
        grow_all(&frame, section, |_, compliance| found.push(compliance));
        assert_eq!(found.len(), 240);
        assert!(found.iter().all(|c| c.is_finite() && *c > 0.0));
        // What stands on a taller tower gives way more.
        let first_of = |level: usize| found[4 * level];
        assert!((1..29).all(|level| first_of(2 * level) < first_of(2 * level + 2)));
    }

    #[test]
    fn work_grows_with_the_strands_and_with_the_square_of_what_is_open() {
        let work = |levels, corners| {
            let frame = tower(levels, corners);
            Opening::of(&frame).effort(&frame).work
        };
        assert!((work(40, 6) / work(20, 6) - 2.0).abs() < 0.1);
        assert!(work(20, 12) > 6.0 * work(20, 6));
    }
}
