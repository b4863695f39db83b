//! What hangs: the parts of a surface that nothing carries from below.
//!
//! Swept upwards, the surface begins in minima, and its parts join at saddles. A part that began
//! in the air hangs until it joins one that stands on the bed or on another body. That is a walk
//! along the join tree (Edelsbrunner, Harer: *Computational Topology*, VII.1).

use crate::geometry::disjoint_sets::UnionFind;
use crate::mesh::Mesh;

/// Marks a part that is carried.
const CARRIED: u32 = u32::MAX;

/// Until which height each part of a surface hangs.
pub(super) struct HangingUntil {
    /// Height at which what begins at a vertex, or goes on there, is carried, mm.
    until: Vec<f64>,
}

/// Vertices where the surface begins, seen from below: of a level face, one.
pub(super) fn minima(mesh: &Mesh) -> Vec<u32> {
    let mut lowest = vec![false; mesh.vertices.len()];
    for &v in mesh.faces.as_flattened() {
        lowest[v as usize] = true;
    }
    for &[a, b, c] in &mesh.faces {
        for (a, b) in [(a, b), (b, c), (c, a)] {
            let higher = if is_below(mesh, a, b) { b } else { a };
            lowest[higher as usize] = false;
        }
    }
    (0..).zip(lowest).filter_map(|(v, lowest)| lowest.then_some(v)).collect()
}

/// Whether vertex `a` comes before `b` from below; the smaller number breaks ties.
fn is_below(mesh: &Mesh, a: u32, b: u32) -> bool {
    let z = |v: u32| mesh.vertices[v as usize].z;
    z(a).total_cmp(&z(b)).then(a.cmp(&b)).is_lt()
}

impl HangingUntil {
    /// Sweeps a surface; `carried` tells of each minimum, a vertex, whether something carries it.
    pub(super) fn new(mesh: &Mesh, carried: impl Fn(u32) -> bool) -> Self {
        let count = mesh.vertices.len();
        let mut order: Vec<u32> = (0..count as u32).collect();
        order.sort_unstable_by(|&a, &b| {
            if is_below(mesh, a, b) {
                std::cmp::Ordering::Less
            } else {
                std::cmp::Ordering::Greater
            }
        });
        let mut rank = vec![0; count];
        for (r, &v) in (0_u32..).zip(&order) {
            rank[v as usize] = r;
        }
        // Each edge from its upper end to its lower one, in the order in which upper ends appear.
        let mut edges: Vec<[u32; 2]> = Vec::with_capacity(3 * mesh.faces.len());
        for face in &mesh.faces {
            let [a, b, c] = face.map(|v| rank[v as usize]);
            edges.extend([(a, b), (b, c), (c, a)].map(|(a, b)| [a.max(b), a.min(b)]));
        }
        edges.sort_unstable();
        edges.dedup();
        let mut sweep = VertexSweep {
            sets: UnionFind::new(count),
            part: vec![CARRIED; count],
            next: Vec::new(),
            until: Vec::new(),
        };
        let mut begun = vec![CARRIED; count];
        let mut edges = edges.into_iter().peekable();
        for (r, &v) in (0_u32..).zip(&order) {
            let z = mesh.vertices[v as usize].z;
            let mut met = Vec::new();
            while let Some([_, lower]) = edges.next_if(|&[upper, _]| upper == r) {
                met.push(sweep.sets.find(lower));
            }
            met.sort_unstable();
            met.dedup();
            begun[v as usize] = match met[..] {
                [] => sweep.begin(r, carried(v)),
                _ => sweep.join(r, &met, z),
            };
        }
        Self { until: begun.into_iter().map(|part| sweep.carried_at(part)).collect() }
    }

    /// Whether a place of a face hangs: `lowest` is the lowest of its corners.
    pub(super) fn hangs(&self, lowest: u32, z: f64) -> bool {
        z < self.until[lowest as usize]
    }
}

/// The lowest corner of a face.
pub(super) fn lowest(mesh: &Mesh, face: usize) -> u32 {
    let [a, b, c] = mesh.faces[face];
    let lower = |a: u32, b: u32| if is_below(mesh, a, b) { a } else { b };
    lower(lower(a, b), c)
}

/// A sweep under way; sets are known by their lowest vertex.
struct VertexSweep {
    sets: UnionFind,
    /// Part that the set of a lowest vertex is now.
    part: Vec<u32>,
    /// The part that each one becomes.
    next: Vec<u32>,
    /// Height at which each becomes that, mm.
    until: Vec<f64>,
}

impl VertexSweep {
    fn new_part(&mut self) -> u32 {
        self.next.push(CARRIED);
        self.until.push(f64::INFINITY);
        self.next.len() as u32 - 1
    }

    fn begin(&mut self, vertex: u32, carried: bool) -> u32 {
        let part = if carried { CARRIED } else { self.new_part() };
        self.part[vertex as usize] = part;
        part
    }

    /// Joins the sets that meet in a vertex, and that with them.
    fn join(&mut self, vertex: u32, met: &[u32], z: f64) -> u32 {
        let parts: Vec<u32> = met.iter().map(|&root| self.part[root as usize]).collect();
        let part = match parts[..] {
            [only] => only,
            _ if parts.contains(&CARRIED) => CARRIED,
            _ => self.new_part(),
        };
        for old in parts.into_iter().filter(|&old| old != part) {
            self.next[old as usize] = part;
            self.until[old as usize] = z;
        }
        for &root in met {
            self.sets.join_alone(vertex, root);
        }
        self.part[self.sets.find(vertex) as usize] = part;
        part
    }

    /// Height at which a part is carried at last, mm.
    fn carried_at(&self, mut part: u32) -> f64 {
        let mut height = f64::NEG_INFINITY;
        while part != CARRIED {
            height = self.until[part as usize];
            part = self.next[part as usize];
        }
        height
    }
}
