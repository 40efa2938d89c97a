//! Regge functions by their coefficients, and tensors by their edge components.

use super::regge::ReggeSpace;
use crate::Error;
use crate::field::{Evaluate, TensorField};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Mat, indefinite_pivot, surely_positive};
use crate::mesh::Mesh;
use crate::scalar::{Field, Lift, Number, Real};
use crate::simplex::{JetTable, Points};

/// A Regge function: a single-valued piecewise polynomial symmetric tensor, by its coefficients.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        try_from = "super::document::Document<C, N>",
        into = "super::document::Document<C, N>",
        bound(
            serialize = "C: Copy + serde::Serialize",
            deserialize = "C: Copy + serde::Deserialize<'de>"
        )
    )
)]
pub struct ReggeFunction<C, const N: usize> {
    space: ReggeSpace<N>,
    coefficients: Vec<C>,
}

impl<const N: usize> ReggeSpace<N> {
    /// The function with these coefficients.
    ///
    /// # Errors
    /// If there are too few or too many.
    pub fn function<C: Copy>(&self, coefficients: Vec<C>) -> Result<ReggeFunction<C, N>, Error> {
        if coefficients.len() != self.len() {
            return Err(Error::Input(format!(
                "{} coefficients for a Regge space of dimension {}",
                coefficients.len(),
                self.len()
            )));
        }
        Ok(ReggeFunction {
            space: self.clone(),
            coefficients,
        })
    }
}

impl<C: Copy, const N: usize> ReggeFunction<C, N> {
    /// Its space.
    pub fn space(&self) -> &ReggeSpace<N> {
        &self.space
    }

    /// Its coefficients in the order of the space's numbering.
    pub fn coefficients(&self) -> &[C] {
        &self.coefficients
    }

    /// The coefficients of the edge components on a cell: `[edge][α]`, one after the other.
    pub fn local(&self, cell: usize) -> Vec<C> {
        let (mesh, slots) = (self.space.mesh(), self.space.slots());
        let numbering = self.space.numbering();
        let mut local = Vec::with_capacity(slots.len() * slots[0].len());
        for slot in slots.iter().flatten() {
            local.push(self.coefficients[numbering.of_cell(mesh, cell, *slot)]);
        }
        local
    }
}

impl<C: Copy, const N: usize> ReggeFunction<C, N> {
    /// The Bernstein coefficients of the components on a cell, in any scalar: of g_ii, then of g_ij with i < j row by row,
    /// `[component][α]`, one after the other.
    pub fn components<F: Field>(&self, cell: usize, number: impl Fn(C) -> F) -> Vec<F> {
        let mut local: Vec<F> = self.local(cell).into_iter().map(number).collect();
        components_from_edges::<F, N>(&mut local);
        local
    }
}

impl<const N: usize> ReggeFunction<f64, N> {
    /// Is it a metric: positive definite at all given points of every cell?
    ///
    /// # Errors
    /// Names the first cell and point where it is not.
    pub fn check_positive(&self, points: &Points) -> Result<(), Error> {
        check_positive(self, self.space.mesh(), points)
    }
}

/// Is a field a metric: positive definite at all given points of every cell?
///
/// # Errors
/// Names the first cell and point where it is not.
pub fn check_positive<const N: usize, G: TensorField<N, Scalar = f64>>(
    field: &G,
    mesh: &Mesh<N>,
    points: &Points,
) -> Result<(), Error> {
    let wide = Evaluate::<G::Wide, N>::tabulate(field, points);
    let table = Evaluate::<f64, N>::tabulate(field, points);
    let mut found = None;
    let on_cell = |cell: usize| {
        if surely_positive_on::<G::Wide, N, G>(field, cell, &wide, points) {
            return None;
        }
        // Point by point, to name the one.
        let local = Evaluate::<f64, N>::on_cell(field, cell);
        (0..points.len()).find_map(|q| {
            let pivot = indefinite_pivot::<N>(&field.value(&local, &table, q))?;
            Some((q, pivot))
        })
    };
    crate::parallel::in_order(mesh.cell_count(), on_cell, |cell, bad| {
        if let (None, Some((q, pivot))) = (&found, bad) {
            found = Some(Error::Indefinite {
                cell,
                point: points.lambda(q).to_vec(),
                pivot,
            });
        }
    });
    found.map_or(Ok(()), Err)
}

fn surely_positive_on<T: Real<Sum = f64>, const N: usize, G: Evaluate<T, N>>(
    field: &G,
    cell: usize,
    table: &G::Table,
    points: &Points,
) -> bool {
    let local = field.on_cell(cell);
    let mut blocks = 0..points.blocks::<T>();
    blocks.all(|block| surely_positive(&field.value(&local, table, block)))
}

/// Adds q_ab f_β of the tensor with components g_ij to `sums`, `[edge][β]`, for these edges a < b.
#[inline]
pub(crate) fn add_edge_components<F: Field, const N: usize>(
    g: &Mat<F, N>,
    edges: &[[usize; 2]],
    f: &[F],
    sums: &mut [F],
) {
    for (&edge, sums) in edges.iter().zip(sums.chunks_exact_mut(f.len())) {
        let q = edge_component(g, edge);
        for (sum, f) in sums.iter_mut().zip(f) {
            *sum += q * *f;
        }
    }
}

/// The edge component q_ab, a < b, of the tensor with components g_ij.
#[inline]
fn edge_component<F: Field, const N: usize>(g: &Mat<F, N>, [a, b]: [usize; 2]) -> F {
    // t_0b = e_b; t_ab = e_b − e_a.
    match a {
        0 => g[(b - 1, b - 1)],
        _ => {
            let (a, b) = (a - 1, b - 1);
            g[(a, a)] + g[(b, b)] - g[(a, b)] - g[(a, b)]
        }
    }
}

/// The coefficients of the components and of their derivatives on a cell, as tables read them, from those of the edge
/// components, `[edge][α]`.
///
/// Differences come first: edge components are nearly the same all over a small cell, so that theirs are exact, and what is
/// rounded when they are put together is as small as the derivative. The other way round the rounding of g_ij itself
/// would be divided by h².
pub(super) fn with_derivatives<C: Field, const N: usize>(
    space: &ReggeSpace<N>,
    edges: &[C],
) -> Vec<C> {
    let (derivatives, count) = (space.derivatives(), N * (N + 1) / 2);
    let mut all = derivatives.follow(count, edges);
    derivatives.each_row(count, &mut all, components_from_edges::<C, N>);
    all
}

/// From the coefficients of the edge components, `[edge][α]`, those of g_ii = q_0i, then, pair by pair i < j in the
/// order of the edges that do not meet vertex 0, of g_ij = ½(q_0i + q_0j − q_ij).
fn components_from_edges<C: Field, const N: usize>(q: &mut [C]) {
    let size = q.len() / (N * (N + 1) / 2);
    let (diagonal, rest) = q.split_at_mut(N * size);
    let mut others = rest.chunks_exact_mut(size);
    for i in 0..N {
        for (j, pair) in (i + 1..N).zip(&mut others) {
            for (a, c) in pair.iter_mut().enumerate() {
                *c = (diagonal[i * size + a] + diagonal[j * size + a] - *c) * C::half();
            }
        }
    }
}

impl<C, T, const N: usize> Evaluate<T, N> for ReggeFunction<C, N>
where
    C: Field + Lift<T>,
    T: Real,
{
    type Table = JetTable<T, N>;
    /// The coefficients of the components on the cell, g_ii, then g_ij with i < j, followed by those of their derivatives.
    type Local = Vec<C>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        JetTable::new(self.space.degree(), points)
    }

    fn on_cell(&self, cell: usize) -> Vec<C> {
        with_derivatives(&self.space, &self.local(cell))
    }

    #[inline]
    fn jet2(&self, local: &Vec<C>, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        table.tensor2(block, local)
    }

    #[inline]
    fn jet1(&self, local: &Vec<C>, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        table.tensor1(block, local)
    }

    #[inline]
    fn value(&self, local: &Vec<C>, table: &Self::Table, block: usize) -> Mat<T, N> {
        table.tensor(block, local)
    }

    fn is_constant(&self) -> bool {
        self.space.degree() == 0
    }
}

impl<C: Number, const N: usize> TensorField<N> for ReggeFunction<C, N> {
    type Scalar = C;
    type Wide = C::Wide;
}
