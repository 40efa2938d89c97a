//! D09, I20: dihedral angles.

use crate::harness::{Equation, Ground, Record, Timed};
use crate::stage::point::{Instance, Pointwise, orthonormal};
use regge_curvature::density::{Corner, outward};
use regge_curvature::linalg::{Vector, form};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::{Algebraic, Field};

/// (sin θ, cos θ), normalised.
fn normalised<B: Ground, const N: usize>(corner: &Corner<'_, B, N>) -> (B, B) {
    let (sin, cos) = corner.dihedral();
    let scale = B::one() / (sin * sin + cos * cos).sqrt();
    (sin * scale, cos * scale)
}

/// The edge from vertex 0 to vertex v of the reference simplex.
fn edge<B: Field, const N: usize>(v: usize) -> Vector<B, N> {
    Vector::from_fn(|k, _| if k + 1 == v { B::one() } else { B::zero() })
}

/// The definition of θ_ST.
pub struct D09;

impl Pointwise for D09 {
    const RECORD: Record = Record {
        label: "D09",
        paper: &["sec:curvature"],
        title: "The dihedral angle",
        statement: r"\cos\theta_{ST} = -g(n^+,n^-) = g(\tau^+,\tau^-),\quad \theta_{ST}\in(0,\pi);\qquad
            \sum_S\theta_{ST} = \pi \text{ for a flat triangle}",
        sides: "Left: the library's dihedral angle, conormals and outward normals, made of g⁻¹ and covectors. Right: \
            edge vectors of the simplex, orthonormalised with g.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let base = i.still0();
        let g = base.g;
        let corner = i.corner(&base, [&outward(N), &outward(N - 1)]);
        let (sin, cos) = normalised(&corner);
        // The hinge has the vertices 0…N−2; the face opposite to vertex N contains N−1, and the other way round.
        let into = |v: usize| {
            let mut edges: Vec<_> = (1..N - 1).map(edge).collect();
            edges.push(edge(v));
            orthonormal(&g, &edges).pop().expect("there is an edge")
        };
        let (one, other) = (into(N - 1), into(N));
        let product = form(&g, &one, &other);
        let normals = form(&g, &corner.normal(0), &corner.normal(1));
        let mut equations = vec![
            Equation::new("cos θ")
                .left("cos θ", cos)
                .right("g(τ⁺,τ⁻)", product)
                .forge("cos θ = +g(n⁺,n⁻)", "cos θ", -cos),
            Equation::new("normals")
                .left("−g(n⁺,n⁻)", -normals)
                .right("g(τ⁺,τ⁻)", product),
            Equation::new("sin θ").left("sin θ", sin).right(
                "√(1−g(τ⁺,τ⁻)²)",
                (S::Base::one() - product * product).sqrt(),
            ),
            Equation::new("τ⁺")
                .left("τ⁺", corner.conormal(0))
                .right("from edges", one),
            Equation::new("τ⁻")
                .left("τ⁻", corner.conormal(1))
                .right("from edges", other),
        ];
        if N == 2 {
            equations.extend(triangle(i, &base));
        }
        equations
    }
}

/// The angles of a flat triangle add up to π.
fn triangle<S: Timed, const N: usize>(
    i: &Instance<S, N>,
    base: &Connection<S::Base, N>,
) -> Option<Equation<S::Base>> {
    let angle = |a: usize, b: usize| {
        let (sin, cos) = i.corner(base, [&outward(a), &outward(b)]).dihedral();
        S::Base::angle(sin, cos)
    };
    Some(
        Equation::new("triangle")
            .left("θ_0", angle(1, 2)?)
            .left("θ_1", angle(2, 0)?)
            .left("θ_2", angle(0, 1)?)
            .right("π", S::Base::from_real(std::f64::consts::PI)),
    )
}

/// The difference of two cosines.
pub struct I20;

impl Pointwise for I20 {
    const RECORD: Record = Record {
        label: "I20",
        paper: &["lemma:angledefectbound"],
        title: "The difference of the cosines of a dihedral angle in two metrics",
        statement: r"\cos\theta_{ST}(g) - \cos\theta_{ST}(\tilde g) = \tilde g(\tilde n^1 - n^1,\tilde n^2 - n^2)
            + \tilde g(\tilde n^1 - n^1,n^2) + \tilde g(n^1,\tilde n^2 - n^2) + \tilde g(n^1,n^2) - g(n^1,n^2)",
        sides: "Left: the library's dihedral angles, from products of covectors. Right: products of unit normals.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, other) = (i.still0(), i.other0());
        let (g, g_t) = (base.g, other.g);
        let nu = [i.nu().map(|x| x.value), i.nu_bar];
        // −cos θ̃ and the products by g̃ cancel for any vectors n¹, n².
        let n = i.or_any([0, 1].map(|a| i.normal(&base, &nu[a]).n));
        let d = [0, 1].map(|a| i.normal(&other, &nu[a]).n - n[a]);
        let cos = |at| normalised(&i.corner(at, [&nu[0], &nu[1]])).1;
        vec![
            Equation::new("cos θ − cos θ̃")
                .left("cos θ", cos(&base))
                .left("−cos θ̃", -cos(&other))
                .right("g̃(ñ¹−n¹,ñ²−n²)", form(&g_t, &d[0], &d[1]))
                .right("g̃(ñ¹−n¹,n²)", form(&g_t, &d[0], &n[1]))
                .right("g̃(n¹,ñ²−n²)", form(&g_t, &n[0], &d[1]))
                .right("g̃(n¹,n²)", form(&g_t, &n[0], &n[1]))
                .right("−g(n¹,n²)", -form(&g, &n[0], &n[1])),
        ]
    }
}
