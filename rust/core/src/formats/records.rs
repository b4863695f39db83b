//! Records of words: one a line, or across lines where there are too few for that.

use super::text::{Lines, Read, uncommented, words};

/// Records of a text, one after another.
pub struct Records<'a> {
    lines: Lines<'a>,
    /// What is left of the last line.
    line: &'a [u8],
    /// Whether each record has a line of its own.
    lined: bool,
    /// Whether `#` begins a comment.
    comments: bool,
}

impl<'a> Records<'a> {
    /// What follows some lines of a text, whose words may stand on any line at first.
    pub fn new(lines: Lines<'a>, comments: bool) -> Self {
        Self { lines, line: &[], lined: false, comments }
    }

    /// Tells how many records follow: each has a line of its own if there are as many lines.
    pub fn expect(&mut self, records: u64) {
        let rest = Lines::new(self.lines.rest());
        let filled = rest.filter(|line| words(self.plain(line)).next().is_some());
        let enough = usize::try_from(records).is_ok_and(|n| filled.take(n).count() == n);
        self.lined = enough && words(self.line).next().is_none();
    }

    /// Whether each record has a line of its own.
    pub fn lined(&self) -> bool {
        self.lined
    }

    /// Number of the line that was read last.
    pub fn at(&self) -> u64 {
        self.lines.number
    }

    /// Begins the next record.
    ///
    /// # Errors
    /// There is none.
    pub fn begin(&mut self) -> Read<()> {
        if self.lined { self.next_line() } else { Ok(()) }
    }

    /// The next word of the record.
    ///
    /// # Errors
    /// There is none.
    pub fn word(&mut self) -> Read<&'a [u8]> {
        loop {
            if let Some(word) = self.try_word() {
                return Ok(word);
            }
            if self.lined {
                return Err("a number is missing".into());
            }
            self.next_line()?;
        }
    }

    /// The next word on the line.
    pub fn try_word(&mut self) -> Option<&'a [u8]> {
        let begin = self.line.iter().position(|b| !b.is_ascii_whitespace())?;
        let rest = &self.line[begin..];
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let (word, rest) = rest.split_at(end);
        self.line = rest;
        Some(word)
    }

    /// Whether words follow the last record.
    pub fn any_left(&mut self) -> bool {
        !self.lined && self.try_word().is_some() || self.next_line().is_ok()
    }

    /// Goes to the next line that has words.
    fn next_line(&mut self) -> Read<()> {
        while let Some(line) = self.lines.next() {
            self.line = self.plain(line);
            if words(self.line).next().is_some() {
                return Ok(());
            }
        }
        Err("the file ends early".into())
    }

    fn plain<'b>(&self, line: &'b [u8]) -> &'b [u8] {
        if self.comments { uncommented(line) } else { line }
    }
}
