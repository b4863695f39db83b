//! The forecast of a text: what its strands would do when they are hot, heavy and pulled at.
//!
//! From the written text alone, as the certificate is: its strands and contacts, when each move
//! begins and ends, and what switches the air. No part of the certificate, and a model throughout.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::beam::Section;
use super::blocks::{hang_far, layered, on_slanted};
use super::climate::Climate;
use super::clock::{StrandTimes, spans};
use super::conditions::{Conditions, along};
use super::contacts::{Contact, contacts};
use super::flows::{Flows, flows};
use super::frame::Frame;
use super::growing::{Laid, grow};
use super::growth::{carrying, rises};
use super::hanging::{HangingStretch, stretches};
use super::holds::{Stroke, softness};
use super::joints::{Joints, joints};
use super::opening::work;
use super::sagging::sagging;
use super::scene::{Found, Scene, Terms};
use crate::check::contact::{self, StrandPart};
use crate::check::deposit::Deposit;
use crate::check::reading::{Macros, Reading};
use crate::check::rules::Rules;
use crate::error::Result;
use crate::gcode::machine::MachineSettings;
use crate::memory;

/// Figures of each strand, NaN where a strand has none.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct PerStrand {
    /// Line of each.
    pub lines: Vec<u64>,
    /// Its ends, mm.
    pub ends: Vec<[DVec3; 2]>,
    /// Age of what it is joined to at its weaker end, when it comes there, s.
    pub age: Vec<f64>,
    /// Temperature of that then, °C.
    pub celsius: Vec<f64>,
    /// Sag of the stretch that it lies in, mm.
    pub sag: Vec<f64>,
    /// How far its end, or what it meets there, gives way, mm/N.
    pub compliance: Vec<f64>,
    /// Share of what it is fed that comes out along it.
    pub flow: Vec<f64>,
    /// Share of a whole weld at its weaker end.
    pub weld: Vec<f64>,
}

/// What a text would do.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Forecast {
    /// Figures of each strand.
    pub strands: PerStrand,
    /// Lean of posts when the nozzle leaves them, mm, by how fast they set: the least, what is
    /// likely, and the most; the detail is the part of it that is due to what they stand on.
    pub holds: [Found; 3],
    /// Sag of stretches, mm; the detail is the speed of the air there, mm/s.
    pub sags: Found,
    /// How far what a strand ends on is pulled aside, mm; the detail is its compliance, mm/N.
    pub meets: Found,
    /// Shares of material, as the distance from a whole one; the detail is the share.
    pub flows: Found,
    /// How far knots stand out of their strand, mm; the detail is their diameter, mm.
    pub knots: Found,
    /// What is missing to a whole weld; the detail is the temperature of the older strand, °C.
    pub welds: Found,
    /// Median share of a weld, of strands that have one; NaN without.
    pub weld_median: f64,
    /// Whether the frame was judged: not where that would take too much work.
    pub frame_judged: bool,
    /// Whether what was laid layer by layer counts as rigid there: it does where all strands would
    /// take too much work.
    pub layers_rigid: bool,
    /// Whether the air ever blows.
    pub air_blows: bool,
}

/// Forecasts a G-code text.
///
/// # Errors
/// [`CoreError::Memory`](crate::CoreError::Memory) for a text too long for the memory that is
/// allowed.
pub fn forecast_text(
    text: &[u8],
    settings: MachineSettings,
    macros: &Macros,
    rules: &Rules,
    times: StrandTimes<'_>,
    terms: &Terms,
) -> Result<Forecast> {
    let read = Reading::of(text, settings, macros, rules.coldest);
    let moves = &read.notes.moves;
    memory::claim(moves.len() as u64 * BYTES_PER_MOVE, || {
        format!("a forecast of {} moves", moves.len())
    })?;
    let deposit = Deposit::of(moves, &read.notes.dwells, &rules.bed);
    let conditions = Conditions::of(text, &terms.air_switch);
    let spans = spans(moves, times);
    let shares = along(&conditions.air, 0.0, moves.iter().map(|step| step.line));
    let shares = spans.iter().map(|span| span[0]).zip(shares);
    let first = std::iter::once((0.0, 0.0));
    let climate = Climate::of(&terms.matter.thermal, terms.air_mm_s, first.chain(shares));
    let carries = carrying(&read.features, &deposit);
    let scene = Scene {
        read: &read,
        deposit: &deposit,
        rules,
        terms,
        spans: &spans,
        climate: &climate,
        carries: &carries,
    };
    scene.forecast(&conditions)
}

/// Floating-point operations, some two seconds of one core, that a frame may take without asking
/// whether its layers could be blocks.
const AMPLE_WORK: f64 = 4e10;
/// Layers are blocks where that leaves at most this share of the work: of wire it leaves nearly all.
const WORTH_BLOCKS: f64 = 0.25;

/// What a move takes, with its strand, its contacts and its figures, bytes.
const BYTES_PER_MOVE: u64 = 800;

impl Scene<'_> {
    /// What all rules find.
    fn forecast(&self, conditions: &Conditions) -> Result<Forecast> {
        let Self { deposit, rules, terms, .. } = self;
        let parts = contact::of_all(deposit, rules);
        let hanging = stretches(deposit, &parts, rules);
        let touching = contacts(deposit, rules, |strand| self.carries[strand])?;
        let Joints { age, celsius, weld, found: welds, median } = joints(self, &touching);
        let grown = self.grown(touching, &parts, &hanging)?;
        let (sag, sags) = sagging(self, &hanging);
        let Flows { shares, strokes, knots } = flows(self, &conditions.advance);
        let strands = PerStrand {
            lines: deposit.lines.clone(),
            ends: deposit.strands.clone(),
            age,
            celsius,
            sag,
            compliance: grown.compliance.clone(),
            flow: shares,
            weld,
        };
        Ok(Forecast {
            holds: terms.sets_faster.map(|faster| self.holds(&hanging, &grown, faster)),
            meets: grown.meets,
            frame_judged: grown.judged,
            layers_rigid: grown.layers_rigid,
            strands,
            sags,
            flows: strokes,
            knots,
            welds,
            weld_median: median,
            air_blows: self.climate.speeds().iter().any(|&speed| speed > 0.0),
        })
    }

    /// How far the frame gives way as it grows.
    fn grown(
        &self,
        touching: Vec<Contact>,
        parts: &[Vec<StrandPart>],
        hanging: &[HangingStretch],
    ) -> Result<Grown> {
        let Self { read, deposit, rules, terms, carries, .. } = *self;
        let slanted = on_slanted(deposit, &touching, rules.tolerance());
        let frame = Frame::of(deposit, rules, touching, |strand| carries[strand]).on_the_bed();
        let mut compliance = vec![f64::NAN; deposit.strands.len()];
        let mut meets = Found::default();
        let section = Section::new(rules.strand, terms.frame_modulus());
        let mut told = |laid: Laid| {
            compliance[laid.strand] = laid.tip.or(laid.met).unwrap_or(f64::NAN);
            if let Some(met) = laid.met {
                let miss = terms.pull_n * met;
                meets.add(self.at_end(laid.strand, miss, 0.0, met), rules.tolerance());
            }
        };
        let most = terms.most_work;
        let whole = work(&frame, most);
        let mut layers_rigid = false;
        let mut frame = frame;
        if whole > AMPLE_WORK.min(most) {
            let far = hang_far(deposit, hanging, &slanted, rules.strand);
            let in_blocks = |far: &[bool]| {
                let layered = layered(&read.features, deposit, parts, far, rules.tolerance());
                let blocks = frame.clone().in_blocks(&layered);
                (work(&blocks, most), blocks)
            };
            let mut found = in_blocks(&far);
            if found.0 > most {
                // Infills of curves hang here and there as far as bridges do.
                found = in_blocks(&slanted);
            }
            let (least, blocks) = found;
            layers_rigid = whole > most || least <= WORTH_BLOCKS * whole;
            if layers_rigid {
                frame = blocks;
            }
        }
        let judged = grow(&frame, section, most, &mut told)?;
        Ok(Grown { compliance, meets, judged, layers_rigid })
    }

    /// How far posts lean when the nozzle leaves them, if they set faster by so much.
    fn holds(&self, hanging: &[HangingStretch], grown: &Grown, faster: f64) -> Found {
        let Self { deposit, rules, terms, .. } = self;
        let mut found = Found::default();
        let moment = std::f64::consts::PI * rules.strand.powi(4) / 64.0;
        for stretch in hanging.iter().filter(|stretch| stretch.free) {
            let [first, last] = stretch.strands;
            if first > last || !self.carries[last] || !rises(deposit, last, rules.tolerance()) {
                continue;
            }
            // A contact reaches a diameter up the post.
            let length = stretch.length + rules.strand;
            let [begin, end] = [self.span(first)[0], self.span(last)[1]];
            let leaves = self.leaves(last);
            let step = &self.read.notes.moves[deposit.steps[last] as usize];
            let speed = step.speed.min(rules.limits.feed).max(f64::MIN_POSITIVE);
            let stroke = Stroke { length, seconds: end - begin, speed };
            let own = softness(&terms.matter, length, |back| {
                let laid = end - stroke.before_end(back.min(length));
                self.climate.celsius(laid, laid + (leaves - laid) * faster)
            });
            let cold = length.powi(3) / (3.0 * terms.frame_modulus() * moment);
            let base = (grown.compliance[last] - cold).max(0.0);
            let base = if base.is_finite() { base } else { 0.0 };
            let lean = (terms.pull_n * (base + own)).min(length);
            found.add(self.at_end(last, lean, length, terms.pull_n * base), rules.tolerance());
        }
        found
    }
}

/// A frame that has grown.
struct Grown {
    /// By strand, mm/N.
    compliance: Vec<f64>,
    meets: Found,
    judged: bool,
    layers_rigid: bool,
}
