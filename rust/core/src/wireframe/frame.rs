//! The wire print as geometry: what the stage hands on.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::strand::{Kind, Strand};
use crate::wireframe::place::posts::Post;
use crate::wireframe::plan::sliced::Sliced;

/// A post with its slab and the contour (of the slice at the slab's top) that it carries.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlacedPost {
    /// The post.
    pub post: Post,
    /// Index of the slab.
    pub slab: u32,
    /// Index of the contour in the slice from below at the slab's top.
    pub contour: u32,
}

/// Why a part of the surface is not printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reason {
    /// It begins in the air with nothing below.
    MidAir,
    /// Neighbouring walls leave the head no room for a post.
    NoFoothold,
    /// A stretch of its contour is longer than a strand can span.
    WideSpan,
    /// Its flat roof is wider than a strand can span.
    WideRoof,
    /// Printed, it would break the rules.
    BreaksRules,
}

/// A part of the surface that is not printed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Unprinted {
    /// Lower end, mm.
    pub low: f64,
    /// Upper end, mm.
    pub high: f64,
    /// Area of the surface, mm².
    pub area: f64,
    /// A point on it, mm.
    pub place: DVec3,
    /// Why.
    pub reason: Reason,
}

/// The wire print as geometry: strands in printing order and what they were made from.
#[derive(Debug, Serialize, Deserialize)]
pub struct Wireframe {
    /// Slices, contours and strips.
    pub sliced: Sliced,
    /// Every post that stands.
    pub posts: Vec<PlacedPost>,
    /// Every strand, in printing order.
    pub strands: Vec<Strand>,
    /// What is not printed, bottom up.
    pub unprinted: Vec<Unprinted>,
}

impl Wireframe {
    /// The same print without strands of these numbers, ascending, `strand` mm in diameter: posts
    /// go with theirs, and what would have been seen of the others is named.
    #[must_use]
    pub fn without(&self, dropped: &[usize], strand: f64) -> Self {
        let mut left = self.beyond(dropped);
        let gone: Vec<&Strand> = dropped.iter().filter_map(|&n| self.strands.get(n)).collect();
        let runs = gone.chunk_by(|one, next| one.to == next.from);
        left.unprinted.extend(runs.filter_map(|run| left_out(run, strand)));
        left.unprinted.sort_by(|a, b| a.low.total_cmp(&b.low));
        left
    }

    /// What is left to print where strands of these numbers, ascending, stand already; posts go with
    /// theirs.
    #[must_use]
    pub fn beyond(&self, dropped: &[usize]) -> Self {
        let is_dropped = |number: &usize| dropped.binary_search(number).is_ok();
        let mut strands = Vec::with_capacity(self.strands.len());
        for (number, &kept) in self.strands.iter().enumerate().filter(|(n, _)| !is_dropped(n)) {
            // The head no longer comes from where it was to come from.
            let direct = kept.direct && number.checked_sub(1).is_none_or(|n| !is_dropped(&n));
            strands.push(Strand { direct, ..kept });
        }
        let gone: Vec<&Strand> = dropped.iter().filter_map(|&n| self.strands.get(n)).collect();
        let stands = |p: &&PlacedPost| {
            !gone
                .iter()
                .any(|s| s.kind == Kind::Post && s.to == p.post.peak && s.from == p.post.base)
        };
        let posts = self.posts.iter().filter(stands).copied().collect();
        let unprinted = self.unprinted.clone();
        Self { sliced: self.sliced.clone(), posts, strands, unprinted }
    }

    /// Number of diagonals: one may be laid in several strands, one after the other.
    #[must_use]
    pub fn diagonals(&self) -> usize {
        let begins = |run: &&[Strand]| run[0].kind == Kind::Diagonal;
        self.strands.chunk_by(|one, next| one.kind == next.kind).filter(begins).count()
    }

    /// Length of all strands of a kind, mm.
    #[must_use]
    pub fn length_of(&self, kind: Kind) -> f64 {
        let found = self.strands.iter().filter(|s| s.kind == kind);
        found.map(|s| s.from.distance(s.to)).fold(0.0, std::ops::Add::add)
    }
}

/// What strands that are not printed would have shown; None of what only supports.
fn left_out(run: &[&Strand], strand: f64) -> Option<Unprinted> {
    let mut seen = run.iter().filter(|s| s.kind != Kind::Support).peekable();
    let place = seen.peek()?.from;
    let (mut low, mut high, mut area) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
    for s in seen {
        (low, high) = (low.min(s.from.z.min(s.to.z)), high.max(s.from.z.max(s.to.z)));
        area += s.from.distance(s.to) * strand;
    }
    Some(Unprinted { low, high, area, place, reason: Reason::BreaksRules })
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    fn strand(kind: Kind, from: [f64; 3], to: [f64; 3]) -> Strand {
        let (from, to) = (from.into(), to.into());
        Strand { from, to, kind, slab: 0, floating: false, flow: 1.0, direct: true }
    }

    #[test]
    fn dropped_strands_take_their_posts_along_and_are_named_run_by_run() {
        let post = Post { base: DVec3::ZERO, peak: dvec3(0.0, 0.0, 5.0), s: 0.0 };
        let other = Post { base: dvec3(9.0, 0.0, 0.0), peak: dvec3(9.0, 0.0, 5.0), s: 9.0 };
        let frame = Wireframe {
            sliced: Sliced::default(),
            posts: [post, other].map(|post| PlacedPost { post, slab: 0, contour: 0 }).to_vec(),
            strands: vec![
                strand(Kind::Post, [0.0, 0.0, 0.0], [0.0, 0.0, 5.0]),
                strand(Kind::Diagonal, [0.0, 0.0, 5.0], [9.0, 0.0, 0.0]),
                strand(Kind::Post, [9.0, 0.0, 0.0], [9.0, 0.0, 5.0]),
                strand(Kind::Support, [3.0, 0.0, 1.0], [3.0, 0.0, 2.0]),
                strand(Kind::Cap, [3.0, 0.0, 2.0], [7.0, 0.0, 2.0]),
            ],
            unprinted: Vec::new(),
        };
        let left = frame.without(&[0, 1, 3], 0.5);
        assert_eq!(left.posts.iter().map(|p| p.post).collect::<Vec<_>>(), [other]);
        assert_eq!(left.strands.iter().map(|s| s.direct).collect::<Vec<_>>(), [false, false]);
        assert_eq!((frame.diagonals(), left.diagonals()), (1, 0));
        let twice = [&frame.strands[..2], &frame.strands[1..]].concat();
        let split = Wireframe { strands: twice, ..frame.without(&[], 0.5) };
        assert_eq!(split.diagonals(), 1);
        assert_eq!(split.length_of(Kind::Diagonal), 2.0 * 106_f64.sqrt());
        // A support shows nothing of the surface.
        let [named] = left.unprinted[..] else { panic!("{:?}", left.unprinted) };
        assert_eq!((named.low, named.high, named.place), (0.0, 5.0, DVec3::ZERO));
        assert!((named.area - 0.5 * (5.0 + 106_f64.sqrt())).abs() < 1e-12);
        assert_eq!(named.reason, Reason::BreaksRules);
        assert_eq!(frame.without(&[], 0.5).strands, frame.strands);
    }
}
