//! Tables of measured points and histories.
//!
//! Columns: the state (`V_m_s`, `alpha_deg`, `delta_NAME_deg`, `t_s` and whatever else was recorded), a load a column
//! (`STATION_Mx_Nm`), and, where loads were calculated by another program, `initial_STATION_Mx_Nm` and `updated_STATION_Mx_Nm`.

use super::file::{Channel, Condition, FlightFile, Source};
use super::history::extremes;
use nastran::{InputError, Table, named_file};
use std::collections::BTreeMap;

/// Names of the models in columns.
const MODELS: [&str; 2] = ["initial", "updated"];
/// A history turns where it comes back by so many standard deviations of a reading, or this share of its range.
const TURNS: (f64, f64) = (4.0, 0.05);

/// The measured state of a wing in the tunnel.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Angle of attack, deg.
    pub alpha_deg: f64,
    /// Deflections of controls, trailing edge down, deg.
    pub controls_deg: BTreeMap<String, f64>,
}

/// Loads measured at one point or instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// Where it stands.
    pub place: nastran::Span,
    /// The state, if its table has it.
    pub state: Option<State>,
    /// Airspeed, m/s, if it was recorded.
    pub v_m_s: Option<f64>,
    /// Load factor, if it was recorded.
    pub n_z: Option<f64>,
    /// Loads in the order of the channels, N or N m; none where a channel is not compared here.
    pub measured: Vec<Option<f64>>,
    /// Loads that the table brings of the initial and the updated model.
    pub calculated: [Option<Vec<f64>>; 2],
    /// Whether it fitted the corrections.
    pub fitted: bool,
}

/// The readings of a condition with a table.
///
/// # Errors
/// If the table cannot be read, a column is missing, a cell is not a number, or there is no row.
pub fn readings(file: &FlightFile, condition: &Condition) -> Result<Vec<Reading>, InputError> {
    let (name, kept) = match &condition.source {
        Source::Points(name) => (name, None),
        Source::History(name, extremes) => (name, Some(*extremes)),
        Source::Campaign(..) | Source::Sections(_) => return Ok(Vec::new()),
    };
    let path = named_file(&file.path, name)?;
    let table = Table::read(&path)?;
    if table.is_empty() {
        let message = format!("the condition `{}` has no points", condition.name);
        return Err(
            InputError::in_file(&path, message).with_help("give a row a point, or take the condition out")
        );
    }
    let channels = file.channels();
    let measured = channels
        .iter()
        .map(|channel| numbers(&table, "", channel)?.ok_or_else(|| missing(&table, channel)))
        .collect::<Result<Vec<_>, _>>()?;
    let counts = counts(&channels, &measured, kept);
    let [initial, updated] = MODELS.map(|model| calculated(&table, model, &channels));
    let (initial, updated) = (initial?, updated?);
    let of = |all: &Option<Vec<Vec<f64>>>, row: usize| {
        all.as_ref().map(|all| all.iter().map(|column| column[row]).collect())
    };
    let fitted = file.fitted.contains(name);
    let row = |row: usize| {
        Ok(Reading {
            place: table.span(row, table.columns().next().unwrap_or_default()),
            state: state(&table, row)?,
            v_m_s: recorded(&table, row, "V_m_s")?,
            n_z: recorded(&table, row, "n_z")?,
            measured: measured.iter().zip(&counts).map(|(all, is)| is[row].then_some(all[row])).collect(),
            calculated: [of(&initial, row), of(&updated, row)],
            fitted,
        })
    };
    let is_compared = |row: &usize| counts.iter().any(|counts| counts[*row]);
    (0..table.len()).filter(is_compared).map(row).collect()
}

/// Which rows of each channel are compared: all, or the extremes.
fn counts(channels: &[Channel], measured: &[Vec<f64>], kept: Option<usize>) -> Vec<Vec<bool>> {
    let of = |(channel, values): (&Channel, &Vec<f64>)| {
        let Some(n) = kept else { return vec![true; values.len()] };
        let range =
            values.iter().copied().fold(f64::MIN, f64::max) - values.iter().copied().fold(f64::MAX, f64::min);
        let back = (TURNS.0 * channel.gauge.sigma.unwrap_or(0.0)).max(TURNS.1 * range);
        let mut is = vec![false; values.len()];
        for row in extremes(values, back, n) {
            is[row] = true;
        }
        is
    };
    channels.iter().zip(measured).map(of).collect()
}

/// A channel's column, if there is one; `Mx_Nm` is the root's.
fn numbers(table: &Table, before: &str, channel: &Channel) -> Result<Option<Vec<f64>>, InputError> {
    let mut names = vec![format!("{before}{}", channel.column())];
    if channel.station == "root" {
        names.push(format!("{before}{}", channel.plain()));
    }
    let name = names.iter().find(|name| table.has(name));
    name.map(|name| table.numbers(name)).transpose()
}

fn missing(table: &Table, channel: &Channel) -> InputError {
    match table.require(&[&channel.column()]) {
        Err(error) => error,
        Ok(()) => InputError::general(format!("the column {} is missing", channel.column())),
    }
}

/// The calculated loads of a model: all channels or none.
fn calculated(table: &Table, model: &str, channels: &[Channel]) -> Result<Option<Vec<Vec<f64>>>, InputError> {
    let before = format!("{model}_");
    let all =
        channels.iter().map(|channel| numbers(table, &before, channel)).collect::<Result<Vec<_>, _>>()?;
    if all.iter().all(Option::is_none) {
        return Ok(None);
    }
    let named =
        |channel: &Channel| Channel { station: format!("{before}{}", channel.station), ..channel.clone() };
    let complete =
        channels.iter().zip(all).map(|(channel, all)| all.ok_or_else(|| missing(table, &named(channel))));
    complete.collect::<Result<Vec<_>, _>>().map(Some)
}

/// A number of a column that may not be there.
fn recorded(table: &Table, row: usize, column: &str) -> Result<Option<f64>, InputError> {
    table.has(column).then(|| table.number(row, column)).transpose()
}

fn state(table: &Table, row: usize) -> Result<Option<State>, InputError> {
    if !(table.has("V_m_s") && table.has("alpha_deg")) {
        return Ok(None);
    }
    let mut controls_deg = BTreeMap::new();
    for column in table.columns() {
        if let Some(name) = column.strip_prefix("delta_").and_then(|rest| rest.strip_suffix("_deg")) {
            controls_deg.insert(name.to_owned(), table.number(row, column)?);
        }
    }
    let (v_m_s, alpha_deg) = (table.number(row, "V_m_s")?, table.number(row, "alpha_deg")?);
    if v_m_s <= 0.0 {
        let error = InputError::at(
            &table.span(row, "V_m_s"),
            format!("an airspeed of {v_m_s} m/s has no loads of the air"),
        );
        return Err(error.with_help("take the row out: loads without wind are no point"));
    }
    Ok(Some(State { v_m_s, alpha_deg, controls_deg }))
}
