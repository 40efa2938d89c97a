//! D13: what is single-valued across a face.

use crate::claim::{Equation, Ground, Pointwise, Record, Timed};
use crate::instance::Instance;
use regge_curvature::formulas::Formulas;
use regge_curvature::hinge::Hinge;
use regge_curvature::hypersurface::Normal;
use regge_curvature::linalg::{Mat, Vector, inverse_and_det, symmetric};
use regge_curvature::scalar::Field;

/// 𝕊σ(n,n), ω_F, ω_S.
pub struct D13;

/// One side of a face: g, σ and what is made of them.
struct Side<B: Ground, const N: usize> {
    inverse: Mat<B, N>,
    det: B,
    normal: Normal<B, N>,
    sigma: Mat<B, N>,
    s_nn: B,
}

impl<B: Ground, const N: usize> Side<B, N> {
    fn new<K: Formulas>(g: &Mat<B, N>, sigma: &Mat<B, N>, nu: &Vector<B, N>) -> Self {
        let (inverse, det) = inverse_and_det(g);
        let normal = Normal::new(&inverse, nu);
        let s_nn = normal.normal_normal(&K::reverse_trace(g, &inverse, sigma));
        Self {
            inverse,
            det,
            normal,
            sigma: *sigma,
            s_nn,
        }
    }

    fn sigma_nn(&self) -> B {
        self.normal.normal_normal(&self.sigma)
    }

    fn omega_f(&self) -> B {
        self.normal.length * self.det.sqrt()
    }

    fn omega_s(&self, nu: [&Vector<B, N>; 2]) -> B {
        Hinge::new(&self.inverse, nu).omega_s(self.det)
    }
}

/// a + factor (α ⊗ β + β ⊗ α).
fn add<B: Ground, const N: usize>(
    a: &Mat<B, N>,
    factor: B,
    alpha: &Vector<B, N>,
    beta: &Vector<B, N>,
) -> Mat<B, N> {
    symmetric(|i, j| a[(i, j)] + factor * (alpha[i] * beta[j] + beta[i] * alpha[j]))
}

impl Pointwise for D13 {
    const RECORD: Record = Record {
        label: "D13",
        paper: &["thm:distcurvdot"],
        title: "What tangential-tangential continuity makes single-valued",
        statement: r"\mathbb{S}\sigma(n,n) = -\operatorname{Tr}(\sigma|_F),\qquad \mathbb{S}\sigma^+(n^+,n^+)
            = \mathbb{S}\sigma^-(n^-,n^-),\quad \omega_F^+ = \omega_F^-,\quad \omega_S^+ = \omega_S^-",
        sides: "Left and right: two metrics and two σ that agree on vectors tangent to F and nowhere else; the trace \
            over F with the tangential part of g⁻¹.",
    };
    const ROOTS: u32 = 8;

    fn equations<K: Formulas, S: Timed, const N: usize>(
        i: &Instance<S, N>,
    ) -> Vec<Equation<S::Base>> {
        let nu = i.nu().map(|x| x.value);
        let (g, sigma) = (i.still0().g, i.sigma0());
        // Small enough to leave g positive definite: |ν|, |β| ≤ √N, and g ≥ ½ δ.
        let small = S::Base::ratio(1, 8 * N as i64);
        let beta = i.alpha.map(|x| x.value);
        let (g_m, sigma_m) = (
            add(&g, small, &nu, &beta),
            add(&sigma, S::Base::one(), &nu, &i.nu_rate),
        );
        let plus = Side::new::<K>(&g, &sigma, &nu);
        let minus = Side::new::<K>(&g_m, &sigma_m, &-nu);
        // Continuity broken: a part that tangent vectors see.
        let broken_sigma = add(&sigma_m, S::Base::one(), &beta, &beta);
        let broken = Side::new::<K>(
            &add(&g_m, S::Base::one(), &beta, &beta),
            &broken_sigma,
            &-nu,
        );
        across(&[plus, minus, broken], [&nu, &i.nu_bar], N == 2)
    }
}

/// The equations between the two sides; the third is the second with continuity broken.
fn across<B: Ground, const N: usize>(
    [plus, minus, broken]: &[Side<B, N>; 3],
    hinge: [&Vector<B, N>; 2],
    point: bool,
) -> Vec<Equation<B>> {
    let name = "tangential continuity broken";
    vec![
        Equation::new("𝕊σ(n,n)")
            .left("𝕊σ(n,n)", plus.s_nn)
            .right("−Tr(σ|_F)", -plus.normal.trace(&plus.sigma))
            .forge("σ for 𝕊σ", "𝕊σ(n,n)", plus.sigma_nn()),
        Equation::new("𝕊σ across F")
            .left("𝕊σ⁺(n⁺,n⁺)", plus.s_nn)
            .right("𝕊σ⁻(n⁻,n⁻)", minus.s_nn)
            .forge(name, "𝕊σ⁻(n⁻,n⁻)", broken.s_nn)
            .forge_terms(
                "σ for 𝕊σ",
                vec![
                    ("𝕊σ⁺(n⁺,n⁺)", vec![plus.sigma_nn()]),
                    ("𝕊σ⁻(n⁻,n⁻)", vec![minus.sigma_nn()]),
                ],
            ),
        Equation::new("ω_F")
            .left("ω_F⁺", plus.omega_f())
            .right("ω_F⁻", minus.omega_f())
            .forge(name, "ω_F⁻", broken.omega_f()),
        Equation::new("ω_S")
            .left("ω_S⁺", plus.omega_s(hinge))
            .right("ω_S⁻", minus.omega_s(hinge))
            .forge(name, "ω_S⁻", broken.omega_s(hinge))
            .vacuous(point, "ω_S = 1 when S is a point"),
    ]
}
