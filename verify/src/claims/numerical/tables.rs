//! N05: the paper's tables against the coordinates of its plots.

use crate::harness::{Draw, Equation, Excuses, Judgement, Method, Record, Setting, Shape};
use crate::stage::mesh::{OnMesh, ROUNDING};
use regge_study::printed::{SERIES, Series};
use regge_study::{Quantity, observed_order};

/// The tables agree with the plots.
pub struct N05;

/// One table as it is printed.
struct Table {
    label: &'static str,
    dimension: usize,
    h: &'static [&'static str],
    /// By r: (error, order).
    columns: [&'static [(&'static str, &'static str)]; 3],
}

fn number(printed: &str) -> f64 {
    printed.parse().expect("a number is printed")
}

/// Rounded to four digits, as the errors are printed.
fn four_digits(x: f64) -> f64 {
    number(&format!("{x:.3e}"))
}

/// Half a unit in the last printed place of h, which has four digits.
fn half_unit(h: &str) -> f64 {
    let exponent = number(h.split('e').nth(1).expect("h is printed with an exponent"));
    5e-4 * 10f64.powf(exponent)
}

impl Table {
    fn series(&self, degree: usize) -> &'static Series {
        let plotted = SERIES.iter().find(|s| {
            (s.dimension, s.degree, s.quantity, s.canonical)
                == (self.dimension, degree, Quantity::CurvatureError, false)
        });
        plotted.expect("what is in the tables is plotted")
    }

    /// Of the orders between two plotted errors that round to two decimals, h anywhere within the rounding of its four
    /// digits, the one nearest to what is printed. (r = 0, N = 2, k = 4: 1.40496 with the printed h, and 1.41 in print.)
    fn nearest_order(&self, k: usize, points: &[(usize, f64)], printed: f64) -> f64 {
        let order = |sign: f64| {
            let h = |k: usize, sign: f64| number(self.h[k]) + sign * half_unit(self.h[k]);
            let (before, now) = (
                (h(k - 1, sign), points[k - 1].1),
                (h(k, -sign), points[k].1),
            );
            observed_order(before, now).expect("h falls, and errors are positive")
        };
        let (a, b) = (order(1.0), order(-1.0));
        printed.clamp(a.min(b) - 0.005, a.max(b) + 0.005)
    }

    /// Errors and orders of one column, printed and found from the plot.
    fn equations(&self, degree: usize) -> Vec<Equation<f64>> {
        let (plot, column) = (self.series(degree), self.columns[degree]);
        let errors = column.iter().map(|c| number(c.0)).collect::<Vec<_>>();
        let plotted = plot
            .points
            .iter()
            .map(|p| four_digits(p.1))
            .collect::<Vec<_>>();
        let orders = column[1..].iter().map(|c| number(c.1)).collect::<Vec<_>>();
        let of = |k: usize| self.nearest_order(k, plot.points, number(column[k].1));
        let found = (1..column.len()).map(of).collect::<Vec<_>>();
        vec![
            Equation::new(self.label)
                .left("printed errors", errors)
                .right("plotted errors, rounded", plotted),
            Equation::new("orders")
                .left("printed orders", orders)
                .right("nearest orders of the plot", found),
        ]
    }
}

impl OnMesh for N05 {
    const RECORD: Record = Record {
        label: "N05",
        paper: &["tab:error_N2", "tab:error_N3", "fig:conv_plot"],
        title: "The printed tables are the plots, rounded",
        statement: r"e_k\text{ to four digits},\qquad \log(e_{k-1}/e_k)/\log(h_{k-1}/h_k)\text{ to two decimals, with the printed } h",
        sides: "Left: the tables. Right: the coordinates of the plots, rounded and divided here; h is known to four digits. No mesh is made.",
    };
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[2, 3];
    /// One case for each degree.
    const EXCUSES: Excuses = Excuses::one_method("it compares data with data")
        .few_cases("all columns of both tables; nothing is random");

    fn settings(_: usize, _: bool) -> Vec<Setting> {
        let of = |r: usize| Setting::new(Shape::Single, r, 0);
        (0..3).map(of).collect()
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let table = TABLES.iter().find(|t| t.dimension == N);
        let table = table.expect("there is one table for N = 2 and one for N = 3");
        table.equations(at.degree)
    }
}

/// Source: scalar-curvature.tex, tab:error_N2 and tab:error_N3, digit by digit.
const TABLES: [Table; 2] = [
    Table {
        label: "tab:error_N2",
        dimension: 2,
        h: &[
            "2.828e-0", "1.534e-0", "8.584e-1", "4.609e-1", "2.417e-1", "1.251e-1", "6.260e-2",
            "3.198e-2",
        ],
        columns: [
            &[
                ("2.237e-1", ""),
                ("1.945e-1", "0.23"),
                ("6.220e-2", "1.96"),
                ("2.336e-2", "1.57"),
                ("9.434e-3", "1.41"),
                ("4.457e-3", "1.14"),
                ("2.181e-3", "1.03"),
                ("1.067e-3", "1.06"),
            ],
            &[
                ("8.613e-2", ""),
                ("8.448e-2", "0.03"),
                ("4.565e-2", "1.06"),
                ("1.335e-2", "1.98"),
                ("3.689e-3", "1.99"),
                ("9.205e-4", "2.11"),
                ("2.280e-4", "2.02"),
                ("5.777e-5", "2.04"),
            ],
            &[
                ("2.720e-2", ""),
                ("1.364e-2", "1.13"),
                ("2.213e-3", "3.13"),
                ("3.615e-4", "2.91"),
                ("4.189e-5", "3.34"),
                ("5.504e-6", "3.08"),
                ("7.028e-7", "2.97"),
                ("8.784e-8", "3.1"),
            ],
        ],
    },
    Table {
        label: "tab:error_N3",
        dimension: 3,
        h: &[
            "3.464e-0", "1.850e-0", "9.709e-1", "4.999e-1", "2.753e-1", "1.358e-1", "6.878e-2",
        ],
        columns: [
            &[
                ("7.869e-2", ""),
                ("3.215e-1", "-2.24"),
                ("1.132e-1", "1.62"),
                ("4.152e-2", "1.51"),
                ("1.838e-2", "1.37"),
                ("8.733e-3", "1.05"),
                ("4.296e-3", "1.04"),
            ],
            &[
                ("1.359e-1", ""),
                ("6.613e-2", "1.15"),
                ("2.912e-2", "1.27"),
                ("8.633e-3", "1.83"),
                ("2.391e-3", "2.15"),
                ("6.194e-4", "1.91"),
                ("1.579e-4", "2.01"),
            ],
            &[
                ("1.871e-2", ""),
                ("4.133e-2", "-1.26"),
                ("5.286e-3", "3.19"),
                ("7.342e-4", "2.97"),
                ("9.753e-5", "3.38"),
                ("1.261e-5", "2.89"),
                ("1.604e-6", "3.03"),
            ],
        ],
    },
];
