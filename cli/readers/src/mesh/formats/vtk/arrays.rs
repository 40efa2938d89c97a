//! The numbers of a DataArray: text, or bytes in the file or behind it, in base 64 or as they are, compressed or not.

use super::tags::Tag;
use crate::error::{Fault, Place};

/// How the arrays of a file are stored.
pub struct Storage<'a> {
    /// The most significant byte first?
    pub big_endian: bool,
    /// Are counts of bytes 8 bytes long?
    pub long: bool,
    /// By zlib?
    pub compressed: bool,
    /// What stands behind the marks, with whether it is in base 64.
    pub appended: Option<(&'a [u8], bool)>,
    /// More numbers than this no array of a mesh in a file of this size has: a few bytes may be said to be billions of zeros.
    pub most: usize,
}

/// The numbers of an array, as f64: whole ones too, which are exact up to 2^53.
pub fn numbers(tag: &Tag<'_>, text: &[u8], storage: &Storage<'_>) -> Result<Vec<f64>, Fault> {
    let refuse = |reason: &str| Err(Fault::new(tag.place, reason));
    let bytes = match tag.expect("format")? {
        "ascii" => return ascii(tag.place, text),
        "binary" => Stored::Owned(base64(tag.place, text)?),
        "appended" => {
            let offset = tag.number("offset")?;
            let Some((all, coded)) = storage.appended else {
                return refuse("the file has no AppendedData: it may be truncated");
            };
            let Some(rest) = all.get(offset..) else {
                return refuse("the array begins behind the end of the file: it may be truncated");
            };
            match coded {
                true => Stored::Owned(base64(tag.place, rest)?),
                false => Stored::Borrowed(rest),
            }
        }
        other => {
            return refuse(&format!(
                "format=\"{other}\": ascii, binary and appended are known"
            ));
        }
    };
    let bytes = match &bytes {
        Stored::Owned(bytes) => bytes,
        Stored::Borrowed(bytes) => *bytes,
    };
    let (width, of) = kind(tag)?;
    let data = storage.data(tag.place, bytes, width)?;
    let number = |chunk: &[u8]| {
        let mut word = [0; 8];
        word[..width].copy_from_slice(chunk);
        if storage.big_endian {
            word[..width].reverse();
        }
        of(word)
    };
    Ok(data.chunks_exact(width).map(number).collect())
}

enum Stored<'a> {
    Owned(Vec<u8>),
    Borrowed(&'a [u8]),
}

fn ascii(place: Place, text: &[u8]) -> Result<Vec<f64>, Fault> {
    let words = text
        .split(u8::is_ascii_whitespace)
        .filter(|w| !w.is_empty());
    let number = |word: &[u8]| {
        let text = std::str::from_utf8(&word[..word.len().min(64)]).unwrap_or("?");
        let none = || Fault::new(place, format!("'{text}' where a number is expected"));
        text.parse().map_err(|_| none())
    };
    words.map(number).collect()
}

/// Base 64, which may end and begin anew in the middle.
fn base64(place: Place, text: &[u8]) -> Result<Vec<u8>, Fault> {
    let digit = |byte: u8| match byte {
        b'A'..=b'Z' => Some(byte - b'A'),
        b'a'..=b'z' => Some(byte - b'a' + 26),
        b'0'..=b'9' => Some(byte - b'0' + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    };
    let mut out = Vec::with_capacity(text.len() / 4 * 3);
    let (mut word, mut count) = (0u32, 0);
    for &byte in text {
        match (digit(byte), byte) {
            (Some(digit), _) => {
                word = word << 6 | u32::from(digit);
                count += 1;
                if count == 4 {
                    out.extend_from_slice(&word.to_be_bytes()[1..]);
                    (word, count) = (0, 0);
                }
            }
            // The end of a part that is no multiple of three bytes; the second of two such marks finds nothing left.
            (None, b'=') => {
                if count > 1 {
                    let bytes = (word << (6 * (4 - count))).to_be_bytes();
                    out.extend_from_slice(&bytes[1..count]);
                }
                (word, count) = (0, 0);
            }
            (None, byte) if byte.is_ascii_whitespace() => {}
            // The end of AppendedData.
            (None, b'<') => break,
            _ => {
                return Err(Fault::new(
                    place,
                    "an array in base 64 with other characters",
                ));
            }
        }
    }
    Ok(out)
}

impl Storage<'_> {
    /// A count of bytes or blocks, and what follows it.
    fn count<'b>(&self, place: Place, bytes: &'b [u8]) -> Result<(usize, &'b [u8]), Fault> {
        let width = if self.long { 8 } else { 4 };
        let Some((head, rest)) = bytes.split_at_checked(width) else {
            return Err(short(place));
        };
        let count = head.iter().enumerate().fold(0u64, |sum, (i, byte)| {
            let place = if self.big_endian { width - 1 - i } else { i };
            sum | u64::from(*byte) << (8 * place)
        });
        Ok((usize::try_from(count).unwrap_or(usize::MAX), rest))
    }

    /// The bytes of an array that begins here, of numbers that take so many.
    fn data(&self, place: Place, bytes: &[u8], width: usize) -> Result<Vec<u8>, Fault> {
        let (count, mut rest) = self.count(place, bytes)?;
        if !self.compressed {
            return rest
                .get(..count)
                .map(<[u8]>::to_vec)
                .ok_or_else(|| short(place));
        }
        // The number of blocks, the size of each and of the last; then what they take compressed.
        let (size, behind) = self.count(place, rest)?;
        let (_, behind) = self.count(place, behind)?;
        rest = behind;
        if count > rest.len() {
            return Err(short(place));
        }
        let mut sizes = Vec::with_capacity(count);
        for _ in 0..count {
            let (compressed, behind) = self.count(place, rest)?;
            sizes.push(compressed);
            rest = behind;
        }
        let mut all = Vec::new();
        for compressed in sizes {
            let Some((block, behind)) = rest.split_at_checked(compressed) else {
                return Err(short(place));
            };
            let room = size.min(self.most * width - all.len());
            let opened = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(block, room);
            let reason = "a compressed array that is broken, or too long for a file of this size";
            all.extend(opened.map_err(|_| Fault::new(place, reason))?);
            rest = behind;
        }
        Ok(all)
    }
}

fn short(place: Place) -> Fault {
    Fault::new(place, "an array ends too early: the file may be truncated")
}

/// How many bytes a number of the array's type takes, and what they are.
fn kind(tag: &Tag<'_>) -> Result<(usize, fn([u8; 8]) -> f64), Fault> {
    Ok(match tag.expect("type")? {
        "Float64" => (8, f64::from_le_bytes),
        "Float32" => (4, |b| {
            f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        }),
        "Int64" => (8, |b| i64::from_le_bytes(b) as f64),
        "UInt64" => (8, |b| u64::from_le_bytes(b) as f64),
        "Int32" => (4, |b| {
            f64::from(i32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        }),
        "UInt32" => (4, |b| {
            f64::from(u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
        }),
        "Int16" => (2, |b| f64::from(i16::from_le_bytes([b[0], b[1]]))),
        "UInt16" => (2, |b| f64::from(u16::from_le_bytes([b[0], b[1]]))),
        "Int8" => (1, |b| f64::from(b[0] as i8)),
        "UInt8" => (1, |b| f64::from(b[0])),
        other => return Err(Fault::new(tag.place, format!("numbers of type {other}"))),
    })
}
