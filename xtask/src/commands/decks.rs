//! `decks`: a folder of users' Nastran decks, each run as its executive control asks, and a table of what became of them.
//!
//! Every deck runs in a process of its own, so that a panic, a hang or a memory that grows without end is a row of the table and not
//! the end of it. What a program of ours cannot run yet as asked (buckling, dynamic response) is read and assembled, and its
//! constrained stiffness factorised.

use super::{decks_broken, decks_factorised};
use clap::Args;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use nastran::{Analysis, InputError, Solution};
use report::Table;
use serde::Serialize;
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::{progress, show};

/// Options of `decks`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask decks ~/decks
  cargo xtask decks ~/decks --list ~/decks.txt --seconds 30
  cargo xtask decks ~/decks --broken 200
  cargo xtask decks ~/decks/wing.bdf")]
pub(crate) struct DecksArgs {
    /// A folder of decks; or one deck, which is read, assembled and factorised in this process
    #[arg(value_name = "DIR")]
    pub(crate) path: PathBuf,
    /// Names of the decks, relative to the folder, one a line [default: all files with an executive control]
    #[arg(long, value_name = "FILE")]
    pub(crate) list: Option<PathBuf>,
    /// Longest time of a deck, s
    #[arg(long, value_name = "S", default_value_t = 60)]
    pub(crate) seconds: u64,
    /// Run this many broken and mixed decks that are made from those of the folder, in their place
    #[arg(long, value_name = "N")]
    pub(crate) broken: Option<usize>,
    /// Largest memory of a deck, megabytes
    #[arg(long, value_name = "MB", default_value_t = 4000)]
    pub(crate) megabytes: u64,
}

/// How many decks run at a time.
const TOGETHER: usize = 2;
/// How often a deck at work is looked at.
const LOOK: Duration = Duration::from_millis(20);
/// Bytes of a page of memory, in which Linux counts.
const PAGE_BYTES: u64 = 4096;

/// What became of a deck.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
enum Status {
    /// Exit status 0.
    Solved,
    /// Exit status 2: one sentence says why.
    Refused,
    /// Exit status 3.
    NotComputed,
    /// Its executive control asks for what wingroot is not for; nothing was run.
    NotOurs,
    /// It ended in another way.
    Panicked,
    /// It took too long.
    TooLong,
    /// It took too much memory.
    TooLarge,
}

/// A row of the table.
#[derive(Debug, Clone, Serialize)]
struct Row {
    /// The deck, relative to the folder.
    deck: String,
    /// SOL.
    asked: String,
    /// The command that ran.
    ran: String,
    /// What became of it.
    status: Status,
    /// What was said last: the sentence of a refusal, or nothing.
    sentence: String,
    /// Wall clock.
    seconds: f64,
}

/// Runs the command.
pub(crate) fn run(args: &DecksArgs, common: &Common) -> Result<(), Failure> {
    if args.path.is_file() {
        return decks_factorised::factorised(&args.path, common);
    }
    let start = Instant::now();
    let scratch = std::env::temp_dir().join(format!("decks-{}", std::process::id()));
    let (names, args) = &asked(args, &scratch)?;
    let bar = progress::bar(common, names.len(), "decks");
    let next = AtomicUsize::new(0);
    let folder = ResultFolder::begin(&common.out("decks"))?;
    let work = |worker: usize| {
        let mut rows = Vec::new();
        while let Some(name) = names.get(next.fetch_add(1, Ordering::Relaxed)) {
            rows.push(row(args, name, &scratch.join(worker.to_string())));
            bar.inc(1);
        }
        rows
    };
    let mut rows: Vec<Row> = std::thread::scope(|scope| {
        let work = &work;
        let workers: Vec<_> = (0..TOGETHER).map(|worker| scope.spawn(move || work(worker))).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap_or_default()).collect()
    });
    progress::end(&bar);
    // Results of single decks are of no use; what is left of them does not matter.
    let _ = std::fs::remove_dir_all(&scratch);
    rows.sort_by(|a, b| a.deck.cmp(&b.deck));
    let mut counts: BTreeMap<Status, usize> = BTreeMap::new();
    for row in &rows {
        *counts.entry(row.status).or_default() += 1;
    }
    folder.write_text("table.csv", &csv(&rows))?;
    folder.write_json(
        "result.json",
        &serde_json::json!({ "command": "decks", "decks": rows, "counts": counts }),
    )?;
    let out = folder.commit()?;
    let said: Vec<String> =
        counts.iter().map(|(status, count)| format!("{count} {}", words(*status))).collect();
    let text = format!(
        "{}{} decks: {}\nwritten to {} in {:.0} s",
        table(&rows),
        rows.len(),
        said.join(", "),
        out.display(),
        start.elapsed().as_secs_f64()
    );
    show::summary(common, &text);
    show::json(common, &serde_json::json!({ "command": "decks", "counts": counts }))?;
    let bad = rows.iter().filter(|row| row.status >= Status::Panicked).count();
    if bad == 0 {
        Ok(())
    } else {
        Err(Failure::Computation(format!("{bad} decks did not end by themselves or panicked")))
    }
}

/// The decks to run and where they are: those of the folder, or broken ones made of them.
fn asked(args: &DecksArgs, scratch: &Path) -> Result<(Vec<String>, DecksArgs), Failure> {
    let names = names(args)?;
    let Some(count) = args.broken else { return Ok((names, args.clone())) };
    let path = scratch.join("broken");
    let made = decks_broken::broken(&args.path, &names, &path, count)?;
    Ok((made, DecksArgs { path, ..args.clone() }))
}

fn words(status: Status) -> &'static str {
    match status {
        Status::Solved => "solved",
        Status::Refused => "refused",
        Status::NotComputed => "not computed",
        Status::NotOurs => "not ours",
        Status::Panicked => "panicked",
        Status::TooLong => "too long",
        Status::TooLarge => "too large",
    }
}

/// The decks of the list, or all files of the folder and those below that begin with an executive control.
fn names(args: &DecksArgs) -> Result<Vec<String>, Failure> {
    if let Some(list) = &args.list {
        return Ok(nastran::read_text(list)?
            .lines()
            .map(str::trim)
            .filter(|name| !name.is_empty())
            .map(str::to_owned)
            .collect());
    }
    let mut names = Vec::new();
    let mut folders = vec![args.path.clone()];
    while let Some(folder) = folders.pop() {
        let entries = std::fs::read_dir(&folder)
            .map_err(|error| InputError::in_file(&folder, format!("the folder cannot be read: {error}")))?;
        for path in entries.flatten().map(|entry| entry.path()) {
            if path.is_dir() {
                folders.push(path);
            } else if is_deck(&path)
                && Solution::of_file(&path).is_ok_and(|solution| solution.is_some())
                && let Ok(name) = path.strip_prefix(&args.path)
            {
                names.push(name.to_string_lossy().into_owned());
            }
        }
    }
    names.sort();
    Ok(names)
}

/// Whether a file may be a deck: what Nastran prints repeats the executive control.
fn is_deck(path: &Path) -> bool {
    let extension = path.extension().map(std::ffi::OsStr::to_ascii_lowercase);
    extension.is_none_or(|extension| !["f06", "f04", "log", "op2"].iter().any(|print| extension == *print))
}

/// Runs a deck.
fn row(args: &DecksArgs, name: &str, scratch: &Path) -> Row {
    let start = Instant::now();
    let path = args.path.join(name);
    let solution = Solution::of_file(&path).ok().flatten();
    let asked = solution.as_ref().map_or_else(String::new, |solution| solution.name.clone());
    let analysis = solution.map_or(Analysis::Modes, |solution| solution.analysis);
    let row = |ran: &str, status: Status, sentence: String| {
        let seconds = start.elapsed().as_secs_f64();
        Row { deck: name.to_owned(), asked: asked.clone(), ran: ran.to_owned(), status, sentence, seconds }
    };
    let Some(ran) = command(analysis) else {
        return row("", Status::NotOurs, format!("SOL {asked} is none of wingroot's"));
    };
    let mut program = match std::env::current_exe() {
        Ok(program) => Command::new(program),
        Err(error) => return row(ran, Status::NotComputed, error.to_string()),
    };
    program.arg(ran);
    if ran != "decks" {
        program.arg("--deck");
    }
    program.arg(&path).arg("--out").arg(scratch).env("RUST_BACKTRACE", "0");
    let child = program.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    match child {
        Ok(child) => {
            let (status, sentence) = watched(child, args);
            row(ran, status, sentence)
        }
        Err(error) => row(ran, Status::NotComputed, error.to_string()),
    }
}

/// The command that runs what a deck asks for; `decks` itself where there is none yet, nothing where there will be none.
fn command(analysis: Analysis) -> Option<&'static str> {
    match analysis {
        Analysis::Other | Analysis::Optimisation => None,
        Analysis::Statics | Analysis::NonlinearStatics => Some("statics"),
        Analysis::Buckling => Some("decks"),
        Analysis::Modes | Analysis::Response => Some("modes"),
        Analysis::Gust => Some("gust"),
        Analysis::Flutter => Some("flutter"),
        Analysis::Trim => Some("fullaircraft"),
    }
}

/// Waits for a deck, or ends it when its time or memory is used up.
fn watched(mut child: Child, args: &DecksArgs) -> (Status, String) {
    let start = Instant::now();
    let stderr = child.stderr.take();
    // Read beside: a full pipe would stop the child.
    let reader = std::thread::spawn(move || {
        stderr.and_then(|mut pipe| std::io::read_to_string(&mut pipe).ok()).unwrap_or_default()
    });
    let ended = loop {
        match child.try_wait() {
            Ok(Some(status)) => {
                break match status.code() {
                    Some(0) => Status::Solved,
                    Some(2) => Status::Refused,
                    Some(3) => Status::NotComputed,
                    _ => Status::Panicked,
                };
            }
            Ok(None) if start.elapsed().as_secs() >= args.seconds => break Status::TooLong,
            Ok(None) if memory_bytes(child.id()) > args.megabytes * 1_000_000 => break Status::TooLarge,
            Ok(None) => std::thread::sleep(LOOK),
            Err(_) => break Status::Panicked,
        }
    };
    // Of one that has ended this does nothing.
    let _ = child.kill();
    let _ = child.wait();
    (
        ended,
        if ended == Status::Solved { String::new() } else { sentence(&reader.join().unwrap_or_default()) },
    )
}

/// The memory that a process has, where the system tells (Linux); zero elsewhere.
fn memory_bytes(process: u32) -> u64 {
    let statm = std::fs::read_to_string(format!("/proc/{process}/statm")).unwrap_or_default();
    statm.split(' ').nth(1).and_then(|pages| pages.parse::<u64>().ok()).unwrap_or(0) * PAGE_BYTES
}

/// What a failure says: the line of the error, or of the panic, without the picture of the source line.
fn sentence(text: &str) -> String {
    let lines = || text.lines().map(str::trim).filter(|line| !line.is_empty());
    let error = lines().find_map(|line| line.strip_prefix("error: "));
    let panic = lines().skip_while(|line| !line.contains("panicked at")).nth(1);
    error.or(panic).or_else(|| lines().next_back()).unwrap_or_default().to_owned()
}

fn table(rows: &[Row]) -> String {
    let mut table = Table::new(&["deck", "SOL", "ran", "status", "s", "sentence"]);
    for row in rows {
        let sentence: String = row.sentence.chars().take(100).collect();
        let seconds = format!("{:.1}", row.seconds);
        table.row([
            row.deck.clone(),
            row.asked.clone(),
            row.ran.clone(),
            words(row.status).to_owned(),
            seconds,
            sentence,
        ]);
    }
    table.to_string()
}

fn csv(rows: &[Row]) -> String {
    let mut text = String::from("deck,asked,ran,status,seconds,sentence\n");
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    for row in rows {
        let sentence = quoted(&row.sentence);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{:.2},{sentence}",
            quoted(&row.deck),
            quoted(&row.asked),
            row.ran,
            words(row.status),
            row.seconds
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sentence_of_a_failure_is_its_error_or_its_panic() {
        let error =
            "note: cards that are not read: 1 EIGRL\nerror: a.bdf:3:1: no GRID\n  picture\nhint: add it\n";
        assert_eq!(sentence(error), "a.bdf:3:1: no GRID");
        let panic = "thread 'main' panicked at src/a.rs:1:2:\nindex out of bounds\nnote: run with\n";
        assert_eq!(sentence(panic), "index out of bounds");
        assert_eq!(sentence(""), "");
    }

    #[test]
    fn a_process_that_does_not_end_is_ended_and_one_that_takes_too_much_memory_as_well() {
        let sleeper = || Command::new("sleep").arg("20").stderr(Stdio::piped()).spawn();
        let args = DecksArgs { path: PathBuf::new(), list: None, seconds: 0, broken: None, megabytes: 4000 };
        let Ok(child) = sleeper() else { return };
        assert_eq!(watched(child, &args).0, Status::TooLong);
        if cfg!(target_os = "linux") {
            let child = sleeper().expect("it has run before");
            assert_eq!(watched(child, &DecksArgs { seconds: 20, megabytes: 0, ..args }).0, Status::TooLarge);
        }
    }
}
