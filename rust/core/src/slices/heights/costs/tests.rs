//! The cost of a slab, term by term, against the same written down plainly.

use glam::DVec3;

use super::*;
use crate::climb::Climb;
use crate::mesh::Mesh;
use crate::printer::Printer;
use crate::slices::heights::outline::Ring;
use crate::solids::{Random, revolved};

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
            let mut rings: Vec<Ring> = (0..3)
                .map(|_| Ring {
                    length: random.between(5.0, 120.0),
                    turning: random.between(0.0, 3.0),
                })
                .collect();
            rings.sort_by(|a, b| a.length.total_cmp(&b.length));
            let length = rings.iter().map(|ring| ring.length).sum::<f64>() + 3.0;
            let turning = rings.iter().map(|ring| ring.turning).sum::<f64>() + 1.0;
            Outline { rings, length, turning }
        });
        let outlines = outlines.collect();
        let (low, high) = (random.between(8.0, 30.0), random.between(8.0, 30.0));
        let middle = random.between(8.0, 30.0);
        let mesh = revolved(&[(low, 0.0), (middle, 11.0), (high, 22.0)], 24);
        Self { heights, wanted, outlines, mesh }
    }

    fn costs<'a>(&'a self, printer: &'a Printer) -> Costs<'a> {
        Costs {
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
    // An axis that raises the head may be slower than both strokes.
    let takes = p.climb.map_or(strokes_length / p.speed, |climb| {
        let rise = climb.takes(height, p.speed);
        rise + rise.max(height.hypot(run) / p.speed)
    });
    let own = per_mm(p.pause + takes);
    let (mut time, mut quick) = (length * own, length * per_mm(0.6 + strokes_length / p.speed));
    let mut turning = (low.turning + high.turning) / 2.0;
    let profile = Profile::new(&case.mesh, 0.35, 22.0, 0.5);
    let (stray, leaning) = profile.deviation(from, to, 0.4 * end);
    let mut fines = 0.4 * (height / end).powi(2) + 80.0 * leaning / end.powi(2);
    for ring in low.rings.iter().chain(&high.rings) {
        let lacking = (3.0 - (ring.length / run).floor()).max(0.0);
        let turns = (height / (0.75 * p.strand)).ceil() + 1.0;
        let (coiled, zigzag) = (turns * ring.length / p.speed, ring.length * own);
        if lacking > 0.0 && coiled < zigzag + 4.0 * lacking * lacking {
            time += (coiled - zigzag) / 2.0;
            turning -= ring.turning / 2.0;
        } else {
            fines += 2.0 * lacking * lacking;
        }
    }
    let sag = run * strokes.paper_run(height) * turning / (12.0 * length);
    quick = quick.max(time / 2.0);
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
    let nothing = Outline { rings: Vec::new(), length: 0.0, turning: 0.0 };
    let case = Case {
        heights: vec![1.0, 5.0],
        wanted: Vec::new(),
        outlines: vec![nothing.clone(), nothing],
        mesh: Mesh::new(vec![DVec3::ZERO], Vec::new()),
    };
    let cost = case.costs(&printer).slab(0, 1);
    assert!((cost - 0.4 * 0.04).abs() < 1e-12, "{cost}");
}
