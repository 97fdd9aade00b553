//! `validate`: our result beside the reference for every published case.

use clap::Args;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Instant;

use nastran::InputError;
use report::Table;
use serde_json::{Value, json};
use validation::registry::{LISTED, Outcome, cases, compute};
use validation::{Row, Tolerance, Verdict};

use crate::pages::validate::page;
use crate::repository;
use wingroot::args::Common;
use wingroot::failure::Failure;
use wingroot::output::ResultFolder;
use wingroot::{progress, show};

/// Options of `validate`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask validate
  cargo xtask validate --only dlm")]
pub(crate) struct ValidateArgs {
    /// The folder of published cases [default: data/published]
    #[arg(long, value_name = "DIR")]
    pub(crate) data: Option<PathBuf>,
    /// Only cases whose name begins with this
    #[arg(long, value_name = "NAME")]
    pub(crate) only: Option<String>,
}

/// The published cases.
const DATA: &str = "data/published";

/// Runs the command; fails if a case is not met or cannot be computed, after writing all the same.
pub(crate) fn run(args: &ValidateArgs, common: &Common) -> Result<(), Failure> {
    let start = Instant::now();
    let data = args.data.clone().unwrap_or_else(|| repository::path(DATA));
    let prefix = args.only.as_deref().unwrap_or_default();
    let chosen: Vec<_> = cases().filter(|case| case.file.starts_with(prefix)).collect();
    if chosen.is_empty() {
        let error = InputError::general(format!("no published case has a name that begins with '{prefix}'"));
        return Err(error.with_help("the names are those of the files in data/published").into());
    }
    let bar = progress::bar(common, chosen.len(), "published cases");
    let outcomes: Vec<Outcome> = chosen
        .into_iter()
        .map(|case| {
            let outcome = compute(&data, case);
            bar.inc(1);
            outcome
        })
        .collect();
    progress::end(&bar);
    let table = table(&outcomes);
    let result = result(&outcomes, start.elapsed().as_secs_f64());
    let folder = ResultFolder::begin(&common.out("validate"))?.with_head(page);
    folder.input("published cases", &data)?;
    folder.write_text("table.txt", &table)?;
    folder.write_json("result.json", &result)?;
    let bad: Vec<&str> = outcomes.iter().filter(|case| !case.is_good()).map(|case| &*case.file).collect();
    let out = folder.commit_if(bad.is_empty())?;
    show::summary(common, &format!("{table}{}written to {}", counted(&outcomes), out.display()));
    show::json(common, &result)?;
    if bad.is_empty() {
        return Ok(());
    }
    Err(Failure::Computation(format!("{} published cases are not met: {}", bad.len(), bad.join(", "))))
}

fn table(outcomes: &[Outcome]) -> String {
    let mut table =
        Table::new(&["case", "quantity", "ours", "reference", "difference", "tolerance", "verdict"]);
    for outcome in outcomes {
        match &outcome.rows {
            Ok(rows) => rows.iter().for_each(|row| {
                table.row([
                    outcome.file.clone(),
                    row.quantity.clone(),
                    number(row.ours),
                    number(row.reference),
                    difference(row),
                    row.tolerance_text(),
                    row.verdict().to_string(),
                ]);
            }),
            Err(message) => {
                table.row([outcome.file.clone(), message.clone(), String::new(), String::new()]);
            }
        }
    }
    let mut text = table.to_string();
    for (file, reason) in LISTED {
        let _ = writeln!(text, "not compared: {file}: {reason}");
    }
    text
}

/// Six significant digits.
fn number(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) {
        return format!("{value:.5e}");
    }
    let before = format!("{:.0}", value.abs().trunc()).len();
    format!("{value:.*}", 6_usize.saturating_sub(before).max(1))
}

/// As a share of the reference where there is one to speak of.
fn difference(row: &Row) -> String {
    let relative = 100.0 * row.relative_difference();
    let absolute = match row.tolerance.asked() {
        Tolerance::Within { rel, .. } => *rel == 0.0,
        Tolerance::Band { .. } => true,
        _ => false,
    };
    if absolute || !relative.is_finite() {
        format!("{:+.2e}", row.difference())
    } else if relative != 0.0 && relative.abs() < 1e-3 {
        format!("{relative:+.1e} %")
    } else {
        format!("{relative:+.3} %")
    }
}

fn verdicts(outcomes: &[Outcome], verdict: Verdict) -> usize {
    let rows = outcomes.iter().flat_map(|outcome| outcome.rows.iter().flatten());
    rows.filter(|row| row.verdict() == verdict).count()
}

fn counted(outcomes: &[Outcome]) -> String {
    let count = |verdict| verdicts(outcomes, verdict);
    format!(
        "{} cases: {} met, {} known deviations, {} recorded, {} not met, {} not computed, {} listed without\n",
        outcomes.len(),
        count(Verdict::Met),
        count(Verdict::KnownDeviation),
        count(Verdict::Recorded),
        count(Verdict::NotMet),
        outcomes.iter().filter(|outcome| outcome.rows.is_err()).count(),
        LISTED.len()
    )
}

fn result(outcomes: &[Outcome], seconds: f64) -> Value {
    let row = |row: &Row| {
        let reason = match &row.tolerance {
            Tolerance::Known { reason, .. } => Some(reason),
            _ => None,
        };
        json!({ "quantity": row.quantity, "ours": row.ours, "reference": row.reference,
            "difference": row.difference(), "tolerance": row.tolerance_text(), "verdict": row.verdict(),
            "reason": reason })
    };
    let case = |outcome: &Outcome| {
        json!({ "case": outcome.file, "source": outcome.source, "good": outcome.is_good(),
            "rows": outcome.rows.as_ref().map(|rows| rows.iter().map(row).collect::<Vec<_>>()).unwrap_or_default(),
            "error": outcome.rows.as_ref().err() })
    };
    let listed = LISTED.iter().map(|(file, reason)| json!({ "case": file, "reason": reason }));
    json!({ "command": "validate", "cases": outcomes.iter().map(case).collect::<Vec<_>>(),
        "not_compared": listed.collect::<Vec<_>>(),
        "met": verdicts(outcomes, Verdict::Met), "known_deviations": verdicts(outcomes, Verdict::KnownDeviation),
        "recorded": verdicts(outcomes, Verdict::Recorded), "not_met": verdicts(outcomes, Verdict::NotMet),
        "seconds": seconds })
}
