//! A folder of measured runs that nobody drives: `runs.csv` and a file of samples for each run.

use nastran::{InputError, Table};
use std::path::{Path, PathBuf};

/// What a run is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A steady cycle.
    Cycle,
    /// What follows a blow.
    Tap,
}

/// A measured run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Its name, which is its file's.
    pub name: String,
    /// The day it was measured on.
    pub day: u32,
    /// What it is.
    pub kind: Kind,
    /// Airspeed, m/s.
    pub airspeed_m_s: f64,
    /// Density, kg/m3.
    pub rho_kg_m3: f64,
    /// Time between samples, s.
    pub step_s: f64,
    /// Heave, m, positive down, about the mean of the run.
    pub heave_m: Vec<f64>,
    /// Pitch, rad, nose up, about the mean of the run.
    pub pitch_rad: Vec<f64>,
    /// What the pitch was counted from, rad.
    pub pitch_offset_rad: f64,
}

/// Columns of `runs.csv` that are needed.
const COLUMNS: [&str; 7] =
    ["run", "day", "kind", "airspeed_m_s", "density_kg_m3", "rate_Hz", "pitch_offset_rad"];
/// Samples a run needs at least: a second at the lowest rate that shows a third harmonic.
const LEAST_SAMPLES: usize = 100;

/// Reads `runs.csv` of a folder and the runs in its folder `free`.
///
/// # Errors
/// If a file is missing or says something that cannot be: the line and what was expected.
pub fn read(folder: &Path) -> Result<Vec<Run>, InputError> {
    let table = Table::read(&runs_file(folder))?;
    table.require(&COLUMNS)?;
    (0..table.len()).map(|row| run(folder, &table, row)).collect()
}

/// The list of runs of a folder.
pub fn runs_file(folder: &Path) -> PathBuf {
    folder.join("runs.csv")
}

fn run(folder: &Path, table: &Table, row: usize) -> Result<Run, InputError> {
    let kind = match table.text(row, "kind")? {
        "cycle" => Kind::Cycle,
        "tap" => Kind::Tap,
        other => {
            let place = table.span(row, "kind");
            return Err(InputError::at(&place, format!("`{other}` is no kind of run"))
                .with_help("expected cycle or tap"));
        }
    };
    let above_zero = |column: &str| {
        let value = table.number(row, column)?;
        if value > 0.0 {
            return Ok(value);
        }
        Err(InputError::at(&table.span(row, column), format!("{column} is {value}; it must be above zero")))
    };
    let day = table.text(row, "day")?;
    let day = day.parse().map_err(|_| {
        InputError::at(&table.span(row, "day"), format!("`{day}` is no day; expected a whole number"))
    })?;
    let name = table.text(row, "run")?.to_owned();
    let file = folder.join("free").join(format!("{name}.csv"));
    let samples = Table::read(&file)?;
    let run = Run {
        day,
        kind,
        airspeed_m_s: above_zero("airspeed_m_s")?,
        rho_kg_m3: above_zero("density_kg_m3")?,
        step_s: 1.0 / above_zero("rate_Hz")?,
        heave_m: samples.numbers("heave_m")?,
        pitch_rad: samples.numbers("pitch_rad")?,
        pitch_offset_rad: table.number(row, "pitch_offset_rad")?,
        name,
    };
    if run.pitch_rad.len() < LEAST_SAMPLES {
        let what = format!("{} samples are too few; a run needs {LEAST_SAMPLES}", run.pitch_rad.len());
        return Err(InputError::in_file(&file, what));
    }
    Ok(run)
}
