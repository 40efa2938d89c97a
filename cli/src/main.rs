//! The command line `regge`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
