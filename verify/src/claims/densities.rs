//! M07, M12, M19, M20 at a point, over the prime field: what is integrated on a mesh.

use super::{mesh, single_valued, traces};
use crate::claim::{Equation, Over, Pointwise, Record, Timed};
use crate::instance::Instance;
use regge_curvature::formulas::Formulas;
use regge_curvature::hinge::Hinge;
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::scalar::{Algebraic, Field};

/// G = 0, II‾ = 0 and σ|_S = 0 when N = 2.
pub struct M07;

impl Pointwise for M07 {
    const RECORD: Record = mesh::M07_RECORD;
    const DIMENSIONS: &'static [usize] = &[2];
    const OVER: Over = Over::Integers;
    const ROOTS: u32 = 4;

    fn equations<K: Formulas, S: Timed, const N: usize>(
        i: &Instance<S, N>,
    ) -> Vec<Equation<S::Base>> {
        let (still, scene, sigma) = (i.still(), i.scene::<K>(), i.sigma0());
        let base = still.lower();
        let (omega, omega_f) = (base.det.sqrt(), scene.face.omega);
        let reversed = scene.face.trace_reversed::<K>(&base);
        let hinge = Hinge::new(&base.inverse, [&i.nu().map(|x| x.value), &i.nu_bar]);
        vec![
            Equation::new("⟨G,σ⟩ω")
                .left("⟨G,σ⟩ω", base.inner(&still.einstein(), &sigma) * omega)
                .vanishes(true, "G = 0")
                .forge(
                    "Ric for G",
                    "⟨G,σ⟩ω",
                    base.inner(&still.ricci(), &sigma) * omega,
                ),
            Equation::new("⟨II‾,σ⟩ω_F")
                .left(
                    "⟨II‾,σ⟩ω_F",
                    scene.face.normal.inner(&reversed, &sigma) * omega_f,
                )
                .vanishes(true, "II‾ = II − Hg = 0 on a curve")
                .forge("II for II‾", "⟨II‾,σ⟩ω_F", scene.ii_sigma * omega_f),
            Equation::new("Tr(σ|_S)")
                .left("Tr(σ|_S)", hinge.trace(&base.inverse, &sigma))
                .vanishes(true, "S is a point")
                .forge("Tr σ", "Tr(σ|_S)", base.trace(&sigma)),
        ]
    }
}

/// Tr(σ|_S) ω_S = 2V̇_S, whatever Θ_S.
pub struct M12;

/// The determinant of the first k rows and columns, by elimination.
fn leading_minor<F: Field, const N: usize>(g: &Mat<F, N>, k: usize) -> F {
    let (mut a, mut product) = (*g, F::one());
    for p in 0..k {
        let pivot = a[(p, p)];
        product *= pivot;
        for i in p + 1..k {
            let factor = a[(i, p)] / pivot;
            for j in p..k {
                let x = a[(p, j)];
                a[(i, j)] -= factor * x;
            }
        }
    }
    product
}

impl Pointwise for M12 {
    const RECORD: Record = mesh::M12_RECORD;
    const DIMENSIONS: &'static [usize] = &[3, 4, 5];
    const OVER: Over = Over::Integers;
    const ROOTS: u32 = 2;

    fn equations<K: Formulas, S: Timed, const N: usize>(
        i: &Instance<S, N>,
    ) -> Vec<Equation<S::Base>> {
        let (base, sigma) = (i.still0(), i.sigma0());
        // S is spanned by the first N − 2 coordinate directions.
        let last = |k: usize| {
            let unit = |m: usize| if m + k == N { 1 } else { 0 };
            Vector::<S::Base, N>::from_fn(|m, _| S::Base::from_int(unit(m)))
        };
        let hinge = Hinge::new(&base.inverse, [&last(1), &last(2)]);
        let trace = hinge.trace(&base.inverse, &sigma) * hinge.omega_s(base.det);
        let rate = leading_minor(&i.moving0().g, N - 2).sqrt().rate();
        vec![
            Equation::new("Tr(σ|_S)ω_S")
                .left("Tr(σ|_S)ω_S", trace)
                .right("2V̇_S", rate + rate)
                .forge(
                    "Tr σ",
                    "Tr(σ|_S)ω_S",
                    base.trace(&sigma) * hinge.omega_s(base.det),
                ),
        ]
    }
}

/// The traces of G, II‾ and g|_S.
pub struct M19;

impl Pointwise for M19 {
    const RECORD: Record = mesh::M19_RECORD;
    const DIMENSIONS: &'static [usize] = &[2, 3, 4];
    const OVER: Over = Over::Integers;

    fn equations<K: Formulas, S: Timed, const N: usize>(
        i: &Instance<S, N>,
    ) -> Vec<Equation<S::Base>> {
        traces::M11::equations::<K, S, N>(i)
    }
}

/// What tangential-tangential continuity makes single-valued.
pub struct M20;

impl Pointwise for M20 {
    const RECORD: Record = mesh::M20_RECORD;
    const DIMENSIONS: &'static [usize] = &[2, 3, 4];
    const OVER: Over = Over::Integers;
    const ROOTS: u32 = single_valued::D13::ROOTS;

    fn equations<K: Formulas, S: Timed, const N: usize>(
        i: &Instance<S, N>,
    ) -> Vec<Equation<S::Base>> {
        single_valued::D13::equations::<K, S, N>(i)
    }
}
