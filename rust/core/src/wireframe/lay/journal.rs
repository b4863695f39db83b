//! What is printed so far: strands and all that is noted about them, which a mark and a rollback take back as one.

use glam::DVec2;
use glam::DVec3;

use crate::strand::{Kind, Strand};
use crate::wireframe::frame::{PlacedPost, Reason, Unprinted};
use crate::wireframe::lay::obstacles::Obstacles;
use crate::wireframe::place::guide::Spokes;
use crate::wireframe::place::posts::Post;
use crate::wireframe::plan::columns::Need;
use crate::wireframe::regions::layered::Line;

/// Points nearer than this are one point, told apart by rounding only, mm.
pub const SAME: f64 = 1e-6;

/// Strands in printing order, and what is noted with them.
#[derive(Debug, Default)]
pub struct Entries {
    /// Every strand.
    pub strands: Vec<Strand>,
    /// Every post that stands.
    pub posts: Vec<PlacedPost>,
    /// What is not printed.
    pub unprinted: Vec<Unprinted>,
    /// Places for columns.
    pub columns: Vec<Need>,
    /// Strips, by slab and number, that lean too far to be climbed: their lower contours are
    /// closed instead.
    pub roofs: Vec<(usize, usize)>,
    /// All flat zigzags that hold contours.
    pub spokes: Vec<Spokes>,
    /// How far contours stray that become straight between their posts, times their length, mm².
    pub sag: f64,
}

/// How far the journal had come.
#[derive(Debug, Clone, Copy)]
pub struct Mark {
    strands: usize,
    posts: usize,
    unprinted: usize,
    columns: usize,
    roofs: usize,
    spokes: usize,
    sag: f64,
}

impl Entries {
    /// Area of what is not printed, mm².
    #[must_use]
    pub fn left_out(&self) -> f64 {
        self.unprinted.iter().map(|part| part.area).sum()
    }

    fn mark(&self) -> Mark {
        Mark {
            strands: self.strands.len(),
            posts: self.posts.len(),
            unprinted: self.unprinted.len(),
            columns: self.columns.len(),
            roofs: self.roofs.len(),
            spokes: self.spokes.len(),
            sag: self.sag,
        }
    }

    /// Parts with what came after a mark.
    fn split_off(&mut self, mark: &Mark) -> Self {
        let sag = self.sag - mark.sag;
        self.sag = mark.sag;
        Self {
            strands: self.strands.split_off(mark.strands),
            posts: self.posts.split_off(mark.posts),
            unprinted: self.unprinted.split_off(mark.unprinted),
            columns: self.columns.split_off(mark.columns),
            roofs: self.roofs.split_off(mark.roofs),
            spokes: self.spokes.split_off(mark.spokes),
            sag,
        }
    }

    fn append(&mut self, later: Self) {
        self.strands.extend(later.strands);
        self.posts.extend(later.posts);
        self.unprinted.extend(later.unprinted);
        self.columns.extend(later.columns);
        self.roofs.extend(later.roofs);
        self.spokes.extend(later.spokes);
        self.sag += later.sag;
    }
}

/// The print so far, with what of it the head must keep clear of.
pub struct Journal<'a> {
    /// The slab's strands as the head meets them.
    pub obstacles: Obstacles<'a>,
    slab: u32,
    /// Number of strands printed before this slab.
    before: usize,
    entries: Entries,
}

impl<'a> Journal<'a> {
    /// Nothing printed yet.
    #[must_use]
    pub fn new(obstacles: Obstacles<'a>) -> Self {
        Self { obstacles, slab: 0, before: 0, entries: Entries::default() }
    }

    /// Begins a slab: all that is printed lies below its strands and is out of the head's way.
    /// The head will come along `lines` later.
    pub fn begin_slab(&mut self, slab: u32, lines: &[Line]) {
        self.obstacles.begin_slab(lines);
        self.slab = slab;
        self.before = self.entries.strands.len();
    }

    /// The slab under way.
    #[must_use]
    pub fn slab(&self) -> u32 {
        self.slab
    }

    /// All that is printed and noted.
    #[must_use]
    pub fn entries(&self) -> &Entries {
        &self.entries
    }

    /// All that was printed and noted, at the end.
    #[must_use]
    pub fn into_entries(self) -> Entries {
        self.entries
    }

    /// The slab's strands that lie within a strand's diameter of height `z` and reach into a
    /// rectangle, in plan.
    pub fn flat(&self, z: f64, low: DVec2, high: DVec2) -> impl Iterator<Item = &Strand> + '_ {
        let near = self.obstacles.strand();
        self.entries.strands[self.before..].iter().filter(move |strand| {
            let [a, b] = [strand.from, strand.to].map(DVec3::truncate);
            let in_plan = a.min(b).cmple(high).all() && a.max(b).cmpge(low).all();
            in_plan && [strand.from, strand.to].iter().all(|p| (p.z - z).abs() <= near)
        })
    }

    /// Where the last strand ended.
    #[must_use]
    pub fn at(&self) -> Option<DVec3> {
        self.entries.strands.last().map(|s| s.to)
    }

    /// Where the head is, in plan; at first the bed's centre.
    #[must_use]
    pub fn place(&self) -> DVec2 {
        self.at().map_or(DVec2::ZERO, DVec3::truncate)
    }

    /// How far the print has come.
    #[must_use]
    pub fn mark(&self) -> Mark {
        self.entries.mark()
    }

    /// Takes back all that was printed and noted since a mark.
    pub fn rollback(&mut self, mark: &Mark) -> Entries {
        self.entries.split_off(mark)
    }

    /// Prints what was taken back, as it was; its slab begins anew.
    pub fn replay(&mut self, slab: u32, later: Entries) {
        self.begin_slab(slab, &[]);
        for strand in &later.strands {
            self.obstacles.add(strand.from, strand.to);
        }
        self.entries.append(later);
    }

    /// Whether all was printed since a mark, with no more than `near` mm² of sag.
    #[must_use]
    pub fn is_whole_since(&self, mark: &Mark, near: f64) -> bool {
        self.entries.unprinted.len() == mark.unprinted
            && self.entries.columns.len() == mark.columns
            && self.entries.sag - mark.sag <= near
    }

    /// Whether a post could be printed now that is to be no longer than `longest` mm.
    #[must_use]
    pub fn has_room(&self, post: &Post, longest: f64) -> bool {
        post.base.distance(post.peak) <= longest && !self.obstacles.is_barred(post.base, post.peak)
    }

    /// Prints one strand; a `floating` one ends in the air.
    pub fn stroke(&mut self, from: DVec3, to: DVec3, kind: Kind, floating: bool) {
        // A strand that goes on from the last one begins at the very same point.
        let from = self.at().filter(|at| at.distance(from) < SAME).unwrap_or(from);
        self.obstacles.add(from, to);
        self.push(from, to, kind, floating);
    }

    /// Prints the turns of a coil, one upon the other. Of what it is the head meets the last one first:
    /// it alone is an obstacle.
    pub fn coil(&mut self, turns: &[Vec<DVec3>], kind: Kind) {
        for (number, turn) in turns.iter().enumerate() {
            for ends in turn.windows(2).filter(|ends| ends[0].distance(ends[1]) > SAME) {
                let from = self.at().filter(|at| at.distance(ends[0]) < SAME).unwrap_or(ends[0]);
                if number + 1 == turns.len() {
                    self.obstacles.add(from, ends[1]);
                }
                self.push(from, ends[1], kind, false);
            }
        }
    }

    fn push(&mut self, from: DVec3, to: DVec3, kind: Kind, floating: bool) {
        let slab = self.slab;
        let strand = Strand { from, to, kind, slab, floating, flow: 1.0, direct: false };
        self.entries.strands.push(strand);
    }

    /// Prints a polyline.
    pub fn polyline(&mut self, points: &[DVec3], kind: Kind) {
        for pair in points.windows(2) {
            if pair[0].distance(pair[1]) > SAME {
                self.stroke(pair[0], pair[1], kind, false);
            }
        }
    }

    /// Prints the lines of this slab's layers. The head goes straight from one to the next unless
    /// wire is in the way; they themselves bar nothing, for each lies below all that comes later.
    pub fn lines(&mut self, lines: &[Line]) {
        self.obstacles.pass_lines();
        for line in lines {
            let Some(&first) = line.points.first() else { continue };
            let kind = if line.inside { Kind::LayerFill } else { Kind::LayerWise };
            let from = self.entries.strands.last().filter(|s| s.kind.is_layered()).map(|s| s.to);
            let mut direct = from.is_some_and(|from| !self.obstacles.is_hit(from, first));
            for pair in line.points.windows(2).filter(|pair| pair[0] != pair[1]) {
                self.push(pair[0], pair[1], kind, false);
                if let Some(strand) = self.entries.strands.last_mut() {
                    strand.flow = line.flow;
                    strand.direct = std::mem::take(&mut direct);
                }
            }
        }
    }

    /// Notes posts that stand.
    pub fn note_posts(&mut self, slab: u32, contour: u32, posts: &[Post]) {
        self.entries.posts.extend(posts.iter().map(|&post| PlacedPost { post, slab, contour }));
    }

    /// Notes a flat zigzag that holds a contour.
    pub fn note_spokes(&mut self, spokes: Spokes) {
        self.entries.spokes.push(spokes);
    }

    /// Notes how far a contour strays between its posts, mm².
    pub fn note_sag(&mut self, sag: f64) {
        self.entries.sag += sag;
    }

    /// Asks for columns.
    pub fn want_columns(&mut self, needs: impl IntoIterator<Item = Need>) {
        self.entries.columns.extend(needs);
    }

    /// Asks for the lower contours of a strip to be closed.
    pub fn want_roof(&mut self, slab: usize, strip: usize) {
        self.entries.roofs.push((slab, strip));
    }

    /// Notes a part of the surface that is not printed.
    pub fn leave_out(&mut self, low: f64, high: f64, area: f64, at: DVec2, reason: Reason) {
        self.entries.unprinted.push(Unprinted { low, high, area, place: at.extend(high), reason });
    }
}

#[cfg(test)]
mod tests;
