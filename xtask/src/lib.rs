//! The commands of wingroot, `cargo xtask NAME`: read arguments, call the crates, write and print results.
//!
//! A command is one file in `commands/` with its options and a `run` function, and a line of the list in `commands/mod.rs`; nothing is computed here.
//! Exit status: 0 done, 2 wrong usage or bad input, 3 the computation could not be completed.

use std::process::ExitCode;

use clap::Parser;

pub mod args;
pub mod blind;
mod cli;
mod commands;
mod corrections;
pub mod failure;
pub mod hdf5;
pub mod nulls;
pub mod output;
pub mod pages;
pub mod paths;
pub mod progress;
pub mod show;
pub mod structures;
pub mod tidy;

use args::Common;
use cli::Cli;
use failure::Failure;

/// Reads the command line, runs the command and turns its end into the exit status.
pub fn main() -> ExitCode {
    let cli = Cli::parse();
    show::start_logging(&cli.common);
    match set_threads(&cli.common).and_then(|()| run(&cli)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            show::failure(&failure);
            ExitCode::from(failure.exit_status())
        }
    }
}

fn run(cli: &Cli) -> Result<(), Failure> {
    let common = &cli.common;
    if let Some(out) = common.out.as_deref().filter(|_| cli.command.replaces_results()) {
        // Before the work, not after it.
        output::check_replaceable(out)?;
    }
    progress::at_work(common, cli.command.name());
    let ended = cli.command.run(common);
    progress::done();
    ended
}

/// Into how many parts the matrix library divides its work, whatever the number of threads: the order of its sums, and so
/// the last digits of results, depend on it.
const PARTS_OF_MATRICES: usize = 8;

/// The number of threads of all loops, and the parts of the matrix library's.
fn set_threads(common: &Common) -> Result<(), Failure> {
    faer::set_global_parallelism(faer::Par::rayon(PARTS_OF_MATRICES));
    let Some(threads) = common.threads else { return Ok(()) };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .map_err(|error| Failure::Computation(format!("{threads} threads cannot be started: {error}")))
}
