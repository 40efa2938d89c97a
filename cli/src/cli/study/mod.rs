//! The commands that compute studies, and what they share: a study, computed, shown and written.

pub mod converge;
mod journal;
mod notes;
mod picture;
mod progress;
pub mod reproduce;
mod table;

use super::common::Common;
use super::picture as picture_file;
use progress::Progress;
use regge_study::{Case, Event, Pace, Report, Row, Study, fits};
use regge_terminal::output::{self, Named};
use regge_terminal::{Stop, Voice};
use std::io::{self, Write};
use std::path::PathBuf;

/// A study and where it goes.
pub struct Job {
    /// What is computed.
    pub study: Study,
    /// What it is, for the table's and the picture's head.
    pub title: String,
    /// Where the JSON goes.
    pub json: Option<PathBuf>,
    /// Where the picture goes.
    pub plot: Option<PathBuf>,
    /// Where each row goes at once.
    pub journal: journal::Args,
}

impl Job {
    /// Computes, shows and writes.
    pub fn run(&self, common: &Common) -> Result<(), Stop> {
        self.study
            .check()
            .map_err(|error| Stop::Usage(error.to_string()))?;
        if let Some(path) = &self.plot {
            picture_file::check(path)?;
        }
        output::check_all(&[], &self.files())?;
        self.check_memory(common)?;
        let voice = common.voice(&self.files());
        let rows = self.compute(common, &voice)?;
        let out = &mut voice.out();
        table::fits(out, &fits(&self.study, &rows))?;
        for note in notes::of(&self.study, &rows) {
            writeln!(out, "\n{}", notes::wrapped(&note))?;
        }
        self.write(rows)?;
        writeln!(out)?;
        Ok(output::show_written(out, &self.files())?)
    }

    /// What is written, with the options that name it.
    fn files(&self) -> Vec<Named<'_>> {
        let given = [
            ("--json", &self.json),
            ("--plot", &self.plot),
            ("--rows", self.journal.file()),
        ];
        output::given(given)
    }

    /// Refuses a study that has a row for which memory does not suffice.
    fn check_memory(&self, common: &Common) -> Result<(), Stop> {
        self.study.cases.iter().try_for_each(|&case| {
            let Case { degree, level } = case;
            let what = format!("degree {degree}, level {level}");
            common
                .memory
                .check(&what, self.study.memory(case), "see --levels")
        })
    }

    /// Two cases at once where threads and memory suffice and it helps.
    fn pace(&self, common: &Common) -> Pace {
        let fits = |need| common.memory.fits(need);
        let several = rayon::current_num_threads() > 1;
        match several && self.study.side_by_side().is_some_and(fits) {
            true => Pace::Double,
            false => Pace::Single,
        }
    }

    /// Shows each row as soon as it is there.
    fn compute(&self, common: &Common, voice: &Voice) -> Result<Vec<Row>, Stop> {
        let study = &self.study;
        let (mut journal, earlier) = self.journal.open(study)?;
        let mut out = voice.out();
        writeln!(out, "{}\n", self.title)?;
        table::head(&mut out)?;
        let mut progress = Progress::new(study, voice);
        let mut degree = None;
        let mut stopped: Result<(), Stop> = Ok(());
        let rows = study.resume(&earlier, self.pace(common), &mut |event| {
            progress.show(study, event);
            if let Event::Row(row) = event {
                let gap = degree
                    .replace(row.degree)
                    .is_some_and(|before| before != row.degree);
                let shown = progress.aside(|| show(&mut out, study, row, gap));
                let kept = match &mut journal {
                    Some(journal) if !earlier.iter().any(|e| e.same_case(row)) => journal.line(row),
                    _ => Ok(()),
                };
                let here = kept.and(shown.map_err(Stop::from));
                stopped = std::mem::replace(&mut stopped, Ok(())).and(here);
            }
        });
        drop(progress);
        let rows = rows.map_err(|failure| Stop::Failed(failure.to_string()))?;
        stopped.map(|()| rows)
    }

    fn write(&self, rows: Vec<Row>) -> Result<(), Stop> {
        let report = Report::new(&self.study, rows, command());
        if let Some(path) = &self.json {
            output::json(path, &report)?;
        }
        if let Some(path) = &self.plot {
            picture_file::write(path, picture::svg(&self.study, &report, &self.title))?;
        }
        Ok(())
    }
}

fn show(out: &mut dyn Write, study: &Study, row: &Row, gap: bool) -> io::Result<()> {
    if gap {
        writeln!(out)?;
    }
    table::line(out, study, row)?;
    out.flush()
}

/// The command as it was given.
fn command() -> String {
    let quote = |word: String| match word.contains(char::is_whitespace) {
        true => format!("'{word}'"),
        false => word,
    };
    let words = std::env::args_os()
        .skip(1)
        .map(|word| quote(word.to_string_lossy().into_owned()));
    std::iter::once("regge".to_string())
        .chain(words)
        .collect::<Vec<_>>()
        .join(" ")
}
