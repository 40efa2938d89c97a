//! A lattice relaxed to a solution of Regge's equations.
//!
//! The edge lengths of a flat cube of 6·3³ tetrahedra are disturbed inside; the boundary's are held. Damped Gauss–Newton
//! steps on the gradient of the action, which the library differentiates exactly, lead back to a flat metric, though
//! to another one: at a flat metric an inner vertex may move in space without any curvature. So the Jacobian of the
//! gradient, the Hessian of the action, has N kernel directions for each inner vertex. The cube is made to bulge first: a
//! vertex inside a flat part of the boundary could move outwards with no change of length to first order, and would add a
//! direction of its own.
//!
//! `cargo run --release -p regge-examples --bin relax`

use nalgebra::{DMatrix, DVector};
use regge_curvature::functional::{action_gradient, action_hessian, angle_defects, regge_action};
use regge_curvature::mesh::SplitMix64;
use regge_curvature::simplex::Points;
use regge_curvature::{Interpolant, Mesh, Metric, ReggeFunction, ReggeSpace, Rules, Smooth};

const N: usize = 3;

/// The action on a mesh as a function of the lengths of its inner edges.
struct Lattice {
    space: ReggeSpace<N>,
    inner: Vec<usize>,
    boundary: Vec<f64>,
}

impl Lattice {
    /// The metric with these inner lengths; None if some cell is none.
    fn metric(&self, lengths: &DVector<f64>) -> Option<ReggeFunction<f64, N>> {
        let mut squares = self.boundary.clone();
        for (&edge, length) in self.inner.iter().zip(lengths.iter()) {
            squares[edge] = length * length;
        }
        let g = self.space.function(squares).ok()?;
        let centre = Points::new(N + 1, vec![0.25; N + 1]);
        let positive = lengths.iter().all(|l| *l > 0.0);
        (positive && g.check_positive(&centre).is_ok()).then_some(g)
    }

    /// ∂(action)/∂ℓ of the inner edges.
    fn gradient(&self, lengths: &DVector<f64>) -> Option<DVector<f64>> {
        let all = action_gradient(&self.metric(lengths)?).ok()?;
        Some(DVector::from_iterator(
            self.inner.len(),
            self.inner.iter().map(|&e| all.gradient[e]),
        ))
    }

    /// The Jacobian of the gradient. Paper: the hinge term of a_h; here ∂Θ_S/∂ℓ from the library's second derivatives.
    fn jacobian(&self, lengths: &DVector<f64>) -> Option<DMatrix<f64>> {
        let hessian = action_hessian(&self.metric(lengths)?).ok()?;
        let size = self.inner.len();
        let mut number = vec![usize::MAX; self.boundary.len()];
        for (i, &edge) in self.inner.iter().enumerate() {
            number[edge] = i;
        }
        let mut matrix = DMatrix::zeros(size, size);
        for entry in hessian {
            let [i, j] = [number[entry.row], number[entry.column]];
            if i < size && j < size {
                matrix[(i, j)] += entry.value;
            }
        }
        Some(matrix)
    }
}

/// A cube with inner vertices moved at random and a boundary that is strictly convex.
fn bulging_cube(side: usize) -> Result<Mesh<N>, regge_curvature::Error> {
    let mesh = Mesh::<N>::cube(side)?.perturbed(0.1, 4)?;
    let points = mesh.points().expect("a cube has coordinates").iter();
    let bulged = points.map(|x| x * (1.0 - 0.1 * x.norm_squared())).collect();
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|cell| mesh.vertices(N, cell).iter().map(|&v| v as usize).collect())
        .collect();
    Mesh::new(bulged, &cells)
}

fn main() -> Result<(), regge_curvature::Error> {
    let mesh = bulging_cube(3)?;
    let space = ReggeSpace::new(&mesh, 0);
    let flat = Interpolant::canonical().apply(&space, &Smooth::new(&mesh, Metric::Flat)?)?;
    let lattice = Lattice {
        space,
        inner: mesh.interior(1).collect(),
        boundary: flat.coefficients().to_vec(),
    };
    let mut random = SplitMix64::new(2);
    let lengths = lattice.inner.iter().map(|&e| flat.coefficients()[e].sqrt());
    let disturbed = lengths.map(|l| l * (1.0 + 0.02 * random.symmetric()));
    let mut lengths = DVector::from_iterator(lattice.inner.len(), disturbed);
    println!(
        "{} inner edges, {} inner vertices",
        lattice.inner.len(),
        mesh.interior(0).count()
    );
    println!("step   |gradient|   largest defect       action");
    let stuck = || regge_curvature::Error::Solver("no step makes the gradient smaller".into());
    let mut damping = 1e-3;
    for step in 0..60 {
        let (Some(g), Some(r)) = (lattice.metric(&lengths), lattice.gradient(&lengths)) else {
            return Err(stuck());
        };
        let defects = angle_defects(&g, &mesh, 1);
        let defect = defects.iter().fold(0.0, |m: f64, d| m.max(d.defect.abs()));
        let action = regge_action(&g, &mesh, &Rules::on(&mesh, 1));
        println!(
            "{step:4}   {:10.2e}   {defect:14.2e}   {:.10}",
            r.norm(),
            action.total()
        );
        if r.norm() < 1e-12 {
            break;
        }
        let jacobian = lattice.jacobian(&lengths).ok_or_else(stuck)?;
        lengths = better(&lattice, &lengths, &r, &jacobian, &mut damping).ok_or_else(stuck)?;
    }
    let hessian = lattice.jacobian(&lengths).ok_or_else(stuck)?;
    let mut sizes: Vec<f64> = hessian
        .symmetric_eigen()
        .eigenvalues
        .iter()
        .map(|x| x.abs())
        .collect();
    sizes.sort_by(f64::total_cmp);
    let kernel = sizes.iter().filter(|x| **x < 1e-8).count();
    println!(
        "eigenvalues of the Hessian below 1e-8: {kernel}, the next is {:.1e}",
        sizes[kernel]
    );
    println!(
        "N times the inner vertices: {}",
        N * mesh.interior(0).count()
    );
    Ok(())
}

/// A step of Levenberg and Marquardt: (JᵀJ + μ) δ = −Jᵀr, μ raised until |r| becomes smaller.
fn better(
    lattice: &Lattice,
    lengths: &DVector<f64>,
    r: &DVector<f64>,
    jacobian: &DMatrix<f64>,
    damping: &mut f64,
) -> Option<DVector<f64>> {
    for _ in 0..30 {
        let mut normal = jacobian.transpose() * jacobian;
        for i in 0..normal.nrows() {
            normal[(i, i)] += *damping;
        }
        let step = normal.cholesky()?.solve(&(jacobian.transpose() * r));
        let next = lengths - step;
        if lattice
            .gradient(&next)
            .is_some_and(|new| new.norm() < r.norm())
        {
            *damping = (*damping * 0.1).max(1e-14);
            return Some(next);
        }
        *damping *= 10.0;
    }
    None
}
