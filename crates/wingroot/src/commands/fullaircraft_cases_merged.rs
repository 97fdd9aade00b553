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
use crate::commands::fullaircraft_draws::set_intervals;
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
    /// Where the wings are from whose envelopes the intervals are of; left out without them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) intervals_from: Option<String>,
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
        let mut envelope = envelope.extremes();
        let draws = draws(flying, &refused, &mut warnings)?;
        set_intervals(&mut envelope, &draws);
        let summary = Summary {
            command: COMMAND,
            name: file.name.clone(),
            cases,
            refused,
            boxes: flying.tools.aircraft.flow.lattice.len(),
            correction_airspeed_m_s: flying.tools.aircraft.file.correction_airspeed_m_s,
            envelope,
            intervals_from: flying.draws.from(),
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
            let mut caption = "The smallest and the largest load of all cases at each station.".to_owned();
            if summary.intervals_from.is_some() {
                caption += " Shaded: 90 % intervals of the updated model's, the envelope taken for each wing that is as likely.";
            }
            folder.write_figure_of(
                "envelope",
                &caption,
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

/// The envelope of each draw; one that cannot fly what the updated model flies is said.
fn draws(
    flying: &Flying<'_>,
    refused: &[Refused],
    warnings: &mut BTreeSet<String>,
) -> Result<Vec<Vec<Extreme>>, Failure> {
    let of_a_draw = flying.of_a_draw();
    let of_draw = |draw: usize| {
        let mut envelope = LoadEnvelope::default();
        let first = flying.grid.len() + draw * of_a_draw;
        let (mut lost, mut example) = (0, String::new());
        for number in first..first + of_a_draw {
            let result = read(flying, number)?;
            envelope.add(&result);
            let Some(why) = &result.refused else { continue };
            if refused.iter().all(|own| own.case != result.number) {
                lost += 1;
                example = format!("{}: {why}", result.label());
            }
        }
        if lost > 0 {
            let wing = draw + 1;
            warnings.insert(format!(
                "wing {wing} of the ensemble cannot fly {lost} cases that the updated model flies ({example}): its envelope is without them"
            ));
        }
        Ok(envelope.extremes())
    };
    (0..flying.draws.count()).map(of_draw).collect()
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

/// The envelope for people; with intervals of the updated model where there are any.
pub(crate) fn table(envelope: &[Extreme]) -> report::Table {
    let is_interval = envelope.iter().any(|extreme| extreme.interval_90.is_some());
    let mut head = vec![""];
    for end in ["updated: smallest", "updated: largest"] {
        head.extend(["initial", end]);
        head.extend(is_interval.then_some("90 %"));
    }
    head.push("given by");
    let mut table = report::Table::new(&head);
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
            let mut row = vec![format!("{station}: {}", load.replace('_', " "))];
            for end in ["smallest", "largest"] {
                row.extend(MODELS.map(|model| {
                    find(model, end).map_or_else(|| "-".to_owned(), |e| format!("{:.2}", e.value))
                }));
                if is_interval {
                    let interval = find(MODELS[1], end).and_then(|e| e.interval_90);
                    row.push(
                        interval.map_or_else(String::new, |[low, high]| format!("{low:.2} to {high:.2}")),
                    );
                }
            }
            row.push(find(MODELS[1], "largest").map_or_else(String::new, |e| e.flown.clone()));
            table.row(row);
        }
    }
    table
}
