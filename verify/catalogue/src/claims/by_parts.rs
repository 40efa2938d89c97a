//! T04: integration by parts on one simplex, exactly.

use crate::claim::seed::Key;
use crate::claim::{Budget, Case, Check, Equation, Ground, Judgement, Method, Record, Tally};
use crate::exact::Fp;
use crate::exact_rule::on_simplex;
use crate::instance::{Face, divergence_terms, reversed};
use crate::report::Entry;
use proptest::strategy::{Strategy, ValueTree};
use regge::formulas::Formulas;
use regge::hinge::Hinge;
use regge::hypersurface::outward;
use regge::jet::{Jet1, Jet2, lower, lower_vector};
use regge::linalg::{Mat, Vector, contract, form, identity, inverse_and_det, symmetric};
use regge::riemann::{Connection, differential};
use regge::scalar::{Algebraic, Field};
use regge::simplex::subsets;
use std::marker::PhantomData;

static RECORD: Record = Record {
    label: "T04",
    paper: &["lemma:IBPdivdivS", "IBP1"],
    title: "Integration by parts on one simplex (corrected sign)",
    statement: r"\int_T(\operatorname{div}\operatorname{div}\mathbb{S}\sigma)v\,\omega
        - \sum_F\int_F\left[(\operatorname{div}\mathbb{S}\sigma)(n) + \operatorname{div}_F(\sigma(n,\cdot))
        - H\sigma(n,n)\right]v\,\omega_F - \sum_S\int_S\sum_{F\supset S}\sigma(n,\tau)\,v\,\omega_S
        = \int_T\langle\mathbb{S}\sigma,\nabla\nabla v\rangle\omega
        - \sum_F\int_F\mathbb{S}\sigma(n,n)\nabla_n v\,\omega_F",
    sides: "Left: derivatives of σ. Right: derivatives of v. The metric is g = LLᵀ with L unipotent and affine, which is \
        curved; v = (∏_F q_F)² w with q_F = ν·g⁻¹ν clears the denominators, so that every integrand is a polynomial and \
        is integrated exactly. τ points into F; the paper prints + for the sum over S, a forgery here.",
};

/// T04 in dimension N by the formulas K.
pub struct ByParts<K, const N: usize>(PhantomData<fn() -> K>);

impl<K, const N: usize> Default for ByParts<K, N> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

/// Degree of all integrands, which are products of v with the derivatives of 𝕊σ. Too low a number makes the claim
/// fail.
const fn degree(n: usize) -> usize {
    // v: 4 (N+1) + 1; 𝕊σ: 5; Γ: 3 for each of two derivatives; g⁻¹: 2 for each of two contractions.
    4 * (n + 1) + 1 + 5 + 6 + 4
}

/// Affine functions: L's entry, σ's components, w.
struct Fields<const N: usize> {
    numbers: Vec<Fp>,
}

impl<const N: usize> Fields<N> {
    const COUNT: usize = (2 + N * (N + 1) / 2) * (N + 1) + 1;

    /// The k-th affine function.
    fn affine(&self, k: usize, x: &[Jet2<Fp, N>; N]) -> Jet2<Fp, N> {
        let c = &self.numbers[k * (N + 1)..];
        let mut sum = Jet2::constant(c[N]);
        for i in 0..N {
            sum += Jet2::constant(c[i]) * x[i];
        }
        sum
    }

    /// g = L Lᵀ with an affine entry L_10 and, for N ≥ 3, a constant L_21.
    fn metric(&self, x: &[Jet2<Fp, N>; N]) -> Mat<Jet2<Fp, N>, N> {
        let mut l = identity::<Jet2<Fp, N>, N>();
        l[(1, 0)] = self.affine(0, x);
        if N > 2 {
            l[(2, 1)] = Jet2::constant(self.numbers[Self::COUNT - 1]);
        }
        symmetric(|i, j| {
            let mut sum = Jet2::zero();
            for k in 0..N {
                sum += l[(i, k)] * l[(j, k)];
            }
            sum
        })
    }

    fn sigma(&self, x: &[Jet2<Fp, N>; N]) -> Mat<Jet2<Fp, N>, N> {
        symmetric(|i, j| self.affine(2 + i * N - i * (i + 1) / 2 + j, x))
    }

    /// All that is needed at the point with these barycentric coordinates of a subsimplex.
    fn at(&self, vertices: &[usize], lambda: &[Fp]) -> Point<N> {
        let mut x: [Jet2<Fp, N>; N] = std::array::from_fn(|i| Jet2::coordinate(Fp::zero(), i));
        for (v, l) in vertices.iter().zip(lambda) {
            if *v > 0 {
                x[v - 1].value = *l;
            }
        }
        let (g, sigma) = (self.metric(&x), self.sigma(&x));
        let inverse = inverse_and_det(&g).0;
        let mut v = self.affine(1, &x);
        for f in 0..=N {
            let nu: Vector<Jet2<Fp, N>, N> = outward(f);
            let square = form(&inverse, &nu, &nu);
            v *= square * square;
        }
        Point {
            still: Connection::new(&g),
            g,
            inverse,
            sigma,
            v,
        }
    }
}

/// g, σ and v with derivatives at a point.
struct Point<const N: usize> {
    g: Mat<Jet2<Fp, N>, N>,
    inverse: Mat<Jet2<Fp, N>, N>,
    still: Connection<Jet1<Fp, N>, N>,
    sigma: Mat<Jet2<Fp, N>, N>,
    v: Jet2<Fp, N>,
}

/// The seven integrals, in the order of the statement.
#[derive(Default)]
struct Integrals([Option<Fp>; 7]);

impl Integrals {
    fn add(&mut self, k: usize, x: Fp) {
        *self.0[k].get_or_insert(Fp::zero()) += x;
    }

    fn is_poisoned(&self) -> bool {
        self.0.iter().flatten().any(|x| x.is_poison())
    }

    fn get(&self, k: usize) -> Fp {
        self.0[k].unwrap_or(Fp::zero())
    }
}

impl<K: Formulas, const N: usize> ByParts<K, N> {
    fn cell(fields: &Fields<N>, sums: &mut Integrals) {
        let all: Vec<usize> = (0..=N).collect();
        on_simplex(N, degree(N), &|_| true, &mut |lambda, w| {
            let p = fields.at(&all, lambda);
            let base = p.still.lower();
            let weight = w * base.det.sqrt();
            let s_sigma = K::reverse_trace(&p.g, &p.inverse, &p.sigma);
            sums.add(0, weight * p.still.div_div(&s_sigma) * p.v.value);
            let s0 = lower(&lower(&s_sigma));
            sums.add(5, weight * base.inner(&s0, &base.hessian(&p.v)));
        });
    }

    fn face(fields: &Fields<N>, opposite: usize, sums: &mut Integrals) {
        let vertices: Vec<usize> = (0..=N).filter(|v| *v != opposite).collect();
        let nu: Vector<Jet1<Fp, N>, N> = outward(opposite);
        let flat = nu.map(|x| x.value);
        let usable = |lambda: &[Fp]| {
            let inverse = fields.at(&vertices, lambda).inverse.map(|x| x.value);
            !form(&inverse, &flat, &flat).sqrt().is_poison()
        };
        on_simplex(N - 1, degree(N), &usable, &mut |lambda, w| {
            let p = fields.at(&vertices, lambda);
            let base = p.still.lower();
            let face = Face::new::<K>(&base, &nu);
            let (sigma1, n) = (lower(&p.sigma), face.normal.n);
            let s_sigma = reversed::<K, Fp, N>(&p.still, &sigma1);
            let (weight, v) = (w * face.omega, p.v.value);
            sums.add(1, -weight * contract(&base.div_tensor(&s_sigma), &n) * v);
            sums.add(2, -weight * divergence_terms(&p.still, &nu, &sigma1) * v);
            sums.add(
                3,
                weight * face.h * face.normal.normal_normal(&lower(&sigma1)) * v,
            );
            let along_n = contract(&lower_vector(&differential(&p.v)), &n);
            sums.add(
                6,
                -weight * face.normal.normal_normal(&lower(&s_sigma)) * along_n,
            );
        });
    }

    fn hinge(fields: &Fields<N>, opposite: [usize; 2], sums: &mut Integrals) {
        let vertices: Vec<usize> = (0..=N).filter(|v| !opposite.contains(v)).collect();
        let nu = opposite.map(outward::<Fp, N>);
        let here = |p: &Point<N>| Hinge::new(&p.inverse.map(|x| x.value), [&nu[0], &nu[1]]);
        let usable = |lambda: &[Fp]| {
            let hinge = here(&fields.at(&vertices, lambda));
            let [a, b] = hinge.squares;
            [a, b, hinge.gram].iter().all(|x| !x.sqrt().is_poison())
        };
        on_simplex(N - 2, degree(N), &usable, &mut |lambda, w| {
            let p = fields.at(&vertices, lambda);
            let (hinge, sigma) = (here(&p), lower(&lower(&p.sigma)));
            let weight = w * hinge.omega_s(p.still.det.value) * p.v.value;
            for f in 0..2 {
                sums.add(
                    4,
                    -weight * form(&sigma, &hinge.normal(f), &hinge.conormal(f)),
                );
            }
        });
    }

    fn equation(fields: &Fields<N>) -> Equation<Fp> {
        let mut sums = Integrals::default();
        // The hinges first, then the faces: where roots do not exist at all, the cell need not be integrated.
        for pair in subsets(N + 1, 2) {
            if !sums.is_poisoned() {
                Self::hinge(fields, [pair[0], pair[1]], &mut sums);
            }
        }
        for f in 0..=N {
            if !sums.is_poisoned() {
                Self::face(fields, f, &mut sums);
            }
        }
        if !sums.is_poisoned() {
            Self::cell(fields, &mut sums);
        }
        Equation::new("by parts")
            .left("∫(div div 𝕊σ)v", sums.get(0))
            .left("−Σ_F∫(div 𝕊σ)(n)v", sums.get(1))
            .left("−Σ_F∫div_F(σ(n,·))v", sums.get(2))
            .left("Σ_F∫Hσ(n,n)v", sums.get(3))
            .left("−Σ_S∫Σσ(n,τ)v", sums.get(4))
            .right("∫⟨𝕊σ,∇∇v⟩", sums.get(5))
            .right("−Σ_F∫𝕊σ(n,n)∇_n v", sums.get(6))
            .forge("conormal as printed", "−Σ_S∫Σσ(n,τ)v", -sums.get(4))
    }
}

impl<K: Formulas, const N: usize> Check for ByParts<K, N> {
    fn record(&self) -> &'static Record {
        &RECORD
    }

    fn dimension(&self) -> usize {
        N
    }

    fn method(&self) -> Method {
        Method::Exact
    }

    /// 2⁻⁵⁴ a draw: two are enough; on the tetrahedron each takes seconds.
    fn cases(&self, budget: &Budget) -> usize {
        match (budget.quick, N) {
            (true, 3..) => 1,
            (true, _) | (_, 3..) => 2,
            _ => 4,
        }
    }

    fn run(&self, budget: &Budget) -> Entry {
        // One identity of integrals in the coefficients of the fields: degree ≤ 2 · 40 in L's, 1 in σ's and w's.
        let mut tally = Tally::new(Judgement::Exact { degree: 100.0 });
        for number in 0..self.cases(budget) {
            let case = Case {
                number,
                ..Case::default()
            };
            let (label, method) = (RECORD.label, Method::Exact.name());
            let key = Key {
                seed: budget.seed,
                label,
                dimension: N,
                method,
                case: number,
            };
            let mut runner = key.runner();
            let numbers = proptest::collection::vec(Fp::number(), Fields::<N>::COUNT);
            let mut drawn = 0;
            while drawn < Fp::REDRAWS {
                let Ok(tree) = numbers.new_tree(&mut runner) else {
                    break;
                };
                let equation = Self::equation(&Fields {
                    numbers: tree.current(),
                });
                if !equation.is_poisoned() {
                    tally.add(&case, &[equation]);
                    break;
                }
                drawn += 1;
            }
            tally.redrawn(drawn);
        }
        tally.finish(&RECORD, N, Fp::NAME, Method::Exact)
    }
}
