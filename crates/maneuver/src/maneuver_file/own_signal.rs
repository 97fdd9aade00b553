//! A user's own signal: columns of a CSV file over time, linear between samples.

use nastran::table::Table;
use nastran::{InputError, Span};
use std::path::Path;

/// Largest angle, degrees.
const LARGEST_DEG: f64 = 90.0;

/// Columns over time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct OwnSignal {
    /// Ascending times, s.
    pub(super) t_s: Vec<f64>,
    /// What each column moves (`alpha` or a control), where it stands, and its values, rad.
    pub(super) columns: Vec<(String, Span, Vec<f64>)>,
}

impl OwnSignal {
    pub(super) fn read(path: &Path) -> Result<Self, InputError> {
        let table = Table::read(path)?;
        table.require(&["t_s"])?;
        let moves = |column: &str| -> Option<String> {
            if column == "alpha_deg" {
                return Some("alpha".to_owned());
            }
            let name = column.strip_prefix("delta_")?.strip_suffix("_deg")?;
            (!name.is_empty()).then(|| name.to_owned())
        };
        let expected = "t_s, alpha_deg or delta_NAME_deg";
        table.allow_only(|column| column == "t_s" || moves(column).is_some(), expected)?;
        let t_s = table.numbers("t_s")?;
        if t_s.len() < 2 {
            return Err(InputError::in_file(path, "a signal needs at least two samples")
                .with_help("it is linear between them, and constant before and behind"));
        }
        if let Some(row) = t_s.windows(2).position(|pair| pair[0] >= pair[1]) {
            let message = format!("time must ascend, here it goes from {} to {} s", t_s[row], t_s[row + 1]);
            return Err(
                InputError::at(&table.span(row + 1, "t_s"), message).with_help("sort the rows by t_s")
            );
        }
        let mut columns = Vec::new();
        for (column, name) in table.columns().filter_map(|column| moves(column).map(|name| (column, name))) {
            let degrees = table.numbers(column)?;
            if let Some(row) = degrees.iter().position(|angle| angle.abs() > LARGEST_DEG) {
                let message = format!("{column} is {:?}, beyond 90 degrees", degrees[row]);
                return Err(
                    InputError::at(&table.span(row, column), message).with_help("angles are in degrees")
                );
            }
            let values = degrees.into_iter().map(f64::to_radians).collect();
            columns.push((name, table.span(0, column), values));
        }
        if columns.is_empty() {
            return Err(InputError::in_file(path, "no column but t_s: nothing moves")
                .with_help("add alpha_deg or delta_NAME_deg columns"));
        }
        Ok(Self { t_s, columns })
    }

    /// A column at a time.
    pub(super) fn at(&self, values: &[f64], t_s: f64) -> f64 {
        let above = self.t_s.partition_point(|t| *t <= t_s);
        if above == 0 {
            return values[0];
        }
        if above == self.t_s.len() {
            return values[values.len() - 1];
        }
        let (t0, t1) = (self.t_s[above - 1], self.t_s[above]);
        values[above - 1] + (t_s - t0) / (t1 - t0) * (values[above] - values[above - 1])
    }
}
