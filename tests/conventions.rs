//! The numbers of docs/conventions.md.

use regge_curvature::density::{Normal, Side};
use regge_curvature::formulas::PAPER;
use regge_curvature::functional::{
    Rules, Three, b_h, boundary_curvature, cell_volumes, distributional_curvature, einstein_against,
};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, identity, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, SmoothTensor};
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::{Connection, reverse_trace, trace};
use regge_curvature::scalar::Real;
use regge_curvature::simplex::subsets;
use regge_curvature::spaces::{Lagrange, ReggeSpace, dofs_per_simplex};
use std::f64::consts::PI;

/// A few units in the last place of numbers of size 10.
const ROUNDING: f64 = 1e-13;

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < ROUNDING, "{a} is not {b}");
}

fn jets<const N: usize>(x: [f64; N]) -> [Jet2<f64, N>; N] {
    std::array::from_fn(|m| Jet2::coordinate(x[m], m))
}

#[test]
fn curvature_is_positive_on_spheres() {
    fn on_sphere<const N: usize>() {
        let x = std::array::from_fn(|i| 0.3 - 0.2 * i as f64);
        let connection = Connection::new(&Metric::Sphere.at(&jets::<N>(x)));
        let (n, r) = (N as f64, connection.scalar());
        close(r, n * (n - 1.0));
        let (g, inverse) = (connection.lower().g, connection.lower().inverse);
        let ricci = connection.ricci();
        (0..N).for_each(|i| (0..N).for_each(|j| close(ricci[(i, j)], (n - 1.0) * g[(i, j)])));
        close(
            trace(&inverse, &connection.einstein(&PAPER)),
            -(n - 2.0) / 2.0 * r,
        );
        close(
            trace(&inverse, &reverse_trace(&PAPER, &g, &inverse, &g)),
            (1.0 - n) * n,
        );
    }
    on_sphere::<2>();
    on_sphere::<3>();
    on_sphere::<4>();
}

/// g = e^{−2x} δ: Γ^1_11 = ½ g^11 ∂_1 g_11 = −1.
#[test]
fn christoffel_symbols_have_their_upper_index_first() {
    let x = jets([0.4, 0.7]);
    let factor = (x[0] * Jet2::constant(-2.0)).exp();
    let zero = Jet2::constant(0.0);
    let g: Mat<Jet2<f64, 2>, 2> = symmetric(|i, j| if i == j { factor } else { zero });
    let connection = Connection::new(&g).lower();
    close(connection.gamma[0][(0, 0)], -1.0);
    // Γ^2_12 = −1 as well, Γ^1_22 = +1.
    close(connection.gamma[1][(0, 1)], -1.0);
    close(connection.gamma[0][(1, 1)], 1.0);
}

/// The unit sphere in Euclidean space at (1, 0, 0), ν = d|x|²/2.
#[test]
fn mean_curvature_is_positive_on_spheres_seen_from_inside() {
    let flat: Mat<Jet1<f64, 3>, 3> = identity::<f64, 3>().map(Jet1::constant);
    let connection = Connection::new(&flat);
    let nu: Vector<Jet1<f64, 3>, 3> =
        Vector::from_fn(|i, _| Jet1::coordinate(f64::from(u8::from(i == 0)), i));
    let side = Side::new(&PAPER, &connection, &nu);
    let normal = &side.normal;
    let alone = Normal::new(
        &PAPER,
        &connection.inverse,
        connection.det,
        &nu.map(|x| x.value),
    );
    close((alone.n - normal.n).norm(), 0.0);
    close(normal.normal_normal(&connection.g), 1.0);
    close(side.mean_curvature, 2.0);
    close(side.densitized_mean_curvature(), 2.0);
    close(normal.trace(&side.trace_reversed()), -2.0);
}

/// ∂Δ^{N+1} with all edges 1.
fn total<const N: usize>() -> f64 {
    let mesh = Mesh::<N>::simplex_boundary().unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let g = space.function(vec![1.0; space.len()]).unwrap();
    let hats = Lagrange::new(&mesh, 1);
    let sums = distributional_curvature(&g, &hats, &Rules::new(N, 1));
    sums.total().iter().sum()
}

#[test]
fn angles_and_defects_of_regular_simplices() {
    // Four vertices with Θ = 2π − 3·π/3 = π; ten edges with Θ = 2π − 3 arccos ⅓.
    close(total::<2>(), 2.0 * 4.0 * PI);
    let theta = 2.0 * PI - 3.0 * (1.0f64 / 3.0).acos();
    close(total::<3>() / 10.0, 2.0 * theta);
    let mesh = Mesh::<3>::simplex_boundary().unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let g = space.function(vec![1.0; space.len()]).unwrap();
    let einstein = einstein_against(&g, &space, &Rules::new(3, 1)).total();
    einstein.iter().for_each(|x| close(*x, -theta));
}

#[test]
fn a_triangle_has_a_volume_and_a_total() {
    let mesh = Mesh::<2>::single().unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let g = space.function(vec![1.0; 3]).unwrap();
    let rules = Rules::new(2, 1);
    close(cell_volumes(&g, &mesh, &rules)[0], 3f64.sqrt() / 4.0);
    let outer = boundary_curvature(&g, &Lagrange::new(&mesh, 1), &rules);
    close(outer.total().iter().sum(), 4.0 * PI);
    close(outer.hinges[0], 2.0 * (PI - PI / 3.0));
}

/// ∂Δ³ with all edges 1 has Θ = π at each vertex: 2π Σ c_i for v = Σ c_i v_i.
#[test]
fn sums_are_paired_with_coefficients() {
    let mesh = Mesh::<2>::simplex_boundary().unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let g = space.function(vec![1.0; space.len()]).unwrap();
    let hats = Lagrange::new(&mesh, 1);
    let sums = distributional_curvature(&g, &hats, &Rules::new(2, 1));
    let Three {
        cells,
        faces,
        hinges,
    } = sums.pair(&[0.0, 1.0, -2.0, 5.0]);
    assert_eq!([cells, faces], [0.0; 2]);
    close(hinges, 8.0 * PI);
}

/// b_h with σ = g is (1−N) ∫ Δv and back by the divergence theorem: Δλ_0² = 2|∇λ_0|² = 8/3 on an area of √3/4. Without
/// the boundary its face sum is empty here, which only a library that can be told to leave it out shows.
#[test]
fn b_h_counts_the_faces_of_the_boundary() {
    let mesh = Mesh::<2>::single().unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let g = space.function(vec![1.0; 3]).unwrap();
    let (squares, rules) = (Lagrange::new(&mesh, 2), Rules::new(2, 2));
    let b = b_h(&g, &g, &squares, &rules);
    close(b.faces[0], 2.0 / 3f64.sqrt());
    close(b.cells[0], -2.0 / 3f64.sqrt());
    #[cfg(feature = "formulas")]
    {
        let inner = rules.with_formulas(regge_curvature::formulas::Formulas {
            b_on_boundary: false,
            ..PAPER
        });
        let inner = b_h(&g, &g, &squares, &inner);
        assert_eq!(inner.faces, vec![0.0; squares.len()]);
        assert_eq!(inner.cells, b.cells);
    }
}

#[test]
fn the_default_order_is_as_stated() {
    assert_eq!([0, 1, 2].map(Rules::default_order), [6, 8, 10]);
}

#[test]
fn meshes_and_spaces_are_numbered_as_stated() {
    assert_eq!(subsets(3, 2), [[0, 1], [0, 2], [1, 2]]);
    assert_eq!(
        (
            dofs_per_simplex(0, 1),
            dofs_per_simplex(1, 1),
            dofs_per_simplex(1, 2)
        ),
        (1, 2, 3)
    );
    let cube = Mesh::<3>::cube(1).unwrap();
    assert_eq!(
        (
            cube.cell_count(),
            cube.interior(1).count(),
            cube.interior(0).count()
        ),
        (6, 1, 0)
    );
    let hats = Lagrange::new(&cube, 1);
    assert!((0..8).all(|v| hats.owner(v) == (0, v)));
    close(Rule::new(2, 7).weights().iter().sum(), 0.5);
    // k = 1: squares of side 1, cut in two.
    close(Mesh::<2>::cube(2).unwrap().mesh_size(), 2f64.sqrt());
    // Squared lengths: a triangle with sides 3, 4, 5 has a right angle at vertex 0.
    let mesh = Mesh::<2>::single().unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let g = space.function(vec![9.0, 16.0, 25.0]).unwrap();
    let outer = boundary_curvature(&g, &Lagrange::new(&mesh, 1), &Rules::new(2, 1));
    close(outer.hinges[0], 2.0 * (PI - PI / 2.0));
}
