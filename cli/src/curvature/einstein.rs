//! The distributional Einstein tensor against the Regge functions that vanish on the boundary.

use super::CurvatureError;
use super::given::{Given, Phase, Source, by_dimension};
use super::report::{About, Parts};
use super::settle::{Orders, settle_sums};
use regge_curvature::functional::{Rules, Sums, einstein_against};
use regge_readers::mesh::MeshFile;
use serde::Serialize;

/// What `regge einstein` writes.
#[derive(Clone, Debug, Serialize)]
pub struct EinsteinReport {
    /// Of what metric; r is also the degree of the functions that it is tested with.
    #[serde(flatten)]
    pub about: About,
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
    /// The sums.
    #[serde(flatten)]
    pub sums: Parts,
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
    by_dimension!(mesh, N => {
        report(&Given::<N>::new(mesh, source, degree, phase)?, quadrature, phase)
    })
}

fn report<const N: usize>(
    given: &Given<'_, N>,
    quadrature: Option<usize>,
    phase: Phase<'_>,
) -> Result<EinsteinReport, CurvatureError> {
    let (g_h, space) = (&given.g_h, given.g_h.space());
    // Where the metric is constant, everything is constant on the hinges: order 1 is more than enough.
    let orders = Orders::of(g_h, space.degree().max(1));
    let sums = settle_sums(g_h, quadrature, orders, &mut |order| {
        phase(&format!(
            "testing the Einstein tensor by rules of order {order}"
        ));
        Ok(einstein_against(g_h, space, &Rules::new(N, order)))
    })?;
    let functions = functions(given, &sums.value);
    let sizes = functions.iter().map(|f| f.sums.total.abs());
    Ok(EinsteinReport {
        about: About::of(given, &sums),
        largest: sizes.fold(0.0, f64::max),
        functions,
    })
}

/// The functions whose simplex is not in the boundary.
fn functions<const N: usize>(given: &Given<'_, N>, sums: &Sums<f64>) -> Vec<EinsteinSums> {
    let (space, mesh) = (given.g_h.space(), given.g_h.space().mesh());
    let numbering = space.numbering();
    let of = |(dof, sums): (usize, Parts)| {
        let (k, simplex) = numbering.owner(dof);
        mesh.is_interior(k, simplex).then(|| EinsteinSums {
            simplex: mesh.vertices(k, simplex).to_vec(),
            index: dof - numbering.global(k, simplex, 0),
            sums,
        })
    };
    let all = Parts::of(sums, None).into_iter().enumerate();
    all.filter_map(of).collect()
}
