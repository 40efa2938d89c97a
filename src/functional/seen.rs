//! The simplices of a cell at the points of the rules, and a metric there: the one place where jets become densities.

use super::Rules;
use crate::density::{Corner, Inside, Side, omega, outward};
use crate::field::Evaluate;
use crate::formulas::Formulas;
use crate::jet::{Jet1, lower};
use crate::linalg::{Mat, Vector, inverse_and_det};
use crate::quadrature::Rule;
use crate::riemann::Connection;
use crate::scalar::Real;
use crate::simplex::{Points, subsets};

/// A rule's weights by blocks; lanes beyond the last point weigh nothing.
pub(super) fn weights<T: Real>(rule: &Rule) -> Vec<T> {
    rule.weight_blocks()
}

/// The k-simplices of an N-simplex, by place: their local vertices and a rule's points on them as the cell sees them.
pub(super) struct Sites {
    /// Local vertices.
    pub vertices: Vec<Vec<usize>>,
    /// The rule's points in barycentric coordinates of the cell.
    pub points: Vec<Points>,
}

impl Sites {
    /// For a rule on simplices of its own dimension.
    pub fn new(dimension: usize, rule: &Rule) -> Self {
        let vertices = subsets(dimension + 1, rule.points().vertices());
        let seen = |on: &Vec<usize>| rule.points().embed(on, dimension + 1);
        Self {
            points: vertices.iter().map(seen).collect(),
            vertices,
        }
    }

    /// A field's tables, by place.
    pub fn tables<T: Real, const N: usize, G: Evaluate<T, N>>(&self, field: &G) -> Vec<G::Table> {
        let points = self.points.iter();
        points.map(|points| field.tabulate(points)).collect()
    }

    /// The outward covectors of the faces of the cell that contain the simplex at a place.
    fn outward<T: Real, const N: usize>(&self, place: usize) -> impl Iterator<Item = Vector<T, N>> {
        let on = &self.vertices[place];
        (0..=N).filter(|v| !on.contains(v)).map(outward)
    }
}

/// The three kinds of sites: cells, faces, hinges.
pub(super) fn all_sites(dimension: usize, rules: &Rules) -> [Sites; 3] {
    [&rules.cells, &rules.faces, &rules.hinges].map(|rule| Sites::new(dimension, rule))
}

/// A metric at the points of the rules on a cell, its faces and its hinges.
pub(super) struct Seen<'a, T: Real, const N: usize, G: Evaluate<T, N>> {
    /// The metric.
    pub g: &'a G,
    formulas: &'a Formulas,
    tables: [Vec<G::Table>; 3],
    faces: Vec<Vector<Jet1<T, N>, N>>,
    hinges: Vec<[Vector<T, N>; 2]>,
}

/// A metric on a cell.
pub(super) struct OnCell<L, T: Real, const N: usize> {
    local: L,
    /// g⁻¹ and det g, where g is constant on the cell.
    everywhere: Option<(Mat<T, N>, T)>,
}

impl<'a, T: Real, const N: usize, G: Evaluate<T, N>> Seen<'a, T, N, G> {
    /// At the sites of rules.
    pub fn new(g: &'a G, sites: &[Sites; 3], formulas: &'a Formulas) -> Self {
        let [_, faces, hinges] = sites;
        let known = "a face belongs to one face of its cell, a hinge to two";
        let pair = |place: usize| {
            let mut nu = hinges.outward(place);
            std::array::from_fn(|_| nu.next().expect(known))
        };
        let one = |place: usize| -> Vector<T, N> { faces.outward(place).next().expect(known) };
        Self {
            g,
            formulas,
            tables: sites.each_ref().map(|sites| sites.tables(g)),
            faces: (0..faces.points.len())
                .map(|place| one(place).map(Jet1::constant))
                .collect(),
            hinges: (0..hinges.points.len()).map(pair).collect(),
        }
    }

    /// Prepares a cell.
    pub fn on_cell(&self, cell: usize) -> OnCell<G::Local, T, N> {
        self.on(self.g.on_cell(cell))
    }

    /// Prepares a cell from the data of a field of the same kind on it.
    pub fn on(&self, local: G::Local) -> OnCell<G::Local, T, N> {
        let constant = self.g.is_constant();
        let inverse = || inverse_and_det(&self.g.value(&local, &self.tables[2][0], 0));
        OnCell {
            everywhere: constant.then(inverse),
            local,
        }
    }

    /// What `of` makes of the metric in the cell at a block of points.
    #[inline]
    pub fn inside<R>(
        &self,
        at: &OnCell<G::Local, T, N>,
        block: usize,
        of: impl FnOnce(&Inside<'_, T, N>, &Connection<T, N>) -> R,
    ) -> R {
        let g = self.g.jet2(&at.local, &self.tables[0][0], block);
        let connection = Connection::new(&lower(&g));
        of(&Inside::new(self.formulas, &g, &connection), &connection)
    }

    /// ω in the cell at a block of points.
    pub fn volume(&self, at: &OnCell<G::Local, T, N>, block: usize) -> T {
        let det = match at.everywhere {
            Some((_, det)) => det,
            None => inverse_and_det(&self.g.value(&at.local, &self.tables[0][0], block)).1,
        };
        omega(self.formulas, det)
    }

    /// What `of` makes of the side that the cell has of its face at this place.
    #[inline]
    pub fn side<R>(
        &self,
        at: &OnCell<G::Local, T, N>,
        place: usize,
        block: usize,
        of: impl FnOnce(&Side<'_, T, N>) -> R,
    ) -> R {
        let g = self.g.jet1(&at.local, &self.tables[1][place], block);
        let connection = Connection::new(&g);
        of(&Side::new(self.formulas, &connection, &self.faces[place]))
    }

    /// What `of` makes of the corner that the cell has at its hinge at this place.
    #[inline]
    pub fn corner<R>(
        &self,
        at: &OnCell<G::Local, T, N>,
        place: usize,
        block: usize,
        of: impl FnOnce(&Corner<'_, T, N>) -> R,
    ) -> R {
        let here;
        let (inverse, det) = match &at.everywhere {
            Some(known) => known,
            None => {
                here = inverse_and_det(&self.g.value(&at.local, &self.tables[2][place], block));
                &here
            }
        };
        let [a, b] = &self.hinges[place];
        of(&Corner::new(self.formulas, inverse, *det, [a, b]))
    }
}
