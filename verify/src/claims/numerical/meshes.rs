//! N03, N04: the meshes and the dimensions of the spaces.

use crate::harness::{Draw, Equation, Excuses, Judgement, Method, Record, Setting, Shape};
use crate::stage::mesh::{OnMesh, ROUNDING};
use regge_curvature::Error;
use regge_curvature::mesh::Mesh;
use regge_curvature::spaces::ReggeSpace;
use regge_study::Quantity;
use regge_study::printed::SERIES;

/// k, and the cube of 2ᵏ cubes a side.
fn cube<const N: usize>(at: &Setting) -> (u32, Mesh<N>) {
    let Shape::Cube(side) = at.shape else {
        panic!("these settings are cubes")
    };
    let mesh = Mesh::cube(side).expect("a cube of some cubes is a mesh");
    (side.trailing_zeros(), mesh)
}

/// All levels of the paper's tables, or the first three.
fn levels(dimension: usize, quick: bool) -> u32 {
    match (quick, dimension) {
        (true, _) => 3,
        (_, 2) => 8,
        _ => 7,
    }
}

/// The paper's meshes.
pub struct N03;

impl OnMesh for N03 {
    const RECORD: Record = Record {
        label: "N03",
        paper: &["sec:numerical"],
        title: "The meshes of the numerical section",
        statement: r"|\mathcal{T}^2|=2\cdot4^k,\ |\mathcal{T}^3|=6\cdot8^k,\quad\tilde h=\sqrt N\,2^{1-k},\quad\min_e|e|=2^{1-k},
            \quad|\delta x_i|\le\tilde h\,2^{-(2N+1)/2}",
        sides: "Left: the library's meshes, counted and measured. Right: the paper's formulas.",
    };
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const EXCUSES: Excuses = Excuses::one_method("it compares data with data")
        .few_cases("all levels that the paper has; nothing is random");

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let of = |k: u32| Setting::new(Shape::Cube(1 << k), 0, 0);
        (0..levels(dimension, quick)).map(of).collect()
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let (k, mesh) = cube::<N>(at);
        let cells = if N == 2 {
            2 * 4usize.pow(k)
        } else {
            6 * 8usize.pow(k)
        };
        let least = 2f64.powi(1 - k as i32);
        let points = mesh.points().expect("a cube has coordinates");
        let edges = (0..mesh.count(1)).map(|e| {
            let v = mesh.vertices(1, e);
            (points[v[0] as usize] - points[v[1] as usize]).norm()
        });
        let h = (N as f64).sqrt() * least;
        // A quarter of a cell when N = 2, 0.153 of it when N = 3.
        let amplitude = h * 2f64.powf(-(2.0 * N as f64 + 1.0) / 2.0);
        let paper = mesh.perturbed_as_in_paper(k, 5);
        let plain = mesh.perturbed(amplitude, 5);
        let moved = |mesh: Result<Mesh<N>, Error>| -> Vec<f64> {
            let mesh = mesh.expect("no cell is turned over");
            let points = mesh.points().expect("a cube has coordinates");
            points.iter().flatten().copied().collect()
        };
        vec![
            Equation::new("cells")
                .left("|𝒯^N|", mesh.cell_count() as f64)
                .right("N! 2^{Nk}", cells as f64),
            Equation::new("h̃")
                .left("max h_T", mesh.mesh_size())
                .right("√N 2^{1−k}", h),
            Equation::new("shortest edge")
                .left("min |e|", edges.fold(f64::INFINITY, f64::min))
                .right("2^{1−k}", least),
            Equation::new("perturbation")
                .left("as in the paper", moved(paper))
                .right("by amplitude", moved(plain)),
        ]
    }
}

/// The numbers of degrees of freedom.
pub struct N04;

impl OnMesh for N04 {
    const RECORD: Record = Record {
        label: "N04",
        paper: &["fig:conv_plot"],
        title: "The plotted numbers of degrees of freedom",
        statement: r"N=2:\ (r+1)E+\tfrac32r(r+1)T;\qquad N=3:\ (r+1)E+\tfrac32r(r+1)F+(r+1)r(r-1)T",
        sides: "Left: dimensions of the library's spaces. Right: the abscissae of the paper's plots, and the formula.",
    };
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const EXCUSES: Excuses = Excuses::one_method("it compares data with data")
        .few_cases("all levels that the paper has; nothing is random");

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let levels = levels(dimension, quick);
        let one = |r: usize| (0..levels).map(move |k| Setting::new(Shape::Cube(1 << k), r, 0));
        (0..3).flat_map(one).collect()
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let (k, mesh) = cube::<N>(at);
        let space = ReggeSpace::new(&mesh, at.degree);
        let plotted = SERIES.iter().find(|s| {
            (s.dimension, s.degree, s.quantity, s.canonical)
                == (N, at.degree, Quantity::CurvatureError, false)
        });
        let plotted = plotted.expect("the error is plotted for r = 0, 1, 2");
        let expected = plotted.points[k as usize].0 as f64;
        let (r, count) = (at.degree as f64, |k: usize| mesh.count(k) as f64);
        let (edge, face) = (r + 1.0, 1.5 * r * (r + 1.0));
        let inner = if N == 3 {
            (r + 1.0) * r * (r - 1.0) * count(3)
        } else {
            0.0
        };
        vec![
            Equation::new("plotted")
                .left("dim", space.len() as f64)
                .right("ndof", expected),
            Equation::new("formula")
                .left("dim", space.len() as f64)
                .right("(r+1)E", edge * count(1))
                .right("3/2 r(r+1)F", face * count(2))
                .vanishes(at.degree == 0, "r = 0")
                .right("(r+1)r(r−1)T", inner)
                .vanishes(N == 2 || at.degree < 2, "no such functions"),
        ]
    }
}
