//! I29: the canonical degrees of freedom and the averaged interpolant. N03, N04: the paper's meshes and dimensions.

use super::fields::{function, torn, variation};
use super::patch::Patch;
use super::setting::{Draw, OnMesh, Setting, Shape, grid};
use crate::claim::{Equation, Excuses, Judgement, Method, Record};
use regge_curvature::formulas::Formulas;
use regge_curvature::interpolate::{Canonical, Interpolant};
use regge_curvature::mesh::{Mesh, Slot};
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::Smooth;
use regge_curvature::simplex::binomial;
use regge_curvature::spaces::{ReggeSpace, dofs_per_simplex};
use regge_study::Quantity;
use regge_study::printed::SERIES;

/// Duality, J_h, and averaging.
pub struct I29;

/// For every degree of freedom the mean over the cells that share it of its value on the mesh taken apart.
fn averaged<const N: usize>(
    space: &ReggeSpace<N>,
    loose: &ReggeSpace<N>,
    values: &[f64],
) -> Vec<f64> {
    let (mut sum, mut shares) = (vec![0.0; space.len()], vec![0.0; space.len()]);
    for cell in 0..space.mesh().cell_count() {
        for k in 1..=N {
            for place in 0..binomial(N + 1, k + 1) {
                for index in 0..dofs_per_simplex(space.degree(), k) {
                    let slot = Slot { k, place, index };
                    let here = space.numbering().of_cell(space.mesh(), cell, slot);
                    sum[here] += values[loose.numbering().of_cell(loose.mesh(), cell, slot)];
                    shares[here] += 1.0;
                }
            }
        }
    }
    sum.iter().zip(shares).map(|(s, n)| s / n).collect()
}

impl OnMesh for I29 {
    const RECORD: Record = Record {
        label: "I29",
        paper: &["appendix:optimalorder", "optimalorder"],
        title: "The canonical degrees of freedom, J_h, and the averaged interpolant",
        statement: r"\ell_i(\psi_j)=\delta_{ij},\quad J_h^2=J_h,\quad \ell_i(g_h)=\ell_i(J_hg)+\frac{1}{|\omega_i|}
            \sum_{T\in\omega_i}\ell_i(\bar g_h|_T-g)",
        sides: "Left: the interpolant of the library. Right: the degrees of freedom of the local projections, taken on every \
            cell by itself, on a mesh without connections. As an oracle: NGSolve's interpolants of the same metrics.",
    };
    /// The dual basis is found by inverting small matrices, of condition below 10³ for r ≤ 2.
    const JUDGEMENT: Judgement = Judgement::Rounding { tolerance: 1e-11 };

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let shapes = [Shape::Alfeld, Shape::Cube(2)];
        match (dimension, quick) {
            (2 | 3, true) => grid(&shapes[..1], &[8, 8, 8], 1),
            (2, false) => grid(&shapes, &[8, 8, 8], 6),
            (3, false) => {
                let mut all = grid(&shapes[..1], &[8, 8, 8], 9);
                all.extend(grid(&shapes[1..], &[8, 8, 8], 1));
                all
            }
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let space = ReggeSpace::new(&mesh, at.degree);
        let canonical = Canonical::new(&space);
        let exact = 2 * at.degree + 1;
        // One random combination of all ψ_j checks the row sums of δ_ij; a false entry survives with probability 0.
        let c = draw.numbers(space.len());
        let psi = function(&space, canonical.solve(&c));
        let regge = variation(&space, draw);
        let again = canonical.solve(&canonical.evaluate::<f64, _>(&regge, exact));
        let mut all = vec![
            Equation::new("duality")
                .left("ℓ_i(Σc_jψ_j)", canonical.evaluate::<f64, _>(&psi, exact))
                .right("c_i", c),
            Equation::new("projector")
                .left("J_hσ", again)
                .right("σ", regge.coefficients().to_vec()),
        ];
        let formula = Patch::new(Metric::Trig, draw);
        all.extend(average(&space, &canonical, formula));
        all
    }
}

/// ℓ_i(g_h) of the averaged interpolant g_h of a smooth metric. Nothing if that is not positive, which a smooth metric
/// on these meshes is.
fn average<const N: usize>(
    space: &ReggeSpace<N>,
    canonical: &Canonical<N>,
    formula: Patch<N>,
) -> Option<Equation<f64>> {
    let apart = torn(space.mesh());
    let loose = ReggeSpace::new(&apart, space.degree());
    let g = Smooth::new(space.mesh(), formula).ok()?;
    let on_apart = Smooth::new(&apart, formula).ok()?;
    let interpolant = Interpolant::average();
    let g_h = interpolant.apply(space, &g).ok()?;
    // Nothing is shared on the mesh without connections: the average is the projection itself.
    let projected = interpolant.apply(&loose, &on_apart).ok()?;
    // Integrals over edges and faces of a smooth metric, to rounding.
    let (order, by_cell) = (16, Canonical::new(&loose));
    let of_projection: Vec<f64> = by_cell.evaluate(&projected, order);
    let of_g: Vec<f64> = by_cell.evaluate(&on_apart, order);
    let difference: Vec<f64> = (of_projection.iter().zip(of_g))
        .map(|(p, g)| p - g)
        .collect();
    Some(
        Equation::new("average")
            .left("ℓ_i(g_h)", canonical.evaluate::<f64, _>(&g_h, order))
            .right("ℓ_i(J_hg)", canonical.evaluate::<f64, _>(&g, order))
            .right("mean ℓ_i(ḡ_h−g)", averaged(space, &loose, &difference)),
    )
}

/// The paper's meshes.
pub struct N03;

impl OnMesh for N03 {
    const RECORD: Record = Record {
        label: "N03",
        paper: &["sec:numerical"],
        title: "The meshes of the numerical section",
        statement: r"|\mathcal{T}^2|=2\cdot4^k,\ |\mathcal{T}^3|=6\cdot8^k,\quad\tilde h=\sqrt N\,2^{1-k},\quad\min_e|e|=2^{1-k},
            \quad|\delta x_i|\le\tilde h\,2^{-(2N+1)/2}",
        sides: "Left: the library's meshes, counted and measured. Right: the paper's formulas.",
    };
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = super::setting::ROUNDING;

    const EXCUSES: Excuses = Excuses::one_method("it compares data with data").few_cases(
        "all levels that the paper has and a computer counts in no time; nothing is random",
    );

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let levels = if quick { 3 } else { 4 };
        let of = |k: u32| Setting::new(Shape::Cube(1 << k), 0, 0);
        if (2..=3).contains(&dimension) {
            (0..levels).map(of).collect()
        } else {
            Vec::new()
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let Shape::Cube(side) = at.shape else {
            return Vec::new();
        };
        let k = side.trailing_zeros();
        let Ok(mesh) = Mesh::<N>::cube(side) else {
            return Vec::new();
        };
        let cells = if N == 2 {
            2 * 4usize.pow(k)
        } else {
            6 * 8usize.pow(k)
        };
        let least = 2f64.powi(1 - k as i32);
        let edges = (0..mesh.count(1)).map(|e| {
            let v = mesh.vertices(1, e);
            mesh.points()
                .map_or(f64::NAN, |p| (p[v[0] as usize] - p[v[1] as usize]).norm())
        });
        let h = (N as f64).sqrt() * least;
        // A quarter of a cell when N = 2, 0.153 of it when N = 3.
        let amplitude = h * 2f64.powf(-(2.0 * N as f64 + 1.0) / 2.0);
        let points = |m: Mesh<N>| -> Vec<f64> {
            m.points()
                .unwrap_or_default()
                .iter()
                .flatten()
                .copied()
                .collect()
        };
        let (Ok(paper), Ok(plain)) = (
            mesh.perturbed_as_in_paper(k, 5),
            mesh.perturbed(amplitude, 5),
        ) else {
            return Vec::new();
        };
        vec![
            Equation::new("cells")
                .left("|𝒯^N|", mesh.cell_count() as f64)
                .right("N! 2^{Nk}", cells as f64),
            Equation::new("h̃")
                .left("max h_T", mesh.mesh_size())
                .right("√N 2^{1−k}", h),
            Equation::new("shortest edge")
                .left("min |e|", edges.fold(f64::INFINITY, f64::min))
                .right("2^{1−k}", least),
            Equation::new("perturbation")
                .left("as in the paper", points(paper))
                .right("by amplitude", points(plain)),
        ]
    }
}

/// The numbers of degrees of freedom.
pub struct N04;

impl OnMesh for N04 {
    const RECORD: Record = Record {
        label: "N04",
        paper: &["fig:conv_plot"],
        title: "The plotted numbers of degrees of freedom",
        statement: r"N=2:\ (r+1)E+\tfrac32r(r+1)T;\qquad N=3:\ (r+1)E+\tfrac32r(r+1)F+(r+1)r(r-1)T",
        sides: "Left: dimensions of the library's spaces. Right: the abscissae of the paper's plots, and the formula.",
    };
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = super::setting::ROUNDING;

    const EXCUSES: Excuses = Excuses::one_method("it compares data with data").few_cases(
        "all levels that the paper has and a computer counts in no time; nothing is random",
    );

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let levels = if quick { 3 } else { 4 };
        let one = |r: usize| (0..levels).map(move |k| Setting::new(Shape::Cube(1 << k), r, 0));
        if (2..=3).contains(&dimension) {
            (0..3).flat_map(one).collect()
        } else {
            Vec::new()
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let Shape::Cube(side) = at.shape else {
            return Vec::new();
        };
        let Ok(mesh) = Mesh::<N>::cube(side) else {
            return Vec::new();
        };
        let space = ReggeSpace::new(&mesh, at.degree);
        let plotted = SERIES.iter().find(|s| {
            (s.dimension, s.degree, s.quantity, s.canonical)
                == (N, at.degree, Quantity::CurvatureError, false)
        });
        let expected = plotted.map_or(f64::NAN, |s| {
            s.points[side.trailing_zeros() as usize].0 as f64
        });
        let (r, count) = (at.degree as f64, |k: usize| mesh.count(k) as f64);
        let (edge, face) = (r + 1.0, 1.5 * r * (r + 1.0));
        let inner = if N == 3 {
            (r + 1.0) * r * (r - 1.0) * count(3)
        } else {
            0.0
        };
        vec![
            Equation::new("plotted")
                .left("dim", space.len() as f64)
                .right("ndof", expected),
            Equation::new("formula")
                .left("dim", space.len() as f64)
                .right("(r+1)E", edge * count(1))
                .right("3/2 r(r+1)F", face * count(2))
                .vanishes(at.degree == 0, "r = 0")
                .right("(r+1)r(r−1)T", inner)
                .vanishes(N == 2 || at.degree < 2, "no such functions"),
        ]
    }
}
