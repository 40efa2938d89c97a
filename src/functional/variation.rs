//! The first variation of the curvature in the metric, and its transpose. Paper: thm:distcurvdot.
//!
//! d/dt ⟨(Rω)_dist(g + tσ), v⟩ = b_h(g; σ, v) − a_h(g; σ, v) is bilinear in σ and v. [`variation`] is it for one σ and every v,
//! [`variation_adjoint`] for one v and every Regge function σ, at the price of one evaluation and without a record of it.
//!
//! The theorem is for v that vanish on the boundary. Its proof integrates by parts on each cell, so that the terms on the
//! boundary are those of any face and hinge, seen from one side: with the terms of Gauss and Bonnet it holds for every v.

use super::einstein::{Against, EdgeComponents, boundary_a_h};
use super::measure::{Density, Where, full_angle};
use super::seen::{OnCell, Seen, Sites, all_sites};
use super::walk::pair;
use super::{Rules, Sums, a_h, b_h};
use crate::field::{Evaluate, TensorField};
use crate::formulas::{Formulas, times};
use crate::jet::Jet1;
use crate::linalg::{contract, double_contract, sandwich};
use crate::riemann::differential;
use crate::scalar::Real;
use crate::simplex::{Derivatives, JetTable};
use crate::spaces::{Lagrange, ReggeSpace, Symmetric};

/// b_h(g; σ, v) − a_h(g; σ, v) for every v of a Lagrange space.
///
/// It is d/dt of [`distributional_curvature`](super::distributional_curvature) at g + tσ for v that vanish on the boundary, up
/// to quadrature. With `boundary` a_h has the faces and hinges of the boundary too, with π − Σ_T θ_ST for Θ_S, and it is the
/// derivative with [`boundary_curvature`](super::boundary_curvature) added, for every v. Paper: thm:distcurvdot.
pub fn variation<const N: usize, G: TensorField<N>, H: Evaluate<G::Wide, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    boundary: bool,
    rules: &Rules,
) -> Sums<G::Scalar> {
    let mut sums = b_h(g, sigma, space, rules);
    let subtract = |from: &mut Sums<G::Scalar>, a: Sums<G::Scalar>| {
        for (list, a) in [
            (&mut from.cells, a.cells),
            (&mut from.faces, a.faces),
            (&mut from.hinges, a.hinges),
        ] {
            list.iter_mut().zip(a).for_each(|(b, a)| *b -= a);
        }
    };
    subtract(&mut sums, a_h(g, sigma, space, rules));
    if boundary {
        subtract(&mut sums, boundary_a_h(g, sigma, space, rules));
    }
    sums
}

/// b_h(g; ψ_i, v) − a_h(g; ψ_i, v) for every basis function ψ_i of a Regge space and one v = Σ_j w_j v_j.
///
/// The transpose of [`variation`]: Σ_i c_i times it is Σ_j w_j times that for σ = Σ_i c_i ψ_i, to rounding. `boundary` is as
/// there. Paper: thm:distcurvdot.
///
/// # Panics
/// If there is not a weight w_j for each function v_j.
pub fn variation_adjoint<const N: usize, G: TensorField<N>>(
    g: &G,
    weights: &[f64],
    tests: &Lagrange<N>,
    space: &ReggeSpace<N>,
    boundary: bool,
    rules: &Rules,
) -> Sums<G::Scalar> {
    assert_eq!(weights.len(), tests.len(), "weights of another space");
    let v = One {
        weights,
        tests,
        derivatives: Derivatives::new(tests.degree()),
    };
    let mut sums = adjoint::<G::Wide, N, G>(g, &v, space, Where::Interior, boundary, rules);
    let outer = adjoint::<G::Wide, N, G>(g, &v, space, Where::Boundary, boundary, rules);
    for (list, outer) in [
        (&mut sums.faces, outer.faces),
        (&mut sums.hinges, outer.hinges),
    ] {
        list.iter_mut().zip(outer).for_each(|(sum, x)| *sum += x);
    }
    sums
}

/// One test function v.
struct One<'a, const N: usize> {
    weights: &'a [f64],
    tests: &'a Lagrange<N>,
    derivatives: Derivatives<N>,
}

impl<const N: usize> One<'_, N> {
    /// Tables for v's jets, by place.
    fn tables<T: Real>(&self, sites: &Sites) -> Vec<JetTable<T, N>> {
        let (degree, points) = (self.tests.degree(), sites.points.iter());
        points.map(|points| JetTable::new(degree, points)).collect()
    }
}

fn adjoint<T: Real, const N: usize, G: Evaluate<T, N>>(
    g: &G,
    v: &One<'_, N>,
    space: &ReggeSpace<N>,
    on: Where,
    boundary: bool,
    rules: &Rules,
) -> Sums<T::Sum> {
    let (formulas, sites) = (&rules.formulas, all_sites(N, rules));
    let seen = Seen::<T, N, G>::new(g, &sites, formulas);
    let curves = v.tests.degree() > 1 || !g.is_constant();
    let density = Variation {
        seen,
        directions: EdgeComponents::new(&sites),
        tables: sites.each_ref().map(|sites| v.tables(sites)),
        v,
        formulas,
        full_angle: full_angle(formulas, on),
        with_b: on == Where::Interior || formulas.b_on_boundary,
        with_a: on == Where::Interior || boundary,
        inside: on == Where::Interior && curves,
    };
    let mut sums = pair(space.mesh(), &density, on, &[space], rules);
    sums.pop().expect("one space, one result")
}

/// What b_h − a_h has in the directions of the Regge functions, for one v.
struct Variation<'a, T: Real, const N: usize, G: Evaluate<T, N>> {
    seen: Seen<'a, T, N, G>,
    directions: EdgeComponents<T, N>,
    v: &'a One<'a, N>,
    /// For v's jets, by codimension and place.
    tables: [Vec<JetTable<T, N>>; 3],
    formulas: &'a Formulas,
    full_angle: T,
    /// Which of the forms there are on faces and hinges.
    with_b: bool,
    with_a: bool,
    /// Is there anything in cells?
    inside: bool,
}

impl<T, const N: usize, G> Density<T, N> for Variation<'_, T, N, G>
where
    T: Real,
    G: Evaluate<T, N>,
{
    type Value = Symmetric;
    /// g, and the coefficients of v on the cell with those of its derivatives.
    type Local = (OnCell<G::Local, T, N>, Vec<f64>);

    fn sums(&self) -> [bool; 3] {
        [self.inside, true, self.with_a]
    }

    fn is_constant_on_hinges(&self) -> bool {
        false
    }

    fn full_angle(&self) -> T {
        self.full_angle
    }

    fn on_cell(&self, cell: usize) -> Self::Local {
        let dofs = self.v.tests.cell_dofs(cell);
        let local: Vec<f64> = dofs.map(|dof| self.v.weights[dof]).collect();
        let local = self.v.derivatives.follow(1, &local);
        (self.seen.on_cell(cell), local)
    }

    /// (⟨𝕊ψ, ∇∇v⟩ − ⟨G, ψ⟩ v) ω.
    fn in_cell(&self, (g, v): &Self::Local, block: usize, out: &mut [T]) {
        let v = self.tables[0][0].jet2(block, v);
        self.seen.inside(g, block, |inside, connection| {
            let (einstein, omega) = inside.einstein();
            let hessian = sandwich(&connection.inverse, &connection.hessian(&v));
            let b = times(self.formulas.b_cells, omega);
            let a = times(self.formulas.a_cells, omega * v.value);
            let mut out = out.iter_mut();
            self.directions.each(&(), 0, 0, block, |psi| {
                let reversed = connection.reverse_trace(self.formulas, psi);
                *out.next().expect("a number for each tensor") =
                    double_contract(&hessian, &reversed) * b - connection.inner(&einstein, psi) * a;
            });
        });
    }

    /// (−𝕊ψ(n,n) ∇_n v − ⟨II‾, ψ⟩ v) ω_F.
    fn on_face(&self, (g, v): &Self::Local, place: usize, block: usize, out: &mut [T]) {
        let v = self.tables[1][place].jet1(block, v);
        self.seen.side(g, place, block, |side| {
            let dv = differential::<Jet1<T, N>, N>(&v);
            let slope = contract(&dv, &side.normal.n);
            let if_wanted = |wanted, factor| if wanted { factor } else { 0 };
            let b = times(if_wanted(self.with_b, self.formulas.b_faces), slope);
            let a = times(if_wanted(self.with_a, self.formulas.a_faces), v.value);
            let (b, a) = (side.normal.omega * b, side.normal.omega * a);
            let curved = side.trace_reversed();
            let mut out = out.iter_mut();
            self.directions.each(&(), 1, place, block, |psi| {
                let reversed = side.reverse_trace(psi);
                *out.next().expect("a number for each tensor") =
                    side.normal.normal_normal(&reversed) * b - side.normal.inner(&curved, psi) * a;
            });
        });
    }

    /// +Θ_S Tr(ψ|_S) v ω_S.
    fn at_hinge(
        &self,
        (g, v): &Self::Local,
        place: usize,
        block: usize,
        factors: Option<&mut [T]>,
    ) -> T {
        self.seen.corner(g, place, block, |corner| {
            if let Some(factors) = factors {
                let v = self.tables[2][place].value(block, v);
                let factor = times(-self.formulas.a_hinges, corner.omega() * v);
                let mut factors = factors.iter_mut();
                self.directions.each(&(), 2, place, block, |psi| {
                    *factors.next().expect("a number for each tensor") = corner.trace(psi) * factor;
                });
            }
            corner.angle()
        })
    }
}
