//! What slicers write beside a model: which triangles or objects are no part of it, and which
//! plates there are.
//!
//! `PrusaSlicer` and its kin keep `Metadata/Slic3r_PE_model.config`, where a volume is a range of an
//! object's triangles; `Bambu Studio` and `OrcaSlicer` keep `Metadata/model_settings.config`, where a
//! part is a component of an object. Both have the same form.

use std::borrow::Cow;

use super::values::{Read, count, kept, number, parsed, required};
use crate::Result;
use crate::xml::{Element, Handler, Reader};

/// What `PrusaSlicer` calls what is printed, and what changes settings within it.
const PART: &str = "ModelPart";
const MODIFIER: &str = "ParameterModifier";
/// Most objects, volumes, plates and instances, each.
const MOST: usize = 1 << 16;

/// What a volume is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Whereof {
    /// These triangles of the object, the first one and the last one.
    Triangles(u32, u32),
    /// The component that places the object of this identifier.
    Component(String),
}

/// A part of an object that has a kind of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Volume {
    /// What it is.
    pub whereof: Whereof,
    /// In the slicer's word, such as `ModelPart` or `normal_part`.
    pub kind: String,
    /// What people call it; may be empty.
    pub name: String,
}

/// An object with its volumes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Described {
    /// The object's identifier in the model.
    pub id: String,
    /// What people call it; may be empty.
    pub name: String,
    /// In the order of the file.
    pub volumes: Vec<Volume>,
}

/// What is printed together.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Plate {
    /// Counted from 1.
    pub number: u32,
    /// What people call it; may be empty.
    pub name: String,
    /// The identifiers of objects, and which of the items that place one it is, counted from 0.
    pub instances: Vec<(String, u32)>,
}

/// All that a slicer says.
#[derive(Debug, Default)]
pub struct Config {
    /// In the order of the file.
    pub objects: Vec<Described>,
    /// In the order of the file.
    pub plates: Vec<Plate>,
}

/// Reads such a part piece by piece.
pub struct ConfigReader(Reader<ConfigDraft>);

impl Default for ConfigReader {
    fn default() -> Self {
        Self(Reader::new(ConfigDraft::default()))
    }
}

impl ConfigReader {
    /// Takes in the next piece.
    ///
    /// # Errors
    /// As [`Reader::feed`]; also where numbers or names make no sense, and where there is too much of
    /// something.
    pub fn feed(&mut self, bytes: &[u8]) -> Result<()> {
        self.0.feed(bytes)
    }

    /// Ends the part.
    ///
    /// # Errors
    /// As [`Reader::finish`].
    pub fn finish(self) -> Result<Config> {
        Ok(self.0.finish()?.config)
    }
}

/// What the innermost element is of which metadata tells.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Object,
    Volume,
    Plate,
    Instance,
}

/// A configuration that is being filled.
#[derive(Default)]
struct ConfigDraft {
    config: Config,
    open: Vec<Option<Of>>,
    things: usize,
}

impl Handler for ConfigDraft {
    fn start(&mut self, element: &Element<'_>) -> Read<()> {
        let outer = self.open.last().copied().flatten();
        let of = match (element.name, outer) {
            ("object", None) if self.open.len() == 1 => {
                let id = kept(required(element, "id")?)?;
                let described = Described { id, name: String::new(), volumes: Vec::new() };
                self.config.objects.push(described);
                Some(Of::Object)
            }
            ("volume", Some(Of::Object)) => {
                let (first, last) = (number(element, "firstid")?, number(element, "lastid")?);
                self.volume(Whereof::Triangles(first, last), PART.into());
                Some(Of::Volume)
            }
            ("part", Some(Of::Object)) => {
                let id = kept(required(element, "id")?)?;
                let kind = element.get("subtype").unwrap_or("normal_part".into());
                self.volume(Whereof::Component(id), kept(kind)?);
                Some(Of::Volume)
            }
            ("plate", None) if self.open.len() == 1 => {
                let number = self.config.plates.len() as u32 + 1;
                self.config.plates.push(Plate { number, ..Plate::default() });
                Some(Of::Plate)
            }
            ("model_instance", Some(Of::Plate)) => {
                if let Some(plate) = self.config.plates.last_mut() {
                    plate.instances.push((String::new(), 0));
                }
                Some(Of::Instance)
            }
            _ => None,
        };
        if of.is_some() {
            count(&mut self.things, 1, MOST, "objects, volumes, plates and instances")?;
        }
        let said = element.get("key").zip(element.get("value"));
        if let ("metadata", Some(of), Some((key, value))) = (element.name, outer, said) {
            self.metadata(of, &key, value)?;
        }
        self.open.push(of);
        Ok(())
    }

    fn end(&mut self, _: &str, _: &str) {
        self.open.pop();
    }
}

impl ConfigDraft {
    fn volume(&mut self, whereof: Whereof, kind: String) {
        if let Some(object) = self.config.objects.last_mut() {
            object.volumes.push(Volume { whereof, kind, name: String::new() });
        }
    }

    fn metadata(&mut self, of: Of, key: &str, value: Cow<'_, str>) -> Read<()> {
        let (object, plate) = (self.config.objects.last_mut(), self.config.plates.last_mut());
        let taken = match of {
            Of::Object => object.map(|object| object.take(key, value)),
            Of::Volume => object.and_then(|o| o.volumes.last_mut()).map(|v| v.take(key, value)),
            Of::Plate => plate.map(|plate| plate.take(key, value)),
            Of::Instance => plate.map(|plate| plate.take_instance(key, value)),
        };
        taken.unwrap_or(Ok(()))
    }
}

impl Described {
    fn take(&mut self, key: &str, value: Cow<'_, str>) -> Read<()> {
        if key == "name" {
            self.name = kept(value)?;
        }
        Ok(())
    }
}

impl Volume {
    fn take(&mut self, key: &str, value: Cow<'_, str>) -> Read<()> {
        match key {
            "name" => self.name = kept(value)?,
            "volume_type" => self.kind = kept(value)?,
            // What old versions write alone; newer ones write the type, before or behind it.
            "modifier" if value == "1" && self.kind == PART => self.kind = MODIFIER.into(),
            _ => {}
        }
        Ok(())
    }
}

impl Plate {
    fn take(&mut self, key: &str, value: Cow<'_, str>) -> Read<()> {
        match key {
            "plater_id" => self.number = parsed(value.trim_ascii())?,
            "plater_name" => self.name = kept(value)?,
            _ => {}
        }
        Ok(())
    }

    fn take_instance(&mut self, key: &str, value: Cow<'_, str>) -> Read<()> {
        let Some((id, number)) = self.instances.last_mut() else { return Ok(()) };
        match key {
            "object_id" => *id = kept(value)?,
            "instance_id" => *number = parsed(value.trim_ascii())?,
            _ => {}
        }
        Ok(())
    }
}
