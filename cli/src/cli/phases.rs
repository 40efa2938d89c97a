//! A progress bar for a computation in a few phases.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// A bar that moves on with every phase; it hides by itself where standard error is no terminal.
pub struct Phases {
    bar: ProgressBar,
}

impl Phases {
    /// For about so many phases.
    pub fn new(count: u64) -> Self {
        let bar = ProgressBar::new(count);
        let template = "{elapsed_precise} [{bar:30}] {spinner} {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Self { bar }
    }

    /// Another one begins.
    pub fn begin(&self, what: &'static str) {
        self.bar.inc(1);
        self.bar.set_message(what);
    }
}

impl Drop for Phases {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
