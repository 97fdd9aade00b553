//! How far what was flown covers the design: the instants that drive it beside the airspeeds and load factors flown, and the largest
//! loads measured beside the design loads.

use schemars::JsonSchema;
use serde::Serialize;

/// Ranges that were flown; none of what was not recorded.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Flown {
    /// Smallest and largest airspeed, m/s TAS.
    pub v_m_s: Option<[f64; 2]>,
    /// Smallest and largest load factor.
    pub n_z: Option<[f64; 2]>,
}

/// An instant that drives the design, and whether its airspeed and load factor lie within those flown.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CoveredInstant {
    /// Load set.
    pub sid: u32,
    /// Case.
    pub case: usize,
    /// State of loading.
    pub mass: String,
    /// Airspeed, m/s TAS.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Load factor.
    pub n_z: f64,
    /// Whether the airspeed lies within those flown; left out if airspeeds were not recorded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub v_is_flown: Option<bool>,
    /// Whether the load factor lies within those flown; left out if load factors were not recorded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n_is_flown: Option<bool>,
}

impl CoveredInstant {
    /// Whether both were flown.
    pub fn is_flown(&self) -> bool {
        self.v_is_flown == Some(true) && self.n_is_flown == Some(true)
    }
}

/// An end of a design load beside what was measured.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CoveredLoad {
    /// Station of the measurement.
    pub station: String,
    /// Load.
    pub load: &'static str,
    /// `smallest` or `largest`.
    pub end: &'static str,
    /// That end of what was measured, N or N m.
    pub measured: f64,
    /// That end of the design loads there, N or N m.
    pub design: f64,
    /// Design over measured where that is above one: calculated loads are extrapolated by it. Left out where no load of that sign was
    /// measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extrapolated_by: Option<f64>,
}

/// See the module.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
pub struct Coverage {
    /// Instants that drive the design.
    pub instants: Vec<CoveredInstant>,
    /// Both ends of every measured load.
    pub loads: Vec<CoveredLoad>,
}

fn within(range: Option<[f64; 2]>, value: f64) -> Option<bool> {
    range.map(|[low, high]| (low..=high).contains(&value))
}

impl Flown {
    /// Marks an instant by the ranges flown.
    #[must_use]
    pub fn marked(&self, instant: CoveredInstant) -> CoveredInstant {
        let (v_is_flown, n_is_flown) = (within(self.v_m_s, instant.v_m_s), within(self.n_z, instant.n_z));
        CoveredInstant { v_is_flown, n_is_flown, ..instant }
    }
}

impl CoveredLoad {
    /// Sets the end of a design load beside that of the measured ones.
    pub fn new(station: &str, load: &'static str, end: &'static str, measured: f64, design: f64) -> Self {
        let same_side = measured * design > 0.0;
        let factor = (design / measured).max(1.0);
        // a design load on this side of zero that was not measured there is beyond any factor
        let towards = if end == "largest" { design > 0.0 } else { design < 0.0 };
        let extrapolated_by = if towards { same_side.then_some(factor) } else { Some(1.0) };
        Self { station: station.to_owned(), load, end, measured, design, extrapolated_by }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_design_load_beyond_the_measured_one_is_extrapolated_and_one_of_another_sign_was_not_flown() {
        let of =
            |end, measured, design| CoveredLoad::new("root", "Mx", end, measured, design).extrapolated_by;
        assert_eq!(of("largest", 100.0, 131.0), Some(1.31));
        assert_eq!(of("largest", 100.0, 80.0), Some(1.0), "flown beyond it");
        assert_eq!(of("smallest", -20.0, -50.0), Some(2.5));
        assert_eq!(of("smallest", 5.0, -50.0), None, "no load downwards was measured");
        assert_eq!(of("smallest", 5.0, 1.0), Some(1.0), "an end that is no load of its sign");
    }

    #[test]
    fn an_instant_is_flown_if_airspeed_and_load_factor_lie_within_what_was_flown() {
        let instant = CoveredInstant {
            sid: 1,
            case: 7,
            mass: "full".to_owned(),
            v_m_s: 37.0,
            n_z: 3.8,
            v_is_flown: None,
            n_is_flown: None,
        };
        let flown = Flown { v_m_s: Some([20.0, 40.0]), n_z: Some([0.5, 3.0]) };
        let marked = flown.marked(instant.clone());
        assert_eq!(
            (marked.v_is_flown, marked.n_is_flown, marked.is_flown()),
            (Some(true), Some(false), false)
        );
        let marked = Flown { n_z: Some([-1.5, 4.0]), ..flown }.marked(instant.clone());
        assert!(marked.is_flown());
        let unknown = Flown { n_z: None, ..flown }.marked(instant);
        assert_eq!(
            (unknown.n_is_flown, unknown.is_flown()),
            (None, false),
            "what was not recorded is not flown"
        );
    }
}
