//! A place in a file, from which lines, numbers and bytes are read.

use crate::error::{Fault, Place};

/// How the numbers of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// As text.
    Ascii,
    /// As bytes, the least significant first or last.
    Binary {
        /// The most significant first?
        big_endian: bool,
    },
}

/// What is left of a file. Every read fails where the file ends.
pub struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u64,
    /// How numbers are written.
    pub encoding: Encoding,
    /// What begins a comment, which ends with its line.
    pub comment: Option<u8>,
}

impl<'a> Cursor<'a> {
    /// The beginning of a file; text until told otherwise.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            at: 0,
            line: 1,
            encoding: Encoding::Ascii,
            comment: None,
        }
    }

    /// Where we are.
    pub fn place(&self) -> Place {
        match self.encoding {
            Encoding::Ascii => Place::Line(self.line),
            Encoding::Binary { .. } => Place::Byte(self.at as u64),
        }
    }

    /// A fault here.
    pub fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::new(self.place(), reason)
    }

    /// Nothing left but white space and comments?
    pub fn is_at_end(&mut self) -> bool {
        let start = (self.at, self.line);
        self.skip_space();
        let end = self.at == self.bytes.len();
        (self.at, self.line) = start;
        end
    }

    /// How many bytes are left: no more things than that can follow.
    pub fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn skip_space(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if Some(byte) == self.comment {
                self.finish_line();
            } else if byte.is_ascii_whitespace() {
                self.line += u64::from(byte == b'\n');
                self.at += 1;
            } else {
                break;
            }
        }
    }

    /// Passes over so many bytes, or all that are left.
    pub fn skip(&mut self, bytes: usize) {
        self.at = (self.at + bytes).min(self.bytes.len());
    }

    /// The place of the next number or word.
    pub fn aligned(&mut self) -> Place {
        self.align();
        self.place()
    }

    /// To the next number, so that its line is known; bytes are where they are.
    pub fn align(&mut self) {
        if self.encoding == Encoding::Ascii {
            self.skip_space();
        }
    }

    /// Behind the next occurrence of a mark, if there is one.
    pub fn skip_past(&mut self, mark: &[u8]) -> bool {
        let rest = &self.bytes[self.at..];
        let Some(found) = rest.windows(mark.len()).position(|w| w == mark) else {
            return false;
        };
        let passed = &rest[..found + mark.len()];
        self.line += passed.iter().filter(|b| **b == b'\n').count() as u64;
        self.at += passed.len();
        true
    }

    /// The next word, whatever the encoding.
    pub fn word(&mut self) -> Result<&'a str, Fault> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(u8::is_ascii_whitespace);
        let word = &rest[..end.unwrap_or(rest.len())];
        if word.is_empty() {
            return Err(self.fault("the file ends too early: it may be truncated"));
        }
        let word = std::str::from_utf8(&word[..word.len().min(64)])
            .map_err(|_| self.fault("bytes where text is expected"))?;
        self.at += end.unwrap_or(rest.len());
        Ok(word)
    }

    /// Nothing but spaces left on this line?
    pub fn is_line_empty(&self) -> bool {
        let mut rest = self.bytes[self.at..].iter().take_while(|b| **b != b'\n');
        self.at == self.bytes.len() || rest.all(u8::is_ascii_whitespace)
    }

    /// The next word, which is read again.
    pub fn peek(&mut self) -> Result<&'a str, Fault> {
        let start = (self.at, self.line);
        let word = self.word();
        if word.is_ok() {
            (self.at, self.line) = start;
        }
        word
    }

    /// This word, in small or large letters.
    pub fn keyword(&mut self, word: &str) -> Result<(), Fault> {
        let (place, found) = (self.aligned(), self.word()?);
        match found.eq_ignore_ascii_case(word) {
            true => Ok(()),
            false => {
                let reason = format!("'{found}' where {word} is expected");
                Err(Fault::new(place, reason))
            }
        }
    }

    /// The end of a line behind its last word, as it may be written: what follows may be bytes.
    pub fn end_line(&mut self) {
        while matches!(self.bytes.get(self.at), Some(b' ' | b'\t')) {
            self.at += 1;
        }
        if self.bytes.get(self.at) == Some(&b'\r') {
            self.at += 1;
        }
        if self.bytes.get(self.at) == Some(&b'\n') {
            self.at += 1;
            self.line += 1;
        }
    }

    /// What is left of this line, its end included.
    pub fn finish_line(&mut self) {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|b| *b == b'\n');
        self.line += u64::from(end.is_some());
        self.at += end.map_or(rest.len(), |end| end + 1);
    }

    /// The number that the next word spells.
    pub fn spelled<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, Fault> {
        self.skip_space();
        let (place, word) = (self.place(), self.word()?);
        let reason = || format!("'{word}' where {what} is expected");
        word.parse().map_err(|_| Fault::new(place, reason()))
    }

    /// Text in double quotes, the last thing on its line: quotes inside it are written as they are.
    pub fn quoted(&mut self) -> Result<String, Fault> {
        self.skip_space();
        let rest = &self.bytes[self.at..];
        let line = rest.split(|b| *b == b'\n').next();
        let line = line.expect("`split` gives one part at the least");
        let inside = line.strip_prefix(b"\"");
        let closed = inside.and_then(|text| Some((text, text.iter().rposition(|b| *b == b'"')?)));
        let Some((inside, end)) = closed else {
            return Err(self.fault("a name in double quotes is expected"));
        };
        self.at += end + 2;
        Ok(String::from_utf8_lossy(&inside[..end]).into_owned())
    }

    fn raw<const B: usize>(&mut self) -> Result<[u8; B], Fault> {
        let bytes = self.bytes.get(self.at..self.at + B);
        let Some(bytes) = bytes.and_then(|bytes| bytes.try_into().ok()) else {
            return Err(self.fault("the file ends too early: it may be truncated"));
        };
        self.at += B;
        Ok(bytes)
    }

    /// A 32-bit integer.
    pub fn int(&mut self, what: &str) -> Result<i32, Fault> {
        match self.encoding {
            Encoding::Ascii => self.spelled(what),
            Encoding::Binary { big_endian: true } => Ok(i32::from_be_bytes(self.raw()?)),
            Encoding::Binary { .. } => Ok(i32::from_le_bytes(self.raw()?)),
        }
    }

    /// A 64-bit count or tag.
    pub fn size(&mut self, what: &str) -> Result<u64, Fault> {
        match self.encoding {
            Encoding::Ascii => self.spelled(what),
            Encoding::Binary { big_endian: true } => Ok(u64::from_be_bytes(self.raw()?)),
            Encoding::Binary { .. } => Ok(u64::from_le_bytes(self.raw()?)),
        }
    }

    /// A byte.
    pub fn byte(&mut self) -> Result<u8, Fault> {
        Ok(self.raw::<1>()?[0])
    }

    /// 16 bits.
    pub fn short(&mut self) -> Result<u16, Fault> {
        match self.encoding {
            Encoding::Binary { big_endian: true } => Ok(u16::from_be_bytes(self.raw()?)),
            _ => Ok(u16::from_le_bytes(self.raw()?)),
        }
    }

    /// A number in single precision, whatever it is.
    pub fn any_single(&mut self) -> Result<f64, Fault> {
        let bits = match self.encoding {
            Encoding::Binary { big_endian: true } => u32::from_be_bytes(self.raw()?),
            _ => u32::from_le_bytes(self.raw()?),
        };
        Ok(f64::from(f32::from_bits(bits)))
    }

    /// A coordinate in single precision: a finite number.
    pub fn single(&mut self) -> Result<f64, Fault> {
        let place = self.place();
        let value = self.any_single()?;
        match value.is_finite() {
            true => Ok(value),
            false => Err(Fault::new(place, format!("a coordinate is {value}"))),
        }
    }

    /// A coordinate: a finite number.
    pub fn coordinate(&mut self) -> Result<f64, Fault> {
        let place = self.place();
        let value = match self.encoding {
            Encoding::Ascii => self.spelled("a coordinate")?,
            Encoding::Binary { big_endian: true } => f64::from_be_bytes(self.raw()?),
            Encoding::Binary { .. } => f64::from_le_bytes(self.raw()?),
        };
        match f64::is_finite(value) {
            true => Ok(value),
            false => {
                let place = if self.encoding == Encoding::Ascii {
                    self.place()
                } else {
                    place
                };
                Err(Fault::new(place, format!("a coordinate is {value}")))
            }
        }
    }

    /// A count of things that take a byte each at the least; more than are left cannot follow.
    pub fn count(&mut self, what: &str) -> Result<usize, Fault> {
        let place = self.place();
        let count = self.size(what)?;
        match usize::try_from(count)
            .ok()
            .filter(|count| *count <= self.left())
        {
            Some(count) => Ok(count),
            None => Err(Fault::new(
                place,
                format!("{what} is {count}, more than the file can hold"),
            )),
        }
    }
}
