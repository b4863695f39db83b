//! One slab: posts and diagonals up to each contour of its upper slice, then that contour.

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::{Waiting, bounds};
use crate::geometry::tour::tour;
use crate::head::Head;
use crate::strand::Kind;
use crate::wireframe::build::{Build, Ground, Standing};
use crate::wireframe::frame::{PlacedPost, Reason};
use crate::wireframe::lay::journal::Course;
use crate::wireframe::order::search::Order;
use crate::wireframe::params::Pattern;
use crate::wireframe::place::guide::Kept;
use crate::wireframe::place::posts::Post;
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::place::walls::Walls;
use crate::wireframe::place::zigzag::{Step, ZigzagInput, zigzag};
use crate::wireframe::plan::sliced::Sliced;
use crate::wireframe::plan::strips::Strip;
use crate::wireframe::regions::layered::{self, LayeredSlab, Piece};

/// A contour printed in the air follows the model to this part of the strand's diameter.
const FOLLOW: f64 = 0.5;
/// Stretches between posts longer than this many least spacings, and than the longest free end,
/// are tied.
const LOOSE: f64 = 2.6;

/// Posts are seldom lower than this part of their slab, though they stand on what lies a little
/// above its foot.
const LIFTED: f64 = 0.8;

/// A contour to be printed at the top of a slab.
pub struct Job {
    /// The number of its curve at the slab's top.
    pub curve: usize,
    /// Contours of the slice below whose rims carry it.
    pub carriers: Vec<usize>,
    /// The strip between them.
    pub strip: usize,
}

/// Contours that stray less than this on average are near enough to try no other order, mm.
const NEAR: f64 = 0.15;
/// A strip with more than this share of its area in plan leans more than it stands.
const LEANING: f64 = 0.9;

/// What all contours at the top of one slab share; depends on the slices alone.
pub struct Top {
    pub(in crate::wireframe) slab: usize,
    z: f64,
    /// The contours, and behind them the wire pieces of those that are layers in part.
    curves: Vec<Option<Curve>>,
    /// The pieces of contours that are layers in part.
    pieces: Vec<Piece>,
    walls: Walls,
    /// Distance within which what stands in this slab bars the head.
    reach: f64,
}

impl Top {
    /// Gathers the contours that end a slab; none of the curves is one that is all layers.
    pub fn new(sliced: &Sliced, layers: Option<&LayeredSlab>, head: &Head, slab: usize) -> Self {
        let z = sliced.levels[slab + 1].z;
        let contours = sliced.lower[slab + 1].iter();
        let mut curves: Vec<Option<Curve>> =
            contours.map(|c| Curve::new(&c.points, c.closed)).collect();
        let mut pieces = Vec::new();
        if let Some(layers) = layers {
            for i in all_layers(&sliced.strips[slab], layers) {
                curves[i] = None;
            }
            pieces = layered::take_out(&mut curves, &layers.stretches);
        }
        let height = z - sliced.levels[slab].z;
        let reach = head.clearance(height) * 1.1;
        let walls = Walls::new(&curves, head.clearance(LIFTED * height)..=reach);
        Self { slab, z, curves, pieces, walls, reach }
    }

    /// The contour that a curve is, or is a piece of.
    fn contour(&self, curve: usize) -> usize {
        self.piece(curve).map_or(curve, |piece| piece.contour)
    }

    /// The piece that a curve is.
    fn piece(&self, curve: usize) -> Option<&Piece> {
        self.pieces.iter().find(|piece| piece.curve == Some(curve))
    }
}

/// The contours of a slab's top that are layers all around.
fn all_layers<'a>(
    strips: &'a [Strip],
    layers: &'a LayeredSlab,
) -> impl Iterator<Item = usize> + 'a {
    let layered = layers.strips.iter().map(|&s| &strips[s as usize]);
    layered.flat_map(|strip| strip.upper.iter().map(|&i| i as usize))
}

impl Build<'_> {
    /// Prints one slab; gives what stands at its top.
    pub(in crate::wireframe) fn slab(&mut self, slab: usize, ground: &mut Ground) -> Ground {
        let top = self.tops.get(slab);
        let jobs = self.jobs(top, &ground.rims);
        if !self.guide.is_empty() {
            return self.slab_in(Order::Guided, top, &jobs, ground);
        }
        let near = NEAR * top.curves.iter().flatten().map(Curve::length).sum::<f64>();
        let alone = jobs.len() < 2;
        if self.searching && !alone {
            return self.best_order(top, &jobs, ground, near);
        }
        let mark = self.mark();
        let printed = self.slab_in(Order::Nearest, top, &jobs, ground);
        self.wanting += usize::from(!alone && !self.is_whole(&mark, near));
        printed
    }

    /// The contours in the order in which they are to be printed; none where that shows on the way.
    fn ranks(&self, order: Order, top: &Top, jobs: &[Job], ground: &Ground) -> Option<Vec<usize>> {
        let (low, high): (Vec<DVec2>, Vec<DVec2>) =
            jobs.iter().map(|job| bounds(plans(job, ground).into_iter().flatten())).unzip();
        let extent = |i: usize| (high[i] - low[i]).max_element();
        let mut ranks: Vec<usize> = (0..jobs.len()).collect();
        match order {
            Order::Nearest => return None,
            Order::Tour => {
                let carried: Vec<usize> =
                    ranks.iter().copied().filter(|&i| extent(i) >= 0.0).collect();
                let middles: Vec<DVec2> =
                    carried.iter().map(|&i| low[i].midpoint(high[i])).collect();
                let way = tour(self.place(), &middles);
                let rest = ranks.into_iter().filter(|&i| extent(i) < 0.0);
                ranks = way.into_iter().map(|k| carried[k]).chain(rest).collect();
            }
            Order::InsideOut => ranks.sort_by(|&a, &b| extent(a).total_cmp(&extent(b))),
            Order::OutsideIn => ranks.sort_by(|&a, &b| extent(b).total_cmp(&extent(a))),
            Order::Guided => {
                ranks.sort_by_key(|&i| self.guide.rank(top.slab, top.contour(jobs[i].curve)))
            }
        }
        Some(ranks)
    }

    /// Prints one slab in one order.
    pub(in crate::wireframe) fn slab_in(
        &mut self,
        order: Order,
        top: &Top,
        jobs: &[Job],
        ground: &mut Ground,
    ) -> Ground {
        let (slab, z) = (top.slab, top.z);
        let layers = self.layered.slab(slab);
        self.out.begin_slab(slab as u32, layers.map_or(&[], |l| &l.lines));
        let mut printed = Ground { rims: vec![None; top.curves.len()], lines: Vec::new() };
        self.print_crowded_rims(top, jobs, ground);
        let (mut waiting, mut loose, mut bare) = (Vec::new(), Vec::new(), Vec::new());
        let mut ranks = self.ranks(order, top, jobs, ground).map(Vec::into_iter);
        let mut order = Waiting::new(jobs.iter().map(|job| plans(job, ground)).collect());
        loop {
            let next = match &mut ranks {
                Some(ranks) => ranks.next().inspect(|&next| order.take(next)),
                None => order.take_nearest(self.place()),
            };
            let Some(next) = next else { break };
            let job = &jobs[next];
            let Some(curve) = &top.curves[job.curve] else { continue };
            let Some(standing) = self.posts_of(top, job, ground) else {
                bare.push(job);
                continue;
            };
            self.sag += sag(curve, &standing);
            if self.is_loose(top, curve, &standing) || self.was_tied(curve, z) {
                loose.push(standing);
            } else if layers.is_some() || is_in_the_way(curve, &order, top.reach) {
                waiting.push(standing);
            } else {
                printed.rims[job.curve] = Some(self.ring(top, &standing));
            }
        }
        if let Some(layers) = layers {
            self.layers(top, layers, &mut printed);
        }
        self.rings(top, &waiting, &mut printed);
        self.hang_rest(top, loose, &bare, &mut printed);
        self.join_pieces(top, &mut printed);
        printed
    }

    /// Prints the slab's layers: their tops stand in for the contours there.
    fn layers(&mut self, top: &Top, layers: &LayeredSlab, printed: &mut Ground) {
        self.out.layers(&layers.lines);
        let contours = &self.sliced.lower[top.slab + 1];
        let curve = |i: usize| Curve::new(&contours[i].points, contours[i].closed);
        for i in all_layers(&self.sliced.strips[top.slab], layers) {
            printed.rims[i] = curve(i).map(|curve| layered::closed_rim(&curve, top.z));
        }
        for piece in top.pieces.iter().filter(|piece| piece.curve.is_none()) {
            let Some(curve) = curve(piece.contour) else { continue };
            printed.lines.push(layered::rim_of(&curve, piece.from, piece.length, top.z));
        }
    }

    /// Joins the rims of the pieces of each contour that is layers in part.
    fn join_pieces(&self, top: &Top, printed: &mut Ground) {
        let contours = &self.sliced.lower[top.slab + 1];
        for pieces in top.pieces.chunk_by(|a, b| a.contour == b.contour) {
            let Some(first) = pieces.first() else { continue };
            let contour = &contours[first.contour];
            let Some(curve) = Curve::new(&contour.points, contour.closed) else { continue };
            let mut rim = |piece: &Piece| match piece.curve {
                Some(i) => printed.rims[i].take().map(layered::reversed),
                None => Some(layered::rim_of(&curve, piece.from, piece.length, top.z)),
            };
            let rims: Vec<Option<Rim>> = pieces.iter().map(&mut rim).collect();
            printed.rims[first.contour] = Some(layered::joined(rims, contour.closed));
        }
        printed.rims.truncate(contours.len());
    }

    /// Posts of one contour: on its own walls, else on whatever stands below.
    fn posts_of(&mut self, top: &Top, job: &Job, ground: &mut Ground) -> Option<Standing> {
        if job.carriers.iter().any(|&i| ground.rims[i].as_ref().is_some_and(|r| !r.printed)) {
            if let Some(standing) = self.on_peaks(top, job, ground) {
                return Some(standing);
            }
            self.print_bare_rims(job, ground);
        }
        let own: Vec<&Rim> = job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref()).collect();
        let support = self.is_support(top, job.curve);
        let kind = if support { Kind::Support } else { Kind::Post };
        let standing = self.stand_on(top, job, &own, kind);
        if standing.is_some() || !self.p.supports {
            return standing;
        }
        self.stand_on(top, job, &ground.all(), Kind::Support)
    }

    fn input<'b>(
        &self,
        top: &'b Top,
        job: &Job,
        curve: &'b Curve,
        carriers: &'b [&'b Rim],
        kept: &'b [Kept],
    ) -> ZigzagInput<'b> {
        let start = kept.first().map(|first| first.post.s).filter(|_| curve.is_closed());
        ZigzagInput {
            curve,
            z: top.z,
            start: start.unwrap_or_else(|| self.start(curve, carriers)),
            // A piece begins where its region ends, wherever the head may be.
            from: if top.piece(job.curve).is_some() { None } else { self.going_on(carriers) },
            rims: carriers,
            walls: &top.walls,
            wall: job.curve,
            least: self.head.clearance(top.z - lowest(carriers)),
            on_peaks: false,
            placement: self.p.placement,
            strand: self.p.strand,
            span_limit: self.p.span_limit,
            kept,
        }
    }

    fn stand_on(&mut self, top: &Top, job: &Job, carriers: &[&Rim], up: Kind) -> Option<Standing> {
        let curve = top.curves[job.curve].as_ref().filter(|_| !carriers.is_empty())?;
        let contour = top.contour(job.curve);
        let mut kept = self.guide.posts(top.slab, contour, curve, top.z);
        kept.retain(|_| up == Kind::Post);
        let input = self.input(top, job, curve, carriers, &kept);
        let limit = self.p.free_end_limit;
        let out = &self.out;
        let (start, mut steps) = zigzag(&input, self.head, |post| {
            post.base.distance(post.peak) <= limit && !out.is_barred(post.base, post.peak)
        });
        let piece = top.piece(job.curve);
        match piece {
            Some(piece) => self.slant(&mut steps, curve, piece, carriers),
            None => steps = met(curve, steps, self.p.span_limit),
        }
        let down = if up == Kind::Post { Kind::Diagonal } else { up };
        let mut posts = self.out.zigzag(&steps, up, down, self.p.span_limit);
        posts.retain(|post| post.base != post.peak);
        if up == Kind::Post {
            self.note(top, job, &posts);
        }
        if let Some(piece) = piece {
            posts = held(posts, curve, piece, top.z);
        }
        (!posts.is_empty()).then_some(Standing { curve: job.curve, start, posts })
    }

    /// Begins a zigzag with a stroke that leans away from the region before it, and ends it with a
    /// diagonal down to the region behind it, each from the region's foot.
    fn slant(&self, steps: &mut Vec<Step>, curve: &Curve, piece: &Piece, carriers: &[&Rim]) {
        let footing = Footing::new(carriers);
        let foot = |end: DVec2| footing.nearest(end).map(|f| f.position);
        if let Some(first) = steps.first_mut().filter(|_| piece.meets[0])
            && let Some(base) = foot(curve.position(0.0))
            && base.distance(first.post.peak) <= self.p.free_end_limit
            && !self.out.is_barred(base, first.post.peak)
        {
            first.post.base = base;
        }
        let end = foot(curve.position(curve.length())).filter(|_| piece.meets[1]);
        if let Some(base) = end.filter(|_| !steps.is_empty()) {
            let post = Post { base, peak: base, s: curve.length() };
            steps.push(Step { post, linked: true });
        }
    }

    fn note(&mut self, top: &Top, job: &Job, posts: &[Post]) {
        let (slab, contour) = (top.slab as u32, top.contour(job.curve) as u32);
        self.posts.extend(posts.iter().map(|&post| PlacedPost { post, slab, contour }));
    }

    /// The pattern without contours: every peak below carries a base. None where that is not to
    /// be had, for a peak left alone would hang in the air.
    fn on_peaks(&mut self, top: &Top, job: &Job, ground: &Ground) -> Option<Standing> {
        let curve = top.curves[job.curve].as_ref()?;
        let carriers: Vec<&Rim> =
            job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref()).collect();
        let [carrier] = carriers[..] else { return None };
        let mut input = self.input(top, job, curve, &carriers, &[]);
        input.on_peaks = true;
        let (out, limit) = (&self.out, self.p.free_end_limit);
        let (start, steps) = zigzag(&input, self.head, |post| {
            post.base.distance(post.peak) <= limit && !out.is_barred(post.base, post.peak)
        });
        if steps.len() != carrier.points.len() || steps.iter().skip(1).any(|s| !s.linked) {
            return None;
        }
        let posts = self.out.zigzag(&steps, Kind::Post, Kind::Diagonal, self.p.span_limit);
        self.note(top, job, &posts);
        Some(Standing { curve: job.curve, start, posts })
    }

    /// Contours through bare peaks are printed before anything stands beside them, for it is not
    /// sure that the chain of peaks can go on among neighbours.
    fn print_crowded_rims(&mut self, top: &Top, jobs: &[Job], ground: &mut Ground) {
        if self.p.pattern != Pattern::Peaks {
            return;
        }
        let boxes: Vec<(DVec2, DVec2)> = jobs.iter().map(|job| room(top, job, ground)).collect();
        let near = |a: &(DVec2, DVec2), b: &(DVec2, DVec2)| {
            (a.0 - b.1).max(b.0 - a.1).max_element() < top.reach
        };
        for (k, job) in jobs.iter().enumerate() {
            if boxes.iter().enumerate().any(|(i, other)| i != k && near(&boxes[k], other)) {
                self.print_bare_rims(job, ground);
            }
        }
    }

    /// Prints the contours through peaks that were to do without one.
    fn print_bare_rims(&mut self, job: &Job, ground: &mut Ground) {
        for &i in &job.carriers {
            if let Some(rim) = ground.rims[i].as_mut().filter(|rim| !rim.printed) {
                rim.printed = true;
                rim.points.rotate_right(1);
                let mut path = rim.points.clone();
                path.extend(rim.closed.then_some(path[0]));
                self.out.polyline(&path, Kind::Contour);
            }
        }
    }

    /// Prints the contour through its posts, or leaves it out where the pattern does without.
    fn ring(&mut self, top: &Top, standing: &Standing) -> Rim {
        let Some(curve) = &top.curves[standing.curve] else { return Rim::default() };
        let peaks = || standing.posts.iter().map(|p| p.peak).collect();
        if self.p.pattern == Pattern::Peaks && self.needs_no_ring(top, standing) {
            let closed = curve.is_closed();
            return Rim { points: peaks(), closed, ..Rim::default() };
        }
        let support = self.is_support(top, standing.curve);
        let kind = if support { Kind::Support } else { Kind::Contour };
        self.follow(curve, standing, top.z, kind)
    }

    fn is_support(&self, top: &Top, curve: usize) -> bool {
        self.sliced.lower[top.slab + 1][top.contour(curve)].support
    }

    /// Prints a contour in the air, without the stretches that would hang too far.
    pub(in crate::wireframe) fn follow(
        &mut self,
        curve: &Curve,
        standing: &Standing,
        z: f64,
        kind: Kind,
    ) -> Rim {
        let (tolerance, longest) = (FOLLOW * self.p.strand, self.p.span_limit);
        let course = Course { start: standing.start, z, tolerance, longest, kind };
        let (rim, left_out) = self.out.ring(curve, &standing.posts, &course);
        if left_out > 0.0 {
            let area = left_out * self.p.strand;
            self.leave_out(z, z, area, curve.position(standing.start), Reason::WideSpan);
        }
        rim
    }

    /// Whether a contour only leads from one plain slab to the next.
    fn needs_no_ring(&self, top: &Top, standing: &Standing) -> bool {
        let level = top.slab + 1;
        let Some(above) = self.sliced.strips.get(level) else { return false };
        let contour = standing.curve as u32;
        // Layers stand on contours, and a piece of one begins and ends on layers.
        let plain = self.layered.slab(level).is_none() && top.piece(standing.curve).is_none();
        plain
            && standing.posts.len() > 2
            && self.sliced.ledges[level].is_none()
            && above.iter().any(|s| s.lower == [contour] && s.upper.len() == 1 && !s.roofed)
    }

    /// Prints the rings that had to wait, the nearest first.
    fn rings(&mut self, top: &Top, waiting: &[Standing], printed: &mut Ground) {
        let end = |s: &Standing| s.posts.last().map(|post| vec![post.peak.truncate()]);
        let mut order = Waiting::new(waiting.iter().map(|s| Vec::from_iter(end(s))).collect());
        while let Some(next) = order.take_nearest(self.place()) {
            let standing = &waiting[next];
            printed.rims[standing.curve] = Some(self.ring(top, standing));
        }
    }

    /// Contours with too few posts, or none, hang on their neighbours.
    fn hang_rest(&mut self, top: &Top, loose: Vec<Standing>, bare: &[&Job], printed: &mut Ground) {
        for standing in loose {
            let Some(curve) = &top.curves[standing.curve] else { continue };
            // A column that stands on one leg is no less a support.
            let standing = if self.is_support(top, standing.curve) {
                standing
            } else {
                let wide = self.tie_over(top, curve);
                self.tighten(curve, top.z, top.slab + 1, standing, printed, wide)
            };
            printed.rims[standing.curve] = Some(self.ring(top, &standing));
        }
        for job in bare {
            let Some(curve) = &top.curves[job.curve] else { continue };
            let contour = &self.sliced.lower[top.slab + 1][top.contour(job.curve)];
            let rim = self.hang(curve, top.z, top.slab + 1, contour, printed);
            if rim.is_none() && !contour.support {
                let born = job.carriers.is_empty();
                // What stands on something unprinted will stand once that is supported.
                if !born || self.sliced.strips[top.slab][job.strip].lower.is_empty() {
                    self.want_columns(curve, top.slab + 1);
                }
                let reason = if born { Reason::MidAir } else { Reason::NoFoothold };
                self.give_up(top.slab, job.strip, reason);
            }
            printed.rims[job.curve] = rim;
            self.floor(top, job, printed);
        }
    }

    /// Closes what begins within the slab, and asks for a roof under what leans too far.
    fn floor(&mut self, top: &Top, job: &Job, printed: &mut Ground) {
        let strip = &self.sliced.strips[top.slab][job.strip];
        let contours = &self.sliced.lower[top.slab + 1];
        let last = strip.upper.iter().all(|&i| printed.rims[i as usize].is_some());
        if strip.lower.is_empty() && last && strip.closes(contours, &strip.upper) {
            self.close(top.slab + 1, &strip.upper, printed);
        } else if !job.carriers.is_empty() && !strip.roofed && leans(strip) {
            self.wants.roofs.push((top.slab, job.strip));
        }
    }

    /// Whether a stretch of the contour hangs too far from posts.
    fn is_loose(&self, top: &Top, curve: &Curve, standing: &Standing) -> bool {
        let limit = self.loose_gap(top);
        gaps(curve, &standing.posts).any(|(_, gap)| gap > limit)
    }

    /// Contours with wider gaps between their posts are tied, mm.
    fn loose_gap(&self, top: &Top) -> f64 {
        let height = top.z - self.sliced.levels[top.slab].z;
        self.p.free_end_limit.max(LOOSE * self.head.clearance(height))
    }

    /// Over which gaps a loose contour is tied: where the plain print does without, only beside
    /// layers.
    fn tie_over(&self, top: &Top, curve: &Curve) -> f64 {
        if self.guide.is_empty() || self.was_tied(curve, top.z) {
            return self.wide_gap();
        }
        self.loose_gap(top)
    }

    /// The contours that this slab leads up to, with what carries them.
    fn jobs(&mut self, top: &Top, rims: &[Option<Rim>]) -> Vec<Job> {
        let (slab, mut jobs) = (top.slab, Vec::new());
        for (s, strip) in self.sliced.strips[slab].iter().enumerate() {
            if self.layered.has(slab, s) {
                continue;
            }
            let lower = strip.lower.iter().map(|&i| i as usize);
            let carriers: Vec<usize> = lower.filter(|&i| rims[i].is_some()).collect();
            if carriers.is_empty() && strip.upper.is_empty() && !strip.lower.is_empty() {
                self.give_up(slab, s, Reason::MidAir);
            }
            let own = |piece: &&Piece| strip.upper.contains(&(piece.contour as u32));
            let pieces = top.pieces.iter().filter(own).filter_map(|piece| piece.curve);
            let curves = strip.upper.iter().map(|&i| i as usize).chain(pieces);
            let job = |curve| Job { curve, carriers: carriers.clone(), strip: s };
            jobs.extend(curves.filter(|&i| top.curves[i].is_some()).map(job));
        }
        jobs
    }
}

/// The posts of a piece between regions, whose layers hold its contour like posts of no height.
fn held(posts: Vec<Post>, curve: &Curve, piece: &Piece, z: f64) -> Vec<Post> {
    let end = |s: f64| {
        let place = curve.position(s).extend(z);
        Post { base: place, peak: place, s }
    };
    let first = piece.meets[0].then(|| end(0.0));
    let last = piece.meets[1].then(|| end(curve.length()));
    first.into_iter().chain(posts).chain(last).collect()
}

/// How far a contour strays that becomes straight between its posts, mm, times its length, mm.
fn sag(curve: &Curve, standing: &Standing) -> f64 {
    let at = |s: f64| curve.station(standing.start, s.min(curve.length()));
    let chord = |(begin, gap): (f64, f64)| {
        let squares = at(begin).chord_error(&at(begin + gap));
        (squares * gap).sqrt()
    };
    gaps(curve, &standing.posts).map(chord).sum()
}

/// The rims that carry a contour, as polylines of the plan.
fn plans(job: &Job, ground: &Ground) -> Vec<Vec<DVec2>> {
    let rims = job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref());
    rims.map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect()
}

/// Whether a ring at the slab's top would stand in the way of zigzags still to come.
fn is_in_the_way(curve: &Curve, order: &Waiting, reach: f64) -> bool {
    let (low, high) = bounds(curve.points().iter().copied());
    order.is_near(low, high, reach)
}

/// The rectangle over which the posts of a contour stand.
fn room(top: &Top, job: &Job, ground: &Ground) -> (DVec2, DVec2) {
    let rims = job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref());
    let below = rims.flat_map(|rim| &rim.points).map(|p| p.truncate());
    let above = top.curves[job.curve].iter().flat_map(|curve| curve.points().iter().copied());
    bounds(below.chain(above))
}

/// Arc length at which each gap between posts begins, and its length, mm.
pub fn gaps<'a>(curve: &'a Curve, posts: &'a [Post]) -> impl Iterator<Item = (f64, f64)> + 'a {
    let first = posts.first().map_or(0.0, |p| p.s);
    let around = curve.is_closed().then(|| {
        let last = posts.last().map_or(0.0, |p| p.s);
        (last, curve.length() - last + first)
    });
    posts.windows(2).map(|p| (p[0].s, p[1].s - p[0].s)).chain(around)
}

/// Leaves out posts whose contour hangs too far on both sides to be printed: nothing would ever
/// meet their peaks.
fn met(curve: &Curve, steps: Vec<Step>, longest: f64) -> Vec<Step> {
    let posts: Vec<Post> = steps.iter().map(|step| step.post).collect();
    let short: Vec<bool> = gaps(curve, &posts).map(|(_, gap)| gap <= longest).collect();
    let before = |i: usize| match i.checked_sub(1) {
        Some(last) => short[last],
        None => curve.is_closed() && short.last().is_some_and(|&s| s),
    };
    let is_met = |i: usize| before(i) || short.get(i).is_some_and(|&s| s);
    let kept = steps.into_iter().enumerate().filter(|&(i, _)| is_met(i));
    kept.map(|(_, step)| step).collect()
}

/// Whether most of a strip is roof or floor, not wall.
fn leans(strip: &Strip) -> bool {
    strip.plan.abs() > LEANING * strip.area
}

fn lowest(rims: &[&Rim]) -> f64 {
    rims.iter().flat_map(|r| &r.points).map(|p| p.z).fold(f64::INFINITY, f64::min)
}
