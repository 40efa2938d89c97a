//! D13, M20: what is single-valued where cells meet.

use crate::harness::{Draw, Equation, Ground, Judgement, Record, Setting, Timed};
use crate::stage::fields::{Regge, Seen, both_sides, variation, wild};
use crate::stage::mesh::{FaceTerms, HingeTerms, OnMesh, ROUNDING, at_points, torn};
use crate::stage::point::{Instance, Over, Pointwise};
use regge_curvature::density::{Corner, Normal};
use regge_curvature::formulas::Formulas;
use regge_curvature::linalg::{Mat, Vector, inverse_and_det, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::reverse_trace;
use regge_curvature::scalar::Field;
use regge_curvature::spaces::ReggeSpace;

/// 𝕊σ(n,n), ω_F, ω_S.
pub struct D13;

/// One side of a face: g, σ and what is made of them.
struct Side<'f, B: Ground, const N: usize> {
    formulas: &'f Formulas,
    inverse: Mat<B, N>,
    det: B,
    normal: Normal<B, N>,
    sigma: Mat<B, N>,
    s_nn: B,
}

impl<'f, B: Ground, const N: usize> Side<'f, B, N> {
    fn new(formulas: &'f Formulas, g: &Mat<B, N>, sigma: &Mat<B, N>, nu: &Vector<B, N>) -> Self {
        let (inverse, det) = inverse_and_det(g);
        let normal = Normal::new(formulas, &inverse, det, nu);
        let s_nn = normal.normal_normal(&reverse_trace(formulas, g, &inverse, sigma));
        Self {
            formulas,
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

    fn omega_s(&self, nu: [&Vector<B, N>; 2]) -> B {
        Corner::new(self.formulas, &self.inverse, self.det, nu).omega()
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

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let nu = i.nu().map(|x| x.value);
        let (g, sigma) = (i.still0().g, i.sigma0());
        let small = Instance::<S, N>::tear();
        let beta = i.alpha.map(|x| x.value);
        let (g_m, sigma_m) = (
            add(&g, small, &nu, &beta),
            add(&sigma, S::Base::one(), &nu, &i.nu_rate),
        );
        let plus = Side::new(&i.formulas, &g, &sigma, &nu);
        let minus = Side::new(&i.formulas, &g_m, &sigma_m, &-nu);
        // Continuity broken: tangent vectors are twice as long, and σ has a part that they see.
        let broken_sigma = add(&sigma_m, S::Base::one(), &beta, &beta);
        let broken_g = g_m.map(|x| x * S::Base::from_int(4));
        let broken = Side::new(&i.formulas, &broken_g, &broken_sigma, &-nu);
        across(&[plus, minus, broken], [&nu, &i.nu_bar], N == 2)
    }
}

/// The equations between the two sides; the third is the second with continuity broken.
fn across<B: Ground, const N: usize>(
    [plus, minus, broken]: &[Side<'_, B, N>; 3],
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
            .left("ω_F⁺", plus.normal.omega)
            .right("ω_F⁻", minus.normal.omega)
            .forge(name, "ω_F⁻", broken.normal.omega),
        Equation::new("ω_S")
            .left("ω_S⁺", plus.omega_s(hinge))
            .right("ω_S⁻", minus.omega_s(hinge))
            .forge(name, "ω_S⁻", broken.omega_s(hinge))
            .vacuous(point, "ω_S = 1 when S is a point"),
    ]
}

/// 𝕊σ(n,n), ω_F, ω_S.
pub struct M20;

/// 𝕊σ(n,n), −Tr(σ|_F), σ(n,n) and ω_F from both sides of the faces.
fn on_faces<const N: usize>(
    at: &Setting,
    mesh: &Mesh<N>,
    g: &Regge<f64, N>,
    sigma: &Regge<f64, N>,
    which: fn(&FaceTerms) -> f64,
) -> [Vec<f64>; 2] {
    let rule = Rule::new(N - 1, at.order);
    let g = Seen::<f64, N, _>::new(g, N - 1, &rule);
    let sigma = Seen::<f64, N, _>::new(sigma, N - 1, &rule);
    both_sides(mesh, N - 1, &rule, &|side, p| {
        let (g, sigma) = (g.jet2(side, p), sigma.jet1(side, p));
        vec![which(&FaceTerms::new::<N>(
            &at.formulas,
            &g,
            &sigma,
            side.place,
        ))]
    })
}

/// ω_S from the first and the last cell around the hinges.
fn on_hinges<const N: usize>(at: &Setting, mesh: &Mesh<N>, g: &Regge<f64, N>) -> [Vec<f64>; 2] {
    let rule = Rule::new(N - 2, at.order);
    let g = Seen::<f64, N, _>::new(g, N - 2, &rule);
    both_sides(mesh, N - 2, &rule, &|side, p| {
        let value = g.value(side, p);
        vec![HingeTerms::new::<N>(&at.formulas, &value, &value, side.place).omega]
    })
}

impl OnMesh for M20 {
    const RECORD: Record = Record {
        label: "M20",
        paper: &["thm:distcurvdot", "normSgsigma"],
        title: "On Regge spaces 𝕊σ(n,n), ω_F and ω_S are single-valued",
        statement: r"\mathbb{S}\sigma(n,n) = -\operatorname{Tr}(\sigma|_F),\quad \mathbb{S}\sigma^+(n^+,n^+) =
            \mathbb{S}\sigma^-(n^-,n^-),\quad \omega_F^+=\omega_F^-,\ \omega_S^+=\omega_S^-",
        sides: "The two cells of a face: different components of g and σ in different coordinates, and different normals.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        at_points(quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let apart = torn(&mesh);
        let regge = ReggeSpace::new(&mesh, at.degree);
        let loose = ReggeSpace::new(&apart, at.degree);
        let (g, sigma) = (wild(&regge, draw, at.noise), variation(&regge, draw));
        let (torn_g, torn_sigma) = (wild(&loose, draw, at.noise), variation(&loose, draw));
        let mut all = reversed_traces::<N>(at, &mesh, &g, [&sigma, &torn_sigma]);
        all.extend(measures::<N>(at, &mesh, [&g, &torn_g], &sigma));
        all
    }
}

/// 𝕊σ(n,n) from both sides; σ and a σ without continuity.
fn reversed_traces<const N: usize>(
    at: &Setting,
    mesh: &Mesh<N>,
    g: &Regge<f64, N>,
    [sigma, torn]: [&Regge<f64, N>; 2],
) -> Vec<Equation<f64>> {
    let faces = |q| on_faces(at, mesh, g, sigma, q);
    let [plus, minus] = faces(|q| q.s_nn);
    let [trace, _] = faces(|q| -q.trace);
    let [_, broken] = on_faces(at, mesh, g, torn, |q| q.s_nn);
    let plain = ["from T+", "from T−"].into_iter().zip(faces(|q| q.nn));
    vec![
        Equation::new("𝕊σ(n,n)")
            .left("from T+", plus.clone())
            .right("from T−", minus)
            .forge("tt-continuity of σ broken", "from T−", broken)
            .forge_terms("σ(n,n) for 𝕊σ(n,n)", plain.collect()),
        Equation::new("−Tr(σ|_F)")
            .left("𝕊σ(n,n)", plus)
            .right("−Tr(σ|_F)", trace),
    ]
}

/// ω_F and ω_S from both sides; g and a g without continuity.
fn measures<const N: usize>(
    at: &Setting,
    mesh: &Mesh<N>,
    [g, torn]: [&Regge<f64, N>; 2],
    sigma: &Regge<f64, N>,
) -> Vec<Equation<f64>> {
    let faces = |g| on_faces(at, mesh, g, sigma, |q| q.omega);
    let ([plus, minus], [_, broken]) = (faces(g), faces(torn));
    let hinges = |g| on_hinges(at, mesh, g);
    let ([first, last], [_, broken_last]) = (hinges(g), hinges(torn));
    vec![
        Equation::new("ω_F")
            .left("from T+", plus)
            .right("from T−", minus)
            .forge("tt-continuity of g broken", "from T−", broken),
        Equation::new("ω_S")
            .left("from the first cell", first)
            .right("from the last cell", last)
            .forge(
                "tt-continuity of g broken",
                "from the last cell",
                broken_last,
            )
            .vacuous(N == 2, "ω_S = 1 when N = 2"),
    ]
}

/// What two cells see at a point of their face satisfies the equations of D13.
impl Pointwise for M20 {
    const RECORD: Record = <Self as OnMesh>::RECORD;
    const DIMENSIONS: &'static [usize] = &[2, 3, 4];
    const OVER: Over = Over::Integers;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        D13::equations::<S, N>(i)
    }
}
