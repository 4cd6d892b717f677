//! The lines of a text file, one at a time, so that a file larger than memory's share is no burden.

use crate::{FormatError, disc};
use std::borrow::Cow;
use std::io::{BufRead, Read};
use std::path::Path;

/// The longest line, continuations included.
const MAX_LINE: u64 = 16 << 20;

/// Reads line by line. A backslash at the end of a line joins the next one to it.
pub struct Lines<'a, R> {
    source: R,
    path: &'a Path,
    line: Vec<u8>,
    read: usize,
    number: usize,
}

impl<'a, R: BufRead> Lines<'a, R> {
    /// Of a source; the path is for messages.
    pub fn new(source: R, path: &'a Path) -> Self {
        Self { source, path, line: Vec::new(), read: 0, number: 0 }
    }

    /// The number of the current line, counted from 1; of its first when several are joined.
    pub const fn number(&self) -> usize {
        self.number
    }

    /// The next line without its end, or None after the last. Bytes that are not UTF-8 are replaced.
    ///
    /// # Errors
    /// When the source fails, the line holds what no text holds, or it is too long.
    pub fn next(&mut self) -> Result<Option<Cow<'_, str>>, FormatError> {
        self.line.clear();
        self.number = self.read + 1;
        loop {
            let start = self.line.len();
            let mut rest = self.source.by_ref().take(MAX_LINE + 1 - start as u64);
            let count = rest.read_until(b'\n', &mut self.line).map_err(|e| disc::unreadable(self.path, e))?;
            self.read += 1;
            if count == 0 && start == 0 {
                return Ok(None);
            }
            self.check(start)?;
            let end = self.line.trim_ascii_end().len();
            self.line.truncate(end);
            // A backslash joins lines only where there is a further one.
            if count == 0 || self.line.last() != Some(&b'\\') {
                break;
            }
            self.line.pop();
            self.line.push(b' ');
        }
        if self.number == 1 && self.line.starts_with("\u{feff}".as_bytes()) {
            self.line.drain(..3);
        }
        Ok(Some(String::from_utf8_lossy(&self.line)))
    }

    fn check(&self, start: usize) -> Result<(), FormatError> {
        if self.line.len() as u64 > MAX_LINE {
            let reason = format!("longer than {} MB", MAX_LINE >> 20);
            return Err(self.fault(reason, "check that this is a text file"));
        }
        // Ctrl-Z ended files on DOS.
        let is_text = |b: &u8| *b >= b' ' || matches!(b, b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a);
        if self.line[start..].iter().all(is_text) {
            Ok(())
        } else {
            Err(self.fault("this is not text".into(), "export the model again as a text file"))
        }
    }

    /// An error at the current line.
    pub fn fault(&self, reason: String, help: impl Into<String>) -> FormatError {
        FormatError::ModelLine { path: self.path.into(), line: self.number, reason, help: help.into() }
    }
}

/// A finite number, or None.
pub fn number(word: &str) -> Option<f32> {
    word.parse().ok().filter(|v: &f32| v.is_finite())
}

/// A word from a file for a message, shortened when it is long.
pub fn quote(word: &str) -> String {
    const MAX: usize = 40;
    match word.char_indices().nth(MAX) {
        Some((end, _)) => format!("`{}…`", &word[..end]),
        None => format!("`{word}`"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(text: &[u8]) -> Result<Vec<(usize, String)>, FormatError> {
        let mut lines = Lines::new(text, Path::new("test"));
        let mut found = Vec::new();
        while let Some(line) = lines.next()?.map(Cow::into_owned) {
            found.push((lines.number(), line));
        }
        Ok(found)
    }

    #[test]
    fn ends_of_every_kind_and_continuations() {
        let lines = all(b"\xef\xbb\xbfone\r\ntwo \\\r\n 2\n\nfour\\").unwrap();
        let expected =
            [(1, "one"), (2, "two   2"), (4, ""), (5, "four")].map(|(n, line)| (n, line.to_owned()));
        assert_eq!(lines, expected);
    }

    #[test]
    fn binary_junk_and_endless_lines_are_refused() {
        assert!(all(b"v 0\0 0 0").unwrap_err().to_string().starts_with("line 1: this is not text"));
        let endless = vec![b'x'; (MAX_LINE + 2) as usize];
        assert!(all(&endless).unwrap_err().to_string().contains("longer than 16 MB"));
        let joined = b"xxxxxxx\\\n".repeat(3 << 20);
        assert!(all(&joined).unwrap_err().to_string().contains("longer than 16 MB"));
    }

    #[test]
    fn numbers_are_finite() {
        assert_eq!(number("-1.5e2"), Some(-150.0));
        for bad in ["nan", "inf", "1e39", "1,5", "", "0x10"] {
            assert_eq!(number(bad), None, "{bad}");
        }
    }

    #[test]
    fn long_words_are_shortened_between_characters() {
        assert_eq!(quote("ё"), "`ё`");
        assert_eq!(quote(&"ё".repeat(50)).chars().count(), 43);
    }
}
