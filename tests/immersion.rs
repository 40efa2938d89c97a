//! Metrics of surfaces and solids by their points.

use regge_curvature::field::Evaluate;
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::scalar::Real;
use regge_curvature::simplex::{Points, multi_indices};
use regge_curvature::spaces::{Immersed, Immersion};
use regge_curvature::{Error, Lagrange, Mesh, Rules, distributional_curvature};
use std::f64::consts::PI;

/// The lattice points of order k of a cell under a map of its affine points.
fn nodes<const N: usize>(
    mesh: &Mesh<N>,
    degree: usize,
    corner: impl Fn(u32) -> Vec<f64>,
    map: impl Fn(&[f64]) -> Vec<f64>,
) -> Vec<Vec<f64>> {
    let lattice = multi_indices(N + 1, degree);
    let of = |cell: usize| {
        let corners: Vec<Vec<f64>> = mesh.vertices(N, cell).iter().map(|&v| corner(v)).collect();
        let at = |alpha: &Vec<usize>| {
            let mut x = vec![0.0; corners[0].len()];
            for (a, corner) in alpha.iter().zip(&corners) {
                for (x, c) in x.iter_mut().zip(corner) {
                    *x += *a as f64 / degree as f64 * c;
                }
            }
            map(&x)
        };
        lattice.iter().flat_map(at).collect()
    };
    (0..mesh.cell_count()).map(of).collect()
}

/// δ on ℝ^D.
struct Flat;
impl<const D: usize> SmoothTensor<D> for Flat {
    fn at<S: Real>(&self, _: &[S; D]) -> Mat<S, D> {
        symmetric(|i, j| if i == j { S::one() } else { S::zero() })
    }
}

/// A map that is no polynomial, on the vertices of a square or cube.
fn bent(x: &[f64]) -> Vec<f64> {
    let z = x.get(2).copied().unwrap_or(0.3);
    vec![
        x[0] + 0.1 * (x[1] + z).sin(),
        x[1] - 0.2 * (x[0] * z).cos(),
        z + 0.3 * x[0] * x[1],
    ]
}

/// The coefficients of g = F*δ against ∂_i F · ∂_j F by jets of F: both are the same polynomial, written in two ways.
fn is_the_square_of_the_derivative<const N: usize>(degree: usize) {
    let mesh = Mesh::<N>::cube(2).unwrap().perturbed(0.05, 2).unwrap();
    let points = mesh.points().unwrap().to_vec();
    let all = nodes(
        &mesh,
        degree,
        |v| points[v as usize].as_slice().to_vec(),
        bent,
    );
    let map = Immersion::through(&mesh, degree, 3, |cell| &all[cell]).unwrap();
    let g = map.metric();
    assert_eq!(g.space().degree(), 2 * (degree - 1));
    let lambda: Vec<f64> = match N {
        2 => vec![0.2, 0.5, 0.3, 0.7, 0.1, 0.2, 0.0, 0.25, 0.75],
        _ => vec![0.2, 0.4, 0.3, 0.1, 0.0, 0.1, 0.2, 0.7],
    };
    let at = Points::new(N + 1, lambda);
    let exact = Immersed::<_, N, 3>::new(map, Flat).unwrap();
    let (ours, theirs) = (
        Evaluate::<f64, N>::tabulate(&g, &at),
        Evaluate::<f64, N>::tabulate(&exact, &at),
    );
    for cell in 0..mesh.cell_count() {
        let (a, b) = (
            Evaluate::<f64, N>::on_cell(&g, cell),
            Evaluate::<f64, N>::on_cell(&exact, cell),
        );
        for q in 0..at.len() {
            let (a, b): (Mat<Jet1<f64, N>, N>, _) =
                (g.jet1(&a, &ours, q), exact.jet1(&b, &theirs, q));
            for (a, b) in a.iter().zip(b.iter()) {
                // Lengths of size 1, coefficients of a few of them.
                assert!((a.value - b.value).abs() < 1e-13);
                assert!((0..N).all(|m| (a.d[m] - b.d[m]).abs() < 1e-12));
            }
        }
    }
}

#[test]
fn the_metric_of_a_map_is_the_square_of_its_derivative() {
    for degree in 1..=4 {
        is_the_square_of_the_derivative::<2>(degree);
    }
    for degree in 1..=3 {
        is_the_square_of_the_derivative::<3>(degree);
    }
}

/// An octahedron blown up to the unit sphere, with cells of degree k: Gauss and Bonnet hold for each of them, up to quadrature.
#[test]
fn a_curved_sphere_has_curvature_8_pi() {
    let faces = (0..8).map(|signs: usize| (0..3).map(|i| 2 * i + (signs >> i) % 2).collect());
    let mesh = Mesh::<2>::new_abstract(6, &faces.collect::<Vec<_>>()).unwrap();
    let corner = |v: u32| {
        let sign = if v.is_multiple_of(2) { 1.0 } else { -1.0 };
        let on = |i: u32| if i == v / 2 { sign } else { 0.0 };
        (0..3).map(on).collect()
    };
    let unit = |x: &[f64]| {
        let r = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        x.iter().map(|x| x / r).collect()
    };
    for degree in 1..=4 {
        let all = nodes(&mesh, degree, corner, unit);
        let g = Immersion::through(&mesh, degree, 3, |cell| &all[cell])
            .unwrap()
            .metric();
        let hats = Lagrange::new(&mesh, 1);
        let sums = distributional_curvature(&g, &hats, &Rules::on(&mesh, 44)).total();
        let total: f64 = sums.iter().sum();
        // Eight cells for a sphere: R ω is no polynomial, and a rule of order 44 sees nine digits of it.
        assert!(
            (total - 8.0 * PI).abs() < 1e-8,
            "{degree}: {}",
            total - 8.0 * PI
        );
    }
}

#[test]
fn points_that_are_none_are_refused() {
    let mesh = Mesh::<2>::simplex_boundary().unwrap();
    let few = Immersion::straight(&mesh, 3, vec![0.0; 9]);
    assert!(matches!(few, Err(Error::Input(_))));
    let mut points = vec![0.0; 12];
    points[7] = f64::NAN;
    let nan = Immersion::straight(&mesh, 3, points);
    assert!(matches!(nan, Err(Error::Vertex { vertex: 2, .. })));
    let corner = |v: u32| vec![f64::from(v), f64::from(v * v), 1.0 / f64::from(v + 1)];
    let mut all = nodes(&mesh, 2, corner, <[f64]>::to_vec);
    assert!(Immersion::through(&mesh, 2, 3, |cell| &all[cell]).is_ok());
    // A point in the middle of an edge that only one of its two cells has there.
    all[3][4] += 1e-3;
    let torn = Immersion::through(&mesh, 2, 3, |cell| &all[cell]);
    assert!(matches!(torn, Err(Error::Cell { cell: 3, .. })), "{torn:?}");
}
