//! Regge finite elements of any degree in any dimension.
//!
//! A symmetric tensor on a cell is known by its edge components q_ab(x) = g_x(t_ab, t_ab), t_ab the edge from vertex
//! a to vertex b: g_ij = ½(q_0i + q_0j − q_ij) in reference coordinates. The tensor has degree r if all q_ab do, and
//! it is tangential-tangential continuous if and only if, for every simplex D and every edge ab of D, q_ab is
//! single-valued on D. So the coefficients of the q_ab in Bernstein's basis belong to simplices: B_α in q_ab to the
//! simplex with vertices {a, b} ∪ supp α, and a global vector of such coefficients is a Regge function. For r = 0
//! they are the squared edge lengths.

use super::lagrange::numbers;
use super::test::{Symmetric, TestSpace, Trace};
use crate::Error;
use crate::field::{Evaluate, TensorField};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Mat, indefinite_pivot, symmetric};
use crate::mesh::{Mesh, Numbering, Slot};
use crate::scalar::{Field, Lift, Number, Real};
use crate::simplex::{Bernstein, JetTable, Points, binomial, subsets};
use std::sync::Arc;

/// The Regge space of degree r on a mesh: a handle, whose clones share its tables.
#[derive(Clone, Debug)]
pub struct ReggeSpace<const N: usize> {
    tables: Arc<Tables<N>>,
}

#[derive(Debug)]
struct Tables<const N: usize> {
    mesh: Mesh<N>,
    degree: usize,
    numbering: Numbering,
    slots: Vec<Vec<Slot>>,
}

/// Spaces are the same if they have one degree on one mesh.
impl<const N: usize> PartialEq for ReggeSpace<N> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.tables, &other.tables)
            || (self.degree() == other.degree() && self.mesh() == other.mesh())
    }
}

/// How many degrees of freedom of degree r belong to a k-simplex: C(r+1, k) k(k+1)/2. Paper: appendix.
pub fn dofs_per_simplex(degree: usize, k: usize) -> usize {
    binomial(degree + 1, k) * k * (k + 1) / 2
}

impl<const N: usize> ReggeSpace<N> {
    /// The space of degree r ≥ 0.
    pub fn new(mesh: &Mesh<N>, degree: usize) -> Self {
        let numbering =
            Numbering::new(mesh, (0..=N).map(|k| dofs_per_simplex(degree, k)).collect());
        let all: Vec<usize> = (0..=N).collect();
        Self {
            tables: Arc::new(Tables {
                mesh: mesh.clone(),
                degree,
                numbering,
                slots: slots_on(&all, N, degree),
            }),
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<N> {
        &self.tables.mesh
    }

    /// r.
    pub fn degree(&self) -> usize {
        self.tables.degree
    }

    /// The dimension.
    pub fn len(&self) -> usize {
        self.tables.numbering.len()
    }

    /// Never.
    pub fn is_empty(&self) -> bool {
        self.tables.numbering.is_empty()
    }

    /// How the degrees of freedom are numbered.
    pub fn numbering(&self) -> &Numbering {
        &self.tables.numbering
    }

    /// The global index of the coefficient of B_α in q_ab on a cell: edges in the order of [`subsets`], α in that of
    /// [`crate::simplex::multi_indices`].
    pub fn cell_dof(&self, cell: usize, edge: usize, alpha: usize) -> usize {
        let tables = &self.tables;
        tables
            .numbering
            .of_cell(&tables.mesh, cell, tables.slots[edge][alpha])
    }

    /// Where the coefficients of the q_ab on a cell are numbered, by edge, then by α.
    pub(super) fn slots(&self) -> &[Vec<Slot>] {
        &self.tables.slots
    }

    /// Where the coefficients of the q_ab on the subsimplex with these local vertices of a cell are numbered, by edge of
    /// the subsimplex, then by α.
    pub fn trace_slots(&self, vertices: &[usize]) -> Vec<Slot> {
        slots_on(vertices, N, self.tables.degree).concat()
    }

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

impl<const N: usize> TestSpace<N> for ReggeSpace<N> {
    type Value = Symmetric;

    fn mesh(&self) -> &Mesh<N> {
        &self.tables.mesh
    }

    fn len(&self) -> usize {
        self.tables.numbering.len()
    }

    fn cell_len(&self) -> usize {
        self.tables.slots.len() * self.tables.slots[0].len()
    }

    fn push_dofs(&self, cell: usize, dofs: &mut Vec<usize>) {
        let Tables {
            mesh, numbering, ..
        } = &*self.tables;
        let slots = self.tables.slots.iter().flatten();
        dofs.extend(slots.map(|&slot| numbering.of_cell(mesh, cell, slot)));
    }

    fn trace(&self, vertices: &[usize]) -> Trace {
        Trace {
            basis: Bernstein::new(vertices.len(), self.tables.degree),
            numbers: numbers(&self.trace_slots(vertices), &self.tables.slots.concat()),
        }
    }
}

/// Where B_α in q_ab is numbered, by edge and α, on the simplex with the given local vertices of an n-simplex.
pub(crate) fn slots_on(vertices: &[usize], n: usize, degree: usize) -> Vec<Vec<Slot>> {
    let places: Vec<Vec<Vec<usize>>> = (0..=n).map(|k| subsets(n + 1, k + 1)).collect();
    let mut seen: Vec<Vec<usize>> = places.iter().map(|p| vec![0; p.len()]).collect();
    let exponents = crate::simplex::multi_indices(vertices.len(), degree);
    subsets(vertices.len(), 2)
        .into_iter()
        .map(|edge| {
            exponents
                .iter()
                .map(|alpha| {
                    let charged = |i: &usize| alpha[*i] > 0 || edge.contains(i);
                    let support: Vec<usize> = (0..vertices.len())
                        .filter(charged)
                        .map(|i| vertices[i])
                        .collect();
                    let k = support.len() - 1;
                    let place = places[k].iter().position(|p| *p == support).expect(
                        "the simplex that two vertices and a support span belongs to the cell",
                    );
                    let index = seen[k][place];
                    seen[k][place] += 1;
                    Slot { k, place, index }
                })
                .collect()
        })
        .collect()
}

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
        let tables = &self.space.tables;
        let mut local = Vec::with_capacity(tables.slots.len() * tables.slots[0].len());
        for slot in tables.slots.iter().flatten() {
            local.push(self.coefficients[tables.numbering.of_cell(&tables.mesh, cell, *slot)]);
        }
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
pub fn check_positive<const N: usize, G: Evaluate<f64, N>>(
    field: &G,
    mesh: &Mesh<N>,
    points: &Points,
) -> Result<(), Error> {
    let table = field.tabulate(points);
    let mut found = None;
    let on_cell = |cell: usize| {
        let local = field.on_cell(cell);
        (0..points.len())
            .find_map(|q| indefinite_pivot(&field.value(&local, &table, q)).map(|pivot| (q, pivot)))
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

/// Edge components `[edge]`, in the order of [`subsets`], of the tensor with components g_ij.
pub(crate) fn edge_components<F: Field, const N: usize>(g: &Mat<F, N>) -> Vec<F> {
    let mut q = Vec::with_capacity(N * (N + 1) / 2);
    // t_0b = e_b; t_ab = e_b − e_a.
    q.extend((0..N).map(|b| g[(b, b)]));
    for a in 0..N {
        q.extend((a + 1..N).map(|b| g[(a, a)] + g[(b, b)] - g[(a, b)] - g[(a, b)]));
    }
    q
}

/// From the coefficients of the edge components, `[edge][α]`, those of g_ii = q_0i, then, pair by pair i < j in the
/// order of the edges that do not meet vertex 0, of g_ij = ½(q_0i + q_0j − q_ij).
pub(super) fn components_from_edges<C: Field, const N: usize>(q: &mut [C]) {
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

/// The matrix whose entries are made of equally long chunks of `coefficients`: the diagonal, then all i < j.
#[inline]
pub(super) fn from_chunks<C, F: Field, const N: usize>(
    coefficients: &[C],
    entry: impl Fn(&[C]) -> F,
) -> Mat<F, N> {
    let size = coefficients.len() / (N * (N + 1) / 2);
    let mut pair = N;
    symmetric(|i, j| {
        let chunk = if i == j { i } else { pair };
        pair += usize::from(i < j);
        entry(&coefficients[chunk * size..(chunk + 1) * size])
    })
}

impl<C, T, const N: usize> Evaluate<T, N> for ReggeFunction<C, N>
where
    C: Field + Lift<T>,
    T: Real,
{
    type Table = JetTable<T, N>;
    /// The coefficients of the components on the cell: g_ii, then g_ij with i < j, `[component][α]`.
    type Local = Vec<C>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        JetTable::new(&Bernstein::new(N + 1, self.space.degree()), points)
    }

    fn on_cell(&self, cell: usize) -> Vec<C> {
        let mut local = self.local(cell);
        components_from_edges::<C, N>(&mut local);
        local
    }

    #[inline]
    fn jet2(&self, local: &Vec<C>, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        from_chunks(local, |c| table.jet2(block, c))
    }

    #[inline]
    fn jet1(&self, local: &Vec<C>, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        from_chunks(local, |c| table.jet1(block, c))
    }

    #[inline]
    fn value(&self, local: &Vec<C>, table: &Self::Table, block: usize) -> Mat<T, N> {
        from_chunks(local, |c| table.value(block, c))
    }

    fn is_constant(&self) -> bool {
        self.space.degree() == 0
    }
}

impl<C: Number, const N: usize> TensorField<N> for ReggeFunction<C, N> {
    type Scalar = C;
    type Wide = C::Wide;
}
