//! A trimmed aircraft in unsteady air, ready to fly: its equations, its instruments and what drives it.

use crate::drive::Drive;
use crate::error::AircraftError;
use crate::flight_equations::{AirRows, Equations, Evaluated, Inputs, Reference};
use crate::flight_gust::Gust;
use crate::flight_rows::LoadParts;
use crate::flight_sensors::{FIXED, Sensors};
use crate::flight_state::StateLayout;
use crate::free_modes::FreeModes;
use crate::history::{FlightHistory, StationHistory, SurfaceHistory, UnitHistory};
use crate::trim::{FlightModel, Trimmed};
use crate::unsteady::{FlightAir, RIGID};
use coupling::GRAVITY_M_S2;
use faer::Mat;
use maneuver::air::RationalAir;
use nalgebra::Vector3;
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
        let aircraft = model.aircraft;
        let modes = &air.modes;
        let flow = model.flow(&trimmed.point);
        let q_pa = flow.dynamic_pressure_pa();
        let parts = LoadParts::new(aircraft, modes);
        let gusts = if gust.is_some() { air.gust_x_m.len() } else { 0 };
        let motions = motions(air, &drives, gusts);
        let rows = |rows: &Mat<f64>| -> AirRows {
            let by_pressure = by_pressure(model, rows);
            let constant = (0..rows.nrows())
                .map(|i| {
                    trimmed.box_loads.iter().enumerate().map(|(k, p)| rows[(i, k)] * p).sum::<f64>() / q_pa
                })
                .collect();
            AirRows::new(constant, &motions.mapped(&by_pressure))
        };
        let generalised = rows(&generalised_rows(model, modes));
        let omega_rad_s = modes.elastic_omega_rad_s().to_vec();
        let eta: Vec<f64> = omega_rad_s
            .iter()
            .enumerate()
            .map(|(mode, omega)| q_pa * generalised.constant[6 + mode] / (omega * omega))
            .collect();
        let pitch: f64 = eta
            .iter()
            .enumerate()
            .map(|(i, eta)| eta * modes.elastic_shape(6 * aircraft.centre + 4, i))
            .sum();
        let actuator = &aircraft.file.actuator;
        let held: Vec<f64> = (3..6).map(|row| -q_pa * generalised.constant[row]).collect();
        let equations = Equations {
            layout: StateLayout {
                modes: modes.elastic(),
                drives: drives.len(),
                motions: motions.steady.ncols(),
                poles: motions.poles_per_m.len(),
            },
            reference: Reference {
                v_m_s: flow.v_m_s,
                alpha_rad: trimmed.alpha_rad - pitch,
                pitch_rate_rad_s: trimmed.point.pitch_rate_deg_s.to_radians(),
            },
            rho_kg_m3: flow.rho_kg_m3,
            gravity_m_s2: GRAVITY_M_S2,
            mass_kg: aircraft.mass.mass_kg,
            inertia: aircraft.mass.inertia_kg_m2,
            omega_rad_s,
            damping_ratio: aircraft.wing.damping_ratio,
            actuator: [TAU * actuator.frequency_hz, actuator.damping_ratio],
            poles_per_m: motions.poles_per_m.clone(),
            generalised,
            hold: Vector3::new(held[0], held[1], held[2]),
        };
        let loads = rows(&parts.air);
        let sensors = Sensors::new((aircraft, modes), (trimmed, &eta), (parts, loads), &equations);
        let first = air.gust_x_m.first().copied().unwrap_or(0.0);
        Ok(Self {
            equations,
            sensors,
            drives,
            gust_behind_m: air.gust_x_m[..gusts].iter().map(|x| x - first).collect(),
            gust,
            centre_behind_m: aircraft.mass.centre.x - first,
        })
    }

    /// Commands and gust at a time, with the distance (m) and the airspeed (m/s) flown.
    pub(crate) fn inputs(&self, command_rad: Vec<f64>, flown_m: f64, v_m_s: f64) -> Inputs {
        let Some(gust) = self.gust else {
            return Inputs { command_rad, ..Inputs::default() };
        };
        let entered = flown_m - self.equations.reference.v_m_s * gust.start_s;
        let met: Vec<[f64; 2]> = self.gust_behind_m.iter().map(|behind| gust.at(entered - behind)).collect();
        Inputs {
            command_rad,
            gust_m_s: met.iter().map(|[w, _]| *w).collect(),
            gust_rate_m_s2: met.iter().map(|[_, slope]| slope * v_m_s).collect(),
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

    /// Outputs (a column a sample) and commands (rad, a list a drive) as histories.
    pub(crate) fn history(&self, t_s: Vec<f64>, y: &Mat<f64>, commands: &[Vec<f64>]) -> FlightHistory {
        let drives = self.drives.len();
        let row = |at: usize| (0..y.ncols()).map(|k| y[(at, k)]).collect::<Vec<f64>>();
        let degrees = |values: Vec<f64>| values.into_iter().map(f64::to_degrees).collect::<Vec<f64>>();
        let rows = |at: usize| std::array::from_fn(|i| row(at + i));
        let angles = |at: usize| std::array::from_fn(|i| degrees(row(at + i)));
        let units: Vec<UnitHistory> = self
            .sensors
            .units
            .iter()
            .enumerate()
            .map(|(i, unit)| {
                let at = Sensors::unit(drives, i);
                UnitHistory {
                    name: unit.name.clone(),
                    deflection_m: row(at),
                    acceleration_m_s2: rows(at + 1),
                    rates_deg_s: angles(at + 4),
                }
            })
            .collect();
        let first_load = self.sensors.first_load(drives);
        let part = |part: usize| rows(first_load + 3 * part);
        let tip = &units[self.sensors.outermost];
        let surface = |drive: usize| SurfaceHistory {
            name: self.drives[drive].name.clone(),
            command_deg: degrees(commands[drive].clone()),
            deflection_deg: degrees(row(FIXED + drive)),
        };
        let surfaces: Vec<SurfaceHistory> = (0..drives).map(surface).collect();
        let (first, others) = match surfaces.split_first() {
            Some((first, others)) => (first.clone(), others.to_vec()),
            None => {
                let still = vec![0.0; t_s.len()];
                let none = SurfaceHistory {
                    command_deg: still.clone(),
                    deflection_deg: still,
                    ..SurfaceHistory::default()
                };
                (none, Vec::new())
            }
        };
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

/// Columns of the air for rigid motions, modes, drives (their surfaces in their shares) and gusts.
fn motions(air: &FlightAir, drives: &[Drive], gusts: usize) -> RationalAir {
    let columns = air.columns;
    let before = RIGID + columns.modes;
    let pick = |of: &Mat<f64>| {
        Mat::from_fn(of.nrows(), before + drives.len() + gusts, |j, motion| match motion {
            own if own < before => of[(j, own)],
            drive if drive < before + drives.len() => drives[drive - before]
                .parts
                .iter()
                .map(|&(control, share)| share * of[(j, columns.control(control))])
                .sum(),
            gust => of[(j, columns.gust(gust - before - drives.len()))],
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

/// Forces and moments about the centre of gravity and generalised forces of the modes: rows by two columns a box.
pub(crate) fn generalised_rows(model: &FlightModel<'_>, modes: &FreeModes) -> Mat<f64> {
    let aircraft = model.aircraft;
    let rigid = aircraft.spline.displace(aircraft.free.rigid_body(&aircraft.mass.centre).as_ref());
    Mat::from_fn(6 + modes.elastic(), rigid.nrows(), |row, k| {
        if row < 6 { rigid[(k, row)] } else { modes.boxes[(k, FreeModes::FIRST_ELASTIC + row - 6)] }
    })
}

/// Rows by box loads made rows by pressures, with the model's corrections, per unit dynamic pressure.
fn by_pressure(model: &FlightModel<'_>, rows: &Mat<f64>) -> Mat<f64> {
    let (wing, c) = (&model.aircraft.flow, &model.corrections);
    Mat::from_fn(rows.nrows(), wing.lattice.len(), |i, j| {
        let (area, arm) = (wing.integration.area(j), wing.integration.moment_arm(j));
        area * (c.force[j] * rows[(i, 2 * j)] + c.moment[j] * arm * rows[(i, 2 * j + 1)])
    })
}
