//! One kernel, many scalars: each scalar gives what another route gives.

use approx::{RelativeEq, assert_relative_eq};
use num_dual::{Dual, Dual2_64, Dual64, HyperDual64};
use regge_curvature::jet::{Jet, Jet1, Jet2, lower};
use regge_curvature::linalg::{Mat, inverse_and_det, symmetric};
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::parts::AllParts;
use regge_curvature::riemann::{Connection, Curvature};
use regge_curvature::scalar::{Lanes, Real};
use std::fmt::Debug;

fn close(a: f64, b: f64, tolerance: f64) {
    assert!(
        (a - b).abs() <= tolerance * (1.0 + b.abs()),
        "{a} and {b} differ by {:e}",
        a - b
    );
}

/// The same for all parts of two values.
fn near<T: RelativeEq<Epsilon = f64> + Debug>(a: &T, b: &T, tolerance: f64) {
    assert_relative_eq!(a, b, epsilon = tolerance, max_relative = tolerance);
}

/// dθ = (cos ds − sin dc)/(s² + c²) at every angle, the right and the flat ones included, where num-dual's atan2 and
/// acos give NaN and ∞.
#[test]
fn angles_have_derivatives_everywhere() {
    for step in -7..=8 {
        let theta = f64::from(step) * std::f64::consts::FRAC_PI_8;
        let (s, c) = theta.sin_cos();
        let (ds, dc) = (0.3, -0.7);
        let angle: Dual64 = Real::angle(Dual64::new(s, ds), Dual64::new(c, dc));
        close(angle.re, theta, 1e-15);
        close(angle.eps, c * ds - s * dc, 1e-14);
    }
}

/// The angle of (sin t², cos t²) is t², its derivatives 2t and 2.
#[test]
fn angles_have_second_derivatives() {
    for t in [0.0, 0.4, 1.0, std::f64::consts::FRAC_PI_2.sqrt(), 1.6] {
        let square = Dual2_64::new(t * t, 2.0 * t, 2.0);
        let angle: Dual2_64 = Real::angle(Real::sin(square), Real::cos(square));
        near(&AllParts(&angle), &AllParts(&square), 1e-13);
    }
}

/// x ↦ a formula that uses every function, as a jet and as nested dual numbers.
fn formula<S: Real>(x: S) -> S {
    let wave = x.sin() * x.cos() + (x * x).exp().ln() - x.atan();
    (wave + S::from_int(5)).sqrt() / (S::one() + x * x) + S::angle(x.sinh(), x.cosh()) + x.tan()
}

#[test]
fn jets_and_nested_duals_agree() {
    for x in [-0.7, 0.1, 0.9] {
        let jet = formula(Jet2::<f64, 1>::coordinate(x, 0));
        let low = formula(Jet1::<f64, 1>::coordinate(x, 0));
        let nested = formula(Dual::new(Dual64::new(x, 1.0), Dual64::new(1.0, 0.0)));
        let hyper = formula(HyperDual64::new(x, 1.0, 1.0, 0.0));
        close(jet.value, formula(x), 1e-15);
        for (d, dd) in [
            (nested.eps.re, nested.eps.eps),
            (hyper.eps1, hyper.eps1eps2),
        ] {
            close(jet.d[0], d, 1e-13);
            close(jet.dd[0][0], dd, 1e-12);
        }
        near(&low, &jet.lower(), 1e-15);
        close(jet.d(0).d[0], jet.dd[0][0], 0.0);
    }
}

#[test]
fn lanes_are_four_numbers() {
    let x = [0.1, 0.5, -0.3, 0.9];
    near(&formula(Lanes::new(x)), &Lanes::new(x.map(formula)), 1e-15);
    close(Lanes::new(x).reduce(), 1.2, 1e-15);
    close(Lanes::pack(|l| x[l]).to_array()[3], 0.9, 0.0);
}

/// The rational approximation of all lanes at once against atan2 of the system, which is off by less than a unit in the
/// last place: two units of π, all around the circle and at its eighths.
#[test]
fn angles_of_lanes() {
    for step in -4000..=4000 {
        let theta = f64::from(step) * std::f64::consts::PI / 4000.0;
        let (s, c) = theta.sin_cos();
        let lanes: Lanes = Real::angle(Lanes::from_f64(3.0 * s), Lanes::from_f64(3.0 * c));
        let known = (3.0 * s).atan2(3.0 * c);
        assert!(
            (lanes.to_array()[1] - known).abs() <= 2.0 * f64::EPSILON * known.abs().max(1.0),
            "{theta}: {lanes:?} {known}"
        );
    }
}

/// A build for this machine leaves nothing unused; another one says so.
#[test]
fn lost_lanes_are_reported() {
    assert_eq!(
        Lanes::unused_width().is_some(),
        cfg!(target_arch = "x86_64") && Lanes::BUILT_FOR < 256 && wide_vectors()
    );
}

#[cfg(target_arch = "x86_64")]
fn wide_vectors() -> bool {
    std::arch::is_x86_feature_detected!("avx")
}

#[cfg(not(target_arch = "x86_64"))]
fn wide_vectors() -> bool {
    false
}

/// A⁻¹A = 1 and det A by LDLᵀ against nalgebra's LU, and the derivative of det: det · Tr(A⁻¹ dA).
#[test]
fn inverse_and_determinant() {
    let a: Mat<f64, 4> =
        symmetric(|i, j| 1.0 / (1.0 + (i + j) as f64) + f64::from(u8::from(i == j)));
    let rate: Mat<f64, 4> = symmetric(|i, j| (i as f64 - 1.3) * (j as f64 + 0.2) + (i * j) as f64);
    let moving = a.zip_map(&rate, Dual64::new);
    let (inverse, det) = inverse_and_det(&moving);
    let known = a.try_inverse().expect("regular");
    let expected = known.zip_map(&-(known * rate * known), Dual64::new);
    near(&AllParts(&inverse), &AllParts(&expected), 1e-12);
    let size = a.determinant();
    let expected = Dual64::new(size, size * (known * rate).trace());
    near(&AllParts(&det), &AllParts(&expected), 1e-12);
}

/// R of a metric by formula at a point of ℝ^N.
fn curvature<S: Real, const N: usize>(metric: Metric, x: [S; N]) -> S {
    let at: [Jet2<S, N>; N] = std::array::from_fn(|i| Jet2::coordinate(x[i], i));
    Connection::new(&metric.at(&at)).scalar()
}

/// Closed forms: N(N−1) on the unit sphere, −N(N−1)/ρ² in hyperbolic space, Gauss' equation for a graph.
fn closed_forms<const N: usize>() {
    let x: [f64; N] = std::array::from_fn(|i| 0.3 - 0.2 * i as f64);
    for metric in [
        Metric::Flat,
        Metric::Sphere,
        Metric::Hyperbolic,
        Metric::GraphQuartic,
    ] {
        let known = metric.scalar_curvature(&x).expect("a closed form");
        close(curvature(metric, x), known, 1e-13);
    }
}

#[test]
fn curvature_of_known_metrics() {
    closed_forms::<2>();
    closed_forms::<3>();
    closed_forms::<4>();
    closed_forms::<5>();
}

/// R_ijkl = g_ik g_jl − g_il g_jk on the unit sphere, and Ric = (N−1) g.
#[test]
fn lowered_curvature_of_the_sphere() {
    let x: [Jet2<f64, 4>; 4] = std::array::from_fn(|i| Jet2::coordinate(0.4 - 0.3 * i as f64, i));
    let sphere = Metric::Sphere.at(&x);
    let connection = Connection::new(&lower(&sphere));
    let (g, curvature) = (&connection.g, Curvature::new(&sphere, &connection));
    for index in 0..256 {
        let [i, j, k, l] = [index / 64, index / 16 % 4, index / 4 % 4, index % 4];
        let expected = g[(i, k)] * g[(j, l)] - g[(i, l)] * g[(j, k)];
        close(curvature.riemann([i, j, k, l]), expected, 1e-13);
    }
    let ricci = curvature.ricci();
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        close(ricci[(i, j)], 3.0 * g[(i, j)], 1e-13);
    }
}

/// The paper's own formula, section 5, at a point: 162(1−x²)(1−y²)/(9+q(x)+q(y))², q(x) = x²(x²−3)².
#[test]
fn curvature_of_the_papers_graph() {
    let (x, y): (f64, f64) = (0.4, -0.7);
    let q = |x: f64| x * x * (x * x - 3.0) * (x * x - 3.0);
    let printed = 162.0 * (1.0 - x * x) * (1.0 - y * y) / (9.0 + q(x) + q(y)).powi(2);
    close(
        Metric::GraphQuartic
            .scalar_curvature(&[x, y])
            .expect("a closed form"),
        printed,
        1e-14,
    );
}

/// The derivative of R along a line by dual numbers, against a central difference (the only use of one).
#[test]
fn duals_go_through_the_kernel() {
    let direction = [0.3, -0.5, 0.2];
    let at = |t: f64| -> [f64; 3] { std::array::from_fn(|i| 0.1 + t * direction[i]) };
    let moving: [Dual64; 3] = std::array::from_fn(|i| Dual64::new(0.1, direction[i]));
    let h = 1e-4;
    let difference = (curvature(Metric::Trig, at(h)) - curvature(Metric::Trig, at(-h))) / (2.0 * h);
    close(curvature(Metric::Trig, moving).eps, difference, 1e-7);
    let lanes = curvature(Metric::Trig, at(0.0).map(Lanes::from_f64)).to_array();
    close(lanes[2], curvature(Metric::Trig, at(0.0)), 1e-13);
}
