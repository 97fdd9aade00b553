//! A campaign: a folder of measurements (`campaign.ron`, `static.csv`, runs), read and checked.

use nastran::table::Table;
use nastran::{InputError, Span, named_file, ron_file};
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// The three channels of the balance, in the order of every array here.
pub const CHANNELS: [&str; 3] = ["Fz_N", "Mx_Nm", "My_Nm"];

/// Airspeeds of measurements, m/s: below, dynamic pressure means nothing; above, incompressible flow.
pub const AIRSPEEDS_M_S: std::ops::RangeInclusive<f64> = 0.1..=340.0;

/// One standard deviation of each channel.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ChannelNoise {
    /// Fz, N.
    #[serde(rename = "fz_N")]
    pub fz_n: f64,
    /// Mx, N m.
    #[serde(rename = "mx_Nm")]
    pub mx_nm: f64,
    /// My, N m.
    #[serde(rename = "my_Nm")]
    pub my_nm: f64,
}

impl ChannelNoise {
    /// In the order Fz, Mx, My.
    pub fn to_array(self) -> [f64; 3] {
        [self.fz_n, self.mx_nm, self.my_nm]
    }
}

/// Declared noise of a campaign.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Noise {
    /// Of one sample of a run.
    pub sample: ChannelNoise,
    /// Of one row of the static cases, which is an average already.
    pub static_point: ChannelNoise,
}

/// What a run may be used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Use {
    /// To find and fit.
    Train,
    /// Only to judge.
    Holdout,
}

/// A run's entry in `campaign.ron`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
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

/// `campaign.ron` as written.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields, rename = "Campaign")]
struct CampaignFile {
    name: String,
    rho_kg_m3: f64,
    #[serde(default)]
    noise: Option<Noise>,
    static_cases: String,
    #[serde(default)]
    runs: Vec<RunEntry>,
}

/// One row of the static cases.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticPoint {
    /// Airspeed, m/s; zero for a tilt tare.
    pub v_m_s: f64,
    /// Angle of attack of the balance, rad.
    pub alpha_rad: f64,
    /// Fz, Mx, My (N, N m, N m); none for a channel the campaign lacks.
    pub loads: [Option<f64>; 3],
    /// Day or mounting.
    pub block: Option<String>,
    /// Control deflections that are not zero, by name, rad.
    pub controls_rad: Vec<(String, f64)>,
    /// Tip deflection from the wind-off shape at alpha = 0, m.
    pub tip_z_m: Option<f64>,
    /// Where the row stands.
    pub span: Span,
}

/// A campaign as read.
#[derive(Debug, Clone)]
pub struct Campaign {
    /// Its name.
    pub name: String,
    /// Its folder.
    pub folder: PathBuf,
    /// Air density, kg/m³.
    pub rho_kg_m3: f64,
    /// Declared noise.
    pub noise: Option<Noise>,
    /// Which channels it has.
    pub channels: [bool; 3],
    /// All rows of the static cases, tilt tares included.
    pub points: Vec<StaticPoint>,
    /// Runs.
    pub runs: Vec<RunEntry>,
}

impl Campaign {
    /// Reads a campaign folder.
    ///
    /// # Errors
    /// A missing file, a misspelt field or column, a cell that is empty or not a number, no load channel at all.
    pub fn read(folder: &Path) -> Result<Self, InputError> {
        let path = folder.join("campaign.ron");
        let file: CampaignFile = ron_file::read(&path)?;
        if !(file.rho_kg_m3.is_finite() && file.rho_kg_m3 > 0.0) {
            return Err(InputError::in_field(&path, "rho_kg_m3", "rho_kg_m3 must be a positive number")
                .with_help("air at sea level has 1.225 kg/m3"));
        }
        if let Some(noise) = &file.noise {
            let all = noise.sample.to_array().into_iter().chain(noise.static_point.to_array());
            if all.into_iter().any(|sigma| !(sigma.is_finite() && sigma > 0.0)) {
                return Err(InputError::in_field(
                    &path,
                    "noise",
                    "noise must be positive standard deviations",
                )
                .with_help("write `noise: None` to have it estimated from replicates"));
            }
        }
        let statics = named_file(&path, &file.static_cases)?;
        let table = Table::read(&statics)?;
        let (channels, points) = static_points(&table, &statics)?;
        Ok(Self {
            name: file.name,
            folder: folder.to_path_buf(),
            rho_kg_m3: file.rho_kg_m3,
            noise: file.noise,
            channels,
            points,
            runs: file.runs,
        })
    }
}

/// Reads the rows of `static.csv`.
fn static_points(table: &Table, path: &Path) -> Result<([bool; 3], Vec<StaticPoint>), InputError> {
    table.require(&["V_m_s", "alpha_deg"])?;
    table.allow_only(
        |name| {
            ["V_m_s", "alpha_deg", "block", "tip_z_m"].contains(&name)
                || CHANNELS.contains(&name)
                || (name.starts_with("delta_") && name.ends_with("_deg"))
        },
        "V_m_s, alpha_deg, Fz_N, Mx_Nm, My_Nm, block, tip_z_m or delta_NAME_deg",
    )?;
    if table.is_empty() {
        return Err(InputError::in_file(path, "there are no static cases below the header")
            .with_help("calibration needs at least three angles at one airspeed"));
    }
    let has = |name: &str| table.has(name);
    let channels = CHANNELS.map(has);
    if !channels.contains(&true) {
        return Err(InputError::at(
            &table.span(0, "V_m_s"),
            "none of the columns Fz_N, Mx_Nm, My_Nm is there",
        )
        .with_help("a static case needs at least one measured load"));
    }
    let controls: Vec<&str> = table.columns().filter(|name| name.starts_with("delta_")).collect();
    let optional = |row: usize, name: &str| has(name).then(|| table.number(row, name)).transpose();
    let mut points = Vec::with_capacity(table.len());
    for row in 0..table.len() {
        let v_m_s = table.number(row, "V_m_s")?;
        if v_m_s != 0.0 && !AIRSPEEDS_M_S.contains(&v_m_s) {
            let message = format!("the airspeed {v_m_s:?} m/s is neither zero nor within 0.1 to 340 m/s");
            return Err(InputError::at(&table.span(row, "V_m_s"), message)
                .with_help("zero marks a tilt tare; the air is taken as incompressible"));
        }
        let alpha_deg = table.number(row, "alpha_deg")?;
        if alpha_deg.abs() > 90.0 {
            let message = format!("the angle of attack {alpha_deg:?} degrees is beyond 90 degrees");
            return Err(InputError::at(&table.span(row, "alpha_deg"), message)
                .with_help("angles are in degrees, nose up positive"));
        }
        let mut controls_rad = Vec::new();
        for name in &controls {
            let delta_deg = table.number(row, name)?;
            if delta_deg != 0.0 {
                let name = name.trim_start_matches("delta_").trim_end_matches("_deg");
                controls_rad.push((name.to_owned(), delta_deg.to_radians()));
            }
        }
        points.push(StaticPoint {
            v_m_s,
            alpha_rad: alpha_deg.to_radians(),
            loads: [optional(row, CHANNELS[0])?, optional(row, CHANNELS[1])?, optional(row, CHANNELS[2])?],
            block: has("block").then(|| table.text(row, "block").map(str::to_owned)).transpose()?,
            controls_rad,
            tip_z_m: optional(row, "tip_z_m")?,
            span: table.span(row, "V_m_s"),
        });
    }
    Ok((channels, points))
}
