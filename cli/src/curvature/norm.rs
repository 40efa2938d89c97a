//! ‖(Rω)_dist(g_h) − (Rω)(g)‖ in a norm of the library's table.

use super::given::{Given, Origin, Phase};
use super::report::{NormError, QuadratureUsed};
use super::settle::{LOAD_SETTLES, SUMS_SETTLE, Settled};
use super::smooth::{check_stated, stated_curvature};
use super::sums::Evaluation;
use super::{CurvatureError, failed, input};
use regge_curvature::functional::{Rules, smooth_curvature};
use regge_curvature::norm::{DualNorm, Kind, Setting, Step, Target, metric_values};
use regge_curvature::quadrature::Rule;
use regge_terminal::left;
use std::time::Instant;

/// The largest N that norms are for.
pub const LARGEST_WITH_NORM: usize = 3;

/// A norm of the table, set up for a Regge metric.
pub struct Norm<'a, const N: usize> {
    kind: &'static Kind<N>,
    /// The norm.
    pub norm: Box<dyn DualNorm<N>>,
    /// The smooth metric that is compared with.
    pub origin: &'a Origin<'a, N>,
    degree: usize,
}

impl<'a, const N: usize> Norm<'a, N> {
    /// Are there norms in this dimension? As a constant, so that nothing of them is compiled where there are none.
    const EXISTS: bool = N <= LARGEST_WITH_NORM;

    /// The norm of this name.
    ///
    /// # Errors
    /// There is no smooth metric, its stated curvature is not its own (which is not looked at if it is `trusted`), or the norm
    /// cannot be set up.
    pub fn new(
        given: &'a Given<'a, N>,
        degree: usize,
        name: &str,
        trusted: bool,
    ) -> Result<Self, CurvatureError> {
        if !Self::EXISTS {
            let reason =
                format!("--norm {name} is for dimensions up to {LARGEST_WITH_NORM}, not {N}");
            return Err(CurvatureError::Input(reason));
        }
        let Some(origin) = &given.origin else {
            let reason = match &given.points {
                Some(_) => {
                    "a norm is for a domain of ℝ^N with a formula, not for a surface or curved cells"
                }
                None => "the error needs a smooth metric to compare with: give --metric",
            };
            return Err(CurvatureError::Input(reason.into()));
        };
        if let Some(exact) = origin.scalar_curvature.filter(|_| !trusted) {
            let rule = Rule::new(N, Rules::default_order(degree));
            check_stated(&origin.metric, exact, &rule).map_err(input)?;
        }
        let kind = Kind::<N>::named(name).expect("--norm takes names of the table");
        let (degree, metric) = ((kind.degree)(degree), metric_values(&origin.metric));
        let setting = Setting::new(given.g_h.space().mesh(), degree).with_metric(&metric);
        Ok(Self {
            kind,
            norm: (kind.new)(&setting).map_err(failed)?,
            origin,
            degree,
        })
    }

    /// ∫ R v ω of the smooth metric for the norm's test functions.
    pub fn smooth_load(&self, rules: &Rules) -> Vec<f64> {
        if !Self::EXISTS {
            return Vec::new();
        }
        let (g, space) = (&self.origin.metric, self.norm.space());
        match self.origin.scalar_curvature {
            Some(exact) => stated_curvature(g, exact, space, &rules.cells),
            None => smooth_curvature(g, space, rules),
        }
    }

    /// The norm of what was evaluated; `phase` is told of an iteration's steps.
    pub fn of(
        &self,
        sums: &Settled<Evaluation>,
        phase: Phase<'_>,
    ) -> Result<NormError, CurvatureError> {
        let load = sums.value.load.as_ref();
        let load = load.expect("a load is evaluated where there is a norm");
        let (mut last, begin) = (None, Instant::now());
        let mut watch = |step: Step| {
            let left = left(Target::DEFAULT.share(step), begin.elapsed());
            phase(&format!(
                "solving for the norm, step {}: residual {:.1e}{left}",
                step.number, step.residual
            ));
            last = Some(step);
        };
        let representative = self.norm.represent(load, &mut watch).map_err(failed)?;
        let value = self.norm.measure(&representative, None).map_err(failed)?;
        Ok(NormError {
            symbol: self.kind.symbol,
            error: value.total,
            degree: self.degree,
            solver: self.norm.solver(),
            steps: last.map(|step| step.number),
            residual: last.map(|step| step.residual),
            unknowns: self.norm.unknowns(),
            quadrature: QuadratureUsed {
                // The change of an evaluation is that of its load in units of what counts for sums.
                change: sums
                    .change
                    .map(|change| change * LOAD_SETTLES / SUMS_SETTLE),
                ..QuadratureUsed::of(sums, SUMS_SETTLE)
            },
        })
    }
}
