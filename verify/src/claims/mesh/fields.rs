//! Random Regge fields, and the three sums of the functionals as vectors over test functions.

use super::setting::Draw;
use num_dual::Dual64;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::Sums;
use regge_curvature::linalg::Mat;
use regge_curvature::mesh::Mesh;
use regge_curvature::scalar::{Field, Lift, Real};
use regge_curvature::simplex::{multi_indices, subsets};
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// A Regge function with coefficients of type C.
pub type Regge<C, const N: usize> = ReggeFunction<C, N>;

/// The coefficients of the metric that makes each edge as long as it is in ℝ^N, or 1 on a mesh without coordinates,
/// each times 1 + `noise` · (a random number in −1…1). With noise ≥ 1 it is a variation rather than a metric.
pub fn near_flat<const N: usize>(
    space: &ReggeSpace<N>,
    random: &[f64],
    noise: f64,
) -> Regge<f64, N> {
    let mesh = space.mesh();
    let mut coefficients = vec![0.0; space.len()];
    for cell in 0..mesh.cell_count() {
        for (e, edge) in subsets(N + 1, 2).iter().enumerate() {
            let square = match (mesh.corner(cell, edge[0]), mesh.corner(cell, edge[1])) {
                (Some(a), Some(b)) => (a - b).norm_squared(),
                _ => 1.0,
            };
            for alpha in 0..multi_indices(N + 1, space.degree()).len() {
                let dof = space.cell_dof(cell, e, alpha);
                coefficients[dof] = square * (1.0 + noise * random[dof]);
            }
        }
    }
    function(space, coefficients)
}

/// A function of a space by its coefficients.
pub fn function<C: Copy, const N: usize>(
    space: &ReggeSpace<N>,
    coefficients: Vec<C>,
) -> Regge<C, N> {
    space
        .function(coefficients)
        .unwrap_or_else(|e| panic!("as many coefficients as the space has: {e}"))
}

/// A random metric. The noise is small: Alfeld's cells in N = 4 are thin, and the sums' integrands are nearer to
/// polynomials.
pub fn metric<const N: usize>(space: &ReggeSpace<N>, draw: &mut Draw) -> Regge<f64, N> {
    near_flat(
        space,
        &draw.numbers(space.len()),
        [0.03, 0.015, 0.005][N - 2],
    )
}

/// A random σ, as large as a metric.
pub fn variation<const N: usize>(space: &ReggeSpace<N>, draw: &mut Draw) -> Regge<f64, N> {
    near_flat(space, &draw.numbers(space.len()), 1.0)
}

/// δ, on a mesh with coordinates.
pub fn flat<const N: usize>(space: &ReggeSpace<N>) -> Regge<f64, N> {
    near_flat(space, &vec![0.0; space.len()], 0.0)
}

/// g + t σ to first order in t.
pub fn moving<const N: usize>(g: &Regge<f64, N>, sigma: &Regge<f64, N>) -> Regge<Dual64, N> {
    let pairs = g.coefficients().iter().zip(sigma.coefficients());
    function(g.space(), pairs.map(|(g, s)| Dual64::new(*g, *s)).collect())
}

/// The mesh without its connections: every cell has vertices of its own. A Regge function there is one without
/// tangential-tangential continuity here.
pub fn torn<const N: usize>(mesh: &Mesh<N>) -> Mesh<N> {
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|c| (c * (N + 1)..(c + 1) * (N + 1)).collect())
        .collect();
    let corners: Option<Vec<Vec<_>>> = (0..mesh.cell_count())
        .map(|c| (0..=N).map(|i| mesh.corner(c, i)).collect())
        .collect();
    let vertices = mesh.cell_count() * (N + 1);
    match corners {
        Some(corners) => Mesh::with_cell_charts(vertices, &cells, &corners),
        None => Mesh::new_abstract(vertices, &cells),
    }
    .unwrap_or_else(|e| panic!("single cells are a mesh: {e}"))
}

/// The three sums over cells, faces and hinges.
#[derive(Clone, Debug)]
pub struct Three {
    /// Σ_T.
    pub t: Vec<f64>,
    /// Σ_F.
    pub f: Vec<f64>,
    /// Σ_S.
    pub s: Vec<f64>,
}

/// The sums of numbers.
pub fn values(sums: Sums<f64>) -> Three {
    Three {
        t: sums.cells,
        f: sums.faces,
        s: sums.hinges,
    }
}

/// d/dt of sums that depend on t.
pub fn rates(sums: &Sums<Dual64>) -> Three {
    let rate = |v: &Vec<Dual64>| v.iter().map(|x| x.eps).collect();
    Three {
        t: rate(&sums.cells),
        f: rate(&sums.faces),
        s: rate(&sums.hinges),
    }
}

/// Which test functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tested {
    /// Those that vanish on the boundary of the mesh: V.
    Inner,
    /// Those that do not.
    Outer,
    /// v = 1 alone.
    One,
}

impl Tested {
    /// The entries of these test functions. Bernstein's polynomials add up to 1.
    pub fn of<const N: usize>(self, space: &Lagrange<N>, all: &[f64]) -> Vec<f64> {
        let of_boundary = |inner: bool| {
            let dofs = (0..space.len()).filter(|&d| space.vanishes_on_boundary(d) == inner);
            dofs.map(|d| all[d]).collect()
        };
        match self {
            Self::Inner => of_boundary(true),
            Self::Outer => of_boundary(false),
            Self::One => vec![all.iter().sum()],
        }
    }

    /// The same of three sums.
    pub fn of_sums<const N: usize>(self, space: &Lagrange<N>, sums: &Three) -> Three {
        Three {
            t: self.of(space, &sums.t),
            f: self.of(space, &sums.f),
            s: self.of(space, &sums.s),
        }
    }
}

/// c v.
pub fn times(c: f64, v: &[f64]) -> Vec<f64> {
    v.iter().map(|x| c * x).collect()
}

/// −v.
pub fn minus(v: &[f64]) -> Vec<f64> {
    times(-1.0, v)
}

/// Wrong on purpose: b_h without the faces of the boundary.
pub struct InteriorFaces;

impl Formulas for InteriorFaces {
    fn face_in_b(interior: bool) -> bool {
        interior
    }
}

/// Wrong on purpose: II for II‾.
pub struct PlainSecondForm;

impl Formulas for PlainSecondForm {
    fn trace_reversed<F: Field, const N: usize>(
        _g: &Mat<F, N>,
        second_form: &Mat<F, N>,
        _h: F,
    ) -> Mat<F, N> {
        *second_form
    }
}

/// Wrong on purpose: 𝕊σ = σ − ½ g Tr σ.
pub struct HalfTrace;

impl Formulas for HalfTrace {
    fn reverse_trace<F: Field, const N: usize>(
        g: &Mat<F, N>,
        inverse: &Mat<F, N>,
        sigma: &Mat<F, N>,
    ) -> Mat<F, N> {
        let s = regge_curvature::riemann::reverse_trace(g, inverse, sigma);
        s.zip_map(sigma, |s, x| (s + x) * F::half())
    }
}

/// A Regge function over f64 as one over another scalar.
pub fn lifted<T: Real, const N: usize>(g: &Regge<f64, N>) -> Regge<T, N>
where
    f64: Lift<T>,
{
    function(
        g.space(),
        g.coefficients().iter().map(|c| c.lift()).collect(),
    )
}
