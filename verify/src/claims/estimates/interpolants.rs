//! I29: the canonical degrees of freedom and the averaged interpolant. N03, N04: the paper's meshes and dimensions.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, grid};
use crate::stage::fields::{Patch, function, variation};
use crate::stage::mesh::{OnMesh, torn};
use crate::stage::reference::{case_of, cases};
use regge_curvature::interpolate::{Canonical, Interpolant};
use regge_curvature::mesh::{Mesh, Slot};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::simplex::binomial;
use regge_curvature::spaces::{ReggeSpace, dofs_per_simplex};

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
        paper: &["appendix:optimalorder"],
        title: "The canonical degrees of freedom, J_h, and the averaged interpolant",
        statement: r"\ell_i(\psi_j)=\delta_{ij},\quad J_h^2=J_h,\quad \ell_i(g_h)=\ell_i(J_hg)+\frac{1}{|\omega_i|}
            \sum_{T\in\omega_i}\ell_i(\bar g_h|_T-g)",
        sides: "Left: the interpolant of the library. Right: the degrees of freedom of the local projections, taken on every \
            cell by itself, on a mesh without connections. As an oracle: NGSolve's interpolants of the same metrics.",
    };
    /// The dual basis is found by inverting small matrices, of condition below 10³ for r ≤ 2.
    const JUDGEMENT: Judgement = Judgement::Rounding { tolerance: 1e-11 };
    const DIMENSIONS: &'static [usize] = &[2, 3];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let shapes = [Shape::Alfeld, Shape::Cube(2)];
        match (dimension, quick) {
            (_, true) => grid(&shapes[..1], &[8, 8, 8], 1),
            (2, false) => grid(&shapes, &[8, 8, 8], 6),
            _ => {
                let mut all = grid(&shapes[..1], &[8, 8, 8], 9);
                all.extend(grid(&shapes[1..], &[8, 8, 8], 1));
                all
            }
        }
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let space = ReggeSpace::new(&mesh, at.degree);
        let canonical = Canonical::new(&space);
        let exact = 2 * at.degree + 1;
        // One random combination of all ψ_j checks the row sums of δ_ij; a false entry survives with probability 0.
        let c = draw.numbers(space.len());
        let psi = function(&space, canonical.solve(&c));
        let regge = variation(&space, draw);
        let again = canonical.solve(&canonical.evaluate(&regge, exact));
        let mut all = vec![
            Equation::new("duality")
                .left("ℓ_i(Σc_jψ_j)", canonical.evaluate(&psi, exact))
                .right("c_i", c),
            Equation::new("projector")
                .left("J_hσ", again)
                .right("σ", regge.coefficients().to_vec()),
        ];
        let formula = Patch::new(Metric::Trig, draw);
        all.push(average(&space, &canonical, formula));
        all
    }
}

/// ℓ_i(g_h) of the averaged interpolant g_h of a smooth metric.
fn average<const N: usize>(
    space: &ReggeSpace<N>,
    canonical: &Canonical<N>,
    formula: Patch<N>,
) -> Equation<f64> {
    let apart = torn(space.mesh());
    let loose = ReggeSpace::new(&apart, space.degree());
    let on = |mesh| Smooth::new(mesh, formula).expect("the mesh has coordinates");
    let (g, on_apart) = (on(space.mesh()), on(&apart));
    let interpolant = Interpolant::average();
    let g_h = interpolant.apply(space, &g).expect("it is near g");
    // Nothing is shared on the mesh without connections: the average is the projection itself.
    let projected = interpolant.apply(&loose, &on_apart).expect("it is near g");
    // Integrals over edges and faces of a smooth metric, to rounding.
    let (order, by_cell) = (16, Canonical::new(&loose));
    let of_projection: Vec<f64> = by_cell.evaluate(&projected, order);
    let of_g: Vec<f64> = by_cell.evaluate(&on_apart, order);
    let difference: Vec<f64> = (of_projection.iter().zip(of_g))
        .map(|(p, g)| p - g)
        .collect();
    Equation::new("average")
        .left("ℓ_i(g_h)", canonical.evaluate(&g_h, order))
        .right("ℓ_i(J_hg)", canonical.evaluate(&g, order))
        .right("mean ℓ_i(ḡ_h−g)", averaged(space, &loose, &difference))
}

/// NGSolve's interpolants.
pub struct InterpolantOracle;

impl OnMesh for InterpolantOracle {
    const RECORD: Record = I29::RECORD;
    const METHOD: Method = Method::Oracle;
    /// What NGSolve's integration of a metric that is no polynomial leaves.
    const JUDGEMENT: Judgement = Judgement::Rounding { tolerance: 1e-9 };
    const DIMENSIONS: &'static [usize] = I29::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |_| true)
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh: Mesh<N> = case.mesh();
        let regge = ReggeSpace::new(&mesh, case.degree);
        let g = Smooth::new(&mesh, case.formula()).expect("the mesh has coordinates");
        let (canonical, same) = (case.interpolant == "canonical", case.degree == 0);
        let interpolant = if canonical {
            Interpolant::canonical()
        } else {
            Interpolant::average_hierarchical()
        }
        .with_order(at.order);
        let other = Interpolant::average();
        let by = |i: &Interpolant| {
            let g_h = i.apply(&regge, &g).expect("it is near g");
            g_h.coefficients().to_vec()
        };
        vec![
            Equation::new("coefficients")
                .left("g_h", by(&interpolant))
                .right("NGSolve's g_h", case.metric(&regge).coefficients().to_vec())
                .forge("another interpolant", "g_h", by(&other))
                .vacuous(same && !canonical, "for r = 0 both averages are one"),
        ]
    }
}
