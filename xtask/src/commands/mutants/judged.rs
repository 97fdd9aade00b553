//! Mutants judged by tests: those that reach one are run with its switch on until one fails.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use rayon::prelude::*;
use wingroot::failure::Failure;

use super::tree::Built;
use crate::repository;

/// A test that takes so many times as long as without a mutant, and so much longer, hangs.
const LONGEST: (u32, Duration) = (10, Duration::from_secs(20));

/// A test of the crate.
struct Test<'a> {
    program: &'a Path,
    name: String,
    took: Duration,
    /// Mutants that it reaches.
    reaches: BTreeSet<usize>,
}

/// Numbers of the mutants that no test catches, of those that together take no longer than `most` without a mutant.
///
/// # Errors
/// If a program does not start, or a test fails without a mutant.
pub(super) fn missed(built: &Built, most: Duration) -> Result<Vec<usize>, Failure> {
    let mut tests = tests(built)?;
    tests.sort_by_key(|test| test.took);
    let missed = built.inside.par_iter().map(|&mutant| Ok((mutant, is_caught(built, &tests, mutant, most)?)));
    let judged: Vec<(usize, bool)> = missed.collect::<Result<_, Failure>>()?;
    Ok(judged.into_iter().filter(|(_, caught)| !caught).map(|(mutant, _)| mutant).collect())
}

/// All tests, each run alone once without a mutant.
fn tests(built: &Built) -> Result<Vec<Test<'_>>, Failure> {
    let mut names = Vec::new();
    for program in &built.programs {
        let output = Command::new(program).args(["--list", "--format", "terse"]).output().map_err(text_of)?;
        let listed = String::from_utf8_lossy(&output.stdout).into_owned();
        let of_program = listed.lines().filter_map(|line| line.strip_suffix(": test"));
        names.extend(of_program.map(|name| (program.as_path(), name.to_owned())));
    }
    let reached = repository::path("target/mutants/reached");
    std::fs::create_dir_all(&reached).map_err(text_of)?;
    let tests = names.into_par_iter().enumerate().map(|(index, (program, name))| {
        let file = std::path::absolute(reached.join(index.to_string())).map_err(text_of)?;
        _ = std::fs::remove_file(&file);
        let mut command = started(built, program, &[&name]);
        let begun = Instant::now();
        let passed = command.env("WINGROOT_REACHED", &file).status().map_err(text_of)?.success();
        if !passed {
            return Err(Failure::Computation(format!("{name} fails without a mutant")));
        }
        let numbers = std::fs::read_to_string(&file).unwrap_or_default();
        let reaches = numbers.lines().filter_map(|line| line.parse().ok()).collect();
        Ok(Test { program, name, took: begun.elapsed(), reaches })
    });
    tests.collect()
}

/// Whether a test fails or hangs with a mutant: first the quickest alone, then more and more in one process.
fn is_caught(built: &Built, tests: &[Test<'_>], mutant: usize, most: Duration) -> Result<bool, Failure> {
    let mut together = Duration::ZERO;
    let quick = |test: &&Test<'_>| {
        together += test.took;
        together <= most
    };
    let reaching = tests.iter().filter(|test| test.reaches.contains(&mutant));
    let reaching: Vec<&Test<'_>> = reaching.take_while(quick).collect();
    let (mut at, mut size) = (0, 1);
    while at < reaching.len() {
        let some = &reaching[at..(at + size).min(reaching.len())];
        for program in &built.programs {
            let of_program: Vec<&&Test<'_>> = some.iter().filter(|test| test.program == program).collect();
            if !of_program.is_empty() && !passes(built, program, &of_program, mutant)? {
                return Ok(true);
            }
        }
        at += size;
        size *= 2;
    }
    Ok(false)
}

fn passes(built: &Built, program: &Path, tests: &[&&Test<'_>], mutant: usize) -> Result<bool, Failure> {
    let names: Vec<&str> = tests.iter().map(|test| test.name.as_str()).collect();
    let mut child = started(built, program, &names)
        .env("WINGROOT_MUTANT", mutant.to_string())
        .spawn()
        .map_err(text_of)?;
    let longest = tests.iter().map(|test| test.took).sum::<Duration>() * LONGEST.0 + LONGEST.1;
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait().map_err(text_of)? {
            return Ok(status.success());
        }
        if begun.elapsed() > longest {
            child.kill().and_then(|()| child.wait()).map_err(text_of)?;
            return Ok(false);
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Exactly these tests, in silence. A loop that a mutant has made endless must not take the machine's memory.
fn started(built: &Built, program: &Path, names: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", "ulimit -v 8388608; exec \"$0\" --exact \"$@\""]).arg(program).args(names);
    command.current_dir(&built.folder);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn text_of(error: impl std::fmt::Display) -> Failure {
    Failure::Computation(error.to_string())
}
