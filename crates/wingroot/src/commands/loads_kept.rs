//! What results keep of a flight beside loads at stations (`instants.csv`), so that selected cases can be flown again for their cards.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use fullaircraft::Component;
use fullaircraft::cases::list::MODELS;
use fullaircraft::design_loads::instants::{FlownCase, FlownInstant, Limit};
use loads::Matrix;
use nastran::{InputError, Table};

use crate::commands::loads_flights::Flown;
use crate::commands::loads_tables::{place_of, station_rows};
use crate::failure::Failure;

/// Heads of `instants.csv`.
const HEAD: &str =
    "model,case,instant,t_s,gradient_m,limit_station,limit_direction,limit_end,right_tip_m,left_tip_m";

/// Model, case, and instant from one.
type Key = (usize, usize, usize);

/// All instants as `instants.csv`.
pub(crate) fn csv(cases: &[FlownCase]) -> String {
    let mut text = format!("{HEAD}\n");
    for case in cases {
        for (at, instant) in (1..).zip(&case.instants) {
            let gradient =
                instant.gradient_m.map_or_else(String::new, |gradient_m| format!("{gradient_m:e}"));
            let limit = instant.limit.map_or_else(
                || ",,".to_owned(),
                |limit| {
                    let end = if limit.is_largest { "largest" } else { "smallest" };
                    format!("{},{},{end}", limit.station, limit.direction)
                },
            );
            let [right, left] = instant.tips_m;
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{},{},{at},{:e},{gradient},{limit},{right:e},{left:e}",
                MODELS[case.model], case.number, instant.t_s
            );
        }
    }
    text
}

/// The flights of earlier results: names of the stations, and all cases.
///
/// # Errors
/// If their tables cannot be read, or do not belong together.
pub(crate) fn read(from: &Path) -> Result<(Vec<String>, Flown), Failure> {
    let instants = Table::read(&from.join("instants.csv"))?;
    let path = from.join("station_loads.csv");
    let mut names: Vec<String> = Vec::new();
    let mut found: BTreeMap<Key, Vec<[[f64; 6]; 5]>> = BTreeMap::new();
    station_rows(&path, |row| {
        let Some(part) = Component::ALL.iter().position(|known| known.name() == row.component) else {
            return;
        };
        let place = place_of(&mut names, row.station);
        let all = found.entry((row.model, row.case, row.instant)).or_default();
        all.resize(all.len().max(place + 1), [[0.0; 6]; 5]);
        all[place][part] = row.loads;
    })?;
    let mut cases: BTreeMap<(usize, usize), Vec<FlownInstant>> = BTreeMap::new();
    for row in 0..instants.len() {
        let (model, case, at) = key(&instants, row)?;
        let own = cases.entry((model, case)).or_default();
        let loads = found.remove(&(model, case, at)).filter(|loads| loads.len() == names.len());
        let (Some(loads), true) = (loads, own.len() + 1 == at) else {
            let message = format!("case {case} lacks loads of instant {at}");
            return Err(InputError::in_file(&path, message)
                .with_help("expected the tables as `wingroot loads` writes them")
                .into());
        };
        own.push(FlownInstant {
            t_s: instants.number(row, "t_s")?,
            gradient_m: optional(&instants, row, "gradient_m")?,
            limit: limit(&instants, row)?,
            tips_m: [instants.number(row, "right_tip_m")?, instants.number(row, "left_tip_m")?],
            loads,
        });
    }
    let cases = cases.into_iter().map(|((model, number), instants)| FlownCase {
        number,
        model,
        instants,
        ..FlownCase::default()
    });
    Ok((names, Flown { cases: cases.collect() }))
}

/// Refuses results of another plan.
///
/// # Errors
/// If a case is another's.
pub(crate) fn check_same(matrix: &Matrix, from: &Path) -> Result<(), InputError> {
    let path = from.join("cases.csv");
    let table = Table::read(&path)?;
    let is_same = table.len() == matrix.cases.len()
        && matrix.cases.iter().enumerate().all(|(row, case)| {
            let is = |column: &str, value: f64| {
                table
                    .number(row, column)
                    .is_ok_and(|known| (known - value).abs() <= 1e-6 * (1.0 + value.abs()))
            };
            table.text(row, "condition").is_ok_and(|words| words == case.condition)
                && is("case", case.number as f64)
                && is("V_m_s", case.v_m_s)
                && is("n_z", case.n_z)
                && is("h_m", case.h_m)
        });
    if is_same {
        return Ok(());
    }
    Err(InputError::in_file(
        &path,
        "these results are of another plan than the one that would fly their cases again",
    )
    .with_help("name the plan they were flown by with --plan, or leave out --cards"))
}

fn key(table: &Table, row: usize) -> Result<Key, InputError> {
    let model = table.text(row, "model")?;
    let place = MODELS.iter().position(|known| *known == model).ok_or_else(|| {
        InputError::at(&table.span(row, "model"), "expected the model initial or updated".to_owned())
    })?;
    Ok((place, whole(table, row, "case")?, whole(table, row, "instant")?))
}

fn whole(table: &Table, row: usize, column: &str) -> Result<usize, InputError> {
    let text = table.text(row, column)?;
    text.parse().map_err(|_| InputError::at(&table.span(row, column), format!("{text} is no whole number")))
}

fn optional(table: &Table, row: usize, column: &str) -> Result<Option<f64>, InputError> {
    if table.text(row, column)?.is_empty() { Ok(None) } else { table.number(row, column).map(Some) }
}

fn limit(table: &Table, row: usize) -> Result<Option<Limit>, InputError> {
    if table.text(row, "limit_station")?.is_empty() {
        return Ok(None);
    }
    Ok(Some(Limit {
        station: whole(table, row, "limit_station")?,
        direction: whole(table, row, "limit_direction")?,
        is_largest: table.text(row, "limit_end")? == "largest",
    }))
}
