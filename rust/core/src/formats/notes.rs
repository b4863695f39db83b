//! What a reader passed over or mended: each kind once, with its count and first place.

/// Kinds of deviation from a format, in the order in which they were first met.
#[derive(Debug, Default)]
pub struct Notes(Vec<Note>);

#[derive(Debug)]
struct Note {
    what: &'static str,
    count: u64,
    first: u64,
}

impl Notes {
    /// Adds one more of a kind; `place` is a line, or a byte that tells of one.
    pub fn add(&mut self, what: &'static str, place: u64) {
        self.add_many(what, 1, place);
    }

    /// Adds some more of a kind, the first of them at a place.
    pub fn add_many(&mut self, what: &'static str, count: u64, place: u64) {
        match self.0.iter_mut().find(|note| note.what == what) {
            Some(note) => note.count += count,
            None => self.0.push(Note { what, count, first: place }),
        }
    }

    /// Adds those of a later part of the file.
    pub fn append(&mut self, later: Self) {
        for note in later.0 {
            self.add_many(note.what, note.count, note.first);
        }
    }

    /// A sentence for each kind, given the words for a place.
    pub fn in_words(&self, place: impl Fn(u64) -> String) -> Vec<String> {
        let sentence = |note: &Note| match note.count {
            1 => format!("{} ({})", note.what, place(note.first)),
            count => format!("{}: {count} times, first in {}", note.what, place(note.first)),
        };
        self.0.iter().map(sentence).collect()
    }
}
