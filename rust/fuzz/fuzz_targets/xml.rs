//! XML documents: whatever the pieces in which one comes, the same elements are read, or it is refused.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wireprint_core::xml::{Element, Handler, Reader};
use wireprint_fuzz::feed;

/// Everything that a handler is told.
#[derive(Default, Debug, PartialEq)]
struct Told(Vec<String>);

impl Handler for Told {
    fn start(&mut self, element: &Element<'_>) -> Result<(), String> {
        let of = ["id", "x", "path", "name"].map(|name| element.get(name));
        let foreign = element.get_in("urn:other", "id");
        let count = element.attributes();
        self.0.push(format!("<{} {} {count} {of:?} {foreign:?}", element.namespace, element.name));
        Ok(())
    }

    fn text(&mut self, text: &str) -> Result<(), String> {
        self.0.push(text.to_owned());
        Ok(())
    }

    fn end(&mut self, namespace: &str, name: &str) {
        self.0.push(format!("</{namespace} {name}"));
    }
}

fuzz_target!(|bytes: &[u8]| {
    let mut pieces = Reader::new(Told::default());
    let in_pieces = feed(bytes, |piece| pieces.feed(piece)).and_then(|()| pieces.finish());
    let mut whole = Reader::new(Told::default());
    let at_once = whole.feed(bytes.get(1..).unwrap_or_default()).and_then(|()| whole.finish());
    match (in_pieces, at_once) {
        (Ok(one), Ok(other)) => assert_eq!(one, other),
        (Err(_), Err(_)) => {}
        (one, other) => panic!("in pieces {one:?}, at once {other:?}"),
    }
});
