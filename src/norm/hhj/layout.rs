//! Where the unknowns of the hybridised method stand in a cell's vector.
//!
//! Bubbles of u first, which are condensed; then one block a subsimplex, of dimension 0, …, N−1 and in the order of
//! [`crate::simplex::subsets`]: the u that belong to it, and on a face the slope û in Bernstein polynomials of
//! degree p−1 after them.

use crate::mesh::Slot;
use crate::simplex::{Bernstein, binomial, subsets};
use crate::spaces::Lagrange;

/// The unknowns of one subsimplex of a cell.
#[derive(Clone, Copy, Debug)]
pub(in crate::norm) struct Block {
    /// The dimension of the subsimplex, < N.
    pub k: usize,
    /// Which of the cell's k-simplices.
    pub place: usize,
    /// Its first local index.
    pub start: usize,
    /// How many unknowns.
    pub width: usize,
}

/// One equation of the change of unknown on a face: which u make the derivative's coefficient β.
#[derive(Clone, Debug)]
pub(in crate::norm) struct FaceMoment {
    /// The local index of û_β, which is that of ŵ_β too.
    pub slope: usize,
    /// For each vertex v of the face, ascending: the local index of the coefficient β + e_v of u.
    pub raised: Vec<usize>,
    /// The same for the vertex opposite to the face. It is a bubble where β charges all vertices of the face.
    pub opposite: usize,
}

/// The numbering inside a cell.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Layout {
    /// How many bubbles of u: indices 0 … bubbles−1.
    pub bubbles: usize,
    /// All other unknowns, by subsimplices.
    pub blocks: Vec<Block>,
    /// The local index of each Bernstein polynomial of u.
    pub bernstein: Vec<usize>,
    /// Face by face (the face without vertex N first, as in `subsets`), the coefficients β of û.
    pub faces: Vec<Vec<FaceMoment>>,
    /// How many unknowns.
    pub len: usize,
}

impl Layout {
    /// The coefficient of u at the vertex opposite to a face, if it is no bubble.
    pub fn opposite(&self, moment: &FaceMoment) -> Option<usize> {
        (moment.opposite >= self.bubbles).then_some(moment.opposite)
    }

    pub fn new<const N: usize>(space: &Lagrange<N>) -> Self {
        let p = space.degree();
        let bubbles = own(N, p);
        let mut blocks = Vec::new();
        let mut len = bubbles;
        for k in 0..N {
            let width = own(k, p) + if k == N - 1 { slopes(N, p) } else { 0 };
            for place in 0..binomial(N + 1, k + 1) {
                blocks.push(Block {
                    k,
                    place,
                    start: len,
                    width,
                });
                len += width;
            }
        }
        let all: Vec<usize> = (0..=N).collect();
        let local = |slot: &Slot| match slot.k == N {
            true => slot.index,
            false => {
                let mut blocks = blocks.iter();
                let block = blocks.find(|b| b.k == slot.k && b.place == slot.place);
                block.expect("every subsimplex has a block").start + slot.index
            }
        };
        let bernstein: Vec<usize> = space.trace_slots(&all).iter().map(local).collect();
        let faces = faces(N, p, &blocks, &bernstein);
        Self {
            bubbles,
            blocks,
            bernstein,
            faces,
            len,
        }
    }
}

/// How many u of degree p belong to a k-simplex: the Bernstein polynomials that charge all its vertices.
pub(in crate::norm) fn own(k: usize, p: usize) -> usize {
    binomial(p - 1, k)
}

/// How many û belong to a face: dim P_{p−1}.
pub(in crate::norm) fn slopes(n: usize, p: usize) -> usize {
    binomial(p + n - 2, n - 1)
}

/// The indices that the change of unknown combines.
fn faces(n: usize, p: usize, blocks: &[Block], bernstein: &[usize]) -> Vec<Vec<FaceMoment>> {
    let of_cell = Bernstein::new(n + 1, p);
    let of_face = Bernstein::new(n, p - 1);
    let index_of = |alpha: &[usize]| {
        let position = of_cell.exponents().iter().position(|a| a == alpha);
        bernstein[position.expect("β + e_v is of degree p")]
    };
    let mut all = Vec::new();
    for (face, block) in subsets(n + 1, n)
        .iter()
        .zip(blocks.iter().filter(|b| b.k == n - 1))
    {
        let first = block.start + own(n - 1, p);
        let opposite = (0..=n).find(|v| !face.contains(v));
        let opposite = opposite.expect("a face has one vertex less than its cell");
        let moment = |(beta, exponents): (usize, &Vec<usize>)| {
            let mut alpha = vec![0; n + 1];
            for (i, &v) in face.iter().enumerate() {
                alpha[v] = exponents[i];
            }
            let raise = |v: usize| {
                let mut raised = alpha.clone();
                raised[v] += 1;
                index_of(&raised)
            };
            FaceMoment {
                slope: first + beta,
                raised: face.iter().map(|&v| raise(v)).collect(),
                opposite: raise(opposite),
            }
        };
        all.push(of_face.exponents().iter().enumerate().map(moment).collect());
    }
    all
}
