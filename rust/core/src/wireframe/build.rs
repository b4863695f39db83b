//! From slices to strands, bottom up: contours, zigzags, caps, splits and merges.

use glam::{DVec2, DVec3};

use super::builder::Builder;
use super::curve::Curve;
use super::hatch::hatch;
use super::posts::{Post, even_spacing};
use super::rim::{Rim, nearest_of};
use super::strips::Strip;
use super::walls::Walls;
use super::zigzag::{Placement, ZigzagInput, zigzag};
use super::{Kind, PlacedPost, Reason, Sliced, Unprinted, WireParams, Wireframe};
use crate::contours::Contour;
use crate::head::Head;

/// A contour printed on top of another lies higher by this part of the strand's diameter.
const LIFT: f64 = 0.4;
/// Contours shorter than this many strand diameters are printed as a dot: the post's end.
const DOT: f64 = 6.0;
/// A contour printed in the air follows the model to this part of the strand's diameter.
const FOLLOW: f64 = 0.5;
/// A contour printed on the bed follows the model to this, mm.
const BED_FOLLOW: f64 = 0.05;

/// A contour to be printed at the top of a slab.
struct Job {
    contour: usize,
    carriers: Vec<usize>,
    strip: usize,
}

/// A contour whose posts stand, waiting for its ring.
struct Standing {
    contour: usize,
    start: f64,
    posts: Vec<Post>,
}

struct Build<'a> {
    sliced: &'a Sliced,
    p: &'a WireParams,
    head: &'a Head,
    out: Builder<'a>,
    posts: Vec<PlacedPost>,
    unprinted: Vec<Unprinted>,
}

/// Lays the strands of a sliced model.
#[must_use]
pub fn build(sliced: Sliced, head: &Head, p: &WireParams) -> Wireframe {
    let (low, high) = sliced.plan();
    let tallest = sliced.levels.windows(2).map(|l| l[1].z - l[0].z).fold(1.0, f64::max);
    let out = Builder::new(head, p.strand, head.clearance(tallest), low, high);
    let mut build =
        Build { sliced: &sliced, p, head, out, posts: Vec::new(), unprinted: Vec::new() };
    build.run();
    let Build { out, posts, unprinted, .. } = build;
    let strands = out.strands;
    Wireframe { posts, strands, unprinted, sliced }
}

impl Build<'_> {
    fn run(&mut self) {
        let Some(first) = self.sliced.levels.first() else { return };
        let mut rims = self.on_bed(first.z);
        for slab in 0..self.sliced.levels.len() - 1 {
            self.roofs_of_slab(slab, &rims);
            let printed = self.slab(slab, &rims);
            rims = self.transition(slab + 1, &printed);
        }
    }

    /// The first contours, pressed onto the bed, and the floors within them.
    fn on_bed(&mut self, z: f64) -> Vec<Option<Rim>> {
        self.out.begin_slab(0);
        let contours = &self.sliced.upper[0];
        let mut rims: Vec<Option<Rim>> = vec![None; contours.len()];
        let mut waiting: Vec<usize> = (0..contours.len()).collect();
        while let Some(i) = self.take_nearest(&mut waiting, contours) {
            let Some(curve) = Curve::new(&contours[i].points, contours[i].closed) else { continue };
            let start = self.seam(&curve);
            rims[i] = Some(self.out.ring(&curve, start, &[], z, BED_FOLLOW));
        }
        for floor in self.sliced.ledges[0].iter().flatten() {
            self.close(0, contours, floor, &floor.upper, &rims);
        }
        rims
    }

    /// Takes the contour nearest to the head out of the list.
    fn take_nearest(&self, waiting: &mut Vec<usize>, contours: &[Contour]) -> Option<usize> {
        let at = self.out.at().map_or(DVec2::ZERO, DVec3::truncate);
        let distance = |i: usize| {
            contours[i].points.iter().map(|p| p.distance_squared(at)).fold(f64::INFINITY, f64::min)
        };
        let best = (0..waiting.len())
            .map(|k| (distance(waiting[k]), k))
            .min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(waiting.remove(best.1))
    }

    /// Arc length where a ring that follows no strand begins: its corner nearest to the head.
    fn seam(&self, curve: &Curve) -> f64 {
        if !curve.is_closed() {
            return 0.0;
        }
        let at = self.out.at().map_or(DVec2::ZERO, DVec3::truncate);
        let off = |s: f64| curve.position(s).distance_squared(at);
        curve
            .corners(0.6, 1.0)
            .into_iter()
            .min_by(|a, b| off(*a).total_cmp(&off(*b)))
            .unwrap_or_else(|| curve.nearest(at).s)
    }

    /// Zigzags and rings of one slab; the rims of its upper contours.
    fn slab(&mut self, slab: usize, rims: &[Option<Rim>]) -> Vec<Option<Rim>> {
        self.out.begin_slab(slab as u32);
        let contours = &self.sliced.lower[slab + 1];
        let z = self.sliced.levels[slab + 1].z;
        let curves: Vec<Option<Curve>> =
            contours.iter().map(|c| Curve::new(&c.points, c.closed)).collect();
        let reach = self.head.clearance(z - self.sliced.levels[slab].z) * 1.1;
        let walls = Walls::new(&curves, reach);
        let mut printed: Vec<Option<Rim>> = vec![None; contours.len()];
        let mut jobs = self.jobs(slab, rims);
        let mut waiting: Vec<Standing> = Vec::new();
        let mut bare: Vec<Job> = Vec::new();
        while let Some(job) = self.next_job(&mut jobs, rims) {
            let Some(curve) = &curves[job.contour] else { continue };
            if job.carriers.is_empty() {
                bare.push(job);
                continue;
            }
            let carriers: Vec<&Rim> =
                job.carriers.iter().filter_map(|&i| rims[i].as_ref()).collect();
            let start = self.start(curve, &carriers);
            let input = ZigzagInput {
                curve,
                z,
                start,
                rims: &carriers,
                walls: &walls,
                wall: job.contour,
                least: self.head.clearance(z - lowest(&carriers)),
                on_peaks: false,
                placement: self.p.placement,
                strand: self.p.strand,
                span_limit: self.p.span_limit,
            };
            let limit = self.p.free_end_limit;
            let out = &self.out;
            let (start, steps) = zigzag(&input, self.head, |post| {
                post.base.distance(post.peak) <= limit && !out.is_hit(post.base, post.peak)
            });
            let posts = self.out.zigzag(&steps, Kind::Post, Kind::Diagonal, self.p.span_limit);
            if posts.is_empty() {
                bare.push(job);
                continue;
            }
            self.posts.extend(posts.iter().map(|&post| PlacedPost {
                post,
                slab: slab as u32,
                contour: job.contour as u32,
            }));
            let standing = Standing { contour: job.contour, start, posts };
            if self.in_the_way(curve, &jobs, rims, reach) {
                waiting.push(standing);
            } else {
                printed[job.contour] = Some(self.ring(curve, &standing, z));
            }
        }
        while !waiting.is_empty() {
            let at = self.out.at().unwrap_or_default();
            let end = |s: &Standing| s.posts.last().map_or(f64::INFINITY, |p| p.peak.distance(at));
            let next = (0..waiting.len())
                .min_by(|&a, &b| end(&waiting[a]).total_cmp(&end(&waiting[b])))
                .map(|i| waiting.remove(i));
            if let Some(standing) = next
                && let Some(curve) = &curves[standing.contour]
            {
                printed[standing.contour] = Some(self.ring(curve, &standing, z));
            }
        }
        for job in bare {
            let Some(curve) = &curves[job.contour] else { continue };
            let neighbours: Vec<&Rim> = printed.iter().flatten().collect();
            printed[job.contour] = self.tie(curve, z, &neighbours);
            if printed[job.contour].is_none() {
                let born = job.carriers.is_empty();
                let reason = if born { Reason::MidAir } else { Reason::NoFoothold };
                self.give_up(slab, job.strip, reason);
            }
        }
        printed
    }

    fn ring(&mut self, curve: &Curve, standing: &Standing, z: f64) -> Rim {
        if curve.is_closed() && curve.length() < DOT * self.p.strand {
            let points = standing.posts.iter().map(|p| p.peak).collect();
            return Rim { points, closed: false };
        }
        let follow = FOLLOW * self.p.strand;
        self.out.ring(curve, standing.start, &standing.posts, z, follow)
    }

    /// The contours that this slab leads up to, with what carries them.
    fn jobs(&mut self, slab: usize, rims: &[Option<Rim>]) -> Vec<Job> {
        let mut jobs = Vec::new();
        for (s, strip) in self.sliced.strips[slab].iter().enumerate() {
            let carriers: Vec<usize> =
                strip.lower.iter().map(|&i| i as usize).filter(|&i| rims[i].is_some()).collect();
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

    /// Where a chain of posts begins: over the end of the last strand if that lies on a carrier,
    /// else over the carriers' vertex nearest to the head.
    fn start(&self, curve: &Curve, carriers: &[&Rim]) -> f64 {
        if !curve.is_closed() {
            return 0.0;
        }
        let at = self.out.at().unwrap_or_default();
        let vertices = carriers.iter().flat_map(|r| &r.points);
        let nearest = vertices.min_by(|a, b| a.distance(at).total_cmp(&b.distance(at)));
        curve.nearest(nearest.copied().unwrap_or(at).truncate()).s
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

    /// Hangs a contour that no post can reach on its printed neighbours, by strokes in its plane.
    fn tie(&mut self, curve: &Curve, z: f64, neighbours: &[&Rim]) -> Option<Rim> {
        let standing = self.spokes(curve, z, neighbours)?;
        Some(self.ring(curve, &standing, z))
    }

    /// A flat zigzag from printed rims out (or in) to a contour of the same height.
    fn spokes(&mut self, curve: &Curve, z: f64, carriers: &[&Rim]) -> Option<Standing> {
        if carriers.is_empty() {
            return None;
        }
        let walls = Walls::new(&[], 1.0);
        let start = self.start(curve, carriers);
        let input = ZigzagInput {
            curve,
            z,
            start,
            rims: carriers,
            walls: &walls,
            wall: 0,
            least: even_spacing(curve.length(), 0.8 * self.p.cap_spacing),
            on_peaks: false,
            placement: Placement::Optimal,
            strand: self.p.strand,
            span_limit: self.p.span_limit,
        };
        let limit = self.p.free_end_limit;
        let (start, steps) =
            zigzag(&input, self.head, |post| post.base.distance(post.peak) <= limit);
        let posts = self.out.zigzag(&steps, Kind::Cap, Kind::Cap, self.p.span_limit);
        let contour = usize::MAX;
        (!posts.is_empty()).then_some(Standing { contour, start, posts })
    }

    /// From the contours that end a slab to those that begin the next: the same rim where they
    /// are the same curve; where they are not (a split, a merge, a step), printed on top.
    fn transition(&mut self, level: usize, printed: &[Option<Rim>]) -> Vec<Option<Rim>> {
        let contours = &self.sliced.upper[level];
        let z = self.sliced.levels[level].z;
        let mut rims: Vec<Option<Rim>> = vec![None; contours.len()];
        let Some(ledges) = &self.sliced.ledges[level] else {
            rims.clone_from_slice(printed);
            return rims;
        };
        for ledge in ledges {
            if ledge.upper.is_empty() {
                self.close(level, &self.sliced.lower[level], ledge, &ledge.lower, printed);
                continue;
            }
            let born = ledge.lower.is_empty();
            for &u in &ledge.upper {
                let contour = &contours[u as usize];
                let Some(curve) = Curve::new(&contour.points, contour.closed) else { continue };
                rims[u as usize] = self.on_top(&curve, z, ledge, printed);
                if rims[u as usize].is_none() {
                    self.unprinted.push(Unprinted {
                        low: z,
                        high: z,
                        area: ledge.area,
                        place: curve.position(0.0).extend(z),
                        reason: Reason::MidAir,
                    });
                }
            }
            if born {
                self.close(level, contours, ledge, &ledge.upper, &rims);
            }
        }
        rims
    }

    /// One upper contour of a ledge: on the rims that the ledge touches or, if it begins in the
    /// air, beside the rims around it.
    fn on_top(
        &mut self,
        curve: &Curve,
        z: f64,
        ledge: &Strip,
        printed: &[Option<Rim>],
    ) -> Option<Rim> {
        let carriers: Vec<&Rim> =
            ledge.lower.iter().filter_map(|&i| printed[i as usize].as_ref()).collect();
        if let ([rim], [_], [_]) = (&carriers[..], &ledge.lower[..], &ledge.upper[..])
            && follows(curve, rim, self.p.strand)
        {
            return Some((*rim).clone());
        }
        if ledge.lower.is_empty() {
            let neighbours: Vec<&Rim> = printed.iter().flatten().collect();
            return self.tie(curve, z, &neighbours);
        }
        let lifted = z + LIFT * self.p.strand;
        let standing = self.spokes(curve, lifted, &carriers)?;
        Some(self.ring(curve, &standing, lifted))
    }

    /// Closes what ends at the foot of this slab.
    fn roofs_of_slab(&mut self, slab: usize, rims: &[Option<Rim>]) {
        for strip in &self.sliced.strips[slab] {
            if strip.upper.is_empty() {
                self.close(slab, &self.sliced.upper[slab], strip, &strip.lower, rims);
            }
        }
    }

    /// Closes the region within an odd number of a piece's contours, as they were printed, where
    /// the piece does close them.
    fn close(
        &mut self,
        level: usize,
        contours: &[Contour],
        piece: &Strip,
        which: &[u32],
        rims: &[Option<Rim>],
    ) {
        let all_printed = which.iter().all(|&i| rims[i as usize].is_some());
        if !self.p.caps || !all_printed || !piece.closes(contours, which) {
            return;
        }
        let rings: Vec<&Rim> = which
            .iter()
            .filter(|&&i| contours[i as usize].closed)
            .filter_map(|&i| rims[i as usize].as_ref())
            .filter(|rim| rim.closed && rim.points.len() > 2)
            .collect();
        let Some(z) = rings.first().map(|rim| rim.points[0].z) else { return };
        let plan: Vec<Vec<DVec2>> =
            rings.iter().map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect();
        let longest = if level == 0 { f64::INFINITY } else { self.p.span_limit };
        let (lines, dropped) = hatch(&plan, self.p.cap_spacing, longest);
        for line in lines {
            let line: Vec<DVec3> = line.into_iter().map(|p| p.extend(z)).collect();
            self.out.polyline(&line, Kind::Cap);
        }
        if dropped > 0.0 {
            let (low, high, reason) = (z, z, Reason::WideRoof);
            let place = plan[0][0].extend(z);
            let area = dropped * self.p.cap_spacing;
            self.unprinted.push(Unprinted { low, high, area, place, reason });
        }
    }

    fn give_up(&mut self, slab: usize, strip: usize, reason: Reason) {
        let piece = &self.sliced.strips[slab][strip];
        let (low, high) = (self.sliced.levels[slab].z, self.sliced.levels[slab + 1].z);
        let upper = piece.upper.first().and_then(|&i| {
            self.sliced.lower[slab + 1][i as usize].points.first().map(|p| p.extend(high))
        });
        let lower = piece.lower.first().and_then(|&i| {
            self.sliced.upper[slab][i as usize].points.first().map(|p| p.extend(low))
        });
        let place = upper.or(lower).unwrap_or_default();
        self.unprinted.push(Unprinted { low, high, area: piece.area, place, reason });
    }
}

fn lowest(rims: &[&Rim]) -> f64 {
    rims.iter().flat_map(|r| &r.points).map(|p| p.z).fold(f64::INFINITY, f64::min)
}

fn bounds(points: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |b, p| (b.0.min(p), b.1.max(p)))
}

/// Whether a printed rim lies under the whole contour.
fn follows(curve: &Curve, rim: &Rim, strand: f64) -> bool {
    let count = (curve.length() / strand).ceil().max(4.0) as usize;
    (0..count).all(|i| {
        let place = curve.position(curve.length() * i as f64 / count as f64);
        nearest_of(&[rim], place).is_some_and(|f| f.distance < strand)
    })
}
