//! A metric and a σ on a mesh, and what the right sides are made of: integrals over cells, faces and hinges.

use super::sums::{Three, values};
use super::terms::{FaceTerms, HingeTerms, div_div, outward_of_face};
use crate::harness::{Draw, Setting};
use crate::stage::fields::{Regge, Seen, integral, points_of, variation, wild};
use regge_curvature::density::{Normal, omega};
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Rules, a_h, b_h};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Vector, apply, contract, inverse_and_det};
use regge_curvature::mesh::Side;
use regge_curvature::riemann::{Connection, reverse_trace};
use regge_curvature::simplex::Bernstein;
use regge_curvature::spaces::{Lagrange, ReggeSpace};

/// A metric and a σ, seen from the cells.
pub struct Pair<const N: usize> {
    /// The test functions.
    pub space: Lagrange<N>,
    /// On cells, faces and hinges.
    pub rules: Rules,
    /// g.
    pub g: Regge<f64, N>,
    /// σ.
    pub sigma: Regge<f64, N>,
    /// By which formulas the library computes.
    pub formulas: Formulas,
}

/// The spaces of a case: Regge's and Lagrange's.
pub fn spaces<const N: usize>(at: &Setting) -> (ReggeSpace<N>, Lagrange<N>) {
    let mesh = at.shape.mesh::<N>();
    (
        ReggeSpace::new(&mesh, at.degree),
        Lagrange::new(&mesh, at.test),
    )
}

/// Which faces or hinges of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Where {
    /// Those inside.
    Interior,
    /// All of them.
    Everywhere,
}

impl<const N: usize> Pair<N> {
    /// A random pair of a case.
    pub fn draw(at: &Setting, draw: &mut Draw) -> Self {
        let (regge, space) = spaces(at);
        let (g, sigma) = (wild(&regge, draw, at.noise), variation(&regge, draw));
        Self::new(at, space, g, sigma)
    }

    /// This pair, with rules of the case's order.
    pub fn new(at: &Setting, space: Lagrange<N>, g: Regge<f64, N>, sigma: Regge<f64, N>) -> Self {
        Self {
            space,
            rules: at.rules(N),
            g,
            sigma,
            formulas: at.formulas,
        }
    }

    fn chosen(&self, k: usize, on: Where) -> impl Iterator<Item = usize> + '_ {
        let mesh = self.space.mesh();
        (0..mesh.count(k)).filter(move |&s| on == Where::Everywhere || mesh.is_interior(k, s))
    }

    /// b_h(g; σ, v).
    pub fn b(&self) -> Three {
        self.b_by(self.formulas)
    }

    /// The same by other formulas: wrong, for forgeries.
    pub fn b_by(&self, formulas: Formulas) -> Three {
        let rules = self.rules.clone().with_formulas(formulas);
        values(b_h(&self.g, &self.sigma, &self.space, &rules))
    }

    /// a_h(g; σ, v).
    pub fn a(&self) -> Three {
        self.a_by(self.formulas)
    }

    /// The same by other formulas: wrong, for forgeries.
    pub fn a_by(&self, formulas: Formulas) -> Three {
        let rules = self.rules.clone().with_formulas(formulas);
        values(a_h(&self.g, &self.sigma, &self.space, &rules))
    }

    /// Σ_T ∫ (div div 𝕊σ) v ω.
    pub fn div_div(&self) -> Vec<f64> {
        let rule = &self.rules.cells;
        let g = Seen::<f64, N, _>::new(&self.g, N, rule);
        let sigma = Seen::<f64, N, _>::new(&self.sigma, N, rule);
        let mut cells = 0..self.space.mesh().cell_count();
        integral(&self.space, N, rule, &mut cells, &|_, side, p| {
            div_div::<N>(&self.formulas, &g.jet2(side, p), &sigma.jet2(side, p))
        })
    }

    /// Σ_F ∫ ⟦q⟧ v ω_F.
    pub fn faces(&self, on: Where, q: fn(&FaceTerms) -> f64) -> Vec<f64> {
        self.signed_faces(on, 1.0, q)
    }

    /// The same with a difference in the place of the sum of both sides: wrong.
    pub fn differences(&self, q: fn(&FaceTerms) -> f64) -> Vec<f64> {
        self.signed_faces(Where::Interior, -1.0, q)
    }

    fn signed_faces(&self, on: Where, second: f64, q: fn(&FaceTerms) -> f64) -> Vec<f64> {
        let (rule, mesh) = (&self.rules.faces, self.space.mesh());
        let g = Seen::<f64, N, _>::new(&self.g, N - 1, rule);
        let sigma = Seen::<f64, N, _>::new(&self.sigma, N - 1, rule);
        let mut faces = self.chosen(N - 1, on);
        integral(&self.space, N - 1, rule, &mut faces, &|face, side, p| {
            let (g, sigma) = (g.jet2(side, p), sigma.jet1(side, p));
            let terms = FaceTerms::new::<N>(&self.formulas, &g, &sigma, side.place);
            let first = mesh.first_side(N - 1, face) == side;
            if first { q(&terms) } else { second * q(&terms) }
        })
    }

    /// Σ_S Σ_T ∫ q v: q as each cell sees it.
    pub fn hinges(&self, on: Where, q: fn(&HingeTerms<f64>) -> f64) -> Vec<f64> {
        let rule = &self.rules.hinges;
        let g = Seen::<f64, N, _>::new(&self.g, N - 2, rule);
        let sigma = Seen::<f64, N, _>::new(&self.sigma, N - 2, rule);
        let mut hinges = self.chosen(N - 2, on);
        integral(&self.space, N - 2, rule, &mut hinges, &|_, side, p| {
            let (g, sigma) = (g.value(side, p), sigma.value(side, p));
            q(&HingeTerms::new::<N>(
                &self.formulas,
                &g,
                &sigma,
                side.place,
            ))
        })
    }

    /// Σ_S ∫ Σ_F ⟦σ(n,τ)⟧ v ω_S.
    pub fn turned(&self, on: Where) -> Vec<f64> {
        self.hinges(on, |q| q.normal_conormal)
    }

    /// ∫_∂T 𝕊σ(n,∇v) ω_F for every v, of the only cell.
    pub fn normal_gradient(&self) -> Vec<f64> {
        let rule = &self.rules.faces;
        let basis = Bernstein::new(N + 1, self.space.degree());
        let g = Seen::<f64, N, _>::new(&self.g, N - 1, rule);
        let sigma = Seen::<f64, N, _>::new(&self.sigma, N - 1, rule);
        let mut sum = vec![0.0; self.space.len()];
        let on_faces = points_of::<N>(N - 1, rule);
        for (place, points) in on_faces.iter().enumerate() {
            let table = basis.tabulate_jets::<f64, N>(points);
            let side = Side { cell: 0, place };
            for (q, w) in rule.weights().iter().enumerate() {
                let (g, sigma) = (g.value(side, q), sigma.value(side, q));
                let (inverse, det) = inverse_and_det(&g);
                let normal = Normal::new(&self.formulas, &inverse, det, &outward_of_face(place));
                let s = reverse_trace(&self.formulas, &g, &inverse, &sigma);
                // 𝕊σ(n, ·) raised.
                let flux = apply(&inverse, &apply(&s, &normal.n));
                let weight = normal.omega * w;
                self.against_gradients(&mut sum, &table[q], &flux.map(|x| x * weight));
            }
        }
        sum
    }

    /// −∫_T (div 𝕊σ)(∇v) ω for every v, of the only cell.
    pub fn div_gradient(&self) -> Vec<f64> {
        let rule = &self.rules.cells;
        let basis = Bernstein::new(N + 1, self.space.degree());
        let table = basis.tabulate_jets::<f64, N>(rule.points());
        let g = Seen::<f64, N, _>::new(&self.g, N, rule);
        let sigma = Seen::<f64, N, _>::new(&self.sigma, N, rule);
        let side = self.space.mesh().first_side(N, 0);
        let mut sum = vec![0.0; self.space.len()];
        for (q, w) in rule.weights().iter().enumerate() {
            let around = Connection::new(&g.jet2(side, q));
            let s = around.reverse_trace(&self.formulas, &sigma.jet1(side, q));
            let at = around.lower();
            let weight = -omega(&self.formulas, at.det) * w;
            let flux = at.sharp(&at.div_tensor(&s)).map(|x| x * weight);
            self.against_gradients(&mut sum, &table[q], &flux);
        }
        sum
    }

    /// Adds dv(flux) for every v of the only cell.
    fn against_gradients(&self, sum: &mut [f64], row: &[Jet2<f64, N>], flux: &Vector<f64, N>) {
        for (dof, v) in self.space.cell_dofs(0).zip(row) {
            sum[dof] += contract(&Vector::from_fn(|m, _| v.d[m]), flux);
        }
    }
}
