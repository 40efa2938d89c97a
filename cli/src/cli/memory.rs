//! What does not fit into memory is refused before it begins.

use super::groups::{self, number};
use regge_terminal::Stop;
use std::fs;

/// Bytes in a GiB.
const GIB: f64 = (1u64 << 30) as f64;

/// How much memory there is.
#[derive(Clone, Debug, clap::Args)]
#[group(skip)]
pub struct Args {
    /// Refuse what is estimated to need more memory than this [default: what the system says is available]
    #[arg(long, global = true, value_name = "GIB", allow_negative_numbers = true, value_parser = positive)]
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
    /// How many bytes there are; None where nothing says.
    fn limit(&self) -> Option<f64> {
        self.memory_limit.map(|gib| gib * GIB).or_else(available)
    }

    /// Are there so many bytes?
    pub fn fits(&self, need: f64) -> bool {
        self.limit().is_none_or(|limit| need <= limit)
    }

    /// Refuses what needs more bytes than there are; `advice` is what else may be done.
    pub fn check(&self, what: &str, need: f64, advice: &str) -> Result<(), Stop> {
        match self.limit().filter(|limit| need > *limit) {
            None => Ok(()),
            Some(limit) => Err(Stop::Input(format!(
                "{what} needs about {} of memory, of {} ({advice}, or --memory-limit if the estimate is wrong)",
                in_words(need),
                in_words(limit),
            ))),
        }
    }
}

/// A number of bytes in the unit that leaves two digits at the least.
fn in_words(bytes: f64) -> String {
    match bytes {
        10e9.. => format!("{:.0} GiB", bytes / GIB),
        1e9.. => format!("{:.1} GiB", bytes / GIB),
        1e6.. => format!("{:.0} MiB", bytes / (GIB / 1024.0)),
        _ => format!("{bytes:.0} bytes"),
    }
}

/// The least of what the system, the shell and the container leave; None where none of them says.
fn available() -> Option<f64> {
    let limits = [
        free(),
        address_space(),
        groups::left(&|file| fs::read_to_string(file).ok()),
    ];
    limits.into_iter().flatten().reduce(f64::min)
}

/// What the system has.
fn free() -> Option<f64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"))?;
    Some(number(line)? * 1024.0)
}

/// What `ulimit -v` leaves. Threads' stacks and the allocator take their part of it too: a quarter is kept for them.
fn address_space() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/limits").ok()?;
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("Max address space"))?;
    let pages = number(&fs::read_to_string("/proc/self/statm").ok()?)?;
    // "unlimited" is no number.
    Some(0.75 * (number(line)? - 4096.0 * pages).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_are_not_nothing() {
        assert_eq!(in_words(2e7), "19 MiB");
        assert_eq!(in_words(1.5 * GIB), "1.5 GiB");
        assert_eq!(in_words(100.0 * GIB), "100 GiB");
        assert_eq!(in_words(1000.0), "1000 bytes");
    }
}
