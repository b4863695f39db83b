//! Text with named places for numbers: how the core writes commands of dialects it does not know.

use super::fixed;
use crate::error::{CoreError, Result};

/// A text such as `G4 P{ms}`, split at its places.
#[derive(Debug, Clone, Default)]
pub struct Template {
    head: Vec<u8>,
    /// Index of the field, and the text that follows it.
    rest: Vec<(usize, Vec<u8>)>,
}

impl Template {
    /// Splits `text` at its `{field}`s, each of which must be one of `fields`.
    ///
    /// # Errors
    /// [`CoreError::Setting`] for a field that is not known or not closed.
    pub fn new(text: &str, fields: &[&str]) -> Result<Self> {
        let mut parts = text.split('{');
        let head = parts.next().unwrap_or_default().as_bytes().to_vec();
        let rest = parts.map(|part| Self::place(text, part, fields)).collect::<Result<_>>()?;
        Ok(Self { head, rest })
    }

    fn place(text: &str, part: &str, fields: &[&str]) -> Result<(usize, Vec<u8>)> {
        let wrong =
            || CoreError::Setting(format!("{text:?}: its fields are {}", fields.join(", ")));
        let (name, after) = part.split_once('}').ok_or_else(wrong)?;
        let field = fields.iter().position(|known| *known == name).ok_or_else(wrong)?;
        Ok((field, after.as_bytes().to_vec()))
    }

    /// Appends the text with `values` in its places: integers in units of 10^-`decimals`.
    pub fn write(&self, out: &mut Vec<u8>, values: &[i64], decimals: u32) {
        out.extend_from_slice(&self.head);
        for (field, after) in &self.rest {
            if let Some(value) = values.get(*field) {
                fixed::push(out, *value, decimals);
            }
            out.extend_from_slice(after);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(text: &str, values: &[i64], decimals: u32) -> String {
        let mut out = Vec::new();
        Template::new(text, &["z", "height"]).unwrap().write(&mut out, values, decimals);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn values_stand_in_their_places() {
        assert_eq!(
            written(";Z:{z}\n;HEIGHT:{height}\n", &[1500, 700], 3),
            ";Z:1.500\n;HEIGHT:0.700\n"
        );
        assert_eq!(written("{height}{z}{height}", &[1, 2], 0), "212");
        assert_eq!(written("plain", &[], 0), "plain");
    }

    #[test]
    fn an_unknown_or_open_field_is_refused() {
        for text in ["{x}", "{z", "G4 {}"] {
            let error = Template::new(text, &["z", "height"]).unwrap_err();
            assert!(error.to_string().contains("z, height"), "{error}");
        }
    }
}
