//! Floor 2. R_h^(q), the projection of the curvature onto Lagrange functions, against R.

use crate::local::{function_components, functions};
use crate::pieces::{euclidean_frame, stretch};
use nalgebra::{DMatrix, DVector};
use regge_curvature::Error;
use regge_curvature::density::omega;
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::functional::{Rules, distributional_curvature, integrate, smooth_curvature};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::inverse_and_det;
use regge_curvature::metrics::{Smooth, SmoothTensor};
use regge_curvature::norm::DualNorm;
use regge_curvature::project::{Projection, Tested};
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::{Connection, Curvature};
use regge_curvature::spaces::{Lagrange, ReggeFunction};

/// R_h of a Regge metric beside the smooth metric that it approximates.
pub struct Projected<'a, M, const N: usize> {
    g: &'a Smooth<M, N>,
    space: Lagrange<N>,
    coefficients: Vec<f64>,
    rules: Rules,
}

impl<'a, M: SmoothTensor<N>, const N: usize> Projected<'a, M, N> {
    /// R_h^(q), by functions that vanish on the boundary.
    ///
    /// # Errors
    /// As [`Projection::new`].
    pub fn new(g: &'a Smooth<M, N>, g_h: &ReggeFunction<f64, N>, q: usize) -> Result<Self, Error> {
        let space = Lagrange::new(g.mesh(), q);
        let rules = Rules::new(N, 2 * (g_h.space().degree() + q) + 6);
        let load = distributional_curvature(g_h, &space, &rules).total();
        let projection = Projection::new(g_h, &space, Tested::Interior, &rules.cells)?;
        Ok(Self {
            g,
            coefficients: projection.apply(&load)?,
            space,
            rules,
        })
    }

    /// ‖R_h − R‖ in a dual norm: of v ↦ ∫ (R_h − R) v ω(g).
    ///
    /// # Errors
    /// Those of the norm.
    pub fn in_dual(&self, norm: &dyn DualNorm<N>) -> Result<f64, Error> {
        let (mesh, rule) = (self.g.mesh(), &self.rules.cells);
        let basis = self.space.basis(N).tabulate::<f64>(rule.points());
        let table = Evaluate::<f64, N>::tabulate(self.g, rule.points());
        let density = |cell: usize, _, point: usize| -> f64 {
            let local = Evaluate::<f64, N>::on_cell(self.g, cell);
            let det = inverse_and_det(&self.g.value(&local, &table, point)).1;
            let dofs = self.space.cell_dofs(cell).zip(&basis[point]);
            let value: f64 = dofs.map(|(dof, b)| self.coefficients[dof] * b).sum();
            value * omega(&PAPER, det)
        };
        let mut load = integrate(norm.space(), N, rule, 0..mesh.cell_count(), density);
        let smooth = smooth_curvature(self.g, norm.space(), &self.rules);
        load.iter_mut().zip(smooth).for_each(|(l, s)| *l -= s);
        Ok(norm.of(&load, None)?.total)
    }

    /// |R_h − R| in the broken H^k, k = 0, 1 or 2, Euclidean: R by the polynomial of degree q + 4 that is nearest on each cell.
    pub fn broken(&self, k: usize) -> f64 {
        let degree = self.space.degree() + 4;
        let rule = Rule::new(N, 2 * degree);
        let fine = functions::<N>(degree, rule.points());
        let coarse = functions::<N>(self.space.degree(), rule.points());
        let fit = nearest(&fine, &rule);
        let mut square = 0.0;
        for cell in 0..self.g.mesh().cell_count() {
            let frame = euclidean_frame(self.g.mesh(), cell);
            let nearest = &fit * DVector::from_vec(self.curvature(cell, &rule));
            let dofs: Vec<usize> = self.space.cell_dofs(cell).collect();
            for (point, weight) in rule.weights().iter().enumerate() {
                let fine = fine[point].iter().zip(nearest.iter().copied());
                let coarse = coarse[point].iter().zip(&dofs);
                let coarse = coarse.map(|(b, dof)| (b, -self.coefficients[*dof]));
                let error = combined(fine.chain(coarse));
                let all = function_components(&error, &frame, k);
                let here: f64 = all.iter().map(|x| x * x).sum();
                square += weight * stretch(self.g.mesh(), cell) * here;
            }
        }
        square.sqrt()
    }

    /// R at the points of a rule.
    fn curvature(&self, cell: usize, rule: &Rule) -> Vec<f64> {
        let table = Evaluate::<f64, N>::tabulate(self.g, rule.points());
        let local = Evaluate::<f64, N>::on_cell(self.g, cell);
        let at = |point| {
            let connection = Connection::new(&self.g.jet1(&local, &table, point));
            Curvature::new(&self.g.jet2(&local, &table, point), &connection).scalar()
        };
        (0..rule.len()).map(at).collect()
    }
}

/// Values at the points of a rule ↦ coefficients of the polynomial that is nearest in L².
fn nearest<const N: usize>(basis: &[Vec<Jet2<f64, N>>], rule: &Rule) -> DMatrix<f64> {
    let (points, len) = (basis.len(), basis[0].len());
    let roots: Vec<f64> = rule.weights().iter().map(|w| w.sqrt()).collect();
    let weighted = DMatrix::from_fn(points, len, |q, i| roots[q] * basis[q][i].value);
    let inverse = weighted.pseudo_inverse(1e-13);
    let inverse = inverse.expect("the tolerance is positive");
    DMatrix::from_fn(len, points, |i, q| inverse[(i, q)] * roots[q])
}

/// Σ c b.
fn combined<'b, const N: usize>(
    all: impl Iterator<Item = (&'b Jet2<f64, N>, f64)>,
) -> Jet2<f64, N> {
    let mut sum = Jet2 {
        value: 0.0,
        d: [0.0; N],
        dd: [[0.0; N]; N],
    };
    for (b, c) in all {
        sum.value += c * b.value;
        for m in 0..N {
            sum.d[m] += c * b.d[m];
            for n in 0..N {
                sum.dd[m][n] += c * b.dd[m][n];
            }
        }
    }
    sum
}
