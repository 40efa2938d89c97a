//! D15: sectional curvatures of planes along and across a hypersurface.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise, sum};
use regge_curvature::linalg::{Vector, form};
use regge_curvature::riemann::Curvature;
use regge_curvature::scalar::Field;

/// R as a sum over orthogonal planes.
pub struct D15;

/// K(X, Y) = R_ijkl XⁱYʲXᵏYˡ of orthonormal vectors.
fn sectional<F: Field, const N: usize>(
    curvature: &Curvature<'_, F, N>,
    x: &Vector<F, N>,
    y: &Vector<F, N>,
) -> F {
    let mut sum = F::zero();
    for i in 0..N {
        for j in 0..N {
            for k in 0..N {
                for l in 0..N {
                    sum += curvature.riemann([i, j, k, l]) * x[i] * y[j] * x[k] * y[l];
                }
            }
        }
    }
    sum
}

impl Pointwise for D15 {
    const RECORD: Record = Record {
        label: "D15",
        paper: &["sec:curvature"],
        title: "R is twice a sum of sectional curvatures, of planes along F and across F",
        statement: r"R = 2\sum_{i<j}K(\tau_i,\tau_j) + 2\sum_iK(\tau_i,n),\qquad
            \operatorname{Ric}(n,n) = \sum_iK(\tau_i,n)",
        sides: "Left: the library's R, with minors of g⁻¹, and its Ricci tensor. Right: R_ijkl on the (N−1)(N−2)/2 planes of an \
            orthonormal frame of F and on the N−1 planes through n. Both use R_ijkl, which O01 to O03 pin down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, frame) = (i.still0(), i.frame());
        let curvature = Curvature::new(&i.g, &base);
        let (n, tau) = (frame.n0(), frame.tau0());
        let of = |x: &Vector<S::Base, N>, y: &Vector<S::Base, N>| sectional(&curvature, x, y);
        let mut along = S::Base::zero();
        for (k, y) in tau.iter().enumerate() {
            along += sum(&tau[..k], |x| of(x, y));
        }
        let across = sum(&tau, |x| of(x, &n));
        vec![
            Equation::new("R")
                .left("R", curvature.scalar())
                .right("2ΣK(τ_i,τ_j)", along + along)
                .vanishes(N == 2, "no plane is tangent to a curve")
                .right("2ΣK(τ_i,n)", across + across)
                .forge("once the planes across F", "2ΣK(τ_i,n)", across),
            Equation::new("Ric(n,n)")
                .left("Ric(n,n)", form(&curvature.ricci(), &n, &n))
                .right("ΣK(τ_i,n)", across),
        ]
    }
}
