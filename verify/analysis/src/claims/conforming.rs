//! Section 4: b_h against functions of H²_0, and the steps of the proofs that lead there.

use super::rates::rules;
use crate::best::{Form, HELD, best_constant};
use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{Dome, gridded, near, smooth};
use crate::finding::{Finding, Rule};
use crate::norms::{Basis, Faces, two_norm};
use crate::pieces::{Pieces, euclidean_frame};
use crate::series::Series;
use crate::splines::Clamped;
use nalgebra::{DMatrix, DVector};
use regge_curvature::Error;
use regge_curvature::density::{Normal, outward};
use regge_curvature::field::{Combination, Evaluate};
use regge_curvature::formulas::PAPER;
use regge_curvature::functional::b_h;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, Vector, inverse_and_det};
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::riemann::Connection;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::{Lagrange, ReggeFunction, ReggeSpace};
use std::borrow::Cow;

/// Splines of H²_0 on the mesh of their grid.
struct OnMesh<'a, const N: usize> {
    splines: &'a Clamped<N>,
    mesh: &'a Mesh<N>,
}

impl<const N: usize> OnMesh<'_, N> {
    fn place(&self, cell: usize, lambda: &[f64]) -> Vector<f64, N> {
        let corner = |i: usize| self.mesh.corner(cell, i).expect("there are coordinates");
        (0..=N).map(|i| corner(i) * lambda[i]).sum()
    }

    fn box_of(&self, cell: usize) -> [usize; N] {
        let centre = self.place(cell, &vec![1.0 / (N + 1) as f64; N + 1]);
        self.splines.box_of(&centre)
    }
}

impl<const N: usize> Basis<N> for OnMesh<'_, N> {
    type Table = Points;

    fn size(&self) -> usize {
        self.splines.len()
    }

    fn on(&self, cell: usize) -> Vec<usize> {
        let all = self.splines.on_box(self.box_of(cell)).into_iter();
        all.map(|number| number.unwrap_or(HELD)).collect()
    }

    fn table(&self, points: &Points) -> Points {
        points.clone()
    }

    fn jets<'t>(&self, cell: usize, table: &'t Points, point: usize) -> Cow<'t, [Jet2<f64, N>]> {
        let x = self.place(cell, table.lambda(point));
        let jacobian = self.mesh.jacobian(cell).expect("there are coordinates");
        let pulled_back = |v: Jet2<f64, N>| {
            let d = jacobian.transpose() * Vector::<f64, N>::from(v.d);
            let dd = jacobian.transpose() * Mat::<f64, N>::from(v.dd) * jacobian;
            Jet2 {
                value: v.value,
                d: d.into(),
                dd: dd.into(),
            }
        };
        let all = self.splines.jets(self.box_of(cell), &x).into_iter();
        Cow::Owned(all.map(pulled_back).collect())
    }
}

/// eq. (normv).
pub const A34: Claim = Claim {
    label: "A34",
    paper: &["normv", "prop:bhbound"],
    title: "The mesh-dependent norm of functions of H²_0, and b_h against them",
    statement: r"\|v\|_{2,h,\tilde g} \le C\,P\,\|v\|_{H^2(\Omega)},\qquad |b_h(\tilde g;\sigma,v)| \le C\,P\,
        \Big(\|\sigma\|_{L^2}^2+\sum_Th_T^2|\sigma|_{H^1(T)}^2\Big)^{1/2}\|v\|_{H^2(\Omega)},\qquad
        P = 1+\max_Th_T^{-1}\|g_h-g\|_{L^\infty(T)}+\max_T|g_h-g|_{W^{1,\infty}(T)},\quad v\in H^2_0(\Omega)",
    how: "Over all products of clamped quadratic C¹ splines on a fixed grid of which the meshes are refinements: they are in H²_0. First the best constant, its root over P, at \
        t = 1/2 and 1, for noise of 10 % at every level, with which P grows. Second the supremum over v of |b_h(g̃(1/2); g_h − g, v)|/‖v‖_{H²}, exactly, over the other factors, for the canonical \
        interpolant of degree 1 of g + 4h E/5 with a smooth tensor E; the part of the right side with derivatives of σ is left out, which makes the quotient larger; for N = 3 the meshes are too coarse to judge it. Forged: without P, and another power of h. That the bound of b_h is A01, A02 and the first part together is not used.",
    measure: normv,
};

/// The best constants of eq. (normv) over P: at t = 1/2, at t = 1, and at t = 1 without P; the supremum of b_h over its bound. The
/// splines' grid has so many boxes a side, of which the mesh is a refinement.
fn constants<const N: usize>(
    boxes: usize,
    side: usize,
    seed: u64,
) -> Result<(f64, [f64; 4]), Error> {
    let (mesh, grids) = gridded::<N>(side, seed)?;
    let h = mesh.mesh_size();
    let coarse = grids.map(|grid| grid.into_iter().step_by(side / boxes).collect());
    let (pieces, splines) = (Pieces::new(mesh.clone())?, Clamped::new(coarse));
    let g = smooth(&mesh)?;
    let matrix = splines.norm(&[0, 1, 2]);
    let mut h2 = Form::zero(splines.len());
    h2.add(&(0..splines.len()).collect::<Vec<_>>(), &matrix);
    let on_mesh = OnMesh {
        splines: &splines,
        mesh: &mesh,
    };
    let rough = near(&g, 0, 0.1, seed)?;
    let at = |t: f64| {
        let segment = Combination::segment(&g, &rough, t);
        let form = two_norm(&pieces, &on_mesh, &segment, Faces::all(-1), 6)?;
        Ok::<_, Error>(best_constant(&form, &h2)?.sqrt())
    };
    let (middle, end, p) = (at(0.5)?, at(1.0)?, prefactor(&g, &rough));
    // A smooth tensor times h, and what interpolation adds to it.
    let dome = Smooth::new(&mesh, Dome)?;
    let shifted = Combination::new(1.0, &g, 0.8 * h, &dome);
    let g_h = Interpolant::canonical().apply(&ReggeSpace::new(&mesh, 1), &shifted)?;
    let sigma = Combination::new(-1.0, &g, 1.0, &g_h);
    let segment = Combination::segment(&g, &g_h, 0.5);
    let fine = Lagrange::new(&mesh, 2 * N);
    let load = b_h(&segment, &sigma, &fine, &rules(N, 2 * N - 2)).total();
    let f = DVector::from_vec(splines.loads(&fine, &load)?);
    // Without derivatives, which die down slowly for a smooth σ: the quotient is larger for it.
    let size = Distance::new(&mesh, &sigma, 4).weighted(0);
    let dual = f.dot(&solved(matrix, &f)?).sqrt() / (size * prefactor(&g, &g_h));
    Ok((h, [middle / p, end / p, end, dual]))
}

/// P.
fn prefactor<const N: usize>(g: &Smooth<Metric, N>, g_h: &ReggeFunction<f64, N>) -> f64 {
    let distance = Distance::new(g.mesh(), &Combination::new(-1.0, g, 1.0, g_h), 4);
    1.0 + distance.sup(0, -1) + distance.sup(1, 0)
}

fn solved(matrix: DMatrix<f64>, f: &DVector<f64>) -> Result<DVector<f64>, Error> {
    let factor = matrix.cholesky();
    let factor = factor.ok_or_else(|| Error::Solver("splines are dependent".into()))?;
    Ok(factor.solve(f))
}

fn normv(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    if effort.quick {
        return Ok(all);
    }
    let mut add = |n: usize, [middle, end, without, b]: [Series; 4]| {
        let finding = |what: &str, series: &Series| {
            Finding::new(format!("N = {n}, {what}"), Rule::Bounded, series.clone())
        };
        all.push(finding("‖v‖ at t = 1/2", &middle).about(&["normv"]));
        let end = finding("‖v‖ at t = 1", &end).about(&["normv"]);
        // In space the meshes that can be afforded are too coarse for P to be needed.
        all.push(if n == 2 {
            end.forge("no P", without)
        } else {
            end
        });
        // In space P falls and the quotient rises to its limit on these meshes: seen and not judged.
        if n == 3 {
            all.push(Finding::new("N = 3, b_h", Rule::Seen, b).about(&["prop:bhbound"]));
            return;
        }
        let b_h = finding("b_h", &b).about(&["prop:bhbound"]);
        all.push(b_h.forge("over one more power of h", b.over_h_power(1)));
    };
    let plane = effort.sweep(&[32, 64, 128], &|side, seed| constants::<2>(8, side, seed));
    add(2, plane?);
    let space = effort.sweep(&[4, 8, 12], &|side, seed| constants::<3>(4, side, seed));
    add(3, space?);
    Ok(all)
}

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
    let (pieces, splines) = (Pieces::new(mesh.clone())?, Clamped::new(grids));
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

/// The proof of cor:conv.
pub const A36: Claim = Claim {
    label: "A36",
    paper: &["cor:conv"],
    title: "Hölder's inequality in the proof of the corollary",
    statement: r"\Big(\sum_Th_T^{2j}|g_h-g|_{H^j(T)}^2\Big)^{1/2} \le |\Omega|^{1/2-1/p}\Big(\sum_Th_T^{jp}|g_h-g|_{W^{j,p}(T)}^p\Big)^{1/p},
        \qquad j=0,1,2,\ p\in[2,\infty]",
    how: "Left over right side for the canonical interpolant and its noisy neighbours on random meshes, p = 2, 3, 6 and ∞, j = 0, 1, 2: at most 1, and 1 is \
        reached for p = 2. Forged: without the power of |Ω|, on (−1, 1)^N.",
    measure: hoelder,
};

/// Left over right side for p = 2, 3, 6, ∞, and without |Ω|, by j.
fn hoelder_on<const N: usize>(side: usize, seed: u64, r: usize) -> Result<[Vec<f64>; 2], Error> {
    let (mesh, _) = gridded::<N>(side, seed)?;
    let (g, rule) = (smooth(&mesh)?, Quadrature::new(N, 6));
    let g_h = near(&g, r, 0.01, seed)?;
    let sigma = Combination::new(-1.0, &g, 1.0, &g_h);
    let volume = 2.0_f64.powi(N as i32);
    let mut all = [Vec::new(), Vec::new()];
    for j in 0..3 {
        let points = Distance::at_points(&mesh, &sigma, &rule, j);
        for p in [2.0, 3.0, 6.0, f64::INFINITY] {
            let mean = |p: f64| -> f64 {
                let sum: f64 = points.iter().map(|(weight, x)| weight * x.powf(p)).sum();
                sum.powf(1.0 / p)
            };
            let right = match p.is_finite() {
                true => mean(p),
                false => points.iter().fold(0.0, |max: f64, (_, x)| max.max(*x)),
            };
            let ratio = mean(2.0) / right;
            all[0].push(ratio / volume.powf(0.5 - 1.0 / p));
            all[1].push(ratio);
        }
    }
    Ok(all)
}

fn hoelder(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, r: usize, [stated, without]: [Vec<f64>; 2]| {
        let finding = Finding::new(
            format!("N = {n}, r = {r}"),
            Rule::Sharp(1.0, 0.999),
            Series::samples(stated),
        );
        all.push(finding.forge("no power of |Ω|", Series::samples(without)));
    };
    add(2, 0, hoelder_on::<2>(8, effort.seed, 0)?);
    add(2, 2, hoelder_on::<2>(8, effort.seed, 2)?);
    add(3, 1, hoelder_on::<3>(3, effort.seed, 1)?);
    Ok(all)
}
