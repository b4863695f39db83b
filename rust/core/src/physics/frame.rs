//! The frame: nodes where strands are in contact, and beams between them.

use glam::DVec3;

use super::contacts::Contact;
use crate::check::contact::{ROUNDING_MM, touch};
use crate::check::deposit::Deposit;
use crate::check::rules::Rules;
use crate::geometry::disjoint_sets::UnionFind;

/// Beams shorter than this are joints, mm: what G-code resolves.
const SHORTEST_MM: f64 = 1e-3;

/// Places that are joined to one node lie within so many reaches of a contact: strands that cross, with
/// what stands on them, but not a wall whose every turn lies on the last.
const NODE_REACHES: f64 = 3.0;

/// A piece of a strand between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Beam {
    /// The node nearer to the strand's start.
    pub from: u32,
    /// The other one.
    pub to: u32,
    /// Its strand.
    pub strand: u32,
    /// From the place of each node to where the beam begins and ends, mm: none but in blocks.
    pub arms: [DVec3; 2],
}

impl Beam {
    /// A piece of a strand from the place of one node to that of another.
    pub(super) fn between(from: u32, to: u32, strand: u32) -> Self {
        Self { from, to, strand, arms: [DVec3::ZERO; 2] }
    }

    /// The same from its other end.
    pub(super) fn turned(self) -> Self {
        let Self { from, to, strand, arms: [begin, end] } = self;
        Self { from: to, to: from, strand, arms: [end, begin] }
    }
}

/// All strands as beams, in the order in which they are laid.
#[derive(Debug, Clone, Default)]
pub(super) struct Frame {
    /// Where each node is, mm: in the middle of the places that are joined there.
    pub places: Vec<DVec3>,
    /// Whether it lies on the bed.
    pub fixed: Vec<bool>,
    pub beams: Vec<Beam>,
    /// Nodes at the start and the end of each strand that counts.
    pub ends: Vec<Option<[u32; 2]>>,
}

impl Frame {
    /// The frame of the strands for which `counts` holds, from their contacts.
    pub(super) fn of(
        deposit: &Deposit,
        rules: &Rules,
        mut contacts: Vec<Contact>,
        counts: impl Fn(usize) -> bool,
    ) -> Self {
        // Ends first: what touches near an end then touches there. What goes on is one node anyway.
        contacts.sort_by_key(|contact| (!contact.goes_on(), contact.inner(), contact.strands));
        let mut joining = Joining::new(deposit, touch(rules));
        for contact in contacts {
            joining.join(&contact);
        }
        joining.frame(rules.bed_contact + ROUNDING_MM, counts)
    }

    /// Without the beams that lie on the bed from end to end: they move as little as it does.
    pub(super) fn on_the_bed(mut self) -> Self {
        let Self { fixed, beams, .. } = &mut self;
        beams.retain(|&Beam { from, to, .. }| !(fixed[from as usize] && fixed[to as usize]));
        self
    }
}

/// Places along strands, joined as contacts are found.
struct Joining<'a> {
    deposit: &'a Deposit,
    reach: f64,
    /// Places on each strand with their numbers; its ends come first.
    on: Vec<Vec<(f64, u32)>>,
    /// Where each place is.
    spots: Vec<DVec3>,
    joined: Vec<Joined>,
}

/// Two places in contact.
#[derive(Debug, Clone, Copy)]
struct Joined {
    places: [u32; 2],
    /// The strand that was laid on the other.
    strand: u32,
}

impl<'a> Joining<'a> {
    fn new(deposit: &'a Deposit, reach: f64) -> Self {
        let count = deposit.strands.len() as u32;
        let on = (0..count).map(|strand| vec![(0.0, 2 * strand), (1.0, 2 * strand + 1)]).collect();
        let spots = deposit.strands.iter().flatten().copied().collect();
        Self { deposit, reach, on, spots, joined: Vec::new() }
    }

    fn join(&mut self, contact: &Contact) {
        let places = [0, 1].map(|side| self.place(contact.strands[side], contact.at[side]));
        self.joined.push(Joined { places, strand: contact.strands[1] });
    }

    /// The place at `u` along a strand: one nearby, or a new one.
    fn place(&mut self, strand: u32, u: f64) -> u32 {
        let length = self.deposit.links[strand as usize].length;
        let on = &mut self.on[strand as usize];
        let nearest = on.iter().min_by(|a, b| (a.0 - u).abs().total_cmp(&(b.0 - u).abs()));
        if let Some(&(at, place)) = nearest
            && (at - u).abs() * length < self.reach
        {
            return place;
        }
        let (place, [from, to]) = (self.spots.len() as u32, self.deposit.strands[strand as usize]);
        on.push((u, place));
        self.spots.push(from.lerp(to, u));
        place
    }

    /// Sets of the places that are one node, and contacts between two of them, the first of each
    /// two sets, in the order of their strands.
    fn sets(&self) -> (UnionFind, Vec<Joined>) {
        let mut sets = UnionFind::new(self.spots.len());
        let mut boxes: Vec<[DVec3; 2]> = self.spots.iter().map(|&spot| [spot; 2]).collect();
        let mut links = Vec::new();
        for joined in &self.joined {
            let [a, b] = joined.places.map(|place| sets.find(place));
            let [one, other] = [a, b].map(|root| boxes[root as usize]);
            let around = [one[0].min(other[0]), one[1].max(other[1])];
            if (around[1] - around[0]).max_element() <= NODE_REACHES * self.reach {
                sets.join_alone(a, b);
                boxes[a.min(b) as usize] = around;
            } else {
                links.push(*joined);
            }
        }
        let pair = |link: &Joined| {
            let [a, b] = link.places.map(|place| sets.find(place));
            [a.min(b), a.max(b)]
        };
        let mut links: Vec<_> = links.iter().map(|link| (pair(link), *link)).collect();
        links.sort_by_key(|(pair, link)| (*pair, link.strand));
        links.dedup_by_key(|(pair, _)| *pair);
        links.sort_by_key(|(pair, link)| (link.strand, *pair));
        (sets, links.into_iter().map(|(_, link)| link).collect())
    }

    fn frame(self, bed: f64, counts: impl Fn(usize) -> bool) -> Frame {
        let (sets, links) = self.sets();
        let mut nodes = Nodes { of: vec![None; self.spots.len()], met: Vec::new() };
        let mut frame = Frame::default();
        let mut links = links.into_iter().peekable();
        for (strand, mut on) in self.on.into_iter().enumerate() {
            if !counts(strand) {
                frame.ends.push(None);
                continue;
            }
            on.sort_by(|a, b| a.0.total_cmp(&b.0));
            let met: Vec<u32> = on
                .iter()
                .map(|&(_, place)| nodes.at(sets.find(place), self.spots[place as usize]))
                .collect();
            // What it touches holds it, before it holds anything itself.
            let mut pairs = Vec::new();
            while let Some(link) = links.next_if(|link| link.strand as usize == strand) {
                let [other, own] = link.places.map(|place| nodes.of[sets.find(place) as usize]);
                pairs.extend(own.zip(other).map(|(own, other)| [own, other]));
            }
            pairs.extend(met.windows(2).map(|pair| [pair[0], pair[1]]));
            for [from, to] in pairs.into_iter().filter(|pair| pair[0] != pair[1]) {
                frame.beams.push(Beam::between(from, to, strand as u32));
            }
            frame.ends.push(met.first().zip(met.last()).map(|(&a, &b)| [a, b]));
        }
        frame.places = nodes.met.iter().map(Node::middle).collect();
        frame.fixed = nodes.met.iter().map(|node| node.lowest <= bed).collect();
        let Frame { places, beams, .. } = &mut frame;
        beams.retain(|&Beam { from, to, .. }| {
            let [a, b] = [from, to].map(|node| node as usize);
            places[a].distance(places[b]) > SHORTEST_MM
        });
        frame
    }
}

/// Nodes in the order in which they are met.
struct Nodes {
    /// The node of each set of places.
    of: Vec<Option<u32>>,
    met: Vec<Node>,
}

/// The places of a node.
#[derive(Default)]
struct Node {
    sum: DVec3,
    count: f64,
    /// Height of the lowest, mm: what lies on the bed is held.
    lowest: f64,
}

impl Node {
    fn middle(&self) -> DVec3 {
        self.sum / self.count
    }
}

impl Nodes {
    fn at(&mut self, set: u32, place: DVec3) -> u32 {
        let count = self.met.len() as u32;
        let node = *self.of[set as usize].get_or_insert(count);
        if node == count {
            self.met.push(Node { lowest: place.z, ..Node::default() });
        }
        let own = &mut self.met[node as usize];
        own.sum += place;
        own.count += 1.0;
        own.lowest = own.lowest.min(place.z);
        node
    }
}
