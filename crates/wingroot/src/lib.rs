#![doc = include_str!("../README.md")]

use std::process::ExitCode;

use clap::Parser;

pub use {
    aero, calibrate, coupling, discover, free, fullaircraft, hidden, loads, maneuver, nastran, report,
    response, shipped, structure, tunnel,
};

pub mod args;
pub mod blind;
mod cli;
pub mod commands;
pub mod common;
pub mod corrections;
pub mod embedded;
mod ensemble;
pub mod failure;
pub mod fingerprint;
pub mod hdf5;
mod kept_nulls;
pub mod matrices;
pub mod nulls;
pub mod output;
pub mod pages;
mod partitioned;
pub mod paths;
pub mod progress;
pub mod said;
pub mod schemas;
pub mod show;
pub mod store;
pub mod structures;
pub mod sweep;
pub mod version;

use common::Common;
use failure::Failure;
pub use version::VERSION;

/// Reads the command line, runs the command and turns its end into the exit status: 0 done, 2 wrong usage or bad input, 3
/// the computation could not be completed.
pub fn main() -> ExitCode {
    let cli = cli::Cli::parse();
    let command = cli.command.name();
    let results = cli.command.results();
    ended(&cli.common, command, results, || cli.command.run(&cli.common))
}

/// Runs a command with its logging, threads and progress, prints how it failed if it did, and gives the exit status; `results` is
/// the name of the folder that it will write.
pub fn ended(
    common: &Common,
    command: &str,
    results: Option<&str>,
    run: impl FnOnce() -> Result<(), Failure>,
) -> ExitCode {
    show::start(common);
    output::start(common);
    let result = set_threads(common).and_then(|()| {
        if let Some(results) = results {
            // Before the work, not after it.
            output::check_replaceable(&common.out(results))?;
        }
        progress::at_work(common, command);
        let result = run();
        progress::done();
        result
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            show::failure(&failure);
            ExitCode::from(failure.exit_status())
        }
    }
}

/// Into how many parts the matrix library divides its work, whatever the number of threads: the order of its sums, and so
/// the last digits of results, depend on it.
const PARTS_OF_MATRICES: usize = 8;

/// The number of threads of all loops, and the parts of the matrix library's.
fn set_threads(common: &Common) -> Result<(), Failure> {
    divide_matrices();
    let Some(threads) = common.threads else { return Ok(()) };
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global()
        .map_err(|error| Failure::Computation(format!("{threads} threads cannot be started: {error}")))
}

/// Makes results independent of the number of processors; to be called once before any computation.
pub fn divide_matrices() {
    faer::set_global_parallelism(faer::Par::rayon(PARTS_OF_MATRICES));
}
