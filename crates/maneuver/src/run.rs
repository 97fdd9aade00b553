//! A measured run: inputs and loads over a uniform time, read from CSV and checked.

use nastran::table::{ColumnNames, Table};
use nastran::{InputError, Span};
use std::path::Path;

mod sampling;

/// Airspeeds of runs, m/s, zero without wind: the air is taken as incompressible.
pub const AIRSPEEDS_M_S: std::ops::RangeInclusive<f64> = 0.0..=340.0;
/// The airspeed may stray by this share of its mean within a run (not whether two airspeeds are one: `aero::flow`).
const STRAYS: f64 = 0.02;

/// A run as measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Name of the file without folder and ending.
    pub name: String,
    /// Time of every sample, s.
    pub t_s: Vec<f64>,
    /// Time step, s.
    pub time_step_s: f64,
    /// Mean airspeed, m/s; zero for a wind-off run.
    pub v_m_s: f64,
    /// Measured angle of attack of the balance, rad.
    pub alpha_rad: Vec<f64>,
    /// Measured Fz, Mx, My (N, N m, N m); none unless the file has all three.
    pub loads: Option<[Vec<f64>; 3]>,
    /// Those of Fz, Mx, My that were measured where the file has one or two of them; else none.
    pub some_loads: [Option<Vec<f64>>; 3],
    /// Commanded deflections by control, rad.
    pub controls_rad: Vec<(String, Vec<f64>)>,
    /// Measured tip deflection, m.
    pub tip_z_m: Option<Vec<f64>>,
    /// Measured accelerations by sensor, m/s².
    pub accelerations: Vec<(String, Vec<f64>)>,
}

impl Run {
    /// Reads a run.
    ///
    /// # Errors
    /// A missing or misspelt column, a cell that is not a number, times that are no uniform sampling, an airspeed that
    /// is not constant within 2 %, fewer than three samples.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::read_named(path, &ColumnNames::new())
    }

    /// Reads a run in which some columns have other names, as its campaign says.
    ///
    /// # Errors
    /// As [`Run::read`].
    pub fn read_named(path: &Path, theirs: &ColumnNames) -> Result<Self, InputError> {
        let table = Table::read_named(path, theirs)?;
        let name = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        Self::from_table(name, &table, path)
    }

    /// Whether a run's file may have a column.
    pub fn has_column(column: &str) -> bool {
        ["t_s", "V_m_s", "alpha_deg", "tip_z_m", "Fz_N", "Mx_Nm", "My_Nm"].contains(&column)
            || inner(column, "delta_", "_deg").is_some()
            || inner(column, "az_", "_m_s2").is_some()
    }

    fn from_table(name: String, table: &Table, path: &Path) -> Result<Self, InputError> {
        table.require(&["t_s", "V_m_s", "alpha_deg"])?;
        let loads = ["Fz_N", "Mx_Nm", "My_Nm"];
        table.allow_only(
            Self::has_column,
            "t_s, V_m_s, alpha_deg, Fz_N, Mx_Nm, My_Nm, tip_z_m, delta_NAME_deg or az_NAME_m_s2",
        )?;
        if table.len() < 3 {
            return Err(InputError::in_file(
                path,
                format!("a run needs at least three samples, this has {}", table.len()),
            )
            .with_help("every row is a sample; lines starting with # are comments"));
        }
        let measured = loads.iter().filter(|column| table.has(column)).count();
        let t_s = table.numbers("t_s")?;
        let columns =
            |prefix: &str, suffix: &str, angle: bool| -> Result<Vec<(String, Vec<f64>)>, InputError> {
                let named = table
                    .columns()
                    .filter_map(|column| inner(column, prefix, suffix).map(|name| (column, name)));
                named
                    .map(|(column, name)| {
                        let values = if angle { angles(table, column)? } else { table.numbers(column)? };
                        Ok((name.to_owned(), values))
                    })
                    .collect()
            };
        let load = |name: &str| (measured < 3 && table.has(name)).then(|| table.numbers(name)).transpose();
        Ok(Self {
            name,
            time_step_s: sampling::time_step(&t_s, |row| table.span(row, "t_s"))?,
            v_m_s: airspeed(&table.numbers("V_m_s")?, |row| table.span(row, "V_m_s"))?,
            alpha_rad: angles(table, "alpha_deg")?,
            loads: if measured == 3 {
                Some([table.numbers(loads[0])?, table.numbers(loads[1])?, table.numbers(loads[2])?])
            } else {
                None
            },
            some_loads: [load(loads[0])?, load(loads[1])?, load(loads[2])?],
            controls_rad: columns("delta_", "_deg", true)?,
            tip_z_m: table.has("tip_z_m").then(|| table.numbers("tip_z_m")).transpose()?,
            accelerations: columns("az_", "_m_s2", false)?,
            t_s,
        })
    }

    /// What was measured of Fz, Mx or My (0, 1, 2), N or N m.
    pub fn load(&self, channel: usize) -> Option<&[f64]> {
        let all = self.loads.as_ref().map(|loads| loads[channel].as_slice());
        all.or(self.some_loads[channel].as_deref())
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.t_s.len()
    }

    /// Never true: a run has at least three samples.
    pub fn is_empty(&self) -> bool {
        self.t_s.is_empty()
    }
}

/// A column of angles, from degrees to rad.
fn angles(table: &Table, column: &str) -> Result<Vec<f64>, InputError> {
    let degrees = table.numbers(column)?;
    if let Some(row) = degrees.iter().position(|angle| angle.abs() > 90.0) {
        let message = format!("{column} is {:?}, beyond 90 degrees", degrees[row]);
        return Err(InputError::at(&table.span(row, column), message).with_help("angles are in degrees"));
    }
    Ok(degrees.into_iter().map(f64::to_radians).collect())
}

/// NAME of `prefixNAMEsuffix`.
fn inner<'a>(column: &'a str, prefix: &str, suffix: &str) -> Option<&'a str> {
    column.strip_prefix(prefix)?.strip_suffix(suffix).filter(|name| !name.is_empty())
}

/// The mean airspeed, or the line that is too far from it.
fn airspeed(v_m_s: &[f64], span: impl Fn(usize) -> Span) -> Result<f64, InputError> {
    if let Some(row) = v_m_s.iter().position(|v| !AIRSPEEDS_M_S.contains(v)) {
        let message =
            format!("the airspeed {:?} m/s is not within 0 to {} m/s", v_m_s[row], AIRSPEEDS_M_S.end());
        return Err(InputError::at(&span(row), message).with_help("zero marks a wind-off run"));
    }
    let mean = v_m_s.iter().sum::<f64>() / v_m_s.len() as f64;
    let far = |v: &f64| (v - mean).abs() > STRAYS * mean.max(1e-3);
    match v_m_s.iter().position(far) {
        None => Ok(mean),
        Some(row) => {
            let message = format!(
                "the airspeed {} m/s is more than 2 % from the run's mean of {mean:.3} m/s",
                v_m_s[row]
            );
            Err(InputError::at(&span(row), message).with_help("a run is flown at one airspeed; split it"))
        }
    }
}
