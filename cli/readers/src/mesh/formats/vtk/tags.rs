//! The marks of an XML file, as far as VTK's files have any: elements with attributes, and what stands between them.

use crate::error::{Fault, Place};

/// An element's mark, `<name attribute="value">`, `<name …/>` or `</name>`.
#[derive(Debug)]
pub struct Tag<'a> {
    /// Its name; with a slash before it where an element ends.
    pub name: &'a str,
    attributes: &'a str,
    /// Where it stands.
    pub place: Place,
    /// Where it ends, in bytes from the beginning.
    pub end: usize,
}

impl<'a> Tag<'a> {
    /// The value of an attribute.
    pub fn get(&self, name: &str) -> Option<&'a str> {
        let mut rest = self.attributes;
        loop {
            let (key, behind) = rest.split_once('=')?;
            let behind = behind.trim_start();
            let quote = behind.chars().next().filter(|c| *c == '"' || *c == '\'')?;
            let (value, next) = behind[1..].split_once(quote)?;
            if key.trim() == name {
                return Some(value);
            }
            rest = next;
        }
    }

    /// An attribute that must be there.
    pub fn expect(&self, name: &str) -> Result<&'a str, Fault> {
        let missing = || Fault::new(self.place, format!("{} without {name}", self.name));
        self.get(name).ok_or_else(missing)
    }

    /// An attribute that is a count or an offset.
    pub fn number(&self, name: &str) -> Result<usize, Fault> {
        let text = self.expect(name)?;
        let none = || Fault::new(self.place, format!("{name}=\"{text}\" is no number"));
        text.trim().parse().map_err(|_| none())
    }
}

/// The marks of a file, one after the other.
pub struct Tags<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u64,
}

impl<'a> Tags<'a> {
    /// From the beginning.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            at: 0,
            line: 1,
        }
    }

    fn to(&mut self, at: usize) {
        let passed = &self.bytes[self.at..at];
        self.line += passed.iter().filter(|b| **b == b'\n').count() as u64;
        self.at = at;
    }

    /// The next one, comments and declarations passed over.
    pub fn next_tag(&mut self) -> Result<Option<Tag<'a>>, Fault> {
        loop {
            let Some(start) = self.bytes[self.at..].iter().position(|b| *b == b'<') else {
                return Ok(None);
            };
            self.to(self.at + start);
            let place = Place::Line(self.line);
            let rest = &self.bytes[self.at..];
            let mark: &[u8] = if rest.starts_with(b"<!--") {
                b"-->"
            } else {
                b">"
            };
            let end = rest.windows(mark.len()).position(|w| w == mark);
            let Some(end) = end.map(|end| end + mark.len()) else {
                return Err(Fault::new(
                    place,
                    "a mark without an end: the file may be truncated",
                ));
            };
            let inside = &rest[1..end - 1];
            self.to(self.at + end);
            if matches!(inside.first(), Some(b'!' | b'?')) {
                continue;
            }
            let Ok(text) = std::str::from_utf8(inside) else {
                return Err(Fault::new(place, "bytes where a mark is expected"));
            };
            let text = text.trim_end_matches('/');
            // A slash at the beginning belongs to the name.
            let mut behind = text.char_indices().skip(1);
            let cut = behind.find(|(_, c)| c.is_whitespace() || *c == '/');
            let (name, attributes) = text.split_at(cut.map_or(text.len(), |(at, _)| at));
            return Ok(Some(Tag {
                name,
                attributes,
                place,
                end: self.at,
            }));
        }
    }

    /// What stands before the next mark.
    pub fn text(&self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|b| *b == b'<');
        &rest[..end.unwrap_or(rest.len())]
    }
}
