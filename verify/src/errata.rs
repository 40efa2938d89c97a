//! Floor 5 of the verification. The errata of the paper, with numbers computed here.
//!
//! [`page`] makes docs/errata.md; `verify/tests/all/errata.rs` keeps the committed page up to date.

use crate::claims::second_variation;
use crate::harness::{Draw, Key};
use regge_curvature::Error;
use regge_curvature::interpolate::{Canonical, Interpolant};
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::{Smooth, SmoothTensor};
use regge_curvature::scalar::Real;
use regge_curvature::spaces::ReggeSpace;
use regge_study::{Case, ProjectionKind, Quadrature, Quantity, Study, printed};

/// d²/dt² of the total curvature at the flat torus by hyper-dual numbers, and the printed formula for it.
pub fn conormal() -> (f64, f64) {
    let key = Key {
        seed: crate::Options::default().seed,
        label: "errata",
        dimension: 3,
        method: "AD",
        case: 0,
    };
    second_variation(&mut Draw::new(&key))
}

/// e^{−ky} dx².
struct Layer(f64);

impl SmoothTensor<2> for Layer {
    fn at<S: Real>(&self, x: &[S; 2]) -> Mat<S, 2> {
        let value = (x[1] * S::from_f64(-self.0)).exp();
        symmetric(|i, j| if i + j == 0 { value } else { S::zero() })
    }
}

/// (ℓ(g), ‖g‖_{L²(T)}) for g = e^{−ky} dx² on the reference triangle, ℓ the canonical degree of freedom of the edge
/// y = 0 for r = 0.
///
/// # Errors
/// Never: the triangle has coordinates.
pub fn scaling(k: f64) -> Result<(f64, f64), Error> {
    let mesh = Mesh::<2>::single()?;
    let space = ReggeSpace::new(&mesh, 0);
    let g = Smooth::new(&mesh, Layer(k))?;
    let values: Vec<f64> = Canonical::new(&space).evaluate(&g, 2);
    // ∫₀¹ (1−y) e^{−2ky} dy.
    let square = 1.0 / (2.0 * k) - (1.0 - (-2.0 * k).exp()) / (4.0 * k * k);
    Ok((values[0], square.sqrt()))
}

/// The error of the paper's example for N = 2, r = 0, 1, 2, on one level.
///
/// # Errors
/// If the study cannot be computed.
pub fn errors(
    level: u32,
    interpolant: Interpolant,
    projection: ProjectionKind,
    quadrature: Quadrature,
) -> Result<Vec<f64>, Error> {
    let study = Study {
        metric: Metric::GraphQuartic,
        dimension: 2,
        quantity: Quantity::CurvatureError,
        interpolants: vec![interpolant],
        projection,
        quadrature,
        seed: 1,
        cases: (0..3).map(|degree| Case { degree, level }).collect(),
    };
    let rows = study.run(&mut |_| ()).map_err(|failure| failure.error)?;
    Ok(rows.iter().map(|r| r.error).collect())
}

/// The errors of the paper's example for N = 2, r = 2, levels 4, 5, 6, by the rules of the original program as far as they are
/// known, over what the tables print.
///
/// # Errors
/// If the study cannot be computed.
pub fn over_printed(interpolant: Interpolant) -> Result<Vec<f64>, Error> {
    let study = |interpolants| Study {
        metric: Metric::GraphQuartic,
        dimension: 2,
        quantity: Quantity::CurvatureError,
        interpolants,
        projection: ProjectionKind::Discrete,
        quadrature: Quadrature::AS_PRINTED,
        seed: 3,
        cases: (4..7).map(|level| Case { degree: 2, level }).collect(),
    };
    let printed = printed::series(
        Metric::GraphQuartic,
        2,
        Quantity::CurvatureError,
        2,
        &Interpolant::average_hierarchical(),
    );
    let rows = study(vec![interpolant]).run(&mut |_| ());
    let rows = rows.map_err(|failure| failure.error)?;
    let ratio = |row: &regge_study::Row| Some(row.error / printed?.error(row.level)?);
    Ok(rows.iter().filter_map(ratio).collect())
}

/// The page.
///
/// # Errors
/// If a number cannot be computed.
pub fn page() -> Result<String, Error> {
    Ok([
        HEAD.to_owned(),
        conormal_section(),
        scaling_section()?,
        quadrature_section()?,
        interpolant_section()?,
        SMALL.to_owned(),
    ]
    .join("\n"))
}

fn conormal_section() -> String {
    let (second, printed) = conormal();
    format!(
        "{CONORMAL}
For one random σ of degree 0 on the flat 3-torus of 162 tetrahedra, d²/dt²⟨(Rω)_dist(δ+tσ), 1⟩ at t = 0:

| | |
|---|---|
| by hyper-dual numbers through the functional | {second:.7} |
| the last remark of section 3.2, τ as printed | {printed:.7} |
| the same with τ = ν_F | {:.7} |

`regge-verify --only M02 --only M03 --only M04 --only M13`: the printed sign is a forgery there, and is caught.
",
        -printed
    )
}

fn scaling_section() -> Result<String, Error> {
    let mut rows = String::new();
    for k in [1.0, 10.0, 100.0, 1000.0] {
        let (value, norm) = scaling(k)?;
        rows += &format!("| {k} | {value:.6} | {norm:.6} | {:.4} |\n", value / norm);
    }
    Ok(format!(
        "{SCALING}\n| k | ℓ(g) | ‖g‖_L²(T) | quotient |\n|---|---|---|---|\n{rows}\n`cargo test -p regge-verify errata`\n"
    ))
}

fn quadrature_section() -> Result<String, Error> {
    let hierarchical = Interpolant::average_hierarchical();
    let printed = errors(
        0,
        hierarchical,
        ProjectionKind::Discrete,
        Quadrature::AS_PRINTED,
    )?;
    let exact = errors(
        0,
        hierarchical,
        ProjectionKind::Discrete,
        Quadrature::CONVERGED,
    )?;
    let table = [0.223745609409278, 0.0861267946606119, 0.0271990483397802];
    let mut rows = String::new();
    for r in 0..3 {
        rows += &format!(
            "| {r} | {} | {:.10} | {:.6} |\n",
            table[r], printed[r], exact[r]
        );
    }
    Ok(format!(
        "{QUADRATURE}\n| r | printed | the paper's rules | converged rules |\n|---|---|---|---|\n{rows}
`regge reproduce table1 --levels 0 --as-printed` and `regge reproduce table1 --levels 0 --projection discrete`
"
    ))
}

fn interpolant_section() -> Result<String, Error> {
    let of = |i| errors(2, i, ProjectionKind::Exact, Quadrature::CONVERGED);
    let (appendix, tables) = (
        of(Interpolant::average())?,
        of(Interpolant::average_hierarchical())?,
    );
    let mut rows = String::new();
    for r in 0..3 {
        rows += &format!("| {r} | {:.6e} | {:.6e} |\n", appendix[r], tables[r]);
    }
    let mut ratios = String::new();
    for interpolant in [Interpolant::average(), Interpolant::average_hierarchical()] {
        let over = over_printed(interpolant)?;
        let over: Vec<String> = over.iter().map(|x| format!("{x:.2}")).collect();
        ratios += &format!("| {} | {} |\n", interpolant.name(), over.join(" | "));
    }
    Ok(format!(
        "{INTERPOLANT}\n| r | the appendix | the tables |\n|---|---|---|\n{rows}
`regge converge --metric graph-quartic --degree 0,1,2 --levels 2 --seed 1 --interpolant average,average-hierarchical`

{WHICH}
| error over printed, r = 2 | k = 4 | k = 5 | k = 6 |
|---|---|---|---|
{ratios}
`regge reproduce table1 --as-printed --interpolant average`, and without `--interpolant`
"
    ))
}

const HEAD: &str = "\
# Errata

What we found in E. S. Gawlik and M. Neunteufel, *Finite element approximation of scalar curvature in arbitrary
dimension*, while verifying it. The theorems stand. Each entry says how to check it. This page is made by
`verify/src/errata.rs`; a test compares it with what the program computes.
";

const CONORMAL: &str = "\
## 1. The direction of τ in lemma:angledefectdot

The lemma says that τ points into F from S. With this τ the sum over F has the wrong sign: it must be
∂_t(Θ_S ω_S) = ½(−Σ⟦σ(n,τ)⟧ + Θ_S Tr(σ|_S)) ω_S, or τ must be ν_F, which points out of F across S. Where it enters:

- lemma:angledefectdot and its equation angledefectdot;
- equation distcurvdot0, third term;
- lemma:IBPdivdivS, third term (its proof has ν_F, correctly, and renames it τ at the end);
- the last remark of section 3.2: the derivative of (Gω)_dist at the flat metric, and the second variation.

The two errors in the proof of thm:distcurvdot cancel: the theorem is right.
";

const SCALING: &str = "\
## 2. scaling2 in the appendix

|ℓ_i(g)| ≤ C h^{2−N/p} ‖g‖_{L^p(T)} is true for polynomials of a fixed degree and for p = ∞. It is applied to ḡ_h − g,
which is no polynomial, and for p < ∞ it is false: integrals over edges are not bounded in L^p of a cell. For
g = e^{−ky} dx² on the triangle with corners (0,0), (1,0), (0,1), the integral of g(t,t) over the edge y = 0 is 1 for all
k, and ‖g‖ tends to 0. A repair is to add h^s |g|_{W^{s,p}(T)}, s > (N−1)/p, on the right; errorterm2 survives.
";

const QUADRATURE: &str = "\
## 3. The quadrature of the tables

The norms of the tables were integrated by rules of low order. On the coarsest mesh of N = 2 (which is not random, so
that the row can be computed again) the printed numbers come out by the rules of the original program: to ten digits for
r = 0 and 1, to 2·10⁻⁵ of themselves for r = 2. With converged rules and the same g_h they are other numbers, by up to a
fifth. The rates are not affected.
";

const INTERPOLANT: &str = "\
## 4. The interpolant of the tables is not that of the appendix

The appendix averages canonical degrees of freedom. The tables averaged the coefficients of a hierarchical basis, which
for r ≥ 1 is another interpolant. Both have the same rates. Errors for N = 2, k = 2, on one mesh:
";

const WHICH: &str = "\
Which one the tables have is decided by r = 2, where the random meshes of the finer levels scatter by a few per cent only. With
the program's own quadrature, error over printed error for N = 2. (For r = 1 it decides nothing: with the local projection of
the tables, which interpolates, both averages agree.)
";

const SMALL: &str = "\
## 5. Small things

- lemma:einbound: the constant depends on |g|_{W^{2,∞}} too (only cor:conv lists it). That of thm:conv (ii) need not: with
  C_0, C_1, C_2 as there and h ≤ h_0, max_T |∂²g| ≤ C_0 h_T⁻¹ |g_h − g|_{W^{1,∞}(T)} + C_2 + 1, G is affine in second
  derivatives, and the prefactor has the first term already. h_0 depends on the modulus of continuity of ∂²g then, and on
  how fast ‖g_h − g‖_{L^∞} tends to 0.
- The label Hdot is there twice, so that a reference to it means the second of two equations.
- Three times ⟨(Rω)_dist(g), 1⟩ is paired in Σ', Σ; it is a functional on V.
- Proof of normv: ‖∇_g∇_g v‖ is the norm of L²(Ω, g).
- Proof of lemma:covdot, last lines: the ♯ is missing (`regge-verify --only P06`).
- Section 2.2 speaks of a right-handed frame n, τ_i; with outward n on both sides of F it cannot be so on both.
  Nothing depends on it.
- F± and T± in the definition of Θ_S are two faces of one cell; elsewhere they are the two cells of one face.
- Section 5: the meshes for N = 2 are not uniformly shape regular, as the theory assumes. Inner vertices move by up to a
  quarter of a box in each direction, and (1/4, −1/4), (3/4, 1/4), (5/4, 3/4), where the corners (0, 0), (1, 0), (1, 1) of
  a cell may go, are on a line: there is no C_0 for the family. (For N = 3 a cell keeps at least 0.081 of its volume.)
- Section 5: the critical term \"stagnates at about 4·10⁻⁴\"; the plotted values are 2.8·10⁻⁴ to 3.3·10⁻⁴.
";
