//! `cargo xtask NAME`: the commands of `wingroot`, handed over to its library, and what only developers need: the house rules,
//! the benchmarks, the published cases.

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use wingroot::args::Common;
use wingroot::failure::Failure;

mod commands;
mod pages;
pub mod repository;
pub mod tidy;

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "xtask", bin_name = "cargo xtask", version = wingroot::VERSION, disable_help_subcommand = true)]
#[command(about = "The commands of wingroot on the repository's example, and those of its developers")]
struct Cli {
    /// What to do.
    #[command(subcommand)]
    command: Task,
    /// Options of every command.
    #[command(flatten)]
    common: Common,
}

/// What can be asked for.
#[derive(Debug, Subcommand)]
enum Task {
    /// A command of the program.
    #[command(flatten)]
    Program(wingroot::commands::Command),
    /// Our results beside every published reference
    Validate(commands::validate::ValidateArgs),
    /// Intervals of calibrated wings beside wings that another program made
    Trust(commands::trust::TrustArgs),
    /// Time of the main steps
    Bench(commands::bench::BenchArgs),
    /// A folder of users' Nastran decks, each run as it asks, and a table of what became of them
    Decks(commands::decks::DecksArgs),
    /// Small faults put in one at a time, and the share that a crate's own tests catch
    Mutants(commands::mutants::MutantsArgs),
    /// Check the house rules of the repository
    Tidy(commands::tidy::TidyArgs),
}

impl Task {
    /// Its name, and the folder of results that it writes.
    fn described(&self) -> (&'static str, Option<&'static str>) {
        match self {
            Self::Program(command) => (command.name(), command.results()),
            Self::Validate(_) => ("validate", Some("validate")),
            Self::Trust(_) => ("trust", Some("trust")),
            Self::Bench(_) => ("bench", Some("bench")),
            Self::Decks(options) => ("decks", options.path.is_dir().then_some("decks")),
            Self::Mutants(_) => ("mutants", Some("mutants")),
            Self::Tidy(_) => ("tidy", None),
        }
    }

    fn run(&self, common: &Common) -> Result<(), Failure> {
        match self {
            Self::Program(command) => command.run(common),
            Self::Validate(options) => commands::validate::run(options, common),
            Self::Trust(options) => commands::trust::run(options, common),
            Self::Bench(options) => commands::bench::run(options, common),
            Self::Decks(options) => commands::decks::run(options, common),
            Self::Mutants(options) => commands::mutants::run(options, common),
            Self::Tidy(options) => commands::tidy::run(options, common),
        }
    }
}

/// Reads the command line, runs the command and turns its end into the exit status.
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    wingroot::paths::start_from(repository::path("data"));
    let (name, results) = cli.command.described();
    wingroot::ended(&cli.common, name, results, || cli.command.run(&cli.common))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent_and_has_every_command_of_the_program() {
        Cli::command().debug_assert();
        for name in ["pipeline", "calibrate", "new", "tidy", "bench", "validate", "decks"] {
            assert!(Cli::command().find_subcommand(name).is_some(), "{name}");
        }
    }
}
