//! $Elements: the simplices of each dimension, flat, with their places and physical tags.

use super::super::cursor::{Cursor, Encoding};
use super::super::kinds::Kind;
use super::nodes::{Nodes, agree, head, tag};
use super::{Reader, element};
use crate::error::{Fault, Place};
use regge_curvature::simplex::binomial;
use std::collections::{HashMap, HashSet};

/// The simplices of one dimension.
pub struct Simplices {
    width: usize,
    nodes: Vec<u64>,
    /// k, the same for all of them; 1 while there are none.
    pub order: usize,
    /// For k > 1 the nodes of each behind its corners.
    further: Vec<u64>,
    /// Where each stands.
    pub places: Vec<Place>,
    /// What tells its physical groups: 2.2 the group itself, 4.1 the entity.
    pub tags: Vec<i32>,
    /// Further groups of simplices, by index: version 2.2 writes a simplex once for each.
    pub more: Vec<(usize, i32)>,
}

impl Simplices {
    /// None yet, with so many nodes each.
    pub fn new(width: usize) -> Self {
        Self {
            width,
            nodes: Vec::new(),
            order: 1,
            further: Vec::new(),
            places: Vec::new(),
            tags: Vec::new(),
            more: Vec::new(),
        }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// None?
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    fn nodes(&self, i: usize) -> &[u64] {
        &self.nodes[i * self.width..(i + 1) * self.width]
    }

    /// Makes one of the simplices that are there several times, each time for another group.
    ///
    /// # Errors
    /// One is there twice for the same group, if that is not `allowed`.
    pub fn merge(&mut self, allowed: bool) -> Result<(), Fault> {
        let old = std::mem::replace(self, Self::new(self.width));
        let mut first: HashMap<[u64; 4], usize> = HashMap::with_capacity(old.len());
        let mut seen = HashSet::new();
        let further = old.further.len() / old.len().max(1);
        self.order = old.order;
        for i in 0..old.len() {
            let (tag, place) = (old.tags[i], old.places[i]);
            let one = *first.entry(key(old.nodes(i))).or_insert(self.len());
            if one == self.len() {
                self.nodes.extend(old.nodes(i));
                let nodes = &old.further[i * further..(i + 1) * further];
                self.further.extend(nodes);
                self.places.push(place);
                self.tags.push(tag);
            } else if self.tags[one] != tag && seen.insert((one, tag)) {
                self.more.push((one, tag));
            } else if !allowed {
                let reason = "an element that is there already, and not for another physical group";
                return Err(Fault::new(place, reason));
            }
        }
        Ok(())
    }

    /// The nodes of one behind its corners, by their index.
    pub fn further(&self, i: usize, nodes: &Nodes) -> Result<Vec<u32>, Fault> {
        let count = self.further.len() / self.len();
        let found = self.further[i * count..(i + 1) * count].iter();
        let index = |tag: &u64| nodes.index(*tag).ok_or_else(|| self.missing(i, *tag));
        found.map(index).collect()
    }

    fn missing(&self, i: usize, tag: u64) -> Fault {
        Fault::new(self.places[i], format!("node {tag} does not exist"))
    }

    /// The vertices of one, by their index.
    pub fn vertices(&self, i: usize, nodes: &Nodes) -> Result<Vec<usize>, Fault> {
        let mut list = Vec::with_capacity(self.width);
        for &tag in self.nodes(i) {
            match nodes.index(tag) {
                Some(index) => list.push(index as usize),
                None => return Err(self.missing(i, tag)),
            }
        }
        Ok(list)
    }
}

impl Reader {
    /// Version 2.2. Text: one element a line. Binary: blocks of elements with one header.
    pub(super) fn elements_2(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let start = cursor.place();
        let total: u64 = cursor.spelled("the number of elements")?;
        cursor.finish_line();
        let ascii = cursor.encoding == Encoding::Ascii;
        let mut done = 0;
        while done < total {
            cursor.align();
            if ascii {
                cursor.int("an element's number")?;
            }
            let kind = element(cursor)?;
            let block = match ascii {
                true => 1,
                false => cursor.int("a number of elements")?.max(1),
            };
            let tags = cursor.int("a number of tags")?;
            for _ in 0..block {
                let place = cursor.place();
                if !ascii {
                    cursor.int("an element's number")?;
                }
                let mut physical = 0;
                for i in 0..tags {
                    let tag = cursor.int("a tag")?;
                    if i == 0 {
                        physical = tag;
                    }
                }
                self.element(cursor, place, kind, physical, tag)?;
            }
            done += u64::from(block.unsigned_abs());
        }
        agree(start, total, done as usize, "elements")
    }

    /// Version 4.1: blocks of elements of one entity.
    pub(super) fn elements_4(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let (start, [blocks, total]) = head(cursor, "the number of elements")?;
        let mut found = 0;
        for _ in 0..blocks {
            cursor.int("a block's dimension")?;
            let entity = cursor.int("a block's tag")?;
            let kind = element(cursor)?;
            let count = cursor.count("the number of elements of a block")?;
            for _ in 0..count {
                cursor.align();
                let place = cursor.place();
                cursor.size("an element's tag")?;
                self.element(cursor, place, kind, entity, |cursor, what| {
                    cursor.size(what)
                })?;
            }
            found += count;
        }
        agree(start, total, found, "elements")
    }

    /// The nodes of one element.
    fn element(
        &mut self,
        cursor: &mut Cursor<'_>,
        place: Place,
        kind: Kind,
        tag: i32,
        node: fn(&mut Cursor<'_>, &str) -> Result<u64, Fault>,
    ) -> Result<(), Fault> {
        let Kind::Simplex { dimension, order } = kind else {
            unreachable!("what is refused is refused by `element`");
        };
        let list = &mut self.simplices[dimension];
        if !list.is_empty() && list.order != order {
            let reason = format!(
                "an element of order {order} among others of order {}",
                list.order
            );
            return Err(Fault::new(place, reason));
        }
        list.order = order;
        for i in 0..binomial(dimension + order, dimension) {
            let node = node(cursor, "a node of the element")?;
            match i <= dimension {
                true => list.nodes.push(node),
                false => list.further.push(node),
            }
        }
        list.places.push(place);
        list.tags.push(tag);
        Ok(())
    }
}

/// In a mesh of tetrahedra: a triangle that is not a face of one.
pub fn lost_triangle(triangles: &Simplices, tetrahedra: &Simplices) -> Option<Place> {
    if tetrahedra.is_empty() || triangles.is_empty() {
        return None;
    }
    let mut faces: Vec<[u64; 3]> = Vec::with_capacity(4 * tetrahedra.len());
    for i in 0..tetrahedra.len() {
        let nodes = tetrahedra.nodes(i);
        for out in 0..4 {
            faces.push(sorted(|j| nodes[if j < out { j } else { j + 1 }]));
        }
    }
    faces.sort_unstable();
    (0..triangles.len())
        .find(|&i| {
            let face = sorted(|j| triangles.nodes(i)[j]);
            faces.binary_search(&face).is_err()
        })
        .map(|i| triangles.places[i])
}

/// The nodes of a simplex whatever their order.
fn key(nodes: &[u64]) -> [u64; 4] {
    let mut key = [0; 4];
    key[..nodes.len()].copy_from_slice(nodes);
    key.sort_unstable();
    key
}

fn sorted(node: impl Fn(usize) -> u64) -> [u64; 3] {
    let mut face = std::array::from_fn(node);
    face.sort_unstable();
    face
}
