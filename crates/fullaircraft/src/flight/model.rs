//! A trimmed aircraft in unsteady air, ready to fly: its equations, its instruments and what drives it.

use crate::error::AircraftError;
use crate::flight::air::{FlightAir, RIGID};
use crate::flight::drive::Drive;
use crate::flight::equations::{AirRows, Equations, Evaluated, Inputs, Reference};
use crate::flight::gust::{Gust, GustAxis};
use crate::flight::history::{FlightHistory, StationHistory, SurfaceHistory, UnitHistory};
use crate::flight::rows::LoadParts;
use crate::flight::sensors::{FIXED, Sensors, Unit};
use crate::flight::state::StateLayout;
use crate::trim::model::{FlightModel, Trimmed};
use coupling::GRAVITY_M_S2;
use faer::Mat;
use maneuver::air::RationalAir;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

/// See the module.
#[derive(Debug, Clone)]
pub struct FlyingAircraft {
    pub(crate) equations: Equations,
    pub(crate) sensors: Sensors,
    pub(crate) drives: Vec<Drive>,
    /// Stations of the gust behind the foremost one, m; none without a gust.
    pub(crate) gust_behind_m: Vec<f64>,
    pub(crate) gust: Option<Gust>,
    /// The centre of gravity behind the foremost station, m.
    pub(crate) centre_behind_m: f64,
}

impl FlyingAircraft {
    /// The trimmed aircraft with these drives and, if given, a gust.
    ///
    /// # Errors
    /// If the trim is not of this aircraft.
    pub fn new(
        model: &FlightModel<'_>,
        air: &FlightAir,
        trimmed: &Trimmed,
        drives: Vec<Drive>,
        gust: Option<Gust>,
    ) -> Result<Self, AircraftError> {
        Self::meeting(model, air, trimmed, drives, gust.map(|gust| (gust, GustAxis::Vertical)))
    }

    /// As [`FlyingAircraft::new`], with a gust along either axis.
    pub(crate) fn meeting(
        model: &FlightModel<'_>,
        air: &FlightAir,
        trimmed: &Trimmed,
        drives: Vec<Drive>,
        gust: Option<(Gust, GustAxis)>,
    ) -> Result<Self, AircraftError> {
        let aircraft = model.aircraft;
        let gusts = if gust.is_some() { air.gust_x_m.len() } else { 0 };
        let rows = Rows::new(model, air, trimmed, &drives, gust.map(|(_, axis)| axis));
        let generalised = rows.of(&air.modes.generalised_rows(aircraft));
        let q_pa = model.flow(&trimmed.point).dynamic_pressure_pa();
        let amplitude =
            |(mode, omega): (usize, &f64)| q_pa * generalised.constant[6 + mode] / (omega * omega);
        let eta: Vec<f64> = air.modes.elastic_omega_rad_s().iter().enumerate().map(amplitude).collect();
        let equations = equations(&rows, air, &eta, generalised, drives.len());
        let parts = LoadParts::new(aircraft, &air.momentum(aircraft))?;
        let loads = rows.of(&parts.air);
        let sensors = Sensors::new(aircraft, &air.modes, trimmed, &eta, parts, loads, &equations);
        let first = air.gust_x_m.first().copied().unwrap_or(0.0);
        Ok(Self {
            equations,
            sensors,
            drives,
            gust_behind_m: air.gust_x_m[..gusts].iter().map(|x| x - first).collect(),
            gust: gust.map(|(gust, _)| gust),
            centre_behind_m: aircraft.mass.centre.x - first,
        })
    }

    /// Commands and gust at a time, with the distance (m) and the airspeed (m/s) flown.
    pub(crate) fn inputs(&self, command_rad: Vec<f64>, flown_m: f64, v_m_s: f64) -> Inputs {
        self.inputs_in(self.gust, command_rad, flown_m, v_m_s)
    }

    /// As [`FlyingAircraft::inputs`], in another gust.
    pub(crate) fn inputs_in(
        &self,
        gust: Option<Gust>,
        command_rad: Vec<f64>,
        flown_m: f64,
        v_m_s: f64,
    ) -> Inputs {
        let Some(gust) = gust else {
            return Inputs { command_rad, ..Inputs::default() };
        };
        let entered = flown_m - self.equations.reference.v_m_s * gust.start_s;
        let met: Vec<[f64; 2]> =
            self.gust_behind_m.iter().map(|behind| gust.met(entered - behind, v_m_s)).collect();
        Inputs {
            command_rad,
            gust_m_s: met.iter().map(|[w, _]| *w).collect(),
            gust_rate_m_s2: met.iter().map(|[_, rate]| *rate).collect(),
        }
    }

    /// The gust's velocity at the centre of gravity after a distance, m/s.
    pub(crate) fn gust_at_centre(&self, flown_m: f64) -> f64 {
        self.gust.map_or(0.0, |gust| {
            gust.at(flown_m - self.equations.reference.v_m_s * gust.start_s - self.centre_behind_m)[0]
        })
    }

    /// What instruments show.
    pub(crate) fn read(&self, state: &[f64], evaluated: &Evaluated) -> Vec<f64> {
        self.sensors.read(&self.equations, state, evaluated)
    }

    /// Histories of the inertial units.
    fn units(&self, y: &Mat<f64>) -> Vec<UnitHistory> {
        let row = |at: usize| (0..y.ncols()).map(|k| y[(at, k)]).collect::<Vec<f64>>();
        let one = |(i, unit): (usize, &Unit)| {
            let at = Sensors::unit(self.drives.len(), i);
            UnitHistory {
                name: unit.name.clone(),
                deflection_m: row(at),
                acceleration_m_s2: std::array::from_fn(|axis| row(at + 1 + axis)),
                rates_deg_s: std::array::from_fn(|axis| {
                    row(at + 4 + axis).into_iter().map(f64::to_degrees).collect()
                }),
            }
        };
        self.sensors.units.iter().enumerate().map(one).collect()
    }

    /// Outputs (a column a sample) and commands (rad, a list a drive) as histories.
    pub(crate) fn history(&self, t_s: Vec<f64>, y: &Mat<f64>, commands: &[Vec<f64>]) -> FlightHistory {
        let drives = self.drives.len();
        let row = |at: usize| (0..y.ncols()).map(|k| y[(at, k)]).collect::<Vec<f64>>();
        let degrees = |values: Vec<f64>| values.into_iter().map(f64::to_degrees).collect::<Vec<f64>>();
        let rows = |at: usize| std::array::from_fn(|i| row(at + i));
        let angles = |at: usize| std::array::from_fn(|i| degrees(row(at + i)));
        let units = self.units(y);
        let first_load = self.sensors.first_load(drives);
        let part = |part: usize| rows(first_load + 3 * part);
        let tip = &units[self.sensors.outermost];
        let surface = |drive: usize| SurfaceHistory {
            name: self.drives[drive].name.clone(),
            command_deg: degrees(commands[drive].clone()),
            deflection_deg: degrees(row(FIXED + drive)),
        };
        let mut surfaces = (0..drives).map(surface);
        let still = || vec![0.0; t_s.len()];
        let first = surfaces.next().unwrap_or_else(|| SurfaceHistory {
            name: String::new(),
            command_deg: still(),
            deflection_deg: still(),
        });
        let others = surfaces.collect();
        let up = &tip.acceleration_m_s2[2];
        let upwards_at_trim = up.first().copied().unwrap_or(0.0);
        FlightHistory {
            command_deg: first.command_deg,
            aileron_deg: first.deflection_deg,
            alpha_deg: degrees(row(1)),
            tip_deflection_m: tip.deflection_m.clone(),
            tip_acceleration_m_s2: up.iter().map(|a| a - upwards_at_trim).collect(),
            tip_rates_deg_s: tip.rates_deg_s.clone(),
            root_right: part(0),
            root_left: part(1),
            v_m_s: row(0),
            beta_deg: degrees(row(2)),
            load_factor: row(3),
            rates_deg_s: angles(4),
            angles_deg: angles(7),
            gust_m_s: row(10).iter().map(|back| self.gust_at_centre(-back)).collect(),
            place_m: rows(10),
            others,
            unbalanced: part(self.sensors.parts.len() - 1),
            stations: (2..self.sensors.parts.len() - 1)
                .map(|i| StationHistory { name: self.sensors.parts[i].clone(), loads: part(i) })
                .collect(),
            units,
            t_s,
        }
    }
}

/// What makes rows of air loads of a trimmed model.
pub(crate) struct Rows<'a> {
    model: &'a FlightModel<'a>,
    trimmed: &'a Trimmed,
    motions: RationalAir,
}

impl<'a> Rows<'a> {
    /// For an aircraft with these drives, and in gusts along an axis if there are any.
    pub(crate) fn new(
        model: &'a FlightModel<'a>,
        air: &FlightAir,
        trimmed: &'a Trimmed,
        drives: &[Drive],
        gusts: Option<GustAxis>,
    ) -> Self {
        Self { model, trimmed, motions: motions(air, drives, gusts) }
    }

    /// Pressures by motions, rates over V, second rates over V², lags: boxes by the columns of [`AirRows`].
    pub(crate) fn pressures(&self) -> Mat<f64> {
        AirRows::new(Vec::new(), &self.motions).by
    }

    /// Rows by box loads made rows by motions, per unit dynamic pressure.
    pub(crate) fn of(&self, rows: &Mat<f64>) -> AirRows {
        let q_pa = self.model.flow(&self.trimmed.point).dynamic_pressure_pa();
        let loads = self.trimmed.box_loads.iter().enumerate();
        let at_trim = |i: usize| loads.clone().map(|(k, p)| rows[(i, k)] * p).sum::<f64>() / q_pa;
        let constant = (0..rows.nrows()).map(at_trim).collect();
        let loads = self.model.aircraft.flow.integration.corrected(&self.model.corrections);
        AirRows::new(constant, &self.motions.mapped(&loads.rows_by_pressure(rows.as_ref())))
    }
}

/// The equations of a trimmed model; `eta` are the modes' amplitudes in the trim.
fn equations(
    rows: &Rows<'_>,
    air: &FlightAir,
    eta: &[f64],
    generalised: AirRows,
    drives: usize,
) -> Equations {
    let (aircraft, trimmed) = (rows.model.aircraft, rows.trimmed);
    let (modes, flow) = (&air.modes, rows.model.flow(&trimmed.point));
    let pitch: f64 =
        eta.iter().enumerate().map(|(i, eta)| eta * modes.elastic_shape(6 * aircraft.centre + 4, i)).sum();
    let alpha_rad = trimmed.alpha_rad - pitch;
    // the air's moment in the trim, turned as the equations turn it
    let q_pa = flow.dynamic_pressure_pa();
    let moment = Vector3::from_fn(|axis, _| q_pa * generalised.constant[3 + axis]);
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.0, -alpha_rad, 0.0));
    let actuator = &aircraft.file.actuator;
    Equations {
        layout: StateLayout {
            modes: modes.elastic(),
            drives,
            motions: rows.motions.steady.ncols(),
            poles: rows.motions.poles_per_m.len(),
        },
        reference: Reference {
            v_m_s: flow.v_m_s,
            alpha_rad,
            pitch_rate_rad_s: trimmed.point.pitch_rate_deg_s.to_radians(),
        },
        rho_kg_m3: flow.rho_kg_m3,
        gravity_m_s2: GRAVITY_M_S2,
        mass_kg: aircraft.mass.mass_kg,
        inertia: aircraft.mass.inertia_kg_m2,
        omega_rad_s: modes.elastic_omega_rad_s().to_vec(),
        damping_ratio: aircraft.wing.damping_ratio,
        actuator: [TAU * actuator.frequency_hz, actuator.damping_ratio],
        poles_per_m: rows.motions.poles_per_m.clone(),
        generalised,
        hold: -(turn * moment),
    }
}

/// Columns of the air for rigid motions, modes, drives (their surfaces in their shares) and gusts.
fn motions(air: &FlightAir, drives: &[Drive], gusts: Option<GustAxis>) -> RationalAir {
    let columns = air.columns;
    let axis = gusts.unwrap_or(GustAxis::Vertical);
    let gusts = if gusts.is_some() { columns.gusts } else { 0 };
    let before = RIGID + columns.modes;
    let pick = |of: &Mat<f64>| {
        Mat::from_fn(of.nrows(), before + drives.len() + gusts, |j, motion| match motion {
            own if own < before => of[(j, own)],
            drive if drive < before + drives.len() => drives[drive - before]
                .parts
                .iter()
                .map(|&(control, share)| share * of[(j, columns.control(control))])
                .sum(),
            gust => of[(j, columns.gust_along(axis, gust - before - drives.len()))],
        })
    };
    RationalAir {
        poles_per_m: air.rational.poles_per_m.clone(),
        steady: pick(&air.rational.steady),
        rate: pick(&air.rational.rate),
        second: pick(&air.rational.second),
        lags: air.rational.lags.iter().map(pick).collect(),
    }
}
