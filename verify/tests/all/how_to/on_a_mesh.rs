use regge_curvature::functional::cell_volumes;
use regge_curvature::mesh::Side;
use regge_curvature::simplex::factorial;
use regge_curvature::spaces::ReggeSpace;
use regge_verify::harness::{Draw, Equation, Judgement, Record, Setting, Shape, grid};
use regge_verify::stage::fields::{Seen, metric};
use regge_verify::stage::mesh::{OnMesh, ROUNDING};
use regge_verify::stage::reference::leading_minor;

pub struct Volumes;

impl OnMesh for Volumes {
    const RECORD: Record = Record {
        label: "X02",
        paper: &[],
        title: "The volumes of the cells of a piecewise flat metric",
        statement: r"\int_T\omega = \frac{1}{N!}\sqrt{\det g}",
        sides: "Left: the production volumes. Right: determinants by elimination.",
    };
    const JUDGEMENT: Judgement = ROUNDING;   // or QUADRATURE, if it holds only in the limit of exact quadrature

    fn settings(_dimension: usize, quick: bool) -> Vec<Setting> {
        // Two meshes, for r = 0 alone by rules of order 1, so many times.
        grid(&[Shape::Alfeld, Shape::Sphere], &[1], if quick { 2 } else { 32 })
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let g = metric(&ReggeSpace::new(&mesh, at.degree), draw);
        let rules = at.rules(N);             // by the formulas of the case
        let seen = Seen::<f64, N, _>::new(&g, N, &rules.cells);
        let volume = |cell| {
            let g = seen.value(Side { cell, place: 0 }, 0);
            leading_minor(&g, N).sqrt() / factorial(N)
        };
        let by_minors: Vec<f64> = (0..mesh.cell_count()).map(volume).collect();
        vec![
            Equation::new("|T|")
                .left("∫_T ω", cell_volumes(&g, &mesh, &rules))
                .right("√det g/N!", by_minors),
        ]
    }
}
