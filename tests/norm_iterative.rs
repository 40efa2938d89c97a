//! The matrix-free solver against the direct one, and its own properties.

use regge_curvature::Error;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::norm::{
    BiharmonicSolver, Census, Direct, HMinus2, Hhj, Iterative, Step, Target,
};
use std::sync::Arc;

use crate::domains;

fn perturbed<const N: usize>(level: u32, seed: u64) -> Mesh<N> {
    Mesh::cube(1 << level)
        .unwrap()
        .perturbed_as_in_paper(level, seed)
        .unwrap()
}

/// Seeded random numbers: rougher than any load of a study.
pub fn random_load(len: usize, seed: u64) -> Vec<f64> {
    let mut random = SplitMix64::new(seed);
    (0..len).map(|_| random.symmetric()).collect()
}

/// max |a − b| over max |b|.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(f64::MIN_POSITIVE, |m: f64, x| m.max(x.abs()));
    let error = |m: f64, (x, y): (&f64, &f64)| m.max((x - y).abs());
    a.iter().zip(b).fold(0.0, error) / size
}

fn agrees_with_direct<const N: usize>(mesh: &Mesh<N>, degree: usize) {
    // The energy is minimal: its error is of second order.
    agrees_up_to(mesh, degree, 1e-10);
}

/// `energy` is how much the norms of σ may differ: the square of the iteration's error, and the direct solver's rounding.
pub fn agrees_up_to<const N: usize>(mesh: &Mesh<N>, degree: usize, energy: f64) {
    let hhj = Arc::new(Hhj::new(mesh, degree).unwrap());
    let load = random_load(hhj.space().len(), 7);
    let direct = Direct::new(hhj.clone()).unwrap();
    let expected = direct.solve(&load, &mut |_| ()).unwrap();
    let solver = Iterative::new(hhj).unwrap();
    let found = solver.solve(&load, &mut |_| ()).unwrap();
    // The iteration ends at a residual of 1e-8 in the norm of the energy; single coefficients may be a little worse.
    let error = distance(&found.coefficients, &expected.coefficients);
    assert!(
        error < 1e-7,
        "N = {N}, degree {degree}: differs by {error:e}"
    );
    let norm = HMinus2::with_solver(Box::new(direct));
    let [found, expected] = [found, expected].map(|u| norm.norm_of(&u, None).unwrap());
    for (a, b, tolerance) in [
        (found.u_l2, expected.u_l2, 1e-8),
        (found.grad_l2, expected.grad_l2, 1e-8),
        (found.sigma_l2, expected.sigma_l2, energy),
    ] {
        assert!(
            (a / b - 1.0).abs() < tolerance,
            "N = {N}, degree {degree}: {a} is not {b}"
        );
    }
}

#[test]
fn direct_3d() {
    for degree in 2..=4 {
        for level in 0..=2 {
            agrees_with_direct(&perturbed::<3>(level, 3), degree);
        }
    }
    agrees_with_direct(&Mesh::<3>::cube(3).unwrap(), 3);
    agrees_with_direct(&perturbed::<3>(1, 5), 1);
    // Four bubbles to a cell.
    agrees_with_direct(&perturbed::<3>(1, 5), 5);
}

#[test]
fn direct_2d() {
    for degree in 1..=5 {
        agrees_with_direct(&perturbed::<2>(3, 3), degree);
    }
    agrees_with_direct(&Mesh::<2>::cube(1).unwrap(), 3);
}

/// Measured: 14 and 16, 16 and 20, 22 and 28 steps. Without the splines they are 40 and 148 for p = 2, 122 and 427 for
/// p = 4.
#[test]
fn steps_hardly_grow() {
    for (degree, most) in [(2, 20), (3, 25), (4, 35)] {
        let steps = [2, 3].map(|level| {
            let mesh = perturbed::<3>(level, 3);
            let hhj = Hhj::new(&mesh, degree).unwrap();
            let norm = HMinus2::with_solver(Box::new(Iterative::new(hhj).unwrap()));
            let load = random_load(norm.space().len(), 1);
            let (mut steps, mut before) = (0, f64::INFINITY);
            norm.solve_watched(&load, &mut |step| {
                steps += 1;
                assert_eq!(step.number, steps);
                before = step.residual;
            })
            .unwrap();
            assert!(before <= Target::DEFAULT.residual && before <= 1e-8);
            steps
        });
        assert!(
            steps.iter().all(|&s| s <= most),
            "degree {degree}: {steps:?}"
        );
        assert!(steps[1] <= steps[0] + 10, "degree {degree}: {steps:?}");
    }
}

/// A rectangle with sides of any length is a lattice as well.
#[test]
fn stretched_boxes() {
    let mesh = perturbed::<3>(2, 9);
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|t| mesh.vertices(3, t).iter().map(|&v| v as usize).collect())
        .collect();
    let moved = mesh.points().unwrap().iter();
    let points = moved.map(|x| [0.7 * x[0] + 3.0, 1.2 * x[1], x[2] - 1.0].into());
    let stretched = Mesh::new(points.collect(), &cells).unwrap();
    agrees_with_direct(&stretched, 3);
}

/// A mesh that has bad cells, which are treated in another way: below a mean ratio of 0.45.
fn with_bad_cells() -> Mesh<3> {
    let mesh = Mesh::<3>::cube(3).unwrap().perturbed(0.2, 5).unwrap();
    let mut ratios = (0..mesh.cell_count()).map(|cell| mesh.mean_ratio(cell).unwrap());
    assert!(ratios.any(|ratio| ratio < 0.4));
    mesh
}

/// What it solves are the equations of the cells' matrices, row by row, for all degrees, and with more cells than it goes through at
/// a time.
#[test]
fn equations_are_those_of_the_cells() {
    let mesh = with_bad_cells();
    for degree in 2..=5 {
        solves_the_equations(&mesh, degree);
    }
    let mesh = Mesh::<3>::cube(9).unwrap().perturbed(0.02, 5).unwrap();
    solves_the_equations(&mesh, 2);
}

fn solves_the_equations(mesh: &Mesh<3>, degree: usize) {
    let target = Target {
        residual: 1e-15,
        steps: 1000,
    };
    let hhj = Arc::new(Hhj::new(mesh, degree).unwrap());
    let load = random_load(hhj.space().len(), 3);
    let solver = Iterative::with_target(hhj.clone(), target).unwrap();
    let x = solver.solve(&load, &mut |_| ()).unwrap().coefficients;
    let (mut rest, mut size) = (vec![0.0; hhj.len()], vec![0.0_f64; hhj.len()]);
    rest[..load.len()].copy_from_slice(&load);
    for cell in 0..mesh.cell_count() {
        let (energy, unknowns) = (hhj.energy(cell), hhj.cell_unknowns(cell));
        for (i, &row) in unknowns.iter().enumerate() {
            for (j, &column) in unknowns.iter().enumerate() {
                let term = energy[(i.max(j), i.min(j))] * x[column];
                rest[row] -= term;
                size[row] += term.abs();
            }
        }
    }
    let slopes = (hhj.len() - load.len()) / mesh.count(2);
    let free = |&row: &usize| match row.checked_sub(load.len()) {
        None => hhj.space().vanishes_on_boundary(row),
        Some(slope) => mesh.is_interior(2, slope / slopes),
    };
    // Rounding of a few hundred terms a row, of which 1e-14 was seen: the iteration goes on until it no longer matters.
    for row in (0..hhj.len()).filter(free) {
        let (rest, size) = (rest[row], size[row]);
        assert!(
            rest.abs() < 1e-13 * size,
            "degree {degree}, row {row}: {rest:e} of {size:e}"
        );
    }
}

/// The preconditioner M⁻¹ is symmetric and positive, for all degrees: on random r, of which smooth ones weigh most, and on S x for
/// random x, of which rough ones do.
#[test]
fn preconditioner_is_symmetric_and_positive() {
    let mesh = with_bad_cells();
    for degree in 2..=5 {
        let solver = Iterative::new(Hhj::new(&mesh, degree).unwrap()).unwrap();
        let image = |x: Vec<f64>| {
            let mut y = vec![0.0; x.len()];
            solver.apply(&x, &mut y, &mut Vec::new());
            y
        };
        let smooth: Vec<_> = (0..3).map(|i| random_load(solver.unknowns(), i)).collect();
        let rough: Vec<_> = smooth.iter().cloned().map(image).collect();
        for vectors in [smooth, rough] {
            is_symmetric_and_positive(&solver, &vectors, degree);
        }
    }
}

fn is_symmetric_and_positive(solver: &Iterative<3>, vectors: &[Vec<f64>], degree: usize) {
    let image = |r: &Vec<f64>| {
        let mut z = vec![0.0; r.len()];
        solver.precondition(r, &mut z);
        z
    };
    let images: Vec<_> = vectors.iter().map(image).collect();
    let product = |i: usize, j: usize| -> f64 {
        let terms = vectors[i].iter().zip(&images[j]);
        terms.map(|(r, z)| r * z).sum()
    };
    for i in 0..vectors.len() {
        assert!(product(i, i) > 0.0, "degree {degree}: {}", product(i, i));
        for j in 0..i {
            let difference = product(i, j) - product(j, i);
            // Single precision in blocks and splines.
            let scale = (product(i, i) * product(j, j)).sqrt();
            assert!(
                difference.abs() < 1e-5 * scale,
                "degree {degree}: {difference:e}, {scale:e}"
            );
        }
    }
}

/// What is chosen; N = 4 is not for the iteration.
#[test]
fn chosen_by_size() {
    let solver = |mesh: &Mesh<3>, degree| HMinus2::new(mesh, degree).unwrap().solver();
    assert_eq!(solver(&Mesh::alfeld().unwrap(), 3), "cholesky");
    // Not one of these is worth an iteration.
    assert_eq!(solver(&perturbed(1, 1), 4), "cholesky");
    assert_eq!(solver(&perturbed(3, 1), 2), "cg");
    assert_eq!(solver(&domains::fichera(8), 2), "cholesky");
    let hhj = Hhj::new(&Mesh::<4>::cube(1).unwrap(), 2).unwrap();
    assert!(matches!(Iterative::new(hhj), Err(Error::Input(_))));
}

/// A load of zero, and a mesh on which no unknown is left.
#[test]
fn nothing_to_solve() {
    let mesh = perturbed::<3>(1, 1);
    let solver = Iterative::new(Hhj::new(&mesh, 2).unwrap()).unwrap();
    let zero = solver
        .solve(&vec![0.0; solver.hhj().space().len()], &mut |_| ())
        .unwrap();
    assert!(zero.coefficients.iter().all(|x| *x == 0.0));
}

/// One, two, three and eight threads give the same solution to the bit.
#[cfg(feature = "parallel")]
pub fn same_bits_for_any_threads<const N: usize>(mesh: &Mesh<N>, degree: usize) {
    let run = |threads: usize| -> Vec<u64> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let hhj = Hhj::new(mesh, degree).unwrap();
            let load = random_load(hhj.space().len(), 1);
            let solver = Iterative::new(hhj).unwrap();
            let found = solver.solve(&load, &mut |_| ()).unwrap();
            found.coefficients.iter().map(|x| x.to_bits()).collect()
        })
    };
    let one = run(1);
    for threads in [2, 3, 8] {
        assert!(one == run(threads), "{threads} threads");
    }
}

#[cfg(feature = "parallel")]
#[test]
fn threads_do_not_matter() {
    same_bits_for_any_threads(&perturbed::<3>(2, 6), 4);
}

/// A target of one's own: the iteration ends as soon as it is met, and gives up when its steps are used up.
#[test]
fn targets() {
    let mesh = perturbed::<3>(2, 3);
    let hhj = Arc::new(Hhj::new(&mesh, 2).unwrap());
    let load = random_load(hhj.space().len(), 1);
    let run = |residual: f64, steps: usize| {
        let target = Target { residual, steps };
        let solver = Iterative::with_target(hhj.clone(), target).unwrap();
        let mut residuals = Vec::new();
        let result = solver.solve(&load, &mut |step| residuals.push(step.residual));
        (result, residuals)
    };
    let share = |residual: f64| {
        let (target, number) = (
            Target {
                residual: 1e-6,
                steps: 9,
            },
            1,
        );
        target.share(Step { number, residual })
    };
    // Half of the way is the root of the target; a residual above the first one is no way back.
    assert!((share(1e-3) - 0.5).abs() < 1e-15 && share(1.0) == 0.0 && share(2.0) == 0.0);
    assert!(share(1e-7) == 1.0);
    let (result, residuals) = run(1e-3, 1000);
    assert!(result.is_ok());
    let (last, before) = residuals.split_last().unwrap();
    assert!(*last <= 1e-3 && before.iter().all(|r| *r > 1e-3));
    let (result, residuals) = run(1e-3, 2);
    assert!(matches!(result, Err(Error::Solver(_))));
    assert_eq!(residuals.len(), 2);
}

/// A cube's simplices are counted before it is there.
#[test]
fn census_of_the_cube() {
    fn check<const N: usize>(sides: &[usize]) {
        for &side in sides {
            let mesh = Mesh::<N>::cube(side).unwrap();
            let census = Census::cube(N, side);
            assert_eq!(census, Census::of(&mesh), "{N}, {side}");
        }
    }
    check::<2>(&[1, 2, 5]);
    check::<3>(&[1, 2, 3]);
    check::<4>(&[1, 2]);
}

/// What is estimated before there is a mesh is what is estimated with it, for the solver that is then chosen.
#[test]
fn memory_is_estimated_from_a_census() {
    let mesh = perturbed::<3>(2, 1);
    let census = Census::cube(3, 4);
    assert_eq!(census, Census::of(&mesh));
    let need = |census: &Census, degree| HMinus2::<3>::memory(census, degree);
    // The iteration's vectors, blocks and places, and no factor; it begins between these two degrees. Elsewhere it has rows of splines
    // besides.
    assert_eq!(HMinus2::new(&mesh, 5).unwrap().solver(), "cg");
    assert_eq!(HMinus2::new(&mesh, 3).unwrap().solver(), "cholesky");
    let elsewhere = Census {
        cube: false,
        ..census.clone()
    };
    assert!(need(&census, 5) < need(&elsewhere, 5));
    assert_eq!(need(&census, 3), need(&elsewhere, 3));
    // Twice as fine is eight times the cells, and more memory by more than that for a factor only.
    let fine = Census::cube(3, 8);
    let growth = need(&fine, 5) / need(&census, 5);
    assert!(7.0 < growth && growth < 9.0, "{growth}");
    assert!(need(&census, 3) / need(&Census::cube(3, 2), 3) > 10.0);
}
