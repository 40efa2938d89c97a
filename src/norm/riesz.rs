//! Norms that are dual to an energy of continuous functions: H⁻¹(Ω, g), and V′_h of the paper's introduction.
//!
//! u of degree p, zero on ∂Ω, with E(u, v) = f(v) for all such v; ‖f‖ = E(u, u)^{1/2} is the supremum of |f(v)| over all
//! v of degree p with E(v, v) ≤ 1, and a lower bound of the supremum over all v.

use super::census::Census;
use super::dual::{DualNorm, NormValue, Part, Representative, Step, check_load};
use super::kind::{Kind, Setting};
use crate::Error;
use crate::density::Volume;
use crate::jet::Jet2;
use crate::linalg::{Mat, Vector, inverse_and_det};
use crate::mesh::Mesh;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::simplex::binomial;
use crate::spaces::Lagrange;
use crate::sparse::{Factor, Kept, Lower};
use nalgebra::DMatrix;

/// Of which functions' energy a norm is the dual.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Energy {
    /// ∫ |dv|²_g ω(g): H⁻¹(Ω, g), by Poisson's problem. Euclidean without a metric.
    Dirichlet,
    /// Σ_T ∫_T |∇v|² + h_T² |∇²v|², Euclidean whatever the metric. Its root is at most the paper's ‖v‖_{V,h} (a sum of two
    /// roots), and at least 1/√2 of it. Paper: eq. (Vdef).
    Broken,
}

/// The norm dual to an [`Energy`]: set up once, by a sparse Cholesky factorisation, for as many functionals as you like.
#[derive(Debug)]
pub struct Riesz<const N: usize> {
    energy: Energy,
    space: Lagrange<N>,
    kept: Kept,
    matrix: Lower,
    /// None where there is no unknown.
    factor: Option<Box<Factor>>,
}

impl<const N: usize> Riesz<N> {
    /// The entry `hm1` in the table of norms.
    pub(super) const HM1: Kind<N> = Kind {
        name: "hm1",
        symbol: "H^-1",
        about: "H^-1(Omega, g) by Poisson's problem",
        degree: |r| r + 2,
        memory: Self::memory,
        new: |setting| Ok(Box::new(Self::new(Energy::Dirichlet, setting)?)),
    };

    /// The entry `vh` in the table of norms.
    pub(super) const VH: Kind<N> = Kind {
        name: "vh",
        symbol: "V_h'",
        about: "the dual of (|v|^2_H1 + sum of h_T^2 |v|^2_H2(T))^(1/2)",
        degree: |r| r + 3,
        memory: Self::memory,
        new: |setting| Ok(Box::new(Self::new(Energy::Broken, setting)?)),
    };

    /// The norm dual to an energy.
    ///
    /// # Errors
    /// If the mesh has no boundary, or no coordinates where they are needed (without a metric, and by the broken energy), or
    /// memory does not suffice.
    pub fn new(energy: Energy, setting: &Setting<'_, N>) -> Result<Self, Error> {
        let mesh = setting.mesh;
        if mesh.is_closed() {
            let reason = "on a mesh without boundary constants have no energy";
            return Err(Error::Input(reason.into()));
        }
        let is_euclidean = energy == Energy::Broken || setting.metric.is_none();
        if is_euclidean && !mesh.has_coordinates() {
            return Err(Error::NoCoordinates("a dual norm without a metric"));
        }
        let space = Lagrange::new(mesh, setting.degree);
        let kept = Kept::new(
            space.len(),
            |dof| space.vanishes_on_boundary(dof),
            mesh.cell_count(),
            |cell| space.cell_dofs(cell),
        )?;
        let matrix = assemble(energy, setting, &space, &kept)?;
        let factor = match kept.is_empty() {
            true => None,
            false => Some(Box::new(Factor::new(&matrix)?)),
        };
        Ok(Self {
            energy,
            space,
            kept,
            matrix,
            factor,
        })
    }

    /// The bytes of the factor and the matrix, generously: n log n and n^(4/3) entries as in nested dissection.
    fn memory(census: &Census, degree: usize) -> f64 {
        let n = census.simplices.len() - 1;
        let own = |k: usize| census.simplices[k] * binomial(degree - 1, k);
        let unknowns = (0..=n).map(own).sum::<usize>() as f64;
        let factor = match n {
            2 => 15.0 * unknowns * unknowns.max(2.0).log2(),
            _ => 12.0 * unknowns.powf(4.0 / 3.0),
        };
        8.0 * factor + 200.0 * unknowns
    }
}

/// h_T².
fn square_of_diameter<const N: usize>(mesh: &Mesh<N>, cell: usize) -> f64 {
    let corner = |i| mesh.corner(cell, i);
    let pairs = (0..=N).flat_map(|i| (0..i).map(move |j| (i, j)));
    let squares = pairs.filter_map(|(i, j)| Some((corner(i)? - corner(j)?).norm_squared()));
    squares.fold(0.0, f64::max)
}

/// The matrix E(v_i, v_j) of the unknowns.
fn assemble<const N: usize>(
    energy: Energy,
    setting: &Setting<'_, N>,
    space: &Lagrange<N>,
    kept: &Kept,
) -> Result<Lower, Error> {
    let mesh = setting.mesh;
    let metric = setting.metric.filter(|_| energy == Energy::Dirichlet);
    // Exact where g is constant; a metric has the order of functions of degree p + 2 in addition.
    let order = 2 * space.degree() + if metric.is_some() { 2 } else { 0 };
    let rule = Rule::new(N, order);
    let jets = space.basis(N).tabulate_jets::<f64, N>(rule.points());
    let on_cell = |cell: usize| {
        let euclidean = || {
            let jacobian = mesh.jacobian(cell).expect("there are coordinates");
            vec![jacobian.transpose() * jacobian; rule.len()]
        };
        let g = metric.map_or_else(euclidean, |g| g(cell, rule.points()));
        let hessians = match energy {
            Energy::Dirichlet => 0.0,
            Energy::Broken => square_of_diameter(mesh, cell),
        };
        let mut sum = DMatrix::zeros(space.cell_len(), space.cell_len());
        for ((g, jets), weight) in g.iter().zip(&jets).zip(rule.weights()) {
            add_point(g, jets, *weight, hessians, &mut sum);
        }
        sum
    };
    let blocks = |cell: usize| kept.blocks(space.cell_dofs(cell));
    let mut matrix = kept.matrix(mesh.cell_count(), &blocks)?;
    in_order(mesh.cell_count(), on_cell, |cell, local| {
        matrix.add(&blocks(cell), &local)
    });
    Ok(matrix)
}

/// Adds weight (⟨dv_i, dv_j⟩ + c ⟨∂²v_i, ∂²v_j⟩) ω to the lower triangle, in the metric g.
fn add_point<const N: usize>(
    g: &Mat<f64, N>,
    jets: &[Jet2<f64, N>],
    weight: f64,
    c: f64,
    sum: &mut DMatrix<f64>,
) {
    let (inverse, det) = inverse_and_det(g);
    let weight = weight * Volume::from_det(det);
    for (j, v) in jets.iter().enumerate() {
        let gradient = inverse * Vector::<f64, N>::from(v.d) * weight;
        let hessian = inverse * Mat::<f64, N>::from(v.dd) * inverse * (c * weight);
        for (i, w) in jets.iter().enumerate().skip(j) {
            let first = gradient.dot(&Vector::from(w.d));
            let second = if c == 0.0 {
                0.0
            } else {
                hessian.dot(&Mat::from(w.dd))
            };
            sum[(i, j)] += first + second;
        }
    }
}

impl<const N: usize> DualNorm<N> for Riesz<N> {
    fn space(&self) -> &Lagrange<N> {
        &self.space
    }

    fn solver(&self) -> &'static str {
        "cholesky"
    }

    /// u, by its coefficients in the basis of the space.
    fn represent(&self, load: &[f64], _: &mut dyn FnMut(Step)) -> Result<Representative, Error> {
        check_load(&self.space, load)?;
        let mut unknowns = self.kept.gather(load);
        if let Some(factor) = &self.factor {
            factor.solve(&mut unknowns);
        }
        Ok(Representative {
            coefficients: self.kept.scatter(&unknowns),
        })
    }

    /// E(u, u)^{1/2}. The energy was integrated when the norm was set up; of the rule nothing but its dimension is looked at.
    fn measure(&self, u: &Representative, rule: Option<&Rule>) -> Result<NormValue, Error> {
        let fits = rule.is_none_or(|rule| rule.points().vertices() == N + 1);
        if !fits || u.coefficients.len() != self.space.len() {
            return Err(Error::Input(
                "a rule or a solution of another mesh or dimension".into(),
            ));
        }
        let value = self
            .matrix
            .energy(&self.kept.gather(&u.coefficients))
            .sqrt();
        let name = match self.energy {
            Energy::Dirichlet => "grad_l2",
            Energy::Broken => "broken_h2",
        };
        Ok(NormValue::of_parts(vec![Part { name, value }]))
    }
}
