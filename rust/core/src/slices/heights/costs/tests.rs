//! The cost of a slab, term by term, against the same written down plainly.

use glam::{DMat3, DVec2, DVec3};

use super::*;
use crate::climb::Climb;
use crate::mesh::Mesh;
use crate::printer::Printer;
use crate::slices::cut::cut_map;
use crate::slices::heights::outline::{Measure, RingShape};
use crate::slices::plane::{Plane, Side};
use crate::solids::{Random, moved, revolved, together};
use crate::wireframe::frame::PlacedPost;

/// The candidates, what is wanted, and what slices tell, all at random.
struct Case {
    heights: Vec<f64>,
    wanted: Vec<Wanted>,
    outlines: Vec<Outline>,
    mesh: Mesh,
}

impl Case {
    fn new(random: &mut Random) -> Self {
        let mut heights: Vec<f64> = (0..8).map(|_| random.between(0.35, 20.0)).collect();
        heights.sort_by(f64::total_cmp);
        let flag = |random: &mut Random| random.unit() < 0.4;
        let mut wanted: Vec<Wanted> = (0..5)
            .map(|_| {
                let (low, size) = (random.between(0.0, 21.0), random.between(1.0, 24.0));
                let (wide, begins, ends) = (flag(random), flag(random), flag(random));
                Wanted { low, high: low, size, wide, begins, ends }
            })
            .collect();
        wanted.sort_by(|a, b| a.low.total_cmp(&b.low));
        let outlines = heights.iter().map(|_| {
            let mut rings: Vec<RingShape> = (0..4)
                .map(|i| RingShape {
                    length: if i < 2 {
                        random.between(5.0, 25.0)
                    } else {
                        random.between(5.0, 90.0)
                    },
                    turning: random.between(0.0, 3.0),
                    middle: DVec2::new(random.between(0.0, 9.0), random.between(0.0, 5.0)),
                    closed: random.unit() < 0.9,
                })
                .collect();
            rings.sort_by(|a, b| a.length.total_cmp(&b.length));
            let length = rings.iter().map(|ring| ring.length).sum::<f64>() + 3.0;
            let turning = rings.iter().map(|ring| ring.turning).sum::<f64>() + 1.0;
            let mut near = |a: usize| {
                let b = if a == 0 { 3 } else { a - 1 };
                let gap = random.between(0.5, 12.0);
                (random.unit() < 0.4).then_some(NearWalls { walls: [a.min(b), a.max(b)], gap })
            };
            let near = (0..3).filter_map(&mut near).collect();
            Outline { rings, near, length, turning }
        });
        let outlines = outlines.collect();
        let (low, high) = (random.between(8.0, 30.0), random.between(8.0, 30.0));
        let middle = random.between(8.0, 30.0);
        let mesh = revolved(&[(low, 0.0), (middle, 11.0), (high, 22.0)], 24);
        Self { heights, wanted, outlines, mesh }
    }

    fn costs<'a>(&'a self, printer: &'a Printer) -> Costs<'a> {
        Costs {
            head: &printer.head,
            strokes: printer.strokes(),
            params: &printer.heights,
            profile: Profile::new(&self.mesh, 0.35, 22.0, 0.5),
            outlines: self.outlines.clone(),
            heights: &self.heights,
            wanted: &self.wanted,
        }
    }
}

/// What the slab costs from height to height, s.
fn plain(case: &Case, printer: &Printer, i: usize, j: usize) -> f64 {
    let (p, strokes) = (&printer.heights, printer.strokes());
    let (from, to) = (case.heights[i], case.heights[j]);
    let (height, end) = (to - from, p.free_end);
    let [low, high] = [&case.outlines[i], &case.outlines[j]];
    let length = (low.length + high.length) / 2.0;
    let run = strokes.run(height);
    // Each post goes straight up, its diagonal comes down over a run; the contour lies on them.
    let strokes_length = height + height.hypot(run);
    let per_mm = |seconds: f64| seconds / run + 1.0 / p.speed;
    let own = per_mm(p.pause + strokes_s(printer, height));
    let (mut time, mut quick) = (length * own, length * per_mm(0.5 + strokes_length / p.speed));
    let mut turning = (low.turning + high.turning) / 2.0;
    let profile = Profile::new(&case.mesh, 0.35, 22.0, 0.5);
    let (stray, leaning) = profile.deviation(from, to, 0.4 * end);
    let mut fines = 0.4 * (height / end).powi(2) + 80.0 * leaning / end.powi(2);
    for (one, other) in [(low, high), (high, low)] {
        for (number, ring) in one.rings.iter().enumerate() {
            let lacking = (3.0 - (ring.length / run).floor()).max(0.0);
            if lacking == 0.0 {
                continue;
            }
            let clearance = |rise: f64| 1.01 * printer.head.clearance(rise);
            let group = group(one, number, clearance(height));
            let gap = |ring: usize| {
                let near = one.near.iter().filter(move |near| near.walls.contains(&ring));
                near.map(|near| near.gap).fold(f64::INFINITY, f64::min)
            };
            let single = clearance(height / (height / (0.75 * p.strand)).ceil());
            let is_coiled = |&ring: &usize| {
                gap(ring) >= single && turns(printer, (one, other), ring, height) > 0.0
            };
            if group.iter().all(is_coiled) {
                let turns = turns(printer, (one, other), number, height);
                let fits = |&count: &usize| clearance(count as f64 * height / turns) <= gap(number);
                let at_once = (1..=turns as usize).rev().find(fits).unwrap_or(1);
                let lifts = (turns / at_once as f64).ceil();
                let coiled = (turns + 1.0) * ring.length / p.speed + (lifts - 1.0) * p.hop;
                time += (coiled - ring.length * own) / 2.0;
                turning -= ring.turning / 2.0;
            } else {
                fines += 0.5 * lacking * lacking;
            }
        }
    }
    let sag = run * strokes.paper_run(height) * turning / (12.0 * length);
    quick = quick.max(0.35 * time);
    if height < p.slab_min {
        fines += 1e4 * (p.slab_min - height) / p.slab_min;
    }
    for w in &case.wanted {
        if w.low <= from || w.low >= to {
            continue;
        }
        fines += 400.0 * w.size / end;
        let (below, above) = (w.low - from, to - w.low);
        let is_high = w.ends && below > 0.2 * end || w.begins && above > 0.2 * end;
        let out_of_reach = below.min(above) > p.slab_min / 2.0;
        fines += if (w.wide || is_high) && out_of_reach { 1e4 } else { 0.0 };
    }
    time + time.min(quick) * ((stray + sag) / p.deviation_target).powi(2) + fines
}

/// How long a post and its diagonal take, s: an axis that raises the head may be slower than both.
fn strokes_s(printer: &Printer, height: f64) -> f64 {
    let (p, diagonal) = (&printer.heights, height.hypot(printer.strokes().run(height)));
    p.climb.map_or((height + diagonal) / p.speed, |climb| {
        let rise = climb.takes(height, p.speed);
        rise + rise.max(diagonal / p.speed)
    })
}

/// The rings that stand near a ring, or near one that does, and so on, itself included.
fn group(of: &Outline, ring: usize, reach: f64) -> Vec<usize> {
    let mut found = vec![ring];
    let mut next = 0;
    while let Some(&one) = found.get(next) {
        next += 1;
        for near in of.near.iter().filter(|near| near.gap < reach && near.walls.contains(&one)) {
            let other = near.walls[0] + near.walls[1] - one;
            if !found.contains(&other) {
                found.push(other);
            }
        }
    }
    found
}

/// How many turns a ring's wall takes by itself; 0 where it is not worth a coil.
fn turns(printer: &Printer, (own, other): (&Outline, &Outline), ring: usize, height: f64) -> f64 {
    let (p, run, ring) = (&printer.heights, printer.strokes().run(height), &own.rings[ring]);
    let closed = other.rings.iter().filter(|to| ring.closed && to.closed);
    let leans = closed.map(|to| {
        let wider = (ring.length - to.length).abs() / std::f64::consts::TAU;
        (ring.middle.distance(to.middle) + wider) / height
    });
    let lean = leans.fold(f64::INFINITY, f64::min);
    let lacking = 3.0 - (ring.length / run).floor();
    if lacking <= 0.0 || lean > 1.5 || ring.length < 6.0 * p.strand {
        return 0.0;
    }
    let turns = (height * lean.hypot(1.0) / (0.75 * p.strand)).ceil();
    let post = p.pause + p.hop + strokes_s(printer, height);
    let zigzag = (ring.length / run).floor().max(1.0) * post + 4.0 * lacking * lacking;
    if turns * ring.length / p.speed < zigzag { turns } else { 0.0 }
}

#[test]
fn a_slab_costs_its_time_its_deviation_and_its_fines() {
    let mut random = Random(2);
    for number in 0..120 {
        let mut printer = Printer::all()[number % 3].clone();
        printer.heights.pause = random.between(0.0, 2.0);
        if number % 2 == 0 {
            let (speed, accel) = (random.between(2.0, 60.0), random.between(50.0, 5000.0));
            printer.heights.climb = Some(Climb { speed, accel });
        }
        let case = Case::new(&mut random);
        let costs = case.costs(&printer);
        for j in 1..case.heights.len() {
            for i in 0..j {
                let (own, wanted) = (costs.slab(i, j), plain(&case, &printer, i, j));
                assert!((own - wanted).abs() <= 1e-9 * wanted, "{own} is not {wanted}");
            }
        }
    }
}

#[test]
fn only_slabs_within_the_bounds_are_made() {
    let (mut random, printer) = (Random(4), Printer::paper());
    for _ in 0..60 {
        let case = Case::new(&mut random);
        let costs = case.costs(&printer);
        for (j, &top) in case.heights.iter().enumerate() {
            let p = &printer.heights;
            let fits = |&i: &usize| {
                let height = top - case.heights[i];
                i < j && (0.2 * p.slab_min..=p.slab_max).contains(&height)
            };
            let wanted: Vec<usize> = (0..j).filter(fits).collect();
            let found = costs.slabs_below(j);
            assert_eq!(found.iter().map(|slab| slab.0).collect::<Vec<_>>(), wanted);
            assert!(found.iter().all(|&(i, cost)| cost == costs.slab(i, j)));
        }
    }
}

#[test]
fn a_slab_of_nothing_costs_no_deviation() {
    let printer = Printer::paper();
    let nothing = Outline { rings: Vec::new(), near: Vec::new(), length: 0.0, turning: 0.0 };
    let case = Case {
        heights: vec![1.0, 5.0],
        wanted: Vec::new(),
        outlines: vec![nothing.clone(), nothing],
        mesh: Mesh::new(vec![DVec3::ZERO], Vec::new()),
    };
    let cost = case.costs(&printer).slab(0, 1);
    assert!((cost - 0.4 * 0.04).abs() < 1e-12, "{cost}");
}

/// Slim rods that lean, alone or in a row, near each other or not.
fn rods(random: &mut Random, printer: &Printer) -> Mesh {
    let strand = printer.wire.strand;
    let radius = random.between(2.0, 7.0) * strand;
    let (lean, height) = (random.between(0.0, 2.6), random.between(6.0, 14.0) * strand);
    let shear = DMat3::from_cols(DVec3::X, DVec3::Y, DVec3::new(lean, 0.0, 1.0));
    let pitch = 2.0 * radius + random.between(0.3, 16.0) * strand;
    let count = 1 + (random.unit() * 3.9) as u32;
    let rod = |i: u32| {
        let upright = revolved(&[(radius, 0.0), (radius, height)], 32);
        moved(&upright, shear, DVec3::Y * f64::from(i) * pitch)
    };
    together(&(0..count).map(rod).collect::<Vec<_>>())
}

/// What slabs are charged for as coils is what is coiled: ring by ring, but where a coil takes about as
/// long as posts.
#[test]
fn what_was_charged_is_what_is_laid() {
    let mut random = Random(31);
    let (mut alike, mut coiled, mut all) = (0, 0, 0);
    for number in 0..90 {
        let printer = &Printer::all()[number % 3];
        let mesh = rods(&mut random, printer);
        let frame = printer.print(&mesh).frame;
        let heights: Vec<f64> = frame.sliced.levels.iter().map(|level| level.z).collect();
        let planes: Vec<Plane> = heights.iter().map(|&z| Plane { z, side: Side::Below }).collect();
        let measure = Measure {
            strand: printer.wire.strand,
            free_end: printer.heights.free_end,
            roomy: f64::INFINITY,
            reach: f64::INFINITY,
        };
        let outlines = cut_map(&mesh, &planes, |loops| Outline::new(&loops, &measure));
        let costs = Costs {
            head: &printer.head,
            strokes: printer.strokes(),
            params: &printer.heights,
            profile: Profile::new(&mesh, 0.0, 1.0, 1.0),
            outlines,
            heights: &heights,
            wanted: &[],
        };
        for slab in 0..heights.len() - 1 {
            let height = heights[slab + 1] - heights[slab];
            let small = costs.small(height, printer.strokes().run(height));
            let [lower, upper] = [slab, slab + 1].map(|i| &costs.outlines[i]);
            let charged = costs.coiled(upper, lower, &small);
            for (ring, charged) in upper.rings.iter().zip(charged) {
                let stands = |placed: &PlacedPost| {
                    let contour = &frame.sliced.lower[slab + 1][placed.contour as usize];
                    let middle = contour.points.iter().sum::<DVec2>() / contour.points.len() as f64;
                    placed.slab as usize == slab
                        && middle.distance(ring.middle) < 0.4 * printer.wire.strand
                };
                let laid = !frame.posts.iter().any(stands);
                all += 1;
                coiled += usize::from(laid);
                alike += usize::from(laid == charged.is_some());
            }
        }
    }
    assert!(coiled > all / 4 && coiled < all, "{coiled} of {all} rings are coiled");
    assert!(alike as f64 > 0.9 * all as f64, "{alike} of {all} rings are as they were charged");
}
