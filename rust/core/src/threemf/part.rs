//! A model part: its objects, what they are made of, and what shall be built.

use std::collections::HashSet;

use super::paint::{MOST_DIGITS, Painting};
use super::values::{Read, kept, number, parsed, required};
use crate::Result;
use crate::mesh::weld::LARGEST;
use crate::xml::{Element, Handler, Reader, shown};

/// Namespace of triangle sets, 3MF core specification 1.3, chapter 4.3.
const SETS: &str = "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07";
/// The production extension, whose attribute `path` refers to another part.
const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
/// PrusaSlicer's namespace; its attribute `mmu_segmentation` paints a triangle.
const SLIC3R: &str = "http://schemas.slic3r.org/3mf/2017/06";
/// Millimetres per unit (3MF core specification 1.3, section 3.4, attribute `unit`).
const UNITS_MM: [(&str, f64); 6] = [
    ("micron", 0.001),
    ("millimeter", 1.0),
    ("centimeter", 10.0),
    ("inch", 25.4),
    ("foot", 304.8),
    ("meter", 1000.0),
];
const IDENTITY: [f64; 12] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

/// Most triangles of a part; a mesh of that many takes a gigabyte.
pub const MOST_TRIANGLES: usize = 1 << 23;
/// Most vertices of a part: a closed mesh has half as many as triangles.
pub const MOST_VERTICES: usize = MOST_TRIANGLES / 2;
/// Most objects of a part.
const MOST_OBJECTS: usize = 1 << 16;
/// Most triangle sets of a part.
const MOST_SETS: usize = 1 << 12;
/// Most items and components of a part.
const MOST_PLACED: usize = 1 << 16;

/// An object that is placed: by the build, or as a component of another one.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The object's id.
    pub object_id: String,
    /// Row by row: (x, y, z, 1) · matrix is where a point goes.
    pub transform: [f64; 12],
    /// The part that has the object, if it is another one.
    pub path: Option<String>,
}

/// First and last triangle of each range.
pub type Ranges = Vec<[u32; 2]>;

/// A mesh, or components.
#[derive(Debug, Default)]
pub struct Object {
    /// Its name within the part.
    pub id: String,
    /// Positions in the part's unit.
    pub vertices: Vec<[f64; 3]>,
    /// Indices of vertices that exist.
    pub triangles: Vec<[u32; 3]>,
    /// What is painted on the triangles.
    pub painting: Painting,
    /// Names of triangle sets, in order, and the triangles that they name, unchecked.
    pub sets: Vec<(String, Ranges)>,
    /// Objects that it is made of.
    pub components: Vec<Placed>,
}

/// One model part.
#[derive(Debug, Default)]
pub struct Part {
    /// Millimetres per unit.
    pub unit_mm: f64,
    /// In the order of the file; ids differ.
    pub objects: Vec<Object>,
    /// What shall be built.
    pub items: Vec<Placed>,
}

/// Reads a model part piece by piece.
pub struct PartReader(Reader<Filling>);

impl Default for PartReader {
    fn default() -> Self {
        Self(Reader::new(Filling::default()))
    }
}

impl PartReader {
    /// Takes in the next piece.
    ///
    /// # Errors
    /// As [`Reader::feed`]; also where numbers, names or indices make no sense, and where there is
    /// too much of something.
    pub fn feed(&mut self, bytes: &[u8]) -> Result<()> {
        self.0.feed(bytes)
    }

    /// Ends the part.
    ///
    /// # Errors
    /// As [`Reader::finish`].
    pub fn finish(self) -> Result<Part> {
        Ok(self.0.finish()?.part)
    }
}

/// A part that is being filled.
#[derive(Default)]
struct Filling {
    part: Part,
    /// Namespace of the outermost element, and so of the core specification.
    core: Option<String>,
    ids: HashSet<String>,
    /// Whether the last object is open, and which of its sets is.
    inside: bool,
    set: Option<usize>,
    // How many of each there are.
    objects: usize,
    vertices: usize,
    triangles: usize,
    digits: usize,
    sets: usize,
    placed: usize,
}

impl Handler for Filling {
    fn start(&mut self, element: &Element<'_>) -> Read<()> {
        let core = self.core.get_or_insert_with(|| element.namespace.to_string());
        if element.namespace == core {
            match element.name {
                "vertex" => self.vertex(element),
                "triangle" => self.triangle(element),
                "component" => self.component(element),
                "item" => self.item(element),
                "object" => self.object(element),
                "model" => self.model(element),
                _ => Ok(()),
            }
        } else if element.namespace == SETS {
            match element.name {
                "triangleset" => self.triangle_set(element),
                "ref" => {
                    let index = number(element, "index")?;
                    self.refer(index, index)
                }
                "refrange" => {
                    self.refer(number(element, "startindex")?, number(element, "endindex")?)
                }
                _ => Ok(()),
            }
        } else {
            Ok(())
        }
    }

    fn end(&mut self, namespace: &str, name: &str) {
        if name == "object" && self.core.as_deref() == Some(namespace) {
            self.inside = false;
            self.set = None;
        } else if name == "triangleset" && namespace == SETS {
            self.set = None;
        }
    }
}

impl Filling {
    fn model(&mut self, element: &Element<'_>) -> Read<()> {
        let unit = element.get("unit").unwrap_or("millimeter".into());
        let known = UNITS_MM.iter().find(|(name, _)| *name == unit);
        let (_, mm) =
            known.ok_or_else(|| format!("makes no sense: unknown unit '{}'", shown(&unit)))?;
        self.part.unit_mm = *mm;
        Ok(())
    }

    fn object(&mut self, element: &Element<'_>) -> Read<()> {
        let id = kept(required(element, "id")?)?;
        if !self.ids.insert(id.clone()) {
            return Err(format!("makes no sense: another one has the id '{}'", shown(&id)));
        }
        count(&mut self.objects, 1, MOST_OBJECTS, "objects")?;
        self.part.objects.push(Object { id, ..Object::default() });
        self.inside = true;
        self.set = None;
        Ok(())
    }

    fn vertex(&mut self, element: &Element<'_>) -> Read<()> {
        let point = [number(element, "x")?, number(element, "y")?, number(element, "z")?];
        let Some(object) = open(&mut self.part, self.inside) else { return Ok(()) };
        if !point.iter().all(|v: &f64| v.abs() <= LARGEST) {
            return Err(format!(
                "makes no sense: vertex {} of object '{}' is {point:?}: \
                 no finite, sensible coordinates",
                object.vertices.len(),
                shown(&object.id)
            ));
        }
        count(&mut self.vertices, 1, MOST_VERTICES, "vertices")?;
        object.vertices.push(point);
        Ok(())
    }

    fn triangle(&mut self, element: &Element<'_>) -> Read<()> {
        let corners = [number(element, "v1")?, number(element, "v2")?, number(element, "v3")?];
        let Some(object) = open(&mut self.part, self.inside) else { return Ok(()) };
        let there = object.vertices.len();
        let Some(triangle) = indices(corners, there) else {
            return Err(format!(
                "makes no sense: triangle {} of object '{}' names vertices {corners:?}, \
                 but there are {there} before it",
                object.triangles.len(),
                shown(&object.id)
            ));
        };
        count(&mut self.triangles, 1, MOST_TRIANGLES, "triangles")?;
        // More than its corners: it may be painted.
        if element.attributes() > corners.len() {
            let text = element.get("paint_color").filter(|text| !text.is_empty());
            if let Some(text) = text.or_else(|| element.get_in(SLIC3R, "mmu_segmentation")) {
                count(&mut self.digits, text.len(), MOST_DIGITS, "digits of paint")?;
                object.painting.add(object.triangles.len() as u32, &text);
            }
        }
        object.triangles.push(triangle);
        Ok(())
    }

    fn component(&mut self, element: &Element<'_>) -> Read<()> {
        let placed = self.place(element)?;
        if let Some(object) = open(&mut self.part, self.inside) {
            object.components.push(placed);
        }
        Ok(())
    }

    fn item(&mut self, element: &Element<'_>) -> Read<()> {
        let placed = self.place(element)?;
        self.part.items.push(placed);
        Ok(())
    }

    fn place(&mut self, element: &Element<'_>) -> Read<Placed> {
        count(&mut self.placed, 1, MOST_PLACED, "items and components")?;
        let transform = match element.get("transform").filter(|text| !text.is_empty()) {
            Some(text) => matrix(&text)?,
            None => IDENTITY,
        };
        let object_id = kept(required(element, "objectid")?)?;
        let path = element.get_in(PRODUCTION, "path").map(kept).transpose()?;
        Ok(Placed { object_id, transform, path })
    }

    fn triangle_set(&mut self, element: &Element<'_>) -> Read<()> {
        count(&mut self.sets, 1, MOST_SETS, "triangle sets")?;
        let Some(object) = open(&mut self.part, self.inside) else { return Ok(()) };
        let name = element.get("name").filter(|name| !name.is_empty());
        let name = kept(name.map_or_else(|| required(element, "identifier"), Ok)?)?;
        let known = object.sets.iter().position(|(known, _)| *known == name);
        let set = known.unwrap_or(object.sets.len());
        if known.is_none() {
            object.sets.push((name, Vec::new()));
        }
        self.set = Some(set);
        Ok(())
    }

    fn refer(&mut self, first: u32, last: u32) -> Read<()> {
        let object = open(&mut self.part, self.inside);
        if let Some((_, ranges)) = object.and_then(|object| object.sets.get_mut(self.set?)) {
            ranges.push([first, last]);
        }
        Ok(())
    }
}

/// The object that is open: the last one, if it is.
fn open(part: &mut Part, inside: bool) -> Option<&mut Object> {
    part.objects.last_mut().filter(|_| inside)
}

/// Counts some more, and refuses what is too much.
fn count(counted: &mut usize, more: usize, most: usize, what: &str) -> Read<()> {
    *counted += more;
    if *counted <= most {
        Ok(())
    } else {
        Err(format!("is too much: there are over {most} {what}"))
    }
}

/// The corners as indices of vertices, if all of them are there.
fn indices(corners: [i64; 3], count: usize) -> Option<[u32; 3]> {
    let index = |corner: i64| u32::try_from(corner).ok().filter(|&index| (index as usize) < count);
    let [a, b, c] = corners.map(index);
    Some([a?, b?, c?])
}

/// The twelve numbers of a transform.
fn matrix(text: &str) -> Read<[f64; 12]> {
    let numbers: Vec<f64> = text.split_ascii_whitespace().map(parsed).collect::<Read<_>>()?;
    let count = numbers.len();
    let wrong = |_| format!("makes no sense: a transform has 12 numbers, not {count}");
    numbers.try_into().map_err(wrong)
}
