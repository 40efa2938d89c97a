//! Stanford's PLY, as text and as bytes of either order: a header that says what follows, then vertices and faces.

mod header;

use super::super::MeshFile;
use super::super::cursor::{Cursor, Encoding};
use super::super::soup::Soup;
use super::no_triangle;
use crate::error::Fault;
use header::{Element, Kind, Number};

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let mut cursor = Cursor::new(bytes);
    let header = header::read(&mut cursor)?;
    let mut soup = Soup::new();
    for element in &header {
        if element.count > cursor.left() {
            let reason = format!(
                "{} times {}, more than the file can hold",
                element.count, element.name
            );
            return Err(Fault::new(element.place, reason));
        }
        match element.name.as_str() {
            "vertex" => vertices(&mut cursor, element, &mut soup)?,
            "face" => faces(&mut cursor, element, &mut soup)?,
            "tristrips" if element.count > 0 => {
                let reason = "strips of triangles: export single triangles";
                return Err(Fault::new(element.place, reason));
            }
            _ => (0..element.count).try_for_each(|_| pass(&mut cursor, element))?,
        }
    }
    if cursor.encoding == Encoding::Ascii && !cursor.is_at_end() {
        let place = cursor.aligned();
        return Err(Fault::new(place, "more than the header says"));
    }
    soup.finish()
}

/// The next number of a kind.
fn number(cursor: &mut Cursor<'_>, kind: Number) -> Result<f64, Fault> {
    if cursor.encoding == Encoding::Ascii {
        return cursor.spelled("a number");
    }
    Ok(match kind {
        Number::I8 => f64::from(cursor.byte()? as i8),
        Number::U8 => f64::from(cursor.byte()?),
        Number::I16 => f64::from(cursor.short()? as i16),
        Number::U16 => f64::from(cursor.short()?),
        Number::I32 => f64::from(cursor.int("a number")?),
        Number::U32 => f64::from(cursor.int("a number")? as u32),
        Number::F32 => cursor.any_single()?,
        Number::F64 => f64::from_bits(cursor.size("a number")?),
    })
}

/// A number that counts or points: not negative, whole.
fn index(cursor: &mut Cursor<'_>, kind: Number) -> Result<usize, Fault> {
    let place = cursor.place();
    let value = number(cursor, kind)?;
    match value >= 0.0 && value.fract() == 0.0 && value < 4294967296.0 {
        true => Ok(value as usize),
        false => Err(Fault::new(
            place,
            format!("{value} where a count or a vertex is expected"),
        )),
    }
}

fn vertices(cursor: &mut Cursor<'_>, element: &Element, soup: &mut Soup) -> Result<(), Fault> {
    let mut where_is = [None; 3];
    for (i, property) in element.properties.iter().enumerate() {
        if let Some(c) = ["x", "y", "z"]
            .iter()
            .position(|name| *name == property.name)
        {
            where_is[c] = Some(i);
        }
    }
    let [Some(x), Some(y), Some(z)] = where_is else {
        let reason = "vertices without one of the properties x, y, z";
        return Err(Fault::new(element.place, reason));
    };
    let mut row = vec![0.0; element.properties.len()];
    for _ in 0..element.count {
        let place = cursor.aligned();
        for (value, property) in row.iter_mut().zip(&element.properties) {
            *value = match property.kind {
                Kind::One(kind) => number(cursor, kind)?,
                Kind::List(count, kind) => {
                    pass_list(cursor, count, kind)?;
                    f64::NAN
                }
            };
        }
        let point = [row[x], row[y], row[z]];
        if let Some(x) = point.iter().find(|x| !x.is_finite()) {
            return Err(Fault::new(place, format!("a coordinate is {x}")));
        }
        soup.point(place, &point);
    }
    Ok(())
}

fn faces(cursor: &mut Cursor<'_>, element: &Element, soup: &mut Soup) -> Result<(), Fault> {
    let named = |name: &str| ["vertex_indices", "vertex_index"].contains(&name);
    if !element.properties.iter().any(|p| named(&p.name)) && element.count > 0 {
        let reason = "faces without the property vertex_indices";
        return Err(Fault::new(element.place, reason));
    }
    for _ in 0..element.count {
        let place = cursor.aligned();
        for property in &element.properties {
            match property.kind {
                Kind::One(kind) => _ = number(cursor, kind)?,
                Kind::List(count, kind) if named(&property.name) => {
                    let corners = index(cursor, count)?;
                    if corners != 3 {
                        return Err(Fault::new(place, no_triangle(corners)));
                    }
                    let mut points = Vec::with_capacity(3);
                    for _ in 0..3 {
                        points.push(index(cursor, kind)?);
                    }
                    soup.triangles.push(place, points);
                }
                Kind::List(count, kind) => pass_list(cursor, count, kind)?,
            }
        }
    }
    Ok(())
}

fn pass(cursor: &mut Cursor<'_>, element: &Element) -> Result<(), Fault> {
    for property in &element.properties {
        match property.kind {
            Kind::One(kind) => _ = number(cursor, kind)?,
            Kind::List(count, kind) => pass_list(cursor, count, kind)?,
        }
    }
    Ok(())
}

fn pass_list(cursor: &mut Cursor<'_>, count: Number, kind: Number) -> Result<(), Fault> {
    for _ in 0..index(cursor, count)? {
        number(cursor, kind)?;
    }
    Ok(())
}
