//! Support in the plane, for contours that no wall of their own carries: strokes from printed
//! neighbours, and bridges from rim to rim. Horizontal strands never meet the head's flank.

use glam::DVec2;

use crate::contours::Contour;
use crate::geometry::curve::Curve;
use crate::geometry::hatch::bridges;
use crate::strand::Kind;
use crate::wireframe::build::{Build, Ground, Standing};
use crate::wireframe::lay::columns::needs;
use crate::wireframe::lay::level::HELD;
use crate::wireframe::lay::slab::gaps;
use crate::wireframe::place::guide::Spokes;
use crate::wireframe::place::posts::{Post, even_spacing};
use crate::wireframe::place::rim::{Footing, Rim};
use crate::wireframe::place::walls::Walls;
use crate::wireframe::place::zigzag::{Placement, ZigzagInput, zigzag};

/// Gaps wider than this part of the longest span want a support.
const WIDE: f64 = 0.6;
/// The strokes of a ledge stand this part of the distance between a cap's strands apart at least.
pub const LEDGE: f64 = 0.8;
/// Ties, which only hold, stand so many times that distance apart.
const TIE: f64 = 2.0;

impl Build<'_> {
    /// Hangs a contour on what is printed around it at its height. One that lies inside another
    /// becomes part of the surface's caps; one beside the others is supported.
    pub(in crate::wireframe) fn hang(
        &mut self,
        curve: &Curve,
        z: f64,
        level: usize,
        contour: &Contour,
        printed: &mut Ground,
    ) -> Option<Rim> {
        let inside = contour.depth > 0;
        if !inside && !self.p.supports {
            return None;
        }
        let kind = if inside { Kind::Cap } else { Kind::Support };
        let neighbours = printed.all();
        let standing = match self.spokes(curve, z, &neighbours, kind, TIE, |_| true) {
            Some(standing) => Some(standing),
            None if self.p.supports => self.bridged(curve, z, printed),
            None => None,
        }?;
        let standing = self.tighten(curve, z, level, standing, printed, self.wide_gap());
        let kind = if contour.support { Kind::Support } else { Kind::Contour };
        Some(self.follow(curve, &standing, z, kind))
    }

    /// Asks for columns under a contour that hangs on nothing.
    pub(in crate::wireframe) fn want_columns(&mut self, curve: &Curve, level: usize) {
        self.wants.columns.extend(needs(curve, 0.0, &[], level, 0.0));
    }

    /// Spokes from bridges across the contour's place.
    fn bridged(&mut self, curve: &Curve, z: f64, printed: &mut Ground) -> Option<Standing> {
        let lines = self.bridge(curve, z, printed)?;
        let carriers: Vec<&Rim> = lines.iter().collect();
        let standing = self.spokes(curve, z, &carriers, Kind::Support, LEDGE, |_| true);
        printed.lines.extend(lines);
        standing
    }

    /// A flat zigzag from printed rims out (or in) to the wanted places of a contour, these at
    /// least `spacing` times the distance between a cap's strands apart.
    pub(in crate::wireframe) fn spokes(
        &mut self,
        curve: &Curve,
        z: f64,
        carriers: &[&Rim],
        kind: Kind,
        spacing: f64,
        wanted: impl Fn(&Post) -> bool,
    ) -> Option<Standing> {
        if carriers.is_empty() {
            return None;
        }
        let walls = Walls::new(&[], 1.0..=1.0);
        let key = self.spokes_key(spacing);
        let kept = self.guide.spokes(key, curve, z);
        let begun = kept.first().map(|first| first.post.s).filter(|_| curve.is_closed());
        let start = begun.unwrap_or_else(|| self.start(curve, carriers));
        let input = ZigzagInput {
            curve,
            z,
            start,
            from: None,
            rims: carriers,
            walls: &walls,
            wall: 0,
            least: even_spacing(curve.length(), spacing * self.p.cap_spacing),
            on_peaks: false,
            placement: Placement::Optimal,
            strand: self.p.strand,
            span_limit: self.p.span_limit,
            kept: &kept,
        };
        let limit = self.p.free_end_limit;
        let shift = |post: &Post| Post { s: curve.wrap(start + post.s), ..*post };
        let (start, steps) = zigzag(&input, self.head, |post| {
            post.base.distance(post.peak) <= limit && wanted(&shift(post))
        });
        let posts = self.out.zigzag(&steps, kind, kind, self.p.span_limit);
        self.spokes.push(Spokes { key, posts: posts.clone() });
        (!posts.is_empty()).then_some(Standing { curve: 0, start, posts })
    }

    /// Gaps of a contour that is tied are no wider than this, mm.
    pub(in crate::wireframe) fn wide_gap(&self) -> f64 {
        TIE * self.p.cap_spacing
    }

    /// Adds ties where a contour's posts leave gaps wider than `wide`, and asks for supports where
    /// gaps remain.
    pub(in crate::wireframe) fn tighten(
        &mut self,
        curve: &Curve,
        z: f64,
        level: usize,
        standing: Standing,
        printed: &Ground,
        wide: f64,
    ) -> Standing {
        let wide_gaps: Vec<(f64, f64)> =
            gaps(curve, &standing.posts).filter(|&(_, gap)| gap > wide).collect();
        if wide_gaps.is_empty() {
            return standing;
        }
        let from_start = |s: f64| curve.forward(standing.start, s);
        let margin = LEDGE * self.p.cap_spacing;
        let wanted = |post: &Post| {
            let s = from_start(post.s);
            wide_gaps.iter().any(|&(begin, gap)| {
                let into = if curve.is_closed() {
                    (s - begin).rem_euclid(curve.length())
                } else {
                    s - begin
                };
                into > margin && into < gap - margin
            })
        };
        let neighbours = printed.all();
        let ties = self.spokes(curve, z, &neighbours, Kind::Cap, TIE, wanted);
        let Standing { curve: number, start, mut posts } = standing;
        if let Some(ties) = ties {
            let shifted = |s: f64| curve.forward(start, curve.wrap(ties.start + s));
            posts.extend(ties.posts.iter().map(|p| Post { s: shifted(p.s), ..*p }));
            posts.sort_by(|a, b| a.s.total_cmp(&b.s));
        }
        let widest = WIDE * self.p.span_limit;
        self.wants.columns.extend(needs(curve, start, &posts, level, widest));
        Standing { curve: number, start, posts }
    }

    /// Whether the plain print ties a contour of this slab to its neighbours.
    pub(in crate::wireframe) fn was_tied(&self, curve: &Curve, z: f64) -> bool {
        !self.guide.spokes(self.spokes_key(TIE), curve, z).is_empty()
    }

    fn spokes_key(&self, spacing: f64) -> (u32, u64) {
        (self.out.slab(), spacing.to_bits())
    }

    /// Bridges from rim to rim across the place of a contour.
    fn bridge(&mut self, curve: &Curve, z: f64, printed: &Ground) -> Option<Vec<Rim>> {
        let rings: Vec<&Rim> =
            printed.rims.iter().flatten().filter(|rim| rim.closed && rim.printed).collect();
        let plan: Vec<Vec<DVec2>> =
            rings.iter().map(|rim| rim.points.iter().map(|p| p.truncate()).collect()).collect();
        let footing = Footing::new(&rings);
        let held = |end: DVec2| footing.holds(end, HELD * self.p.strand);
        let (figure, spacing) = (curve.points(), self.p.cap_spacing);
        let lines = bridges(&plan, figure, spacing, self.p.span_limit, held)?;
        let rims: Vec<Rim> =
            lines.into_iter().map(|line| Rim::line(line.map(|p| p.extend(z)).to_vec())).collect();
        for rim in &rims {
            self.out.polyline(&rim.points, Kind::Support);
        }
        Some(rims)
    }
}
