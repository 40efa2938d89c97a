//! Sums over planes of a lattice by several threads: what reaches the same plane is never taken at the same time.

use crate::parallel::for_chunks;

/// Items in slabs of consecutive planes, by the first plane that they reach. No item reaches beyond the next slab.
#[derive(Clone, Debug)]
pub(super) struct Slabs {
    /// How many planes a slab has.
    thickness: usize,
    /// By slab, in the order in which they were given.
    items: Vec<Vec<u32>>,
}

impl Slabs {
    /// Of items with the first plane that they reach and the one behind the last, among so many planes.
    pub fn new(planes: usize, spans: Vec<(u32, usize, usize)>) -> Self {
        let reach = spans.iter().map(|(_, first, end)| end - first).max();
        let thickness = reach.unwrap_or(1);
        let mut items = vec![Vec::new(); planes.div_ceil(thickness)];
        for (item, first, _) in spans {
            items[first / thickness].push(item);
        }
        Self { thickness, items }
    }

    /// `work(items, chunk, plane)` adds what a slab's items have to the chunk of `data` that begins at this plane; a plane has
    /// `unit` entries. First every other slab, then those between: the order of the sums does not depend on the threads.
    pub fn add_up<T: Send>(
        &self,
        data: &mut [T],
        unit: usize,
        work: impl Fn(&[u32], &mut [T], usize) + Sync,
    ) {
        for colour in 0..2 {
            let begin = data.len().min(colour * self.thickness * unit);
            for_chunks(&mut data[begin..], 2 * self.thickness * unit, |i, chunk| {
                let slab = 2 * i + colour;
                if let Some(items) = self.items.get(slab) {
                    work(items, chunk, slab * self.thickness);
                }
            });
        }
    }
}
