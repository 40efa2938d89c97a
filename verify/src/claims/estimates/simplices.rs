//! I18, I28: simplices.

use crate::harness::{Equation, Excuses, Ground, Record, Timed, each, list};
use crate::stage::point::{Instance, Over, Pointwise};
use regge_curvature::density::{Corner, outward};
use regge_curvature::formulas::Formulas;
use regge_curvature::linalg::{Mat, Vector, apply, contract, form, inverse_and_det, symmetric};
use regge_curvature::scalar::Field;
use regge_curvature::simplex::binomial;
use regge_curvature::spaces::dofs_per_simplex;

/// Dihedral angles and the shape of a simplex.
pub struct I18;

/// Inradius, diameter and the least sine of a dihedral angle of the reference simplex in a constant metric.
struct Shape {
    inradius: f64,
    diameter: f64,
    least_height: f64,
    least_sine: f64,
}

impl Shape {
    fn new<B: Ground, const N: usize>(formulas: &Formulas, g: &Mat<B, N>) -> Self {
        let (inverse, det) = inverse_and_det(g);
        let nu: Vec<Vector<B, N>> = list(N + 1, outward);
        // 1/|dλ_f| is the height over the face f, and 1/ρ = Σ_f 1/height_f.
        let inverse_heights = each(&nu, |nu| {
            contract(nu, &apply(&inverse, nu)).to_real().sqrt()
        });
        let (mut diameter, mut least_sine) = (0.0_f64, 1.0_f64);
        for a in 0..=N {
            for b in 0..a {
                let (sin, cos) = Corner::new(formulas, &inverse, det, [&nu[a], &nu[b]]).dihedral();
                let (sin, cos) = (sin.to_real(), cos.to_real());
                least_sine = least_sine.min(sin / f64::hypot(sin, cos));
                let edge: Vector<B, N> = Vector::from_fn(|k, _| {
                    let at = |v: usize| if k + 1 == v { B::one() } else { B::zero() };
                    at(a) - at(b)
                });
                diameter = diameter.max(form(g, &edge, &edge).to_real().sqrt());
            }
        }
        Self {
            inradius: 1.0 / inverse_heights.iter().sum::<f64>(),
            diameter,
            least_height: 1.0 / inverse_heights.iter().fold(0.0, |a: f64, b| a.max(*b)),
            least_sine,
        }
    }
}

/// The metric of a slender simplex: an edge of length s³-small far away from a small hinge.
///
/// Vertices 0, s e_1 … s e_{N−2} span the hinge; the others are e_{N−1} and e_{N−1} + b e_N with b ≪ s ≪ 1.
fn slender<B: Ground, const N: usize>() -> Mat<B, N> {
    // 1/ρ = (2 + (N−1) b/s …)/b and diameter² = 1 + s²: 2ρ/h is below sin θ = b by a factor of 1.004 at most.
    let (s, b) = (0.05, 5e-5);
    symmetric(|i, j| {
        let value = match (i + 2 >= N, j + 2 >= N) {
            (true, true) if i == j && i + 1 == N => 1.0 + b * b,
            (true, true) => 1.0,
            (false, false) if i == j => s * s,
            _ => 0.0,
        };
        B::from_real(value)
    })
}

impl Pointwise for I18 {
    const RECORD: Record = Record {
        label: "I18",
        paper: &["lemma:anglebound"],
        title: "Dihedral angles are bounded by the shape of the simplex",
        statement: r"\sin\theta_{ST} \ge \frac{2\rho_T}{h_T},\qquad 2\rho_T \le \text{every height}",
        sides: "Left: inradius and diameter, from the lengths of dλ_f and of edges. Right: the library's dihedral \
            angles. The constant 2 is sharp: 2.01 is refuted by slender simplices.",
    };
    const OVER: Over = Over::Ordered;
    const EXCUSES: Excuses = Excuses::one_method("an inequality: a finite field has no order");

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let bound = |name, shape: Shape| {
            let ratio = |c: f64| S::Base::from_real(c * shape.inradius / shape.diameter);
            Equation::at_most(name)
                .left("2ρ/h", ratio(2.0))
                .right("least sin θ", S::Base::from_real(shape.least_sine))
                .forge("no sin θ", "least sin θ", S::Base::from_real(0.0))
        };
        let random = Shape::new(&i.formulas, &i.still0().g);
        let (twice, height) = (2.0 * random.inradius, random.least_height);
        let thin = Shape::new(&i.formulas, &slender::<S::Base, N>());
        let sharper = S::Base::from_real(2.01 * thin.inradius / thin.diameter);
        vec![
            bound("random simplex", random),
            bound("slender simplex", thin).forge("2.01 for 2", "2ρ/h", sharper),
            Equation::at_most("heights")
                .left("2ρ", S::Base::from_real(twice))
                .right("least height", S::Base::from_real(height))
                .forge("no height", "least height", S::Base::from_real(0.0)),
        ]
    }
}

/// The dimension of the Regge space on a simplex.
pub struct I28;

/// How many degrees of freedom belong to simplices of dimension k, as a term.
const DOFS: [&str; 5] = [
    "dofs of edges",
    "dofs of triangles",
    "dofs of tetrahedra",
    "dofs of 4-simplices",
    "dofs of 5-simplices",
];

/// The degrees that are tried.
const DEGREES: [&str; 6] = ["r = 0", "r = 1", "r = 2", "r = 3", "r = 4", "r = 5"];

impl Pointwise for I28 {
    const RECORD: Record = Record {
        label: "I28",
        paper: &["appendix:optimalorder"],
        title: "The number of degrees of freedom of a Regge element",
        statement: r"\sum_{k=1}^N\binom{N+1}{k+1}\binom{r+1}{k}\frac{k(k+1)}{2} = \binom{N+r}{N}\frac{N(N+1)}{2}",
        sides: "Left: the library's degrees of freedom of a k-simplex, over all subsimplices. Right: the dimension of \
            the polynomials of degree r times that of symmetric matrices.",
    };
    const OVER: Over = Over::Integers;
    const EXCUSES: Excuses =
        Excuses::one_method("an identity of whole numbers: it is exact already")
            .few_cases("nothing is random: r = 0, …, 5 for every N");

    fn equations<S: Timed, const N: usize>(_i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let int = |n: usize| S::Base::from_int(n as i64);
        list(DEGREES.len(), |r| {
            let mut equation = Equation::new(DEGREES[r]);
            for k in 1..=N {
                equation = equation
                    .left(
                        DOFS[k - 1],
                        int(binomial(N + 1, k + 1) * dofs_per_simplex(r, k)),
                    )
                    .vanishes(k > r + 1, "no degree of freedom of so low a degree inside");
            }
            let dimension = |n: usize| int(binomial(N + r, N) * n);
            equation
                .right("dimension", dimension(N * (N + 1) / 2))
                .forge("all matrices", "dimension", dimension(N * N))
        })
    }
}
