//! The results of `fullaircraft --cases`, made of the store case by case: what is in memory does not grow with the cases, but for
//! points of a figure (so many at most) and words on cases that cannot be flown.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use fullaircraft::cases::envelope::{CaseColumns, Extreme, LOADS, LoadEnvelope, envelope_csv};
use fullaircraft::cases::list::MODELS;
use fullaircraft::{CaseResult, CasesFile};
use schemars::JsonSchema;
use serde::Serialize;

use crate::commands::fullaircraft_cases_figures as figures;
use crate::commands::fullaircraft_cases_flown::{COMMAND, Flying};
use crate::commands::fullaircraft_cases_table::LoadsTable;
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// Most cases of the figure of all cases; of more it shows every second, third and so on.
const MOST_DRAWN: usize = 10_000;

/// What `result.json` holds: nothing that depends on how often the run was stopped.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Summary {
    /// Name of the command.
    command: &'static str,
    /// Name of the grid of cases.
    name: String,
    /// How many cases were flown.
    pub(crate) cases: usize,
    /// Cases that could not be flown.
    pub(crate) refused: Vec<Refused>,
    /// Number of aerodynamic boxes.
    boxes: usize,
    /// Airspeed of the corrections.
    pub(crate) correction_airspeed_m_s: f64,
    /// Smallest and largest loads.
    pub(crate) envelope: Vec<Extreme>,
    /// What the user should know.
    warnings: Vec<String>,
}

/// A case that could not be flown.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Refused {
    /// Its number.
    case: usize,
    /// Which model.
    model: String,
    /// What was to be flown.
    flown: String,
    /// Why it was not.
    why: String,
}

/// The results.
pub(crate) struct Merged {
    /// What `result.json` holds.
    pub(crate) summary: Summary,
    columns: CaseColumns,
    drawn: Vec<CaseResult>,
}

impl Merged {
    /// Goes through all finished cases once.
    ///
    /// # Errors
    /// If one cannot be read.
    pub(crate) fn of(flying: &Flying<'_>, file: &CasesFile) -> Result<Self, Failure> {
        let cases = flying.grid.len();
        let every = cases.div_ceil(MOST_DRAWN);
        let (mut refused, mut warnings, mut drawn) = (Vec::new(), BTreeSet::new(), Vec::new());
        let (mut envelope, mut columns) = (LoadEnvelope::default(), CaseColumns::default());
        for number in 0..cases {
            let mut result = read(flying, number)?;
            envelope.add(&result);
            columns.add(&result);
            let (model, v_m_s) = (&result.model, result.v_m_s);
            warnings.extend(result.warnings.iter().map(|warning| format!("{model}, {v_m_s} m/s, {warning}")));
            if let Some(why) = result.refused.clone() {
                let flown = result.label();
                refused.push(Refused { case: number, model: result.model.clone(), flown, why });
            }
            if number % every == 0 {
                result.loads.retain(|place| place.station == figures::DRAWN_STATION);
                drawn.push(result);
            }
        }
        let summary = Summary {
            command: COMMAND,
            name: file.name.clone(),
            cases,
            refused,
            boxes: flying.tools.aircraft.flow.lattice.len(),
            correction_airspeed_m_s: flying.tools.aircraft.file.correction_airspeed_m_s,
            envelope: envelope.extremes(),
            warnings: warnings.into_iter().collect(),
        };
        Ok(Self { summary, columns, drawn })
    }

    /// Writes everything.
    ///
    /// # Errors
    /// If a case cannot be read or a file not written.
    pub(crate) fn write(
        &self,
        flying: &Flying<'_>,
        target: &Path,
        inputs: &[(&'static str, PathBuf)],
    ) -> Result<PathBuf, Failure> {
        let Self { summary, columns, drawn } = self;
        let folder = ResultFolder::begin(target)?;
        inputs.iter().try_for_each(|(what, path)| folder.input(what, path))?;
        let mut table = LoadsTable::new(&folder, flying);
        let rows = (0..summary.cases).map(|number| {
            let result = read(flying, number)?;
            table.add(&flying.grid.case(number), &result)?;
            Ok(columns.csv_row(&result))
        });
        folder.write_lines("cases.csv", std::iter::once(Ok(columns.csv_head())).chain(rows))?;
        table.finish()?;
        folder.write_text("envelope.csv", &envelope_csv(&summary.envelope))?;
        if !summary.envelope.is_empty() {
            folder.write_figure_of(
                "envelope",
                "The smallest and the largest load of all cases at each station.",
                figures::envelope(&flying.tools.stations, &summary.envelope),
                "envelope.csv",
            )?;
            let mut caption = "Both ends of what each case moves through.".to_owned();
            if drawn.len() < summary.cases {
                caption = format!("{caption} {} of {} cases are drawn.", drawn.len(), summary.cases);
            }
            folder.write_figure_of("cases", &caption, figures::cloud(drawn), "cases.csv")?;
        }
        folder.write_json("result.json", summary)?;
        folder.commit_if(summary.refused.len() < summary.cases)
    }
}

fn read(flying: &Flying<'_>, number: usize) -> Result<CaseResult, Failure> {
    let lost =
        || Failure::Computation(format!("case {number} was finished and can no longer be read: run again"));
    flying.kept(number).ok_or_else(lost)
}

/// How many cases were refused or warned about; the whole list is in the results.
pub(crate) fn remark(summary: &Summary) {
    for refused in summary.refused.iter().take(5) {
        show::note(&format!("{}, {}: {}", refused.model, refused.flown, refused.why));
    }
    if summary.refused.len() > 5 {
        show::note(&format!("and {} more that cannot be flown, see result.json", summary.refused.len() - 5));
    }
    if !summary.warnings.is_empty() {
        show::note(&format!(
            "{} warnings (deflections, polars, stability) in result.json, the first: {}",
            summary.warnings.len(),
            summary.warnings[0]
        ));
    }
}

/// The envelope for people.
pub(crate) fn table(envelope: &[Extreme]) -> report::Table {
    let mut table =
        report::Table::new(&["", "initial", "updated: smallest", "initial", "updated: largest", "given by"]);
    let mut stations: Vec<&str> = Vec::new();
    for extreme in envelope {
        if !stations.contains(&extreme.station.as_str()) {
            stations.push(&extreme.station);
        }
    }
    for station in stations {
        for load in LOADS {
            let find = |model: &str, end: &str| {
                envelope
                    .iter()
                    .find(|e| e.model == model && e.station == station && e.load == load && e.end == end)
            };
            let number =
                |model: &str, end: &str| find(model, end).map_or("-".into(), |e| format!("{:.2}", e.value));
            table.row([
                format!("{station}: {}", load.replace('_', " ")),
                number(MODELS[0], "smallest"),
                number(MODELS[1], "smallest"),
                number(MODELS[0], "largest"),
                number(MODELS[1], "largest"),
                find(MODELS[1], "largest").map_or_else(String::new, |e| e.flown.clone()),
            ]);
        }
    }
    table
}
