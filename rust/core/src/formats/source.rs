//! A file that many threads read at once.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;

use crate::{CoreError, Result, memory};

/// Memory that a file takes which is read as a whole, what is made of it included, in its lengths.
const WHOLE: u64 = 8;

/// A file that is no device; each thread reads it through its own handle.
pub struct Source<'a> {
    path: &'a Path,
    /// Its length, bytes.
    pub len: u64,
}

impl<'a> Source<'a> {
    /// Opens a file.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] with its name where there is none, or nothing in it.
    pub fn open(path: &'a Path) -> Result<Self> {
        let refused = |e| CoreError::Unreadable(format!("{}: {e}", path.display()));
        let about = std::fs::metadata(path).map_err(refused)?;
        let source = Self { path, len: about.len() };
        if !about.is_file() {
            return Err(source.error("this is no regular file"));
        }
        if source.len == 0 {
            return Err(source.error("the file is empty"));
        }
        Ok(source)
    }

    /// An error about the file.
    pub fn error(&self, what: impl std::fmt::Display) -> CoreError {
        CoreError::Unreadable(format!("{}: {what}", self.path.display()))
    }

    /// Fills `buffer` with the bytes from `start` on, at most `count`, fewer at the file's end.
    ///
    /// # Errors
    /// [`CoreError::Unreadable`] where the system refuses.
    pub fn fill(&self, buffer: &mut Vec<u8>, start: u64, count: usize) -> Result<()> {
        buffer.clear();
        let mut read = || {
            let mut file = File::open(self.path)?;
            file.seek(SeekFrom::Start(start))?;
            file.take(count as u64).read_to_end(buffer)
        };
        read().map_err(|e| self.error(e))?;
        Ok(())
    }

    /// The bytes from `start` on, at most `count`.
    ///
    /// # Errors
    /// As [`Source::fill`].
    pub fn bytes(&self, start: u64, count: usize) -> Result<Vec<u8>> {
        let mut buffer = Vec::new();
        self.fill(&mut buffer, start, count)?;
        Ok(buffer)
    }

    /// All bytes.
    ///
    /// # Errors
    /// As [`Source::fill`]; [`CoreError::Memory`] where there are too many.
    pub fn whole(&self) -> Result<Vec<u8>> {
        memory::claim(WHOLE * self.len, || format!("{}, read as a whole,", self.path.display()))?;
        self.bytes(0, self.len as usize)
    }
}
