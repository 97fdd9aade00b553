//! A grid of cases flown: all cases of a model at one airspeed with one factorisation.
//!
//! A case that cannot be flown (no such trim, divergence) is a result too: it says why. Numbers of a result go through text
//! (JSON) before anything is made of them, so a result read back from a file is the same as one just found.

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::FlightPoint;
use crate::cases::file::{Action, CasesFile};
use crate::cases::list::{Case, MODELS};
use crate::error::AircraftError;
use crate::flight::air::FlightAir;
use crate::flight::history::FlightHistory;
use crate::flight::small_motions::FreeFlight;
use crate::trim::case::{TrimAt, TrimTools};
use crate::trim::model::FlightModel;
use crate::{LiftLimits, Trimmed};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// How cases are flown and written; another number where results of the same version would not be comparable.
const RULES: &str = "3";
/// Smallest and largest loads at a station; the same twice in steady flight.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StationLoads {
    /// The station.
    pub station: String,
    /// Fz, N.
    #[serde(rename = "Fz_N")]
    pub fz_n: [f64; 2],
    /// Mx, N m.
    #[serde(rename = "Mx_Nm")]
    pub mx_nm: [f64; 2],
    /// My, N m.
    #[serde(rename = "My_Nm")]
    pub my_nm: [f64; 2],
}

/// What came of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CaseResult {
    /// Its place in the grid.
    pub number: usize,
    /// `initial` or `updated`.
    pub model: String,
    /// What was flown.
    pub maneuver: String,
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Load factor asked for.
    pub load_factor: f64,
    /// Why it could not be flown.
    pub refused: Option<String>,
    /// Variables and motions by name, of the trim the case is or starts from.
    pub values: BTreeMap<String, f64>,
    /// Smallest and largest height of the right and the left tip over the plane of the wing's root, m. In motion the
    /// right tip's accelerometer's, for the right only.
    pub tip_deflection_m: Vec<[f64; 2]>,
    /// Loads of each station; in motion of the roots and the stations of the wing's file.
    pub loads: Vec<StationLoads>,
    /// What to be wary of.
    pub warnings: Vec<String>,
}

/// Everything cases are flown with.
#[derive(Debug)]
pub struct CaseFlight<'a> {
    /// Shared by all trims.
    pub tools: &'a TrimTools<'a>,
    /// Initial and updated model.
    pub models: [&'a FlightModel<'a>; 2],
    /// Modes and their air, if a case is dynamic.
    pub air: Option<&'a FlightAir>,
    /// Lift limits of the section, for warnings.
    pub limits: Option<&'a [LiftLimits]>,
}

/// A model at one airspeed, or why it cannot fly there.
#[derive(Debug)]
pub struct GroupAt<'a> {
    at: Result<TrimAt<'a>, String>,
}

impl Case {
    fn blank(&self) -> CaseResult {
        CaseResult {
            number: self.number,
            model: MODELS[self.model].to_owned(),
            maneuver: self.maneuver(),
            v_m_s: self.v_m_s,
            load_factor: self.steady().load_factor(),
            refused: None,
            values: BTreeMap::new(),
            tip_deflection_m: Vec::new(),
            loads: Vec::new(),
            warnings: Vec::new(),
        }
    }
}

impl CaseFlight<'_> {
    /// Flies cases of one model at one airspeed, one after the other: one factorisation for all trims among them. `done` gets
    /// each result in turn and may stop the rest with an error.
    ///
    /// # Errors
    /// As those of [`one`](Self::one), and what `done` says.
    pub fn fly<E: From<AircraftError>>(
        &self,
        cases: &[&Case],
        done: &mut dyn FnMut(&Case, CaseResult) -> Result<(), E>,
    ) -> Result<(), E> {
        let Some(first) = cases.first() else { return Ok(()) };
        let at = self.at(first);
        cases.iter().try_for_each(|case| done(case, self.one(case, &at)?))
    }

    /// What all cases of this one's model and airspeed are flown with.
    pub fn at(&self, case: &Case) -> GroupAt<'_> {
        GroupAt { at: self.tools.at(self.models[case.model], case.v_m_s).map_err(|error| error.to_string()) }
    }

    /// Flies a case of the model and airspeed that `at` is of.
    ///
    /// # Errors
    /// Names that the aircraft does not know. Whatever else goes wrong is a result.
    pub fn one(&self, case: &Case, at: &GroupAt<'_>) -> Result<CaseResult, AircraftError> {
        let refused = |why: String| CaseResult { refused: Some(why), ..case.blank() };
        let at = match &at.at {
            Ok(at) => at,
            Err(why) => return Ok(refused(why.clone())),
        };
        match self.flown(case, at) {
            Ok(result) => Ok(result.if_finite()),
            Err(AircraftError::NotTrimmable { why, .. }) => Ok(refused(why)),
            Err(AircraftError::Input(error)) => Err(AircraftError::Input(error)),
            Err(other) => Ok(refused(other.to_string())),
        }
    }

    fn flown(&self, case: &Case, at: &TrimAt<'_>) -> Result<CaseResult, AircraftError> {
        let (aircraft, model) = (self.tools.aircraft, self.models[case.model]);
        let mut result = case.blank();
        let balanced = at.solve(&case.steady().case(&aircraft.file, case.v_m_s))?;
        let pair = |value: f64| [value, value];
        let point = FlightPoint {
            v_m_s: case.v_m_s,
            load_factor: at.value(&balanced, "n_z").unwrap_or(1.0),
            pitch_rate_deg_s: at.value(&balanced, "pitch_rate_deg_s").unwrap_or(0.0),
        };
        let trimmed = at.trimmed(&balanced, &point);
        result.values = at.values(&balanced).map(|(name, value)| (name.to_owned(), value)).collect();
        result.warnings = aircraft.validity(&result.maneuver, &trimmed, self.limits);
        if let Some(history) = self.history(case, model, &trimmed, &mut result.warnings)? {
            result.tip_deflection_m = vec![range(&history.tip_deflection_m)];
            result.loads = self.flown_loads(&history, &at.station_loads(&balanced));
        } else {
            result.tip_deflection_m = trimmed.tip_deflection_m.map(pair).to_vec();
            let stations = self.tools.stations.iter().zip(at.station_loads(&balanced));
            result.loads = stations.map(|(place, loads)| station(&place.name, loads.map(pair))).collect();
        }
        Ok(result)
    }

    /// Loads in flight at the roots and at those stations that the wing's file has: the trim's, and how they change from its
    /// start on.
    fn flown_loads(&self, history: &FlightHistory, steady: &[[f64; 3]]) -> Vec<StationLoads> {
        let roots = [("right root", &history.root_right), ("left root", &history.root_left)];
        let mut all = roots.map(|(name, loads)| station(name, [0, 1, 2].map(|i| range(&loads[i])))).to_vec();
        for (place, steady) in self.tools.stations.iter().zip(steady) {
            let Some(flown) = history.stations.iter().find(|flown| flown.name == place.channel) else {
                continue;
            };
            let load = |i: usize| {
                let start = flown.loads[i].first().copied().unwrap_or(0.0);
                range(&flown.loads[i]).map(|value| steady[i] + (value - start))
            };
            all.push(station(&place.name, [0, 1, 2].map(load)));
        }
        all
    }

    fn history(
        &self,
        case: &Case,
        model: &FlightModel<'_>,
        trimmed: &Trimmed,
        warnings: &mut Vec<String>,
    ) -> Result<Option<FlightHistory>, AircraftError> {
        let Action::Motion(motion) = &case.action else { return Ok(None) };
        let own;
        let air = if let Some(air) = self.air {
            air
        } else {
            own = FlightAir::new(model.aircraft)?;
            &own
        };
        let flight = FreeFlight::new(model, air, trimmed, motion.control().unwrap_or_default())?;
        warnings.extend(flight.warning(&case.maneuver(), motion.record_s()));
        Ok(Some(flight.fly_motion(motion)))
    }
}

impl CaseResult {
    /// The result, or a refusal if one of its numbers is not finite: such a number would not survive as text.
    fn if_finite(self) -> Self {
        let loads = self.loads.iter().flat_map(|s| [s.fz_n, s.mx_nm, s.my_nm]).flatten();
        let mut all =
            loads.chain(self.tip_deflection_m.iter().flatten().copied()).chain(self.values.values().copied());
        if all.all(f64::is_finite) {
            return self;
        }
        drop(all);
        let refused = Some("its loads are not finite: a motion grows beyond all numbers".to_owned());
        Self { refused, values: BTreeMap::new(), tip_deflection_m: Vec::new(), loads: Vec::new(), ..self }
    }

    /// Model, maneuver, airspeed and load factor in words.
    pub fn label(&self) -> String {
        format!("{}, {} m/s, n = {}", self.maneuver, self.v_m_s, self.load_factor)
    }
}

fn station(name: &str, [fz_n, mx_nm, my_nm]: [[f64; 2]; 3]) -> StationLoads {
    StationLoads { station: name.to_owned(), fz_n, mx_nm, my_nm }
}

fn range(values: &[f64]) -> [f64; 2] {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // min and max pass over what is no number
    if values.iter().all(|value| value.is_finite()) { [low, high] } else { [f64::NAN; 2] }
}

impl Aircraft {
    /// What results of cases depend on beside the case, as text by name: the aircraft, its wing, the corrections of one wing's
    /// boxes, the stations, and how results are made and written.
    pub fn inputs_of_cases(
        &self,
        corrections: &aero::Corrections,
        file: &CasesFile,
    ) -> [(&'static str, String); 5] {
        let limits = self.file.lift_limits().ok();
        [
            ("aircraft", format!("{} {limits:?}", self.file.text())),
            ("wing", self.wing.hash.clone()),
            ("corrections", format!("{corrections:?}")),
            ("stations", format!("{:?}", file.stations)),
            ("rules of cases", RULES.to_owned()),
        ]
    }
}
