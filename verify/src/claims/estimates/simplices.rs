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
    least_edge: f64,
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
        let (mut diameter, mut least_edge, mut least_sine) = (0.0_f64, f64::INFINITY, 1.0_f64);
        for a in 0..=N {
            for b in 0..a {
                let (sin, cos) = Corner::new(formulas, &inverse, det, [&nu[a], &nu[b]]).dihedral();
                let (sin, cos) = (sin.to_real(), cos.to_real());
                least_sine = least_sine.min(sin / f64::hypot(sin, cos));
                let edge: Vector<B, N> = Vector::from_fn(|k, _| {
                    let at = |v: usize| if k + 1 == v { B::one() } else { B::zero() };
                    at(a) - at(b)
                });
                let length = form(g, &edge, &edge).to_real().sqrt();
                diameter = diameter.max(length);
                least_edge = least_edge.min(length);
            }
        }
        Self {
            inradius: 1.0 / inverse_heights.iter().sum::<f64>(),
            diameter,
            least_edge,
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
            angles. Both constants are sharp: 2.01 is refuted by slender simplices.",
    };
    const OVER: Over = Over::Ordered;
    const EXCUSES: Excuses = Excuses::one_method("an inequality: a finite field has no order");

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let real = S::Base::from_real;
        let angles = |name, shape: &Shape| {
            Equation::at_most(name)
                .left("2ρ/h", real(2.0 * shape.inradius / shape.diameter))
                .right("least sin θ", real(shape.least_sine))
        };
        let heights = |name, shape: &Shape| {
            Equation::at_most(name)
                .left("2ρ", real(2.0 * shape.inradius))
                .right("least height", real(shape.least_height))
        };
        let random = Shape::new(&i.formulas, &i.still0().g);
        let thin = Shape::new(&i.formulas, &slender::<S::Base, N>());
        let of_edge = 2.0 * thin.inradius / thin.least_edge;
        let sharper = 2.01 * thin.inradius;
        // sin ½θ, with sin θ small.
        let half = (0.5 * thin.least_sine.asin()).sin();
        vec![
            angles("random simplex", &random),
            angles("slender simplex", &thin)
                .forge("2.01 for 2", "2ρ/h", real(sharper / thin.diameter))
                .forge("the shortest edge for h", "2ρ/h", real(of_edge))
                .forge("half of the angle", "least sin θ", real(half)),
            heights("heights", &random),
            heights("heights of the slender simplex", &thin).forge(
                "2.01 for 2",
                "2ρ",
                real(sharper),
            ),
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
