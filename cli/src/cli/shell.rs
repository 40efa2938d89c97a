//! Completions for shells and pages for man, made from the arguments themselves.

use clap::Command;
use clap_complete::Shell;
use regge_terminal::{Stop, output};
use std::fs;
use std::path::PathBuf;

/// Write what a shell needs to complete arguments to standard output.
#[derive(clap::Args)]
#[command(
    after_help = "Example: regge completions bash > ~/.local/share/bash-completion/completions/regge"
)]
pub struct Completions {
    /// For which shell
    shell: Shell,
}

/// Write a page for man for every command.
#[derive(clap::Args)]
#[command(after_help = "Example: regge man ~/.local/share/man/man1")]
pub struct Man {
    /// The folder that they go to; it is made if it is not there
    folder: PathBuf,
}

impl Completions {
    /// Runs the command for these arguments.
    pub fn run(self, mut program: Command) -> Result<(), Stop> {
        let (name, mut text) = (program.get_name().to_owned(), Vec::new());
        clap_complete::generate(self.shell, &mut program, name, &mut text);
        output::write_by("-".as_ref(), |out| out.write_all(&text))
    }
}

impl Man {
    /// Runs the command for these arguments.
    pub fn run(self, mut program: Command) -> Result<(), Stop> {
        let failed = |error| Stop::Failed(format!("{}: {error}", self.folder.display()));
        fs::create_dir_all(&self.folder).map_err(failed)?;
        // So that the options of every command are in every page.
        program.build();
        let name = program.get_name().to_owned();
        let commands = program.get_subcommands().filter(|of| !of.is_hide_set());
        let commands = commands.filter(|of| of.get_name() != "help").cloned();
        let named = |of: Command| {
            let page = format!("{name}-{}", of.get_name());
            // A command's name lives as long as the program, which ends soon.
            of.name(&*page.leak())
        };
        let pages: Vec<Command> = commands.map(named).collect();
        for page in std::iter::once(program).chain(pages) {
            let file = self.folder.join(format!("{}.1", page.get_name()));
            let page = clap_mangen::Man::new(page);
            output::write_by(&file, |mut out| page.render(&mut out))?;
        }
        Ok(())
    }
}
