//! P02: volumes, and how they change.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise};
use crate::stage::reference::leading_minor;
use regge_curvature::density::{omega, outward};
use regge_curvature::scalar::{Algebraic, Field};

/// ω, ω_F, ω_S and ω̇, ω̇_F, ω̇_S.
pub struct P02;

impl Pointwise for P02 {
    const RECORD: Record = Record {
        label: "P02",
        paper: &["prop:curvdot"],
        title: "The volume forms and their rates of change",
        statement: r"\dot\omega = \tfrac12(\operatorname{Tr}\sigma)\,\omega, \quad
            \dot\omega_F = \tfrac12\operatorname{Tr}(\sigma|_F)\,\omega_F, \quad
            \dot\omega_S = \tfrac12\operatorname{Tr}(\sigma|_S)\,\omega_S;\qquad
            \omega = \sqrt{\det g},\ \omega_F = \sqrt{\det g|_F},\ \omega_S = \sqrt{\det g|_S}",
        sides: "Left: the library's volume forms, which are roots of det g and of products of covectors, differentiated \
            in t. Right: traces with g⁻¹ and normals. Both use the volume forms, the left their change and the right their \
            values, which are checked on the reference simplex: minors of g by elimination.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        values(i).into_iter().chain(rates(i)).collect()
    }
}

/// The volumes of the reference simplex, of the face x_N = 0 and of the hinge x_N = x_{N−1} = 0.
fn values<S: Timed, const N: usize>(i: &Instance<S, N>) -> [Equation<S::Base>; 3] {
    let base = i.still0();
    let [nu, other] = [outward(N), outward(N - 1)];
    let omega = omega(&i.formulas, base.det);
    let omega_f = i.normal(&base, &nu).omega;
    let omega_s = i.corner(&base, [&nu, &other]).omega();
    let one = |name, left: S::Base, k: usize| {
        Equation::new(name)
            .left("volume", left)
            .right("√ of a minor of g", leading_minor(&base.g, k).sqrt())
    };
    [
        one("ω", omega, N),
        one("ω_F", omega_f, N - 1),
        one("ω_S", omega_s, N - 2),
    ]
}

/// On F = {φ = 0} and where it meets another hypersurface.
fn rates<S: Timed, const N: usize>(i: &Instance<S, N>) -> [Equation<S::Base>; 3] {
    let (moving, still, sigma) = (i.moving0(), i.still0(), i.sigma0());
    let nu = i.nu().map(|x| x.value);
    let (nu_t, bar_t) = (nu.map(S::fixed), i.nu_bar.map(S::fixed));
    let (normal, corner) = (i.normal(&still, &nu), i.corner(&still, [&nu, &i.nu_bar]));
    let half = S::Base::half();
    let (omega_dot, omega_0) = (
        omega(&i.formulas, moving.det).rate(),
        omega(&i.formulas, still.det),
    );
    let omega_s = corner.omega();
    [
        Equation::new("ω̇")
            .left("ω̇", omega_dot)
            .right("½ Tr σ ω", half * still.trace(&sigma) * omega_0),
        Equation::new("ω̇_F")
            .left("ω̇_F", i.normal(&moving, &nu_t).omega.rate())
            .right("½ Tr(σ|_F) ω_F", half * normal.trace(&sigma) * normal.omega),
        Equation::new("ω̇_S")
            .left("ω̇_S", i.corner(&moving, [&nu_t, &bar_t]).omega().rate())
            .vanishes(N == 2, "ω_S = 1 when S is a point")
            .right("½ Tr(σ|_S) ω_S", half * corner.trace(&sigma) * omega_s)
            .vanishes(N == 2, "σ has no components along a point")
            .magnitude(still.trace(&sigma) * omega_s),
    ]
}
