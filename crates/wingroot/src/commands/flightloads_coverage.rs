//! The design loads of a run of `loads` beside what was flown.

use std::fmt::Write as _;
use std::path::Path;

use loads::compare::coverage::{Coverage, CoveredInstant, CoveredLoad, Flown};
use loads::flight::Channel;
use nastran::{InputError, Table};

use super::flightloads_measured::Measured;
use crate::failure::Failure;
use crate::output::ResultFolder;

/// The model whose design loads count.
const MODEL: &str = "updated";

/// Coverage of the design loads in a folder of `loads`.
pub(super) fn coverage(folder: &Path, channels: &[Channel], all: &[Measured]) -> Result<Coverage, Failure> {
    let flown = flown(all);
    let instants =
        instants(&folder.join("selected.csv"))?.into_iter().map(|instant| flown.marked(instant)).collect();
    let path = folder.join("envelope.csv");
    let envelope = Table::read(&path)?;
    let mut loads = Vec::new();
    for (at, channel) in channels.iter().enumerate() {
        // sections of a wing are no stations of a plan
        let of_channels = all.iter().filter(|one| one.channels == channels);
        let readings = of_channels.flat_map(|one| &one.readings);
        let measured: Vec<f64> = readings.filter_map(|reading| reading.measured[at]).collect();
        if measured.is_empty() {
            continue;
        }
        let ends = [
            ("smallest", measured.iter().copied().fold(f64::INFINITY, f64::min)),
            ("largest", measured.iter().copied().fold(f64::NEG_INFINITY, f64::max)),
        ];
        for (end, measured) in ends {
            let design = design(&envelope, channel, end)?.ok_or_else(|| {
                let message = format!("there are no design loads {} of station {}", channel.plain(), channel.station);
                InputError::in_file(&path, message)
                    .with_help("stations of the plan and of the measurements need the same names; the right wing's count")
            })?;
            loads.push(CoveredLoad::new(&channel.station, channel.load.name(), end, measured, design));
        }
    }
    Ok(Coverage { instants, loads })
}

/// Ranges of everything that was measured.
fn flown(all: &[Measured]) -> Flown {
    let range = |values: Vec<f64>| {
        let low = values.iter().copied().reduce(f64::min)?;
        Some([low, values.iter().copied().fold(low, f64::max)])
    };
    let readings = || all.iter().flat_map(|one| &one.readings);
    Flown {
        v_m_s: range(readings().filter_map(|reading| reading.v_m_s).collect()),
        n_z: range(readings().filter_map(|reading| reading.n_z).collect()),
    }
}

/// The instants that went to stress.
fn instants(path: &Path) -> Result<Vec<CoveredInstant>, InputError> {
    let table = Table::read(path)?;
    let whole = |row: usize, column: &str| {
        let text = table.text(row, column)?;
        text.parse::<u32>()
            .map_err(|_| InputError::at(&table.span(row, column), format!("{text} is no number from one on")))
    };
    let one = |row: usize| {
        Ok(CoveredInstant {
            sid: whole(row, "sid")?,
            case: whole(row, "case")? as usize,
            mass: table.text(row, "mass")?.to_owned(),
            v_m_s: table.number(row, "V_m_s")?,
            n_z: table.number(row, "n_z")?,
            v_is_flown: None,
            n_is_flown: None,
        })
    };
    (0..table.len()).map(one).collect()
}

/// An end of the design loads where a channel measures: of its station, or of the right wing's of that name.
fn design(envelope: &Table, channel: &Channel, end: &str) -> Result<Option<f64>, InputError> {
    for name in [channel.station.clone(), format!("right {}", channel.station)] {
        for row in 0..envelope.len() {
            let is = |column: &str, text: &str| envelope.text(row, column).map(|own| own == text);
            if is("model", MODEL)?
                && is("station", &name)?
                && is("load", &channel.plain())?
                && is("end", end)?
            {
                return envelope.number(row, "value").map(Some);
            }
        }
    }
    Ok(None)
}

/// Both tables.
pub(super) fn write(folder: &ResultFolder, coverage: &Coverage) -> Result<(), Failure> {
    let word = |is: Option<bool>| match is {
        Some(true) => "yes",
        Some(false) => "no",
        None => "not recorded",
    };
    let mut text = String::from("sid,case,mass,V_m_s,n_z,V_is_flown,n_is_flown\n");
    for one in &coverage.instants {
        let CoveredInstant { sid, case, mass, v_m_s, n_z, v_is_flown, n_is_flown } = one;
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{sid},{case},\"{}\",{v_m_s},{n_z},{},{}",
            mass.replace('"', "'"),
            word(*v_is_flown),
            word(*n_is_flown)
        );
    }
    folder.write_text("coverage_cases.csv", &text)?;
    let mut text = String::from("station,load,end,measured,design,extrapolated_by\n");
    for one in &coverage.loads {
        let CoveredLoad { station, load, end, measured, design, extrapolated_by } = one;
        let by = extrapolated_by.map_or_else(|| "not flown".to_owned(), |by| format!("{by:.6}"));
        let _ = writeln!(text, "\"{}\",{load},{end},{measured},{design},{by}", station.replace('"', "'"));
    }
    folder.write_text("coverage_loads.csv", &text)
}

/// In a line.
pub(super) fn line(coverage: &Coverage) -> String {
    let inside = coverage.instants.iter().filter(|instant| instant.is_flown()).count();
    let mut text = format!(
        "coverage     {inside} of {} design instants within the airspeeds and load factors flown",
        coverage.instants.len()
    );
    let most = coverage.loads.iter().filter(|load| load.extrapolated_by.is_some());
    if let Some(most) =
        most.max_by(|a, b| a.extrapolated_by.unwrap_or(1.0).total_cmp(&b.extrapolated_by.unwrap_or(1.0)))
    {
        let by = most.extrapolated_by.unwrap_or(1.0);
        // Writing to a String cannot fail.
        let _ = write!(text, "; {} {} ({}) extrapolated by {by:.2}", most.station, most.load, most.end);
    }
    let not = coverage.loads.iter().filter(|load| load.extrapolated_by.is_none()).count();
    if not > 0 {
        let _ = write!(text, "; {not} ends of loads were not flown at all");
    }
    text + "\n"
}
