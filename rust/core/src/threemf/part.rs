//! Reads a model part: its objects, what they are made of, and what shall be built.

use std::collections::HashSet;

use super::extensions::{self, BEAMS, PRODUCTION, SETS, SLIC3R};
use super::model::{MOST_TRIANGLES, MOST_VERTICES, Object, Part, Placed};
use super::paint::MOST_DIGITS;
use super::values::{Read, count, kept, number, parsed, required};
use crate::mesh::weld::LARGEST;
use crate::xml::{Element, Handler, Reader, shown};
use crate::{CoreError, Result};

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

/// Most objects of a part.
const MOST_OBJECTS: usize = 1 << 16;
/// Most triangle sets of a part.
const MOST_SETS: usize = 1 << 12;
/// Most items and components of a part.
const MOST_PLACED: usize = 1 << 16;

/// Reads a model part piece by piece.
pub struct PartReader(Reader<PartDraft>);

impl Default for PartReader {
    fn default() -> Self {
        Self(Reader::new(PartDraft::default()))
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
    /// As [`Reader::finish`]; also where the document is another one than a model.
    pub fn finish(self) -> Result<Part> {
        let filled = self.0.finish()?;
        if !filled.is_model {
            return Err(CoreError::Unreadable("its outermost element is no <model>".into()));
        }
        Ok(filled.part)
    }
}

/// A part that is being filled.
#[derive(Default)]
struct PartDraft {
    part: Part,
    is_model: bool,
    /// Namespace of the outermost element, and so of the core specification.
    core: Option<String>,
    ids: HashSet<String>,
    /// How many elements are open from the last object on, and which of its sets is.
    within: usize,
    set: Option<usize>,
    /// The flag whose value follows.
    flag: Option<String>,
    // How many of each there are.
    objects: usize,
    vertices: usize,
    triangles: usize,
    digits: usize,
    sets: usize,
    placed: usize,
}

impl Handler for PartDraft {
    fn start(&mut self, element: &Element<'_>) -> Read<()> {
        let outermost = self.core.is_none();
        let core = self.core.get_or_insert_with(|| element.namespace.to_string());
        let is_core = element.namespace == core;
        self.shape(element, is_core);
        self.within += usize::from(self.within > 0);
        if is_core {
            match element.name {
                "vertex" => self.vertex(element),
                "triangle" => self.triangle(element),
                "component" => self.component(element),
                "item" => self.item(element),
                "object" => self.object(element),
                "model" if outermost => self.model(element),
                "model" => Err("makes no sense within another element".into()),
                "metadata" => self.metadata(element),
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
        self.within = self.within.saturating_sub(1);
        self.flag = None;
        if self.within == 0 || name == "triangleset" && namespace == SETS {
            self.set = None;
        }
    }

    fn text(&mut self, text: &str) -> Read<()> {
        if self.flag.is_some() && text.trim().eq_ignore_ascii_case("true") {
            let flag = self.flag.take();
            if let Some(object) = open(&mut self.part, self.within) {
                object.flag = flag;
            }
        }
        Ok(())
    }
}

impl PartDraft {
    fn model(&mut self, element: &Element<'_>) -> Read<()> {
        extensions::check_required(element)?;
        let unit = element.get("unit").unwrap_or("millimeter".into());
        let known = UNITS_MM.iter().find(|(name, _)| *name == unit);
        let (_, mm) =
            known.ok_or_else(|| format!("makes no sense: unknown unit '{}'", shown(&unit)))?;
        self.part.unit_mm = *mm;
        self.is_model = true;
        Ok(())
    }

    fn object(&mut self, element: &Element<'_>) -> Read<()> {
        let id = kept(required(element, "id")?)?;
        if !self.ids.insert(id.clone()) {
            return Err(format!("makes no sense: another one has the id '{}'", shown(&id)));
        }
        count(&mut self.objects, 1, MOST_OBJECTS, "objects")?;
        let text = |name: &str| element.get(name).map(kept).transpose();
        self.part.objects.push(Object {
            id,
            name: text("name")?.unwrap_or_default(),
            kind: text("type")?.unwrap_or_else(|| "model".into()),
            ..Object::default()
        });
        (self.within, self.set) = (1, None);
        Ok(())
    }

    /// Notes an extension that gives the open object its shape: in place of a mesh or components,
    /// or beside a mesh's triangles.
    fn shape(&mut self, element: &Element<'_>, is_core: bool) {
        let place = self.within;
        let Some(object) = open(&mut self.part, place) else { return };
        let instead = place == 1 && !is_core;
        let lattice = element.name == "beamlattice" && element.namespace == BEAMS;
        if instead || lattice {
            object.foreign.get_or_insert_with(|| extensions::in_words(element.namespace));
        }
    }

    /// Notes whose value follows: a flag of Cura's.
    fn metadata(&mut self, element: &Element<'_>) -> Read<()> {
        let name = element.get("name").unwrap_or_default();
        if let Some(flag) = name.strip_prefix("cura:").filter(|flag| flag.ends_with("_mesh")) {
            self.flag = Some(kept(flag.into())?);
        }
        Ok(())
    }

    fn vertex(&mut self, element: &Element<'_>) -> Read<()> {
        let point = [number(element, "x")?, number(element, "y")?, number(element, "z")?];
        let Some(object) = open(&mut self.part, self.within) else { return Ok(()) };
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
        let Some(object) = open(&mut self.part, self.within) else { return Ok(()) };
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
        if let Some(object) = open(&mut self.part, self.within) {
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
        let printable = element.get("printable").is_none_or(|text| text != "0");
        Ok(Placed { object_id, transform, path, printable })
    }

    fn triangle_set(&mut self, element: &Element<'_>) -> Read<()> {
        count(&mut self.sets, 1, MOST_SETS, "triangle sets")?;
        let Some(object) = open(&mut self.part, self.within) else { return Ok(()) };
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
        let object = open(&mut self.part, self.within);
        if let Some((_, ranges)) = object.and_then(|object| object.sets.get_mut(self.set?)) {
            ranges.push([first, last]);
        }
        Ok(())
    }
}

/// The object that is open: the last one, if it is.
fn open(part: &mut Part, within: usize) -> Option<&mut Object> {
    part.objects.last_mut().filter(|_| within > 0)
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
