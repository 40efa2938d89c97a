//! The introduction: four earlier results in their own norms, and where these norms are too strong.

use crate::claim::{Claim, Effort};
use crate::errors::{biased, dual_norm_named, rules};
use crate::families::{mesh, near, smooth};
use crate::fields::Dome;
use crate::finding::Finding;
use crate::projected::Projected;
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::{Smooth, SmoothTensor};
use regge_curvature::norm::{Energy, Riesz, Setting, metric_values};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};
use regge_study::Quantity;

/// An interpolant of degree r, with quadrature that leaves no trace.
fn interpolated<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<M, N>,
    r: usize,
    interpolant: &Interpolant,
) -> Result<ReggeFunction<f64, N>, Error> {
    let space = ReggeSpace::new(g.mesh(), r);
    interpolant.with_order(2 * r + 6).apply(&space, g)
}

/// What g_h is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Made {
    Canonical,
    Average,
    /// The canonical interpolant with noise of the order h^{r+1}, in a periodic pattern: of optimal order, and no better than that.
    Noisy,
    /// With noise of the order h^r: of no optimal order.
    TooNoisy,
}

impl Made {
    fn name(self) -> &'static str {
        match self {
            Self::Canonical => "canonical",
            Self::Average => "average",
            Self::Noisy => "with noise",
            Self::TooNoisy => "with noise of h^r",
        }
    }

    fn of(self, g: &Smooth<Dome, 2>, r: usize, seed: u64) -> Result<ReggeFunction<f64, 2>, Error> {
        let h = 0.5 * g.mesh().mesh_size();
        match self {
            Self::Canonical => interpolated(g, r, &Interpolant::canonical()),
            Self::Average => interpolated(g, r, &Interpolant::average()),
            Self::Noisy => near(g, r, 0.05 * h.powi(r as i32 + 1), seed),
            Self::TooNoisy => near(g, r, 0.4 * h.powi(r as i32), seed),
        }
    }
}

/// ‖R_h^(q) − R‖ in H⁻¹(Ω, g) and in the broken H⁰, H¹, H², N = 2. The curvature of the metric vanishes on the boundary, as the
/// functions do onto which is projected.
fn projected(
    side: usize,
    seed: u64,
    [r, q]: [usize; 2],
    made: Made,
) -> Result<(f64, [f64; 4]), Error> {
    let mesh = mesh::<2>(side, seed)?;
    let g = Smooth::new(&mesh, Dome)?;
    let g_h = made.of(&g, r, seed)?;
    let projected = Projected::new(&g, &g_h, q)?;
    let values = metric_values(&g);
    let setting = Setting::new(&mesh, q.max(r) + 2).with_metric(&values);
    let norm = Riesz::new(Energy::Dirichlet, &setting)?;
    let dual = projected.in_dual(&norm)?;
    let [l2, h1, h2] = [0, 1, 2].map(|k| projected.broken(k));
    Ok((mesh.mesh_size(), [dual, l2, h1, h2]))
}

const NORMS: [&str; 4] = ["H⁻¹(Ω, g)", "L²", "broken H¹", "broken H²"];

/// Findings in as many of the norms as orders are stated; forged is the same for another metric.
fn in_norms(
    effort: &Effort,
    degrees: [usize; 2],
    [made, wrong]: [Made; 2],
    orders: &[usize],
) -> Result<Vec<Finding>, Error> {
    let sides = effort.levels(&[8, 16, 32, 64], 3);
    let of = |made| effort.sweep(sides, &|side, seed| projected(side, seed, degrees, made));
    let (stated, forged) = (of(made)?, of(wrong)?);
    let all = orders.iter().zip(NORMS).zip(stated.into_iter().zip(forged));
    Ok(all
        .map(|((order, norm), (series, forged))| {
            let [r, q] = degrees;
            let case = format!("r = {r}, q = {q}, {}, {norm}", made.name());
            let finding = Finding::new(case, Rule::Order(*order as f64), series);
            finding.forge(wrong.name(), forged)
        })
        .collect())
}

/// Gawlik 2020.
pub const A26: Claim = Claim {
    label: "A26",
    paper: &["sec:intro"],
    title: "Earlier results: the projected curvature of an optimal-order interpolant, N = 2 (Gawlik)",
    statement: r"\|R_h^{(q)}(g_h)-R(g)\|_{H^{-1}(\Omega,g)} = O(h^r),\quad |R_h^{(q)}(g_h)-R(g)|_{H^k(\mathcal T)} = O(h^{r-k-1}),
        \ 0\le k\le r-2,\quad r\ge1,\ q\ge\max(1,r-2)",
    how: "Introduction, second result. R_h^(q) by the library, q = max(1, r−2), for the average and for the canonical interpolant with noise of h^{r+1} in its coefficients, \
        interpolants of optimal order that are not canonical. The norm of H⁻¹(Ω, g) by Poisson's problem with functions of degree r + 2; the broken norms against a local polynomial of degree \
        q + 4. The metric is flat near the boundary, where the functions vanish that R_h is one of. Forged: noise of h^r, which is of no optimal order; by inverse inequalities every order is one less.",
    measure: gawlik,
};

fn gawlik(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    for r in 1..if effort.quick { 3 } else { 4 } {
        let orders: Vec<usize> = [r].into_iter().chain((1..r).rev()).collect();
        for made in [Made::Average, Made::Noisy] {
            all.extend(in_norms(effort, [r, 1], [made, Made::TooNoisy], &orders)?);
        }
    }
    Ok(all)
}

/// Gopalakrishnan, Neunteufel, Schöberl and Wardetzky.
pub const A28: Claim = Claim {
    label: "A28",
    paper: &["sec:intro"],
    title: "Earlier results: the projected curvature of the canonical interpolant, N = 2 (Gopalakrishnan and others)",
    statement: r"\|R_h^{(r+1)}(g_h)-R(g)\|_{H^{-1}(\Omega,g)} = O(h^{r+1}),\quad |R_h^{(r+1)}(g_h)-R(g)|_{H^k(\mathcal T)} = O(h^{r-k}),
        \ 0\le k\le r-1,\quad r\ge0",
    how: "Introduction, fourth result: as A26, for the canonical interpolant and q = r + 1. That an interpolant has optimal order does not do: with noise of h^{r+1} in \
        its coefficients all orders are one less, by inverse inequalities, and are refused; for r = 0 so is the average.",
    measure: canonical,
};

fn canonical(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    for r in 0..if effort.quick { 2 } else { 3 } {
        let orders: Vec<usize> = [r + 1].into_iter().chain((0..r).map(|k| r - k)).collect();
        let wrong = if r == 0 { Made::Average } else { Made::Noisy };
        all.extend(in_norms(
            effort,
            [r, r + 1],
            [Made::Canonical, wrong],
            &orders,
        )?);
    }
    Ok(all)
}

/// Berchenko-Kogan and Gawlik.
pub const A27: Claim = Claim {
    label: "A27",
    paper: &["sec:intro", "Vdef"],
    title: "Earlier results: the error in the dual of V, N = 2 (Berchenko-Kogan and Gawlik)",
    statement: r"\|(R\omega)_{\rm dist}(g_h)-(R\omega)(g)\|_{V',h} = O(h^r),\quad r\ge1,\qquad
        \|v\|_{V,h} = |v|_{H^1(\Omega)}+\Big(\sum_Th_T^2|v|_{H^2(T)}^2\Big)^{1/2}",
    how: "Introduction, third result. The norm by its Riesz problem in Lagrange functions of degree r + 3, with the squares of the two parts \
        of ‖v‖_{V,h} added, which changes it by a factor of √2 at most. The average, the canonical interpolant with periodic noise of \
        its order, and biased.",
    measure: in_v,
};

/// The error of g_h in V′_h: of the average, with noise, biased; of the canonical interpolant.
fn errors_in_v(side: usize, seed: u64, r: usize) -> Result<(f64, [f64; 4]), Error> {
    let mesh = mesh::<2>(side, seed)?;
    let (g, norm) = (smooth(&mesh)?, dual_norm_named("vh", &mesh, r)?);
    let size = 0.05 * (0.5 * mesh.mesh_size()).powi(r as i32 + 1);
    let all = [
        interpolated(&g, r, &Interpolant::average())?,
        near(&g, r, size, seed)?,
        biased(&g, r, size)?,
        interpolated(&g, r, &Interpolant::canonical())?,
    ];
    let mut errors = [0.0; 4];
    for (error, g_h) in errors.iter_mut().zip(&all) {
        let load = Quantity::CurvatureError.load(&g, g_h, norm.space(), &rules(2, r + 1));
        *error = norm.of(&load, None)?.total;
    }
    Ok((mesh.mesh_size(), errors))
}

fn in_v(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let sides = effort.levels(&[8, 16, 32, 64], 3);
    for r in 1..3 {
        let series = effort.sweep(sides, &|side, seed| errors_in_v(side, seed, r))?;
        let names = ["average", "with noise", "biased", "canonical"];
        for (name, series) in names.into_iter().zip(series) {
            let finding = Finding::new(format!("r = {r}, {name}"), Rule::Order(r as f64), series);
            let wrong = Rule::Order(r as f64 + 1.5);
            all.push(finding.forge_claim("an order and a half more", wrong));
        }
    }
    Ok(all)
}

/// Why H⁻².
pub const A29: Claim = Claim {
    label: "A29",
    paper: &["sec:intro"],
    title: "In norms stronger than that of H⁻² the average does not converge, N = 2, r = 0",
    statement: r"N=2,\ r=0:\quad \|R_h^{(1)}(g_h)-R(g)\|_{H^{-1}(\Omega,g)},\ \|(R\omega)_{\rm dist}(g_h)-(R\omega)(g)\|_{V',h}
        \not\to 0\ \text{(average)},\qquad = O(h)\ \text{(canonical)}",
    how: "Introduction, “fails to hold in stronger norms when g_h is not the canonical interpolant”: the orders in H⁻¹(Ω, g) and in \
        V′_h of A26 and A27, on the same meshes and with the same metrics. Those of the average must be less than 0.3, those of the \
        canonical interpolant at least 1; each is the other's forgery.",
    measure: too_strong,
};

fn too_strong(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let sides = effort.levels(&[16, 32, 64, 128], 3);
    let in_dual = |side: usize, seed: u64| {
        let (h, [one, ..]) = projected(side, seed, [0, 1], Made::Average)?;
        let (_, [two, ..]) = projected(side, seed, [0, 1], Made::Canonical)?;
        let (_, [three, _, _, four]) = errors_in_v(side, seed, 0)?;
        Ok((h, [one, two, three, four]))
    };
    let [one, two, three, four] = effort.sweep(sides, &in_dual)?;
    let mut all = Vec::new();
    let mut add = |norm: &str, average: Series, canonical: Series| {
        let finding = |name: &str, rule, series: &Series| {
            Finding::new(format!("{name}, {norm}"), rule, series.clone())
        };
        let stalls = finding("average", Rule::Stalls(0.3), &average);
        all.push(stalls.forge("the canonical interpolant", canonical.clone()));
        let converges = finding("canonical", Rule::Order(1.0), &canonical);
        all.push(converges.forge("the average", average));
    };
    add("H⁻¹(Ω, g)", one, two);
    add("V′_h", three, four);
    Ok(all)
}
