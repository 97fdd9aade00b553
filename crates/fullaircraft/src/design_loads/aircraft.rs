//! The aircraft of a plan: in each state of loading, its airframe for the rules, its stations, and the plan's own maneuvers.

use crate::aircraft::assembly::Aircraft;
use crate::cases::file::{Action, CasesFile};
use crate::error::AircraftError;
use crate::stations::places::Station;
use crate::trim::maneuvers::Steady;
use crate::trim::model::FlightModel;
use coupling::Keep;
use loads::design::{Design, MassCase, Speed};
use loads::{Airframe, Condition};
use nastran::InputError;

/// Share of the largest load factor that rolls are flown at, beside zero, where the plan has no load factors of its own.
const ROLLING_SHARE: f64 = 2.0 / 3.0;

impl Aircraft {
    /// The aircraft in a state of loading: what that leaves out stays. The body at the wing's root takes up the difference.
    ///
    /// # Errors
    /// If no body could do that, or the state has a number that aircraft here do not.
    pub fn loaded(&self, mass: &MassCase) -> Result<Self, AircraftError> {
        self.loaded_kept(mass, &())
    }

    /// The same; what takes long is taken from where it is kept, or found and kept there.
    ///
    /// # Errors
    /// As [`loaded`](Self::loaded).
    pub fn loaded_kept(&self, mass: &MassCase, keep: &dyn Keep) -> Result<Self, AircraftError> {
        check_loading(mass)?;
        let mut file = self.file.clone();
        let total = &mut file.total;
        total.mass_kg = mass.mass_kg;
        for (own, given) in [
            (&mut total.x_cg_m, mass.x_cg_m),
            (&mut total.ixx_kg_m2, mass.ixx_kg_m2),
            (&mut total.iyy_kg_m2, mass.iyy_kg_m2),
            (&mut total.izz_kg_m2, mass.izz_kg_m2),
        ] {
            *own = given.unwrap_or(*own);
        }
        self.of_totals(file, keep).map_err(|error| match error {
            AircraftError::Input(input) => {
                let message = format!("mass {}: {}", mass.name, input.message);
                AircraftError::Input(InputError { message, span: None, ..input })
            }
            other => other,
        })
    }

    /// What rules know of it: area and mean chord of both wings, and the lift slope of the whole, rigid, at an airspeed.
    ///
    /// # Errors
    /// If the aircraft diverges there.
    pub fn airframe(&self, model: &FlightModel<'_>, v_m_s: f64) -> Result<Airframe, AircraftError> {
        let found = model.derivatives(v_m_s)?;
        let alpha = found.derivatives.iter().find(|derivative| derivative.variable == "alpha");
        Ok(Airframe {
            area_m2: found.area_m2,
            mean_chord_m: found.area_m2 / found.span_m,
            lift_slope_per_rad: alpha.map_or(f64::NAN, |alpha| alpha.rigid.lift),
        })
    }

    /// Stations of a plan: those of the wing and of the file, the tail, the fuselage and the whole.
    ///
    /// # Errors
    /// If two have a name, or one has nothing outboard of it: of the plan's own at their place in it.
    pub fn loads_stations(&self, file: &CasesFile) -> Result<Vec<Station>, InputError> {
        self.wing_stations(&[])?;
        let in_plan = |error: InputError| {
            let span = InputError::in_field(&file.path, "stations", "").span;
            InputError { span, ..error }
        };
        let mut all = self.wing_stations(&file.stations).map_err(in_plan)?;
        all.extend(self.body_stations());
        Ok(all)
    }
}

/// Refuses what a state of loading can say and aircraft here do not have.
///
/// # Errors
/// If its centre of gravity is above or below the axis, or it has a product of inertia.
pub fn check_loading(mass: &MassCase) -> Result<(), InputError> {
    if mass.z_cg_m.is_none_or(|z_m| z_m == 0.0) && mass.ixz_kg_m2.is_none_or(|ixz| ixz == 0.0) {
        return Ok(());
    }
    let name = &mass.name;
    let message =
        format!("mass {name}: the height of the centre of gravity and products of inertia are not read");
    Err(InputError::general(message).with_help("leave out z_cg_m and ixz_kg_m2"))
}

/// The maneuvers of a plan beside corners and gusts, and the same as conditions of its matrix: each at every airspeed of the
/// file, or at VA, VC and VD; rolls at its load factors, or at zero and two thirds of the largest.
///
/// # Errors
/// If the plan's numbers make no sense.
pub fn maneuvers(file: &CasesFile, design: &Design) -> Result<Vec<(Action, Condition)>, InputError> {
    let (factors, _) = design.load_factors()?;
    let speeds: Vec<f64> = if file.airspeeds_v_m_s.is_empty() {
        [Speed::VA, Speed::VC, Speed::VD].iter().filter_map(|speed| design.speeds.get(*speed)).collect()
    } else {
        file.airspeeds_v_m_s.clone()
    };
    let mut plan = file.clone();
    if plan.load_factors.is_empty() {
        plan.load_factors = vec![0.0, ROLLING_SHARE * factors.n1];
    }
    let mut all = Vec::new();
    for action in plan.actions() {
        for &v_eas_m_s in &speeds {
            let (kind, n_z) = match &action {
                Action::Steady(steady) => (steady.kind().to_owned(), steady.load_factor()),
                Action::Motion(motion) => (motion.kind().words().to_owned(), 1.0),
            };
            let words = match &action {
                Action::Steady(Steady::Roll { rate_deg_s, control, .. }) => {
                    format!("roll {rate_deg_s} deg/s by {control}")
                }
                Action::Motion(motion) => format!("{kind} of {}", motion.control().unwrap_or_default()),
                Action::Steady(_) => kind.clone(),
            };
            all.push((action.clone(), Condition { kind, words, v_eas_m_s, n_z }));
        }
    }
    Ok(all)
}
