//! Namespaces: which prefix stands for which, in nested scopes.

use super::cursor::{Stop, shown};
use super::limits::MOST_BINDINGS;
use super::text::{plain, same};

const XML: &str = "http://www.w3.org/XML/1998/namespace";
const XMLNS: &str = "http://www.w3.org/2000/xmlns/";

/// The prefixes that are bound, inner ones last.
#[derive(Default)]
pub struct Spaces {
    /// Prefix (empty: of names without one) and namespace (empty: none).
    bindings: Vec<(String, String)>,
    /// Number of bindings outside each element.
    outside: Vec<usize>,
}

impl Spaces {
    /// Binds what an element's attributes declare.
    pub fn enter(&mut self, attributes: &[(&str, &str)]) -> Result<(), Stop> {
        self.outside.push(self.bindings.len());
        for (name, value) in attributes {
            let prefix = match name.strip_prefix("xmlns") {
                Some("") => "",
                Some(rest) if rest.starts_with(':') => &rest[1..],
                _ => continue,
            };
            let namespace = plain(value).into_owned();
            let reserved = [XML, XMLNS].contains(&namespace.as_str()) != (prefix == "xml")
                || prefix == "xml" && namespace != XML;
            let undone = namespace.is_empty() && name.len() > "xmlns".len();
            if reserved || undone || prefix == "xmlns" || prefix.contains(':') {
                let what = format!("{} cannot be declared so", shown(name));
                return Err(Stop::damage(&what));
            }
            self.bindings.push((prefix.to_string(), namespace));
        }
        if self.bindings.len() > MOST_BINDINGS {
            let what = format!("its XML binds more than {MOST_BINDINGS} prefixes");
            return Err(Stop::Fault(what));
        }
        Ok(())
    }

    /// Takes back what the innermost element has bound.
    pub fn leave(&mut self) {
        let outside = self.outside.pop().unwrap_or_default();
        self.bindings.truncate(outside);
    }

    /// The namespace that a prefix stands for; without a prefix it may be none, an empty one.
    pub fn of(&self, prefix: &str) -> Option<&str> {
        let bound = self.bindings.iter().rev().find(|(found, _)| same(found, prefix));
        let unbound = || match prefix {
            "" => Some(""),
            "xml" => Some(XML),
            _ => None,
        };
        bound.map(|(_, namespace)| namespace.as_str()).or_else(unbound)
    }

    /// Namespace and local name of an element's name.
    pub fn of_element<'a>(&'a self, name: &'a str) -> Result<(&'a str, &'a str), Stop> {
        let Some(colon) = name.bytes().position(|b| b == b':') else {
            return Ok((self.of("").unwrap_or_default(), name));
        };
        let (prefix, local) = (&name[..colon], &name[colon + 1..]);
        let namespace = self.of(prefix).filter(|_| is_local(local) && colon > 0);
        let unbound = || Stop::damage(&format!("{} has an unbound prefix", shown(name)));
        Ok((namespace.ok_or_else(unbound)?, local))
    }

    /// Refuses attributes of which two have one name, or one has a prefix that is not bound.
    pub fn check(&self, attributes: &[(&str, &str)]) -> Result<(), Stop> {
        let mut qualified = Vec::new();
        for (index, (name, _)) in attributes.iter().enumerate() {
            if attributes[..index].iter().any(|(other, _)| same(other, name)) {
                return Err(twice(name));
            }
            if name.bytes().any(|b| b == b':') && !name.starts_with("xmlns:") {
                let pair = self.of_element(name)?;
                if qualified.contains(&pair) {
                    return Err(twice(name));
                }
                qualified.push(pair);
            }
        }
        Ok(())
    }
}

/// Whether a name without its prefix is one.
fn is_local(name: &str) -> bool {
    let first = name.bytes().next();
    !name.contains(':') && first.is_some_and(|b| !matches!(b, b'0'..=b'9' | b'-' | b'.'))
}

fn twice(name: &str) -> Stop {
    Stop::damage(&format!("a tag has two attributes {}", shown(name)))
}
