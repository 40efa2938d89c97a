//! The geometry at one point against what characterises it, for random metrics. A failure shrinks towards g = δ.

use crate::common::draw::{Outcome, Source, check, close, vanishes};
use nalgebra::DMatrix;
use regge_curvature::density::{Corner, Normal, Side, omega, outward, surface_div};
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::{Jet1, lower, lower_vector};
use regge_curvature::linalg::{Mat, Vector, apply, contract, form, symmetric};
use regge_curvature::riemann::{Connection, Curvature};

/// The same in dimensions 2, 3 and 4.
macro_rules! in_every_dimension {
    ($($name:ident: $property:ident;)*) => {$(
        #[test]
        fn $name() {
            check($property::<2>);
            check($property::<3>);
            check($property::<4>);
        }
    )*};
}

in_every_dimension! {
    products_and_traces_are_their_sums: products;
    the_connection_is_metric: parallel_metric;
    derivatives_obey_leibniz: leibniz;
    divergences_agree_with_coordinates: divergences;
    curvature_has_its_symmetries: curvature_symmetries;
    derivatives_commute_up_to_curvature: ricci_identity;
    normals_are_unit_and_bend: hypersurface;
    hinges_are_where_faces_meet: hinge;
    measures_are_minors: measures;
}

/// ⟨σ, ρ⟩ = g^ik g^jl σ_ij ρ_kl, Tr σ = ⟨g, σ⟩, 𝕊σ = σ − g Tr σ.
fn products<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let connection = Connection::new(&lower(&source.metric::<N>()));
    let mut tensor = || lower(&lower(&source.tensor::<N>()));
    let (sigma, rho) = (tensor(), tensor());
    let inverse = &connection.inverse;
    vanishes(
        "g⁻¹g",
        (inverse * connection.g - Mat::<f64, N>::identity()).iter(),
    )?;
    let expected = quadruples::<N>()
        .map(|[i, j, k, l]| inverse[(i, k)] * inverse[(j, l)] * sigma[(i, j)] * rho[(k, l)]);
    close("⟨σ, ρ⟩", connection.inner(&sigma, &rho), expected.sum())?;
    let trace = connection.trace(&sigma);
    close("Tr σ", trace, connection.inner(&connection.g, &sigma))?;
    let reversed = sigma - connection.g * trace;
    vanishes(
        "𝕊σ",
        (connection.reverse_trace(&PAPER, &sigma) - reversed).iter(),
    )
}

/// ∇g = 0, div (f g) = df.
fn parallel_metric<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let (g, f) = (source.metric::<N>(), source.jet());
    let connection = Connection::new(&lower(&g));
    let scaled = lower(&g.map(|x| f * x));
    let div = connection.div_tensor(&scaled);
    for (m, slope) in connection.nabla_tensor(&lower(&g)).iter().enumerate() {
        vanishes("∇g", slope.iter())?;
        close("div fg", div[m], f.d[m])?;
    }
    Ok(())
}

/// ∂(α(X)) = (∇α)(X) + α(∇X), and ∇(α ⊗ α) by the product rule; torsion-free: dα = Alt ∇α.
fn leibniz<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let connection = Connection::new(&lower(&source.metric::<N>()));
    let (alpha, x) = (
        lower_vector(&source.vector::<N>()),
        lower_vector(&source.vector::<N>()),
    );
    let (of_alpha, of_x) = (
        connection.nabla_covector(&alpha),
        connection.nabla_vector(&x),
    );
    let square = symmetric(|i, j| alpha[i] * alpha[j]);
    let of_square = connection.nabla_tensor(&square);
    for m in 0..N {
        let paired = (0..N).map(|k| (alpha[k] * x[k]).d[m]).sum();
        let product = (0..N)
            .map(|k| of_alpha[(m, k)] * x[k].value + alpha[k].value * of_x[(m, k)])
            .sum();
        close("∂(α(X))", paired, product)?;
        for i in 0..N {
            let torsion = of_alpha[(m, i)] - of_alpha[(i, m)];
            close("dα", torsion, alpha[i].d[m] - alpha[m].d[i])?;
            for j in 0..N {
                let product = of_alpha[(m, i)] * alpha[j].value + alpha[i].value * of_alpha[(m, j)];
                close("∇(α ⊗ α)", of_square[m][(i, j)], product)?;
            }
        }
    }
    Ok(())
}

/// Δf = ∂_i(√g g^ij ∂_j f)/√g; div div (f g) = Δf; div div (df ⊗ df) by the product rule.
fn divergences<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let (g, f) = (source.metric::<N>(), source.jet::<N>());
    let connection = Connection::new(&g);
    let root = regge_curvature::scalar::Algebraic::sqrt(connection.det);
    let df = regge_curvature::riemann::differential(&f);
    let flux = apply(&connection.inverse, &df).map(|x| x * root);
    let expected = (0..N).map(|i| flux[i].d[i]).sum::<f64>() / root.value;
    close("Δf", connection.laplacian(&f), expected)?;
    close("div df", connection.lower().div_covector(&df), expected)?;
    let hessian = connection.lower().hessian(&f);
    close("Tr ∇∇f", connection.lower().trace(&hessian), expected)?;
    let scaled = g.map(|x| f * x);
    close("div div fg", connection.div_div(&scaled), expected)
}

/// R_ijkl is antisymmetric in i, j, symmetric under pairs, obeys Bianchi's first identity; R and G are its traces.
fn curvature_symmetries<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let g = source.metric::<N>();
    let connection = Connection::new(&lower(&g));
    let curvature = Curvature::new(&g, &connection);
    let r = |i, j, k, l| curvature.riemann([i, j, k, l]);
    let (inverse, mut scalar) = (&connection.inverse, 0.0);
    for [i, j, k, l] in quadruples::<N>() {
        close("R_ijkl + R_jikl", r(i, j, k, l) + r(j, i, k, l), 0.0)?;
        close("R_ijkl − R_klij", r(i, j, k, l), r(k, l, i, j))?;
        close(
            "Bianchi",
            r(i, j, k, l) + r(j, k, i, l) + r(k, i, j, l),
            0.0,
        )?;
        scalar += inverse[(i, k)] * inverse[(j, l)] * r(i, j, k, l);
    }
    close("R", curvature.scalar(), scalar)?;
    let (ricci, einstein) = (curvature.ricci(), curvature.einstein(&PAPER));
    close("Tr Ric", connection.trace(&ricci), scalar)?;
    let reversed = ricci - connection.g * (scalar / 2.0);
    vanishes("G", (einstein - reversed).iter())
}

fn quadruples<const N: usize>() -> impl Iterator<Item = [usize; 4]> {
    (0..N.pow(4)).map(|n| [n % N, n / N % N, n / N.pow(2) % N, n / N.pow(3)])
}

/// (∇_i ∇_j − ∇_j ∇_i) α_k = R_ijkl α^l, Γ and its derivatives on the left and the lowered R on the right.
fn ricci_identity<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let (g, alpha) = (source.metric::<N>(), source.vector::<N>());
    let connection = Connection::new(&g);
    let low = connection.lower();
    let nabla = connection.nabla_covector(&alpha);
    let raised = low.sharp(&alpha.map(|a| a.value));
    let curvature = Curvature::new(&g, &low);
    // (∇_m ∇α)_ij: the derivative of a tensor that is not symmetric.
    let second = |m: usize, i: usize, j: usize| {
        let terms = (0..N).map(|k| {
            low.gamma[k][(m, i)] * nabla[(k, j)].value + low.gamma[k][(m, j)] * nabla[(i, k)].value
        });
        nabla[(i, j)].d[m] - terms.sum::<f64>()
    };
    for [i, j, k, _] in quadruples::<N>() {
        let commutator = second(i, j, k) - second(j, i, k);
        let expected: f64 = (0..N)
            .map(|l| curvature.riemann([i, j, k, l]) * raised[l])
            .sum();
        close("[∇_i, ∇_j] α", commutator, expected)?;
    }
    Ok(())
}

/// The face x_1 = 0 seen from x_1 > 0: g(n, n) = 1, n ⟂ F, II(X, Y) = g(∇_X n, Y), H and div_F by components.
fn hypersurface<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let (g, alpha) = (source.metric::<N>(), lower_vector(&source.vector::<N>()));
    let sigma = lower(&lower(&source.tensor::<N>()));
    let connection = Connection::new(&g);
    let nu: Vector<Jet1<f64, N>, N> = outward(1);
    let field = Normal::new(&PAPER, &connection.inverse, connection.det, &nu);
    let low = connection.lower();
    let side = Side::new(&PAPER, &low, &nu);
    let normal = &side.normal;
    close("g(n, n)", normal.normal_normal(&low.g), 1.0)?;
    close(
        "|ν|",
        contract(&nu.map(|x| x.value), &normal.n),
        normal.length,
    )?;
    close(
        "Tr(σ|_F)",
        normal.trace(&sigma),
        low.trace(&sigma) - normal.normal_normal(&sigma),
    )?;
    let bend = low.nabla_vector(&field.n);
    let mut h = 0.0;
    for i in 1..N {
        close("n ⟂ F", apply(&low.g, &normal.n)[i], 0.0)?;
        for j in 1..N {
            let expected: f64 = (0..N).map(|k| bend[(i, k)] * low.g[(k, j)]).sum();
            close("II", side.second_form[(i, j)], expected)?;
            h += normal.tangential[(i, j)] * expected;
        }
    }
    close("H", side.mean_curvature, h)?;
    let density = h * side.normal.omega;
    close("H ω_F", side.densitized_mean_curvature(), density)?;
    let reversed = side.second_form - low.g * h;
    vanishes("II‾", (side.trace_reversed() - reversed).iter())?;
    let along_n = form(&low.nabla_covector(&alpha), &normal.n, &normal.n);
    let div = surface_div(&low, normal, &alpha);
    close("div_F α", div, low.div_covector(&alpha) - along_n)
}

/// n_a and τ_a are an orthonormal frame of the plane normal to S; cos θ = g(τ_a, τ_b) = −g(n_a, n_b).
fn hinge<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let connection = Connection::new(&lower(&source.metric::<N>()));
    let sigma = lower(&lower(&source.tensor::<N>()));
    for (a, b) in [(0, 1), (1, 2), (N, 1)] {
        let nu: [Vector<f64, N>; 2] = [outward(a), outward(b)];
        let (inverse, det) = (&connection.inverse, connection.det);
        let hinge = Corner::new(&PAPER, inverse, det, [&nu[0], &nu[1]]);
        let product = |x: &Vector<f64, N>, y: &Vector<f64, N>| form(&connection.g, x, y);
        let tau = [hinge.conormal(0), hinge.conormal(1)];
        for face in 0..2 {
            let (n, t) = (hinge.normal(face), tau[face]);
            let unit = Normal::new(&PAPER, inverse, det, &nu[face]).n;
            vanishes("n", (n - unit).iter())?;
            close("g(τ, τ)", product(&t, &t), 1.0)?;
            close("g(n, τ)", product(&n, &t), 0.0)?;
            let inwards = contract(&nu[1 - face], &t) < 0.0;
            close("τ points into the face", f64::from(u8::from(inwards)), 1.0)?;
            let rest = form(&sigma, &n, &n) + form(&sigma, &t, &t);
            let trace = hinge.trace(&sigma);
            close("Tr(σ|_S)", trace, connection.trace(&sigma) - rest)?;
        }
        let (sin, cos) = hinge.dihedral();
        let length = sin.hypot(cos);
        close("cos θ", cos / length, product(&tau[0], &tau[1]))?;
        close(
            "|sin θ + i cos θ|",
            length,
            (hinge.squares[0] * hinge.squares[1]).sqrt(),
        )?;
    }
    Ok(())
}

/// ω_F and ω_S are the square roots of minors of g: F = {x_1 = 0}, S = {x_1 = x_2 = 0}.
fn measures<const N: usize>(source: &mut Source<'_>) -> Outcome {
    let connection = Connection::new(&lower(&source.metric::<N>()));
    let minor = |k: usize| DMatrix::from_fn(N - k, N - k, |i, j| connection.g[(i + k, j + k)]);
    close("det g", connection.det, minor(0).determinant())?;
    let nu = [outward(1), outward(2)];
    let face = minor(1).determinant().sqrt();
    let (inverse, det) = (&connection.inverse, connection.det);
    close("ω", omega(&PAPER, det), minor(0).determinant().sqrt())?;
    close("ω_F", Normal::new(&PAPER, inverse, det, &nu[0]).omega, face)?;
    let hinge = Corner::new(&PAPER, inverse, det, [&nu[0], &nu[1]]);
    let size = if N == 2 {
        1.0
    } else {
        minor(2).determinant().sqrt()
    };
    close("ω_S", hinge.omega(), size)
}
