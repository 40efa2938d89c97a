//! Floor 2. The norms of section 4 as quadratic forms on V_h and on Regge spaces.

use crate::best::Form;
use crate::local::{
    Functions, Gram, frame_of, function_components, functions, push_components, tensor_components,
    tensors,
};
use crate::pieces::{Pieces, Unknowns, diameter, stretch};
use regge_curvature::Error;
use regge_curvature::density::{Normal, omega, outward};
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, Vector, contract, inverse_and_det};
use regge_curvature::mesh::Side;
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::{Connection, differential, reverse_trace};
use regge_curvature::simplex::{Points, subsets};
use std::borrow::Cow;

/// Terms Σ_T h_T^power |·|²_{H^order(T)}.
pub type Terms<'a> = &'a [(usize, i32)];

/// Σ_T h_T^power |σ|²_{H^order(T)}, Euclidean, over the σ of these unknowns.
///
/// # Errors
/// As [`tensors`].
pub fn of_tensors<const N: usize>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    terms: Terms<'_>,
) -> Result<Form, Error> {
    let rule = Rule::new(N, 2 * u.tensors.degree());
    let basis = tensors(&pieces.regge_apart(u.tensors.degree()), rule.points())?;
    let mut form = Form::zero(u.len());
    for cell in 0..pieces.mesh.cell_count() {
        let (frame, h) = (pieces.euclidean_frame(cell), pieces.diameter(cell));
        let volume = stretch(&pieces.mesh, cell);
        let mut gram = Gram::new(basis[0].len());
        for (point, weight) in rule.weights().iter().enumerate() {
            for &(order, power) in terms
                .iter()
                .filter(|(order, _)| *order <= u.tensors.degree())
            {
                let of = |psi| tensor_components(psi, &frame, order);
                let all: Vec<_> = basis[point].iter().map(of).collect();
                gram.add(weight * volume * h.powi(power), &all);
            }
        }
        form.add(&u.of_tensors(cell), &gram.matrix());
    }
    Ok(form)
}

/// Σ_T h_T^power |v|²_{H^order(T)}, Euclidean, over the v of these unknowns.
pub fn of_functions<const N: usize>(pieces: &Pieces<N>, u: &Unknowns<N>, terms: Terms<'_>) -> Form {
    let rule = Rule::new(N, 2 * u.functions.degree());
    let basis = functions(u.functions.degree(), rule.points());
    let mut form = Form::zero(u.len());
    for cell in 0..pieces.mesh.cell_count() {
        let (frame, h) = (pieces.euclidean_frame(cell), pieces.diameter(cell));
        let volume = stretch(&pieces.mesh, cell);
        let mut gram = Gram::new(basis[0].len());
        for (point, weight) in rule.weights().iter().enumerate() {
            for &(order, power) in terms {
                let of = |v| function_components(v, &frame, order);
                let all: Vec<_> = basis[point].iter().map(of).collect();
                gram.add(weight * volume * h.powi(power), &all);
            }
        }
        form.add(&u.of_functions(cell), &gram.matrix());
    }
    form
}

/// Which faces a norm of section 4 sums over, and with which power of h_F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faces {
    /// Those inside.
    pub interior: bool,
    /// Those of the boundary.
    pub boundary: bool,
    /// The power of h_F.
    pub power: i32,
}

impl Faces {
    /// All, with this power.
    pub const fn all(power: i32) -> Self {
        Self {
            interior: true,
            boundary: true,
            power,
        }
    }

    fn has(&self, interior: bool) -> bool {
        if interior {
            self.interior
        } else {
            self.boundary
        }
    }
}

/// The rules of cells and faces: of one order, so that the inequality of Cauchy and Schwarz for b_h, whose points have the same
/// positive weights, holds for the sums as it does for the integrals.
fn rules<const N: usize>(order: usize) -> [Rule; 2] {
    [Rule::new(N, order), Rule::new(N - 1, order)]
}

/// ‖𝕊_g σ‖²_{0,h,g} over the σ of these unknowns; the paper's with [`Faces::all`]`(1)`.
///
/// # Errors
/// As [`tensors`], and if g is not positive definite.
pub fn zero_norm<const N: usize, G: Evaluate<f64, N>>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    g: &G,
    faces: Faces,
    order: usize,
) -> Result<Form, Error> {
    let [cells, sides] = rules::<N>(order);
    let apart = pieces.regge_apart(u.tensors.degree());
    let (basis, table) = (tensors(&apart, cells.points())?, g.tabulate(cells.points()));
    let mut form = Form::zero(u.len());
    for cell in 0..pieces.mesh.cell_count() {
        let (local, mut gram) = (g.on_cell(cell), Gram::new(basis[0].len()));
        for (point, weight) in cells.weights().iter().enumerate() {
            let g = g.value(&local, &table, point);
            let (inverse, det) = inverse_and_det(&g);
            let frame = frame_of(&g).ok_or_else(indefinite)?;
            let of = |psi: &Mat<_, N>| {
                let mut all = Vec::new();
                let value = psi.map(|x: Jet2<f64, N>| x.value);
                push_components(
                    &reverse_trace(&PAPER, &g, &inverse, &value),
                    &frame,
                    &mut all,
                );
                all
            };
            let all: Vec<_> = basis[point].iter().map(of).collect();
            gram.add(weight * omega(&PAPER, det), &all);
        }
        form.add(&u.of_tensors(cell), &gram.matrix());
    }
    add_normal_components(pieces, u, g, faces, &sides, &mut form)?;
    Ok(form)
}

/// Adds Σ_F h_F^power ‖𝕊σ(n,n)‖².
fn add_normal_components<const N: usize, G: Evaluate<f64, N>>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    g: &G,
    faces: Faces,
    sides: &Rule,
    form: &mut Form,
) -> Result<(), Error> {
    let apart = pieces.regge_apart(u.tensors.degree());
    for (place, vertices) in subsets(N + 1, N).iter().enumerate() {
        let points = sides.points().embed(vertices, N + 1);
        let (basis, table) = (tensors(&apart, &points)?, g.tabulate(&points));
        for face in 0..pieces.mesh.count(N - 1) {
            let side = pieces.mesh.first_side(N - 1, face);
            if side.place != place || !faces.has(pieces.mesh.is_interior(N - 1, face)) {
                continue;
            }
            let (local, mut gram) = (g.on_cell(side.cell), Gram::new(basis[0].len()));
            let h = diameter(&pieces.mesh, side.cell, vertices).powi(faces.power);
            for (point, weight) in sides.weights().iter().enumerate() {
                let g = g.value(&local, &table, point);
                let (inverse, det) = inverse_and_det(&g);
                let normal = Normal::new(&PAPER, &inverse, det, &outward(N - place));
                let of = |psi: &Mat<_, N>| {
                    let value = psi.map(|x: Jet2<f64, N>| x.value);
                    vec![normal.normal_normal(&reverse_trace(&PAPER, &g, &inverse, &value))]
                };
                let all: Vec<_> = basis[point].iter().map(of).collect();
                gram.add(weight * normal.omega * h, &all);
            }
            form.add(&u.of_tensors(side.cell), &gram.matrix());
        }
    }
    Ok(())
}

fn indefinite() -> Error {
    Error::Solver("a metric of the analysis is not positive definite".into())
}

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
