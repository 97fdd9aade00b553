//! What a trim can turn and what it can ask for, by names that carry their units.
//!
//! Variables: angle of attack and sideslip of the wing's root, rates about the centre of gravity as flight mechanics counts
//! them (right wing down, nose up, nose right), thrust, and control surfaces: both halves of the elevator together, the rudder, each pair of
//! ailerons against one another (trailing edge down on the right is positive).
//! Motions: load factors (what an accelerometer feels at the centre of gravity over g; ahead, right and up positive) and
//! angular accelerations in the sense of the rates.

use crate::aircraft::assembly::Aircraft;
use aero::incidence;
use coupling::GRAVITY_M_S2;
use faer::Mat;
use nalgebra::{Point3, Vector3};
use nastran::InputError;
use std::f64::consts::PI;

/// One degree, rad.
const DEGREE: f64 = PI / 180.0;

/// The six motions in the order of the equations (forces along x, y, z, moments about them), by name.
pub const MOTIONS: [&str; 6] =
    ["n_x", "n_y", "n_z", "roll_acceleration_deg_s2", "pitch_acceleration_deg_s2", "yaw_acceleration_deg_s2"];

/// Acceleration along or about the axes (m/s², rad/s²) of one unit of each motion as it is named: ahead is -x, right wing
/// down a rotation about -x, nose right about -z.
pub const MOTION_UNITS: [f64; 6] = [-GRAVITY_M_S2, GRAVITY_M_S2, GRAVITY_M_S2, -DEGREE, DEGREE, -DEGREE];

/// A variable.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimVariable {
    /// Its name: `alpha_deg`, `roll_rate_deg_s`, `thrust_N`, `elevator_deg`...
    pub name: String,
    /// SI value of one unit.
    pub unit: f64,
    /// What it does.
    pub(crate) acts: Acts,
}

/// What a variable does.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Acts {
    /// A column of the pressures that do not depend on airspeed.
    Flow(usize),
    /// The same, divided by the airspeed.
    Rate(usize),
    /// A force, N, and moment, N m, about the centre of gravity per newton.
    Force([f64; 6]),
}

/// Variables of an aircraft and the pressures they cause.
#[derive(Debug, Clone)]
pub struct TrimVariables {
    /// All of them.
    pub all: Vec<TrimVariable>,
    /// Pressure coefficients, boxes by columns: fixed (camber and twist), then by column as [`Acts`] says.
    pub(crate) pressures: Mat<f64>,
}

impl TrimVariables {
    /// The variables of an aircraft.
    pub fn new(aircraft: &Aircraft) -> Self {
        let wing = &aircraft.flow;
        let lattice = &wing.lattice;
        let about = Point3::new(aircraft.file.total.x_cg_m, 0.0, 0.0);
        let rate = |axis: Vector3<f64>| incidence::rotation_rate(lattice, &axis, &about, 1.0);
        let rates = [rate(-Vector3::x()), rate(Vector3::y()), rate(-Vector3::z())];
        let mut columns =
            vec![wing.camber.clone(), incidence::angle_of_attack(lattice), incidence::sideslip(lattice)];
        columns.extend(rates);
        let flow =
            |name: &str, at| TrimVariable { name: name.to_owned(), unit: DEGREE, acts: Acts::Flow(at) };
        let turn =
            |name: &str, at| TrimVariable { name: name.to_owned(), unit: DEGREE, acts: Acts::Rate(at) };
        let mut all = vec![
            flow("alpha_deg", 1),
            flow("beta_deg", 2),
            turn("roll_rate_deg_s", 3),
            turn("pitch_rate_deg_s", 4),
            turn("yaw_rate_deg_s", 5),
            TrimVariable { name: "thrust_N".to_owned(), unit: 1.0, acts: Acts::Force(thrust(aircraft)) },
        ];
        for (name, parts) in controls(aircraft) {
            let column = moved_together(aircraft, &parts);
            all.push(flow(&format!("{name}_deg"), columns.len()));
            columns.push(column);
        }
        let w = Mat::from_fn(lattice.len(), columns.len(), |j, column| columns[column][j]);
        Self { all, pressures: wing.pressures(w.as_ref()) }
    }

    /// Place of a variable.
    ///
    /// # Errors
    /// If there is none of this name; says which there are.
    pub fn place(&self, name: &str) -> Result<usize, InputError> {
        self.all.iter().position(|variable| variable.name == name).ok_or_else(|| {
            let names: Vec<&str> = self.all.iter().map(|variable| variable.name.as_str()).collect();
            InputError::general(format!("{name} is no variable of this aircraft's trim"))
                .with_help(format!("there are {}", names.join(", ")))
        })
    }
}

/// Place of a motion.
///
/// # Errors
/// If there is none of this name; says which there are.
pub fn motion(name: &str) -> Result<usize, InputError> {
    MOTIONS.iter().position(|motion| *motion == name).ok_or_else(|| {
        InputError::general(format!("{name} is no motion of an aircraft"))
            .with_help(format!("there are {}", MOTIONS.join(", ")))
    })
}

/// Force and moment about the centre of gravity per newton of thrust.
fn thrust(aircraft: &Aircraft) -> [f64; 6] {
    let Some(line) = aircraft.file.thrust_line else { return [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0] };
    let up = line.up_deg.to_radians();
    let force = Vector3::new(-up.cos(), 0.0, up.sin());
    let (x, y, z) = line.point_m;
    let moment = Vector3::new(x - aircraft.file.total.x_cg_m, y, z).cross(&force);
    [force.x, force.y, force.z, moment.x, moment.y, moment.z]
}

/// Incidence of all boxes by a control, rad per rad; none of this name: nothing.
pub(crate) fn incidence_of_control(aircraft: &Aircraft, name: &str) -> Option<Vec<f64>> {
    let (_, parts) = controls(aircraft).into_iter().find(|(known, _)| known == name)?;
    Some(moved_together(aircraft, &parts))
}

fn moved_together(aircraft: &Aircraft, parts: &[(usize, f64)]) -> Vec<f64> {
    let wing = &aircraft.flow;
    let mut column = vec![0.0; wing.lattice.len()];
    for (at, sign) in parts {
        for (sum, value) in column.iter_mut().zip(wing.controls[*at].column(wing.lattice.len())) {
            *sum += sign * value;
        }
    }
    column
}

/// Control surfaces that move together: name, and place and sense of each.
fn controls(aircraft: &Aircraft) -> Vec<(String, Vec<(usize, f64)>)> {
    let mut groups = Vec::new();
    let elevator = aircraft.file.htp.control.name.as_str();
    for (at, control) in aircraft.flow.controls.iter().enumerate() {
        let name = control.name.as_str();
        if name.strip_prefix("L_").is_some_and(|right| aircraft.control(right).is_some()) {
            continue;
        }
        let left_sense = if name == elevator { 1.0 } else { -1.0 };
        let left = aircraft.control(&format!("L_{name}")).map(|left| (left, left_sense));
        groups.push((name.to_owned(), std::iter::once((at, 1.0)).chain(left).collect()));
    }
    groups
}

#[cfg(test)]
mod tests;
