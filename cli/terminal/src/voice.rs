//! How much a program says, and where.

use super::bar::Bar;
use super::out::Out;
use std::io::{self, Write};
use std::sync::Mutex;
use std::time::Instant;

/// The options of every command that say how much is said.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
#[group(skip)]
pub struct Loudness {
    /// Say nothing but what is wrong
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    quiet: bool,
    /// Say on standard error what is being done, and how long it took
    #[arg(short, long, global = true)]
    verbose: bool,
}

/// What speaks to the user: results on standard output, progress and notes on standard error.
pub struct Voice {
    loudness: Loudness,
    /// Is standard output for a file?
    output_is_taken: bool,
}

impl Loudness {
    /// The voice of a command; results go to standard error where standard output is for a file.
    pub fn voice(self, output_is_taken: bool) -> Voice {
        Voice {
            loudness: self,
            output_is_taken,
        }
    }
}

impl Voice {
    /// Where results are shown.
    pub fn out(&self) -> Out {
        match (self.loudness.quiet, self.output_is_taken) {
            (true, _) => Out::nowhere(),
            (false, true) => Out::error(),
            (false, false) => Out::new(),
        }
    }

    /// Something to know beside the results, in a line.
    pub fn note(&self, text: &str) {
        if !self.loudness.quiet {
            say(&format!("note: {text}"));
        }
    }

    /// A bar of this length, in whatever unit.
    pub fn bar(&self, length: u64) -> Bar {
        match self.loudness {
            Loudness { quiet: true, .. } | Loudness { verbose: true, .. } => Bar::hidden(length),
            _ => Bar::new(length),
        }
    }

    /// The phases of a command, about so many.
    pub fn phases(&self, about: u64) -> Phases {
        Phases {
            bar: self.bar(about),
            about,
            spoken: self.loudness.verbose,
            last: Mutex::new(None),
        }
    }
}

/// What a command is doing: as a bar, or for those who want to hear it in a line with the time that it took.
pub struct Phases {
    bar: Bar,
    about: u64,
    spoken: bool,
    last: Mutex<Option<(String, Instant)>>,
}

impl Phases {
    /// Something else begins.
    pub fn begin(&self, what: &str) {
        self.bar.advance(self.about, what);
        self.next(Some(what));
    }

    fn next(&self, what: Option<&str>) {
        let begun = what.map(|what| (what.to_owned(), Instant::now()));
        let mut last = super::bar::locked(&self.last);
        if let Some((what, since)) = std::mem::replace(&mut *last, begun).filter(|_| self.spoken) {
            say(&format!("{:9.3} s  {what}", since.elapsed().as_secs_f64()));
        }
    }
}

impl Drop for Phases {
    fn drop(&mut self) {
        self.next(None);
    }
}

/// Nothing is left to be done where standard error cannot be written.
fn say(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{line}");
}
