//! Wavefront OBJ: vertices and faces; normals, textures and materials are passed over.
//!
//! Source: Wavefront, Advanced Visualizer Manual, appendix B1, Object files.

use std::borrow::Cow;

use glam::DVec3;

use super::facets::{Facets, Outlines};
use super::notes::Notes;
use super::text::{self, Lines, Read, coordinate, next_number, number, shown, uncommented, words};
use crate::{CoreError, Result};

/// Statements that say nothing of where a polygon's surface is.
const PASSED_OVER: [&[u8]; 22] = [
    b"vt",
    b"vn",
    b"vp",
    b"g",
    b"o",
    b"s",
    b"mg",
    b"usemtl",
    b"mtllib",
    b"usemap",
    b"maplib",
    b"lod",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"shadow_obj",
    b"trace_obj",
    b"deg",
    b"cstype",
    b"bmat",
    b"step",
    b"end",
];
/// Statements of free-form curves and surfaces.
const FREE_FORM: [&[u8]; 15] = [
    b"curv", b"curv2", b"surf", b"parm", b"trim", b"hole", b"scrv", b"sp", b"con", b"ctech",
    b"stech", b"bzp", b"bsp", b"cdc", b"cdp",
];

/// Reads a file that was taken in as a whole.
///
/// # Errors
/// [`CoreError::Unreadable`] with the line of what makes no sense, and where there is no face.
pub fn read(bytes: Vec<u8>) -> Result<Facets> {
    let text = text::decoded(bytes);
    let mut model = Model { outlines: Outlines::counted_from(1), ..Model::default() };
    let mut lines = Lines::new(&text);
    while let Some(line) = lines.next() {
        let at = lines.number;
        let statement = continued(uncommented(line), &mut lines);
        let taken = model.take(&statement, at);
        taken.map_err(|what| CoreError::Unreadable(format!("line {at}: {what}")))?;
    }
    if model.outlines.is_empty() && model.free_form {
        let text = "it holds free-form curves and surfaces, and no faces";
        return Err(CoreError::Unreadable(text.into()));
    }
    model.outlines.filled(model.vertices, model.notes, |line| format!("line {line}"))
}

/// A line with those that continue it: each but the last ends in a backslash.
fn continued<'a>(line: &'a [u8], lines: &mut Lines<'a>) -> Cow<'a, [u8]> {
    let mut whole = Cow::Borrowed(line);
    while let Some(before) = whole.trim_ascii_end().strip_suffix(b"\\") {
        let Some(next) = lines.next() else { return Cow::Owned(before.to_vec()) };
        whole = Cow::Owned([before, b" ", uncommented(next)].concat());
    }
    whole
}

#[derive(Default)]
struct Model {
    vertices: Vec<DVec3>,
    outlines: Outlines,
    free_form: bool,
    notes: Notes,
}

impl Model {
    /// Takes in a statement of a line.
    fn take(&mut self, statement: &[u8], line: u64) -> Read<()> {
        let mut words = words(statement);
        match words.next() {
            None => {}
            Some(b"v") => self.vertex(&mut words)?,
            Some(b"f" | b"fo") => self.face(words, line)?,
            Some(b"l" | b"p") => self.notes.add("lines and points left out", line),
            Some(b"call" | b"csh") => return Err("it calls another file, which is not read".into()),
            Some(word) if FREE_FORM.contains(&word) => {
                self.free_form = true;
                self.notes.add("free-form curves and surfaces left out", line);
            }
            Some(word) if PASSED_OVER.contains(&word) => {}
            Some(_) => self.notes.add("what is no statement of OBJ passed over", line),
        }
        Ok(())
    }

    fn vertex<'a>(&mut self, words: &mut impl Iterator<Item = &'a [u8]>) -> Read<()> {
        let mut next = || coordinate(next_number(words)?);
        self.vertices.push(DVec3::new(next()?, next()?, next()?));
        Ok(())
    }

    fn face<'a>(&mut self, corners: impl Iterator<Item = &'a [u8]>, line: u64) -> Read<()> {
        for corner in corners {
            let vertex = corner.split(|&b| b == b'/').next().unwrap_or_default();
            self.outlines.corner(self.index(number(vertex)?, corner)?, line);
        }
        self.outlines.end(&mut self.notes, line);
        Ok(())
    }

    /// The vertex of a number: counted from 1, or back from the last one.
    fn index(&self, number: i64, corner: &[u8]) -> Read<u32> {
        let index = match number {
            1.. => Some(number - 1),
            0 => None,
            _ => Some(self.vertices.len() as i64 + number),
        };
        let index = index.and_then(|index| u32::try_from(index).ok());
        index.ok_or_else(|| {
            format!("a face has the corner {}, of {} vertices", shown(corner), self.vertices.len())
        })
    }
}
