//! Section 4: b_h against functions of H²_0.

use crate::best::{Form, HELD, best_constant};
use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{gridded, near, smooth};
use crate::finding::Finding;
use crate::norms::{Faces, of_tensors, two_norm};
use crate::on_mesh::OnMesh;
use crate::pieces::{Pieces, Unknowns};
use crate::rule::Rule;
use crate::series::Series;
use crate::splines::{Clamped, Lattice};
use regge_curvature::Error;
use regge_curvature::field::Combination;
use regge_curvature::functional::{Rules, b_h};
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::spaces::{Lagrange, ReggeFunction};

/// eq. (normv).
pub const A34: Claim = Claim {
    label: "A34",
    paper: &["normv", "prop:bhbound"],
    title: "The mesh-dependent norm of functions of H²_0, and b_h against them",
    statement: r"\|v\|_{2,h,\tilde g} \le C\,P\,\|v\|_{H^2(\Omega)},\qquad |b_h(\tilde g;\sigma,v)| \le C\,P\,
        \Big(\|\sigma\|_{L^2}^2+\sum_Th_T^2|\sigma|_{H^1(T)}^2\Big)^{1/2}\|v\|_{H^2(\Omega)},\qquad
        P = 1+\max_Th_T^{-1}\|g_h-g\|_{L^\infty(T)}+\max_T|g_h-g|_{W^{1,\infty}(T)},\quad v\in H^2_0(\Omega)",
    how: "Over all products of clamped quadratic C¹ splines on a fixed grid of which the meshes are refinements: they are in H²_0. The metric is on the segment to one with \
        noise of 10 % at every level, with which P grows. First the best constant, its root over P, at t = 1/2 and 1. Second the best constant of the bound of b_h at t = 1, over all \
        Regge functions σ of degree r and all splines, over P: b_h by the library, cell by cell; also for noise of h/10, with which P is bounded and the constant tends to a limit; N = 2, r = 0 and 1, and N = 3, r = 0, where with noise of h/10 the meshes are too coarse to see the limit. Forged: without P, and another power of h. That the bound of b_h is A01, A02 \
        and the first part together is not used.",
    measure: conforming,
};

/// The best constants of eq. (normv) over P: at t = 1/2, at t = 1, and at t = 1 without P. The splines' grid has so many boxes a side, of
/// which the mesh is a refinement.
fn constants<const N: usize>(
    boxes: usize,
    side: usize,
    seed: u64,
) -> Result<(f64, [f64; 3]), Error> {
    let (mesh, splines) = refined::<N>(boxes, side, seed)?;
    let (h, g) = (mesh.mesh_size(), smooth(&mesh)?);
    let (pieces, h2) = (Pieces::new(mesh.clone())?, splines.norm(&[0, 1, 2]));
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
    Ok((h, [middle / p, end / p, end]))
}

/// A mesh, and splines on a grid of which it is a refinement.
fn refined<const N: usize>(
    boxes: usize,
    side: usize,
    seed: u64,
) -> Result<(Mesh<N>, Clamped<N>), Error> {
    let (mesh, grids) = gridded::<N>(side, seed)?;
    let coarse = grids.map(|grid| grid.into_iter().step_by(side / boxes).collect());
    Ok((mesh, Clamped::new(coarse, 2)))
}

/// The best constant of prop:bhbound at t = 1, for noise of this size and σ of degree r: over P, and without P.
fn b_constants<const N: usize>(
    boxes: usize,
    side: usize,
    seed: u64,
    r: usize,
    noise: fn(f64) -> f64,
) -> Result<(f64, [f64; 2]), Error> {
    let (mesh, splines) = refined::<N>(boxes, side, seed)?;
    let (h, g) = (mesh.mesh_size(), smooth(&mesh)?);
    let pieces = Pieces::new(mesh.clone())?;
    let rough = near(&g, 0, noise(h), seed)?;
    let fine = Lagrange::new(&mesh, splines.total_degree());
    let lattice = Lattice::new(&fine);
    // The metric is constant on cells: on them and on faces b_h integrates a polynomial, of at most this degree.
    let rules = Rules::new(N, fine.degree() + r);
    let matrices = pieces.matrices([r, fine.degree()], &|sigma, space| {
        b_h(&rough, sigma, space, &rules).total()
    })?;
    let u = Unknowns::new(&mesh, [r, 1]).tensors_only();
    let (start, size) = (u.len(), u.len() + splines.len());
    let (mut b, mut norms) = (Form::zero(size), Form::zero(size));
    for (cell, matrix) in matrices.iter().enumerate() {
        let here = splines.on_cell(&mesh, cell)?;
        let shifted: Vec<usize> = (here.iter())
            .map(|number| number.map_or(HELD, |number| start + number))
            .collect();
        let matrix = matrix * splines.coefficients(&lattice, &mesh, cell)?;
        b.add_between(&u.of_tensors(cell), &shifted, &matrix);
    }
    norms.add_form(1.0, &of_tensors(&pieces, &u, &[(0, 0), (1, 2)])?);
    norms.add_shifted(start, &splines.norm(&[0, 1, 2]));
    let best = best_constant(&b, &norms)?;
    Ok((h, [best / prefactor(&g, &rough), best]))
}

/// P.
fn prefactor<const N: usize>(g: &Smooth<Metric, N>, g_h: &ReggeFunction<f64, N>) -> f64 {
    let distance = Distance::new(g.mesh(), &Combination::new(-1.0, g, 1.0, g_h), 4);
    1.0 + distance.sup(0, -1) + distance.sup(1, 0)
}

fn conforming(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    if effort.quick {
        return Ok(all);
    }
    let mut add = |n: usize, [middle, end, without]: [Series; 3]| {
        let finding = |what: &str, series: Series| {
            let case = format!("N = {n}, ‖v‖ at {what}");
            Finding::new(case, Rule::Bounded, series).about(&["normv"])
        };
        all.push(finding("t = 1/2", middle));
        let end = finding("t = 1", end);
        // In space the meshes that can be afforded are too coarse for P to be needed.
        all.push(if n == 2 {
            end.forge("no P", without)
        } else {
            end
        });
    };
    let plane = effort.sweep(&[32, 64, 128], &|side, seed| constants::<2>(8, side, seed));
    add(2, plane?);
    let space = effort.sweep(&[4, 8, 12], &|side, seed| constants::<3>(4, side, seed));
    add(3, space?);
    all.extend(b_bound(effort)?);
    Ok(all)
}

/// prop:bhbound: with noise of 10 %, which needs P, and with noise of the order of h, where P is bounded and the constant has a limit.
fn b_bound(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |case: String, rule: Rule, [best, without]: [Series; 2]| {
        let (over, named) = (best.over_h_power(1), format!("{case}, b_h"));
        let mut finding = Finding::new(named, rule, best);
        if rule == Rule::Bounded {
            finding = finding.forge("over one more power of h", over);
        }
        all.push(finding.about(&["prop:bhbound"]));
        let seen = Finding::new(format!("{case}, b_h without P"), Rule::Seen, without);
        all.push(seen.about(&["prop:bhbound"]));
    };
    // On the meshes that can be afforded in space, one to three cells to a spline's box, the constant is still on its way to the
    // limit, which P hides only where it grows.
    let noises: [(&str, Rule, fn(f64) -> f64); 2] = [
        ("noise of 10 %", Rule::Bounded, |_| 0.1),
        ("noise of h/10", Rule::Seen, |h| 0.1 * h),
    ];
    for (name, in_space, noise) in noises {
        for r in 0..2 {
            let plane = effort.sweep(&[16, 32, 64], &|side, seed| {
                b_constants::<2>(8, side, seed, r, noise)
            })?;
            add(format!("N = 2, r = {r}, {name}"), Rule::Bounded, plane);
        }
        // In space the tensors of degree 1 on the third mesh are more than a minute can be spent on.
        let space = effort.sweep(&[4, 8, 12], &|side, seed| {
            b_constants::<3>(4, side, seed, 0, noise)
        })?;
        add(format!("N = 3, r = 0, {name}"), in_space, space);
    }
    Ok(all)
}
