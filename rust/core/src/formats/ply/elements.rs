//! Elements as vertices and faces; those of other kinds are passed over.

use glam::DVec3;

use super::super::facets::{Facets, Outlines};
use super::super::notes::Notes;
use super::super::text::{Read, coordinate};
use super::header::{ElementKind, Header, Property};
use super::values::Values;
use crate::{CoreError, Result};

/// Names of the list of a face's, or a strip's, vertices.
const LISTS: [&[u8]; 2] = [b"vertex_indices", b"vertex_index"];
/// Ends a strip of triangles within a list.
const RESTART: f64 = -1.0;

/// What is known of a model.
#[derive(Default)]
pub struct Model {
    vertices: Vec<DVec3>,
    outlines: Outlines,
    notes: Notes,
}

impl Model {
    /// Reads all that a header declares.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] with the place of what makes no sense, and where there is no face.
    pub fn read<V: Values>(mut self, header: &Header, mut values: V) -> Result<Facets> {
        for (index, element) in header.elements.iter().enumerate() {
            let twice = header.elements[..index].iter().any(|other| other.name == element.name);
            if twice {
                let text = format!("{} is declared twice", name(&element.name));
                return Err(CoreError::Unreadable(text));
            }
            let mut number = 0;
            let taken = self.all(element, &mut values, &mut number);
            taken.map_err(|what| {
                CoreError::Unreadable(format!(
                    "{}: {} {number} of {}: {what}",
                    V::place(values.at()),
                    name(&element.name),
                    element.count
                ))
            })?;
        }
        if values.any_left() {
            self.notes.add("what follows the last element passed over", values.at());
        }
        self.outlines.filled(self.vertices, self.notes, V::place)
    }

    /// Takes in all elements of a kind, keeping their number.
    fn all(
        &mut self,
        element: &ElementKind,
        values: &mut impl Values,
        number: &mut u64,
    ) -> Read<()> {
        if element.count == 0 || element.properties.is_empty() {
            return Ok(());
        }
        let role = Role::of(element)?;
        while *number < element.count {
            *number += 1;
            values.begin()?;
            match role {
                Role::Vertex(axes) => self.vertex(element, values, axes)?,
                Role::Face(list) => self.listed(element, values, list, Self::face)?,
                Role::Strips(list) => self.listed(element, values, list, Self::strips)?,
                Role::Other => {
                    element.properties.iter().try_for_each(|other| skip(values, other))?;
                }
            }
            values.end()?;
        }
        Ok(())
    }

    fn vertex(
        &mut self,
        element: &ElementKind,
        values: &mut impl Values,
        axes: [usize; 3],
    ) -> Read<()> {
        let mut point = [0.0; 3];
        for (index, property) in element.properties.iter().enumerate() {
            match axes.iter().position(|&axis| axis == index) {
                Some(axis) => point[axis] = coordinate(values.next(property.value)?)?,
                None => skip(values, property)?,
            }
        }
        self.vertices.push(point.into());
        Ok(())
    }

    /// Takes in the list of an element, and passes over its other properties.
    fn listed<V: Values>(
        &mut self,
        element: &ElementKind,
        values: &mut V,
        list: usize,
        take: impl Fn(&mut Self, &Property, &mut V) -> Read<()>,
    ) -> Read<()> {
        for (index, property) in element.properties.iter().enumerate() {
            if index == list {
                take(self, property, values)?;
            } else {
                skip(values, property)?;
            }
        }
        Ok(())
    }

    fn face(&mut self, list: &Property, values: &mut impl Values) -> Read<()> {
        let at = values.at();
        for _ in 0..length(values, list)? {
            let value = values.next(list.value)?;
            self.outlines.corner(vertex(value)?, at);
        }
        self.outlines.end(&mut self.notes, at);
        Ok(())
    }

    /// Strips of triangles: each corner makes one with the two before it.
    fn strips(&mut self, list: &Property, values: &mut impl Values) -> Read<()> {
        let (mut last, mut odd) = ([None, None], false);
        for _ in 0..length(values, list)? {
            let at = values.at();
            let value = values.next(list.value)?;
            if value == RESTART {
                (last, odd) = ([None, None], false);
                continue;
            }
            let corner = vertex(value)?;
            if let [Some(a), Some(b)] = last {
                let triangle = if odd { [b, a, corner] } else { [a, b, corner] };
                triangle.into_iter().for_each(|v| self.outlines.corner(v, at));
                self.outlines.end(&mut self.notes, at);
                odd = !odd;
            }
            last = [last[1], Some(corner)];
        }
        Ok(())
    }
}

/// What an element is to a model; properties by their index.
#[derive(Clone, Copy)]
enum Role {
    Vertex([usize; 3]),
    Face(usize),
    Strips(usize),
    Other,
}

impl Role {
    fn of(element: &ElementKind) -> Read<Self> {
        let find = |names: &[&[u8]], list: bool| {
            let wanted = |p: &Property| p.length.is_some() == list && names.contains(&&*p.name);
            let found = element.properties.iter().position(wanted);
            found.ok_or_else(|| format!("it has no property {}", name(names[0])))
        };
        Ok(match element.name.as_slice() {
            b"vertex" => {
                Self::Vertex([find(&[b"x"], false)?, find(&[b"y"], false)?, find(&[b"z"], false)?])
            }
            b"face" => Self::Face(find(&LISTS, true)?),
            b"tristrips" => Self::Strips(find(&LISTS, true)?),
            b"range_grid" => return Err("it is a grid of a scanner, which is no surface".into()),
            _ => Self::Other,
        })
    }
}

fn skip(values: &mut impl Values, property: &Property) -> Read<()> {
    let count = if property.length.is_some() { length(values, property)? } else { 1 };
    values.skip(property.value, count)
}

/// The length of a list.
fn length(values: &mut impl Values, list: &Property) -> Read<u64> {
    let Some(kind) = list.length else { return Ok(1) };
    let value = values.next(kind)?;
    whole(value).ok_or_else(|| format!("{value} is no length of a list"))
}

fn vertex(value: f64) -> Read<u32> {
    let index = whole(value).and_then(|index| u32::try_from(index).ok());
    index.ok_or_else(|| format!("{value} is no index of a vertex"))
}

/// A value as an integer, if it is one that is not negative.
fn whole(value: f64) -> Option<u64> {
    (value >= 0.0 && value.fract() == 0.0 && value <= f64::from(u32::MAX)).then_some(value as u64)
}

fn name(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).escape_debug().take(40).collect()
}
