//! NumPy's archive of arrays (.npz): a zip file without compression of .npy files. Both are a few headers around the bytes.
//!
//! Source: numpy.lib.format (version 1.0 of .npy), PKWARE's APPNOTE (zip).

use std::io::{self, Write};

/// An array as it is in the file.
pub struct Array {
    /// The type of its entries, as NumPy spells it.
    kind: String,
    shape: Vec<usize>,
    bytes: Vec<u8>,
}

impl Array {
    /// A list of 64-bit floating point numbers.
    pub fn doubles(list: impl Iterator<Item = f64>) -> Self {
        Self::list("<f8", list.map(f64::to_le_bytes))
    }

    /// A list of 32-bit integers.
    pub fn ints(list: impl Iterator<Item = i32>) -> Self {
        Self::list("<i4", list.map(i32::to_le_bytes))
    }

    fn list<const B: usize>(kind: &str, list: impl Iterator<Item = [u8; B]>) -> Self {
        let mut bytes = Vec::new();
        for entry in list {
            bytes.extend_from_slice(&entry);
        }
        Self {
            kind: kind.into(),
            shape: vec![bytes.len() / B],
            bytes,
        }
    }

    /// A table of vertices, a simplex a row; where they are of several dimensions, rows end with −1.
    pub fn simplices<'a>(list: impl Iterator<Item = &'a [u32]> + Clone) -> Self {
        let width = list.clone().map(<[u32]>::len).max().unwrap_or(0);
        let row = |simplex: &'a [u32]| {
            let vertices = simplex.iter().map(|v| *v as i32);
            vertices.chain(std::iter::repeat(-1)).take(width)
        };
        let rows = list.clone().count();
        Self {
            shape: vec![rows, width],
            ..Self::ints(list.flat_map(row))
        }
    }

    /// A text, which NumPy has as an array without axes.
    pub fn text(text: &str) -> Self {
        let bytes = text.chars().flat_map(|c| u32::from(c).to_le_bytes());
        Self {
            kind: format!("<U{}", text.chars().count()),
            shape: Vec::new(),
            bytes: bytes.collect(),
        }
    }

    /// The head of its .npy file: a description in Python's syntax, filled up so that the data are aligned.
    fn head(&self) -> Vec<u8> {
        let axes: String = self.shape.iter().map(|n| format!("{n}, ")).collect();
        let mut text = format!(
            "{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}",
            self.kind,
            axes.trim_end()
        );
        const BEFORE: usize = 10;
        let length = (BEFORE + text.len() + 1).next_multiple_of(64) - BEFORE;
        text += &" ".repeat(length - 1 - text.len());
        text.push('\n');
        let mut head = b"\x93NUMPY\x01\x00".to_vec();
        head.extend((length as u16).to_le_bytes());
        head.extend(text.bytes());
        head
    }
}

/// Writes arrays with their names.
///
/// # Errors
/// Those of `out`, and a file beyond 4 GiB, which needs another kind of zip.
pub fn write(arrays: &[(String, Array)], out: &mut dyn Write) -> io::Result<()> {
    let (mut directory, mut offset) = (Vec::new(), 0u64);
    for (name, array) in arrays {
        let (name, head) = (format!("{name}.npy"), array.head());
        let size = (head.len() + array.bytes.len()) as u64;
        let about = entry(&name, crc(&[&head, &array.bytes]), small(size)?);
        directory.extend(b"PK\x01\x02\x14\x00");
        directory.extend(&about);
        // No comment, the first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(small(offset)?.to_le_bytes());
        directory.extend(name.bytes());
        out.write_all(b"PK\x03\x04")?;
        out.write_all(&about)?;
        out.write_all(name.as_bytes())?;
        out.write_all(&head)?;
        out.write_all(&array.bytes)?;
        offset += (4 + about.len() + name.len()) as u64 + size;
    }
    let count = (arrays.len() as u16).to_le_bytes();
    out.write_all(&directory)?;
    out.write_all(b"PK\x05\x06\0\0\0\0")?;
    out.write_all(&[count, count].concat())?;
    out.write_all(&(directory.len() as u32).to_le_bytes())?;
    out.write_all(&small(offset)?.to_le_bytes())?;
    out.write_all(&[0, 0])
}

/// What a file's own head and the directory say of it alike.
fn entry(name: &str, crc: u32, size: u32) -> Vec<u8> {
    // Version 2.0, no flags, no compression, midnight of the first of January 1980.
    let mut about = b"\x14\0\0\0\0\0\0\0\x21\0".to_vec();
    about.extend([crc, size, size].map(u32::to_le_bytes).concat());
    about.extend((name.len() as u16).to_le_bytes());
    about.extend([0, 0]);
    about
}

fn small(bytes: u64) -> io::Result<u32> {
    let too_large =
        |_| io::Error::other("an .npz file of more than 4 GiB is not written: use --json");
    u32::try_from(bytes).map_err(too_large)
}

/// The cyclic redundancy check of zip.
fn crc(parts: &[&[u8]]) -> u32 {
    const TABLES: [[u32; 256]; 8] = tables();
    let mut crc = u32::MAX;
    for part in parts {
        let mut eights = part.chunks_exact(8);
        for eight in &mut eights {
            let first = u32::from_le_bytes([eight[0], eight[1], eight[2], eight[3]]) ^ crc;
            let bytes = first
                .to_le_bytes()
                .into_iter()
                .chain(eight[4..].iter().copied());
            let pairs = bytes.zip(TABLES.iter().rev());
            crc = pairs.fold(0, |sum, (byte, table)| sum ^ table[byte as usize]);
        }
        for byte in eights.remainder() {
            crc = crc >> 8 ^ TABLES[0][(crc as u8 ^ byte) as usize];
        }
    }
    !crc
}

/// `tables()[k][byte]`: what a byte adds to the check when k bytes follow it.
const fn tables() -> [[u32; 256]; 8] {
    let mut tables = [[0; 256]; 8];
    let mut byte = 0;
    while byte < 256 {
        let (mut crc, mut bit) = (byte as u32, 0);
        while bit < 8 {
            crc = crc >> 1 ^ if crc & 1 == 1 { 0xedb8_8320 } else { 0 };
            bit += 1;
        }
        tables[0][byte] = crc;
        byte += 1;
    }
    let mut k = 1;
    while k < 8 {
        let mut byte = 0;
        while byte < 256 {
            let before = tables[k - 1][byte];
            tables[k][byte] = before >> 8 ^ tables[0][(before & 255) as usize];
            byte += 1;
        }
        k += 1;
    }
    tables
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source: the check value of CRC-32 in the catalogue of parametrised CRC algorithms.
    #[test]
    fn the_check_is_that_of_zip() {
        assert_eq!(crc(&[b"123456789"]), 0xcbf4_3926);
        assert_eq!(crc(&[b"1234", b"5", b"6789"]), 0xcbf4_3926);
        let long: Vec<u8> = (0..1000).map(|i| (i * 7) as u8).collect();
        assert_eq!(crc(&[&long]), crc(&[&long[..3], &long[3..]]));
    }

    #[test]
    fn heads_are_aligned_and_say_type_and_shape() {
        let rows: [&[u32]; 2] = [&[1, 2], &[3]];
        let array = Array::simplices(rows.into_iter());
        let head = array.head();
        assert_eq!(head.len() % 64, 0);
        let text = String::from_utf8_lossy(&head[10..]);
        assert!(text.starts_with("{'descr': '<i4', 'fortran_order': False, 'shape': (2, 2,), }"));
        assert_eq!(array.bytes[12..], (-1i32).to_le_bytes());
        assert!(String::from_utf8_lossy(&Array::text("é").head()).contains("'<U1'"));
    }
}
