//! Physical groups: $PhysicalNames, and in version 4.1 the $Entities that belong to them.

use super::super::Group;
use super::super::cursor::Cursor;
use super::elements::Simplices;
use super::nodes::Nodes;
use crate::error::Fault;
use std::collections::{BTreeMap, HashMap};

/// What a file says of its groups.
#[derive(Default)]
pub struct Groups {
    /// By dimension and tag.
    names: HashMap<(usize, i32), String>,
    /// In version 4.1 the groups of an entity, by its dimension and tag.
    entities: HashMap<(usize, i32), Vec<i32>>,
    /// Version 2.2: elements name their group themselves.
    direct: bool,
}

impl Groups {
    /// None yet; `direct` in version 2.2.
    pub fn new(direct: bool) -> Self {
        Self {
            direct,
            ..Self::default()
        }
    }

    /// $PhysicalNames, which are text in binary files too: dimension, tag, name in quotes.
    pub fn names(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let count: u64 = cursor.spelled("the number of names")?;
        for _ in 0..count {
            let dimension: usize = cursor.spelled("a group's dimension")?;
            let tag: i32 = cursor.spelled("a group's tag")?;
            self.names.insert((dimension, tag), cursor.quoted()?);
        }
        Ok(())
    }

    /// $Entities of version 4.1.
    pub fn entities(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.finish_line();
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = cursor.count("a number of entities")?;
        }
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                let tag = cursor.int("an entity's tag")?;
                // A point, or the corners of a box.
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    cursor.coordinate()?;
                }
                let groups = tags(cursor, "the number of an entity's groups")?;
                if dimension > 0 {
                    tags(cursor, "the number of an entity's boundaries")?;
                }
                self.entities.insert((dimension, tag), groups);
            }
        }
        Ok(())
    }

    /// The groups that have members, by dimension and tag.
    pub fn collect(
        &self,
        simplices: &[Simplices; 4],
        nodes: &Nodes,
        cells: usize,
    ) -> Result<Vec<Group>, Fault> {
        let mut all: BTreeMap<(usize, i32), Group> = BTreeMap::new();
        for (k, list) in simplices.iter().enumerate().take(cells + 1) {
            let first = list.tags.iter().copied().enumerate();
            for (i, tag) in first.chain(list.more.iter().copied()) {
                for &group in self.of(k, &tag) {
                    let group = all
                        .entry((k, group))
                        .or_insert_with(|| self.empty(k, group));
                    if k == cells {
                        group.cells.push(i as u32);
                    } else {
                        group.simplices.push(list.vertices(i, nodes)?);
                    }
                }
            }
        }
        Ok(all.into_values().collect())
    }

    /// The groups of an element with this tag; 0 is none.
    fn of<'a>(&'a self, k: usize, tag: &'a i32) -> &'a [i32] {
        match self.direct {
            true if *tag == 0 => &[],
            true => std::slice::from_ref(tag),
            false => self.entities.get(&(k, *tag)).map_or(&[], Vec::as_slice),
        }
    }

    fn empty(&self, dimension: usize, tag: i32) -> Group {
        Group {
            dimension,
            tag,
            name: self.names.get(&(dimension, tag)).cloned(),
            cells: Vec::new(),
            simplices: Vec::new(),
        }
    }
}

/// A count and so many tags.
fn tags(cursor: &mut Cursor<'_>, what: &str) -> Result<Vec<i32>, Fault> {
    let count = cursor.count(what)?;
    (0..count).map(|_| cursor.int("a tag")).collect()
}
