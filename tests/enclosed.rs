//! Enclosures contain what they enclose, and are narrow.

use proptest::prelude::*;
use regge_curvature::functional::{Enclosed, angle_defects, enclosed, regge_action};
use regge_curvature::mesh::Mesh;
use regge_curvature::scalar::{Algebraic, Field, Interval};
use regge_curvature::simplex::subsets;
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};
use regge_curvature::{Error, Rules};
use std::f64::consts::{PI, TAU};

/// All edges of length 1.
fn unit_edges<const N: usize>(mesh: &Mesh<N>) -> ReggeFunction<f64, N> {
    let space = ReggeSpace::new(mesh, 0);
    space.function(vec![1.0; mesh.count(1)]).expect("lengths")
}

fn of<const N: usize>(g: &ReggeFunction<f64, N>) -> Enclosed {
    enclosed(g).unwrap_or_else(|e| panic!("{e}"))
}

/// It contains x and is narrow.
fn assert_encloses(found: Interval, x: f64, relative: f64) {
    assert!(found.contains(x), "{x:e} is not in {found:?}");
    assert!(
        found.width() <= relative * x.abs().max(1e-3),
        "{found:?} is too wide for {x:e}"
    );
    assert!(!found.contains(x + 1e-9), "{found:?} contains {x:e} + 1e-9");
    assert!(!found.contains(x - 1e-9), "{found:?} contains {x:e} − 1e-9");
}

proptest! {
    #[test]
    fn operations_contain_what_they_round(a in -9.0f64..9.0, b in -9.0f64..9.0, c in 0.1f64..9.0) {
        let (x, y, z) = (Interval::exactly(a), Interval::exactly(b), Interval::exactly(c));
        // Exact for the numbers themselves: (a + b) − b is a, and so on.
        prop_assert!(((x + y) - y).contains(a));
        prop_assert!(((x * z) / z).contains(a));
        prop_assert!((z.sqrt() * z.sqrt()).contains(c));
        prop_assert!((x * y).contains(a * b) && (x / z).contains(a / c));
        // An interval contains what its members give.
        let wide = x + Interval::exactly(0.0) * y;
        prop_assert!((wide * y - z).contains(a * b - c));
    }

    #[test]
    fn angles_are_enclosed(theta in 1e-9f64..(PI - 1e-9), r in 0.01f64..100.0) {
        let (s, c) = (r * theta.sin(), r * theta.cos());
        let found = Interval::angle(Interval::exactly(s), Interval::exactly(c));
        let angle = f64::atan2(s, c);
        // atan2 itself is good to a unit in the last place.
        let ulp = angle * f64::EPSILON;
        prop_assert!(found.low() <= angle + ulp && angle - ulp <= found.high());
        prop_assert!(found.width() <= 4e-14 * angle, "{found:?}");
    }
}

#[test]
fn angles_in_closed_form() {
    let of = |s: i64, c: Interval| Interval::angle(Interval::from_int(s), c);
    let root = |n: i64| Interval::from_int(n).sqrt();
    for (found, part) in [
        (of(1, Interval::one()), Interval::ratio(1, 4)),
        (of(1, Interval::zero()), Interval::ratio(1, 2)),
        (of(1, -Interval::one()), Interval::ratio(3, 4)),
        (of(1, root(3)), Interval::ratio(1, 6)),
        (of(1, -root(3)), Interval::ratio(5, 6)),
    ] {
        let wanted = Interval::pi() * part;
        assert!(
            found.low() <= wanted.high() && wanted.low() <= found.high(),
            "{found:?}"
        );
        assert!(found.width() < 1e-13);
    }
    // Corners: an interval on both sides of a right angle.
    let cos = Interval::ratio(-1, 10) + Interval::ratio(1, 5) * Interval::half();
    let (sin, both) = (Interval::one(), cos - cos);
    assert!(Interval::angle(sin, both).contains(PI / 2.0));
    // What may have no angle has none.
    assert!(
        Interval::angle(Interval::zero(), Interval::one())
            .low()
            .is_nan()
    );
}

#[test]
fn what_does_not_exist_is_undefined() {
    let (one, zero) = (Interval::one(), Interval::zero());
    assert!((one / zero).low().is_nan());
    assert!((-one).sqrt().low().is_nan());
    assert!(((one / zero) * zero).low().is_nan());
    assert!(!(one / zero).is_positive() && !(one / zero).contains(0.0));
    assert_eq!((one / zero).integer(), None);
    // What overflows is still enclosed.
    let large = Interval::exactly(f64::MAX);
    assert!(((large + large) + (one - (large + large))).contains(1.0));
    assert!(one.hull(one / zero).high().is_nan());
    let third = Interval::ratio(1, 3);
    assert_eq!((third + third + third).integer(), Some(1));
    assert_eq!((third * Interval::from_int(2)).integer(), None);
    assert_eq!(Interval::from_int(7).integer(), Some(7));
}

/// ∂Δ^{N+1}: three regular simplices around each hinge.
fn regular_sphere<const N: usize>(size: f64) {
    let mesh = Mesh::<N>::simplex_boundary().expect("a sphere");
    let g = unit_edges(&mesh);
    let found = of(&g);
    let defect = TAU - 3.0 * (1.0 / N as f64).acos();
    for hinge in 0..mesh.count(N - 2) {
        assert_encloses(found.defects[hinge], defect, 1e-12);
        assert_encloses(found.sizes[hinge], size, 1e-12);
    }
    assert_encloses(
        found.interior,
        defect * size * mesh.count(N - 2) as f64,
        1e-12,
    );
    assert_eq!(found.boundary, Interval::zero());
}

#[test]
fn regular_spheres() {
    // √(k+1)/(k! 2^{k/2}) for k = N − 2.
    regular_sphere::<2>(1.0);
    regular_sphere::<3>(1.0);
    regular_sphere::<4>(3f64.sqrt() / 4.0);
    regular_sphere::<5>(2f64.sqrt() / 12.0);
}

/// The cells of a polytope with regular simplices for facets: the cliques of neighbouring vertices.
fn cliques(points: &[[f64; 4]], nearest: f64) -> Vec<Vec<usize>> {
    let near = |a: usize, b: usize| {
        let square: f64 = (0..4).map(|k| (points[a][k] - points[b][k]).powi(2)).sum();
        (square.sqrt() - nearest).abs() < 1e-6
    };
    let mut all: Vec<Vec<usize>> = (0..points.len()).map(|v| vec![v]).collect();
    for _ in 0..3 {
        let longer = |c: &Vec<usize>| {
            let last = c[c.len() - 1];
            let next = (last + 1..points.len()).filter(|v| c.iter().all(|u| near(*u, *v)));
            next.map(|v| [c.as_slice(), &[v]].concat())
                .collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

/// The 120 unit icosians: the vertices of the 600-cell with edges 1/φ.
fn icosians() -> Vec<[f64; 4]> {
    let phi = f64::midpoint(1.0, 5f64.sqrt());
    let mut all: Vec<[f64; 4]> = Vec::new();
    let mut add = |x: [f64; 4]| {
        let known = all
            .iter()
            .any(|y| (0..4).all(|k| (x[k] - y[k]).abs() < 1e-9));
        if !known {
            all.push(x);
        }
    };
    let even = [
        [0, 1, 2, 3],
        [1, 2, 0, 3],
        [2, 0, 1, 3],
        [1, 0, 3, 2],
        [0, 3, 1, 2],
        [3, 1, 0, 2],
        [2, 3, 0, 1],
        [3, 0, 2, 1],
        [0, 2, 3, 1],
        [3, 2, 1, 0],
        [2, 1, 3, 0],
        [1, 3, 2, 0],
    ];
    for signs in 0..16u32 {
        let sign = |k: u32| if signs >> k & 1 == 0 { 0.5 } else { -0.5 };
        add(std::array::from_fn(|k| sign(k as u32)));
        for place in even {
            let parts = [phi * sign(0), sign(1), sign(2) / phi, 0.0];
            add(std::array::from_fn(|k| parts[place[k]]));
            let parts = [2.0 * sign(0), 0.0, 0.0, 0.0];
            add(std::array::from_fn(|k| parts[place[k]]));
        }
    }
    all
}

/// Σ Θ_S |S| with unit edges: 24 (2π − 4 arccos ⅓) and 720 (2π − 5 arccos ⅓).
#[test]
fn the_16_cell_and_the_600_cell() {
    let axes = (0..8).map(|v| {
        let mut x = [0.0; 4];
        x[v / 2] = if v % 2 == 0 { 1.0 } else { -1.0 };
        x
    });
    let axes: Vec<[f64; 4]> = axes.collect();
    let phi = f64::midpoint(1.0, 5f64.sqrt());
    for (points, nearest, cells, wanted) in [
        (axes, 2f64.sqrt(), 16, 32.624_343_307_6),
        (icosians(), 1.0 / phi, 600, 92.439_518_742_5),
    ] {
        let found = cliques(&points, nearest);
        assert_eq!(found.len(), cells);
        let mesh = Mesh::<3>::new_abstract(points.len(), &found).expect("a sphere");
        let action = of(&unit_edges(&mesh)).action();
        // The value is printed to ten digits.
        assert!((action.low() - wanted).abs() < 1e-9 && (action.high() - wanted).abs() < 1e-9);
        let around = if cells == 16 {
            (24.0, 4.0)
        } else {
            (720.0, 5.0)
        };
        let exactly = around.0 * (TAU - around.1 * (1.0 / 3.0_f64).acos());
        assert_encloses(action, exactly, 1e-12);
    }
}

/// Production results lie in their enclosures, up to their own rounding, and no longer when they are shifted by 1e-9.
#[test]
fn production_lies_inside() {
    fn near(found: Interval, x: f64) {
        let wider = |by: f64| found.low() - by <= x && x <= found.high() + by;
        assert!(wider(1e-12), "{x:e} is not in {found:?}");
        assert!(!found.contains(x + 1e-9) && !found.contains(x - 1e-9));
    }
    fn check<const N: usize>(mesh: &Mesh<N>) {
        let space = ReggeSpace::new(mesh, 0);
        let squares = (0..mesh.count(1)).map(|e| 1.0 + 0.2 * (e as f64 * 1.7).sin());
        let g = space.function(squares.collect()).expect("lengths");
        let found = of(&g);
        for h in angle_defects(&g, mesh, 1) {
            near(found.defects[h.hinge], h.defect);
            near(found.sizes[h.hinge], h.size);
        }
        let action = regge_action(&g, mesh, &Rules::new(N, 1));
        near(found.interior, action.interior);
        let gradient = regge_curvature::functional::action_gradient(&g).expect("degree 0");
        for (enclosure, x) in found.gradient.iter().zip(&gradient.gradient) {
            near(*enclosure, *x);
        }
    }
    check(&Mesh::<2>::simplex_boundary().expect("a sphere"));
    check(&Mesh::<3>::simplex_boundary().expect("a sphere"));
    check(&Mesh::<4>::simplex_boundary().expect("a sphere"));
    check(&Mesh::<3>::cube(2).expect("a cube"));
}

/// Gauss and Bonnet, needles included: 2π is enclosed so narrowly that χ is the only integer.
#[test]
fn the_euler_characteristic_of_needles() {
    let cells = [vec![0, 1, 4], vec![1, 2, 4], vec![2, 3, 4], vec![3, 0, 4]];
    let mesh = Mesh::<2>::new_abstract(5, &cells).expect("a disc");
    let space = ReggeSpace::new(&mesh, 0);
    let square = |e: usize| match mesh.vertices(1, e) {
        [_, 4] => 1.0,
        _ => 1e-12,
    };
    let g = space
        .function((0..mesh.count(1)).map(square).collect())
        .expect("lengths");
    let over = of(&g).action() / (Interval::pi() + Interval::pi());
    assert_eq!(over.integer(), Some(1), "{over:?}");
}

/// A flat torus of triangles with sides 1 and 2⁻²³: from the sharp angle det g is a difference of numbers 10¹⁴ times as large, and
/// g^aa g^bb − (g^ab)² encloses zero wherever it is seen from.
#[test]
fn thin_triangles_are_enclosed_narrowly() {
    let mesh = Mesh::<2>::torus(16).expect("a torus");
    let space = ReggeSpace::new(&mesh, 0);
    let thin = 2f64.powi(-46);
    let square = |e: usize| {
        let side = mesh.first_side(1, e);
        let ends = &subsets(3, 2)[side.place];
        let [a, b] = [ends[0], ends[1]].map(|v| mesh.corner(side.cell, v).expect("a corner"));
        match [0, 1].map(|i| (b - a)[i].abs() > 1e-9) {
            [true, true] => 1.0 + thin,
            [true, false] => 1.0,
            _ => thin,
        }
    };
    let g = space
        .function((0..mesh.count(1)).map(square).collect())
        .expect("lengths");
    let found = of(&g);
    for defect in &found.defects {
        // What is left is the rounding of squares by 2⁻⁵³, over the sine of the sharp angle.
        assert!(defect.contains(0.0) && defect.width() < 1e-8, "{defect:?}");
    }
    let over = found.action() / (Interval::pi() + Interval::pi());
    assert_eq!(over.integer(), Some(0), "{over:?}");
}

#[test]
fn what_is_not_positive_definite_is_not_enclosed() {
    let mesh = Mesh::<2>::simplex_boundary().expect("a sphere");
    let space = ReggeSpace::new(&mesh, 0);
    // 1 + 1 < 3.
    let mut squares = vec![1.0; mesh.count(1)];
    squares[0] = 9.0;
    let g = space.function(squares).expect("lengths");
    assert!(matches!(enclosed(&g), Err(Error::Indefinite { .. })));
    // 1 + 1 = 2: no triangle, and intervals cannot tell.
    let mut squares = vec![1.0; mesh.count(1)];
    squares[0] = 4.0;
    let g = space.function(squares).expect("lengths");
    assert!(enclosed(&g).is_err());
}

/// The reference meshes of degree 0. What f64 computes is rounded, too: it lies inside up to its own rounding, and not when it is
/// moved by 1e-9.
#[test]
fn production_lies_inside_on_the_reference_meshes() {
    /// Of Θ_S. The arctangent is off by two units in the last place (`scalar::lanes`), 2ε each below 4; and at each difference
    /// below 8 the ends of an interval moved by that much may be rounded by another unit, 4ε. What goes into the arctangent is rounded
    /// too, and in flat cells by much more, since f64 sees them from vertex 0; on the cells of these meshes the rest of 8ε is enough.
    fn rounding(cells: usize) -> f64 {
        8.0 * f64::EPSILON * cells as f64
    }
    fn check<const N: usize>(oracle: &regge_oracle::Oracle) -> usize {
        let mesh = oracle.mesh::<N>();
        let space = oracle.space(&mesh);
        let g = oracle.metric(&space);
        let found = of(&g);
        let near = |x: Interval, value: f64, slack: f64| {
            let inside = x.low() - slack <= value && value <= x.high() + slack;
            assert!(inside, "{}: {value:e} is not in {x:?}", oracle.name);
            assert!(!x.contains(value + 1e-9) && !x.contains(value - 1e-9));
        };
        for h in angle_defects(&g, &mesh, 1) {
            let cells = mesh.star(N - 2, h.hinge).len();
            near(found.defects[h.hinge], h.defect, rounding(cells));
            assert!(found.defects[h.hinge].width() < 1e-11);
            near(found.sizes[h.hinge], h.size, 4.0 * f64::EPSILON * h.size);
        }
        // Sums of n terms, in whichever order, are rounded by less than nε/2 times the sum of their sizes, and their terms by ε.
        let (mut of_angles, mut sizes) = (0.0, 0.0);
        for h in mesh.interior_hinges() {
            let size = found.sizes[h].high();
            of_angles += rounding(mesh.star(N - 2, h).len()) * size;
            sizes += found.defects[h].low().abs().max(found.defects[h].high()) * size;
        }
        let of_sum = (mesh.interior_hinges().count() + 8) as f64 * f64::EPSILON * sizes;
        near(
            found.interior,
            regge_action(&g, &mesh, &Rules::new(N, 1)).interior,
            of_angles + of_sum,
        );
        found.defects.len()
    }
    let mut hinges = 0;
    for oracle in regge_oracle::all().iter().filter(|o| o.degree == 0) {
        hinges += match oracle.dimension {
            2 => check::<2>(oracle),
            3 => check::<3>(oracle),
            n => panic!("no reference mesh of dimension {n}"),
        };
    }
    assert!(hinges > 100, "{hinges} hinges");
}

/// χ of a large torus with slivers: 2π is enclosed so closely that one integer is left.
#[test]
fn the_euler_characteristic_of_a_large_surface_with_slivers() {
    let mesh = Mesh::<2>::torus(224).expect("a torus");
    assert!(mesh.cell_count() > 100_000);
    let space = ReggeSpace::new(&mesh, 0);
    // Sides 1, 1 and nearly 2: each triangle has an angle of π − 0.008, and two of 0.004.
    let square = |e: usize| {
        let side = mesh.first_side(1, e);
        let ends = &subsets(3, 2)[side.place];
        let [a, b] = [ends[0], ends[1]].map(|v| mesh.corner(side.cell, v).expect("a corner"));
        let diagonal = (b - a).iter().all(|x| x.abs() > 1e-9);
        let long = if diagonal { 4.0 - 2f64.powi(-14) } else { 1.0 };
        long + (e % 5) as f64 * 2f64.powi(-24)
    };
    let g = space
        .function((0..mesh.count(1)).map(square).collect())
        .expect("lengths");
    let over = of(&g).action() / (Interval::pi() + Interval::pi());
    assert_eq!(over.integer(), Some(0), "{over:?}");
}
