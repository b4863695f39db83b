//! The frame while it grows: how far each post's peak gives way when it has just been laid.

use glam::DVec3;

use super::beam::Section;
use super::contacts::contacts;
use super::frame::Frame;
use super::growing::grow;
use crate::check::deposit::Deposit;
use crate::check::reading::{Macros, Reading};
use crate::check::rules::Rules;
use crate::error::Result;
use crate::gcode::machine::MachineSettings;

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
    let frame = Frame::of(&deposit, rules, contacts(&deposit, rules, counts)?, counts).on_the_bed();
    let mut peaks = Vec::new();
    let section = Section::new(rules.strand, elastic.modulus);
    let judged = grow(&frame, section, elastic.most_work, |laid| {
        if let Some(compliance) = laid.tip
            && rises(&deposit, laid.strand, rules.tolerance())
        {
            let (line, [_, at]) = (deposit.lines[laid.strand], deposit.strands[laid.strand]);
            peaks.push(Peak { line, at, compliance });
        }
    })?;
    Ok(Growth { peaks, judged })
}

/// For each strand, whether it carries anything, by the labels of a text.
pub(super) fn carrying(labels: &[String], deposit: &Deposit) -> Vec<bool> {
    let aside: Vec<bool> = labels.iter().map(|name| ASIDE.contains(&name.as_str())).collect();
    let is_aside = |&feature: &u16| aside.get(usize::from(feature)).copied().unwrap_or(false);
    deposit.features.iter().map(|feature| !is_aside(feature)).collect()
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
