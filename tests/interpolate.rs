//! Interpolants: what each of the table does, and what it refuses.

use crate::common::{crooked_cube, largest, random_regge};
use nalgebra::SVector;
use regge_curvature::interpolate::{Interpolant, geodesic_length};
use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::ReggeSpace;
use regge_oracle::{Oracle, all as load_all};

/// Everything in the table has its name, and is found again by it.
#[test]
fn interpolants_are_known_by_name() {
    for one in Interpolant::ALL {
        let again = Interpolant::named(one.name()).expect("its name is in the table");
        assert!(again.is(&one) && !one.about().is_empty());
        let same = Interpolant::ALL.iter().filter(|other| other.is(&one));
        assert_eq!(same.count(), 1);
    }
    assert!(
        Interpolant::named("canonical")
            .expect("a name")
            .is(&Interpolant::canonical())
    );
    assert!(Interpolant::named("Canonical").is_none());
}

/// Every interpolant reproduces Regge functions of its degree (it is a projector).
fn projector<const N: usize>(degree: usize) {
    let mesh = crooked_cube::<N>(2, 3);
    let space = ReggeSpace::new(&mesh, degree);
    let g = random_regge(&space, 0.05, 6);
    // The geodesic one needs a formula, and has no Regge functions to find again but constant ones.
    let all = Interpolant::ALL
        .into_iter()
        .filter(|one| !one.is(&Interpolant::geodesic()));
    let discrete = |one: &Interpolant| one.projected_by(|n, r| Ok(Rule::new(n, 2 * r)));
    let projecting = all.clone().filter(Interpolant::projects);
    let few_points = projecting.map(|one| discrete(&one));
    // 2r + 1 is the degree of a moment's integrand on an edge.
    let low_order = all.clone().map(|one| one.with_order(2 * degree + 1));
    for interpolant in all.chain(few_points).chain(low_order) {
        let h = interpolant.apply(&space, &g).expect("a metric");
        for (a, b) in g.coefficients().iter().zip(h.coefficients()) {
            assert!(
                (a - b).abs() < 1e-11,
                "N = {N}, r = {degree}, {interpolant:?}: {a} {b}"
            );
        }
    }
}

#[test]
fn interpolants_are_projectors() {
    for degree in 0..=3 {
        projector::<2>(degree);
    }
    for degree in 0..=2 {
        projector::<3>(degree);
    }
}

/// The oracles' metrics again, from the formula. Their g_h is NGSolve's, of another basis and quadrature: 1e-9 of the
/// largest coefficient is what its integration of a non-polynomial metric leaves.
fn interpolates_as_oracle<const N: usize>(oracle: &Oracle) {
    let mesh = oracle.mesh::<N>();
    let space = oracle.space(&mesh);
    let theirs = oracle.metric(&space);
    let named = Metric::ALL
        .iter()
        .find(|m| m.0 == oracle.metric)
        .expect("a known metric")
        .1;
    let g = Smooth::new(&mesh, named).expect("coordinates");
    let interpolant = match oracle.interpolant.as_str() {
        "canonical" => Interpolant::canonical().with_order(20),
        _ => Interpolant::average_hierarchical().with_order(20),
    };
    let ours = interpolant.apply(&space, &g).expect("a metric");
    let scale = largest(theirs.coefficients());
    for (a, b) in ours.coefficients().iter().zip(theirs.coefficients()) {
        assert!((a - b).abs() < 1e-9 * scale, "{}: {a} {b}", oracle.name);
    }
}

#[test]
fn interpolants_are_those_of_the_oracles() {
    for oracle in load_all() {
        match oracle.dimension {
            2 => interpolates_as_oracle::<2>(&oracle),
            _ => interpolates_as_oracle::<3>(&oracle),
        }
    }
}

/// The appendix's average and the hierarchical one are different interpolants for r ≥ 1, and one for r = 0.
#[test]
fn the_two_averages_differ() {
    let mesh = crooked_cube::<3>(2, 3);
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    for degree in 0..=2 {
        let space = ReggeSpace::new(&mesh, degree);
        let one = Interpolant::average().apply(&space, &g).expect("a metric");
        let other = Interpolant::average_hierarchical()
            .apply(&space, &g)
            .expect("a metric");
        let difference = one.coefficients().iter().zip(other.coefficients());
        let difference = difference.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(
            if degree == 0 {
                difference < 1e-13
            } else {
                difference > 1e-4
            },
            "{degree}: {difference:e}"
        );
    }
}

/// Stereographic coordinates of the unit sphere: |x−y|_chord = 2|x−y|/√((1+|x|²)(1+|y|²)), distance 2 asin(chord/2).
#[test]
fn geodesics_of_the_sphere() {
    for (a, b) in [
        ([-0.9, 0.4], [0.3, 0.8]),
        ([0.1, 0.2], [0.15, 0.18]),
        ([-0.6, -0.6], [0.7, 0.5]),
    ] {
        let (a, b): (Vector<f64, 2>, Vector<f64, 2>) = (a.into(), b.into());
        let product: f64 = (1.0 + a.norm_squared()) * (1.0 + b.norm_squared());
        let chord: f64 = 2.0 * (a - b).norm() / product.sqrt();
        let known: f64 = 2.0 * (chord / 2.0).asin();
        let length = geodesic_length(&Metric::Sphere, a, b).expect("a geodesic");
        assert!((length - known).abs() < 1e-12 * known, "{length} {known}");
    }
}

/// The ball model of radius ρ = √12 in N = 3: cosh(d/ρ) = 1 + 2ρ²|x−y|²/((ρ²−|x|²)(ρ²−|y|²)).
#[test]
fn geodesics_of_hyperbolic_space() {
    let (a, b) = (
        Vector::<f64, 3>::from([0.9, -0.8, 0.1]),
        Vector::from([-0.5, 0.7, 0.6]),
    );
    let square: f64 = 12.0;
    let ratio: f64 = 2.0 * square * (a - b).norm_squared()
        / ((square - a.norm_squared()) * (square - b.norm_squared()));
    let known = square.sqrt() * (1.0 + ratio).acosh();
    let length = geodesic_length(&Metric::Hyperbolic, a, b).expect("a geodesic");
    assert!((length - known).abs() < 1e-12 * known, "{length} {known}");
}

#[test]
fn geodesic_interpolant_has_the_geodesic_lengths() {
    let mesh = crooked_cube::<3>(2, 3);
    let space = ReggeSpace::new(&mesh, 0);
    let on_mesh = |metric| Smooth::new(&mesh, metric).expect("coordinates");
    let geodesic = Interpolant::geodesic();
    let g = geodesic.apply(&space, &on_mesh(Metric::GraphQuartic));
    let g = g.expect("a metric");
    let points = mesh.points().expect("coordinates");
    for edge in (0..mesh.count(1)).step_by(7) {
        let ends = mesh.vertices(1, edge);
        let [a, b] = [points[ends[0] as usize], points[ends[1] as usize]];
        let length = geodesic_length(&Metric::GraphQuartic, b, a).expect("a geodesic");
        assert!((g.coefficients()[edge] - length * length).abs() < 1e-12);
    }
    let flat = geodesic
        .apply(&space, &on_mesh(Metric::Flat))
        .expect("a metric");
    assert!((flat.coefficients()[0] - (points[1] - points[0]).norm_squared()).abs() < 1e-13);
}

/// A geodesic that leaves the formula's domain is refused by its edge.
#[test]
fn a_geodesic_that_leaves_the_domain_is_refused_by_its_edge() {
    // Twice the square: its corners are outside of the ball |x|² < 8 of the hyperbolic plane.
    let corners = [[-3.0, -3.0], [3.0, -3.0], [-3.0, 3.0], [3.0, 3.0]];
    let large = Mesh::<2>::new(
        corners.map(SVector::from).to_vec(),
        &[vec![0, 1, 2], vec![1, 2, 3]],
    )
    .expect("a square");
    let hyperbolic = Smooth::new(&large, Metric::Hyperbolic).expect("coordinates");
    let error = Interpolant::geodesic()
        .apply(&ReggeSpace::new(&large, 0), &hyperbolic)
        .expect_err("outside")
        .to_string();
    assert!(
        error.contains("edge 0-1") && error.contains("leaves the domain"),
        "{error}"
    );
}

/// What cannot be done is said in a line, and nothing is guessed instead.
#[test]
fn what_makes_no_sense_is_refused() {
    let mesh = crooked_cube::<2>(2, 3);
    let flat = Smooth::new(&mesh, Metric::Flat).expect("coordinates");
    let (constant, linear) = (ReggeSpace::new(&mesh, 0), ReggeSpace::new(&mesh, 1));
    let refused = |one: Interpolant, space: &ReggeSpace<2>, says: &str| {
        let error = one.apply(space, &flat).expect_err("refused").to_string();
        assert!(error.contains(says), "{error}");
    };
    let geodesic = Interpolant::geodesic();
    refused(geodesic, &linear, "has degree 0, not 1");
    refused(geodesic.with_order(4), &constant, "no order of integration");
    let middle = |n, _| Ok(Rule::new(n, 1));
    refused(
        Interpolant::canonical().projected_by(middle),
        &linear,
        "no local projection",
    );
    refused(
        Interpolant::average().projected_by(middle),
        &linear,
        "cannot determine 3",
    );
    let on_edges = |n, r| Ok(Rule::new(n - 1, 2 * r));
    refused(
        Interpolant::average().projected_by(on_edges),
        &linear,
        "2 vertices",
    );
    // A Regge function has no formula in the plane, even if it is flat.
    let g = Interpolant::canonical()
        .apply(&constant, &flat)
        .expect("a metric");
    let error = geodesic
        .apply(&constant, &g)
        .expect_err("no formula")
        .to_string();
    assert!(error.contains("needs a formula in ℝ^2"), "{error}");
}
