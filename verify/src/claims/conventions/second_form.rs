//! D03, D04, D07, D08: the second fundamental form.

use crate::harness::{Equation, Record, Timed, each, table};
use crate::stage::point::{Face, Instance, Over, Pointwise, along, sum};
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Mat, Vector, apply, form};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::{Algebraic, Field};

/// II.
pub struct D03;

impl Pointwise for D03 {
    const RECORD: Record = Record {
        label: "D03",
        paper: &["sec:evolution_mean"],
        title: "The second fundamental form",
        statement: r"\mathrm{II}(X,Y) = g(\nabla_X n,Y) = -g(n,\nabla_X Y) = \frac{\nabla\nabla\varphi(X,Y)}{|d\varphi|},\quad
            H = \operatorname{Tr}\mathrm{II};\qquad
            \mathrm{II}_{ij} = -\frac{\Gamma^k_{ij}\nu_k}{|\nu|} \text{ for a plane}",
        sides: "Left: the library's II, made of ∇ν. Right: derivatives of the field n, of frame fields, the Hessian of \
            φ, and Christoffel symbols.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let (base, second_form) = (&scene.base, scene.face.second_form);
        let (n, tau, tau1) = (frame.n0(), frame.tau0(), frame.tau1());
        let on_frame = |a: &Mat<S::Base, N>| table(N - 1, |x, y| form(a, &tau[x], &tau[y]));
        let nabla_n = base.nabla_vector(&frame.n1());
        let turns = each(&tau, |t| along(&nabla_n, t));
        let turn = table(N - 1, |x, y| form(&base.g, &turns[x], &tau[y]));
        let bends = each(&tau1, |t| base.nabla_vector(t));
        let bend = table(N - 1, |x, y| -form(&base.g, &n, &along(&bends[y], &tau[x])));
        let scale = S::Base::one() / scene.face.normal.length;
        let hessian = base.hessian(&i.phi).map(|x| x * scale);
        let transposed = table(N - 1, |x, y| form(&second_form, &tau[y], &tau[x]));
        vec![
            Equation::new("∇n")
                .left("II(τ,τ′)", on_frame(&second_form))
                .right("g(∇_τ n,τ′)", turn),
            Equation::new("∇τ")
                .left("II(τ,τ′)", on_frame(&second_form))
                .right("−g(n,∇_τ τ′)", bend),
            Equation::new("∇∇φ")
                .left("II(τ,τ′)", on_frame(&second_form))
                .right("∇∇φ(τ,τ′)/|dφ|", on_frame(&hessian)),
            Equation::new("symmetry")
                .left("II(τ,τ′)", on_frame(&second_form))
                .right("II(τ′,τ)", transposed),
            Equation::new("trace")
                .left("H", scene.face.h)
                .right("ΣII(τ,τ)", sum(&tau, |t| form(&second_form, t, t))),
            plane::<S, N>(i),
        ]
    }
}

/// II of a plane, from Christoffel symbols.
fn plane<S: Timed, const N: usize>(i: &Instance<S, N>) -> Equation<S::Base> {
    let base = i.still0();
    let face = Face::new(&i.formulas, &base, &i.flat_nu());
    let nu = i.nu().map(|x| x.value);
    let christoffel = Mat::<S::Base, N>::from_fn(|a, b| {
        let mut sum = S::Base::zero();
        for k in 0..N {
            sum -= base.gamma[k][(a, b)] * nu[k];
        }
        sum / face.normal.length
    });
    Equation::new("plane")
        .left("II", face.second_form)
        .right("−Γν/|ν|", christoffel)
}

/// Spheres.
pub struct D04;

impl Pointwise for D04 {
    const RECORD: Record = Record {
        label: "D04",
        paper: &["sec:evolution_mean"],
        title: "The mean curvature of a sphere",
        statement: r"H = \frac{N-1}{\rho} \text{ on the sphere of radius } \rho \text{ with outward } n",
        sides: "Left: the library's H of {g(x,x) = ρ²} in a constant metric g, an ellipsoid in coordinates. Right: the \
            textbook's value.",
    };
    const OVER: Over = Over::Oracle;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let g = i.still0().g;
        let connection = Connection::new(&g.map(Jet1::<S::Base, N>::constant));
        let x = i.fields[0].map(|x| x.value.value());
        // ν = d(½ g(x,x)), with ∂_m ν_j = g_mj.
        let lowered = apply(&g, &x);
        let nu = Vector::from_fn(|j, _| Jet1 {
            value: lowered[j],
            d: std::array::from_fn(|m| g[(m, j)]),
        });
        let rho = form(&g, &x, &x).sqrt();
        let over = |k: usize| S::Base::from_int(k as i64) / rho;
        let face = Face::new(&i.formulas, &connection, &nu);
        let inward = Face::new(&i.formulas, &connection, &nu.map(|x| -x));
        vec![
            Equation::new("H")
                .left("H", face.h)
                .right("(N−1)/ρ", over(N - 1))
                .forge("N for N−1", "(N−1)/ρ", over(N))
                .forge("inward n", "H", inward.h),
        ]
    }
}

/// II‾.
pub struct D07;

impl Pointwise for D07 {
    const RECORD: Record = Record {
        label: "D07",
        paper: &["prop:Homegadot"],
        title: "The trace of II‾",
        statement: r"\overline{\mathrm{II}} = \mathrm{II} - Hg,\qquad
            \operatorname{Tr}\overline{\mathrm{II}} = -(N-2)H",
        sides: "Left: the library's II‾ on a frame. Right: H.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let scene = i.scene();
        let tau = i.frame().tau0();
        let reversed = scene.face.trace_reversed;
        let h = scene.face.h;
        let times = |k: usize| S::Base::from_int(-(k as i64)) * h;
        vec![
            Equation::new("Tr II‾")
                .left("Tr II‾", sum(&tau, |t| form(&reversed, t, t)))
                .vanishes(N == 2, "II‾ = 0 when N = 2")
                .right("−(N−2)H", times(N - 2))
                .vanishes(N == 2, "N − 2 = 0")
                .magnitude(h)
                .forge("II for II‾", "Tr II‾", h)
                .forge("N−1 for N−2", "−(N−2)H", times(N - 1)),
        ]
    }
}

/// ⟦II⟧.
pub struct D08;

impl Pointwise for D08 {
    const RECORD: Record = Record {
        label: "D08",
        paper: &["sec:curvature"],
        title: "The jump is the sum of the outward-signed sides",
        statement: r"[\![\mathrm{II}]\!](X,Y) = g^+(\nabla_X n^+,Y) + g^-(\nabla_X n^-,Y),\qquad
            [\![\mathrm{II}]\!] = 0 \text{ for a smooth metric}",
        sides: "Left: II of either side with its own outward normal. Right: the difference of the two forms with \
            respect to one fixed normal.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (plus, minus) = (i.still0(), i.other0());
        let (nu, opposite) = (i.nu(), i.nu().map(|x| -x));
        let form = |c: &Connection<S::Base, N>, nu| Face::new(&i.formulas, c, nu).second_form;
        let (here, there) = (form(&plus, &nu), form(&minus, &opposite));
        vec![
            Equation::new("jump")
                .left("II⁺, n⁺", here)
                .left("II⁻, n⁻", there)
                .right("II⁺, fixed n", here)
                .right("−II⁻, fixed n", -form(&minus, &nu))
                .forge("difference of the outward-signed sides", "II⁻, n⁻", -there),
            Equation::new("smooth metric")
                .left("II, n⁺", here)
                .right("−II, n⁻", -form(&plus, &opposite))
                .forge(
                    "difference of the outward-signed sides",
                    "−II, n⁻",
                    form(&plus, &opposite),
                ),
        ]
    }
}
