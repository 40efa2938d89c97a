//! How far a study is.

use regge_curvature::norm::Target;
use regge_study::{Case, Event, Phase, Study};
use regge_terminal::{Bar, Voice, left};
use std::time::Instant;

/// A bar that is as long as a study is work.
pub struct Progress {
    bar: Bar,
    /// That of all cases.
    work: u64,
    start: Instant,
    /// The work of the cases that are done, and of those that an earlier run did.
    done: u64,
    earlier: u64,
    /// The phase of the case at hand.
    phase: Option<(Case, Phase)>,
}

/// The share of a case's work that is done when a phase begins: rounded from rows of k = 4 in space.
fn share(phase: Phase) -> f64 {
    match phase {
        Phase::Mesh => 0.0,
        Phase::SetUp => 0.02,
        Phase::Interpolate => 0.1,
        Phase::Load => 0.15,
        Phase::Solve => 0.3,
        Phase::Norm => 0.97,
    }
}

impl Progress {
    /// For a study.
    pub fn new(study: &Study, voice: &Voice) -> Self {
        let work: u64 = study.cases.iter().map(|&case| study.work(case)).sum();
        Self {
            bar: voice.bar(work),
            work,
            start: Instant::now(),
            done: 0,
            earlier: 0,
            phase: None,
        }
    }

    /// Shows what goes on.
    pub fn show(&mut self, study: &Study, event: Event<'_>) {
        match event {
            Event::Phase(case, phase) => {
                self.phase = Some((case, phase));
                self.put(study, case, share(phase), phase.to_string());
            }
            Event::Step(case, step) => {
                let part = Target::DEFAULT.share(step);
                let (from, to) = (share(Phase::Solve), share(Phase::Norm));
                let what = format!(
                    "solution, step {}, residual {:.1e}",
                    step.number, step.residual
                );
                self.put(study, case, from + part * (to - from), what);
            }
            Event::Done(case) => {
                self.done += study.work(case);
                if self.phase.take().is_none() {
                    self.earlier += study.work(case);
                }
                self.bar.place(self.done, "");
            }
            Event::Row(_) => {}
        }
    }

    fn put(&self, study: &Study, case: Case, share: f64, what: String) {
        let position = self.done + (share * study.work(case) as f64) as u64;
        let share = (position - self.earlier) as f64 / (self.work - self.earlier) as f64;
        let left = left(share, self.start.elapsed());
        let Case { degree, level } = case;
        self.bar
            .place(position, format!("r = {degree}, k = {level}: {what}{left}"));
    }

    /// Prints with the bar out of the way.
    pub fn aside<T>(&self, print: impl FnOnce() -> T) -> T {
        self.bar.aside(print)
    }
}
