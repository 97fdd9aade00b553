//! The commands of wingroot, `cargo xtask NAME`: read arguments, call the crates, write and print results.
//!
//! A command is one file in `commands/` with a `run` function and its options in [`args`]; nothing is computed here.
//! Exit status: 0 done, 2 wrong usage or bad input, 3 the computation could not be completed.

use std::process::ExitCode;

use clap::Parser;

pub mod args;
pub mod blind;
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

use args::{Cli, Command, Common};
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
    if let (
        Command::Calibrate(_)
        | Command::Simulate(_)
        | Command::Deflection(_)
        | Command::Discover(_)
        | Command::Hidden(_)
        | Command::Fullaircraft(_)
        | Command::Tunnel(_)
        | Command::Modes(_)
        | Command::Deck(_)
        | Command::Response(_)
        | Command::Flutter(_)
        | Command::Validate(_),
        Some(out),
    ) = (&cli.command, &common.out)
    {
        // Before the work, not after it.
        output::check_replaceable(out)?;
    }
    progress::at_work(common, cli.command.name());
    let ended = dispatch(cli);
    progress::done();
    ended
}

fn dispatch(cli: &Cli) -> Result<(), Failure> {
    let common = &cli.common;
    match &cli.command {
        Command::Calibrate(args) => commands::calibrate::run(args, common),
        Command::Simulate(args) => commands::simulate::run(args, common),
        Command::Deflection(args) => commands::deflection::run(args, common),
        Command::Discover(args) => commands::discover::run(args, common),
        Command::Hidden(args) => commands::hidden::run(args, common),
        Command::Fullaircraft(args) => commands::fullaircraft::run(args, common),
        Command::Pipeline(args) => commands::pipeline::run(args, common),
        Command::Tunnel(args) => commands::tunnel::run(args, common),
        Command::Modes(args) => commands::modes::run(args, common),
        Command::Deck(args) => commands::deck::run(args, common),
        Command::Response(args) => commands::response::run(args, common),
        Command::Flutter(args) => commands::flutter::run(args, common),
        Command::Validate(args) => commands::validate::run(args, common),
        Command::New(args) => commands::new::run(args, common),
        Command::Bench(args) => commands::bench::run(args, common),
        Command::Tidy(args) => commands::tidy::run(args, common),
    }
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
