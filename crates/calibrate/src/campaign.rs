//! A campaign: a folder of measurements (`campaign.ron` or `campaign.json`, `static.csv`, runs), read and checked.

use crate::deflected::{control_of, deflections};
use crate::sensors::{self, Sensor};
use nastran::table::{ColumnNames, Table};
use nastran::{InputError, Span, named_file, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The columns that can be fitted, in the order of every array of four: three of the balance, and the tip's height.
pub const CHANNELS: [&str; 4] = ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"];

/// Index of the tip's height among [`CHANNELS`].
pub const TIP: usize = 3;

/// Airspeeds of measurements, m/s: below, dynamic pressure means nothing; above, incompressible flow.
pub const AIRSPEEDS_M_S: std::ops::RangeInclusive<f64> = 0.1..=340.0;

/// No gas of a wind tunnel is as dense, kg/m³.
const DENSEST_KG_M3: f64 = 100.0;

/// One standard deviation of each channel; left out where the campaign does not have the channel.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ChannelNoise {
    /// Fz, N.
    #[serde(rename = "fz_N")]
    pub fz_n: Option<f64>,
    /// Mx, N m.
    #[serde(rename = "mx_Nm")]
    pub mx_nm: Option<f64>,
    /// My, N m.
    #[serde(rename = "my_Nm")]
    pub my_nm: Option<f64>,
    /// Height of the tip, m.
    pub tip_z_m: Option<f64>,
}

impl ChannelNoise {
    /// In the order of [`CHANNELS`]; zero for a channel that is left out.
    pub fn to_array(self) -> [f64; 4] {
        self.given().map(|sigma| sigma.unwrap_or(0.0))
    }

    /// From the order of [`CHANNELS`].
    pub(crate) fn from_array(sigma: [f64; 4]) -> Self {
        let [fz_n, mx_nm, my_nm, tip_z_m] = sigma.map(|sigma| (sigma > 0.0).then_some(sigma));
        Self { fz_n, mx_nm, my_nm, tip_z_m }
    }

    fn given(self) -> [Option<f64>; 4] {
        [self.fz_n, self.mx_nm, self.my_nm, self.tip_z_m]
    }
}

/// What the tip's height in `static.csv` is used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum TipReading {
    /// Nothing (the default of a campaign with root loads).
    Unused,
    /// It is fitted, its zero unknown: one free offset for each block (the default without root loads).
    FreeZero,
    /// It is fitted, its zero known: the wind-off shape at alpha = 0.
    Zeroed,
}

/// How many sets of corrections a campaign asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum Sets {
    /// One for each airspeed, from its angles, as in the paper.
    #[default]
    EachAirspeed,
    /// One for all airspeeds: for sweeps of the airspeed at a few angles. Corrections belong to coefficients, so
    /// loads and tip may grow with dynamic pressure as the elastic wing's do.
    Common,
}

/// Declared noise of a campaign, one standard deviation a channel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Noise<C = ChannelNoise> {
    /// Of one sample of a run.
    pub sample: C,
    /// Of one row of the static cases, which is an average already.
    pub static_point: C,
}

/// What a run may be used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Use {
    /// To find and fit.
    Train,
    /// Only to judge.
    Holdout,
}

/// A run's entry in `campaign.ron`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RunEntry {
    /// CSV file in the campaign's folder.
    pub file: String,
    /// Training or held out; left out, the program decides and says how.
    #[serde(default, rename = "use")]
    pub usage: Option<Use>,
    /// Day or mounting.
    #[serde(default)]
    pub block: Option<String>,
    /// Clock time of the first sample, s.
    #[serde(default)]
    pub start_s: Option<f64>,
    /// File of the run this one repeats.
    #[serde(default)]
    pub repeat_of: Option<String>,
    /// Marks a run at V = 0.
    #[serde(default)]
    pub wind_off: bool,
}

/// A campaign's file as written; [`Campaign::read`] checks it.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Campaign")]
pub struct CampaignFile {
    /// What reports call it.
    pub name: String,
    /// Air density, kg/m³.
    pub rho_kg_m3: f64,
    /// Declared noise; left out: it is estimated from replicates.
    #[serde(default)]
    pub noise: Option<Noise>,
    /// What the tip's height is used for; left out: nothing, or with a free zero where there are no root loads.
    #[serde(default)]
    pub tip: Option<TipReading>,
    /// Corrections by airspeed, or one set for all.
    #[serde(default)]
    pub sets: Sets,
    /// CSV file of static points in the folder.
    pub static_cases: String,
    /// Sensors beside the balance, with columns in the static cases.
    #[serde(default)]
    pub sensors: Vec<Sensor>,
    /// What the CSV files call our columns.
    #[serde(default)]
    pub columns: ColumnNames,
    /// Runs.
    #[serde(default)]
    pub runs: Vec<RunEntry>,
}

/// One row of the static cases.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticPoint {
    /// Airspeed, m/s; zero for a weight tare.
    pub v_m_s: f64,
    /// Angle of attack of the balance, rad.
    pub alpha_rad: f64,
    /// Fz, Mx, My (N, N m, N m); none for a load the campaign lacks.
    pub loads: [Option<f64>; 3],
    /// Day or mounting.
    pub block: Option<String>,
    /// Control deflections that are not zero, by name, rad.
    pub controls_rad: Vec<(String, f64)>,
    /// Tip deflection from the wind-off shape at alpha = 0, m.
    pub tip_z_m: Option<f64>,
    /// What the campaign's sensors read, in their order; none where a cell is empty.
    pub sensors: Vec<Option<f64>>,
    /// Where the row stands.
    pub span: Span,
}

impl StaticPoint {
    /// Whether it says more than the mean of its angle does: a control deflected, a sensor read, a weight on the wing.
    pub(crate) fn says_more(&self, sensors: &[Sensor]) -> bool {
        let read = self.sensors.iter().any(Option::is_some);
        if self.v_m_s > 0.0 { read || !self.controls_rad.is_empty() } else { self.is_hung(sensors) }
    }

    /// Whether a sensor is read under a dead weight.
    pub(crate) fn is_hung(&self, sensors: &[Sensor]) -> bool {
        sensors::weight_in(sensors, &self.sensors).is_some()
    }

    /// Whether it is a tare: with wind off, and no weight on the wing.
    pub(crate) fn is_tare(&self, sensors: &[Sensor]) -> bool {
        self.v_m_s == 0.0 && !self.is_hung(sensors)
    }

    /// What was read on a channel of [`CHANNELS`]; zero where there is none.
    pub(crate) fn reading(&self, channel: usize) -> f64 {
        self.loads.get(channel).copied().unwrap_or(self.tip_z_m).unwrap_or(0.0)
    }
}

/// A campaign as read.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// Its name.
    pub name: String,
    /// Its folder.
    pub folder: PathBuf,
    /// The file that lists it, `campaign.ron` or `campaign.json`.
    pub path: PathBuf,
    /// Air density, kg/m³.
    pub rho_kg_m3: f64,
    /// Declared noise.
    pub noise: Option<Noise>,
    /// Which root loads it has.
    pub channels: [bool; 3],
    /// What its tip readings are used for.
    pub tip: TipReading,
    /// Corrections by airspeed, or one set for all.
    pub sets: Sets,
    /// Sensors beside the balance.
    pub sensors: Vec<Sensor>,
    /// All rows of the static cases, weight tares included.
    pub points: Vec<StaticPoint>,
    /// What its files call columns that have another name here: our name to theirs.
    pub columns: ColumnNames,
    /// Runs.
    pub runs: Vec<RunEntry>,
}

impl Campaign {
    /// Reads a campaign folder.
    ///
    /// # Errors
    /// A missing file, a misspelt field or column, a cell that is empty or not a number, nothing to fit.
    pub fn read(folder: &Path) -> Result<Self, InputError> {
        let path = nastran::ron_or_json::expected_in(folder, "campaign")?;
        let file: CampaignFile = ron_file::read(&path)?;
        if !(file.rho_kg_m3 > 0.0 && file.rho_kg_m3 < DENSEST_KG_M3) {
            return Err(InputError::in_field(
                &path,
                "rho_kg_m3",
                "rho_kg_m3 must be a positive number below 100",
            )
            .with_help("air at sea level has 1.225 kg/m3"));
        }
        check_columns(&file.columns, &path)?;
        let statics = named_file(&path, &file.static_cases)?;
        let table = Table::read_named(&statics, &file.columns)?;
        sensors::check(&file.sensors, is_static_column, &path)?;
        let (channels, points) = static_points(&table, &statics, &file.sensors)?;
        let tip = file.tip.unwrap_or(if channels.contains(&true) {
            TipReading::Unused
        } else {
            TipReading::FreeZero
        });
        if tip != TipReading::Unused && !table.has("tip_z_m") {
            return Err(InputError::in_field(&path, "tip", "the static cases have no column tip_z_m to fit")
                .with_help("write `tip: Unused`, or add the column"));
        }
        let [fz, mx, my] = channels;
        if let Some(noise) = &file.noise {
            check_noise(noise, [fz, mx, my, tip != TipReading::Unused], &path)?;
        }
        Ok(Self {
            name: file.name,
            folder: folder.to_path_buf(),
            path,
            rho_kg_m3: file.rho_kg_m3,
            noise: file.noise,
            channels,
            tip,
            sets: file.sets,
            sensors: file.sensors,
            points,
            columns: file.columns,
            runs: file.runs,
        })
    }

    /// Which channels of [`CHANNELS`] are fitted.
    pub fn fitted(&self) -> [bool; 4] {
        let [fz, mx, my] = self.channels;
        [fz, mx, my, self.tip != TipReading::Unused]
    }
}

/// Declared noise is positive, and there for every channel that is fitted.
fn check_noise(noise: &Noise, fitted: [bool; 4], path: &Path) -> Result<(), InputError> {
    let fault = |message: String| {
        InputError::in_field(path, "noise", message)
            .with_help("write `noise: None` to have it estimated from replicates")
    };
    let all = noise.sample.given().into_iter().chain(noise.static_point.given());
    if all.flatten().any(|sigma| !(sigma.is_finite() && sigma > 0.0)) {
        return Err(fault("noise must be positive standard deviations".to_owned()));
    }
    match (0..CHANNELS.len()).find(|&c| fitted[c] && noise.static_point.given()[c].is_none()) {
        Some(c) => Err(fault(format!("noise of a static_point is not given for {}", CHANNELS[c]))),
        None => Ok(()),
    }
}

/// Other names belong to columns that there are, and no two to one.
fn check_columns(columns: &ColumnNames, path: &Path) -> Result<(), InputError> {
    let fault = |name: &str, message: String, help: &str| {
        let text = nastran::read_text(path).unwrap_or_default();
        let place = nastran::place_of(&["columns:", &format!("\"{name}\"")], &text, path);
        Err(InputError::at(&place, message).with_help(help))
    };
    for (ours, theirs) in columns {
        if !is_static_column(ours) && ours != "t_s" && !(ours.starts_with("az_") && ours.ends_with("_m_s2")) {
            let message = format!("`{ours}` is no column of static cases or runs");
            return fault(
                ours,
                message,
                "columns: {\"V_m_s\": \"speed\"} says that files have `speed` for `V_m_s`",
            );
        }
        if theirs.trim() != theirs || theirs.is_empty() {
            return fault(
                ours,
                format!("\"{theirs}\" is no name of a column"),
                "write it as the file's header does",
            );
        }
        if columns.iter().any(|(other, name)| other != ours && name == theirs) {
            return fault(ours, format!("`{theirs}` stands for two columns"), "each column has one meaning");
        }
    }
    Ok(())
}

fn is_static_column(name: &str) -> bool {
    ["V_m_s", "alpha_deg", "block"].contains(&name) || CHANNELS.contains(&name) || control_of(name).is_some()
}

/// Reads the rows of `static.csv`.
fn static_points(
    table: &Table,
    path: &Path,
    sensors: &[Sensor],
) -> Result<([bool; 3], Vec<StaticPoint>), InputError> {
    let columns: Vec<&str> = sensors.iter().map(|sensor| sensor.column.as_str()).collect();
    table.require(&["V_m_s", "alpha_deg"])?;
    table.require(&columns)?;
    table.allow_only(
        |name| is_static_column(name) || columns.contains(&name),
        "V_m_s, alpha_deg, Fz_N, Mx_Nm, My_Nm, block, tip_z_m, delta_NAME_deg or a sensor of campaign.ron",
    )?;
    if table.is_empty() {
        return Err(InputError::in_file(path, "there are no static cases below the header")
            .with_help("calibration needs at least three angles at one airspeed"));
    }
    let has = |name: &str| table.has(name);
    let channels = [CHANNELS[0], CHANNELS[1], CHANNELS[2]].map(has);
    if !CHANNELS.into_iter().any(has) {
        return Err(InputError::at(
            &table.span(0, "V_m_s"),
            "none of the columns Fz_N, Mx_Nm, My_Nm, tip_z_m is there",
        )
        .with_help("a static case needs at least one measured load, or the tip's height"));
    }
    let read = |row: usize, name: &str| {
        let empty = table.text(row, name)?.trim().is_empty();
        (!empty).then(|| table.number(row, name)).transpose()
    };
    let optional = |row: usize, name: &str| has(name).then(|| table.number(row, name)).transpose();
    let mut points = Vec::with_capacity(table.len());
    for row in 0..table.len() {
        let v_m_s = table.number(row, "V_m_s")?;
        if v_m_s != 0.0 && !AIRSPEEDS_M_S.contains(&v_m_s) {
            let message = format!("the airspeed {v_m_s:?} m/s is neither zero nor within 0.1 to 340 m/s");
            return Err(InputError::at(&table.span(row, "V_m_s"), message)
                .with_help("zero marks a weight tare; the air is taken as incompressible"));
        }
        let alpha_deg = table.number(row, "alpha_deg")?;
        if alpha_deg.abs() > 90.0 {
            let message = format!("the angle of attack {alpha_deg:?} degrees is beyond 90 degrees");
            return Err(InputError::at(&table.span(row, "alpha_deg"), message)
                .with_help("angles are in degrees, nose up positive"));
        }
        let cells = columns.iter().map(|name| read(row, name)).collect::<Result<Vec<_>, _>>()?;
        sensors::check_weights(sensors, v_m_s, &cells, |name| table.span(row, name))?;
        points.push(StaticPoint {
            v_m_s,
            alpha_rad: alpha_deg.to_radians(),
            loads: [optional(row, CHANNELS[0])?, optional(row, CHANNELS[1])?, optional(row, CHANNELS[2])?],
            block: has("block").then(|| table.text(row, "block").map(str::to_owned)).transpose()?,
            controls_rad: deflections(table, row)?,
            tip_z_m: optional(row, "tip_z_m")?,
            sensors: cells,
            span: table.span(row, "V_m_s"),
        });
    }
    Ok((channels, points))
}

#[cfg(test)]
mod tests;
