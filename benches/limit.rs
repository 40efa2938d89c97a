//! How near the machine's limit the functional is: operations a cell, their rate, and the rates of a dense product and of
//! bare multiply-adds, on one thread.
//!
//! The operations are counted, not estimated: a scalar that counts goes through the same kernel. `cargo bench -p
//! regge-benches --bench limit` prints the table of docs/performance.md.

use nalgebra::DMatrix;
use regge_curvature::scalar::{Algebraic, Field, Lanes, Lift, Number, Real};
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeFunction, ReggeSpace, Rules, Smooth, TensorField,
    distributional_curvature,
};
use std::hint::black_box;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// Sums, differences and products; quotients; roots; angles.
static COUNTS: [AtomicU64; 4] = [const { AtomicU64::new(0) }; 4];

fn count(kind: usize) {
    COUNTS[kind].fetch_add(1, Ordering::Relaxed);
}

/// An f64 whose operations are counted. Signs are free.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Counted(f64);

macro_rules! counted {
    ($($trait:ident $method:ident $assign:ident $assign_method:ident $kind:literal;)*) => {$(
        impl $trait for Counted {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                count($kind);
                Self($trait::$method(self.0, other.0))
            }
        }
        counted!(@ $assign $assign_method $trait $method);
    )*};
    (@ DivAssign $assign_method:ident $trait:ident $method:ident) => {};
    (@ $assign:ident $assign_method:ident $trait:ident $method:ident) => {
        impl $assign for Counted {
            fn $assign_method(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    };
}
counted! {
    Add add AddAssign add_assign 0;
    Sub sub SubAssign sub_assign 0;
    Mul mul MulAssign mul_assign 0;
    Div div DivAssign div_assign 1;
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Field for Counted {
    fn from_int(n: i64) -> Self {
        Self(n as f64)
    }
    fn ratio(n: i64, d: i64) -> Self {
        Self(n as f64 / d as f64)
    }
}

impl Algebraic for Counted {
    fn sqrt(self) -> Self {
        count(2);
        Self(self.0.sqrt())
    }
}

/// The kernel has no elementary function but the angle.
impl Real for Counted {
    const LANES: usize = 1;
    type Sum = Self;

    fn from_f64(x: f64) -> Self {
        Self(x)
    }
    fn pack(value: impl Fn(usize) -> f64) -> Self {
        Self(value(0))
    }
    fn reduce(self) -> Self {
        self
    }
    fn exp(self) -> Self {
        Self(self.0.exp())
    }
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
    fn sin(self) -> Self {
        Self(self.0.sin())
    }
    fn cos(self) -> Self {
        Self(self.0.cos())
    }
    fn atan(self) -> Self {
        Self(self.0.atan())
    }
    fn angle(sin: Self, cos: Self) -> Self {
        count(3);
        Self(sin.0.atan2(cos.0))
    }
    fn select(self, above: Self, below: Self) -> Self {
        Self(self.0.select(above.0, below.0))
    }
}

impl Lift<Self> for Counted {
    fn lift(self) -> Self {
        self
    }
}

impl Number for Counted {
    type Wide = Self;
}

/// The least time of the runs of a second, in seconds; of a single run where `cargo test` tries the benches.
fn least(mut run: impl FnMut()) -> f64 {
    let measured = std::env::args().any(|argument| argument == "--bench");
    let start = Instant::now();
    let mut best = f64::INFINITY;
    while best.is_infinite() || (measured && start.elapsed().as_secs_f64() < 1.0) {
        let begin = Instant::now();
        run();
        best = best.min(begin.elapsed().as_secs_f64());
    }
    best
}

/// Multiply-adds of lanes that do not wait for one another, in operations a second.
fn multiply_adds() -> f64 {
    const CHAINS: usize = 12;
    const STEPS: usize = 100_000;
    let (a, b) = (Lanes::new([0.5; 4]), Lanes::new([1.0; 4]));
    let seconds = least(|| {
        let (a, b) = black_box((a, b));
        let mut sums = [b; CHAINS];
        for _ in 0..STEPS {
            for sum in &mut sums {
                let mut next = b;
                next.add_product(*sum, a);
                *sum = next;
            }
        }
        black_box(sums);
    });
    (2 * Lanes::LANES * CHAINS * STEPS) as f64 / seconds
}

/// A product of matrices of 768 rows by nalgebra, in operations a second.
fn dense_product() -> f64 {
    const SIZE: usize = 768;
    let a = DMatrix::from_fn(SIZE, SIZE, |i, j| ((i * 7 + j * 3) % 11) as f64);
    let mut c = a.clone();
    let seconds = least(|| c.gemm(1.0, black_box(&a), black_box(&a), 0.0));
    black_box(c);
    2.0 * (SIZE as f64).powi(3) / seconds
}

/// Operations by kind and seconds of the functional against the hats, for a cell.
struct Cost {
    counts: [f64; 4],
    seconds: f64,
}

fn cost<const N: usize>(g: &ReggeFunction<f64, N>, rules: &Rules) -> Cost {
    let (space, hats) = (g.space(), Lagrange::new(g.space().mesh(), 1));
    let cells = hats.mesh().cell_count() as f64;
    let coefficients = g.coefficients().iter().map(|c| Counted(*c)).collect();
    let counted = space.function(coefficients).expect("as many coefficients");
    run(&counted, &hats, rules);
    let counts = COUNTS
        .each_ref()
        .map(|c| c.swap(0, Ordering::Relaxed) as f64 / cells);
    Cost {
        counts,
        seconds: least(|| run(g, &hats, rules)) / cells,
    }
}

fn run<const N: usize>(g: &impl TensorField<N>, hats: &Lagrange<N>, rules: &Rules) {
    black_box(distributional_curvature(black_box(g), hats, rules));
}

/// A line for each degree on the paper's mesh of this level.
fn by_degree<const N: usize>(level: u32, rates: [f64; 2]) {
    let mesh = Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 1))
        .expect("a mesh");
    let graph = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    for degree in 0..=2 {
        let space = ReggeSpace::new(&mesh, degree);
        let canonical = Interpolant::canonical().with_order(2 * degree + 2);
        let g = canonical.apply(&space, &graph).expect("a metric");
        let Cost { counts, seconds } = cost(&g, &Rules::on(&mesh, 2 * (degree + 2)));
        let rate = counts[0] / seconds;
        println!(
            "| {N} | {degree} | {:.0} | {:.0} | {:.0} | {:.0} | {:.2} | {:.1} | {:.0} % | {:.0} % |",
            counts[0],
            counts[1],
            counts[2],
            counts[3],
            seconds * 1e6,
            rate / 1e9,
            100.0 * rate / rates[0],
            100.0 * rate / rates[1],
        );
    }
}

fn main() {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    one.expect("a thread").install(|| {
        let rates = [dense_product(), multiply_adds()];
        let [product, bare] = rates.map(|rate| rate / 1e9);
        println!(
            "one thread, vectors of {} bits; dense product {product:.1} GFlop/s, bare multiply-adds {bare:.1}",
            Lanes::BUILT_FOR
        );
        println!(
            "| N | r | + − × | ÷ | √ | angles | µs a cell | GFlop/s | of a dense product | of multiply-adds |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|");
        by_degree::<2>(5, rates);
        by_degree::<3>(3, rates);
    });
}
