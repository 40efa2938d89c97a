//! The options that every command has, and what follows from them.

use super::memory;
use regge_terminal::output::{Named, is_standard};
use regge_terminal::{Loudness, Stop, Voice};

/// What can be said of any run.
#[derive(clap::Args)]
#[command(next_help_heading = "Options of every command")]
pub struct Common {
    #[command(flatten)]
    pub loudness: Loudness,
    /// Compute with so many threads; numbers do not depend on it [default: one for each processor]
    #[arg(long, global = true, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    pub memory: memory::Args,
}

impl Common {
    /// Has this process compute with the threads that were asked for.
    pub fn set_threads(&self) -> Result<(), Stop> {
        let Some(threads) = self.threads else {
            return Ok(());
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        let built = pool.build_global();
        built.map_err(|error| Stop::Failed(format!("{threads} threads: {error}")))
    }

    /// The voice of a command that writes these files.
    pub fn voice(&self, outputs: &[Named<'_>]) -> Voice {
        let taken = outputs.iter().any(|(_, path)| is_standard(path));
        self.loudness.voice(taken)
    }
}
