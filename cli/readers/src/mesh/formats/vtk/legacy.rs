//! Legacy files: `# vtk DataFile Version`, a title, ASCII or BINARY, DATASET, and sections.

use super::super::super::MeshFile;
use super::super::super::cursor::{Cursor, Encoding};
use super::super::super::soup::Soup;
use super::{POLYGON, add};
use crate::error::{Fault, Place};

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let mut cursor = Cursor::new(bytes);
    // The version, and the title.
    cursor.finish_line();
    cursor.finish_line();
    let place = cursor.aligned();
    let encoding = match cursor.word()?.to_ascii_uppercase().as_str() {
        "ASCII" => Encoding::Ascii,
        "BINARY" => Encoding::Binary { big_endian: true },
        other => {
            let reason = format!("'{other}' where ASCII or BINARY is expected");
            return Err(Fault::new(place, reason));
        }
    };
    cursor.keyword("DATASET")?;
    let place = cursor.aligned();
    let surface = match cursor.word()?.to_ascii_uppercase().as_str() {
        "POLYDATA" => true,
        "UNSTRUCTURED_GRID" => false,
        other => {
            let reason = format!("{other}: POLYDATA and UNSTRUCTURED_GRID can be read");
            return Err(Fault::new(place, reason));
        }
    };
    let mut reader = Reader {
        cursor,
        encoding,
        soup: Soup::new(),
        cells: Vec::new(),
    };
    reader.sections(surface)?;
    reader.soup.finish()
}

/// A cell's points and where it stands.
type Cell = (Vec<usize>, Place);

struct Reader<'a> {
    cursor: Cursor<'a>,
    encoding: Encoding,
    soup: Soup,
    /// Of an unstructured grid, until their kinds are known.
    cells: Vec<Cell>,
}

impl Reader<'_> {
    fn sections(&mut self, surface: bool) -> Result<(), Fault> {
        while !self.cursor.is_at_end() {
            let place = self.cursor.aligned();
            let word = self.cursor.word()?;
            match word.to_ascii_uppercase().as_str() {
                "POINTS" => self.points()?,
                "POLYGONS" if surface => {
                    for (points, place) in self.lists()? {
                        add(&mut self.soup, place, POLYGON, points)?;
                    }
                }
                "LINES" | "VERTICES" if surface => drop(self.lists()?),
                "TRIANGLE_STRIPS" if surface => {
                    if let Some((points, place)) = self.lists()?.into_iter().next() {
                        add(&mut self.soup, place, 6, points)?;
                    }
                }
                "CELLS" if !surface => self.cells = self.lists()?,
                "CELL_TYPES" if !surface => self.kinds()?,
                "METADATA" => self.metadata(),
                // Fields come behind the mesh.
                "POINT_DATA" | "CELL_DATA" | "FIELD" => break,
                other => {
                    let reason = format!("'{other}' where a section of a VTK file is expected");
                    return Err(Fault::new(place, reason));
                }
            }
        }
        match self.cells.is_empty() {
            true => Ok(()),
            false => Err(self
                .cursor
                .fault("CELL_TYPES is missing: the file may be truncated")),
        }
    }

    /// Numbers follow, as text or bytes.
    fn begin(&mut self) {
        if self.encoding != Encoding::Ascii {
            self.cursor.end_line();
            self.cursor.encoding = self.encoding;
        }
    }

    /// Words follow.
    fn end(&mut self) {
        if self.encoding != Encoding::Ascii {
            self.cursor.encoding = Encoding::Ascii;
        }
    }

    fn points(&mut self) -> Result<(), Fault> {
        let count = self.cursor.count("the number of points")?;
        let place = self.cursor.aligned();
        let single = match self.cursor.word()?.to_ascii_lowercase().as_str() {
            "float" => true,
            "double" => false,
            other => {
                let reason = format!("points of type {other}: float and double can be read");
                return Err(Fault::new(place, reason));
            }
        };
        self.begin();
        for _ in 0..count {
            let (place, mut x) = (self.cursor.aligned(), [0.0; 3]);
            for x in &mut x {
                *x = match self.encoding != Encoding::Ascii && single {
                    true => self.cursor.single()?,
                    false => self.cursor.coordinate()?,
                };
            }
            self.soup.point(place, &x);
        }
        self.end();
        Ok(())
    }

    /// Lists of points: each with its length before it, or since version 5 all ends, then all points.
    fn lists(&mut self) -> Result<Vec<Cell>, Fault> {
        let count = self.cursor.count("the number of cells")?;
        let numbers = self.cursor.count("the number of numbers")?;
        if self
            .cursor
            .peek()
            .is_ok_and(|word| word.eq_ignore_ascii_case("OFFSETS"))
        {
            return self.offsets(count, numbers);
        }
        self.begin();
        let mut all = Vec::new();
        for _ in 0..count {
            let place = self.cursor.aligned();
            let points = self.index()?;
            if points > self.cursor.left() {
                return Err(Fault::new(place, format!("a cell with {points} points")));
            }
            let points: Result<Vec<usize>, Fault> = (0..points).map(|_| self.index()).collect();
            all.push((points?, place));
        }
        self.end();
        Ok(all)
    }

    fn offsets(&mut self, ends: usize, points: usize) -> Result<Vec<Cell>, Fault> {
        self.cursor.keyword("OFFSETS")?;
        let ends = self.array(ends)?;
        self.cursor.keyword("CONNECTIVITY")?;
        let place = self.cursor.aligned();
        let points = self.array(points)?;
        let list = |pair: &[usize]| match points.get(pair[0]..pair[1]) {
            Some(points) => Ok((points.to_vec(), place)),
            None => Err(Fault::new(place, "OFFSETS do not fit CONNECTIVITY")),
        };
        ends.windows(2).map(list).collect()
    }

    /// A type and so many whole numbers.
    fn array(&mut self, count: usize) -> Result<Vec<usize>, Fault> {
        let place = self.cursor.aligned();
        let long = match self.cursor.word()? {
            "vtktypeint64" => true,
            "vtktypeint32" => false,
            other => return Err(Fault::new(place, format!("whole numbers of type {other}"))),
        };
        self.begin();
        let bytes = long && self.encoding != Encoding::Ascii;
        let mut all = Vec::new();
        for _ in 0..count {
            all.push(match bytes {
                true => self.long()?,
                false => self.index()?,
            });
        }
        self.end();
        Ok(all)
    }

    fn index(&mut self) -> Result<usize, Fault> {
        let (place, index) = (self.cursor.aligned(), self.cursor.int("a whole number")?);
        usize::try_from(index).map_err(|_| Fault::new(place, format!("point {index}")))
    }

    fn long(&mut self) -> Result<usize, Fault> {
        let (place, index) = (self.cursor.place(), self.cursor.size("a whole number")?);
        usize::try_from(index).map_err(|_| Fault::new(place, format!("point {index}")))
    }

    fn kinds(&mut self) -> Result<(), Fault> {
        let place = self.cursor.aligned();
        let count = self.cursor.count("the number of types")?;
        if count != self.cells.len() {
            let reason = format!("{count} types for {} cells", self.cells.len());
            return Err(Fault::new(place, reason));
        }
        self.begin();
        for (points, place) in std::mem::take(&mut self.cells) {
            let kind = u8::try_from(self.index()?).unwrap_or(u8::MAX);
            add(&mut self.soup, place, kind, points)?;
        }
        self.end();
        Ok(())
    }

    /// Lines up to an empty one.
    fn metadata(&mut self) {
        self.cursor.finish_line();
        while !self.cursor.is_line_empty() {
            self.cursor.finish_line();
        }
    }
}
