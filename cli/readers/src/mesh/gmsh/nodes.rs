//! $Nodes: tags, which are any numbers, and coordinates.

use super::super::cursor::Cursor;
use crate::error::{Fault, Place};
use std::collections::HashMap;

/// The nodes in the order of the file.
#[derive(Default)]
pub struct Nodes {
    /// Index + 1 of the tags that are small, 0 where there is none.
    dense: Vec<u32>,
    /// The index of the others.
    sparse: HashMap<u64, u32>,
    /// Three for each node.
    pub coordinates: Vec<f64>,
    /// Where each node stands.
    pub places: Vec<Place>,
}

impl Nodes {
    /// How many.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// The index of a tag.
    pub fn index(&self, tag: u64) -> Option<u32> {
        match self.dense.get(tag as usize) {
            Some(0) | None => self.sparse.get(&tag).copied(),
            Some(next) => Some(next - 1),
        }
    }

    fn add(&mut self, place: Place, tag: u64, x: [f64; 3]) -> Result<(), Fault> {
        let index = self.places.len() as u32;
        if self.index(tag).is_some() {
            return Err(Fault::new(place, format!("node {tag} is given twice")));
        }
        // Tags are numbered through as a rule: a table that is no longer than a few times the nodes so far.
        if tag < 4 * u64::from(index) + 64 && self.sparse.is_empty() {
            let at = tag as usize;
            if at >= self.dense.len() {
                self.dense.resize(at + 1, 0);
            }
            self.dense[at] = index + 1;
        } else {
            self.sparse.insert(tag, index);
        }
        self.places.push(place);
        self.coordinates.extend(x);
        Ok(())
    }

    /// Version 2.2.
    pub fn read_2(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let count: u64 = cursor.spelled("the number of nodes")?;
        cursor.finish_line();
        for _ in 0..count {
            cursor.align();
            let place = cursor.place();
            let tag = tag(cursor, "a node's number")?;
            let x = point(cursor)?;
            self.add(place, tag, x)?;
        }
        Ok(())
    }

    /// Version 4.1: blocks, in each the tags, then the coordinates.
    pub fn read_4(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let (place, [blocks, total]) = head(cursor, "the number of nodes")?;
        for _ in 0..blocks {
            self.block(cursor)?;
        }
        agree(place, total, self.len(), "nodes")
    }

    fn block(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let dimension = cursor.int("a block's dimension")?;
        cursor.int("a block's tag")?;
        let parametric = cursor.int("0 or 1")? != 0;
        let count = cursor.count("the number of nodes of a block")?;
        let mut tags = Vec::new();
        for _ in 0..count {
            tags.push(cursor.size("a node's tag")?);
        }
        let extra = if parametric { dimension.clamp(0, 3) } else { 0 };
        for tag in tags {
            cursor.align();
            let place = cursor.place();
            let x = point(cursor)?;
            for _ in 0..extra {
                cursor.coordinate()?;
            }
            self.add(place, tag, x)?;
        }
        Ok(())
    }
}

/// The first line of $Nodes or $Elements in version 4.1, with its place: how many blocks and how many things.
pub fn head(cursor: &mut Cursor<'_>, what: &str) -> Result<(Place, [u64; 2]), Fault> {
    cursor.finish_line();
    cursor.align();
    let place = cursor.place();
    let counts = [cursor.size("the number of blocks")?, cursor.size(what)?];
    for what in ["the least tag", "the largest tag"] {
        cursor.size(what)?;
    }
    Ok((place, counts))
}

/// Refuses a section in which there is not as much as its first line says: something is missing, or too much.
pub fn agree(place: Place, stated: u64, found: usize, what: &str) -> Result<(), Fault> {
    match stated == found as u64 {
        true => Ok(()),
        false => {
            let reason = format!("{stated} {what} are announced, {found} are there");
            Err(Fault::new(place, reason))
        }
    }
}

fn point(cursor: &mut Cursor<'_>) -> Result<[f64; 3], Fault> {
    Ok([
        cursor.coordinate()?,
        cursor.coordinate()?,
        cursor.coordinate()?,
    ])
}

/// A 32-bit tag.
pub fn tag(cursor: &mut Cursor<'_>, what: &str) -> Result<u64, Fault> {
    let tag = cursor.int(what)?;
    u64::try_from(tag).map_err(|_| cursor.fault(format!("{what} is {tag}")))
}
