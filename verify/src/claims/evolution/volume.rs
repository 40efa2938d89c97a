//! P02: how volumes change.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise};
use regge_curvature::hinge::Hinge;
use regge_curvature::hypersurface::{Normal, omega_f};
use regge_curvature::scalar::{Algebraic, Field};

/// ω̇, ω̇_F, ω̇_S.
pub struct P02;

impl Pointwise for P02 {
    const RECORD: Record = Record {
        label: "P02",
        paper: &["prop:curvdot"],
        title: "The rates of change of the volume forms",
        statement: r"\dot\omega = \tfrac12(\operatorname{Tr}\sigma)\,\omega, \quad
            \dot\omega_F = \tfrac12\operatorname{Tr}(\sigma|_F)\,\omega_F, \quad
            \dot\omega_S = \tfrac12\operatorname{Tr}(\sigma|_S)\,\omega_S",
        sides: "Left: square roots of determinants, differentiated in t. Right: traces with g⁻¹ and normals. Both use the volume forms, the left their change and the right their values.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (moving, still, sigma) = (i.moving0(), i.still0(), i.sigma0());
        let nu = i.nu().map(|x| x.value);
        let (nu_t, bar_t) = (nu.map(S::fixed), i.nu_bar.map(S::fixed));
        let normal = Normal::new(&still.inverse, &nu);
        let hinge = Hinge::new(&still.inverse, [&nu, &i.nu_bar]);
        let omega_s = hinge.omega_s(still.det);
        let moving_s = Hinge::new(&moving.inverse, [&nu_t, &bar_t]).omega_s(moving.det);
        let half = S::Base::half();
        vec![
            Equation::new("ω̇")
                .left("ω̇", moving.det.sqrt().rate())
                .right("½ Tr σ ω", half * still.trace(&sigma) * still.det.sqrt()),
            Equation::new("ω̇_F")
                .left("ω̇_F", omega_f(&moving, &nu_t).rate())
                .right(
                    "½ Tr(σ|_F) ω_F",
                    half * normal.trace(&sigma) * omega_f(&still, &nu),
                ),
            Equation::new("ω̇_S")
                .left("ω̇_S", moving_s.rate())
                .vanishes(N == 2, "ω_S = 1 when S is a point")
                .right(
                    "½ Tr(σ|_S) ω_S",
                    half * hinge.trace(&still.inverse, &sigma) * omega_s,
                )
                .vanishes(N == 2, "σ has no components along a point")
                .magnitude(still.trace(&sigma) * omega_s),
        ]
    }
}
