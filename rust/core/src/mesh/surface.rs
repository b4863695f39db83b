//! A mesh under repair: vertices, faces and their adjacency, rebuilt after each change.

use glam::{DAffine3, DVec3};

use super::fans;
use super::indexed::{Mesh, bounds};
use super::topology::{Adjacency, NO_FACE};

/// A mesh under repair.
#[derive(Debug, Default)]
pub struct Surface {
    /// Vertex positions, in the file's unit.
    pub vertices: Vec<DVec3>,
    /// Vertex indices of each face.
    pub faces: Vec<[u32; 3]>,
    /// The face across each edge of each face.
    pub neighbours: Vec<[u32; 3]>,
    /// Half-edges of each edge with more than two faces.
    pub fans: Vec<Vec<u32>>,
    /// Number of half-edges without a neighbour.
    pub boundary: usize,
    /// Number of edges that both of their faces traverse in the same direction.
    pub opposed: usize,
    /// Whether each face runs against its direction in the file; may be shorter than `faces`,
    /// where none of the others does.
    reversed: Vec<bool>,
}

impl Surface {
    /// The surface of faces whose three vertices differ.
    pub fn new(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Self {
        let mut surface = Self { vertices, faces, ..Self::default() };
        surface.connect();
        surface
    }

    /// Finds the adjacency anew.
    pub fn connect(&mut self) {
        self.neighbours = Vec::new();
        let adjacency = Adjacency::new(&self.faces, self.vertices.len());
        self.neighbours = adjacency.neighbours;
        let paired = fans::pair(&self.vertices, &self.faces, &adjacency.fans, &mut self.neighbours);
        self.boundary = adjacency.boundary + paired.single;
        self.opposed = adjacency.opposed + paired.opposed;
        self.fans = adjacency.fans;
    }

    /// Length of the bounding box' diagonal, in the file's unit.
    pub fn diagonal(&self) -> f64 {
        let (low, high) = bounds(&self.vertices);
        (high - low).length()
    }

    /// Positions of the corners of face `f`.
    pub fn corners(&self, f: usize) -> [DVec3; 3] {
        self.faces[f].map(|v| self.vertices[v as usize])
    }

    /// Half-edges without a neighbour, ascending.
    pub fn open_halves(&self) -> Vec<u32> {
        if self.boundary == 0 {
            return Vec::new();
        }
        let open = |(f, edges): (usize, &[u32; 3])| {
            let edges = *edges;
            (0..3).filter(move |&i| edges[i] == NO_FACE).map(move |i| (3 * f + i) as u32)
        };
        self.neighbours.iter().enumerate().flat_map(open).collect()
    }

    /// Reverses face `f`: its last two corners change places, and two edges with them.
    pub fn flip(&mut self, f: usize) {
        self.faces[f].swap(1, 2);
        self.neighbours[f].swap(0, 2);
        if self.reversed.len() <= f {
            self.reversed.resize(self.faces.len(), false);
        }
        self.reversed[f] ^= true;
    }

    /// Number of faces that run against their direction in the file.
    pub fn reversed(&self) -> usize {
        self.reversed.iter().filter(|&&reversed| reversed).count()
    }

    /// Drops the marked faces and connects the rest; returns how many were dropped.
    pub fn drop_faces(&mut self, dropped: &[bool]) -> usize {
        let before = self.faces.len();
        let (mut marks, mut same) = (dropped.iter(), dropped.iter());
        self.faces.retain(|_| marks.next() != Some(&true));
        self.reversed.retain(|_| same.next() != Some(&true));
        if self.faces.len() < before {
            self.connect();
        }
        before - self.faces.len()
    }

    /// Drops the vertices that no face has.
    pub fn compact(&mut self) {
        let mut map = vec![u32::MAX; self.vertices.len()];
        for &v in self.faces.as_flattened() {
            map[v as usize] = 0;
        }
        let mut kept = 0;
        for (old, new) in map.iter_mut().enumerate() {
            if *new == 0 {
                *new = kept as u32;
                self.vertices[kept] = self.vertices[old];
                kept += 1;
            }
        }
        self.vertices.truncate(kept);
        for v in self.faces.as_flattened_mut() {
            *v = map[*v as usize];
        }
    }
}

impl Mesh {
    /// A mesh of welded vertices and faces, with its adjacency and without any repair.
    ///
    /// Each face must have three different vertices, all below the number of vertices. At edges
    /// with more than two faces these are paired so that manifold sheets remain.
    ///
    /// # Panics
    /// Where a face names a vertex that does not exist.
    #[must_use]
    pub fn new(vertices: Vec<DVec3>, faces: Vec<[u32; 3]>) -> Self {
        Surface::new(vertices, faces).into()
    }
}

impl From<Surface> for Mesh {
    fn from(surface: Surface) -> Self {
        let Surface { vertices, faces, neighbours, .. } = surface;
        Self { vertices, faces, neighbours, placement: DAffine3::IDENTITY }
    }
}
