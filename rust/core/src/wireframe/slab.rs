//! One slab: posts and diagonals up to each contour of its upper slice, then that contour.

use glam::{DVec2, DVec3};

use super::build::{Build, Ground, Standing};
use super::builder::Course;
use super::curve::Curve;
use super::posts::Post;
use super::rim::Rim;
use super::strips::Strip;
use super::walls::Walls;
use super::zigzag::{ZigzagInput, zigzag};
use super::{Kind, Pattern, PlacedPost, Reason};

/// A contour printed in the air follows the model to this part of the strand's diameter.
const FOLLOW: f64 = 0.5;
/// Stretches between posts longer than this many least spacings, and than the longest free end,
/// are tied.
const LOOSE: f64 = 2.6;

/// A contour to be printed at the top of a slab.
pub struct Job {
    /// Its number within the slice.
    pub contour: usize,
    /// Contours of the slice below whose rims carry it.
    pub carriers: Vec<usize>,
    /// The strip between them.
    pub strip: usize,
}

/// A strip with more than this share of its area in plan leans more than it stands.
const LEANING: f64 = 0.9;

/// What all contours of one slab share.
struct Top {
    slab: usize,
    z: f64,
    curves: Vec<Option<Curve>>,
    walls: Walls,
    /// Distance within which what stands in this slab bars the head.
    reach: f64,
}

impl Build<'_> {
    /// Prints one slab; gives what stands at its top.
    pub(super) fn slab(&mut self, slab: usize, ground: &mut Ground) -> Ground {
        self.out.begin_slab(slab as u32);
        let contours = &self.sliced.lower[slab + 1];
        let z = self.sliced.levels[slab + 1].z;
        let curves: Vec<Option<Curve>> =
            contours.iter().map(|c| Curve::new(&c.points, c.closed)).collect();
        let reach = self.head.clearance(z - self.sliced.levels[slab].z) * 1.1;
        let walls = Walls::new(&curves, reach);
        let top = Top { slab, z, curves, walls, reach };
        let mut printed = Ground { rims: vec![None; contours.len()], lines: Vec::new() };
        let mut jobs = self.jobs(slab, &ground.rims);
        let (mut waiting, mut loose, mut bare) = (Vec::new(), Vec::new(), Vec::new());
        while let Some(job) = self.next_job(&mut jobs, &ground.rims) {
            let Some(curve) = &top.curves[job.contour] else { continue };
            let Some(standing) = self.posts_of(&top, &job, ground) else {
                bare.push(job);
                continue;
            };
            if self.is_loose(curve, &standing, z - self.sliced.levels[slab].z) {
                loose.push(standing);
            } else if self.in_the_way(curve, &jobs, &ground.rims, top.reach) {
                waiting.push(standing);
            } else {
                printed.rims[job.contour] = Some(self.ring(&top, &standing));
            }
        }
        self.rings(&top, waiting, &mut printed);
        self.hang_rest(&top, loose, &bare, &mut printed);
        printed
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
        let support = self.sliced.lower[top.slab + 1][job.contour].support;
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
    ) -> ZigzagInput<'b> {
        ZigzagInput {
            curve,
            z: top.z,
            start: self.start(curve, carriers),
            from: self.going_on(carriers),
            rims: carriers,
            walls: &top.walls,
            wall: job.contour,
            least: self.head.clearance(top.z - lowest(carriers)),
            on_peaks: false,
            placement: self.p.placement,
            strand: self.p.strand,
            span_limit: self.p.span_limit,
        }
    }

    fn stand_on(&mut self, top: &Top, job: &Job, carriers: &[&Rim], up: Kind) -> Option<Standing> {
        let curve = top.curves[job.contour].as_ref().filter(|_| !carriers.is_empty())?;
        let input = self.input(top, job, curve, carriers);
        let limit = self.p.free_end_limit;
        let out = &self.out;
        let (start, steps) = zigzag(&input, self.head, |post| {
            post.base.distance(post.peak) <= limit && !out.is_hit(post.base, post.peak)
        });
        let down = if up == Kind::Post { Kind::Diagonal } else { up };
        let posts = self.out.zigzag(&steps, up, down, self.p.span_limit);
        if up == Kind::Post {
            self.note(top, job, &posts);
        }
        (!posts.is_empty()).then_some(Standing { contour: job.contour, start, posts })
    }

    fn note(&mut self, top: &Top, job: &Job, posts: &[Post]) {
        let (slab, contour) = (top.slab as u32, job.contour as u32);
        self.posts.extend(posts.iter().map(|&post| PlacedPost { post, slab, contour }));
    }

    /// The pattern without contours: every peak below carries a base. None where that is not to
    /// be had, for a peak left alone would hang in the air.
    fn on_peaks(&mut self, top: &Top, job: &Job, ground: &Ground) -> Option<Standing> {
        let curve = top.curves[job.contour].as_ref()?;
        let carriers: Vec<&Rim> =
            job.carriers.iter().filter_map(|&i| ground.rims[i].as_ref()).collect();
        let [carrier] = carriers[..] else { return None };
        let mut input = self.input(top, job, curve, &carriers);
        input.on_peaks = true;
        let out = &self.out;
        let (start, steps) = zigzag(&input, self.head, |post| !out.is_hit(post.base, post.peak));
        if steps.len() != carrier.points.len() || steps.iter().skip(1).any(|s| !s.linked) {
            return None;
        }
        let posts = self.out.zigzag(&steps, Kind::Post, Kind::Diagonal, self.p.span_limit);
        self.note(top, job, &posts);
        Some(Standing { contour: job.contour, start, posts })
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
        let Some(curve) = &top.curves[standing.contour] else { return Rim::default() };
        let peaks = || standing.posts.iter().map(|p| p.peak).collect();
        if self.p.pattern == Pattern::Peaks && self.needs_no_ring(top.slab + 1, standing) {
            let closed = curve.is_closed();
            return Rim { points: peaks(), closed, ..Rim::default() };
        }
        let support = self.sliced.lower[top.slab + 1][standing.contour].support;
        let kind = if support { Kind::Support } else { Kind::Contour };
        self.follow(curve, standing, top.z, kind)
    }

    /// Prints a contour in the air, without the stretches that would hang too far.
    pub(super) fn follow(&mut self, curve: &Curve, standing: &Standing, z: f64, kind: Kind) -> Rim {
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
    fn needs_no_ring(&self, level: usize, standing: &Standing) -> bool {
        let Some(above) = self.sliced.strips.get(level) else { return false };
        let contour = standing.contour as u32;
        standing.posts.len() > 2
            && self.sliced.ledges[level].is_none()
            && above.iter().any(|s| s.lower == [contour] && s.upper.len() == 1)
    }

    /// Prints the rings that had to wait, the nearest first.
    fn rings(&mut self, top: &Top, mut waiting: Vec<Standing>, printed: &mut Ground) {
        while !waiting.is_empty() {
            let at = self.out.at().unwrap_or_default();
            let end = |s: &Standing| s.posts.last().map_or(f64::INFINITY, |p| p.peak.distance(at));
            let nearest =
                (0..waiting.len()).min_by(|&a, &b| end(&waiting[a]).total_cmp(&end(&waiting[b])));
            let Some(standing) = nearest.map(|i| waiting.remove(i)) else { return };
            printed.rims[standing.contour] = Some(self.ring(top, &standing));
        }
    }

    /// Contours with too few posts, or none, hang on their neighbours.
    fn hang_rest(&mut self, top: &Top, loose: Vec<Standing>, bare: &[Job], printed: &mut Ground) {
        for standing in loose {
            let Some(curve) = &top.curves[standing.contour] else { continue };
            let contour = &self.sliced.lower[top.slab + 1][standing.contour];
            // A column that stands on one leg is no less a support.
            let standing = if contour.support {
                standing
            } else {
                self.tighten(curve, top.z, top.slab + 1, standing, printed)
            };
            printed.rims[standing.contour] = Some(self.ring(top, &standing));
        }
        for job in bare {
            let Some(curve) = &top.curves[job.contour] else { continue };
            let contour = &self.sliced.lower[top.slab + 1][job.contour];
            let rim = self.hang(curve, top.z, top.slab + 1, contour, printed);
            if rim.is_none() && !contour.support {
                let born = job.carriers.is_empty();
                let reason = if born { Reason::MidAir } else { Reason::NoFoothold };
                self.give_up(top.slab, job.strip, reason);
            }
            printed.rims[job.contour] = rim;
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
    fn is_loose(&self, curve: &Curve, standing: &Standing, height: f64) -> bool {
        let limit = self.p.free_end_limit.max(LOOSE * self.head.clearance(height));
        gaps(curve, &standing.posts).any(|(_, gap)| gap > limit)
    }

    /// The contours that this slab leads up to, with what carries them.
    fn jobs(&mut self, slab: usize, rims: &[Option<Rim>]) -> Vec<Job> {
        let mut jobs = Vec::new();
        for (s, strip) in self.sliced.strips[slab].iter().enumerate() {
            let lower = strip.lower.iter().map(|&i| i as usize);
            let carriers: Vec<usize> = lower.filter(|&i| rims[i].is_some()).collect();
            if carriers.is_empty() && strip.upper.is_empty() && !strip.lower.is_empty() {
                self.give_up(slab, s, Reason::MidAir);
            }
            jobs.extend(strip.upper.iter().map(|&contour| Job {
                contour: contour as usize,
                carriers: carriers.clone(),
                strip: s,
            }));
        }
        jobs
    }

    /// The job whose carriers come nearest to the head.
    fn next_job(&self, jobs: &mut Vec<Job>, rims: &[Option<Rim>]) -> Option<Job> {
        let at = self.out.at().map_or(DVec2::ZERO, DVec3::truncate);
        let distance = |job: &Job| {
            let carriers = job.carriers.iter().filter_map(|&i| rims[i].as_ref());
            carriers
                .flat_map(|r| &r.points)
                .map(|p| p.truncate().distance_squared(at))
                .fold(f64::INFINITY, f64::min)
        };
        let best =
            (0..jobs.len()).map(|k| (distance(&jobs[k]), k)).min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(jobs.remove(best.1))
    }

    /// Whether a ring at the slab's top would stand in the way of zigzags still to come.
    fn in_the_way(&self, curve: &Curve, jobs: &[Job], rims: &[Option<Rim>], reach: f64) -> bool {
        let (low, high) = bounds(curve.points().iter().copied());
        let carriers = jobs.iter().flat_map(|j| &j.carriers).filter_map(|&i| rims[i].as_ref());
        carriers.into_iter().any(|rim| {
            let (a, b) = bounds(rim.points.iter().map(|p| p.truncate()));
            (a - high).max(low - b).max_element() < reach
        })
    }
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

/// Whether most of a strip is roof or floor, not wall.
fn leans(strip: &Strip) -> bool {
    strip.plan.abs() > LEANING * strip.area
}

fn lowest(rims: &[&Rim]) -> f64 {
    rims.iter().flat_map(|r| &r.points).map(|p| p.z).fold(f64::INFINITY, f64::min)
}

fn bounds(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, p| (b.0.min(p), b.1.max(p)))
}
