//! Steady maneuvers of the calibrated half wing and its image, which carry the aircraft alone, with each wing of its ensemble: what
//! `fullaircraft` does with `surfaces: WingsOnly`, by half the boxes and for many wings (a test compares the two).

use aero::{Corrections, Flow};
use calibrate::ensemble::{Ensemble, interval};
use calibrate::{Member, Schedule};
use coupling::wing_file::{Departure, Source};
use coupling::{CouplingError, ElasticWing, GRAVITY_M_S2, Mount, RootPlane, SteadyCase, WingFile};
use fullaircraft::AircraftFile;

/// Angle that derivatives by the angle of attack are taken over, rad; all is linear but the cosine of the weight.
const STEP_RAD: f64 = 1e-3;
/// Logarithm of the flexibility that derivatives are taken over.
const STEP_FLEXIBILITY: f64 = 0.02;

/// A steady maneuver.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point {
    pub(super) v_m_s: f64,
    pub(super) rho_kg_m3: f64,
    pub(super) load_factor: f64,
    /// What each half wing carries at a load factor of one, kg.
    pub(super) half_mass_kg: f64,
    /// What is asked of it.
    pub(super) asked: Asked,
}

/// What is asked of a maneuver, and what the table calls it.
#[derive(Debug, Clone, Copy)]
pub(super) enum Asked {
    Incidence(&'static str),
    Tip(&'static str),
}

/// The maneuvers of an aircraft's file, its tail left out and without the pitch rate, all at one airspeed: that of the calibration, since
/// sections are others at another Reynolds number.
pub(super) fn points(aircraft: &AircraftFile, v_m_s: f64) -> [Point; 3] {
    let of = |point: &fullaircraft::FlightPoint, asked: Asked| Point {
        v_m_s,
        rho_kg_m3: aircraft.rho_kg_m3,
        load_factor: point.load_factor,
        half_mass_kg: 0.5 * aircraft.total.mass_kg,
        asked,
    };
    [
        of(&aircraft.trim, Asked::Incidence("trim incidence")),
        of(&aircraft.pull_up, Asked::Tip("tip in the pull-up")),
        of(&aircraft.push_down, Asked::Tip("tip in the push-down")),
    ]
}

/// What a wing does in a maneuver: rad or m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steady {
    alpha_rad: f64,
    tip_z_m: f64,
}

impl Asked {
    fn of(self, steady: Steady) -> f64 {
        match self {
            Self::Incidence(_) => steady.alpha_rad,
            Self::Tip(_) => steady.tip_z_m,
        }
    }
}

/// A maneuver and the wing in it.
struct Flight {
    point: Point,
    /// Its gravity is the load factor times that of the ground.
    wing: ElasticWing,
    /// By the logarithms of the flexibility in bending and in torsion, by theory.
    by_flexibility: [f64; 2],
    theory: f64,
}

/// What is predicted of a maneuver.
pub(super) struct InFlight {
    pub(super) value: f64,
    pub(super) theory: f64,
    pub(super) interval: [f64; 2],
}

/// All maneuvers.
pub(super) struct Flights(Vec<Flight>);

impl Flights {
    /// For the wing of a file, without the fairing that it has in the tunnel.
    pub(super) fn new(file: &WingFile, points: &[Point]) -> Result<Self, CouplingError> {
        let wing = |log_flexibility: [f64; 2]| {
            let mut file = file.clone();
            if let Source::Parametric(planform) = &mut file.source {
                planform.fairing = None;
            }
            file.root_plane = Some(RootPlane::Symmetric(0.0));
            file.departure = Departure { log_flexibility, ..Departure::default() };
            ElasticWing::from_bulk(&file, &file.bulk(Mount::Tunnel)?)
        };
        let (drawn, bent, twisted) =
            (wing([0.0; 2])?, wing([STEP_FLEXIBILITY, 0.0])?, wing([0.0, STEP_FLEXIBILITY])?);
        let theory = Corrections::neutral(drawn.correctable.len());
        let flight = |point: &Point| {
            let at = |wing: &ElasticWing| {
                let mut wing = wing.clone();
                wing.gravity_m_s2 = point.load_factor * GRAVITY_M_S2;
                let value = point.asked.of(steady(&wing, point, &theory)?);
                Ok::<_, CouplingError>((wing, value))
            };
            let (wing, value) = at(&drawn)?;
            let by =
                |softer: &ElasticWing| Ok::<_, CouplingError>((at(softer)?.1 - value) / STEP_FLEXIBILITY);
            Ok(Flight { point: *point, wing, by_flexibility: [by(&bent)?, by(&twisted)?], theory: value })
        };
        points.iter().map(flight).collect::<Result<_, _>>().map(Self)
    }

    /// What a calibrated wing does with the structure that was found, between what the wings of its ensemble do.
    pub(super) fn predict(
        &self,
        schedule: &Schedule,
        ensemble: &Ensemble,
    ) -> Result<Vec<InFlight>, CouplingError> {
        let one = |flight: &Flight| {
            let with = |corrections: &Corrections, [bending, torsion]: [f64; 2]| {
                let value = flight.point.asked.of(steady(&flight.wing, &flight.point, corrections)?);
                let [by_bending, by_torsion] = flight.by_flexibility;
                let softer = by_bending * bending + by_torsion * torsion;
                Ok::<_, CouplingError>(match flight.point.asked {
                    Asked::Incidence(_) => value + softer,
                    // under a given lift the tip goes with the flexibility
                    Asked::Tip(_) => value * (softer / flight.theory).exp(),
                })
            };
            let value = match &schedule.found {
                Some(found) => with(&found.sets[0].corrections, found.log_flexibility)?,
                None => with(&schedule.sets[0].corrections, [0.0; 2])?,
            };
            let member =
                |member: &Member| with(&member.sets_in_flight()[0].corrections, member.log_flexibility);
            let members = ensemble.members.iter().map(member).collect::<Result<Vec<_>, _>>()?;
            Ok(InFlight { value, theory: flight.theory, interval: interval(value, &members) })
        };
        self.0.iter().map(one).collect()
    }
}

/// A wing whose lift is the load factor times the weight.
fn steady(wing: &ElasticWing, point: &Point, corrections: &Corrections) -> Result<Steady, CouplingError> {
    let flow = Flow { v_m_s: point.v_m_s, rho_kg_m3: point.rho_kg_m3 };
    let cases = [0.0, STEP_RAD].map(|alpha_rad| SteadyCase::new(flow, alpha_rad));
    let tip = wing.supported.as_ref().map(|structure| structure.tip_z);
    let states = wing.at(flow, corrections)?.solve(&cases);
    let lifts_and_tips: Vec<[f64; 2]> = states
        .iter()
        .map(|state| {
            let loads = state.box_loads.values.iter().enumerate();
            let lift_n: f64 = loads.map(|(k, load)| wing.root_rows[(0, k)] * load).sum();
            [lift_n, tip.map_or(0.0, |tip| state.displacement[tip])]
        })
        .collect();
    let by_rad = |i: usize| (lifts_and_tips[1][i] - lifts_and_tips[0][i]) / STEP_RAD;
    let asked_n = point.half_mass_kg * point.load_factor * GRAVITY_M_S2;
    let alpha_rad = (asked_n - lifts_and_tips[0][0]) / by_rad(0);
    Ok(Steady { alpha_rad, tip_z_m: lifts_and_tips[0][1] + by_rad(1) * alpha_rad })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

    use super::{Asked, Flights, points};
    use crate::repository;
    use coupling::WingFile;
    use fullaircraft::aircraft::file::Surfaces;
    use fullaircraft::{Aircraft, AircraftFile};
    use truth::rig::{Coupled, Rig};
    use truth::setting::Setting;
    use truth::wing::Wing;

    /// The half wing and its image are the free aircraft whose wings carry it alone, both sides with their own boxes; and the other
    /// program's wing, flat sections and another lattice and beam, flies alike but for what the two lattices differ by.
    #[test]
    fn the_half_wing_flies_as_the_aircraft_of_wings_alone_and_as_that_of_the_other_program() {
        let path = repository::path("data/tuflex/wing_beam.ron");
        let mut file = AircraftFile::read(&repository::path("data/tuflex/aircraft.ron")).unwrap();
        file.surfaces = Surfaces::WingsOnly;
        let v_m_s = file.trim.v_m_s;
        for point in [&mut file.trim, &mut file.pull_up, &mut file.push_down] {
            point.pitch_rate_deg_s = 0.0;
            point.v_m_s = v_m_s;
        }
        let points = points(&file, file.trim.v_m_s);
        let wing = WingFile::read(&path).unwrap();
        let flights = Flights::new(&wing, &points).unwrap();
        let rig = Rig::new(Wing::read(&path).unwrap(), None).on_aircraft();
        let aircraft = Aircraft::new(file.clone(), wing).unwrap();
        let model = aircraft.uncorrected();
        for (flight, point) in flights.0.iter().zip([file.trim, file.pull_up, file.push_down]) {
            let trimmed = model.trim("point", &point).unwrap();
            let coupled = Coupled::new(&rig, Setting::drawn(0.02, 3), point.v_m_s, file.rho_kg_m3);
            let other = coupled.steady(flight.point.half_mass_kg, point.load_factor).unwrap();
            let (whole, other) = match flight.point.asked {
                Asked::Incidence(_) => (trimmed.alpha_rad, other.alpha_rad),
                Asked::Tip(_) => (trimmed.tip_deflection_m[0], other.tip_z_m),
            };
            assert!((flight.theory / whole - 1.0).abs() < 1e-3, "{} {whole}", flight.theory);
            // the flat sections of the other program have no camber: tips under a given lift hardly know it
            if matches!(flight.point.asked, Asked::Tip(_)) {
                assert!((flight.theory / other - 1.0).abs() < 0.03, "{} {other}", flight.theory);
            }
        }
    }
}
