//! The integrals over cells, faces and hinges that come from div div 𝕊σ by parts.

use super::density::{FaceTerms, HingeTerms, Seen, div_div, outward_of_face};
use super::fields::{Regge, metric, variation};
use super::setting::{Draw, Setting};
use regge::formulas::Formulas;
use regge::functional::{Rules, integrate};
use regge::hypersurface::Normal;
use regge::lagrange::Lagrange;
use regge::linalg::{apply, contract, inverse_and_det};
use regge::regge::ReggeSpace;
use regge::riemann::Connection;
use regge::simplex::Bernstein;

/// A metric and a σ, seen from the cells.
pub struct Pair<'s, const N: usize> {
    space: &'s Lagrange<'s, N>,
    /// On cells, faces and hinges.
    pub rules: Rules,
    /// g.
    pub g: Regge<'s, f64, N>,
    /// σ.
    pub sigma: Regge<'s, f64, N>,
}

impl<'s, const N: usize> Pair<'s, N> {
    /// A random pair.
    pub fn new(
        at: &Setting,
        draw: &mut Draw,
        regge: &'s ReggeSpace<'s, N>,
        space: &'s Lagrange<'s, N>,
    ) -> Self {
        Self {
            space,
            rules: Rules::new::<N>(at.order),
            g: metric(regge, draw),
            sigma: variation(regge, draw),
        }
    }

    /// Σ_T ∫ (div div 𝕊σ) v ω.
    pub fn div_div<K: Formulas>(&self) -> Vec<f64> {
        let rule = &self.rules.element;
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N, rule),
            Seen::<f64, N, _>::new(&self.sigma, N, rule),
        );
        integrate(
            self.space,
            N,
            rule,
            0..self.space.mesh().cells(),
            |_, side, p| div_div::<K, N>(&g.jet2(side, p), &sigma.jet2(side, p)),
        )
    }

    /// Σ_F ∫ ⟦q⟧ v ω_F over the interior faces, or all of them.
    pub fn faces<K: Formulas>(&self, all: bool, q: impl Fn(&FaceTerms) -> f64 + Sync) -> Vec<f64> {
        let (rule, mesh) = (&self.rules.face, self.space.mesh());
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N - 1, rule),
            Seen::<f64, N, _>::new(&self.sigma, N - 1, rule),
        );
        let faces = (0..mesh.count(N - 1)).filter(|&f| all || mesh.is_interior(N - 1, f));
        integrate(self.space, N - 1, rule, faces, |_, side, p| {
            q(&FaceTerms::new::<K, N>(
                &g.jet2(side, p),
                &sigma.jet1(side, p),
                side.place,
            ))
        })
    }

    /// Σ_S ∫ Σ_F ⟦σ(n,τ)⟧ v ω_S over the interior hinges, or all of them.
    pub fn hinges<K: Formulas>(&self, all: bool) -> Vec<f64> {
        let (rule, mesh) = (&self.rules.hinge, self.space.mesh());
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N - 2, rule),
            Seen::<f64, N, _>::new(&self.sigma, N - 2, rule),
        );
        let hinges = (0..mesh.count(N - 2)).filter(|&s| all || mesh.is_interior(N - 2, s));
        integrate(self.space, N - 2, rule, hinges, |_, side, p| {
            HingeTerms::new::<K, N>(&g.value(side, p), &sigma.value(side, p), side.place)
                .normal_conormal
        })
    }

    /// ∫_∂T 𝕊σ(n,∇v) ω_F for every v, of the only cell.
    pub fn normal_gradient<K: Formulas>(&self) -> Vec<f64> {
        let (rule, basis) = (&self.rules.face, Bernstein::new(N + 1, self.space.degree()));
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N - 1, rule),
            Seen::<f64, N, _>::new(&self.sigma, N - 1, rule),
        );
        let dofs: Vec<usize> = self.space.cell_dofs(0).collect();
        let mut sum = vec![0.0; self.space.len()];
        for (place, points) in super::density::points_of::<N>(N - 1, rule)
            .iter()
            .enumerate()
        {
            let table = basis.tabulate_jets::<f64, N>(points);
            let side = regge::mesh::Side { cell: 0, place };
            for (q, w) in rule.weights().iter().enumerate() {
                let (inverse, det) = inverse_and_det(&g.value(side, q));
                let normal = Normal::new(&inverse, &outward_of_face(place));
                let s = K::reverse_trace(&g.value(side, q), &inverse, &sigma.value(side, q));
                // 𝕊σ(n, ·) raised.
                let flux = apply(&inverse, &apply(&s, &normal.n));
                for (dof, v) in dofs.iter().zip(&table[q]) {
                    let dv = regge::linalg::Vector::from_fn(|m, _| v.d[m]);
                    sum[*dof] += contract(&dv, &flux) * normal.length * det.sqrt() * w;
                }
            }
        }
        sum
    }

    /// −∫_T (div 𝕊σ)(∇v) ω for every v, of the only cell.
    pub fn div_gradient<K: Formulas>(&self) -> Vec<f64> {
        let rule = &self.rules.element;
        let table =
            Bernstein::new(N + 1, self.space.degree()).tabulate_jets::<f64, N>(rule.points());
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N, rule),
            Seen::<f64, N, _>::new(&self.sigma, N, rule),
        );
        let side = self.space.mesh().first_side(N, 0);
        let dofs: Vec<usize> = self.space.cell_dofs(0).collect();
        let mut sum = vec![0.0; self.space.len()];
        for (q, w) in rule.weights().iter().enumerate() {
            let around = Connection::new(&g.jet2(side, q));
            let s = K::reverse_trace(&around.g, &around.inverse, &sigma.jet1(side, q));
            let at = around.lower();
            let flux = at.sharp(&at.div_tensor(&s));
            for (dof, v) in dofs.iter().zip(&table[q]) {
                let dv = regge::linalg::Vector::from_fn(|m, _| v.d[m]);
                sum[*dof] -= contract(&dv, &flux) * at.det.sqrt() * w;
            }
        }
        sum
    }
}
