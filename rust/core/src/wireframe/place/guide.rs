//! What the plain wire print looks like: wire beside layers is laid as if these were not there.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::geometry::curve::Curve;
use crate::geometry::nearest_first::bounds;
use crate::wireframe::frame::PlacedPost;
use crate::wireframe::place::posts::{Candidate, Post, Rank};
use crate::wireframe::place::rim::Footing;

/// A flat zigzag that holds a contour.
#[derive(Debug, Clone)]
pub struct Spokes {
    /// The slab under way, and the spacing asked for by its bits.
    pub key: (u32, u64),
    /// Its strokes; their peaks lie on the contour.
    pub posts: Vec<Post>,
}

/// A plain wire print.
#[derive(Debug, Default)]
pub struct Guide {
    /// The posts of each contour by slab and contour, in printing order.
    posts: BTreeMap<(u32, u32), Vec<Post>>,
    /// Which contour's posts came when.
    ranks: BTreeMap<(u32, u32), usize>,
    /// All spokes by their key, in printing order.
    spokes: BTreeMap<(u32, u64), Vec<Vec<Post>>>,
}

/// A post of the plain print.
#[derive(Debug, Clone, Copy)]
pub struct Kept {
    /// The post; its arc length counts from the first point of the curve asked about, mm.
    pub post: Post,
    /// Its place along its contour.
    pub rank: Rank,
}

/// A peak this near to a curve lies on it, mm.
const ON: f64 = 1e-6;
/// A foothold may shift by this part of a strand's diameter, to where its rim is now.
const SHIFT: f64 = 0.5;

impl Guide {
    /// Learns from the posts and spokes of a print.
    #[must_use]
    pub fn new(posts: &[PlacedPost], spokes: Vec<Spokes>) -> Self {
        let mut guide = Self::default();
        for placed in posts {
            let key = (placed.slab, placed.contour);
            let next = guide.ranks.len();
            guide.ranks.entry(key).or_insert(next);
            guide.posts.entry(key).or_default().push(placed.post);
        }
        for Spokes { key, posts } in spokes {
            guide.spokes.entry(key).or_default().push(posts);
        }
        guide
    }

    /// Whether there is no plain print to go by.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.ranks.is_empty() && self.spokes.is_empty()
    }

    /// The contour's turn in its slab; last come those without posts.
    #[must_use]
    pub fn rank(&self, slab: usize, contour: usize) -> usize {
        self.ranks.get(&(slab as u32, contour as u32)).copied().unwrap_or(usize::MAX)
    }

    /// The posts of a contour that stand under a curve at height `z`, which is the contour or a
    /// part of it.
    #[must_use]
    pub fn posts(&self, slab: usize, contour: usize, curve: &Curve, z: f64) -> Vec<Kept> {
        let own = self.posts.get(&(slab as u32, contour as u32));
        own.map_or_else(Vec::new, |posts| on(posts, 0, curve, z))
    }

    /// The spokes with a key that hold a curve at height `z`.
    #[must_use]
    pub fn spokes(&self, key: (u32, u64), curve: &Curve, z: f64) -> Vec<Kept> {
        let mut first = 0;
        let mut found = Vec::new();
        for posts in self.spokes.get(&key).into_iter().flatten() {
            found.extend(on(posts, first, curve, z));
            first += posts.len();
        }
        found
    }
}

/// Those of a chain's posts, numbered from `first` on, whose peaks lie on a curve at height `z`.
fn on(posts: &[Post], first: usize, curve: &Curve, z: f64) -> Vec<Kept> {
    let (low, high) = bounds(curve.points().iter().copied());
    let near = |p: DVec2| p.clamp(low, high).distance(p) < ON;
    let place = |(number, post): (usize, &Post)| {
        let at = curve.nearest(post.peak.truncate());
        let rank = Rank { number: first + number, next: first + (number + 1) % posts.len() };
        let is_on = at.position.extend(z).distance(post.peak) < ON;
        is_on.then_some(Kept { post: Post { s: at.s, ..*post }, rank })
    };
    let close = posts.iter().enumerate().filter(|(_, post)| near(post.peak.truncate()));
    close.filter_map(place).collect()
}

/// The candidates among which a chain is sought that is to go by the plain print: its posts, as far
/// as they are free and on something, and what lies where others are missing. Arc lengths count
/// from `start`, which for a closed curve moves on to the first post that is left.
#[must_use]
pub fn merged(
    all: Vec<Candidate>,
    kept: &[Kept],
    curve: &Curve,
    start: f64,
    footing: &Footing,
    strand: f64,
    is_free: impl Fn(&Post) -> bool,
) -> (f64, Vec<Candidate>) {
    let stand = |kept: &Kept| {
        let Post { base, peak, s } = kept.post;
        let foothold = footing.nearest(base.truncate())?.position;
        let shift = foothold.distance(base);
        let base = if shift < ON { base } else { foothold };
        let post = Post { base, peak, s: curve.forward(start, s) };
        let (rank, room, station) = (Some(kept.rank), f64::INFINITY, curve.station(0.0, s));
        (shift < SHIFT * strand && is_free(&post)).then_some(Candidate {
            post,
            station,
            offset: 0.0,
            spacing: 0.0,
            room,
            kept: rank,
        })
    };
    let mut found: Vec<Candidate> = kept.iter().filter_map(stand).collect();
    let Some(first) = found.first().map(|c| c.post.s) else { return (start, all) };
    let ahead = if curve.is_closed() { first } else { 0.0 };
    let start = curve.wrap(start + ahead);
    let moved = |mut c: Candidate| {
        c.post.s = curve.forward(ahead, c.post.s);
        c.station = curve.station(start, c.post.s);
        c
    };
    found = found.into_iter().map(moved).collect();
    found.sort_by(|a, b| a.post.s.total_cmp(&b.post.s));
    let others = all.into_iter().map(moved);
    let others: Vec<Candidate> = others.filter(|c| !is_settled(&found, c.post.s)).collect();
    found.extend(others);
    found.sort_by(|a, b| a.post.s.total_cmp(&b.post.s));
    (start, found)
}

/// Whether a place is that of a post, or lies between two that were neighbours before.
fn is_settled(posts: &[Candidate], s: f64) -> bool {
    let next = posts.partition_point(|c| c.post.s < s - ON);
    let Some(after) = posts.get(next) else { return false };
    let before = next.checked_sub(1).and_then(|i| posts.get(i));
    after.post.s < s + ON || before.is_some_and(|before| before.leads_to(after))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::wireframe::place::candidates::{Begin, candidates};
    use crate::wireframe::place::rim::Rim;

    const SIDE: f64 = 40.0;

    fn square() -> Curve {
        let points = [(0.0, 0.0), (SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE)].map(DVec2::from);
        Curve::new(&points, true).unwrap()
    }

    fn foot() -> Rim {
        let points = square().points()[..4].iter().map(|p| p.extend(0.0)).collect();
        Rim { points, closed: true, printed: true, ..Rim::default() }
    }

    fn guide(count: usize) -> Guide {
        let post = |i: usize| {
            let s = 4.0 * SIDE * i as f64 / count as f64;
            let place = square().position(s);
            Post { base: place.extend(0.0), peak: place.extend(5.0), s }
        };
        let placed = (0..count).map(|i| PlacedPost { post: post(i), slab: 3, contour: 1 });
        Guide::new(&placed.collect::<Vec<_>>(), Vec::new())
    }

    fn chosen(curve: &Curve, is_free: impl Fn(&Post) -> bool) -> Vec<Candidate> {
        let (rim, kept) = (foot(), guide(16).posts(3, 1, curve, 5.0));
        let rims = [&rim];
        let all = candidates(curve, 5.0, Begin { s: 0.0, foothold: None }, &rims, 0.7, 1.0, false);
        merged(all, &kept, curve, 0.0, &Footing::new(&rims), 0.7, is_free).1
    }

    #[test]
    fn where_all_posts_of_the_plain_print_are_free_there_are_no_others() {
        let found = chosen(&square(), |_| true);
        let ranks: Vec<usize> = found.iter().filter_map(|c| c.kept).map(|r| r.number).collect();
        assert_eq!(ranks, (0..16).collect::<Vec<_>>());
        assert!(found[..15].iter().all(|c| c.kept.is_some()), "{found:?}");
    }

    #[test]
    fn other_places_are_sought_only_where_a_post_is_missing() {
        let lost = square().position(50.0).extend(5.0);
        let found = chosen(&square(), |post| post.peak.distance(lost) > 1e-9);
        let others: Vec<f64> =
            found.iter().filter(|c| c.kept.is_none()).map(|c| c.post.s).collect();
        assert!(others.iter().any(|s| (40.0..60.0).contains(s)));
        assert!(others.iter().all(|s| (40.0..60.0).contains(s) || *s > 150.0), "{others:?}");
    }

    #[test]
    fn a_part_of_a_contour_keeps_the_posts_that_stand_under_it() {
        let points = [(10.0, 0.0), (SIDE, 0.0), (SIDE, 25.0)].map(DVec2::from);
        let part = Curve::new(&points, false).unwrap();
        let kept = guide(16).posts(3, 1, &part, 5.0);
        let places: Vec<(usize, f64)> =
            kept.iter().map(|k| (k.rank.number, k.post.s.round())).collect();
        assert_eq!(places, [(1, 0.0), (2, 10.0), (3, 20.0), (4, 30.0), (5, 40.0), (6, 50.0)]);
        assert!(guide(16).posts(3, 0, &part, 5.0).is_empty());
        assert!(guide(16).posts(3, 1, &part, 4.0).is_empty());
    }

    /// The posts of the plain print that are left where the rim below lies `off` mm beside their bases.
    fn left(off: f64) -> Vec<Post> {
        let points = foot().points.iter().map(|p| p + DVec3::X * off).collect();
        let rim = Rim { points, ..foot() };
        let rims = [&rim];
        let kept = guide(16).posts(3, 1, &square(), 5.0);
        // Those on the left side, away from corners, stand beside the rim.
        let (_, found) =
            merged(Vec::new(), &kept[13..15], &square(), 0.0, &Footing::new(&rims), 0.7, |_| true);
        found.iter().map(|c| c.post).collect()
    }

    #[test]
    fn a_post_moves_its_base_by_less_than_half_a_strand() {
        let bases = |off: f64| -> Vec<f64> { left(off).iter().map(|post| post.base.x).collect() };
        assert_eq!(bases(0.0), [0.0, 0.0]);
        assert_eq!(bases(1e-7), [0.0, 0.0]);
        assert_eq!(bases(0.2), [0.2, 0.2]);
        assert_eq!(bases(0.34), [0.34, 0.34]);
        assert!(bases(0.35).is_empty() && bases(1.0).is_empty());
        // Peaks stay where they are.
        assert!(left(0.2).iter().all(|post| post.peak.x == 0.0 && post.peak.z == 5.0));
    }

    #[test]
    fn a_place_is_settled_at_a_post_and_between_neighbours() {
        let post = |s: f64, number: usize, next: usize| {
            let place = square().position(s).extend(0.0);
            let post = Post { base: place, peak: place, s };
            let station = square().station(0.0, s);
            let (spacing, room, kept) = (0.0, f64::INFINITY, Some(Rank { number, next }));
            Candidate { post, station, offset: 0.0, spacing, room, kept }
        };
        // Between 20 and 40 a post of the plain print is missing.
        let posts = [post(10.0, 1, 2), post(20.0, 2, 3), post(40.0, 4, 5)];
        let settled: Vec<f64> = [5.0, 9.0, 10.0, 10.0 + 5e-7, 15.0, 20.0, 25.0, 40.0 - 5e-7, 45.0]
            .into_iter()
            .filter(|&s| is_settled(&posts, s))
            .collect();
        assert_eq!(settled, [10.0, 10.0 + 5e-7, 15.0, 20.0, 40.0 - 5e-7]);
    }
}
