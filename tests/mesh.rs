//! Meshes: counts, what is interior, and one clear error for each kind of bad input.

use nalgebra::SVector;
use regge_curvature::Error;
use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;
use regge_curvature::simplex::{binomial, factorial};

/// Freudenthal's cube and torus, by the numbers: N! side^N cells, χ = 1 and 0.
fn counts<const N: usize>(side: usize) {
    let cells = factorial(N) as usize * side.pow(N as u32);
    let cube = Mesh::<N>::cube(side).expect("a cube");
    assert_eq!(cube.cell_count(), cells);
    assert_eq!(cube.count(0), (side + 1).pow(N as u32));
    assert_eq!(cube.euler_characteristic(), 1);
    assert_eq!(cube.interior(0).count(), (side - 1).pow(N as u32));
    assert!((cube.mesh_size() - (N as f64).sqrt() * 2.0 / side as f64).abs() < 1e-14);
    let torus = Mesh::<N>::torus(3).expect("a torus");
    assert!(torus.is_closed());
    assert_eq!(torus.euler_characteristic(), 0);
    assert_eq!(
        torus.cell_count(),
        factorial(N) as usize * 3usize.pow(N as u32)
    );
}

#[test]
fn cubes_and_tori_have_the_right_numbers() {
    counts::<2>(4);
    counts::<3>(2);
    counts::<4>(2);
    counts::<5>(1);
}

/// The paper's section 5: 2·4^k triangles and 6·8^k tetrahedra.
#[test]
fn the_papers_meshes() {
    for k in 0..4 {
        assert_eq!(
            Mesh::<2>::cube(1 << k).expect("a square").cell_count(),
            2 * 4usize.pow(k)
        );
        assert_eq!(
            Mesh::<3>::cube(1 << k).expect("a cube").cell_count(),
            6 * 8usize.pow(k)
        );
    }
}

/// ∂Δ^{N+1} is a sphere: C(N+2, k+1) simplices of each dimension.
fn sphere<const N: usize>() {
    let mesh = Mesh::<N>::simplex_boundary().expect("a sphere");
    for k in 0..=N {
        assert_eq!(mesh.count(k), binomial(N + 2, k + 1));
    }
    assert!(mesh.is_closed() && !mesh.has_coordinates());
    assert_eq!(
        mesh.euler_characteristic(),
        if N.is_multiple_of(2) { 2 } else { 0 }
    );
}

#[test]
fn boundaries_of_simplices_are_spheres() {
    sphere::<2>();
    sphere::<3>();
    sphere::<4>();
    sphere::<5>();
}

/// "Interior" means not contained in the boundary: the diagonal of the cube between two boundary vertices is.
#[test]
fn an_edge_between_boundary_vertices_can_be_interior() {
    let mesh = Mesh::<3>::cube(1).expect("a cube");
    let interior: Vec<usize> = mesh.interior(1).collect();
    assert_eq!(interior.len(), 1);
    let ends = mesh.vertices(1, interior[0]);
    assert!(ends.iter().all(|&v| !mesh.is_interior(0, v as usize)));
    // Around it stand all six tetrahedra.
    assert_eq!(mesh.star(1, interior[0]).count(), 6);
}

#[test]
fn incidence_is_consistent() {
    let mesh = Mesh::<3>::cube(2).expect("a cube");
    for k in 0..3 {
        for s in 0..mesh.count(k) {
            for side in mesh.star(k, s) {
                assert_eq!(mesh.simplices_of(side.cell, k)[side.place] as usize, s);
                let cell = mesh.vertices(3, side.cell);
                assert!(mesh.vertices(k, s).iter().all(|v| cell.contains(v)));
            }
        }
    }
}

/// The same seed moves the same vertices by the same amounts; the boundary stays; nothing is inverted.
#[test]
fn perturbation_is_reproducible() {
    let mesh = Mesh::<2>::cube(8).expect("a square");
    let one = mesh.perturbed_as_in_paper(3, 5).expect("a mesh");
    let same = mesh.perturbed_as_in_paper(3, 5).expect("a mesh");
    let other = mesh.perturbed_as_in_paper(3, 6).expect("a mesh");
    assert_eq!(one.points(), same.points());
    assert_ne!(one.points(), other.points());
    let (before, after) = (
        mesh.points().expect("points"),
        one.points().expect("points"),
    );
    for v in 0..mesh.count(0) {
        let moved = (after[v] - before[v]).amax();
        // h̃ 2^{−5/2} with h̃ = √2 2^{1−k}: a quarter of a cell's side (claims.md, N03).
        assert!(moved <= 0.25 * 0.25);
        assert!(mesh.is_interior(0, v) || moved == 0.0);
    }
}

#[test]
fn too_large_a_perturbation_is_refused_by_cell() {
    let mesh = Mesh::<2>::cube(4).expect("a square");
    let error = mesh.perturbed(0.5, 1).expect_err("cells are inverted");
    assert!(
        matches!(error, Error::Cell { .. }) && error.to_string().contains("inverted"),
        "{error}"
    );
}

fn point(x: f64, y: f64) -> Vector<f64, 2> {
    SVector::from([x, y])
}

fn square() -> Vec<Vector<f64, 2>> {
    vec![
        point(0.0, 0.0),
        point(1.0, 0.0),
        point(0.0, 1.0),
        point(1.0, 1.0),
    ]
}

/// Each kind of bad input: one line that names the place.
#[test]
fn bad_input_is_named() {
    let refuse = |points: Vec<Vector<f64, 2>>, cells: &[&[usize]], expected: &str| {
        let cells: Vec<Vec<usize>> = cells.iter().map(|c| c.to_vec()).collect();
        let error = Mesh::<2>::new(points, &cells)
            .expect_err(expected)
            .to_string();
        assert!(
            error.contains(expected),
            "{error:?} should contain {expected:?}"
        );
        assert!(!error.contains('\n'));
    };
    refuse(
        square(),
        &[&[0, 1, 2], &[1, 1, 3]],
        "cell 1: vertex 1 is repeated",
    );
    refuse(
        square(),
        &[&[0, 1, 2], &[1, 2, 4]],
        "cell 1: vertex 4 does not exist",
    );
    refuse(square(), &[&[0, 1, 2], &[1, 2]], "cell 1: has 2 vertices");
    refuse(square(), &[&[0, 1, 2]], "vertex 3: belongs to no cell");
    refuse(square(), &[], "0 cells");
    let mut nan = square();
    nan[2] = point(f64::NAN, 0.0);
    refuse(nan, &[&[0, 1, 2], &[1, 2, 3]], "vertex 2: coordinates");
    let mut flat = square();
    flat[3] = point(0.5, 0.5);
    refuse(flat, &[&[0, 1, 2], &[1, 2, 3]], "cell 1: degenerate");
    let mut folded = square();
    folded[3] = point(0.1, 0.1);
    refuse(folded, &[&[0, 1, 2], &[1, 2, 3]], "cell 1: inverted");
    let mut three = square();
    three.push(point(2.0, 2.0));
    refuse(
        three,
        &[&[0, 1, 2], &[1, 2, 3], &[1, 2, 4]],
        "3 cells share this face",
    );
    let mut bow = square();
    bow.push(point(-1.0, 0.0));
    bow.push(point(-1.0, -1.0));
    refuse(
        bow,
        &[&[0, 1, 2], &[1, 2, 3], &[0, 4, 5]],
        "not connected through the faces",
    );
    assert!(Mesh::<2>::torus(2).is_err());
}

/// A mesh of one cell.
fn one_cell<const N: usize>(points: &[[f64; N]]) -> Mesh<N> {
    let points = points.iter().map(|&x| Vector::from(x)).collect();
    Mesh::new(points, &[(0..=N).collect()]).unwrap()
}

/// 1 for regular cells, by the edges and the volume for others, and the same for a cell of any size, up to rounding: that of the
/// regular ones is a few units, that of the others is multiplied by the condition of their Gram matrix, some 10².
#[test]
fn mean_ratios() {
    let equilateral = one_cell([[0.0, 0.0], [2.0, 0.0], [1.0, 3_f64.sqrt()]].as_slice());
    let regular = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0]];
    let regular = one_cell(&[&regular[..], &[[-1.0, -1.0, 1.0]]].concat());
    assert!((equilateral.mean_ratio(0).unwrap() - 1.0).abs() < 1e-14);
    assert!((regular.mean_ratio(0).unwrap() - 1.0).abs() < 1e-14);
    for scale in [1.0, 1e-3] {
        let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.3, 0.8, 0.1], [0.2, 0.4, 0.15]];
        let points = points.map(|x| x.map(|x| scale * x));
        let mesh = one_cell(&points);
        let squares = (0..4).flat_map(|i| (0..i).map(move |j| (i, j)));
        let squares = squares
            .map(|(i, j)| (Vector::from(points[i]) - Vector::from(points[j])).norm_squared());
        let volume = mesh.jacobian(0).unwrap().determinant().abs() / 6.0;
        let expected = 12.0 * (3.0 * volume).powf(2.0 / 3.0) / squares.sum::<f64>();
        assert!((mesh.mean_ratio(0).unwrap() / expected - 1.0).abs() < 1e-12);
    }
}
