//! Text in which lines mean something: their words, without comments, and what they spell.

use crate::error::{Fault, Place};

/// The lines of a text that are not empty.
pub struct Lines<'a> {
    bytes: &'a [u8],
    number: u64,
}

/// One line.
pub struct Line<'a> {
    /// Where it stands.
    pub place: Place,
    words: std::vec::IntoIter<&'a str>,
}

impl<'a> Lines<'a> {
    /// Of a file; what stands behind `#` is a comment, and a line that ends in a backslash goes on in the next.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, number: 0 }
    }

    /// The next raw line, without what ends it.
    fn raw(&mut self) -> Option<&'a [u8]> {
        if self.bytes.is_empty() {
            return None;
        }
        self.number += 1;
        let end = self.bytes.iter().position(|b| *b == b'\n');
        let line = &self.bytes[..end.unwrap_or(self.bytes.len())];
        self.bytes = &self.bytes[end.map_or(self.bytes.len(), |end| end + 1)..];
        Some(line)
    }

    /// The next line with a word in it.
    pub fn next_line(&mut self) -> Result<Option<Line<'a>>, Fault> {
        let mut words: Vec<&str> = Vec::with_capacity(8);
        let mut place = Place::Whole;
        while let Some(raw) = self.raw() {
            if words.is_empty() {
                place = Place::Line(self.number);
            }
            let raw = raw.split(|b| *b == b'#').next().unwrap_or(raw);
            let here = Place::Line(self.number);
            for word in raw.split(u8::is_ascii_whitespace).filter(|w| !w.is_empty()) {
                // Names may be in any encoding; numbers are ASCII.
                words.push(std::str::from_utf8(word).unwrap_or("?"));
            }
            if let Some(word) = words.last().and_then(|word| word.strip_suffix('\\')) {
                words.pop();
                words.extend(Some(word).filter(|word| !word.is_empty()));
            } else if !words.is_empty() {
                break;
            }
            if words.len() > 1 << 16 {
                return Err(Fault::new(here, "the line is too long"));
            }
        }
        let some = !words.is_empty();
        Ok(some.then(|| Line {
            place,
            words: words.into_iter(),
        }))
    }

    /// The next line, which must be there.
    pub fn expect_line(&mut self) -> Result<Line<'a>, Fault> {
        let end = Place::Line(self.number);
        self.next_line()?
            .ok_or_else(|| Fault::new(end, "the file ends too early: it may be truncated"))
    }
}

impl<'a> Line<'a> {
    /// The next word.
    pub fn word(&mut self) -> Option<&'a str> {
        self.words.next()
    }

    /// How many words are left.
    pub fn left(&self) -> usize {
        self.words.len()
    }

    /// A fault here.
    pub fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::new(self.place, reason)
    }

    /// What the next word spells.
    pub fn spelled<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, Fault> {
        let Some(word) = self.word() else {
            return Err(self.fault(format!("the line ends where {what} is expected")));
        };
        let short: String = word.chars().take(40).collect();
        word.parse()
            .map_err(|_| self.fault(format!("'{short}' where {what} is expected")))
    }

    /// Three coordinates.
    pub fn point(&mut self) -> Result<[f64; 3], Fault> {
        let mut x = [0.0; 3];
        for x in &mut x {
            *x = self.spelled::<f64>("a coordinate")?;
            if !x.is_finite() {
                return Err(self.fault(format!("a coordinate is {x}")));
            }
        }
        Ok(x)
    }
}
