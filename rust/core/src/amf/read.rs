//! Reads the document of an AMF file piece by piece.

use glam::DVec3;

use super::place::bodies;
use super::{Constellation, Instance, Model, Object, Purpose, Volume};
use crate::mesh::weld::LARGEST;
use crate::xml::{Element, Handler, Reader, shown};
use crate::{CoreError, Result};

/// Millimetres per unit (ISO/ASTM 52915, attribute `unit`).
const UNITS_MM: [(&str, f64); 7] = [
    ("millimeter", 1.0),
    ("inch", 25.4),
    ("feet", 304.8),
    ("foot", 304.8),
    ("meter", 1000.0),
    ("micron", 0.001),
    ("micrometer", 0.001),
];
/// Most bytes of an id.
const MOST_ID: usize = 1 << 10;
/// Where a vertex has no coordinate yet.
const MISSING: DVec3 = DVec3::NAN;

type Read<T> = std::result::Result<T, String>;

/// Reads a document piece by piece.
pub struct AmfReader(Reader<Filling>);

impl Default for AmfReader {
    fn default() -> Self {
        Self(Reader::new(Filling::default()))
    }
}

impl AmfReader {
    /// Takes in the next piece.
    ///
    /// # Errors
    /// As [`Reader::feed`]; also where numbers make no sense.
    pub fn feed(&mut self, bytes: &[u8]) -> Result<()> {
        self.0.feed(bytes)
    }

    /// Ends the document: what it places.
    ///
    /// # Errors
    /// As [`Reader::finish`]; [`CoreError::Unreadable`] where a triangle or a constellation names
    /// what is not there, a vertex has no place, or nothing is to be printed; [`CoreError::Memory`].
    pub fn finish(self) -> Result<Model> {
        let filled = self.0.finish()?;
        if !filled.is_amf {
            return Err(CoreError::Unreadable("this is XML, but no AMF".into()));
        }
        filled.objects.iter().try_for_each(check)?;
        let bodies = bodies(&filled.objects, &filled.constellations)?;
        if !bodies.iter().any(|body| body.purpose == Purpose::Part) {
            return Err(CoreError::Unreadable(
                "nothing is to be printed: it has no triangle".into(),
            ));
        }
        let left_out = filled.objects.iter().flat_map(|object| &object.volumes);
        let left_out = left_out.filter(|volume| volume.purpose == Purpose::LeftOut).count();
        let mut notes = Vec::new();
        if left_out > 0 {
            let volumes = if left_out == 1 { "volume" } else { "volumes" };
            notes.push(format!("{left_out} {volumes} left out: for supports, or for settings"));
        }
        if filled.curved {
            notes.push("curved triangles read as flat ones".into());
        }
        Ok(Model { unit_mm: filled.unit_mm, bodies, notes })
    }
}

/// Whether an object's vertices have places, and its triangles vertices.
fn check(object: &Object) -> Result<()> {
    let refused =
        |what: String| CoreError::Unreadable(format!("object '{}': {what}", shown(&object.id)));
    if let Some(number) = object.vertices.iter().position(|p| !p.is_finite()) {
        return Err(refused(format!("vertex {number} lacks a coordinate")));
    }
    let there = object.vertices.len();
    let mut faces = object.volumes.iter().flat_map(|volume| &volume.faces);
    match faces.find(|face| face.iter().any(|&v| v as usize >= there)) {
        Some(face) => {
            Err(refused(format!("a triangle names vertices {face:?}, but there are {there}")))
        }
        None => Ok(()),
    }
}

/// An element that is open, as far as it matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Open {
    Root,
    Object,
    Vertex,
    Volume,
    Triangle,
    Constellation,
    Instance,
    /// A coordinate, a corner, a shift or an angle: which of three.
    Coordinate(usize),
    Corner(usize),
    Delta(usize),
    Angle(usize),
    /// A slicer's word for what a volume is; whether it says that it changes settings.
    Kind,
    Modifier,
    Other,
}

#[derive(Default)]
struct Filling {
    is_amf: bool,
    unit_mm: f64,
    objects: Vec<Object>,
    constellations: Vec<Constellation>,
    curved: bool,
    open: Vec<Open>,
}

impl Handler for Filling {
    fn start(&mut self, element: &Element<'_>) -> Read<()> {
        let open = self.opened(element)?;
        self.open.push(open);
        Ok(())
    }

    fn text(&mut self, text: &str) -> Read<()> {
        let text = text.trim_ascii();
        let Some(&open) = self.open.last().filter(|_| !text.is_empty()) else { return Ok(()) };
        let object = self.objects.last_mut();
        match open {
            Open::Coordinate(axis) => {
                let value: f64 = parsed(text)?;
                if value.is_nan() || value.abs() > LARGEST {
                    return Err(format!("makes no sense: {value} is no sensible coordinate"));
                }
                if let Some(vertex) = object.and_then(|object| object.vertices.last_mut()) {
                    vertex[axis] = value;
                }
            }
            Open::Corner(corner) => {
                let volume = object.and_then(|object| object.volumes.last_mut());
                if let Some(face) = volume.and_then(|volume| volume.faces.last_mut()) {
                    face[corner] = parsed(text)?;
                }
            }
            Open::Delta(axis) | Open::Angle(axis) => {
                let value: f64 = parsed(text)?;
                if !value.is_finite() || value.abs() > LARGEST {
                    return Err(format!("makes no sense: {value} is no sensible number"));
                }
                let last = self.constellations.last_mut().and_then(|one| one.instances.last_mut());
                if let Some(instance) = last {
                    match open {
                        Open::Delta(_) => instance.delta[axis] = value,
                        _ => instance.rotate[axis] = value,
                    }
                }
            }
            Open::Kind => self.kind(purpose(text)),
            Open::Modifier if text == "1" => self.kind(Purpose::LeftOut),
            _ => {}
        }
        Ok(())
    }

    fn end(&mut self, _: &str, _: &str) {
        self.open.pop();
    }
}

impl Filling {
    /// What an element is that begins.
    fn opened(&mut self, element: &Element<'_>) -> Read<Open> {
        let outer = self.open.last().copied();
        let within = self.open.iter().rev().find(|&&open| open != Open::Other).copied();
        let index = |names: [&str; 3]| names.iter().position(|&name| name == element.name);
        Ok(match (element.name, within) {
            ("amf", None) if outer.is_none() => {
                self.is_amf = true;
                self.unit_mm = unit(element)?;
                Open::Root
            }
            ("object", Some(Open::Root)) => {
                let id = id(element, "id")?;
                self.objects.push(Object { id, vertices: Vec::new(), volumes: Vec::new() });
                Open::Object
            }
            ("vertex", Some(Open::Object)) => {
                self.objects.last_mut().ok_or("is in no object")?.vertices.push(MISSING);
                Open::Vertex
            }
            ("volume", Some(Open::Object)) => {
                let support = element.get("type").is_some_and(|text| text == "support");
                let purpose = if support { Purpose::LeftOut } else { Purpose::Part };
                let object = self.objects.last_mut().ok_or("is in no object")?;
                object.volumes.push(Volume { purpose, faces: Vec::new() });
                Open::Volume
            }
            ("triangle", Some(Open::Volume)) => {
                let volume = self.objects.last_mut().and_then(|object| object.volumes.last_mut());
                volume.ok_or("is in no volume")?.faces.push([u32::MAX; 3]);
                Open::Triangle
            }
            ("constellation", Some(Open::Root)) => {
                let id = id(element, "id")?;
                self.constellations.push(Constellation { id, instances: Vec::new() });
                Open::Constellation
            }
            ("instance", Some(Open::Constellation)) => {
                let id = id(element, "objectid")?;
                let constellation =
                    self.constellations.last_mut().ok_or("is in no constellation")?;
                let (delta, rotate) = (DVec3::ZERO, DVec3::ZERO);
                constellation.instances.push(Instance { id, delta, rotate });
                Open::Instance
            }
            ("edge" | "normal", Some(Open::Object | Open::Vertex)) => {
                self.curved = true;
                Open::Other
            }
            ("metadata", Some(Open::Volume)) => match element.get("type").as_deref() {
                Some("slic3r.volume_type") => Open::Kind,
                Some("slic3r.modifier") => Open::Modifier,
                _ => Open::Other,
            },
            (_, Some(Open::Vertex)) => index(["x", "y", "z"]).map_or(Open::Other, Open::Coordinate),
            (_, Some(Open::Triangle)) => {
                index(["v1", "v2", "v3"]).map_or(Open::Other, Open::Corner)
            }
            (_, Some(Open::Instance)) => match index(["deltax", "deltay", "deltaz"]) {
                Some(axis) => Open::Delta(axis),
                None => index(["rx", "ry", "rz"]).map_or(Open::Other, Open::Angle),
            },
            _ => Open::Other,
        })
    }

    fn kind(&mut self, purpose: Purpose) {
        if let Some(volume) = self.objects.last_mut().and_then(|object| object.volumes.last_mut()) {
            volume.purpose = purpose;
        }
    }
}

/// What a slicer's word means.
fn purpose(word: &str) -> Purpose {
    match word {
        "ModelPart" => Purpose::Part,
        "NegativeVolume" => Purpose::Negative,
        _ => Purpose::LeftOut,
    }
}

fn unit(element: &Element<'_>) -> Read<f64> {
    let Some(unit) = element.get("unit") else { return Ok(1.0) };
    let found = UNITS_MM.iter().find(|(name, _)| unit.eq_ignore_ascii_case(name));
    found.map(|&(_, mm)| mm).ok_or_else(|| format!("has the unknown unit '{}'", shown(&unit)))
}

fn id(element: &Element<'_>, name: &str) -> Read<String> {
    let id = element.get(name).ok_or_else(|| format!("has no attribute '{name}'"))?;
    if id.len() > MOST_ID {
        return Err(format!("makes no sense: its {name} has more than {MOST_ID} bytes"));
    }
    Ok(id.into_owned())
}

fn parsed<T: std::str::FromStr>(text: &str) -> Read<T> {
    text.parse().map_err(|_| format!("makes no sense: '{}' is no such number", shown(text)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(inner: &str) -> Result<Model> {
        let mut reader = AmfReader::default();
        let text = format!("<?xml version='1.0'?><amf unit='inch'>{inner}</amf>");
        for piece in text.as_bytes().chunks(7) {
            reader.feed(piece)?;
        }
        reader.finish()
    }

    fn object(volume: &str) -> String {
        let vertex = |x, y, z| {
            format!("<vertex><coordinates><x> {x} </x><y>{y}</y><z>{z}</z></coordinates></vertex>")
        };
        let vertices = vertex(0, 0, 0) + &vertex(1, 0, 0) + &vertex(0, 2, 3);
        let triangle = "<triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle>";
        format!(
            "<object id='1'><mesh><vertices>{vertices}</vertices>\
             <volume{volume}{triangle}</volume></mesh></object>"
        )
    }

    #[test]
    fn vertices_and_triangles_are_read_in_the_unit_of_the_file() {
        let model = read(&object(">")).unwrap();
        assert_eq!(model.unit_mm, 25.4);
        assert_eq!(model.bodies.len(), 1);
        assert_eq!(model.bodies[0].vertices[2], DVec3::new(0.0, 2.0, 3.0));
        assert_eq!(model.bodies[0].faces, [[0, 1, 2]]);
    }

    #[test]
    fn what_is_no_part_of_the_model_is_left_out_or_cut_out() {
        let kind = |word: &str| format!("><metadata type='slic3r.volume_type'>{word}</metadata>");
        let both = |other: &str| read(&(object(">") + &object(other).replace("id='1'", "id='2'")));
        let supports = both(" type='support'>").unwrap();
        assert_eq!((supports.bodies.len(), supports.notes.len()), (1, 1));
        let cut = both(&kind("NegativeVolume")).unwrap();
        assert_eq!(cut.bodies[1].purpose, Purpose::Negative);
        assert_eq!(both(&kind("ParameterModifier")).unwrap().bodies.len(), 1);
        assert_eq!(both(&kind("ModelPart")).unwrap().bodies.len(), 2);
        assert!(read(&object(&kind("SupportBlocker"))).is_err());
    }

    #[test]
    fn what_makes_no_sense_is_named() {
        let whole = object(">");
        for (wrong, what) in [
            (whole.replace("<v3>2</v3>", "<v3>7</v3>"), "[0, 1, 7], but there are 3"),
            (whole.replace("<v3>2</v3>", ""), "but there are 3"),
            (whole.replace("<x> 1 </x>", ""), "vertex 1 lacks a coordinate"),
            (whole.replace("<x> 1 </x>", "<x>a</x>"), "'a' is no such number"),
            (whole.replace("<x> 1 </x>", "<x>inf</x>"), "inf is no sensible coordinate"),
            (String::new(), "nothing is to be printed"),
        ] {
            let text = read(&wrong).unwrap_err().to_string();
            assert!(text.contains(what), "{text}");
        }
        let mut reader = AmfReader::default();
        reader.feed(b"<svg></svg>").unwrap();
        assert!(reader.finish().unwrap_err().to_string().contains("no AMF"));
    }
}
