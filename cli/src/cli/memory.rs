//! What does not fit into memory is refused before it begins.

use regge_study::{Case, Study};
use regge_terminal::Stop;

/// Bytes in a GiB.
const GIB: f64 = (1u64 << 30) as f64;

/// How much memory there is.
#[derive(Clone, Debug, clap::Args)]
#[group(skip)]
pub struct Args {
    /// Refuse what is estimated to need more memory than this [default: what the system says is available]
    #[arg(long, value_name = "GIB", allow_negative_numbers = true, value_parser = positive)]
    memory_limit: Option<f64>,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text
        .parse::<f64>()
        .ok()
        .filter(|x| x.is_finite() && *x > 0.0);
    number.ok_or_else(|| format!("'{text}' is no number of GiB"))
}

impl Args {
    /// Refuses a study that has a row for which memory does not suffice.
    pub fn check(&self, study: &Study) -> Result<(), Stop> {
        let Some(limit) = self.memory_limit.map(|gib| gib * GIB).or_else(available) else {
            return Ok(());
        };
        for &case in &study.cases {
            let need = study.memory(case);
            if need > limit {
                let Case { degree, level } = case;
                return Err(Stop::Input(format!(
                    "degree {degree}, level {level} needs about {:.1} GiB of memory, of {:.1} (see --memory-limit and \
                     --levels)",
                    need / GIB,
                    limit / GIB
                )));
            }
        }
        Ok(())
    }
}

/// What the system says is available; None where it does not say.
fn available() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kib: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kib * 1024.0)
}
