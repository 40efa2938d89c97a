//! Bounds over whole simplices hold at every point that is tried, are not much wider than what is found there, and a Regge
//! function that is no metric between the points where one looks is refused.

use crate::common::{crooked_cube, random_regge};
use regge_curvature::Error;
use regge_curvature::density::{Corner, Side as FaceSide, outward};
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::functional::{EnclosedCurvature, enclosed_curvature, proven_metric};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::jet::{Jet1, lower};
use regge_curvature::linalg::{Mat, Vector, inverse_and_det};
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::riemann::{Connection, Curvature};
use regge_curvature::scalar::Interval;
use regge_curvature::simplex::{Points, multi_indices, subsets};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};
use std::f64::consts::PI;

/// Points of a simplex: its vertices, and others at random.
fn points(vertices: usize, count: usize) -> Points {
    let mut random = SplitMix64::new(7);
    let mut lambda = Vec::new();
    for v in 0..vertices {
        lambda.extend((0..vertices).map(|w| f64::from(u8::from(v == w))));
    }
    for _ in 0..count {
        let weights: Vec<f64> = (0..vertices).map(|_| 1.0 + random.symmetric()).collect();
        let sum: f64 = weights.iter().sum();
        lambda.extend(weights.iter().map(|w| w / sum));
    }
    Points::new(vertices, lambda)
}

/// Σ of what each cell around a simplex makes of its metric, at the points on the simplex.
fn around<const N: usize>(
    g: &ReggeFunction<f64, N>,
    k: usize,
    simplex: usize,
    of: &dyn Fn(&Mat<Jet1<f64, N>, N>, &[Vector<f64, N>]) -> f64,
) -> Vec<f64> {
    let (mesh, on) = (g.space().mesh(), points(k + 1, 20));
    let mut sums = vec![0.0; on.len()];
    for side in mesh.star(k, simplex) {
        let vertices = &subsets(N + 1, k + 1)[side.place];
        let table = Evaluate::<f64, N>::tabulate(g, &on.embed(vertices, N + 1));
        let local = Evaluate::<f64, N>::on_cell(g, side.cell);
        let others = (0..=N).filter(|v| !vertices.contains(v));
        let nu: Vec<Vector<f64, N>> = others.map(outward).collect();
        for (q, sum) in sums.iter_mut().enumerate() {
            *sum += of(&g.jet1(&local, &table, q), &nu);
        }
    }
    sums
}

fn scalars<const N: usize>(g: &ReggeFunction<f64, N>, cell: usize) -> Vec<f64> {
    let on = points(N + 1, 20);
    let table = Evaluate::<f64, N>::tabulate(g, &on);
    let local = Evaluate::<f64, N>::on_cell(g, cell);
    let at = |q: usize| {
        let jets = g.jet2(&local, &table, q);
        Curvature::new(&jets, &Connection::new(&lower(&jets))).scalar()
    };
    (0..on.len()).map(at).collect()
}

fn jumps<const N: usize>(g: &ReggeFunction<f64, N>, face: usize) -> Vec<f64> {
    around(g, N - 1, face, &|jets, nu| {
        let connection = Connection::new(jets);
        FaceSide::new(&PAPER, &connection, &nu[0].map(Jet1::constant)).mean_curvature
    })
}

fn defects<const N: usize>(g: &ReggeFunction<f64, N>, hinge: usize) -> Vec<f64> {
    let angles = around(g, N - 2, hinge, &|jets, nu| {
        let (inverse, det) = inverse_and_det(&lower(jets));
        Corner::new(&PAPER, &inverse, det, [&nu[0], &nu[1]]).angle()
    });
    let full = if g.space().mesh().is_interior(N - 2, hinge) {
        2.0 * PI
    } else {
        PI
    };
    angles.iter().map(|sum| full - sum).collect()
}

/// All values lie inside, up to the rounding of the values themselves; of a value moved by `wrong` of the spread of all that is not
/// so. Returns the widths of bounds and values.
fn inside(bounds: Interval, values: &[f64]) -> [f64; 2] {
    // Derivatives of lengths are of size 1/h; values have some ten digits.
    let slack = 1e-10 * (1.0 + bounds.low().abs().max(bounds.high().abs()));
    for x in values {
        assert!(
            bounds.low() - slack <= *x && *x <= bounds.high() + slack,
            "{x} is not in {bounds:?}"
        );
    }
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert!(!bounds.contains(high + bounds.width() + slack));
    [bounds.width(), high - low]
}

fn check<const N: usize>(g: &ReggeFunction<f64, N>, most: f64) {
    let mesh = g.space().mesh();
    let EnclosedCurvature {
        scalar,
        jumps: on_faces,
        defects: on_hinges,
    } = enclosed_curvature(g).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(
        [scalar.len(), on_faces.len(), on_hinges.len()],
        [mesh.cell_count(), mesh.count(N - 1), mesh.count(N - 2)]
    );
    let of = |all: &[Interval], values: &dyn Fn(usize) -> Vec<f64>| {
        let mut widths = [0.0; 2];
        for (k, bounds) in all.iter().enumerate() {
            let magnitude = bounds.low().abs().max(bounds.high().abs());
            let [bounds, values] = inside(*bounds, &values(k));
            // Bounds need not be closer than a tenth.
            widths[0] += (bounds - 0.1 * magnitude).max(0.0);
            widths[1] += values;
        }
        widths
    };
    for [bounds, values] in [
        of(&scalar, &|cell| scalars(g, cell)),
        of(&on_faces, &|face| jumps(g, face)),
        of(&on_hinges, &|hinge| defects(g, hinge)),
    ] {
        assert!(bounds <= most * values + 1e-9, "{bounds} against {values}");
    }
}

#[test]
fn bounds_hold_and_are_close() {
    for degree in [1, 2] {
        let (two, three) = (crooked_cube::<2>(2, 1), crooked_cube::<3>(1, 1));
        check(&random_regge(&ReggeSpace::new(&two, degree), 0.05, 3), 4.0);
        check(
            &random_regge(&ReggeSpace::new(&three, degree), 0.02, 3),
            8.0,
        );
    }
    let sphere = Mesh::<4>::simplex_boundary().expect("a sphere");
    check(&random_regge(&ReggeSpace::new(&sphere, 1), 0.01, 3), 16.0);
}

#[test]
fn a_constant_metric_is_flat() {
    let mesh = crooked_cube::<3>(2, 5);
    for degree in [0, 2] {
        let flat = random_regge(&ReggeSpace::new(&mesh, degree), 0.0, 1);
        let found = enclosed_curvature(&flat).unwrap_or_else(|e| panic!("{e}"));
        let tight = |x: &Interval| x.contains(0.0) && x.width() < 1e-9;
        assert!(found.scalar.iter().all(tight) && found.jumps.iter().all(tight));
        assert!(
            mesh.interior_hinges()
                .all(|hinge| tight(&found.defects[hinge]))
        );
    }
}

/// Regge interpolants of degree 2 of the unit sphere: R is positive at every point of every cell, which is a theorem about each.
#[test]
fn the_curvature_is_positive_here() {
    fn positive<const N: usize>(side: usize) {
        let mesh = Mesh::<N>::cube(side).expect("a cube");
        let metric = Smooth::new(&mesh, Metric::Sphere).expect("coordinates");
        let space = ReggeSpace::new(&mesh, 2);
        let g = Interpolant::canonical()
            .apply(&space, &metric)
            .expect("a metric");
        let found = enclosed_curvature(&g).unwrap_or_else(|e| panic!("{e}"));
        assert!(
            found.scalar.iter().all(|x| x.is_positive()),
            "{:?}",
            found.scalar
        );
    }
    positive::<2>(16);
}

/// f δ on one triangle, f = Σ f_α B_α.
fn conformal(mesh: &Mesh<2>, f: &dyn Fn(&[usize]) -> f64) -> ReggeFunction<f64, 2> {
    let space = ReggeSpace::new(mesh, 2);
    let mut coefficients = vec![0.0; space.len()];
    for (e, edge) in subsets(3, 2).iter().enumerate() {
        let [a, b] = [edge[0], edge[1]].map(|v| mesh.corner(0, v).expect("a corner"));
        for (k, alpha) in multi_indices(3, 2).iter().enumerate() {
            coefficients[space.cell_dof(0, e, k)] = f(alpha) * (b - a).norm_squared();
        }
    }
    space.function(coefficients).expect("all coefficients")
}

#[test]
fn a_metric_that_vanishes_between_the_points_is_refused() {
    let mesh = Mesh::<2>::single().expect("a triangle");
    // (λ_0 − λ_1)² + c, by its coefficients; the one of λ_0 λ_1 is c − 1.
    let f = |c: f64| {
        conformal(&mesh, &move |alpha: &[usize]| match alpha {
            [2, 0, 0] | [0, 2, 0] => 1.0 + c,
            [1, 1, 0] => c - 1.0,
            _ => c,
        })
    };
    // At the vertices, and at points that are not in the middle, f is positive for both.
    let seen = Points::new(3, vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.6, 0.3, 0.1]);
    for (c, wanted) in [(0.01, true), (-0.01, false)] {
        let g = f(c);
        g.check_positive(&seen).unwrap_or_else(|e| panic!("{e}"));
        let found = proven_metric(&g);
        assert_eq!(found.is_ok(), wanted, "c = {c}: {found:?}");
        if let Err(Error::Indefinite { point, pivot, .. }) = found {
            assert!(
                (point[0] - point[1]).powi(2) - 0.01 <= 0.0 && pivot <= 0.0,
                "{point:?}"
            );
        } else {
            assert!(wanted, "a point is named");
        }
    }
    // 0 on a line: no metric, and no point is found where it is surely none, but the middle of an edge.
    assert!(proven_metric(&f(0.0)).is_err());
    assert!(enclosed_curvature(&f(-0.01)).is_err());
}
