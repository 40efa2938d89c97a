use regge_curvature::linalg::identity;
use regge_curvature::riemann::trace;
use regge_verify::harness::{Equation, Record, Timed};
use regge_verify::stage::point::{Instance, Pointwise};

pub struct Laplacian;

impl Pointwise for Laplacian {
    const RECORD: Record = Record {
        label: "X01",                // the row of the catalogue
        paper: &["sec:evolution"],   // labels of the paper's LaTeX, none if it is not printed there
        title: "The Laplacian",
        statement: r"\Delta v = \operatorname{Tr}\nabla\nabla v",
        sides: "Left: the divergence of dv. Right: the trace of the library's Hessian.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let still = i.still();
        let base = still.lower();
        let hessian = base.hessian(&i.v);
        vec![
            Equation::new("Δv")
                .left("Δv", still.laplacian(&i.v))
                .right("Tr∇∇v", base.trace(&hessian))
                .forge("Euclidean trace", "Tr∇∇v", trace(&identity(), &hessian)),
        ]
    }
}
