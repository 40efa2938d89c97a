//! M20, D14: what is single-valued where cells meet.

use super::density::{FaceTerms, HingeTerms, Seen};
use super::fields::{Regge, metric, torn, variation};
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape, grid};
use crate::claim::{Equation, Excuses, Judgement, Record};
use regge_curvature::field::TensorField;
use regge_curvature::formulas::Formulas;
use regge_curvature::linalg::Mat;
use regge_curvature::mesh::{Mesh, Side};
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::{Bernstein, subsets};
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::ReggeSpace;

fn some(dimension: usize, quick: bool) -> Vec<Setting> {
    let times = if quick { 1 } else { 4 };
    match dimension {
        2..=4 => grid(&[Shape::Alfeld, Shape::Sphere], &[3, 3, 3], times),
        _ => Vec::new(),
    }
}

/// A quantity at every point of every interior simplex of dimension k: as the first cell sees it, and as the last.
fn both_sides<const N: usize>(
    mesh: &Mesh<N>,
    k: usize,
    rule: &Rule,
    q: impl Fn(Side, usize) -> Vec<f64>,
) -> [Vec<f64>; 2] {
    let mut sides = [Vec::new(), Vec::new()];
    for simplex in mesh.interior(k) {
        let around: Vec<Side> = mesh.star(k, simplex).collect();
        for p in 0..rule.len() {
            sides[0].extend(q(around[0], p));
            sides[1].extend(q(around[around.len() - 1], p));
        }
    }
    sides
}

/// 𝕊σ(n,n), ω_F, ω_S.
pub struct M20;

/// 𝕊σ(n,n), −Tr(σ|_F), σ(n,n) and ω_F from both sides of the faces.
fn on_faces<K: Formulas, const N: usize, G: TensorField<f64, N>, H: TensorField<f64, N>>(
    mesh: &Mesh<N>,
    g: &G,
    sigma: &H,
    rule: &Rule,
    which: fn(&FaceTerms) -> f64,
) -> [Vec<f64>; 2] {
    let g = Seen::<f64, N, _>::new(g, N - 1, rule);
    let sigma = Seen::<f64, N, _>::new(sigma, N - 1, rule);
    both_sides(mesh, N - 1, rule, |side, p| {
        let terms = FaceTerms::new::<K, N>(&g.jet2(side, p), &sigma.jet1(side, p), side.place);
        vec![which(&terms)]
    })
}

/// ω_S from the first and the last cell around the hinges.
fn on_hinges<K: Formulas, const N: usize, G: TensorField<f64, N>>(
    mesh: &Mesh<N>,
    g: &G,
    rule: &Rule,
) -> [Vec<f64>; 2] {
    let g = Seen::<f64, N, _>::new(g, N - 2, rule);
    both_sides(mesh, N - 2, rule, |side, p| {
        let value = g.value(side, p);
        vec![HingeTerms::<f64>::new::<K, N>(&value, &value, side.place).omega]
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

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        some(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let apart = torn(&mesh);
        let regge = ReggeSpace::new(&mesh, at.degree);
        let loose = ReggeSpace::new(&apart, at.degree);
        let (g, sigma) = (metric(&regge, draw), variation(&regge, draw));
        let (torn_g, torn_sigma) = (metric(&loose, draw), variation(&loose, draw));
        let mut all = reversed_traces::<K, N>(&mesh, &g, &sigma, &torn_sigma, at.order);
        all.extend(measures::<K, N>(&mesh, [&g, &torn_g], &sigma, at.order));
        all
    }
}

/// 𝕊σ(n,n) from both sides; σ and a σ without continuity.
fn reversed_traces<K: Formulas, const N: usize>(
    mesh: &Mesh<N>,
    g: &Regge<f64, N>,
    sigma: &Regge<f64, N>,
    torn: &Regge<f64, N>,
    order: usize,
) -> Vec<Equation<f64>> {
    let rule = Rule::new(N - 1, order);
    let faces = |q| on_faces::<K, N, _, _>(mesh, g, sigma, &rule, q);
    let [plus, minus] = faces(|q| q.s_nn);
    let [trace, _] = faces(|q| -q.trace);
    let [_, broken] = on_faces::<K, N, _, _>(mesh, g, torn, &rule, |q| q.s_nn);
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
fn measures<K: Formulas, const N: usize>(
    mesh: &Mesh<N>,
    [g, torn]: [&Regge<f64, N>; 2],
    sigma: &Regge<f64, N>,
    order: usize,
) -> Vec<Equation<f64>> {
    let (rule, hinge_rule) = (Rule::new(N - 1, order), Rule::new(N - 2, order));
    let faces = |g| on_faces::<K, N, _, _>(mesh, g, sigma, &rule, |q| q.omega);
    let ([plus, minus], [_, broken]) = (faces(g), faces(torn));
    let hinges = |g| on_hinges::<K, N, _>(mesh, g, &hinge_rule);
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

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        some(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
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
            let all: Vec<_> = (1..N).map(of).collect();
            [0, 1].map(|i| all.iter().flat_map(|sides| sides[i].clone()).collect())
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
    both_sides(mesh, k, &rule, |side, p| {
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
    let points = super::density::points_of::<N>(k, &rule);
    let tables: Vec<Vec<Vec<f64>>> = points.iter().map(|p| basis.tabulate(p)).collect();
    both_sides(space.mesh(), k, &rule, |side, p| {
        let terms = tables[side.place][p].iter().zip(space.cell_dofs(side.cell));
        vec![terms.map(|(b, d)| b * v[d]).sum()]
    })
}
