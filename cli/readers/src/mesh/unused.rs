//! Vertices of no cell: the centres of circles in Gmsh's files, the points that curves were drawn by.

use super::MeshFile;

impl MeshFile {
    /// Leaves out the vertices that belong to no cell, with the members of groups that have them, and says how many.
    pub(super) fn drop_unused(&mut self) {
        let mut new = vec![None; self.vertices];
        for &vertex in self.cells.iter().flatten() {
            new[vertex] = Some(0);
        }
        for (index, kept) in new.iter_mut().flatten().enumerate() {
            *kept = index;
        }
        let left = new.iter().flatten().count();
        if left == self.vertices {
            return;
        }
        // Nodes of curved cells that are no corners are no vertices, but they are used.
        let further = self.curved.as_ref().map_or(&[][..], |curved| &curved.nodes);
        let is_lost = |node: &usize| new[*node].is_none() && further.get(*node) != Some(&true);
        let dropped = (0..self.vertices).filter(is_lost).count();
        if dropped > 0 {
            self.notes.push(format!(
                "{dropped} of {} nodes belong to no cell and are left out; vertices are counted without them",
                self.vertices
            ));
        }
        self.vertices = left;
        let width = self.width;
        let mut kept = new.iter();
        let mut is_kept = || kept.next().is_some_and(Option::is_some);
        self.vertex_places.retain(|_| is_kept());
        let rows = self.coordinates.chunks_exact(width).zip(&new);
        self.coordinates = (rows.filter(|(_, new)| new.is_some()))
            .flat_map(|(row, _)| row.iter().copied())
            .collect();
        let mut lost = 0;
        for cell in &mut self.cells {
            for vertex in cell {
                *vertex = new[*vertex].expect("vertices of cells are kept");
            }
        }
        for group in &mut self.groups {
            let before = group.simplices.len();
            group
                .simplices
                .retain(|list| list.iter().all(|v| new[*v].is_some()));
            lost += before - group.simplices.len();
            for vertex in group.simplices.iter_mut().flatten() {
                *vertex = new[*vertex].expect("the others are gone");
            }
        }
        if lost > 0 {
            self.notes.push(format!(
                "{lost} members of physical groups are no faces, edges or vertices of cells and are left out"
            ));
        }
        self.groups
            .retain(|group| !(group.cells.is_empty() && group.simplices.is_empty()));
    }
}
