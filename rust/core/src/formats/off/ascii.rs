//! ASCII files.

use glam::DVec3;

use super::super::facets::{Facets, Outlines};
use super::super::notes::Notes;
use super::super::records::Records;
use super::super::text::{Lines, Read, coordinate, number, shown};
use super::header::Header;
use crate::{CoreError, Result};

/// Reads a text.
///
/// # Errors
/// [`CoreError::Unreadable`] with the line of what makes no sense, and where there is no face.
pub fn read(text: &[u8]) -> Result<Facets> {
    let mut records = Records::new(Lines::new(text), true);
    let mut model = Model::default();
    let header = counts(&mut records);
    let taken = header.and_then(|header| model.take(&mut records, header));
    taken.map_err(|what| CoreError::Unreadable(format!("line {}: {what}", records.at())))?;
    model.outlines.filled(model.vertices, model.notes, |line| format!("line {line}"))
}

/// What is said before the vertices.
struct Counts {
    header: Header,
    vertices: u64,
    faces: u64,
}

/// Reads the first word, which may be missing, and how many vertices and faces there are; the
/// number of edges may be missing, too.
fn counts(records: &mut Records<'_>) -> Read<Counts> {
    let first = records.word()?;
    let header = Header::of(first).map_err(|error| error.to_string())?;
    let count = match header {
        Some(_) => records.word()?,
        None => first,
    };
    let known = |_| format!("expected OFF and how many vertices there are, found {}", shown(count));
    let vertices = number(count).map_err(known)?;
    let faces = number(records.word()?)?;
    records.try_word();
    records.expect(u64::saturating_add(vertices, faces));
    Ok(Counts { header: header.unwrap_or_default(), vertices, faces })
}

#[derive(Default)]
struct Model {
    vertices: Vec<DVec3>,
    outlines: Outlines,
    notes: Notes,
}

impl Model {
    fn take(&mut self, records: &mut Records<'_>, counts: Counts) -> Read<()> {
        if counts.header.extras > 0 && !records.lined() {
            return Err(
                "its vertices have colours or normals, but no line of their own each".into()
            );
        }
        for _ in 0..counts.vertices {
            records.begin()?;
            self.vertex(records, counts.header)?;
        }
        for _ in 0..counts.faces {
            records.begin()?;
            self.face(records)?;
        }
        if records.any_left() {
            self.notes.add("what follows the last face passed over", records.at());
        }
        Ok(())
    }

    fn vertex(&mut self, records: &mut Records<'_>, header: Header) -> Read<()> {
        let mut next = || number(records.word()?).and_then(coordinate);
        let point = DVec3::new(next()?, next()?, next()?);
        let divisor = if header.homogeneous { next()? } else { 1.0 };
        let place = point / divisor;
        place.to_array().into_iter().try_for_each(|value| coordinate(value).map(|_| ()))?;
        self.vertices.push(place);
        Ok(())
    }

    fn face(&mut self, records: &mut Records<'_>) -> Read<()> {
        let corners: u64 = number(records.word()?)?;
        for _ in 0..corners {
            self.outlines.corner(number(records.word()?)?, records.at());
        }
        self.outlines.end(&mut self.notes, records.at());
        // Its colours may follow, where it has a line of its own.
        Ok(())
    }
}
