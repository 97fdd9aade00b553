//! `mutants`: small faults put in one at a time by `cargo mutants`, and the share that a crate's own tests catch.

mod judged;
mod listed;
mod switched;
mod tree;

use std::time::Duration;

use clap::Args;
use loads::compare::statistics::wilson;
use nastran::InputError;
use serde::Serialize;
use serde_json::json;
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::show;

use self::listed::Mutant;
use crate::repository;

/// Options of `mutants`.
#[derive(Debug, Clone, Args)]
#[command(after_help = "Examples:
  cargo xtask mutants --crates structure --sample 40
  cargo xtask mutants --seed 3 --write

Needs cargo-mutants (cargo install cargo-mutants --locked), which lists the mutants. All of a crate are built at once, each
behind a switch, and only tests that reach a mutant judge it. Equivalent mutants, which change nothing that can be seen, are listed with their reasons in .cargo/mutants.toml.")]
pub(crate) struct MutantsArgs {
    /// Crates, by comma [default: all of the table in docs/testing.md]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub(crate) crates: Vec<String>,
    /// About so many mutants of a crate: every k-th of its list, from that of --seed on; two thirds can stand behind a switch
    #[arg(long, value_name = "N", default_value_t = 225)]
    pub(crate) sample: usize,
    /// A mutant is missed if the quickest tests that reach it, of so many seconds together, all pass
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub(crate) seconds: u64,
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

/// Around the table of docs/testing.md.
const MARKS: [&str; 2] = ["<!-- kill rate: begin -->\n", "<!-- kill rate: end -->\n"];

/// A crate's row.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Row {
    name: String,
    /// All that cargo-mutants lists.
    mutants: usize,
    /// Every so many of them was taken, from that of the seed on.
    every: usize,
    seed: u64,
    caught: usize,
    missed: Vec<String>,
    /// Taken, but what stands there then does not compile.
    unviable: usize,
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
        let row = row(args, common.seed.unwrap_or(1), name, files)?;
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
fn row(args: &MutantsArgs, seed: u64, name: &str, files: &[&str]) -> Result<Row, Failure> {
    let all = listed::listed(name, files)?;
    let every = (all.len() / args.sample.max(1)).max(1);
    let from = usize::try_from(seed % every as u64).unwrap_or_default();
    let taken: Vec<Mutant> = all.iter().skip(from).step_by(every).cloned().collect();
    let built = tree::built(name, &taken)?;
    let missed = judged::missed(&built, Duration::from_secs(args.seconds))?;
    Ok(Row {
        name: name.to_owned(),
        mutants: all.len(),
        every,
        seed,
        caught: built.inside.len() - missed.len(),
        missed: missed.iter().map(|&number| taken[number].name.clone()).collect(),
        unviable: taken.len() - built.inside.len(),
    })
}

/// `| crate | caught of tried | share | 95 % from | one in every of all, seed |`
fn line(row: &Row) -> String {
    let Row { name, mutants, every, seed, caught, missed, .. } = row;
    let tried = caught + missed.len();
    let share = wilson(*caught, tried);
    format!(
        "| {name} | {caught} of {tried} | {:.2} | {:.2} | one in {every} of {mutants}, seed {seed} |",
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

    /// Caught, missed and not compiled: 2, 1, 1.
    fn example() -> Row {
        let missed = vec!["replace * with / in b".to_owned()];
        Row { name: "aero".into(), mutants: 400, every: 100, seed: 1, caught: 2, missed, unviable: 1 }
    }

    #[test]
    fn what_does_not_compile_does_not_count() {
        // Wilson's interval of 2 of 3: Newcombe (1998), method 3
        assert_eq!(line(&example()), "| aero | 2 of 3 | 0.67 | 0.21 | one in 100 of 400, seed 1 |");
    }

    #[test]
    fn rows_of_other_crates_stay_in_the_table() {
        let table = "| crate | caught |\n| --- | --- |\n| hidden | old |\n| aero | old |\n";
        let text = format!("before\n{}{table}{}after\n", MARKS[0], MARKS[1]);
        let written = with_rows(&text, &[example()]).expect("the marks are there");
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
