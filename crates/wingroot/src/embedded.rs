//! Commands inside another program, such as Python: the words of the command line go in; nothing is printed, and what would have
//! been is handed back.

use std::sync::{Mutex, PoisonError};

use clap::Parser;
use nastran::InputError;

use crate::cli::Cli;
use crate::failure::Failure;
use crate::said::{self, Said};
use crate::{output, paths, progress, show};

/// One command at a time: each uses all processors, and what is said belongs to one.
static AT_WORK: Mutex<()> = Mutex::new(());

/// Runs a command, given as its name and options; waits until another one is done.
///
/// # Errors
/// Words that are no command, bad input, or a computation that could not be completed.
pub fn run(words: &[String]) -> (Result<(), Failure>, Said) {
    let _alone = AT_WORK.lock().unwrap_or_else(PoisonError::into_inner);
    let words = std::iter::once("wingroot").chain(words.iter().map(String::as_str));
    let cli = match Cli::try_parse_from(words) {
        Ok(cli) => cli,
        Err(error) => return (Err(InputError::general(error.to_string()).into()), Said::default()),
    };
    paths::forget();
    said::collect();
    show::start(&cli.common);
    output::start(&cli.common);
    progress::watched(cli.command.name());
    let replaceable = |results| output::check_replaceable(&cli.common.out(results));
    let checked = cli.command.results().map_or(Ok(()), replaceable);
    let result = checked.and_then(|()| cli.command.run(&cli.common));
    progress::done();
    (result, said::collected())
}
