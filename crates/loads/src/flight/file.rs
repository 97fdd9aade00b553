//! The RON file of measured loads: gauges, conditions, what is asked of the calculation.

use crate::compare::{Gauge, Thresholds, Zero};
use crate::select::file::Load;
use nastran::{InputError, place_of, read_text, ron_file};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Measured loads as their file describes them.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "FlightLoads")]
pub struct FlightFile {
    /// What reports call it.
    pub name: String,
    /// The wing in the tunnel that loads are calculated for; left out: conditions bring calculated loads with them.
    #[serde(default)]
    pub wing: Option<String>,
    /// Density of the air at points of the wing, kg/m3; a campaign brings its own.
    #[serde(default)]
    pub rho_kg_m3: Option<f64>,
    /// Corrections of the updated model; left out: found from the points that are marked as fitted.
    #[serde(default)]
    pub corrections: Option<String>,
    /// Stations and what their gauges read.
    pub stations: Vec<Station>,
    /// What was measured.
    pub conditions: Vec<ConditionInFile>,
    /// Noise of the measured state, one standard deviation.
    #[serde(default)]
    pub state_sigma: StateSigma,
    /// Slopes within this of one are reliable.
    pub reliable_within_percent: f64,
    /// A bias within so many standard deviations of the measurement is reliable.
    pub bias_within_sigma: f64,
    /// Loads from this share of the largest one on are large.
    pub large_from_percent: f64,
    /// Tables of points that fitted the corrections.
    #[serde(default)]
    pub fitted: Vec<String>,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
}

/// A station with gauges.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Station {
    /// Its name, which begins its columns: `NAME_Mx_Nm`; those of `root` may be `Mx_Nm`.
    pub name: String,
    /// Loads.
    pub loads: Vec<GaugeInFile>,
}

/// A gauge.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GaugeInFile {
    /// What it reads.
    pub load: Load,
    /// Standard deviation of a reading, N or N m; left out: that of the residuals.
    #[serde(default)]
    pub sigma: Option<f64>,
    /// Standard deviation of its calibration factor, percent.
    #[serde(default)]
    pub factor_sigma_percent: f64,
    /// Whether its reading without load is known.
    #[serde(default)]
    pub zero: Zero,
}

/// What was measured in a condition: one of `points`, `history`, `campaign` and `sections`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConditionInFile {
    /// What reports call it.
    pub name: String,
    /// A table of steady points.
    #[serde(default)]
    pub points: Option<String>,
    /// A table over time.
    #[serde(default)]
    pub history: Option<String>,
    /// How many of the largest and of the smallest extremes of a history are compared.
    #[serde(default)]
    pub extremes: Option<usize>,
    /// A folder with a wind-tunnel campaign, whose static cases are points.
    #[serde(default)]
    pub campaign: Option<String>,
    /// A table of lift coefficients of the wing's sections (`V_m_s`, `alpha_deg`, `two_y_over_b`, `cl`): each stands for the part of the
    /// half wing that is nearest to it, as a station of its own, whose Fz is compared.
    #[serde(default)]
    pub sections: Option<String>,
    /// Every so many angles of a campaign fit the corrections, from the smallest on; the others are judged.
    #[serde(default)]
    pub fit_every: Option<usize>,
}

/// Noise of the measured state.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StateSigma {
    /// Airspeed, m/s.
    #[serde(rename = "V_m_s", default)]
    pub v_m_s: f64,
    /// Angle of attack, deg.
    #[serde(default)]
    pub alpha_deg: f64,
}

/// Where a condition's points are.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A table of points.
    Points(String),
    /// A history with so many extremes at either end.
    History(String, usize),
    /// A campaign's folder, with every so many angles fitted.
    Campaign(String, Option<usize>),
    /// A table of sections' lift.
    Sections(String),
}

/// A condition as it was checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Condition {
    /// Its name.
    pub name: String,
    /// Its points.
    pub source: Source,
}

/// A load at a station with its gauge.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Station.
    pub station: String,
    /// Load.
    pub load: Load,
    /// Gauge.
    pub gauge: Gauge,
}

impl Channel {
    /// Its column in tables.
    pub fn column(&self) -> String {
        format!("{}_{}", self.station, self.plain())
    }

    /// Its column without the station.
    pub fn plain(&self) -> String {
        format!("{}_{}", self.load.name(), self.load.unit().replace(' ', ""))
    }
}

impl FlightFile {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// If it cannot be read, a number makes no sense, or a condition has no points.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let mut file: Self = ron_file::read(path)?;
        file.path = path.to_path_buf();
        file.check()?;
        file.conditions()?;
        Ok(file)
    }

    /// All loads that are compared, station by station.
    pub fn channels(&self) -> Vec<Channel> {
        let of = |station: &Station| -> Vec<Channel> {
            let one = |gauge: &GaugeInFile| Channel {
                station: station.name.clone(),
                load: gauge.load,
                gauge: Gauge {
                    sigma: gauge.sigma,
                    factor_sigma: gauge.factor_sigma_percent / 100.0,
                    zero: gauge.zero,
                },
            };
            station.loads.iter().map(one).collect()
        };
        self.stations.iter().flat_map(of).collect()
    }

    /// What is asked of calculated loads.
    pub fn thresholds(&self) -> Thresholds {
        Thresholds {
            reliable_within: self.reliable_within_percent / 100.0,
            bias_within_sigma: self.bias_within_sigma,
            large_from: self.large_from_percent / 100.0,
        }
    }

    /// The conditions.
    ///
    /// # Errors
    /// If one does not say where its points are.
    pub fn conditions(&self) -> Result<Vec<Condition>, InputError> {
        self.conditions.iter().map(|one| self.condition(one)).collect()
    }

    fn condition(&self, one: &ConditionInFile) -> Result<Condition, InputError> {
        let wrong =
            |message: &str, help: &str| self.at_name(&one.name, &format!("`{}` {message}", one.name), help);
        let help =
            "give one of points: \"FILE\", history: \"FILE\", campaign: \"FOLDER\" and sections: \"FILE\"";
        let source = match (&one.points, &one.history, &one.campaign, &one.sections) {
            (Some(file), None, None, None) => Source::Points(file.clone()),
            (None, Some(file), None, None) => Source::History(file.clone(), one.extremes.unwrap_or(1)),
            (None, None, Some(folder), None) => Source::Campaign(folder.clone(), one.fit_every),
            (None, None, None, Some(file)) => Source::Sections(file.clone()),
            (None, None, None, None) => return Err(wrong("has no points", help)),
            _ => return Err(wrong("has points from two places", help)),
        };
        match source {
            Source::History(_, 0) => Err(wrong("compares no extreme", "give `extremes` above zero")),
            Source::Campaign(_, Some(0 | 1)) => {
                Err(wrong("leaves no angle to judge", "give `fit_every: 2`, for instance, or leave it out"))
            }
            source => Ok(Condition { name: one.name.clone(), source }),
        }
    }

    fn check(&self) -> Result<(), InputError> {
        let wrong = |field: &str, message: &str, help: &str| {
            Err(InputError::in_field(&self.path, field, message).with_help(help))
        };
        for (field, value) in [
            ("reliable_within_percent", self.reliable_within_percent),
            ("bias_within_sigma", self.bias_within_sigma),
            ("large_from_percent", self.large_from_percent),
        ] {
            if value <= 0.0 || value >= 100.0 {
                return wrong(field, "this makes no threshold", "expected a number above zero and below 100");
            }
        }
        if self.rho_kg_m3.is_some_and(|rho| !(0.0..100.0).contains(&rho) || rho == 0.0) {
            return wrong("rho_kg_m3", "this is no density of air", "air at sea level has 1.225 kg/m3");
        }
        let noise = [self.state_sigma.v_m_s, self.state_sigma.alpha_deg];
        if noise.into_iter().any(|sigma| sigma < 0.0) {
            return wrong("state_sigma", "a standard deviation is below zero", "expected m/s and degrees");
        }
        if self.stations.iter().all(|station| station.loads.is_empty()) {
            return wrong(
                "stations",
                "no station has a load",
                "such as (name: \"root\", loads: [(load: Mx)])",
            );
        }
        if self.conditions.is_empty() {
            return wrong(
                "conditions",
                "there is no condition",
                "such as (name: \"sweep\", points: \"sweep.csv\")",
            );
        }
        for station in &self.stations {
            for gauge in &station.loads {
                if gauge.sigma.is_some_and(|sigma| sigma <= 0.0) || gauge.factor_sigma_percent < 0.0 {
                    let message = format!("a standard deviation of `{}` makes no sense", station.name);
                    return Err(self.at_name(&station.name, &message, "expected N or N m above zero"));
                }
            }
        }
        let mut names = BTreeSet::new();
        for channel in self.channels() {
            if !names.insert(channel.column()) {
                let message = format!("{} is there twice", channel.column());
                return Err(self.at_name(&channel.station, &message, "each load of a station once"));
            }
        }
        let mut names = BTreeSet::new();
        for condition in &self.conditions {
            if !names.insert(&condition.name) {
                let message = format!("two conditions are called `{}`", condition.name);
                return Err(self.at_name(&condition.name, &message, "give every condition its own name"));
            }
        }
        Ok(())
    }

    /// A complaint where a name stands in quotes.
    fn at_name(&self, name: &str, message: &str, help: &str) -> InputError {
        let text = read_text(&self.path).unwrap_or_default();
        InputError::at(&place_of(&[&format!("\"{name}\"")], &text, &self.path), message).with_help(help)
    }
}
