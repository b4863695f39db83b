//! What a forecast is about: a text as it was read, and what it is asked for.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::climate::Climate;
use super::clock::TimeSpan;
use super::conditions::Switch;
use super::flow::Matter;
use crate::check::deposit::Deposit;
use crate::check::reading::Reading;
use crate::check::rules::Rules;

/// What a calibration found at one length.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct SagShare {
    /// Length of the stretch, mm.
    pub length_mm: f64,
    /// Its sag there, to that of the model.
    pub share: f64,
}

/// What a forecast is made from, beside the text and the rules.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Terms {
    /// What strands are made of.
    #[serde(flatten)]
    pub matter: Matter,
    /// What switches the air.
    pub air_switch: Switch,
    /// Speed of the air where all of it blows, mm/s.
    pub air_mm_s: f64,
    /// Of the nozzle on what it leaves, N.
    pub pull_n: f64,
    /// Of the flow behind the feed, s; 0 where it is not known.
    pub pressure_lag_s: f64,
    /// Floating-point operations after which the frame is not judged.
    pub most_work: f64,
    /// By how much faster posts set than the model says, as a calibration found: the least, what is
    /// likely, and the most.
    pub sets_faster: [f64; 3],
    /// By how much stiffer strands bend than diameter and modulus say, as a calibration found.
    pub stiffer: f64,
    /// By how much farther stretches of some lengths (mm) sag than the model says, likewise.
    pub sags_farther: Vec<SagShare>,
}

impl Terms {
    /// Modulus of cold strands in the frame, MPa.
    pub(super) fn frame_modulus(&self) -> f64 {
        self.stiffer * self.matter.modulus_mpa
    }
}

/// The worst of what a rule is about.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Worst {
    /// In the rule's unit.
    pub value: f64,
    /// Line of the text.
    pub line: u64,
    /// Where, mm.
    pub at: DVec3,
    /// Length of the post or stretch that it is about, mm; 0 where it is about none.
    pub length: f64,
    /// The rest of what there is to say of it: see the rule.
    pub detail: f64,
}

/// What a rule found: its worst, and how many of how many are beyond its limit.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Found {
    /// None where there is nothing that it is about, or where it was not judged.
    pub worst: Option<Worst>,
    /// Number beyond the limit.
    pub over: usize,
    /// Number of all.
    pub of: usize,
}

impl Found {
    /// Takes one more; the first of those that are equally bad is kept.
    pub(super) fn add(&mut self, one: Worst, limit: f64) {
        self.of += 1;
        self.over += usize::from(one.value > limit);
        if self.worst.is_none_or(|worst| one.value > worst.value) {
            self.worst = Some(one);
        }
    }
}

/// A text as it was read, with all that follows from it alone.
pub(super) struct Scene<'a> {
    pub read: &'a Reading,
    pub deposit: &'a Deposit,
    pub rules: &'a Rules,
    pub terms: &'a Terms,
    /// Begin and end of each move, s.
    pub spans: &'a [TimeSpan],
    pub climate: &'a Climate,
    /// Which strands carry anything.
    pub carries: &'a [bool],
}

impl Scene<'_> {
    /// Begin and end of a strand, s.
    pub(super) fn span(&self, strand: usize) -> TimeSpan {
        self.spans[self.deposit.steps[strand] as usize]
    }

    /// When the nozzle was at a place (0–1) along a strand, s.
    pub(super) fn when(&self, strand: usize, share: f64) -> f64 {
        let [begin, end] = self.span(strand);
        begin + share * (end - begin)
    }

    /// When the nozzle leaves the end of a strand, s: with the next move that moves the head.
    pub(super) fn leaves(&self, strand: usize) -> f64 {
        let next = self.deposit.steps[strand] as usize + 1;
        let mut moves = self.read.notes.moves[next..].iter().zip(&self.spans[next..]);
        let next = moves.find(|(step, _)| step.from != step.to);
        next.map_or(f64::INFINITY, |(_, span)| span[0])
    }

    /// The worst that is found at the end of a strand.
    pub(super) fn at_end(&self, strand: usize, value: f64, length: f64, detail: f64) -> Worst {
        let (line, [_, at]) = (self.deposit.lines[strand], self.deposit.strands[strand]);
        Worst { value, line, at, length, detail }
    }
}
