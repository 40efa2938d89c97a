//! The progress bar on standard error.

use indicatif::{ProgressBar, ProgressStyle};
use regge_study::{Event, Study};
use std::time::Duration;

/// A bar that is as long as a study is work; it hides by itself where standard error is no terminal.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// For a study.
    pub fn new(study: &Study) -> Self {
        let work = study.cases.iter().map(|&case| study.work(case)).sum();
        let bar = ProgressBar::new(work);
        let template = "{elapsed_precise} [{bar:30}] {percent:>3}% {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Self { bar }
    }

    /// Shows what goes on.
    pub fn show(&self, study: &Study, event: Event<'_>) {
        match event {
            Event::Phase(case, phase) => {
                self.bar
                    .set_message(format!("r = {}, k = {}: {phase}", case.degree, case.level));
            }
            Event::Done(case) => self.bar.inc(study.work(case)),
            Event::Row(_) => {}
        }
    }

    /// Prints with the bar out of the way.
    pub fn aside<T>(&self, print: impl FnOnce() -> T) -> T {
        self.bar.suspend(print)
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
