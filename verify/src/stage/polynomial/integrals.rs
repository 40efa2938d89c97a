//! Densities at points, and their exact integrals over cells, faces and hinges.

use super::fields::{Domain, Fields, Point};
use crate::exact::on_simplex;
use crate::harness::{Ground, others};
use crate::stage::point::Face;
use regge_curvature::density::{Corner, Normal, omega, outward, surface_div};
use regge_curvature::formulas::Formulas;
use regge_curvature::jet::{Jet, Jet1, lower, lower_vector};
use regge_curvature::linalg::{apply, contract, form};
use regge_curvature::riemann::{differential, reverse_trace};

/// What is integrated over a cell.
struct OnCell<F> {
    div_div: F,
    hessian: F,
    div_gradient: F,
}

/// What is integrated over a face, ω_F included, as one cell sees it.
pub struct OnFace<F> {
    /// (div 𝕊σ)(n) v.
    pub div_s: F,
    /// div_F(σ(n,·)) v.
    pub div_f: F,
    /// div_F(vσ(n,·)).
    pub div_f_v: F,
    /// Hσ(n,n) v.
    pub h_nn: F,
    /// 𝕊σ(n,n).
    pub s_nn: F,
    /// ∇_n v ω_F.
    pub along_n: F,
    /// 𝕊σ(n,∇v).
    pub gradient: F,
}

/// One draw on one domain.
pub struct Exactly<F: Ground, const N: usize> {
    fields: Fields<F, N>,
    domain: Domain<F, N>,
    formulas: Formulas,
}

impl<F: Ground, const N: usize> Exactly<F, N> {
    /// On one simplex.
    pub fn on_single(numbers: &[F], formulas: &Formulas) -> Self {
        Self::new(numbers, formulas, Domain::single())
    }

    /// On a simplex cut at an inner point.
    pub fn on_cut(numbers: &[F], formulas: &Formulas) -> Self {
        Self::new(numbers, formulas, Domain::cut())
    }

    fn new(numbers: &[F], formulas: &Formulas, domain: Domain<F, N>) -> Self {
        let numbers = numbers.to_vec();
        Self {
            fields: Fields { numbers },
            domain,
            formulas: *formulas,
        }
    }

    /// How many cells the domain has.
    pub fn cell_count(&self) -> usize {
        self.domain.cells.len()
    }

    fn point(&self, cell: usize, vertices: &[usize], lambda: &[F]) -> Point<F, N> {
        self.fields.at(&self.domain, cell, vertices, lambda)
    }

    fn cell(&self, cell: usize, lambda: &[F]) -> OnCell<F> {
        let all: Vec<usize> = (0..=N).collect();
        let p = self.point(cell, &all, lambda);
        let base = p.still.lower();
        let omega = omega(&self.formulas, base.det);
        let s_sigma = reverse_trace(&self.formulas, &p.g, &p.inverse, &p.sigma);
        let flux = base.sharp(&base.div_tensor(&lower(&s_sigma)));
        let dv = lower_vector(&differential(&p.v));
        OnCell {
            div_div: omega * p.still.div_div(&s_sigma) * p.v.value,
            hessian: omega * base.inner(&lower(&lower(&s_sigma)), &base.hessian(&p.v)),
            div_gradient: omega * contract(&dv, &flux),
        }
    }

    /// What is integrated over the face of a cell opposite to a vertex, at a point of it.
    pub fn face(&self, cell: usize, opposite: usize, lambda: &[F]) -> OnFace<F> {
        let vertices = others(N + 1, &[opposite]);
        let p = self.point(cell, &vertices, lambda);
        let (base, nu) = (p.still.lower(), outward::<Jet1<F, N>, N>(opposite));
        let face = Face::new(&self.formulas, &base, &nu);
        let (sigma, n, omega) = (lower(&p.sigma), face.normal.n, face.normal.omega);
        let s_sigma = p.still.reverse_trace(&self.formulas, &sigma);
        let s_value = lower(&s_sigma);
        let around = Normal::new(&self.formulas, &p.still.inverse, p.still.det, &nu);
        let flux = apply(&sigma, &around.n);
        let v: Jet1<F, N> = p.v.lower();
        let dv = lower_vector(&differential(&p.v));
        let div_f = |flux| surface_div(&base, &face.normal, flux) * omega;
        OnFace {
            div_s: contract(&base.div_tensor(&s_sigma), &n) * v.value * omega,
            div_f: div_f(&flux) * v.value,
            div_f_v: div_f(&flux.map(|x| x * v)),
            h_nn: face.h * face.normal.normal_normal(&lower(&sigma)) * v.value * omega,
            s_nn: face.normal.normal_normal(&s_value),
            along_n: contract(&dv, &n) * omega,
            gradient: form(&s_value, &n, &base.sharp(&dv)) * omega,
        }
    }

    /// σ(n,τ) v ω_S, τ pointing into the face, for the two faces of a cell at a hinge.
    pub fn hinge(&self, cell: usize, opposite: [usize; 2], lambda: &[F]) -> [F; 2] {
        let vertices = others(N + 1, &opposite);
        let p = self.point(cell, &vertices, lambda);
        let nu = [outward::<F, N>(opposite[0]), outward(opposite[1])];
        let inverse = p.inverse.map(|x| x.value);
        let det = p.still.det.value;
        let corner = Corner::new(&self.formulas, &inverse, det, [&nu[0], &nu[1]]);
        let sigma = lower(&lower(&p.sigma));
        let weight = corner.omega() * p.v.value;
        let side = |f: usize| form(&sigma, &corner.normal(f), &corner.conormal(f)) * weight;
        [side(0), side(1)]
    }

    /// ∫ of several densities over a cell, face or hinge. Points where one of them does not exist are avoided.
    pub fn integral<const M: usize>(&self, k: usize, densities: &dyn Fn(&[F]) -> [F; M]) -> [F; M] {
        let mut sums = [F::zero(); M];
        let usable = |lambda: &[F]| k == N || !poisoned(&densities(lambda));
        if !(0..TRIED).any(|i| usable(&somewhere(k, i))) {
            return poison();
        }
        let there = on_simplex(k, self.domain.degree(), &usable, &mut |lambda, w| {
            for (sum, x) in sums.iter_mut().zip(densities(lambda)) {
                *sum += w * x;
            }
        });
        if there { sums } else { poison() }
    }

    /// What is integrated over the cells, their faces and hinges, at points with these coordinates.
    pub(super) fn densities(&self, lambda: &[F]) -> Vec<F> {
        let mut all = Vec::new();
        for cell in 0..self.cell_count() {
            let p = self.cell(cell, lambda);
            all.extend([p.div_div, p.hessian, p.div_gradient]);
            for f in 0..=N {
                let q = self.face(cell, f, &lambda[1..]);
                all.extend([q.div_s, q.div_f, q.div_f_v, q.h_nn, q.gradient]);
                all.push(q.s_nn * q.along_n);
                for other in 0..f {
                    // A hinge of a triangle is a point.
                    let one = [F::one()];
                    let at = if N == 2 { &one } else { &lambda[2..] };
                    all.extend(self.hinge(cell, [f, other], at));
                }
            }
        }
        all
    }

    /// ∫(div div 𝕊σ)v, ∫⟨𝕊σ,∇∇v⟩, ∫(div 𝕊σ)(∇v) over all cells.
    pub fn cells(&self) -> [F; 3] {
        let of = |cell: usize| {
            self.integral(N, &|lambda| {
                let p = self.cell(cell, lambda);
                [p.div_div, p.hessian, p.div_gradient]
            })
        };
        (0..self.cell_count()).map(of).fold([F::zero(); 3], add_up)
    }

    /// Densities over the faces of the only cell.
    pub fn faces<const M: usize>(&self, q: fn(&OnFace<F>) -> [F; M]) -> [F; M] {
        let of = |f: usize| self.integral(N - 1, &|lambda| q(&self.face(0, f, lambda)));
        let mut sums = [F::zero(); M];
        for f in 0..=N {
            if !poisoned(&sums) {
                sums = add_up(sums, of(f));
            }
        }
        sums
    }
}

/// At so many points of a face or hinge a root is looked for. It is at half of them if it is at any.
const TRIED: i64 = 40;

/// Points of a k-simplex.
fn somewhere<F: Ground>(k: usize, i: i64) -> Vec<F> {
    let mut lambda: Vec<F> = (1..=k as i64).map(|j| F::from_int(i + j * j + 2)).collect();
    let sum = lambda.iter().fold(F::zero(), |sum, x| sum + *x);
    lambda.push(F::one() - sum);
    lambda
}

/// Component by component.
pub fn add_up<F: Ground, const M: usize>(mut a: [F; M], b: [F; M]) -> [F; M] {
    for (x, y) in a.iter_mut().zip(b) {
        *x += y;
    }
    a
}

/// What does not exist: 1/0.
pub fn poison<F: Ground, const M: usize>() -> [F; M] {
    [F::one() / F::zero(); M]
}

/// Does nothing exist to be compared?
pub fn poisoned<F: Ground, const M: usize>(all: &[F; M]) -> bool {
    all.iter().any(|x| x.is_poison())
}
