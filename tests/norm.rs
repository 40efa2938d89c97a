//! The H⁻² norm against an independent dense discretisation, exact solutions, and its own invariances.

mod dense;
pub mod plate;

use plate::{Volume, load_of, plate_bilaplacian};
use regge_curvature::Error;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::norm::{
    DualNorm, HMinus2, HMinus2Norm, Kind, NormValue, Part, Representative, Setting, Step,
    check_load, metric_values,
};
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::Lagrange;

/// A load that is as good as any: seeded random numbers.
fn random_load(len: usize, seed: u64) -> Vec<f64> {
    let mut random = SplitMix64::new(seed);
    (0..len).map(|_| random.symmetric()).collect()
}

fn perturbed<const N: usize>(level: u32, seed: u64) -> Mesh<N> {
    Mesh::cube(1 << level)
        .unwrap()
        .perturbed_as_in_paper(level, seed)
        .unwrap()
}

/// max |a − b| over max |b|; 0 where both vanish.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(f64::MIN_POSITIVE, |m: f64, x| m.max(x.abs()));
    a.iter()
        .zip(b)
        .fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()))
        / size
}

fn close(a: HMinus2Norm, b: HMinus2Norm, tolerance: f64) {
    for (a, b) in [
        (a.u_l2, b.u_l2),
        (a.grad_l2, b.grad_l2),
        (a.sigma_l2, b.sigma_l2),
    ] {
        assert!((a - b).abs() <= tolerance * b, "{a} is not {b}");
    }
}

/// The other route: `dense` enforces normal-normal continuity by multipliers, in Cartesian components, and solves
/// the indefinite system by LU.
fn agrees_with_dense<const N: usize>(mesh: &Mesh<N>, degree: usize, tolerance: f64) {
    let norm = HMinus2::new(mesh, degree).unwrap();
    let load = random_load(norm.space().len(), 7);
    let solution = norm.solve(&load).unwrap();
    let (u, expected) = dense::solve(mesh, degree, &load);
    let error = distance(&solution.coefficients[..u.len()], &u);
    assert!(
        error < tolerance,
        "N = {N}, degree {degree}: u differs by {error:e}"
    );
    close(norm.norm(&load, None).unwrap(), expected, tolerance);
}

// Seen: up to 1e-13. The condition numbers of these small systems (1e3 to 1e5) leave 1e-11.
#[test]
fn dense_mixed_method_2d() {
    for degree in 1..=5 {
        agrees_with_dense(&Mesh::<2>::cube(1).unwrap(), degree, 1e-11);
    }
    for degree in 1..=4 {
        agrees_with_dense(&perturbed::<2>(1, 3), degree, 1e-11);
        agrees_with_dense(&Mesh::<2>::alfeld().unwrap(), degree, 1e-11);
    }
    agrees_with_dense(&perturbed::<2>(2, 5), 2, 1e-11);
}

#[test]
fn dense_mixed_method_3d() {
    for degree in 1..=3 {
        agrees_with_dense(&Mesh::<3>::cube(1).unwrap(), degree, 1e-11);
        agrees_with_dense(&Mesh::<3>::alfeld().unwrap(), degree, 1e-11);
    }
    agrees_with_dense(&Mesh::<3>::single().unwrap(), 5, 1e-11);
}

#[test]
fn dense_mixed_method_4d() {
    agrees_with_dense(&Mesh::<4>::alfeld().unwrap(), 2, 1e-11);
}

/// u = Π(1−x_i²)² is a polynomial of degree 8 in the plane: the method finds it.
#[test]
fn polynomials_are_exact() {
    for (degree, mesh) in [
        (8, Mesh::<2>::cube(1).unwrap()),
        (8, perturbed(1, 11)),
        (9, perturbed(1, 12)),
    ] {
        let norm = HMinus2::new(&mesh, degree).unwrap();
        let load = load_of(norm.space(), plate_bilaplacian);
        let [u, sigma] = plate::errors(&norm, &norm.solve(&load).unwrap());
        // Seen: 2e-12. Bernstein's bases of degree 8 have condition numbers of 1e4.
        assert!(
            u < 1e-10 && sigma < 1e-10,
            "degree {degree}: {u:e}, {sigma:e}"
        );
    }
}

/// Fitted orders of ‖u−u_h‖ and ‖∇²u−σ_h‖ between two levels, which must lie in `bands`.
fn converges<const N: usize>(degree: usize, levels: [u32; 2], bands: [[f64; 2]; 2]) {
    let errors = levels.map(|level| {
        let mesh = perturbed::<N>(level, 17);
        let norm = HMinus2::new(&mesh, degree).unwrap();
        let load = load_of(norm.space(), plate_bilaplacian);
        plate::errors(&norm, &norm.solve(&load).unwrap())
    });
    for i in 0..2 {
        let order = (errors[0][i] / errors[1][i]).log2() / f64::from(levels[1] - levels[0]);
        let [low, high] = bands[i];
        assert!(
            low < order && order < high,
            "N = {N}, degree {degree}, quantity {i}: order {order}, {errors:?}"
        );
    }
}

/// Orders p+1 of u (2 for p = 1) and p of σ: Babuška, Osborn, Pitkäranta, Math. Comp. 35 (1980).
#[test]
fn converges_at_the_proven_rates_2d() {
    for degree in 1..=4 {
        let p = degree as f64;
        converges::<2>(degree, [3, 5], [[p + 0.7, p + 1.3], [p - 0.3, p + 0.3]]);
    }
}

/// In space the moments are one order worse, p−1: b(τ, u − Iu) leaves terms ∫_e τ(n,t) (u − Iu) on the edges of the
/// cells, which vanish for no interpolant I into P_p; in the plane these edges are points, and nodes. By duality u is
/// of order min(p+1, 2(p−1)), so that p = 1 does not converge at all. (The dense mixed method above has the same
/// solutions: this is a property of the method, not of its hybridisation.)
#[test]
fn converges_one_order_worse_in_3d() {
    converges::<3>(1, [2, 3], [[-0.5, 0.5], [-0.5, 0.5]]);
    converges::<3>(2, [2, 3], [[1.1, 2.3], [0.6, 1.3]]);
    converges::<3>(4, [2, 3], [[4.6, 5.4], [2.6, 3.4]]);
}

/// f(u) = b(σ, u) = ‖σ‖².
#[test]
fn the_load_works_against_the_moments() {
    fn check<const N: usize>(mesh: &Mesh<N>, degree: usize) {
        let norm = HMinus2::new(mesh, degree).unwrap();
        let load = random_load(norm.space().len(), 5);
        let solution = norm.solve(&load).unwrap();
        let work: f64 = load
            .iter()
            .zip(&solution.coefficients)
            .map(|(f, u)| f * u)
            .sum();
        let sigma = norm.norm_of(&solution, None).unwrap().sigma_l2;
        // The solver's residual is 1e-16 times the condition number of a few local scales.
        assert!(
            (work - sigma * sigma).abs() < 1e-11 * work,
            "{work} is not {}",
            sigma * sigma
        );
    }
    for degree in 1..=6 {
        check(&perturbed::<2>(3, 2), degree);
    }
    for degree in 1..=4 {
        check(&perturbed::<3>(2, 2), degree);
    }
}

/// The same mesh with other numbers for its vertices, shuffled, and its cells in the opposite order.
fn relabelled<const N: usize>(mesh: &Mesh<N>, seed: u64) -> Mesh<N> {
    let points = mesh.points().unwrap();
    let mut new: Vec<usize> = (0..points.len()).collect();
    let mut random = SplitMix64::new(seed);
    for i in (1..new.len()).rev() {
        new.swap(i, (random.next_u64() % (i as u64 + 1)) as usize);
    }
    let mut moved = points.to_vec();
    for (old, &new) in new.iter().enumerate() {
        moved[new] = points[old];
    }
    let cell = |c: usize| {
        mesh.vertices(N, c)
            .iter()
            .map(|&v| new[v as usize])
            .collect()
    };
    Mesh::new(
        moved,
        &(0..mesh.cell_count()).rev().map(cell).collect::<Vec<_>>(),
    )
    .unwrap()
}

#[test]
fn numbering_does_not_matter() {
    fn check<const N: usize>(mesh: &Mesh<N>, degree: usize) {
        let norms = [mesh, &relabelled(mesh, 8)].map(|mesh| {
            let norm = HMinus2::new(mesh, degree).unwrap();
            norm.norm(&load_of(norm.space(), |x| (x[0] - 0.3) * x[1].exp()), None)
                .unwrap()
        });
        close(norms[0], norms[1], 1e-11);
    }
    check(&perturbed::<2>(3, 4), 4);
    check(&perturbed::<3>(2, 4), 3);
}

/// x → c x: f(v) is kept, so u grows by c^{4−N}, and with it the norms.
#[test]
fn scaling() {
    fn check<const N: usize>(mesh: &Mesh<N>, degree: usize, c: f64) {
        let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
            .map(|t| mesh.vertices(N, t).iter().map(|&v| v as usize).collect())
            .collect();
        let points = mesh.points().unwrap().iter().map(|x| x * c).collect();
        let large = Mesh::new(points, &cells).unwrap();
        let load = random_load(HMinus2::new(mesh, degree).unwrap().space().len(), 9);
        let expected = HMinus2::new(mesh, degree)
            .unwrap()
            .norm(&load, None)
            .unwrap();
        let found = HMinus2::new(&large, degree)
            .unwrap()
            .norm(&load, None)
            .unwrap();
        let u = c.powi(4 - N as i32);
        let volume = c.powf(N as f64 / 2.0);
        let back = HMinus2Norm {
            u_l2: found.u_l2 / (u * volume),
            grad_l2: found.grad_l2 / (u * volume / c),
            sigma_l2: found.sigma_l2 / (u * volume / (c * c)),
        };
        close(back, expected, 1e-11);
    }
    check(&perturbed::<2>(2, 4), 3, 7.3);
    check(&perturbed::<3>(1, 4), 3, 0.011);
}

/// Sums in a fixed order: not a bit depends on the number of threads.
#[cfg(feature = "parallel")]
#[test]
fn threads_do_not_matter() {
    fn run<const N: usize>(mesh: &Mesh<N>, degree: usize, threads: usize) -> (Vec<u64>, [u64; 3]) {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let norm = HMinus2::new(mesh, degree).unwrap();
            let solution = norm.solve(&random_load(norm.space().len(), 1)).unwrap();
            let n = norm.norm_of(&solution, None).unwrap();
            let bits = solution.coefficients.iter().map(|x| x.to_bits()).collect();
            (bits, [n.u_l2, n.grad_l2, n.sigma_l2].map(f64::to_bits))
        })
    }
    let (plane, space) = (perturbed::<2>(5, 6), perturbed::<3>(3, 6));
    for threads in [2, 3, 8] {
        assert!(
            run(&plane, 4, 1) == run(&plane, 4, threads),
            "{threads} threads in the plane"
        );
        assert!(
            run(&space, 3, 1) == run(&space, 3, threads),
            "{threads} threads in space"
        );
    }
}

#[test]
fn the_norms_take_any_rule() {
    let mesh = perturbed::<2>(2, 1);
    let norm = HMinus2::new(&mesh, 4).unwrap();
    let solution = norm
        .solve(&load_of(norm.space(), |x| x[0].sin() + 1.0))
        .unwrap();
    let exact = norm.norm_of(&solution, None).unwrap();
    // Order 2p is exact, so order 12 changes nothing; the paper's order 5 does.
    close(
        norm.norm_of(&solution, Some(&Rule::new(2, 12))).unwrap(),
        exact,
        1e-13,
    );
    let low = norm.norm_of(&solution, Some(&Rule::new(2, 5))).unwrap();
    let change = (low.total() / exact.total() - 1.0).abs();
    assert!(1e-8 < change && change < 1e-2, "changed by {change:e}");
}

#[test]
fn refusals() {
    let mesh = Mesh::<2>::cube(2).unwrap();
    assert!(matches!(HMinus2::new(&mesh, 0), Err(Error::Input(_))));
    assert!(matches!(
        HMinus2::new(&Mesh::<2>::torus(3).unwrap(), 3),
        Err(Error::Input(_))
    ));
    let two = Mesh::<2>::new_abstract(4, &[vec![0, 1, 2], vec![1, 2, 3]]).unwrap();
    assert!(matches!(
        HMinus2::new(&two, 3),
        Err(Error::NoCoordinates(_))
    ));
    let norm = HMinus2::new(&mesh, 3).unwrap();
    let mut load = vec![0.0; norm.space().len()];
    assert_eq!(norm.norm(&load, None).unwrap().total(), 0.0);
    assert!(matches!(norm.norm(&load[1..], None), Err(Error::Input(_))));
    assert!(matches!(
        norm.norm(&load, Some(&Rule::new(3, 2))),
        Err(Error::Input(_))
    ));
    load[2] = f64::NAN;
    assert!(matches!(norm.norm(&load, None), Err(Error::Input(_))));
}

/// A cell alone: no interior face, only bubbles; with too low a degree there is nothing left, and the norm is 0.
#[test]
fn a_single_cell() {
    let mesh = Mesh::<2>::single().unwrap();
    let nothing = HMinus2::new(&mesh, 2).unwrap();
    assert_eq!(nothing.norm(&[1.0; 6], None).unwrap().total(), 0.0);
    let bubble = HMinus2::new(&mesh, 3).unwrap();
    assert!(bubble.norm(&[1.0; 10], None).unwrap().total() > 0.0);
}

/// The table of norms: what is asked for by name is what its own constructor makes, to the bit, and the parts have names.
#[test]
fn norms_by_name() {
    fn check<const N: usize>(mesh: &Mesh<N>, degree: usize) {
        let kind = Kind::named("hm2").expect("the first norm");
        let test_degree = (kind.degree)(degree);
        assert_eq!(test_degree, degree + 2);
        let named = (kind.new)(&Setting::new(mesh, test_degree)).unwrap();
        let norm = HMinus2::new(mesh, test_degree).unwrap();
        assert_eq!(named.space().len(), norm.space().len());
        assert_eq!(named.solver(), norm.solver());
        let load = random_load(norm.space().len(), 3);
        let expected = norm.norm(&load, None).unwrap();
        let found = named.of(&load, None).unwrap();
        assert_eq!(found, NormValue::from(expected));
        assert_eq!(found.total, expected.total());
        let parts: Vec<_> = found.parts.iter().map(|p| (p.name, p.value)).collect();
        assert_eq!(
            parts,
            [
                ("u_l2", expected.u_l2),
                ("grad_l2", expected.grad_l2),
                ("sigma_l2", expected.sigma_l2)
            ]
        );
        // The two steps by themselves.
        let u = named.represent(&load, &mut |_| ()).unwrap();
        assert_eq!(u, norm.solve(&load).unwrap());
        let rule = Rule::new(N, 5);
        let [found, expected] = [
            named.measure(&u, Some(&rule)).unwrap().total,
            norm.norm_of(&u, Some(&rule)).unwrap().total(),
        ];
        assert_eq!(found, expected);
        assert!(matches!(
            named.represent(&load[1..], &mut |_| ()),
            Err(Error::Input(_))
        ));
    }
    check(&perturbed::<2>(2, 1), 1);
    check(&perturbed::<3>(1, 1), 0);
    assert!(Kind::<2>::named("hm3").is_none());
    let plane: Vec<_> = Kind::<2>::all().iter().map(|kind| kind.name).collect();
    let space: Vec<_> = Kind::<3>::all().iter().map(|kind| kind.name).collect();
    assert_eq!(plane, space, "the names do not depend on N");
}

/// A norm that the library does not know, behind the same seam: ‖f‖ = √(Σ f(v)²/d) over the basis functions that vanish on
/// ∂Ω, d the number of cells that carry v. It asks for nothing but a space, and a metric would be at hand.
#[derive(Debug)]
struct Weighted(Lagrange<2>, Vec<f64>);

impl DualNorm<2> for Weighted {
    fn space(&self) -> &Lagrange<2> {
        &self.0
    }

    fn solver(&self) -> &'static str {
        "diagonal"
    }

    fn represent(&self, load: &[f64], _: &mut dyn FnMut(Step)) -> Result<Representative, Error> {
        check_load(&self.0, load)?;
        let weighted = load.iter().zip(&self.1).map(|(f, w)| f * w);
        Ok(Representative {
            coefficients: weighted.collect(),
        })
    }

    fn measure(&self, u: &Representative, _: Option<&Rule>) -> Result<NormValue, Error> {
        let value = u.coefficients.iter().map(|x| x * x).sum::<f64>().sqrt();
        Ok(NormValue::of_parts(vec![Part { name: "l2", value }]))
    }
}

fn weighted(setting: &Setting<'_, 2>) -> Result<Box<dyn DualNorm<2>>, Error> {
    let space = Lagrange::new(setting.mesh, setting.degree);
    let centre = Points::new(3, vec![1.0 / 3.0; 3]);
    let mut weights = vec![0.0; space.len()];
    for cell in 0..setting.mesh.cell_count() {
        // √det g at the centre; 1 without a metric.
        let root = setting.metric.map_or(1.0, |g| {
            let g = g(cell, &centre)[0];
            (g[(0, 0)] * g[(1, 1)] - g[(0, 1)] * g[(1, 0)]).sqrt()
        });
        for dof in space.cell_dofs(cell) {
            weights[dof] += root;
        }
    }
    for (dof, weight) in weights.iter_mut().enumerate() {
        *weight = match space.vanishes_on_boundary(dof) {
            true => weight.powf(-0.5),
            false => 0.0,
        };
    }
    Ok(Box::new(Weighted(space, weights)))
}

/// A setting hands the metric on in reference coordinates: that of a metric which is constant is JᵀgJ on each cell.
#[test]
fn a_norm_of_ones_own_that_depends_on_the_metric() {
    let mesh = perturbed::<2>(2, 1);
    let kind = Kind {
        name: "weighted",
        symbol: "w",
        about: "for this test",
        degree: |_| 1,
        memory: |census, _| 8.0 * census.simplices[0] as f64,
        new: weighted,
    };
    let setting = Setting::new(&mesh, (kind.degree)(3));
    let plain = (kind.new)(&setting).unwrap();
    let load = random_load(plain.space().len(), 2);
    let first = (0..mesh.count(0))
        .find(|&v| mesh.is_interior(0, v))
        .unwrap();
    let mut one = vec![0.0; load.len()];
    one[first] = 3.0;
    let star = mesh.star(0, first);
    let cells = star.len() as f64;
    assert!((plain.of(&one, None).unwrap().total - 3.0 / cells.sqrt()).abs() < 1e-14);
    let areas: f64 = star.map(|s| mesh.jacobian(s.cell).unwrap().volume()).sum();
    let euclidean = Smooth::new(&mesh, Metric::Flat).unwrap();
    let values = metric_values(&euclidean);
    let curved = (kind.new)(&setting.with_metric(&values)).unwrap();
    let expected = 3.0 / areas.sqrt();
    assert!((curved.of(&one, None).unwrap().total / expected - 1.0).abs() < 1e-12);
    assert!(curved.of(&load[1..], None).is_err());
}
