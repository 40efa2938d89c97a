//! The distributional Einstein tensor against the Regge functions that vanish on the boundary.

use super::given::{Given, Phase, Source, Task, on_metric};
use super::report::QuadratureUsed;
use super::settle::{SUMS_SETTLE, Settled, relative_change, settle};
use super::{CurvatureError, failed};
use crate::input::mesh::MeshFile;
use regge::field::TensorField;
use regge::functional::{Rules, Sums, einstein_against};
use regge::scalar::Lanes;
use serde::Serialize;

/// What `regge einstein` writes.
#[derive(Clone, Debug, Serialize)]
pub struct EinsteinReport {
    /// The version of the program.
    pub version: &'static str,
    /// The mesh file.
    pub mesh: String,
    /// N.
    pub dimension: usize,
    /// r: of the metric, and of the functions that it is tested with.
    pub degree: usize,
    /// How the Regge metric was made.
    pub interpolant: String,
    /// The quadrature of the sums.
    pub quadrature: QuadratureUsed,
    /// The largest |⟨(Gω)_dist, ψ⟩|.
    pub largest: f64,
    /// The basis functions that vanish on the boundary.
    pub functions: Vec<EinsteinSums>,
}

/// ⟨(Gω)_dist, ψ⟩ for one Regge basis function.
#[derive(Clone, Debug, Serialize)]
pub struct EinsteinSums {
    /// The vertices of the simplex that carries ψ.
    pub simplex: Vec<u32>,
    /// Which of the functions on that simplex, from 0.
    pub index: usize,
    /// Σ_T.
    pub element: f64,
    /// Σ_F.
    pub face: f64,
    /// Σ_S.
    pub hinge: f64,
    /// Their sum.
    pub total: f64,
}

/// The distributional Einstein tensor of the Regge metric on the mesh.
///
/// # Errors
/// Whether the input is to blame or the computation, and what is wrong where.
pub fn einstein(
    mesh: &MeshFile,
    source: &Source,
    degree: usize,
    quadrature: Option<usize>,
    phase: Phase<'_>,
) -> Result<EinsteinReport, CurvatureError> {
    if mesh.dimension < 3 {
        return Err(CurvatureError::Input(format!(
            "{}: the Einstein tensor vanishes in dimension 2: N = 3 or more is needed",
            mesh.file.display()
        )));
    }
    on_metric(mesh, source, degree, phase, &Einstein { quadrature, phase })
}

struct Einstein<'a> {
    quadrature: Option<usize>,
    phase: Phase<'a>,
}

impl Task for Einstein<'_> {
    type Output = EinsteinReport;

    fn run<const N: usize>(&self, given: &Given<'_, N>) -> Result<EinsteinReport, CurvatureError> {
        (self.phase)("testing the Einstein tensor");
        let settled = self.sums(given)?;
        let space = given.g_h.space();
        let functions = functions(given, &settled.value);
        let sizes = functions.iter().map(|f| f.total.abs());
        Ok(EinsteinReport {
            version: env!("CARGO_PKG_VERSION"),
            mesh: given.file.file.display().to_string(),
            dimension: N,
            degree: space.degree(),
            interpolant: given.interpolant.into(),
            quadrature: QuadratureUsed::of(&settled, SUMS_SETTLE),
            largest: sizes.fold(0.0, f64::max),
            functions,
        })
    }
}

impl Einstein<'_> {
    fn sums<const N: usize>(
        &self,
        given: &Given<'_, N>,
    ) -> Result<Settled<Sums<f64>>, CurvatureError> {
        let (g_h, space) = (given.g_h, given.g_h.space());
        let compute = |order| {
            let rules = Rules::new::<N>(order);
            Ok(einstein_against::<Lanes, N, _>(g_h, space, &rules))
        };
        let settled = match (self.quadrature, TensorField::<f64, N>::is_constant(g_h)) {
            (Some(order), _) => compute(order).map(|sums| Settled::given(sums, order)),
            // Everything is constant on the hinges.
            (None, true) => compute(1).map(|sums| Settled::exact(sums, 1)),
            (None, false) => {
                let first = Rules::default_order(space.degree());
                settle(first, SUMS_SETTLE, compute, |a, b| {
                    relative_change(entries(a), entries(b))
                })
            }
        };
        let settled = settled.map_err(failed)?;
        let finite = entries(&settled.value).all(|x| x.is_finite());
        match finite {
            true => Ok(settled),
            false => Err(CurvatureError::Failed(
                "a sum is not finite: the metric may be all but degenerate".into(),
            )),
        }
    }
}

fn entries(sums: &Sums<f64>) -> impl Iterator<Item = &f64> {
    sums.element.iter().chain(&sums.face).chain(&sums.hinge)
}

/// The functions whose simplex is not in the boundary.
fn functions<const N: usize>(given: &Given<'_, N>, sums: &Sums<f64>) -> Vec<EinsteinSums> {
    let (space, mesh) = (given.g_h.space(), given.g_h.space().mesh());
    let numbering = space.numbering();
    let total = sums.total();
    let of = |dof: usize| {
        let (k, simplex) = numbering.owner(dof);
        mesh.is_interior(k, simplex).then(|| EinsteinSums {
            simplex: mesh.vertices(k, simplex).to_vec(),
            index: dof - numbering.global(k, simplex, 0),
            element: sums.element[dof],
            face: sums.face[dof],
            hinge: sums.hinge[dof],
            total: total[dof],
        })
    };
    (0..space.len()).filter_map(of).collect()
}
