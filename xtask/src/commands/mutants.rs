//! `mutants`: small faults put in one at a time by `cargo mutants`, and the share that a crate's own tests catch.

use clap::Args;
use std::process::Command;

use loads::compare::statistics::wilson;
use nastran::InputError;
use serde::{Deserialize, Serialize};
use serde_json::json;
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::show;

use crate::repository;

/// Options of `mutants`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask mutants --crates structure --sample 40
  cargo xtask mutants --seed 3 --write

Needs cargo-mutants (cargo install cargo-mutants --locked). A mutant takes a build of its crate and a run of its tests.
Equivalent mutants, which change nothing that can be seen, are listed with their reasons in .cargo/mutants.toml.")]
pub(crate) struct MutantsArgs {
    /// Crates, by comma [default: all of the table in docs/testing.md]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) crates: Vec<String>,
    /// About so many mutants of a crate: every k-th of its list
    #[arg(long, value_name = "N", default_value_t = 150)]
    pub(crate) sample: usize,
    /// Which of every k, counted round
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(crate) seed: usize,
    /// Put the rows into docs/testing.md, in place of earlier ones of these crates
    #[arg(long)]
    pub(crate) write: bool,
}

/// What is mutated, by crate: all of it, or some files.
const CRATES: [(&str, &[&str]); 8] = [
    ("aero", &[]),
    ("structure", &[]),
    ("coupling", &[]),
    ("calibrate", &[]),
    ("maneuver", &[]),
    ("fullaircraft", &[]),
    (
        "discover",
        &[
            "search.rs",
            "rank.rs",
            "trial.rs",
            "backward_step.rs",
            "consistency.rs",
            "distinguish.rs",
            "shared.rs",
        ],
    ),
    ("hidden", &["score/*.rs"]),
];

/// Tests of a mutant end after so long, s: it is caught then, as one that fails.
const LONGEST_S: &str = "900";

/// Around the table of docs/testing.md.
const MARKS: [&str; 2] = ["<!-- kill rate: begin -->\n", "<!-- kill rate: end -->\n"];

/// A crate's row.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    name: String,
    mutants: usize,
    /// Every so many of them was tried, from this one on.
    every: usize,
    from: usize,
    caught: usize,
    missed: Vec<String>,
    unviable: usize,
}

/// `outcomes.json` of cargo-mutants, as far as it is read.
#[derive(Debug, Deserialize)]
struct Outcomes {
    outcomes: Vec<Outcome>,
}

#[derive(Debug, Deserialize)]
struct Outcome {
    scenario: serde_json::Value,
    summary: String,
}

/// Runs the command.
pub(crate) fn run(args: &MutantsArgs, common: &Common) -> Result<(), Failure> {
    let unknown = args.crates.iter().find(|name| !CRATES.iter().any(|(known, _)| known == name));
    if let Some(name) = unknown {
        let known: Vec<&str> = CRATES.iter().map(|(name, _)| *name).collect();
        let error = InputError::general(format!("--crates: no crate {name} is in the list"));
        return Err(error.with_help(format!("take some of {}", known.join(", "))).into());
    }
    let folder = ResultFolder::begin(&common.out("mutants"))?;
    let wanted =
        CRATES.iter().filter(|(name, _)| args.crates.is_empty() || args.crates.iter().any(|one| one == name));
    let mut rows = Vec::new();
    for (name, files) in wanted {
        let row = row(args, name, files)?;
        show::summary(common, &format!("{}\n", line(&row)));
        rows.push(row);
    }
    let result = json!({ "command": "mutants", "rows": rows });
    folder.write_json("result.json", &result)?;
    folder.commit()?;
    if args.write {
        let path = repository::path("docs/testing.md");
        let text = nastran::read_text(&path)?;
        let text = with_rows(&text, &rows).ok_or_else(|| {
            InputError::in_file(
                &path,
                format!("the lines {} and {} are not there", MARKS[0].trim(), MARKS[1].trim()),
            )
        })?;
        std::fs::write(&path, text).map_err(|error| Failure::Computation(error.to_string()))?;
    }
    show::json(common, &result)
}

/// Lists a crate's mutants, tries every k-th and counts.
fn row(args: &MutantsArgs, name: &str, files: &[&str]) -> Result<Row, Failure> {
    let folder = repository::path("target/mutants").join(name);
    std::fs::create_dir_all(&folder).map_err(|error| Failure::Computation(error.to_string()))?;
    let listed = output(mutants(name, files).args(["--list", "--json"]))?;
    let all: Vec<serde_json::Value> = serde_json::from_str(&listed)
        .map_err(|error| Failure::Computation(format!("the list of cargo-mutants: {error}")))?;
    let every = (all.len() / args.sample.max(1)).max(1);
    let from = args.seed % every;
    // the tree is copied for each run, what is compiled stays
    let target = std::path::absolute(repository::path("target/mutants/target"))
        .map_err(|error| Failure::Computation(error.to_string()))?;
    let shard = format!("{from}/{every}");
    let status = mutants(name, files)
        .args(["--shard", &shard, "--sharding", "round-robin", "--no-shuffle", "--profile", "mutants"])
        .args(["--timeout", LONGEST_S, "--output"])
        .arg(&folder)
        .env("CARGO_TARGET_DIR", target)
        .stdout(std::process::Stdio::null())
        .status()
        .map_err(not_there)?;
    // 2: some were missed, 3: some took too long; anything else tried nothing
    if !matches!(status.code(), Some(0 | 2 | 3)) {
        return Err(Failure::Computation(format!(
            "cargo-mutants did not get through {name}; what it says is in {}",
            folder.join("mutants.out/log").display()
        )));
    }
    let path = folder.join("mutants.out/outcomes.json");
    counted(name, &nastran::read_text(&path)?, [all.len(), every, from])
        .ok_or_else(|| InputError::in_file(&path, "this is no outcomes.json of cargo-mutants").into())
}

fn mutants(name: &str, files: &[&str]) -> Command {
    let mut command = Command::new("cargo");
    command.current_dir(repository::path(".")).args(["mutants", "--package", &format!("wingroot-{name}")]);
    for file in files {
        command.arg("--file").arg(format!("crates/{name}/src/{file}"));
    }
    command
}

fn output(command: &mut Command) -> Result<String, Failure> {
    let output = command.output().map_err(not_there)?;
    if output.status.success() {
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(if said.contains("no such command") { not_there(said) } else { Failure::Computation(said) })
}

fn not_there(error: impl std::fmt::Display) -> Failure {
    let message =
        format!("cargo mutants cannot be started: {}", error.to_string().lines().next().unwrap_or_default());
    InputError::general(message).with_help("install it with `cargo install cargo-mutants --locked`").into()
}

/// A row from the text of `outcomes.json`.
fn counted(name: &str, outcomes: &str, [mutants, every, from]: [usize; 3]) -> Option<Row> {
    let Outcomes { outcomes } = serde_json::from_str(outcomes).ok()?;
    let mut row =
        Row { name: name.to_owned(), mutants, every, from, caught: 0, missed: Vec::new(), unviable: 0 };
    for Outcome { scenario, summary } in outcomes {
        let Some(mutant) = scenario.get("Mutant") else { continue };
        match summary.as_str() {
            "CaughtMutant" | "Timeout" => row.caught += 1,
            "MissedMutant" => row.missed.push(mutant["name"].as_str().unwrap_or_default().to_owned()),
            _ => row.unviable += 1,
        }
    }
    Some(row)
}

/// `| crate | caught | of | share | 95 % from | every |`
fn line(row: &Row) -> String {
    let Row { name, mutants, every, caught, missed, .. } = row;
    let tried = caught + missed.len();
    let share = wilson(*caught, tried);
    format!(
        "| {name} | {caught} of {tried} | {:.2} | {:.2} | one in {every} of {mutants} |",
        share.value, share.low
    )
}

/// The text with new rows in its table, in the order of [`CRATES`]; none without the marks.
fn with_rows(text: &str, rows: &[Row]) -> Option<String> {
    let (head, rest) = text.split_once(MARKS[0])?;
    let (table, tail) = rest.split_once(MARKS[1])?;
    let name_of = |line: &str| line.split('|').nth(1).map(|cell| cell.trim().to_owned());
    let line_of = |name: &str| {
        let new = rows.iter().find(|row| row.name == name).map(line);
        new.or_else(|| table.lines().find(|line| name_of(line).as_deref() == Some(name)).map(str::to_owned))
    };
    let mut lines: Vec<String> = table.lines().take(2).map(str::to_owned).collect();
    lines.extend(CRATES.iter().filter_map(|(name, _)| line_of(name)));
    Some(format!("{head}{}{}\n{}{tail}", MARKS[0], lines.join("\n"), MARKS[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTCOMES: &str = r#"{"outcomes": [
        {"scenario": "Baseline", "summary": "Success"},
        {"scenario": {"Mutant": {"name": "replace + with - in a"}}, "summary": "CaughtMutant"},
        {"scenario": {"Mutant": {"name": "replace * with / in b"}}, "summary": "MissedMutant"},
        {"scenario": {"Mutant": {"name": "replace < with <= in c"}}, "summary": "Timeout"},
        {"scenario": {"Mutant": {"name": "replace d -> f64 with 0.0"}}, "summary": "Unviable"}
    ]}"#;

    #[test]
    fn what_fails_or_hangs_is_caught_and_what_does_not_compile_does_not_count() {
        let row = counted("aero", OUTCOMES, [400, 100, 1]).expect("it is one");
        assert_eq!((row.caught, row.unviable), (2, 1));
        assert_eq!(row.missed, ["replace * with / in b"]);
        // Wilson's interval of 2 of 3: Newcombe (1998), method 3
        assert_eq!(line(&row), "| aero | 2 of 3 | 0.67 | 0.21 | one in 100 of 400 |");
        assert!(counted("aero", "no json", [1, 1, 0]).is_none());
    }

    #[test]
    fn rows_of_other_crates_stay_in_the_table() {
        let table = "| crate | caught |\n| --- | --- |\n| hidden | old |\n| aero | old |\n";
        let text = format!("before\n{}{table}{}after\n", MARKS[0], MARKS[1]);
        let row = counted("aero", OUTCOMES, [400, 100, 1]).expect("it is one");
        let written = with_rows(&text, &[row]).expect("the marks are there");
        let lines: Vec<&str> = written.lines().collect();
        assert_eq!(lines[..2], ["before", MARKS[0].trim()]);
        assert!(lines[4].starts_with("| aero | 2 of 3"), "{written}");
        assert_eq!(lines[5..], ["| hidden | old |", MARKS[1].trim(), "after"]);
        assert_eq!(with_rows("no marks", &[]), None);
    }

    #[test]
    fn every_crate_and_file_that_is_mutated_is_there() {
        for (name, files) in CRATES {
            let folder = repository::path("crates").join(name).join("src");
            assert!(folder.is_dir(), "{name}");
            for file in files.iter().filter(|file| !file.contains('*')) {
                assert!(folder.join(file).is_file(), "{name}: {file}");
            }
        }
    }
}
