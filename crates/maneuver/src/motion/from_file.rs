//! A user's own signal: a CSV file with `t_s` and `alpha_deg` (the angle itself) or `delta_NAME_deg` columns.

use super::kind::{Column, Kind, Mover};
use super::signal::Signal;
use nastran::table::Table;
use nastran::{InputError, named_file};
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// Largest angle, degrees.
const LARGEST_DEG: f64 = 90.0;

/// Columns over time, linear between samples and constant before and behind them.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FromFile {
    /// The file, relative to the maneuver's.
    pub file: String,
    /// Where its t_s = 0 is, s.
    #[serde(default)]
    pub start_s: f64,
    /// Its columns, time counted from the maneuver's beginning.
    #[serde(skip)]
    columns: Vec<Column>,
}

impl Signal for FromFile {
    /// Zero: its columns are its signals.
    fn at(&self, _t_s: f64) -> f64 {
        0.0
    }
}

impl Kind for FromFile {
    fn words(&self) -> &'static str {
        "signal from a file"
    }

    fn height(&self) -> f64 {
        0.0
    }

    fn start_s(&self) -> f64 {
        self.start_s
    }

    /// To the last sample.
    fn length_s(&self) -> f64 {
        self.columns.first().map_or(0.0, |column| column.t_s[column.t_s.len() - 1])
    }

    fn mover(&self) -> Mover {
        Mover::Columns
    }

    fn read_beside(&mut self, maneuver: &Path) -> Result<(), InputError> {
        self.columns = columns(&named_file(maneuver, &self.file)?)?;
        Ok(())
    }

    fn columns(&self) -> &[Column] {
        &self.columns
    }
}

/// What a column moves; none if it has another name.
fn moves(column: &str) -> Option<String> {
    if column == "alpha_deg" {
        return Some("alpha".to_owned());
    }
    let name = column.strip_prefix("delta_")?.strip_suffix("_deg")?;
    (!name.is_empty()).then(|| name.to_owned())
}

fn columns(path: &Path) -> Result<Vec<Column>, InputError> {
    let table = Table::read(path)?;
    table.require(&["t_s"])?;
    table.allow_only(
        |column| column == "t_s" || moves(column).is_some(),
        "t_s, alpha_deg or delta_NAME_deg",
    )?;
    let t_s = table.numbers("t_s")?;
    if t_s.len() < 2 {
        return Err(InputError::in_file(path, "a signal needs at least two samples")
            .with_help("it is linear between them, and constant before and behind"));
    }
    if let Some(row) = t_s.windows(2).position(|pair| pair[0] >= pair[1]) {
        let message = format!("time must ascend, here it goes from {} to {} s", t_s[row], t_s[row + 1]);
        return Err(InputError::at(&table.span(row + 1, "t_s"), message).with_help("sort the rows by t_s"));
    }
    let mut columns = Vec::new();
    for (column, of) in table.columns().filter_map(|column| moves(column).map(|of| (column, of))) {
        let degrees = table.numbers(column)?;
        if let Some(row) = degrees.iter().position(|angle| angle.abs() > LARGEST_DEG) {
            let message = format!("{column} is {:?}, beyond 90 degrees", degrees[row]);
            return Err(InputError::at(&table.span(row, column), message).with_help("angles are in degrees"));
        }
        let values = degrees.into_iter().map(f64::to_radians).collect();
        columns.push(Column { of, span: table.span(0, column), t_s: t_s.clone(), values });
    }
    if columns.is_empty() {
        return Err(InputError::in_file(path, "no column but t_s: nothing moves")
            .with_help("add alpha_deg or delta_NAME_deg columns"));
    }
    Ok(columns)
}
