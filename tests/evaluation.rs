//! How a functional is evaluated does not matter: simplex by simplex, for several spaces at once, with lanes or without.

use crate::common::{crooked_cube, largest, random_regge};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use regge_curvature::field::{Evaluate, PointByPoint};
use regge_curvature::functional::{
    Sums, a_h, boundary_curvature, boundary_curvatures, cell_volumes, distributional_curvatures,
    integrate, smooth_curvature, smooth_curvatures,
};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::Mat;
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Real;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::{Indicators, Scalar, TestSpace, check_positive};
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeSpace, Rules, Smooth, distributional_curvature,
};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Rounding: sums of some 10² terms of size 1.
const ROUNDING: f64 = 1e-11;

/// The pieces add up to the sums of the functional at v = 1.
#[test]
fn the_integrals_simplex_by_simplex_add_up() {
    let mesh = Mesh::<3>::cube(1).unwrap().perturbed(0.05, 2).unwrap();
    let (space, hats) = (ReggeSpace::new(&mesh, 1), Lagrange::new(&mesh, 1));
    let smooth = Smooth::new(&mesh, Metric::Trig).unwrap();
    let g = Interpolant::canonical()
        .with_order(8)
        .apply(&space, &smooth)
        .unwrap();
    let rules = Rules::new(3, 6);
    let sums = distributional_curvature(&g, &hats, &rules);
    let outer = boundary_curvature(&g, &hats, &rules);
    let each = Indicators::new(&mesh);
    let (inside, bent) = (
        distributional_curvature(&g, &each, &rules),
        boundary_curvature(&g, &each, &rules),
    );
    // The one inner hinge of this mesh has a small defect, still far above rounding.
    for (pieces, whole, least) in [
        (&inside.cells, &sums.cells, 1e-3),
        (&inside.faces, &sums.faces, 1e-3),
        (&inside.hinges, &sums.hinges, 1e-8),
        (&bent.faces, &outer.faces, 1e-3),
        (&bent.hinges, &outer.hinges, 1e-3),
    ] {
        let [pieces, whole] = [pieces, whole].map(|list| list.iter().sum::<f64>());
        assert!((pieces - whole).abs() < ROUNDING, "{pieces} {whole}");
        assert!(whole.abs() > least, "{whole}");
    }
    // A simplex has its own piece and no other's.
    for (codimension, own) in [&inside.cells, &inside.faces, &inside.hinges]
        .iter()
        .enumerate()
    {
        let range = each.range(codimension);
        let others = (0..own.len()).filter(|i| !range.contains(i));
        assert!(others.into_iter().all(|i| own[i] == 0.0), "{codimension}");
        let k = 3 - codimension;
        for (simplex, piece) in own[range].iter().enumerate() {
            assert!(mesh.is_interior(k, simplex) || *piece == 0.0);
            assert!(!mesh.is_interior(k, simplex) || *piece != 0.0);
        }
    }
}

/// ω by one point at a time is ω by lanes, cell by cell.
#[test]
fn volumes_do_not_depend_on_lanes() {
    let mesh = Mesh::<3>::cube(1).unwrap().perturbed(0.05, 2).unwrap();
    let smooth = Smooth::new(&mesh, Metric::Trig).unwrap();
    let rules = Rules::new(3, 6);
    let wide = cell_volumes(&smooth, &mesh, &rules);
    let single = cell_volumes(&PointByPoint(&smooth), &mesh, &rules);
    assert_eq!(wide.len(), mesh.cell_count());
    assert_relative_eq!(wide[..], single[..], epsilon = 0.0, max_relative = ROUNDING);
}

/// Every interpolant by one point at a time is that by lanes, and refuses the same.
#[test]
fn interpolants_do_not_depend_on_lanes() {
    let mesh = Mesh::<3>::cube(1).unwrap().perturbed(0.05, 2).unwrap();
    let smooth = Smooth::new(&mesh, Metric::Trig).unwrap();
    for degree in 0..=2 {
        let space = ReggeSpace::new(&mesh, degree);
        let all = Interpolant::ALL.into_iter();
        for one in all.filter(|one| one.check_degree(degree).is_ok()) {
            let wide = one.apply(&space, &smooth).unwrap();
            let single = one.apply(&space, &PointByPoint(&smooth)).unwrap();
            let (wide, single) = (wide.coefficients(), single.coefficients());
            assert_abs_diff_eq!(wide, single, epsilon = 1e-13 * largest(single));
        }
    }
    // One point of one cell is enough to be refused: it is named.
    let space = ReggeSpace::new(&mesh, 1);
    let mut coefficients = random_regge(&space, 0.1, 2).coefficients().to_vec();
    coefficients[space.cell_dof(3, 0, 0)] = -50.0;
    let bad = space.function(coefficients).unwrap();
    let points = Rules::on(&mesh, 5).cells;
    let refused = bad.check_positive(points.points()).unwrap_err();
    let again = check_positive(&PointByPoint(&bad), &mesh, points.points());
    assert_eq!(refused, again.unwrap_err());
}

/// Several spaces at once get what each of them gets alone, to the bit.
#[test]
fn several_spaces_get_what_each_gets() {
    let mesh = crooked_cube::<3>(2, 2);
    let space = ReggeSpace::new(&mesh, 1);
    let (g, rules) = (random_regge(&space, 0.1, 2), Rules::on(&mesh, 4));
    let (hats, cubics) = (Lagrange::new(&mesh, 1), Lagrange::new(&mesh, 3));
    let each = Indicators::new(&mesh);
    let spaces: [&dyn TestSpace<3, Value = Scalar>; 3] = [&hats, &cubics, &each];
    let alone = [
        distributional_curvature(&g, &hats, &rules),
        distributional_curvature(&g, &cubics, &rules),
        distributional_curvature(&g, &each, &rules),
    ];
    assert_eq!(distributional_curvatures(&g, &spaces, &rules), alone);
    let alone = [
        boundary_curvature(&g, &hats, &rules),
        boundary_curvature(&g, &cubics, &rules),
        boundary_curvature(&g, &each, &rules),
    ];
    assert_eq!(boundary_curvatures(&g, &spaces, &rules), alone);
    let alone = [
        smooth_curvature(&g, &hats, &rules),
        smooth_curvature(&g, &cubics, &rules),
        smooth_curvature(&g, &each, &rules),
    ];
    let zero = |len: usize| vec![0.0; len];
    let alone = alone.map(|cells| Sums {
        faces: zero(cells.len()),
        hinges: zero(cells.len()),
        cells,
    });
    assert_eq!(smooth_curvatures(&g, &spaces, &rules), alone);
}

/// A field that counts how often its value is asked for.
struct Counted<'a, G>(&'a G, AtomicUsize);

impl<T: Real, const N: usize, G: Evaluate<T, N>> Evaluate<T, N> for Counted<'_, G> {
    type Table = G::Table;
    type Local = G::Local;

    fn tabulate(&self, points: &Points) -> Self::Table {
        self.0.tabulate(points)
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.0.on_cell(cell)
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        self.0.jet2(local, table, block)
    }
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        self.1.fetch_add(1, Ordering::Relaxed);
        self.0.value(local, table, block)
    }
    fn is_constant(&self) -> bool {
        self.0.is_constant()
    }
}

/// Around hinges, what is constant on cells is asked for at one point, whatever the rule; what is not, at all of them.
#[test]
fn constants_are_asked_for_once() {
    let mesh = crooked_cube::<3>(2, 2);
    let test = Lagrange::new(&mesh, 2);
    let count = |metric: usize, degree: usize, order: usize| {
        let [g, sigma] = [metric, degree].map(|degree| ReggeSpace::new(&mesh, degree));
        let (g, sigma) = (random_regge(&g, 0.1, 2), random_regge(&sigma, 0.1, 3));
        let counted = Counted(&PointByPoint(&sigma), AtomicUsize::new(0));
        // Twice the order on hinges alone, where the rule then has more points.
        let mut rules = Rules::new(3, 4);
        rules.hinges = Rules::new(3, order).hinges;
        a_h(&PointByPoint(&g), &counted, &test, &rules);
        counted.1.into_inner()
    };
    assert_eq!(count(0, 0, 4), count(0, 0, 8));
    for (metric, degree) in [(1, 0), (0, 1), (1, 1)] {
        assert!(count(metric, degree, 4) < count(metric, degree, 8));
    }
}

/// The lanes run the same lines as f64.
#[test]
fn lanes_agree_with_f64() {
    let mesh = crooked_cube::<3>(2, 2);
    let space = ReggeSpace::new(&mesh, 2);
    let g = random_regge(&space, 0.1, 2);
    let test = Lagrange::new(&mesh, 3);
    let rules = Rules::new(3, 7);
    let one = distributional_curvature(&PointByPoint(&g), &test, &rules);
    let four = distributional_curvature(&g, &test, &rules);
    for (a, b) in [
        (&one.cells, &four.cells),
        (&one.faces, &four.faces),
        (&one.hinges, &four.hinges),
    ] {
        assert_abs_diff_eq!(a[..], b[..], epsilon = 1e-13 * largest(a));
    }
}

/// Every cell around a simplex adds what it sees. λ_0 (c_D + c_T) on each third of the k-simplices D, T ⊃ D, has the integral
/// (1 + δ_0i) (c_D + c_T) / (k + 2)! against the hat function of vertex i of D.
fn what_cells_see_is_added<const N: usize>() {
    let mesh = Mesh::<N>::cube(2).unwrap();
    let hats = Lagrange::new(&mesh, 1);
    let c = |simplex: usize, cell: usize| (simplex + 1) as f64 + 100.0 * (cell + 1) as f64;
    for k in 1..=N {
        let rule = Rule::new(k, 2);
        let some = || (1..mesh.count(k)).step_by(3);
        let of_cell = |cell: usize| match k == N {
            true => vec![cell as u32],
            false => mesh.simplices_of(cell, k).to_vec(),
        };
        let found = integrate(&hats, k, &rule, some(), |simplex, side, point| {
            assert_eq!(simplex, of_cell(side.cell)[side.place] as usize);
            rule.points().lambda(point)[0] * c(simplex, side.cell)
        });
        let factorial: usize = (1..=k + 2).product();
        let mut expected = vec![0.0; hats.len()];
        for simplex in some() {
            let cells =
                (0..mesh.cell_count()).filter(|&cell| of_cell(cell).contains(&(simplex as u32)));
            let seen: f64 = cells.map(|cell| c(simplex, cell)).sum();
            for (i, &vertex) in mesh.vertices(k, simplex).iter().enumerate() {
                let twice = if i == 0 { 2.0 } else { 1.0 };
                expected[vertex as usize] += twice * seen / factorial as f64;
            }
        }
        // The rule is exact for λ_0 λ_i; what is left is the rounding of sums of positive terms.
        assert_relative_eq!(found[..], expected[..], max_relative = 1e-12);
    }
}

#[test]
fn integrals_add_what_the_cells_around_see() {
    what_cells_see_is_added::<2>();
    what_cells_see_is_added::<3>();
}
