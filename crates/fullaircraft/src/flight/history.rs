//! Time histories of a dynamic maneuver: what sensors on board would show.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// Time histories of a maneuver; all the same length. They include the trimmed state, except `tip_acceleration_m_s2`.
///
/// Rates and angles have the signs of flight mechanics: roll positive with the right wing down, pitch nose up, yaw nose
/// right. That is the opposite of rotations about x (aft) and z (up) of the model's axes.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FlightHistory {
    /// Time, s.
    pub t_s: Vec<f64>,
    /// First command (of ailerons: right trailing edge down, left up), deg.
    pub command_deg: Vec<f64>,
    /// The surface itself, deg.
    pub aileron_deg: Vec<f64>,
    /// Angle of attack of the centre (the wing's root), deg.
    pub alpha_deg: Vec<f64>,
    /// Height of the right tip's accelerometer over the plane of the centre, without load, m.
    pub tip_deflection_m: Vec<f64>,
    /// Change of what that accelerometer feels along its own upward axis from the trim, m/s2.
    pub tip_acceleration_m_s2: Vec<f64>,
    /// Roll, pitch and yaw rate of that accelerometer, deg/s.
    pub tip_rates_deg_s: [Vec<f64>; 3],
    /// Root loads of the right wing: Fz (N), Mx, My (N m), aircraft axes.
    pub root_right: [Vec<f64>; 3],
    /// Root loads of the left wing.
    pub root_left: [Vec<f64>; 3],
    /// Airspeed of the centre of gravity, m/s.
    pub v_m_s: Vec<f64>,
    /// Sideslip, positive with the wind from the right, deg.
    pub beta_deg: Vec<f64>,
    /// Lift over weight.
    pub load_factor: Vec<f64>,
    /// Roll, pitch and yaw rate of the aircraft (its mean axes), deg/s.
    pub rates_deg_s: [Vec<f64>; 3],
    /// Roll, pitch and yaw angle, deg.
    pub angles_deg: [Vec<f64>; 3],
    /// Place of the centre of gravity from where it began: back, right and up in the earth's axes, m.
    pub place_m: [Vec<f64>; 3],
    /// Further commands and their surfaces, deg.
    pub others: Vec<SurfaceHistory>,
    /// Vertical velocity of the gust at the centre of gravity, m/s.
    pub gust_m_s: Vec<f64>,
    /// Inertial units: those of the wing's file on both sides, and one at the centre.
    pub units: Vec<UnitHistory>,
    /// What the loads of the whole aircraft, air less inertia and weight, do not close by: Fz (N), Mx and My about the centre of
    /// gravity (N m). Rounding, but for what an aircraft without a tail leaves unbalanced.
    pub unbalanced: [Vec<f64>; 3],
    /// Loads at monitoring stations: of everything outboard, about the station's point.
    pub stations: Vec<StationHistory>,
}

/// A surface, deg.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SurfaceHistory {
    /// Name of its drive.
    pub name: String,
    /// Commanded.
    pub command_deg: Vec<f64>,
    /// Reached.
    pub deflection_deg: Vec<f64>,
}

/// An inertial unit.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct UnitHistory {
    /// Name.
    pub name: String,
    /// Height over the plane of the centre, m.
    pub deflection_m: Vec<f64>,
    /// What it feels along its own axes aft, right and up, m/s2: at rest +9.81 upwards.
    pub acceleration_m_s2: [Vec<f64>; 3],
    /// Roll, pitch and yaw rate, deg/s.
    pub rates_deg_s: [Vec<f64>; 3],
}

/// A monitoring station.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StationHistory {
    /// Name and side.
    pub name: String,
    /// Fz (N), Mx, My (N m), aircraft axes.
    pub loads: [Vec<f64>; 3],
}

/// Three histories with the heads of their columns.
fn three(names: [String; 3], values: &[Vec<f64>; 3]) -> impl Iterator<Item = (String, &[f64])> {
    names.into_iter().zip(values.iter().map(Vec::as_slice))
}

impl FlightHistory {
    /// Column heads and columns, in the order of the CSV file.
    pub fn columns(&self) -> Vec<(String, &[f64])> {
        let one = |name: &str, values| -> (String, &[f64]) { (name.to_owned(), values) };
        let mut columns = vec![
            one("t_s", &self.t_s),
            one("delta_command_deg", &self.command_deg),
            one("delta_deg", &self.aileron_deg),
            one("alpha_deg", &self.alpha_deg),
            one("tip_deflection_m", &self.tip_deflection_m),
            one("tip_acceleration_m_s2", &self.tip_acceleration_m_s2),
        ];
        let loads = |part: &str| [format!("Fz_{part}_N"), format!("Mx_{part}_Nm"), format!("My_{part}_Nm")];
        let rates = |of: &str| ["roll", "pitch", "yaw"].map(|axis| format!("{of}{axis}_rate_deg_s"));
        columns.extend(three(rates("tip_"), &self.tip_rates_deg_s));
        columns.extend(three(loads("right"), &self.root_right));
        columns.extend(three(loads("left"), &self.root_left));
        columns.push(one("V_m_s", &self.v_m_s));
        columns.push(one("beta_deg", &self.beta_deg));
        columns.push(one("load_factor", &self.load_factor));
        columns.extend(three(rates(""), &self.rates_deg_s));
        columns.extend(three(["roll_deg", "pitch_deg", "yaw_deg"].map(str::to_owned), &self.angles_deg));
        columns.extend(three(["back_m", "right_m", "up_m"].map(str::to_owned), &self.place_m));
        for other in &self.others {
            columns.push((format!("{}_command_deg", other.name), &other.command_deg));
            columns.push((format!("{}_deg", other.name), &other.deflection_deg));
        }
        columns.push(one("gust_m_s", &self.gust_m_s));
        for unit in &self.units {
            let axes = ["x", "y", "z"].map(|axis| format!("{}_a{axis}_m_s2", unit.name));
            columns.push((format!("{}_deflection_m", unit.name), &unit.deflection_m));
            columns.extend(three(axes, &unit.acceleration_m_s2));
            columns.extend(three(rates(&format!("{}_", unit.name)), &unit.rates_deg_s));
        }
        for station in &self.stations {
            columns.extend(three(loads(&station.name), &station.loads));
        }
        columns
    }

    /// The histories as CSV with a header.
    pub fn csv(&self) -> String {
        self.csv_every(1)
    }

    /// The histories as CSV with a header, one row every so many samples (0 as 1).
    pub fn csv_every(&self, samples: usize) -> String {
        let columns = self.columns();
        let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
        let mut text = names.join(",") + "\n";
        for row in (0..self.t_s.len()).step_by(samples.max(1)) {
            for (at, (_, values)) in columns.iter().enumerate() {
                let comma = if at == 0 { "" } else { "," };
                // Writing to a String cannot fail.
                let _ = write!(text, "{comma}{:.7e}", values[row]);
            }
            text.push('\n');
        }
        text
    }

    /// Largest absolute value of a history.
    pub fn peak(values: &[f64]) -> f64 {
        values.iter().map(|value| value.abs()).fold(0.0, f64::max)
    }
}
