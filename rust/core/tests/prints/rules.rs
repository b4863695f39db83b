//! What any print must keep, asked of every strand against every other one.

use std::fmt::Write;

use glam::DVec3;
use wireprint_core::mesh::Mesh;
use wireprint_core::strand::{Kind, Strand};

use crate::printer::Print;
use crate::solids::Random;

/// Distance of a point from a segment, mm.
fn distance(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let way = b - a;
    let t = ((p - a).dot(way) / way.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    p.distance(a + way * t)
}

/// What breaks a rule, in words; empty where nothing does.
#[derive(Debug, Default)]
pub struct Breaches(pub String);

impl Breaches {
    fn add(&mut self, number: usize, strand: &Strand, what: &str) {
        let Strand { from, to, kind, slab, .. } = strand;
        let _ = writeln!(self.0, "{number} {kind:?} in slab {slab} from {from} to {to}: {what}");
    }
}

/// All rules.
pub fn breaches(print: &Print) -> Breaches {
    let mut found = Breaches::default();
    held(print, &mut found);
    clear(print, &mut found);
    met(print, &mut found);
    steep(print, &mut found);
    placed(print, &mut found);
    found
}

/// Every strand begins and ends on the bed, on what is printed before, or goes on; what hangs between
/// two holds is no longer than a strand may span, and what ends in the air no longer than that may be.
fn held(print: &Print, found: &mut Breaches) {
    let (strands, wire) = (&print.frame.strands, &print.printer.wire);
    let place = Held { strands, strand: wire.strand };
    let mut hanging = 0.0;
    for (i, strand) in strands.iter().enumerate() {
        let goes_on = i > 0 && strands[i - 1].to == strand.from;
        if goes_on && strands[i - 1].floating {
            // The peak of a post hangs by the post alone.
            hanging = strands[i - 1].from.distance(strands[i - 1].to);
        } else if place.holds(strand.from, i - usize::from(goes_on)) {
            hanging = 0.0;
        } else if !goes_on {
            found.add(i, strand, "begins in the air");
        }
        let length = strand.from.distance(strand.to);
        if strand.floating {
            if length > wire.free_end_limit + 1e-6 {
                found.add(i, strand, "is too long a free end");
            }
            continue;
        }
        let (longest, last) = place.spans(strand, i, hanging, wire.span_limit);
        if longest > wire.span_limit + wire.strand {
            found.add(i, strand, "spans too much");
        }
        hanging = last;
        let next = strands.get(i + 1).is_some_and(|next| next.from == strand.to);
        // A strand may not hold its own end.
        if !next && !place.holds(strand.to, i) {
            found.add(i, strand, "ends in the air");
        }
    }
}

/// What holds strands.
struct Held<'a> {
    strands: &'a [Strand],
    /// Their diameter, mm.
    strand: f64,
}

impl Held<'_> {
    /// Whether a point lies on the bed, or what lies there, or touches one of the first strands.
    fn holds(&self, p: DVec3, first: usize) -> bool {
        p.z <= self.strand
            || self.strands[..first].iter().any(|s| distance(p, s.from, s.to) <= self.strand)
    }

    /// The longest stretch of a strand that nothing before holds, and the last one, mm, where it
    /// begins `hanging` mm behind what holds it. Looked at closely only where it might span `most`.
    fn spans(&self, strand: &Strand, number: usize, hanging: f64, most: f64) -> (f64, f64) {
        let length = strand.from.distance(strand.to);
        if hanging + length <= most {
            return (hanging + length, hanging + length);
        }
        let count = (2.0 * length / self.strand).ceil() as usize;
        let step = length / count as f64;
        let (mut longest, mut last) = (hanging, hanging);
        for k in 1..=count {
            last += step;
            longest = longest.max(last);
            if self.holds(strand.from.lerp(strand.to, k as f64 / count as f64), number) {
                last = 0.0;
            }
        }
        (longest, last)
    }
}

/// The head, on its way along a strand, meets nothing printed before by more than half its diameter.
fn clear(print: &Print, found: &mut Breaches) {
    let (strands, printer) = (&print.frame.strands, &print.printer);
    let most = 0.5 * printer.wire.strand + 1e-6;
    for (i, strand) in strands.iter().enumerate() {
        let way = [strand.from, strand.to];
        for other in &strands[..i] {
            if let Some(hit) = printer.head.deeper_than(most, way, [other.from, other.to]) {
                let what = format!("runs {:.2} mm into {} - {}", hit.depth, other.from, other.to);
                found.add(i, strand, &what);
            }
        }
    }
}

/// Whatever ends in the air is met by a strand that comes later.
fn met(print: &Print, found: &mut Breaches) {
    let strands = &print.frame.strands;
    for (i, strand) in strands.iter().enumerate().filter(|(_, s)| s.floating) {
        let near = |s: &Strand| distance(strand.to, s.from, s.to) <= print.printer.wire.strand;
        if !strands[i + 1..].iter().any(near) {
            found.add(i, strand, "is met by nothing");
        }
    }
}

/// What falls by more than strands are squashed does so no steeper than the flank, one tip's radius
/// beside what it falls from.
fn steep(print: &Print, found: &mut Breaches) {
    let head = &print.printer.head;
    let squash = 0.5 * print.printer.wire.strand;
    for (i, strand) in print.frame.strands.iter().enumerate() {
        let run = strand.from.truncate().distance(strand.to.truncate());
        let fall = strand.from.z - strand.to.z;
        if fall > squash && run + 1e-6 < head.tip_radius + fall / head.slope {
            found.add(i, strand, "is too steep");
        }
    }
}

/// Each post leads from what is printed up to its contour, and is printed; it must hold by itself, unless
/// it is no longer than a strand is thick.
fn placed(print: &Print, found: &mut Breaches) {
    let frame = &print.frame;
    for placed in &frame.posts {
        let level = placed.slab as usize + 1;
        let post = placed.post;
        let contour = &frame.sliced.lower[level][placed.contour as usize];
        let ends = contour.points.iter().zip(contour.points.iter().cycle().skip(1));
        let ends = ends.take(contour.points.len() - usize::from(!contour.closed));
        let z = frame.sliced.levels[level].z;
        let off = ends.map(|(a, b)| distance(post.peak, a.extend(z), b.extend(z)));
        let off = off.fold(f64::INFINITY, f64::min);
        let touches = |s: &Strand| s.from.distance(s.to) <= print.printer.wire.strand;
        let is_up = |s: &Strand| s.to.distance(post.peak) < 1e-5 && s.floating != touches(s);
        let up = frame.strands.iter().position(is_up);
        match up {
            Some(i) if off > 1e-6 => found.add(i, &frame.strands[i], "is no post of its contour"),
            Some(_) => {}
            None => found.0.push_str(&format!("the post at {} is not printed\n", post.peak)),
        }
    }
}

/// How far contours and posts lie apart, and how many of each there are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figures {
    pub posts: usize,
    pub diagonals: usize,
    /// Share of the posts above the lowest slab that stand on a peak.
    pub aligned: f64,
    /// Share of them that stand within a strand's diameter of one.
    pub on_joints: f64,
}

/// Posts, and how many of them stand on the peaks of those below.
pub fn figures(print: &Print) -> Figures {
    let posts = &print.frame.posts;
    let upper: Vec<_> = posts.iter().filter(|p| p.slab > 0).collect();
    let share = |near: f64| {
        let on_peak = upper.iter().filter(|upper| {
            let below = posts.iter().filter(|p| p.slab + 1 == upper.slab);
            below.map(|p| p.post.peak.distance(upper.post.base)).any(|off| off < near)
        });
        on_peak.count() as f64 / upper.len().max(1) as f64
    };
    Figures {
        posts: posts.len(),
        diagonals: print.count(Kind::Diagonal),
        aligned: share(1e-3),
        on_joints: share(print.printer.wire.strand),
    }
}

/// Mean and greatest distance of the contours above the bed from the strands of their slab, mm.
pub fn stray(print: &Print) -> (f64, f64) {
    let frame = &print.frame;
    let (mut sum, mut count, mut most) = (0.0, 0.0, 0.0_f64);
    for (level, contours) in frame.sliced.lower.iter().enumerate().skip(1) {
        let z = frame.sliced.levels[level].z;
        let slab: Vec<&Strand> =
            frame.strands.iter().filter(|s| s.slab as usize + 1 == level).collect();
        for contour in contours.iter().filter(|contour| !contour.support) {
            let ends = contour.points.iter().zip(contour.points.iter().cycle().skip(1));
            for (a, b) in ends.take(contour.points.len() - usize::from(!contour.closed)) {
                let place = a.midpoint(*b).extend(z);
                let off = slab.iter().map(|s| distance(place, s.from, s.to));
                let off = off.fold(f64::INFINITY, f64::min);
                let length = a.distance(*b);
                (sum, count, most) = (sum + off * length, count + length, most.max(off));
            }
        }
    }
    (sum / count.max(f64::MIN_POSITIVE), most)
}

/// Distances of places all over a surface from the nearest strand, mm, ascending.
pub fn bare(print: &Print, mesh: &Mesh) -> Vec<f64> {
    let mut found = Vec::new();
    let mut random = Random(11);
    let share = 1500.0 / mesh.area();
    for face in 0..mesh.faces.len() {
        let [a, b, c] = mesh.corners(face);
        let area = 0.5 * (b - a).cross(c - a).length();
        for _ in 0..(area * share + random.unit()) as usize {
            let (mut u, mut v) = (random.unit(), random.unit());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let place = a + (b - a) * u + (c - a) * v;
            let off = print.frame.strands.iter().map(|s| distance(place, s.from, s.to));
            found.push(off.fold(f64::INFINITY, f64::min));
        }
    }
    found.sort_by(f64::total_cmp);
    found
}
