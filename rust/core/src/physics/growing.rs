//! The beams of a frame, added one after the other: how far each end gives way when it is laid.
//!
//! Kept is the compliance of those nodes alone that later beams will touch: a free end adds a node,
//! an end that meets another closes a loop.

use glam::DVec3;

use super::beam::{Section, transport};
use super::compliance::Compliance;
use super::frame::{Beam, Frame};
use super::opening::{Effort, Opening};
use super::six::{Six, greatest_of_shifts, product, transposed};
use crate::error::Result;
use crate::memory;

/// A strand that has just been laid, and how far things give way where it ends, mm/N.
#[derive(Debug, Clone, Copy)]
pub(super) struct Laid {
    pub strand: usize,
    /// Its own end, if that is new and hangs freely.
    pub tip: Option<f64>,
    /// The softest place that it met, before it held it.
    pub met: Option<f64>,
}

/// Lays the beams in the order of printing; `told` is told each strand when it has just been laid.
///
/// False: that would take more than `most_work` floating-point operations, and nothing was done.
///
/// # Errors
/// [`CoreError::Memory`](crate::CoreError::Memory) where more ends are loose at a time than the
/// memory that is allowed has room for.
pub(super) fn grow(
    frame: &Frame,
    section: Section,
    most_work: f64,
    told: impl FnMut(Laid),
) -> Result<bool> {
    let open = Opening::of(frame);
    let Effort { work, most_open } = open.effort(frame, most_work);
    if work > most_work {
        return Ok(false);
    }
    memory::claim(Compliance::bytes(most_open), || format!("a frame with {most_open} loose ends"))?;
    lay(frame, &open, Compliance::with_room(most_open), section, told);
    Ok(true)
}

/// Adds the beams one after the other.
fn lay(
    frame: &Frame,
    open: &Opening,
    mut compliance: Compliance,
    section: Section,
    mut told: impl FnMut(Laid),
) {
    let mut slots: Vec<Option<u32>> = vec![None; frame.places.len()];
    // The node in each slot.
    let mut opened: Vec<usize> = Vec::new();
    for beams in frame.beams.chunk_by(|a, b| a.strand == b.strand) {
        let strand = beams[0].strand;
        let mut tip = None;
        let mut met: Option<f64> = None;
        for beam in beams {
            let is_held = |node: u32| frame.fixed[node as usize] || slots[node as usize].is_some();
            // A beam is laid from what holds it; one that nothing holds is loose, and left out.
            let beam = if is_held(beam.from) { *beam } else { beam.turned() };
            if !is_held(beam.from) {
                continue;
            }
            let is_closed = is_held(beam.to);
            let [from, to] = [beam.from as usize, beam.to as usize];
            let (transport, flexibility) = between(frame, &beam, section);
            if is_closed {
                if let Some(slot) = slots[to] {
                    let block = carried(&compliance.block(slot), beam.arms[1]);
                    let gives = greatest_of_shifts(&block);
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
            if open.until(opened[slot]) > strand {
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

/// How a beam's start carries the node at its end, and how far that gives way by the beam alone.
fn between(frame: &Frame, beam: &Beam, section: Section) -> (Six, Six) {
    let [from, to] = [beam.from, beam.to].map(|node| frame.places[node as usize]);
    let run = to + beam.arms[1] - from - beam.arms[0];
    (transport(to - from), carried(&section.flexibility(run), -beam.arms[1]))
}

/// The compliance of what is fixed to a point with one, `arm` mm away.
fn carried(compliance: &Six, arm: DVec3) -> Six {
    if arm == DVec3::ZERO {
        return *compliance;
    }
    let carries = transport(arm);
    let half = product(&carries, compliance);
    product(&half, &transposed(&carries))
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, dvec3};

    use super::super::opening;
    use super::super::six::{identity, lower_factor, solve_lower};
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
        let beams: Vec<_> = beams.iter().map(|&beam| (beam, section)).collect();
        direct_of(frame, &beams, node)
    }

    /// The same for beams with a section each.
    fn direct_of(frame: &Frame, beams: &[(Beam, Section)], node: usize) -> Six {
        let n = 6 * frame.places.len();
        let mut rows = vec![vec![0.0; n + 6]; n];
        for &(Beam { from, to, .. }, section) in beams {
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
            beams.iter().any(|(beam, _)| beam.from as usize == node || beam.to as usize == node)
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
            frame.beams.push(Beam::between(from, to, strand));
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
        let told = |laid: Laid| laid.tip.into_iter().for_each(|tip| free(laid.strand, tip));
        assert!(grow(frame, section, f64::INFINITY, told).unwrap());
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

    /// A peak gives way as the frame does that was laid up to it, solved as a whole.
    fn assert_gives_way(frame: &Frame, section: Section, strand: usize, compliance: f64) {
        let end = frame.ends[strand].unwrap()[1] as usize;
        let laid = &frame.beams[..=strand];
        let expected = greatest_of_shifts(&direct(frame, laid, section, end));
        assert!((compliance / expected - 1.0).abs() < 1e-8, "{compliance} {expected}");
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
                assert_gives_way(&frame, section, strand, compliance);
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
            assert_gives_way(&frame, section, strand, compliance);
        }
    }

    /// A cube of layers on four posts, and a post on each of its corners.
    fn table(rigid: bool) -> (Frame, Vec<bool>) {
        let mut frame = Frame::default();
        let mut layered = Vec::new();
        let corner = |i: u32| match i % 4 {
            0 => dvec3(0.0, 0.0, 0.0),
            1 => dvec3(9.0, 0.0, 0.0),
            2 => dvec3(9.0, 7.0, 0.0),
            _ => dvec3(0.0, 7.0, 0.0),
        };
        let heights = [0.0, 6.0, 6.5, 7.0, 12.0];
        for (level, &z) in heights.iter().enumerate() {
            for i in 0..4 {
                frame.places.push(corner(i) + DVec3::Z * z);
                frame.fixed.push(level == 0);
            }
        }
        let mut strand = |from: u32, to: u32, layer: bool| {
            frame.beams.push(Beam::between(from, to, layered.len() as u32));
            frame.ends.push(Some([from, to]));
            layered.push(layer);
        };
        for i in 0..4 {
            strand(i, 4 + i, false);
        }
        // Each layer is a ring with both diagonals, laid on the one below.
        for level in [8, 12] {
            for i in 0..4 {
                strand(level - 4 + i, level + i, true);
            }
            for (i, j) in [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 3)] {
                strand(level + i, level + j, true);
            }
        }
        for i in 0..4 {
            strand(12 + i, 16 + i, false);
        }
        let frame = if rigid { frame.in_blocks(&layered) } else { frame };
        (frame, layered)
    }

    #[test]
    fn layers_in_blocks_give_way_a_little_less_than_their_strands() {
        let told = |rigid: bool| {
            let (frame, _) = table(rigid);
            let mut found = Vec::new();
            grow_all(&frame, Section::new(0.7, 2200.0), |strand, c| found.push((strand, c)));
            found
        };
        let [strands, blocks] = [told(false), told(true)];
        let posts = |found: &[(usize, f64)]| -> Vec<f64> {
            found.iter().filter(|one| one.0 >= 24).map(|one| one.1).collect()
        };
        let [strands, blocks] = [posts(&strands), posts(&blocks)];
        assert_eq!([strands.len(), blocks.len()], [4, 4]);
        for (strands, blocks) in strands.iter().zip(&blocks) {
            assert!(blocks < strands && *blocks > 0.5 * strands, "{blocks} {strands}");
        }
    }

    /// With strands as good as rigid there is no difference.
    #[test]
    fn a_block_is_what_ever_stiffer_layers_come_to() {
        let (frame, layered) = table(false);
        let (blocks, _) = table(true);
        let section = Section::new(0.7, 2200.0);
        let last = 27;
        let mut found = 0.0;
        grow_all(&blocks, section, |strand, c| found = if strand == last { c } else { found });
        // Layers of strands a hundred times as thick, but for those that meet the posts below.
        let stiff = Section::new(70.0, 2200.0);
        let in_block = |strand: u32| strand >= 8 && layered[strand as usize];
        let of = |strand: u32| if in_block(strand) { stiff } else { section };
        let beams: Vec<_> = frame.beams.iter().map(|&beam| (beam, of(beam.strand))).collect();
        let end = frame.ends[last].unwrap()[1] as usize;
        let expected = greatest_of_shifts(&direct_of(&frame, &beams, end));
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
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
            opening::work(&frame, f64::INFINITY)
        };
        assert!((work(40, 6) / work(20, 6) - 2.0).abs() < 0.1);
        assert!(work(20, 12) > 6.0 * work(20, 6));
        let most = 0.5 * work(20, 12);
        let counted = opening::work(&tower(20, 12), most);
        assert!(counted > most && counted < 1.1 * most, "no farther than it matters");
    }
}
