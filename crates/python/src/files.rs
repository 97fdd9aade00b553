//! Input files as dictionaries and arrays, and back.

use std::path::{Path, PathBuf};

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use pythonize::{depythonize, pythonize};
use wingroot::aero::Corrections;
use wingroot::calibrate::{Campaign, CampaignFile, CorrectionSet, Schedule};
use wingroot::coupling::WingFile;
use wingroot::fullaircraft::AircraftFile;
use wingroot::maneuver::effects::library;
use wingroot::nastran::table::Table;
use wingroot::nastran::{InputError, ron_file};

use crate::raised::checked;

/// Name, fingerprint and content of a wing's file, checked.
#[pyfunction]
pub(crate) fn read_wing(py: Python<'_>, path: PathBuf) -> PyResult<(String, String, Bound<'_, PyAny>)> {
    let wing = checked(py, py.detach(|| WingFile::read(&path)))?;
    Ok((wing.name.clone(), wing.hash.clone(), pythonize(py, &wing)?))
}

/// Writes a wing's file, with the files it names (looked for from `base`) beside it.
#[pyfunction]
pub(crate) fn write_wing(
    py: Python<'_>,
    wing: &Bound<'_, PyAny>,
    base: PathBuf,
    path: PathBuf,
) -> PyResult<()> {
    let wing: WingFile = understood(py, wing, "wing")?;
    let written = || {
        let written = WingFile { path: base.join(path.file_name().unwrap_or_default()), ..wing }.written()?;
        for (name, from) in &written.beside {
            write(&path.with_file_name(name), &wingroot::nastran::read_text(from)?)?;
        }
        write(&path, &written.text)
    };
    checked(py, py.detach(written))
}

/// The content of a campaign's file; the campaign is checked.
#[pyfunction]
pub(crate) fn read_campaign(py: Python<'_>, folder: PathBuf) -> PyResult<Bound<'_, PyAny>> {
    let campaign = checked(py, py.detach(|| Campaign::read(&folder)))?;
    let file: CampaignFile = checked(py, ron_file::read(&campaign.path))?;
    Ok(pythonize(py, &file)?)
}

/// Writes a campaign's file.
#[pyfunction]
pub(crate) fn write_campaign(py: Python<'_>, campaign: &Bound<'_, PyAny>, path: PathBuf) -> PyResult<()> {
    let campaign: CampaignFile = understood(py, campaign, "campaign")?;
    let text = checked(py, ron_file::file_text(&path, "Campaign", &campaign))?;
    checked(py, write(&path, &text))
}

/// A dictionary of Python as the content of a file.
fn understood<T: serde::de::DeserializeOwned>(
    py: Python<'_>,
    value: &Bound<'_, PyAny>,
    what: &str,
) -> PyResult<T> {
    let read = depythonize(value).map_err(|error| InputError::general(format!("this is no {what}: {error}")));
    let help = "compare with to_dict() of a shipped one";
    checked(py, read.map_err(|error| error.with_help(help)))
}

fn write(path: &Path, text: &str) -> Result<(), InputError> {
    std::fs::write(path, text)
        .map_err(|error| InputError::in_file(path, format!("it cannot be written: {error}")))
}

/// Wing, its fingerprint, airspeeds, and force factors, moment factors and pressure offsets, a row an airspeed.
#[pyfunction]
pub(crate) fn read_corrections(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let schedule = checked(py, py.detach(|| Schedule::read(&path)))?;
    let v_m_s: Bound<'_, PyArray1<f64>> =
        schedule.sets.iter().map(|set| set.v_m_s).collect::<Vec<_>>().into_pyarray(py);
    let rows = |of: fn(&Corrections) -> &Vec<f64>| -> PyResult<Bound<'_, PyArray2<f64>>> {
        let all: Vec<f64> = schedule.sets.iter().flat_map(|set| of(&set.corrections)).copied().collect();
        all.into_pyarray(py).reshape([schedule.sets.len(), of(&schedule.sets[0].corrections).len()])
    };
    let dict = PyDict::new(py);
    dict.set_item("wing", schedule.wing.as_str())?;
    dict.set_item("wing_hash", schedule.wing_hash.as_str())?;
    dict.set_item("V_m_s", v_m_s)?;
    dict.set_item("force", rows(|set| &set.force)?)?;
    dict.set_item("moment", rows(|set| &set.moment)?)?;
    dict.set_item("pressure_offset", rows(|set| &set.pressure_offset)?)?;
    Ok(dict)
}

/// Writes corrections, and reads them again to check them.
#[pyfunction]
pub(crate) fn write_corrections(
    py: Python<'_>,
    path: PathBuf,
    wing: (String, String),
    v_m_s: PyReadonlyArray1<'_, f64>,
    families: [PyReadonlyArray2<'_, f64>; 3],
) -> PyResult<()> {
    let row = |family: &PyReadonlyArray2<'_, f64>, i: usize| family.as_array().row(i).to_vec();
    let [force, moment, offset] = &families;
    let set = |(i, &v_m_s): (usize, &f64)| CorrectionSet {
        v_m_s,
        corrections: Corrections {
            force: row(force, i),
            moment: row(moment, i),
            pressure_offset: row(offset, i),
        },
    };
    let sets = v_m_s.as_array().iter().enumerate().map(set).collect();
    let (wing, wing_hash) = wing;
    let schedule = Schedule { wing, wing_hash, sets, found: None, unconverged: Vec::new() };
    checked(py, write(&path, &schedule.to_ron()).and_then(|()| Schedule::read(&path).map(drop)))
}

/// What the library knows of effects for a wing with these controls: name, form, title, parameters with bounds.
#[pyfunction]
pub(crate) fn effect_library(py: Python<'_>, controls: Vec<String>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    let each = |effect: &dyn wingroot::maneuver::effects::Effect| {
        let dict = PyDict::new(py);
        dict.set_item("name", effect.spec().name)?;
        dict.set_item("form", effect.form())?;
        dict.set_item("title", effect.spec().title)?;
        dict.set_item("rivals", effect.spec().rivals)?;
        let parameters = PyDict::new(py);
        for parameter in effect.parameters() {
            parameters.set_item(parameter.name, (parameter.lower, parameter.upper, parameter.plausible))?;
        }
        dict.set_item("parameters", parameters)?;
        Ok(dict)
    };
    library(&controls).iter().map(|effect| each(effect.as_ref())).collect()
}

/// Name, the wing's file, airspeed of the corrections and density of an aircraft.
#[pyfunction]
pub(crate) fn read_aircraft(py: Python<'_>, path: PathBuf) -> PyResult<(String, PathBuf, f64, f64)> {
    let file = checked(py, py.detach(|| AircraftFile::read(&path)))?;
    let wing = file.wing_path();
    Ok((file.name, wing, file.correction_airspeed_m_s, file.rho_kg_m3))
}

/// The columns of a CSV file: numbers, or words where a cell is no number.
#[pyfunction]
pub(crate) fn read_table(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let table = checked(py, py.detach(|| Table::read(&path)))?;
    let dict = PyDict::new(py);
    for column in table.columns() {
        let cells = (0..table.len()).map(|row| table.text(row, column)).collect::<Result<Vec<_>, _>>();
        let cells = checked(py, cells)?;
        let number = |cell: &&str| if cell.is_empty() { Some(f64::NAN) } else { cell.parse().ok() };
        match cells.iter().map(number).collect::<Option<Vec<f64>>>() {
            Some(numbers) => dict.set_item(column, numbers.into_pyarray(py))?,
            None => dict.set_item(column, cells)?,
        }
    }
    Ok(dict)
}
