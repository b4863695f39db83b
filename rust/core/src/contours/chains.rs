//! Rings of points parted into chains that rise in the direction of the sweep.

use std::cmp::Ordering;

use glam::DVec2;

use super::ring::Ring;

/// Slope of the sweep line: out of line with the edges that models usually have.
const SHEAR: f64 = 0.381_966_011_250_105_1;

/// Position along the sweep; ties are broken so that different points never tie.
#[derive(Clone, Copy)]
pub(super) struct Key {
    /// Coordinate along the sweep.
    pub along: f64,
    point: DVec2,
}

impl Key {
    pub fn of(point: DVec2) -> Self {
        Self { along: Self::along(point), point }
    }

    /// Coordinate along the sweep.
    pub fn along(p: DVec2) -> f64 {
        p.y + SHEAR * p.x
    }

    /// Coordinate along the sweep line, to the right; on the scale of `along`.
    pub fn across(p: DVec2) -> f64 {
        p.x - SHEAR * p.y
    }

    /// How far a rising direction leans to the right: run over rise.
    pub fn lean(d: DVec2) -> f64 {
        Self::across(d) / Self::along(d)
    }
}

impl Ord for Key {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.along.total_cmp(&other.along))
            .then(self.point.y.total_cmp(&other.point.y))
            .then(self.point.x.total_cmp(&other.point.x))
    }
}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Key {}

/// A rising run of a ring's points; a single point where the ring encloses nothing.
pub(super) struct RisingChain {
    pub ring: u32,
    pub segments: u32,
    /// Whether the ring runs along the chain upwards.
    pub up: bool,
    /// Extent along the sweep line.
    pub leftmost: f64,
    pub rightmost: f64,
    /// Place of the lowest point among all rings' places.
    bottom: u32,
}

/// The chains of all rings, and their points in the sweep's coordinates.
pub(super) struct Chains<'a> {
    pub list: Vec<RisingChain>,
    rings: &'a [Ring<'a>],
    /// For each ring: its first place, and which of its points stands there (its lowest one).
    origins: Vec<(u32, u32)>,
    /// Places: each ring's points from its lowest one around, that one once more at the end.
    places: Vec<DVec2>,
}

impl<'a> Chains<'a> {
    pub fn of(rings: &'a [Ring<'a>]) -> Self {
        let total: usize = rings.iter().map(|ring| ring.points.len() + 1).sum();
        let mut chains = Self {
            list: Vec::new(),
            rings,
            origins: Vec::with_capacity(rings.len()),
            places: Vec::with_capacity(total),
        };
        for (index, ring) in (0..).zip(rings) {
            chains.add(index, ring);
        }
        chains
    }

    fn add(&mut self, index: u32, ring: &Ring) {
        let first = self.places.len() as u32;
        let points = ring.points;
        let lowest = if ring.area.is_none() { 0 } else { lowest(points) };
        self.origins.push((first, lowest as u32));
        let around = points[lowest..].iter().chain(&points[..lowest]).chain(points.get(lowest));
        self.places.extend(around.map(|&p| DVec2::new(Key::across(p), Key::along(p))));
        if points.is_empty() {
            return;
        }
        if ring.area.is_none() {
            self.push(index, first, first);
            return;
        }
        let last = self.places.len() as u32 - 1;
        let (mut begin, mut rising) = (first, true);
        for place in first + 1..last {
            if self.rises(index, place) != rising {
                self.push(index, begin, place);
                (begin, rising) = (place, !rising);
            }
        }
        self.push(index, begin, last);
    }

    /// Whether the ring rises from this place to the next.
    fn rises(&self, ring: u32, place: u32) -> bool {
        let (a, b) = (self.places[place as usize].y, self.places[place as usize + 1].y);
        a < b || (a == b && self.key(ring, place) < self.key(ring, place + 1))
    }

    fn key(&self, ring: u32, place: u32) -> Key {
        Key::of(self.point_at(ring, place))
    }

    /// Adds the chain between two places.
    fn push(&mut self, ring: u32, begin: u32, end: u32) {
        let places = &self.places[begin as usize..=end as usize];
        let (mut leftmost, mut rightmost) = (f64::INFINITY, f64::NEG_INFINITY);
        for place in places {
            leftmost = leftmost.min(place.x);
            rightmost = rightmost.max(place.x);
        }
        let up = self.key(ring, begin) <= self.key(ring, end);
        let bottom = if up { begin } else { end };
        self.list.push(RisingChain {
            ring,
            segments: end - begin,
            up,
            leftmost,
            rightmost,
            bottom,
        });
    }

    fn point_at(&self, ring: u32, place: u32) -> DVec2 {
        let (first, lowest) = self.origins[ring as usize];
        let points = self.rings[ring as usize].points;
        points[(lowest + place - first) as usize % points.len()]
    }

    /// Place of a chain's `i`-th point from below.
    fn place(chain: &RisingChain, i: u32) -> u32 {
        if chain.up { chain.bottom + i } else { chain.bottom - i }
    }

    /// A chain's `i`-th point from below.
    pub fn point(&self, chain: &RisingChain, i: u32) -> DVec2 {
        self.point_at(chain.ring, Self::place(chain, i))
    }

    /// A chain's `i`-th segment from below; a chain that is a point has that point twice.
    pub fn segment(&self, chain: &RisingChain, i: u32) -> (DVec2, DVec2) {
        (self.point(chain, i), self.point(chain, (i + 1).min(chain.segments)))
    }

    /// Coordinate along the sweep of a chain's `i`-th point.
    pub fn along(&self, chain: &RisingChain, i: u32) -> f64 {
        self.places[Self::place(chain, i) as usize].y
    }

    /// How far right a chain's `i`-th segment reaches.
    pub fn reach_right(&self, chain: &RisingChain, i: u32) -> f64 {
        self.across(chain, i).max(self.across(chain, i + 1))
    }

    /// How far left a chain's `i`-th segment reaches.
    pub fn reach_left(&self, chain: &RisingChain, i: u32) -> f64 {
        self.across(chain, i).min(self.across(chain, i + 1))
    }

    fn across(&self, chain: &RisingChain, i: u32) -> f64 {
        self.places[Self::place(chain, i) as usize].x
    }

    /// The segment of a chain that the sweep line crosses; the upper one at a point.
    pub fn segment_at(&self, chain: &RisingChain, along: f64) -> u32 {
        let (mut low, mut high) = (0, chain.segments.saturating_sub(1));
        while low < high {
            let middle = low + (high - low).div_ceil(2);
            if self.along(chain, middle) <= along { low = middle } else { high = middle - 1 }
        }
        low
    }
}

/// Index of a ring's lowest point in the sweep.
fn lowest(points: &[DVec2]) -> usize {
    let mut lowest = 0;
    let mut least = f64::INFINITY;
    for (i, &p) in points.iter().enumerate() {
        let along = Key::along(p);
        if along < least || (along == least && Key::of(p) < Key::of(points[lowest])) {
            (lowest, least) = (i, along);
        }
    }
    lowest
}
