//! The header of a PLY file: which elements follow, how many, with which properties.

use super::super::super::cursor::{Cursor, Encoding};
use crate::error::{Fault, Place};

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// The names of the kinds, old and new.
const KINDS: [(&str, Number); 16] = [
    ("char", Number::I8),
    ("int8", Number::I8),
    ("uchar", Number::U8),
    ("uint8", Number::U8),
    ("short", Number::I16),
    ("int16", Number::I16),
    ("ushort", Number::U16),
    ("uint16", Number::U16),
    ("int", Number::I32),
    ("int32", Number::I32),
    ("uint", Number::U32),
    ("uint32", Number::U32),
    ("float", Number::F32),
    ("float32", Number::F32),
    ("double", Number::F64),
    ("float64", Number::F64),
];

/// What a property is made of.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// One number.
    One(Number),
    /// A count and so many numbers.
    List(Number, Number),
}

/// One property of an element.
#[derive(Debug)]
pub struct Property {
    /// Its name.
    pub name: String,
    /// What it is made of.
    pub kind: Kind,
}

/// One kind of element.
#[derive(Debug)]
pub struct Element {
    /// Its name.
    pub name: String,
    /// How many there are.
    pub count: usize,
    /// The properties of each.
    pub properties: Vec<Property>,
    /// Where it is announced.
    pub place: Place,
}

/// Reads up to the end of the header, and sets how the cursor reads from there on.
pub fn read(cursor: &mut Cursor<'_>) -> Result<Vec<Element>, Fault> {
    cursor.keyword("ply")?;
    let (mut elements, mut encoding) = (Vec::<Element>::new(), None);
    loop {
        let place = cursor.aligned();
        match cursor.word()? {
            "comment" | "obj_info" => cursor.finish_line(),
            "format" => encoding = Some(format(cursor)?),
            "element" => {
                let name = cursor.word()?.to_owned();
                elements.push(Element {
                    name,
                    count: cursor.spelled("a number of elements")?,
                    properties: Vec::new(),
                    place,
                });
            }
            "property" => {
                let property = property(cursor)?;
                let Some(element) = elements.last_mut() else {
                    return Err(Fault::new(place, "a property before any element"));
                };
                element.properties.push(property);
            }
            "end_header" => break,
            other => {
                let reason = format!("'{other}' in the header of a PLY file");
                return Err(Fault::new(place, reason));
            }
        }
    }
    let Some(encoding) = encoding else {
        return Err(cursor.fault("the header does not state the format"));
    };
    cursor.end_line();
    cursor.encoding = encoding;
    Ok(elements)
}

fn format(cursor: &mut Cursor<'_>) -> Result<Encoding, Fault> {
    let encoding = match cursor.word()? {
        "ascii" => Encoding::Ascii,
        "binary_little_endian" => Encoding::Binary { big_endian: false },
        "binary_big_endian" => Encoding::Binary { big_endian: true },
        other => return Err(cursor.fault(format!("format {other}"))),
    };
    cursor.word()?;
    Ok(encoding)
}

fn property(cursor: &mut Cursor<'_>) -> Result<Property, Fault> {
    let first = cursor.word()?;
    let kind = match first {
        "list" => {
            let count = cursor.word()?;
            let count = number(cursor, count)?;
            let entry = cursor.word()?;
            Kind::List(count, number(cursor, entry)?)
        }
        word => Kind::One(number(cursor, word)?),
    };
    Ok(Property {
        name: cursor.word()?.to_owned(),
        kind,
    })
}

fn number(cursor: &Cursor<'_>, name: &str) -> Result<Number, Fault> {
    let found = KINDS.iter().find(|(known, _)| *known == name);
    let fault = || cursor.fault(format!("'{name}' where a type of numbers is expected"));
    found.map(|(_, kind)| *kind).ok_or_else(fault)
}
