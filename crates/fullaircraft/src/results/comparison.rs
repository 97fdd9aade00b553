//! Everything an aircraft flies, with and without corrections, and the numbers that sum it up.

use crate::aircraft::assembly::Aircraft;
use crate::error::AircraftError;
use crate::flight::air::FlightAir;
use crate::flight::gust::Gust;
use crate::flight::history::FlightHistory;
use crate::flight::model::FlyingAircraft;
use crate::flight::nonlinear::Integration;
use crate::flight::small_motions::FreeFlight;
use crate::trim::derivatives::Derivatives;
use crate::trim::model::{FlightModel, Trimmed};
use aero::Corrections;
use maneuver::motion::MotionSpec;
use schemars::JsonSchema;
use serde::Serialize;

/// All maneuvers of one model.
#[derive(Debug, Clone)]
pub struct Flown {
    /// Steady flight.
    pub trim: Trimmed,
    /// Pull-up.
    pub pull_up: Trimmed,
    /// Push-down.
    pub push_down: Trimmed,
    /// Aileron doublet from `trim`.
    pub doublet: FlightHistory,
    /// Aileron chirp from `trim`.
    pub chirp: FlightHistory,
    /// Stability and control derivatives at the airspeed of `trim`.
    pub derivatives: Derivatives,
    /// The gust of the aircraft's file from `trim`, without linearisation.
    pub gust: Option<FlightHistory>,
    /// What to be wary of in the dynamic maneuvers.
    pub warnings: Vec<String>,
}

/// Both models.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// Without corrections.
    pub initial: Flown,
    /// With corrections.
    pub updated: Flown,
    /// Natural frequencies of the free aircraft with its structure as given, Hz; the first six are zero.
    pub frequencies_hz: Vec<f64>,
    /// What to be wary of.
    pub warnings: Vec<String>,
}

/// A steady point in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct SteadyNumbers {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// Load factor.
    pub load_factor: f64,
    /// Pitch rate.
    pub pitch_rate_deg_s: f64,
    /// Angle of the wing's root.
    pub alpha_deg: f64,
    /// Elevator, trailing edge down.
    pub elevator_deg: f64,
    /// Right tip over the plane of the centre.
    pub tip_deflection_m: f64,
}

/// A dynamic maneuver in numbers: largest absolute values.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct DynamicNumbers {
    /// Upwards, at the right tip's accelerometer.
    pub peak_tip_acceleration_m_s2: f64,
    /// Largest of roll, pitch and yaw rate there.
    pub peak_tip_rate_deg_s: f64,
    /// Change of the deflection there from trimmed flight.
    pub peak_tip_deflection_change_m: f64,
    /// Largest load factor.
    pub peak_load_factor: f64,
    /// At the right wing's root, the trim included.
    #[serde(rename = "peak_right_root_Mx_Nm")]
    pub peak_right_root_mx_nm: f64,
}

/// One model in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ModelNumbers {
    /// Steady flight.
    pub trim: SteadyNumbers,
    /// Pull-up.
    pub pull_up: SteadyNumbers,
    /// Push-down.
    pub push_down: SteadyNumbers,
    /// Aileron chirp.
    pub chirp: DynamicNumbers,
    /// Aileron doublet.
    pub doublet: DynamicNumbers,
    /// Gust.
    pub gust: Option<DynamicNumbers>,
}

/// Both models in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct BothModels {
    /// Without corrections.
    pub initial: ModelNumbers,
    /// With corrections.
    pub updated: ModelNumbers,
}

/// Derivatives of both models.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BothDerivatives {
    /// Without corrections.
    pub initial: Derivatives,
    /// With corrections.
    pub updated: Derivatives,
}

/// What `result.json` holds.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Summary {
    /// `fullaircraft`.
    pub command: &'static str,
    /// The aircraft's name.
    pub aircraft: String,
    /// Both models.
    pub models: BothModels,
    /// Stability and control derivatives and the neutral point at the airspeed of `trim`.
    pub derivatives: BothDerivatives,
    /// Airspeed whose corrections were used.
    pub correction_airspeed_m_s: f64,
    /// Number of boxes in the flow.
    pub boxes: usize,
    /// Natural frequencies of the free aircraft, rigid motions included.
    pub frequencies_hz: Vec<f64>,
    /// What to be wary of.
    pub warnings: Vec<String>,
    /// Time it took.
    pub seconds: f64,
}

impl Aircraft {
    /// Flies all maneuvers without corrections and with `wing`, the corrections of one wing's boxes.
    ///
    /// # Errors
    /// If a point cannot be trimmed, a control is not there, or the corrections have the wrong length.
    pub fn compare(&self, wing: &Corrections) -> Result<Comparison, AircraftError> {
        self.compare_acting(None, wing, [&self.file.doublet, &self.file.chirp])
    }

    /// As [`Aircraft::compare`], the updated model with a doublet and a chirp of its own, what its surfaces make of the commanded ones, and
    /// with the aircraft whose structure was `found`, if that is another.
    ///
    /// # Errors
    /// As [`Aircraft::compare`].
    pub fn compare_acting(
        &self,
        found: Option<&Self>,
        wing: &Corrections,
        [doublet, chirp]: [&MotionSpec; 2],
    ) -> Result<Comparison, AircraftError> {
        let air = FlightAir::new(self)?;
        let initial = self.uncorrected().fly_all(&air, &self.file.doublet, &self.file.chirp)?;
        let updated = match found {
            Some(found) => found.fly_acting(wing, doublet, chirp)?,
            None => self.with_corrections(wing)?.fly_all(&air, doublet, chirp)?,
        };
        let limits = self.file.lift_limits()?;
        let mut warnings = self.warnings();
        let models = [("initial", &initial, self), ("updated", &updated, found.unwrap_or(self))];
        for (model, flown, aircraft) in models {
            for (name, trimmed) in
                [("trim", &flown.trim), ("pull_up", &flown.pull_up), ("push_down", &flown.push_down)]
            {
                warnings.extend(aircraft.validity(&format!("{model}, {name}"), trimmed, limits.as_deref()));
            }
            warnings.extend(flown.warnings.iter().map(|warning| format!("{model}, {warning}")));
        }
        Ok(Comparison { initial, updated, frequencies_hz: air.modes.frequencies_hz(), warnings })
    }

    /// Flies all maneuvers with corrections alone, the doublet and the chirp as the surfaces make them.
    ///
    /// # Errors
    /// As [`Aircraft::compare`].
    pub fn fly_acting(
        &self,
        wing: &Corrections,
        doublet: &MotionSpec,
        chirp: &MotionSpec,
    ) -> Result<Flown, AircraftError> {
        self.with_corrections(wing)?.fly_all(&FlightAir::new(self)?, doublet, chirp)
    }

    /// Sentences about flight points that contradict themselves.
    pub fn warnings(&self) -> Vec<String> {
        let points =
            [("pull_up", &self.file.pull_up), ("push_down", &self.file.push_down), ("trim", &self.file.trim)];
        points.into_iter().filter_map(|(name, point)| point.warning(name)).collect()
    }
}

impl FlightModel<'_> {
    /// Flies all points and the gust of the aircraft's file, and a doublet and a chirp.
    ///
    /// # Errors
    /// If a point cannot be trimmed or a control is not there.
    pub fn fly_all(
        &self,
        air: &FlightAir,
        doublet: &MotionSpec,
        chirp: &MotionSpec,
    ) -> Result<Flown, AircraftError> {
        let file = &self.aircraft.file;
        let trim = self.trim("trim", &file.trim)?;
        let fly = |name: &str, motion: &MotionSpec| -> Result<_, AircraftError> {
            let flight = FreeFlight::new(self, air, &trim, motion.control().unwrap_or_default())?;
            Ok((flight.warning(name, motion.record_s()), flight.fly_motion(motion)))
        };
        let (doublet, chirp) = (fly("doublet", doublet)?, fly("chirp", chirp)?);
        let warnings = [doublet.0, chirp.0, air.warning(file.trim.v_m_s)];
        Ok(Flown {
            warnings: warnings.into_iter().flatten().collect(),
            derivatives: self.derivatives(file.trim.v_m_s)?,
            doublet: doublet.1,
            chirp: chirp.1,
            gust: self.fly_gust(air, &trim)?,
            pull_up: self.trim("pull_up", &file.pull_up)?,
            push_down: self.trim("push_down", &file.push_down)?,
            trim,
        })
    }
}

impl FlightModel<'_> {
    /// The gust of the aircraft's file, without linearisation.
    fn fly_gust(&self, air: &FlightAir, trim: &Trimmed) -> Result<Option<FlightHistory>, AircraftError> {
        let Some(case) = self.aircraft.file.gust else { return Ok(None) };
        let gust = Gust { velocity_m_s: case.velocity_m_s, length_m: case.length_m, start_s: case.start_s };
        let flying = FlyingAircraft::new(self, air, trim, Vec::new(), Some(gust))?;
        flying.fly(&[], case.duration_s, &Integration::default()).map(Some)
    }
}

impl Comparison {
    /// The numbers of `result.json`; `seconds` is the time it all took.
    pub fn summary(&self, aircraft: &Aircraft, seconds: f64) -> Summary {
        Summary {
            command: "fullaircraft",
            aircraft: aircraft.file.name.clone(),
            models: BothModels { initial: self.initial.numbers(), updated: self.updated.numbers() },
            derivatives: BothDerivatives {
                initial: self.initial.derivatives.clone(),
                updated: self.updated.derivatives.clone(),
            },
            correction_airspeed_m_s: aircraft.file.correction_airspeed_m_s,
            boxes: aircraft.flow.lattice.len(),
            frequencies_hz: self.frequencies_hz.clone(),
            warnings: self.warnings.clone(),
            seconds,
        }
    }
}

impl Flown {
    /// The maneuvers in numbers.
    pub fn numbers(&self) -> ModelNumbers {
        ModelNumbers {
            trim: self.trim.numbers(),
            pull_up: self.pull_up.numbers(),
            push_down: self.push_down.numbers(),
            chirp: DynamicNumbers::of(&self.chirp),
            doublet: DynamicNumbers::of(&self.doublet),
            gust: self.gust.as_ref().map(DynamicNumbers::of),
        }
    }
}

impl Trimmed {
    /// The point in numbers.
    pub fn numbers(&self) -> SteadyNumbers {
        SteadyNumbers {
            v_m_s: self.point.v_m_s,
            load_factor: self.point.load_factor,
            pitch_rate_deg_s: self.point.pitch_rate_deg_s,
            alpha_deg: self.alpha_rad.to_degrees(),
            elevator_deg: self.elevator_rad.to_degrees(),
            tip_deflection_m: self.tip_deflection_m[0],
        }
    }
}

impl DynamicNumbers {
    fn of(history: &FlightHistory) -> Self {
        let start = history.tip_deflection_m.first().copied().unwrap_or(0.0);
        let change: Vec<f64> = history.tip_deflection_m.iter().map(|z| z - start).collect();
        let rates = history.tip_rates_deg_s.iter().map(|rate| FlightHistory::peak(rate));
        Self {
            peak_tip_acceleration_m_s2: FlightHistory::peak(&history.tip_acceleration_m_s2),
            peak_tip_rate_deg_s: rates.fold(0.0, f64::max),
            peak_tip_deflection_change_m: FlightHistory::peak(&change),
            peak_load_factor: history.load_factor.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            peak_right_root_mx_nm: FlightHistory::peak(&history.root_right[1]),
        }
    }
}
