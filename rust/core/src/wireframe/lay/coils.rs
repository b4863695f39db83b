//! Which rings of a slab are coiled, and which of them together.

use glam::DVec2;

use crate::coil::{NearWalls, gap, keep_groups};
use crate::geometry::disjoint_sets::UnionFind;
use crate::stroke::SLACK;
use crate::wireframe::lay::coil::{Group, Tube, small_walls};
use crate::wireframe::lay::context::Context;
use crate::wireframe::lay::ground::Ground;
use crate::wireframe::lay::job::{Job, plans};
use crate::wireframe::lay::journal::Journal;
use crate::wireframe::lay::tops::Top;

/// The groups of a slab.
pub struct Coils {
    groups: Vec<Group>,
    /// For each job, the number of its group.
    of: Vec<Option<usize>>,
}

impl Coils {
    /// Those of a slab: none of a wall that is woven with another one, or near one that is not coiled.
    pub fn new(
        cx: &Context,
        journal: &Journal,
        top: &Top,
        jobs: &[Job],
        ground: &Ground,
        woven: &[Option<usize>],
    ) -> Self {
        let mut able = vec![false; jobs.len()];
        if cx.p.has_forms() && cx.layered.slab(top.slab).is_none() {
            let is_able = |(i, job): (usize, &Job)| {
                woven[i].is_none() && Tube::new(cx, journal, top, job, ground).is_some()
            };
            able = jobs.iter().enumerate().map(is_able).collect();
        }
        if !able.contains(&true) {
            return Self { groups: Vec::new(), of: vec![None; jobs.len()] };
        }
        let height = top.z - cx.sliced.levels[top.slab].z;
        let clearance = |rise: f64| cx.head.clearance(rise) * SLACK;
        let near = near(top, jobs, ground, &able, clearance(height));
        keep_groups(&mut able, &near, clearance(small_walls(cx, height).rise()));
        let together: Vec<&NearWalls> = near.iter().filter(|near| able[near.walls[0]]).collect();
        let sets = UnionFind::new(jobs.len());
        for NearWalls { walls: [a, b], .. } in &together {
            sets.join(*a as u32, *b as u32);
        }
        let (mut groups, mut of) = (Vec::<Group>::new(), vec![None; jobs.len()]);
        for job in (0..jobs.len()).filter(|&job| able[job]) {
            let root = sets.find(job as u32) as usize;
            let number = of[root].unwrap_or(groups.len());
            if number == groups.len() {
                groups.push(Group { jobs: Vec::new(), gap: f64::INFINITY });
            }
            groups[number].jobs.push(job);
            (of[root], of[job]) = (Some(number), Some(number));
        }
        for near in together {
            if let Some(group) = of[near.walls[0]].and_then(|number| groups.get_mut(number)) {
                group.gap = group.gap.min(near.gap);
            }
        }
        Self { groups, of }
    }

    /// The group of a job.
    pub fn group(&self, job: usize) -> Option<&Group> {
        self.of[job].map(|number| &self.groups[number])
    }

    /// Leaves a job, and all of its group, to zigzags.
    pub fn give_up(&mut self, job: usize) {
        if let Some(number) = self.of[job] {
            for &job in &self.groups[number].jobs {
                self.of[job] = None;
            }
        }
    }
}

/// Pairs of walls that come nearer to each other than `reach` mm, in what they stand on or what they lead
/// up to; one of each at least could be coiled.
fn near(top: &Top, jobs: &[Job], ground: &Ground, able: &[bool], reach: f64) -> Vec<NearWalls> {
    let outlines = |job: &Job| -> [Vec<Vec<DVec2>>; 2] {
        let upper = top.curves[job.curve].iter().map(|curve| curve.points().to_vec());
        [plans(job, ground), upper.collect()]
    };
    let outlines: Vec<[Vec<Vec<DVec2>>; 2]> = jobs.iter().map(outlines).collect();
    let apart = |a: usize, b: usize| {
        let levels = outlines[a].iter().zip(&outlines[b]);
        let pairs = levels
            .flat_map(|(of, to)| of.iter().flat_map(|one| to.iter().map(move |two| [one, two])));
        pairs.map(|[one, two]| gap(one, two, true, reach)).fold(f64::INFINITY, f64::min)
    };
    let mut found = Vec::new();
    for a in (0..jobs.len()).filter(|&a| able[a]) {
        for b in (0..jobs.len()).filter(|&b| b != a && (b > a || !able[b])) {
            let gap = apart(a, b);
            if gap < reach {
                found.push(NearWalls { walls: [a, b], gap });
            }
        }
    }
    found
}
