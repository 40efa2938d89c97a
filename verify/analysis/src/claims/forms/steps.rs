//! Section 4: the steps of the proofs that lead to the bound of b_h.

use crate::claim::{Claim, Effort};
use crate::families::{gridded, near, smooth};
use crate::finding::Finding;
use crate::norms::{Faces, two_norm};
use crate::on_mesh::OnMesh;
use crate::pieces::{Pieces, euclidean_frame};
use crate::rule::Rule;
use crate::series::Series;
use crate::splines::Clamped;
use regge_curvature::Error;
use regge_curvature::density::{Normal, outward};
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, inverse_and_det};
use regge_curvature::mesh::SplitMix64;
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::riemann::Connection;

/// Steps of the proofs of prop:equiv and prop:bhbound.
pub const A35: Claim = Claim {
    label: "A35",
    paper: &["prop:equiv", "ndiffLinf"],
    title: "Steps of the proofs: slopes and Christoffel symbols of two metrics, and slopes that do not jump",
    statement: r"\|dv(n_{\tilde g}-n_g)\|_{L^2(F)} \le C\|dv\|_{L^2(F)}\|g_h-g\|_{L^\infty(F)},\quad
        \|\Gamma-\tilde\Gamma\|_{L^\infty(T)} \le C\|g_h-g\|_{W^{1,\infty}(T)},\qquad v\in H^2_0,\ g\ \text{smooth}:\ [\![dv(n_g)]\!]=0",
    how: "At t = 1, by level, for noise of a h: the greatest |n_{g̃} − n_g|/|g_h − g| at the barycentres of faces (dv is contracted with it), \
        and the greatest |Γ − Γ̃| over |g_h − g| + |∂(g_h − g)| at the barycentres of cells, Euclidean lengths. Forged: another power of h, and without the derivatives. \
        Last: the faces' part of ‖v‖²_{2,h,g} for a random clamped spline v, relative to the cells' part: none in g, which is smooth; the \
        forgery is the same in g_h.",
    measure: steps,
};

/// The greatest of both quotients, and of the second without derivatives.
fn quotients<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 3]), Error> {
    let (mesh, _) = gridded::<N>(side, seed)?;
    let (h, g) = (mesh.mesh_size(), smooth(&mesh)?);
    let g_h = near(&g, 0, 0.05 * h, seed)?;
    let mut greatest = [0.0_f64; 3];
    for place in 0..=N {
        let corners: Vec<usize> = (0..=N).filter(|i| *i != place).collect();
        let on_face = Quadrature::new(N - 1, 1).points().embed(&corners, N + 1);
        let tables = (
            Evaluate::<f64, N>::tabulate(&g, &on_face),
            Evaluate::<f64, N>::tabulate(&g_h, &on_face),
        );
        for cell in 0..mesh.cell_count() {
            let locals = (
                Evaluate::<f64, N>::on_cell(&g, cell),
                Evaluate::<f64, N>::on_cell(&g_h, cell),
            );
            let frame = euclidean_frame(&mesh, cell);
            let inverse = frame.try_inverse().expect("cells are not flat");
            let values: [Mat<f64, N>; 2] = [
                g.value(&locals.0, &tables.0, 0),
                g_h.value(&locals.1, &tables.1, 0),
            ];
            let normals = values.map(|g| {
                let (raised, det) = inverse_and_det(&g);
                inverse * Normal::new(&PAPER, &raised, det, &outward(place)).n
            });
            let apart = (frame.transpose() * (values[1] - values[0]) * frame).norm();
            greatest[0] = greatest[0].max((normals[1] - normals[0]).norm() / apart);
            let jets = [
                Evaluate::<f64, N>::jet1(&g, &locals.0, &tables.0, 0),
                Evaluate::<f64, N>::jet1(&g_h, &locals.1, &tables.1, 0),
            ];
            let gammas = jets.map(|jets| christoffel(&Connection::new(&jets), &frame));
            let difference = gammas[1]
                .iter()
                .zip(&gammas[0])
                .map(|(a, b)| (a - b).powi(2));
            let difference = difference.sum::<f64>().sqrt();
            let slopes = (0..N).map(|c| {
                let along = |m: usize| frame[(m, c)];
                let d = |k: usize| {
                    Mat::<f64, N>::from_fn(|i, j| {
                        (0..N).map(|m| along(m) * jets[k][(i, j)].d[m]).sum()
                    })
                };
                (frame.transpose() * (d(1) - d(0)) * frame).norm_squared()
            });
            let slopes = slopes.sum::<f64>().sqrt();
            greatest[1] = greatest[1].max(difference / (apart + slopes));
            greatest[2] = greatest[2].max(slopes / apart);
        }
    }
    Ok((h, greatest))
}

/// Γ_ij^k in the coordinates of ℝ^N.
fn christoffel<const N: usize>(connection: &Connection<f64, N>, frame: &Mat<f64, N>) -> Vec<f64> {
    // The Hessian of a coordinate x^k, whose differential is constant, is −Γ^k.
    let inverse = frame.try_inverse().expect("cells are not flat");
    let mut all = Vec::new();
    for k in 0..N {
        let x = Jet2 {
            value: 0.0,
            d: std::array::from_fn(|m| inverse[(k, m)]),
            dd: [[0.0; N]; N],
        };
        let hessian = frame.transpose() * connection.hessian(&x) * frame;
        all.extend(hessian.iter().map(|x| -x));
    }
    all
}

/// The faces' part of ‖v‖² over the cells' part for a random spline: in g and in g_h.
fn jumps<const N: usize>(side: usize, seed: u64) -> Result<[f64; 2], Error> {
    let (mesh, grids) = gridded::<N>(side, seed)?;
    let (pieces, splines) = (Pieces::new(mesh.clone())?, Clamped::new(grids, 2));
    let g = smooth(&mesh)?;
    let g_h = near(&g, 0, 0.05, seed)?;
    let on_mesh = OnMesh {
        splines: &splines,
        mesh: &mesh,
    };
    let mut random = SplitMix64::new(seed);
    let v: Vec<f64> = (0..splines.len()).map(|_| random.symmetric()).collect();
    let none = Faces {
        interior: false,
        boundary: false,
        power: 0,
    };
    let energy = |faces, of_h: bool| {
        Ok::<_, Error>(match of_h {
            true => two_norm(&pieces, &on_mesh, &g_h, faces, 6)?.energy(&v),
            false => two_norm(&pieces, &on_mesh, &g, faces, 6)?.energy(&v),
        })
    };
    let part = |of_h| {
        let cells = energy(none, of_h)?;
        Ok::<_, Error>((energy(Faces::all(-1), of_h)? - cells).abs() / cells)
    };
    Ok([part(false)?, part(true)?])
}

fn steps(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, [normals, gammas, slopes]: [Series; 3], values: Vec<[f64; 2]>| {
        let case = |what: &str| format!("N = {n}, {what}");
        let wrong = normals.over_h_power(1);
        let finding = Finding::new(case("normals"), Rule::Bounded, normals).about(&["ndiffLinf"]);
        all.push(finding.forge("over one more power of h", wrong));
        let wrong = gammas.over_h_power(1);
        let finding = Finding::new(case("Γ"), Rule::Bounded, gammas).about(&["prop:equiv"]);
        all.push(finding.forge("over one more power of h", wrong));
        all.push(Finding::new(
            case("|∂(g_h − g)| over |g_h − g|, which is not bounded"),
            Rule::Seen,
            slopes,
        ));
        let series = |i: usize| Series::samples(values.iter().map(|v| v[i]).collect());
        // Squares of rounding errors, and of differences of sums.
        let finding = Finding::new(case("jumps of slopes"), Rule::AtMost(1e-12), series(0));
        all.push(finding.forge("in g_h", series(1)));
    };
    let seeds = effort.seeds();
    let of = |jumps: fn(usize, u64) -> Result<[f64; 2], Error>, side: usize| {
        seeds
            .iter()
            .map(|seed| jumps(side, *seed))
            .collect::<Result<Vec<_>, _>>()
    };
    let sides = effort.levels(&[8, 16, 32], 3);
    add(2, effort.sweep(sides, &quotients::<2>)?, of(jumps::<2>, 8)?);
    if !effort.quick {
        add(
            3,
            effort.sweep(&[4, 6, 8], &quotients::<3>)?,
            of(jumps::<3>, 5)?,
        );
    }
    Ok(all)
}
