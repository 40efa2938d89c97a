//! ‖·‖_{2,h,g}.

use super::{Faces, indefinite, rules};
use crate::best::Form;
use crate::local::{Functions, Gram, frame_of, functions, push_components};
use crate::pieces::{Pieces, Unknowns, diameter};
use regge_curvature::Error;
use regge_curvature::density::{Normal, omega, outward};
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Vector, contract, inverse_and_det};
use regge_curvature::mesh::Side;
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::{Connection, differential};
use regge_curvature::simplex::{Points, subsets};
use std::borrow::Cow;

/// Functions on a mesh, cell by cell.
pub trait Basis<const N: usize> {
    /// What is prepared from points alone.
    type Table;

    /// How many unknowns there are.
    fn size(&self) -> usize;
    /// Those of the functions on a cell.
    fn on(&self, cell: usize) -> Vec<usize>;
    /// Prepares points.
    fn table(&self, points: &Points) -> Self::Table;
    /// The functions on a cell at a point, in the order of the unknowns, in reference coordinates.
    fn jets<'t>(
        &self,
        cell: usize,
        table: &'t Self::Table,
        point: usize,
    ) -> Cow<'t, [Jet2<f64, N>]>;
}

impl<const N: usize> Basis<N> for Unknowns<N> {
    type Table = Functions<N>;

    fn size(&self) -> usize {
        self.len()
    }

    fn on(&self, cell: usize) -> Vec<usize> {
        self.of_functions(cell)
    }

    fn table(&self, points: &Points) -> Functions<N> {
        functions(self.functions.degree(), points)
    }

    fn jets<'t>(&self, _: usize, table: &'t Functions<N>, point: usize) -> Cow<'t, [Jet2<f64, N>]> {
        Cow::Borrowed(&table[point])
    }
}

/// ‖v‖²_{2,h,g} over the v of a basis; the paper's with [`Faces::all`]`(-1)`.
///
/// # Errors
/// If g is not positive definite.
pub fn two_norm<const N: usize, G: Evaluate<f64, N>, B: Basis<N>>(
    pieces: &Pieces<N>,
    u: &B,
    g: &G,
    faces: Faces,
    order: usize,
) -> Result<Form, Error> {
    let [cells, sides] = rules::<N>(order);
    let (basis, table) = (u.table(cells.points()), g.tabulate(cells.points()));
    let mut form = Form::zero(u.size());
    for cell in 0..pieces.mesh.cell_count() {
        let (local, unknowns) = (g.on_cell(cell), u.on(cell));
        let mut gram = Gram::new(unknowns.len());
        for (point, weight) in cells.weights().iter().enumerate() {
            let connection = Connection::new(&g.jet1(&local, &table, point));
            let frame = frame_of(&connection.g).ok_or_else(indefinite)?;
            let of = |v| {
                let mut all = Vec::new();
                push_components(&connection.hessian(v), &frame, &mut all);
                all
            };
            let all: Vec<_> = u.jets(cell, &basis, point).iter().map(of).collect();
            gram.add(weight * omega(&PAPER, connection.det), &all);
        }
        form.add(&unknowns, &gram.matrix());
    }
    let slopes = Slopes::new(g, u, &sides);
    for face in 0..pieces.mesh.count(N - 1) {
        if faces.has(pieces.mesh.is_interior(N - 1, face)) {
            slopes.add_jump(pieces, face, faces.power, &mut form);
        }
    }
    Ok(form)
}

/// dv(n_g) on the sides of faces.
struct Slopes<'a, const N: usize, G: Evaluate<f64, N>, B: Basis<N>> {
    g: &'a G,
    u: &'a B,
    rule: &'a Rule,
    /// By place.
    tables: Vec<G::Table>,
    bases: Vec<B::Table>,
    vertices: Vec<Vec<usize>>,
}

impl<'a, const N: usize, G: Evaluate<f64, N>, B: Basis<N>> Slopes<'a, N, G, B> {
    fn new(g: &'a G, u: &'a B, rule: &'a Rule) -> Self {
        let vertices = subsets(N + 1, N);
        let points: Vec<_> = vertices
            .iter()
            .map(|on| rule.points().embed(on, N + 1))
            .collect();
        Self {
            g,
            rule,
            tables: points.iter().map(|points| g.tabulate(points)).collect(),
            bases: points.iter().map(|points| u.table(points)).collect(),
            u,
            vertices,
        }
    }

    /// dv(n) of each function of the side's cell at a point, and ω_F.
    fn slopes(&self, side: Side, local: &G::Local, point: usize) -> (Vec<f64>, f64) {
        let g = self.g.value(local, &self.tables[side.place], point);
        let (inverse, det) = inverse_and_det(&g);
        let normal = Normal::new(&PAPER, &inverse, det, &outward(N - side.place));
        let slope = |v: &Jet2<f64, N>| {
            let dv: Vector<f64, N> =
                differential(v).map(|x: regge_curvature::jet::Jet1<f64, N>| x.value);
            contract(&dv, &normal.n)
        };
        let jets = self.u.jets(side.cell, &self.bases[side.place], point);
        (jets.iter().map(slope).collect(), normal.omega)
    }

    /// Adds h_F^power ‖⟦dv(n)⟧‖² on a face.
    fn add_jump(&self, pieces: &Pieces<N>, face: usize, power: i32, form: &mut Form) {
        let sides: Vec<Side> = pieces.mesh.star(N - 1, face).collect();
        let locals: Vec<G::Local> = sides.iter().map(|side| self.g.on_cell(side.cell)).collect();
        let unknowns: Vec<usize> = sides.iter().flat_map(|side| self.u.on(side.cell)).collect();
        let (first, mut gram) = (sides[0], Gram::new(unknowns.len()));
        let h = diameter(&pieces.mesh, first.cell, &self.vertices[first.place]).powi(power);
        for (point, weight) in self.rule.weights().iter().enumerate() {
            let mut all = Vec::new();
            let mut omega_f = 0.0;
            for (side, local) in sides.iter().zip(&locals) {
                let (slopes, omega) = self.slopes(*side, local, point);
                all.extend(slopes.into_iter().map(|x| vec![x]));
                omega_f = omega;
            }
            gram.add(weight * omega_f * h, &all);
        }
        form.add(&unknowns, &gram.matrix());
    }
}
