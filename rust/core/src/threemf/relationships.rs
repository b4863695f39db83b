//! The package's relationships: which part is what.

use super::values::{Read, kept, required};
use crate::Result;
use crate::xml::{Element, Handler, Reader};

/// Namespace of the relationships of the Open Packaging Conventions.
const PACKAGE: &str = "http://schemas.openxmlformats.org/package/2006/relationships";

/// Reads a relationships part piece by piece.
pub struct RelationshipReader(Reader<Search>);

impl RelationshipReader {
    /// Looks for the first relationship of a type, a URI.
    #[must_use]
    pub fn new(kind: &str) -> Self {
        Self(Reader::new(Search { kind: kind.into(), found: None }))
    }

    /// Takes in the next piece.
    ///
    /// # Errors
    /// As [`Reader::feed`]; also where a relationship has no type or no target.
    pub fn feed(&mut self, bytes: &[u8]) -> Result<()> {
        self.0.feed(bytes)
    }

    /// Ends the part and returns the name of the part that was looked for.
    ///
    /// # Errors
    /// As [`Reader::finish`].
    pub fn finish(self) -> Result<Option<String>> {
        Ok(self.0.finish()?.found)
    }
}

struct Search {
    kind: String,
    found: Option<String>,
}

impl Handler for Search {
    fn start(&mut self, element: &Element<'_>) -> Read<()> {
        if (element.namespace, element.name) != (PACKAGE, "Relationship") {
            return Ok(());
        }
        let (kind, target) = (required(element, "Type")?, required(element, "Target")?);
        if self.found.is_none() && kind == self.kind {
            self.found = Some(kept(target)?);
        }
        Ok(())
    }

    fn end(&mut self, _: &str, _: &str) {}
}
