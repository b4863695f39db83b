//! From slices to strands, bottom up.
//!
//! `build` runs over the levels; `slab` lays the zigzags and rings between two of them, `level`
//! leads from the contours that end one slab to those that begin the next, and `hang` finds
//! support for what has no wall of its own below.

use glam::{DVec2, DVec3};

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::Waiting;
use crate::head::Head;
use crate::strand::{Kind, Strand};
use crate::wireframe::frame::{PlacedPost, Reason, Unprinted, Wireframe};
use crate::wireframe::lay::columns::{self, Wants};
use crate::wireframe::lay::journal::{Builder, Course, SAME};
use crate::wireframe::lay::tops::Tops;
use crate::wireframe::order::search::{Costs, costs};
use crate::wireframe::params::WireParams;
use crate::wireframe::place::guide::{Guide, Spokes};
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::rim::Rim;
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::Layered;

/// A contour printed on the bed follows the model to this, mm.
const BED_FOLLOW: f64 = 0.05;

/// Fewer slabs than one in so many are not worth looking for other orders.
const FEW: usize = 4;

/// What stands at one height: the rims by contour, and the strands that close faces there.
#[derive(Clone, Default)]
pub struct Ground {
    /// Rim of each contour, if it is printed.
    pub rims: Vec<Option<Rim>>,
    /// Other strands of this height, as open rims.
    pub lines: Vec<Rim>,
}

impl Ground {
    /// Everything printed at this height.
    pub fn all(&self) -> Vec<&Rim> {
        self.rims.iter().flatten().chain(&self.lines).filter(|r| r.printed).collect()
    }
}

/// A contour whose posts stand.
pub struct Standing {
    /// The number of its curve at the slab's top.
    pub curve: usize,
    /// Arc length where the chain of posts begins, mm.
    pub start: f64,
    /// Its posts, by arc length from there.
    pub posts: Vec<Post>,
}

/// The print in the making.
pub struct Build<'a> {
    pub(in crate::wireframe) sliced: &'a Sliced,
    pub(in crate::wireframe) layered: &'a Layered,
    pub(in crate::wireframe) p: &'a WireParams,
    pub(in crate::wireframe) head: &'a Head,
    /// What ends each slab.
    pub(in crate::wireframe) tops: &'a Tops<'a>,
    pub(in crate::wireframe) out: Builder<'a>,
    pub(in crate::wireframe) posts: Vec<PlacedPost>,
    pub(in crate::wireframe) unprinted: Vec<Unprinted>,
    pub(in crate::wireframe) wants: Wants,
    /// How far contours stray that become straight between their posts, times their length, mm².
    pub(in crate::wireframe) sag: f64,
    /// Whether slabs are tried in several orders.
    pub(in crate::wireframe) searching: bool,
    /// Number of slabs that want that.
    pub(in crate::wireframe) wanting: usize,
    /// The plain print that wire beside layers goes by; empty for that print itself.
    pub(in crate::wireframe) guide: &'a Guide,
    /// All flat zigzags that hold contours so far.
    pub(in crate::wireframe) spokes: Vec<Spokes>,
}

/// What a pass of the build goes by.
#[derive(Clone, Copy)]
struct Plan<'a> {
    layered: &'a Layered,
    head: &'a Head,
    p: &'a WireParams,
    /// Whether slabs are tried in several orders.
    searching: bool,
}

/// What a pass of the build comes to.
struct Laid {
    posts: Vec<PlacedPost>,
    strands: Vec<Strand>,
    unprinted: Vec<Unprinted>,
    wants: Wants,
    sag: f64,
    wanting: usize,
    spokes: Vec<Spokes>,
}

impl Laid {
    fn costs(&self) -> Costs {
        costs(None, &self.strands, &self.unprinted, self.wants.columns.len(), self.sag)
    }

    /// Whether it leaves out less than another, or costs less and does not take longer.
    fn is_better(&self, other: &Self) -> bool {
        let ([area, cost, time], [other_area, other_cost, other_time]) =
            (self.costs(), other.costs());
        area < other_area || area == other_area && cost < other_cost && time <= other_time
    }
}

/// Lays the strands of a sliced model, those of `layered` among them: always the nearest contour
/// first and, where slabs want that, also in the best order of each slab; what is better as a whole
/// is kept. With layers, the same is done without them first, and the wire goes by that.
#[must_use]
pub fn build(sliced: Sliced, layered: &Layered, head: &Head, p: &WireParams) -> Wireframe {
    let none = Layered::default();
    let plan = Plan { layered: &none, head, p, searching: false };
    let nothing = Guide::default();
    let free = [&nothing; 2];
    let mut found = settled(&sliced, &plan, free);
    if found.last.wanting > 0 && found.last.wanting >= sliced.strips.len() / FEW {
        let searched = settled(&sliced, &Plan { searching: true, ..plan }, free);
        if searched.last.is_better(&found.last) {
            found = searched;
        }
    }
    if !layered.is_empty() {
        let last = Guide::new(&found.last.posts, found.last.spokes);
        let first = found.first.map(|first| Guide::new(&first.posts, first.spokes));
        let guides = [first.as_ref().unwrap_or(&last), &last];
        found = settled(&sliced, &Plan { layered, ..plan }, guides);
    }
    let sliced = found.propped.unwrap_or(sliced);
    let Laid { posts, strands, unprinted, .. } = found.last;
    Wireframe { posts, strands, unprinted, sliced }
}

/// What one or two passes of the build come to.
struct Settled {
    /// The slices with supports, if the first pass found that they are needed.
    propped: Option<Sliced>,
    /// That pass, and the last one.
    first: Option<Laid>,
    last: Laid,
}

/// Lays the strands; a second pass adds supports where the first one found that they are needed.
/// Each goes by a guide of its own.
fn settled(sliced: &Sliced, plan: &Plan, guides: [&Guide; 2]) -> Settled {
    let mut laid = lay(sliced, plan, guides[0]);
    if !plan.p.supports {
        laid.wants.columns.clear();
    }
    if laid.wants.columns.is_empty() && laid.wants.roofs.is_empty() {
        return Settled { propped: None, first: None, last: laid };
    }
    let mut propped = sliced.clone();
    columns::add(&mut propped, &laid.wants);
    let last = lay(&propped, plan, guides[1]);
    Settled { propped: Some(propped), first: Some(laid), last }
}

fn lay(sliced: &Sliced, plan: &Plan, guide: &Guide) -> Laid {
    let &Plan { layered, head, p, searching } = plan;
    let (low, high) = sliced.plan();
    let tallest = sliced.levels.windows(2).map(|l| l[1].z - l[0].z).fold(1.0, f64::max);
    let out = Builder::new(head, p.strand, head.clearance(tallest), low, high);
    let tops = Tops::new(sliced, layered, head);
    let mut build = Build {
        sliced,
        layered,
        p,
        head,
        tops: &tops,
        out,
        posts: Vec::new(),
        unprinted: Vec::new(),
        wants: Wants::default(),
        sag: 0.0,
        searching,
        wanting: 0,
        guide,
        spokes: Vec::new(),
    };
    rayon::scope(|scope| {
        scope.spawn(|_| tops.gather());
        build.run();
    });
    let Build { out, posts, unprinted, wants, sag, wanting, spokes, .. } = build;
    Laid { posts, strands: out.strands, unprinted, wants, sag, wanting, spokes }
}

impl Build<'_> {
    fn run(&mut self) {
        let Some(first) = self.sliced.levels.first() else { return };
        let mut ground = self.on_bed(first.z);
        for slab in 0..self.tops.len() {
            self.roofs_of_slab(slab, &mut ground);
            let printed = self.slab(slab, &mut ground);
            ground = self.transition(slab + 1, printed);
        }
    }

    /// The first contours, pressed onto the bed, and the floors within them.
    fn on_bed(&mut self, z: f64) -> Ground {
        self.out.begin_slab(0, &[]);
        let contours = &self.sliced.upper[0];
        let mut ground = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
        let plans = contours.iter().map(|c| vec![c.points.clone()]);
        let mut waiting = Waiting::new(plans.collect());
        while let Some(i) = waiting.take_nearest(self.place()) {
            let Some(curve) = Curve::new(&contours[i].points, contours[i].closed) else { continue };
            let start = self.seam(&curve);
            let kind = if contours[i].support { Kind::Support } else { Kind::Contour };
            let longest = f64::INFINITY;
            let course = Course { start, z, tolerance: BED_FOLLOW, longest, kind };
            let (rim, _) = self.out.ring(&curve, &[], &course);
            ground.rims[i] = Some(Rim { held: true, ..rim });
        }
        let closes = |floor: &&Strip| floor.closes(contours, &floor.upper);
        for floor in self.sliced.ledges[0].iter().flatten().filter(closes) {
            self.close(0, &floor.upper, &mut ground);
        }
        ground
    }

    /// Where the head is, in plan; at first the bed's centre.
    pub(in crate::wireframe) fn place(&self) -> DVec2 {
        self.out.at().map_or(DVec2::ZERO, DVec3::truncate)
    }

    /// Arc length where a ring that follows no strand begins: its corner nearest to the head.
    fn seam(&self, curve: &Curve) -> f64 {
        if !curve.is_closed() {
            return 0.0;
        }
        let at = self.out.at().map_or(DVec2::ZERO, DVec3::truncate);
        let off = |s: f64| curve.position(s).distance_squared(at);
        curve
            .corners()
            .iter()
            .copied()
            .min_by(|a, b| off(*a).total_cmp(&off(*b)))
            .unwrap_or_else(|| curve.nearest(at).s)
    }

    /// Where a chain of posts begins: over the end of the last strand if that lies on a carrier,
    /// else over the carriers' vertex nearest to the head.
    pub(in crate::wireframe) fn start(&self, curve: &Curve, carriers: &[&Rim]) -> f64 {
        if !curve.is_closed() {
            return 0.0;
        }
        let at = self.out.at().unwrap_or_default();
        let vertices = carriers.iter().flat_map(|r| &r.points);
        let nearest = vertices.min_by(|a, b| a.distance(at).total_cmp(&b.distance(at)));
        curve.nearest(nearest.copied().unwrap_or(at).truncate()).s
    }

    /// The end of the last strand, if it is a vertex of one of the carriers.
    pub(in crate::wireframe) fn going_on(&self, carriers: &[&Rim]) -> Option<DVec3> {
        let at = self.out.at()?;
        carriers.iter().flat_map(|r| &r.points).find(|p| p.distance(at) < SAME).copied()
    }

    /// Notes a part of the surface that is not printed.
    pub(in crate::wireframe) fn leave_out(
        &mut self,
        low: f64,
        high: f64,
        area: f64,
        at: DVec2,
        reason: Reason,
    ) {
        self.unprinted.push(Unprinted { low, high, area, place: at.extend(high), reason });
    }
}
