//! What a model file holds: vertices, and faces of three or more corners.

use glam::DVec3;

use super::notes::Notes;
use super::polygon::{self, Polygon};
use crate::mesh::size::claim;
use crate::mesh::weld;
use crate::{CoreError, Result};

/// Polygons of fewer corners, which have no surface.
const LESS_THAN_A_FACE: &str = "faces of fewer than three corners left out";
/// Polygons that no triangles fill.
const CROSSED: &str = "faces whose outline crosses itself, filled as well as it goes";

/// Vertices and triangles of a file, and what is to be said of how they were read.
#[derive(Debug)]
pub struct Facets {
    /// Positions in the file's unit.
    pub vertices: Vec<DVec3>,
    /// Indices of vertices that exist.
    pub faces: Vec<[u32; 3]>,
    /// Sentences about what was passed over or mended.
    pub notes: Vec<String>,
}

impl Facets {
    /// The same with equal vertices as one.
    ///
    /// # Errors
    /// As [`weld::weld_facets`].
    pub fn welded(self) -> Result<Self> {
        let (vertices, faces) = weld::weld_facets(&self.vertices, &self.faces)?;
        Ok(Self { vertices, faces, ..self })
    }
}

/// Faces as a file gives them, while it is read.
#[derive(Debug, Default)]
pub struct Outlines {
    /// Corners of all faces, one face after another, and where each ends.
    corners: Vec<u32>,
    ends: Vec<usize>,
    /// The highest vertex that a face names, and the place of that face.
    highest: Option<(u32, u64)>,
    /// What the format calls its first vertex: 0 or 1.
    first: u32,
}

impl Outlines {
    /// No faces yet, of a format that calls its first vertex so: 0 or 1.
    pub fn counted_from(first: u32) -> Self {
        Self { first, ..Self::default() }
    }

    /// Whether there is no face.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Adds a corner of a face at a place: the index of a vertex, which may come later.
    pub fn corner(&mut self, vertex: u32, place: u64) {
        self.corners.push(vertex);
        if self.highest.is_none_or(|(highest, _)| vertex > highest) {
            self.highest = Some((vertex, place));
        }
    }

    /// Ends a face, all of whose corners were added.
    pub fn end(&mut self, notes: &mut Notes, place: u64) {
        let begin = self.ends.last().copied().unwrap_or_default();
        if self.corners.len() - begin < 3 {
            notes.add(LESS_THAN_A_FACE, place);
            self.corners.truncate(begin);
        } else {
            self.ends.push(self.corners.len());
        }
    }

    /// Triangles that fill the faces.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] where a face names a vertex that is not there, with its place, or
    /// has a hopeless outline, and where there is no face; otherwise as [`claim`].
    pub fn filled(
        self,
        vertices: Vec<DVec3>,
        notes: Notes,
        place: impl Fn(u64) -> String,
    ) -> Result<Facets> {
        if let Some((highest, at)) = self.highest.filter(|&(v, _)| v as usize >= vertices.len()) {
            return Err(CoreError::Unreadable(format!(
                "{}: a face names vertex {}, but there are {} vertices, counted from {}",
                place(at),
                u64::from(highest) + u64::from(self.first),
                vertices.len(),
                self.first
            )));
        }
        if self.is_empty() {
            let points = if vertices.is_empty() { "" } else { ", only points" };
            return Err(CoreError::Unreadable(format!("the file has no facets{points}")));
        }
        let triangles = self.corners.len() - 2 * self.ends.len();
        claim(triangles as u64)?;
        let mut faces = Vec::with_capacity(triangles);
        let (mut begin, mut crossed) = (0, Notes::default());
        for (number, &end) in (1..).zip(&self.ends) {
            let polygon = Polygon { vertices: &vertices, corners: &self.corners[begin..end] };
            let simple = polygon::fill(&polygon, &mut faces).ok_or_else(|| {
                CoreError::Unreadable(format!(
                    "face {number} has {} corners and too winding an outline",
                    end - begin
                ))
            })?;
            if !simple {
                crossed.add(CROSSED, number);
            }
            begin = end;
        }
        let mut notes = notes.in_words(place);
        notes.extend(crossed.in_words(|number| format!("face {number}")));
        Ok(Facets { vertices, faces, notes })
    }
}
