//! M20, D14: what is single-valued where cells meet.

use crate::harness::{Draw, Equation, Excuses, Judgement, Record, Setting};
use crate::stage::fields::{Regge, Seen, both_sides, points_of, variation};
use crate::stage::mesh::{OnMesh, ROUNDING, at_points, torn};
use regge_curvature::linalg::Mat;
use regge_curvature::mesh::Mesh;
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::{Bernstein, subsets};
use regge_curvature::spaces::{Lagrange, ReggeSpace};

/// Traces.
pub struct D14;

/// g(t_ab, t_ab) for all edges ab of the simplex with these local vertices, from components in reference coordinates.
fn edge_values<const N: usize>(g: &Mat<f64, N>, on: &[usize]) -> Vec<f64> {
    let coordinate = |v: usize, i: usize| f64::from(u8::from(v == i + 1));
    let mut all = Vec::new();
    for edge in subsets(on.len(), 2) {
        let (a, b) = (on[edge[0]], on[edge[1]]);
        let mut sum = 0.0;
        for i in 0..N {
            for j in 0..N {
                let (ti, tj) = (
                    coordinate(b, i) - coordinate(a, i),
                    coordinate(b, j) - coordinate(a, j),
                );
                sum += g[(i, j)] * ti * tj;
            }
        }
        all.push(sum);
    }
    all
}

impl OnMesh for D14 {
    const RECORD: Record = Record {
        label: "D14",
        paper: &["Vdef", "sec:curvature"],
        title: "Traces on lower simplices are single-valued",
        statement: r"\sigma\in\Sigma:\ \sigma|_D \text{ is the same from every cell } T\supset D;\qquad v\in V:\ v|_D
            \text{ likewise}\qquad (1\le\dim D<N)",
        sides: "The first and the last cell around each simplex of dimension 1 to N − 1, each in its own coordinates.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    const EXCUSES: Excuses = Excuses::one_method(
        "it is about the numbering of the coefficients, which there is once for all scalars",
    );

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        at_points(quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let apart = torn(&mesh);
        let (regge, loose) = (
            ReggeSpace::new(&mesh, at.degree),
            ReggeSpace::new(&apart, at.degree),
        );
        let (sigma, torn_sigma) = (variation(&regge, draw), variation(&loose, draw));
        let space = Lagrange::new(&mesh, 2);
        let v = draw.numbers(space.len());
        let on_all = |of: &dyn Fn(usize) -> [Vec<f64>; 2]| -> [Vec<f64>; 2] {
            let [mut first, mut last] = [Vec::new(), Vec::new()];
            for k in 1..N {
                let [one, other] = of(k);
                first.extend(one);
                last.extend(other);
            }
            [first, last]
        };
        let [first, last] = on_all(&|k| of_field(&mesh, &sigma, k, at.order));
        let [_, broken] = on_all(&|k| of_field(&mesh, &torn_sigma, k, at.order));
        let [v_first, v_last] = on_all(&|k| of_function(&space, &v, k, at.order));
        vec![
            Equation::new("σ|_D")
                .left("from the first cell", first)
                .right("from the last cell", last)
                .forge("tt-continuity broken", "from the last cell", broken),
            Equation::new("v|_D")
                .left("from the first cell", v_first)
                .right("from the last cell", v_last),
        ]
    }
}

/// The edge components of σ on the k-simplices, from both sides.
fn of_field<const N: usize>(
    mesh: &Mesh<N>,
    sigma: &Regge<f64, N>,
    k: usize,
    order: usize,
) -> [Vec<f64>; 2] {
    let (rule, places) = (Rule::new(k, order), subsets(N + 1, k + 1));
    let seen = Seen::<f64, N, _>::new(sigma, k, &rule);
    both_sides(mesh, k, &rule, &|side, p| {
        edge_values(&seen.value(side, p), &places[side.place])
    })
}

/// v on the k-simplices, from both sides.
fn of_function<const N: usize>(
    space: &Lagrange<N>,
    v: &[f64],
    k: usize,
    order: usize,
) -> [Vec<f64>; 2] {
    let (rule, basis) = (Rule::new(k, order), Bernstein::new(N + 1, space.degree()));
    let points = points_of::<N>(k, &rule);
    let tables: Vec<Vec<Vec<f64>>> = points.iter().map(|p| basis.tabulate(p)).collect();
    both_sides(space.mesh(), k, &rule, &|side, p| {
        let terms = tables[side.place][p].iter().zip(space.cell_dofs(side.cell));
        vec![terms.map(|(b, d)| b * v[d]).sum()]
    })
}
