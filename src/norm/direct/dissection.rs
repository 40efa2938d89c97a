//! An order of elimination with little fill: nested dissection by coordinates.
//!
//! The cells are cut in two by a plane across an axis, the unknowns of the simplices that touch both halves come
//! last, and each half is ordered in the same way. The plane is the one in the middle part of the cells, over all
//! axes, that cuts through the fewest unknowns (A. George, SIAM J. Numer. Anal. 10 (1973), who did it on a grid).

/// What is to be ordered: nodes with weights, each shared by some cells.
pub(super) struct Graph<'a> {
    /// A point of each cell, in a space of any dimension: `[axis][cell]`.
    pub centres: &'a [Vec<f64>],
    /// Compressed rows: the cells of node n are `cells[offsets[n]..offsets[n + 1]]`.
    pub offsets: &'a [usize],
    /// The cells of the nodes.
    pub cells: &'a [u32],
    /// How many unknowns a node has.
    pub weights: &'a [usize],
}

/// The part of the cells, on either side, in which no cut is looked for.
const MARGIN: f64 = 0.4;

/// The nodes in order of elimination. Depends on nothing but the graph.
pub(super) fn dissect(graph: &Graph<'_>) -> Vec<u32> {
    let along = |places: &Vec<f64>| {
        let place = |c: u32| places[c as usize];
        let mut cells: Vec<u32> = (0..places.len() as u32).collect();
        cells.sort_unstable_by(|&a, &b| place(a).total_cmp(&place(b)).then(a.cmp(&b)));
        cells
    };
    let cells: Vec<_> = graph.centres.iter().map(along).collect();
    let nodes: Vec<u32> = (0..graph.weights.len() as u32).collect();
    let mut order = Vec::with_capacity(nodes.len());
    let mut ranks = vec![0; cells[0].len()];
    graph.part(cells, nodes, &mut ranks, &mut order);
    order
}

/// A cut across an axis, between the first `at` cells along it and the others.
struct Cut {
    axis: usize,
    at: usize,
    weight: usize,
}

impl Graph<'_> {
    /// Appends the order of `nodes`, all of whose cells are among `cells`, which are given along each axis.
    fn part(&self, cells: Vec<Vec<u32>>, nodes: Vec<u32>, ranks: &mut [u32], order: &mut Vec<u32>) {
        let cut = match cells[0].len() {
            0 | 1 => None,
            _ if nodes.is_empty() => None,
            _ => (0..cells.len())
                .map(|axis| self.cut(axis, &cells[axis], &nodes, ranks))
                .min_by_key(|c| c.weight),
        };
        let Some(Cut { axis, at, .. }) = cut else {
            order.extend(nodes);
            return;
        };
        rank(&cells[axis], ranks);
        let (mut below, mut above, mut both) = (Vec::new(), Vec::new(), Vec::new());
        for node in nodes {
            let (first, last) = self.span(node, ranks);
            let list = if last < at {
                &mut below
            } else if first >= at {
                &mut above
            } else {
                &mut both
            };
            list.push(node);
        }
        // Each list stays in order, so that none is sorted again.
        let is_lower = |&c: &u32| (ranks[c as usize] as usize) < at;
        let lists = cells.into_iter();
        let halves = lists.map(|list| list.into_iter().partition(is_lower));
        let (lower, upper) = halves.unzip();
        self.part(lower, below, ranks, order);
        self.part(upper, above, ranks, order);
        order.extend(both);
    }

    /// The best cut across an axis of cells in order along it: the lightest one, and of these the one nearest to the middle.
    fn cut(&self, axis: usize, cells: &[u32], nodes: &[u32], ranks: &mut [u32]) -> Cut {
        rank(cells, ranks);
        // A node is cut by all planes between its first and its last cell.
        let (mut begin, mut end) = (vec![0; cells.len()], vec![0; cells.len()]);
        for &node in nodes {
            let (first, last) = self.span(node, ranks);
            begin[first] += self.weights[node as usize];
            end[last] += self.weights[node as usize];
        }
        let margin = ((cells.len() as f64 * MARGIN) as usize).max(1);
        let (mut best, mut weight) = (None, 0);
        for at in 1..cells.len() {
            weight = weight + begin[at - 1] - end[at - 1];
            if (margin..=cells.len() - margin).contains(&at) {
                let cut = (weight, (2 * at).abs_diff(cells.len()), at);
                best = Some(best.map_or(cut, |best| cut.min(best)));
            }
        }
        let (weight, _, at) = best.expect("two cells or more have a middle");
        Cut { axis, at, weight }
    }

    /// The ranks of the first and the last of a node's cells.
    fn span(&self, node: u32, ranks: &[u32]) -> (usize, usize) {
        let cells = &self.cells[self.offsets[node as usize]..self.offsets[node as usize + 1]];
        cells.iter().fold((usize::MAX, 0), |(first, last), &c| {
            let rank = ranks[c as usize] as usize;
            (first.min(rank), last.max(rank))
        })
    }
}

/// Writes down each cell's place in the list.
fn rank(cells: &[u32], ranks: &mut [u32]) {
    for (rank, &cell) in cells.iter().enumerate() {
        ranks[cell as usize] = rank as u32;
    }
}
