//! Time histories of a dynamic maneuver: what sensors on board would show.

use serde::{Deserialize, Serialize};
use std::fmt::Write as _;

/// Time histories of a maneuver; all the same length. They include the trimmed state, except accelerations and rates.
///
/// Rates have the signs of flight mechanics: roll positive with the right wing down, pitch nose up, yaw nose
/// right. That is the opposite of rotations about x (aft) and z (up) of the model's axes.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct FlightHistory {
    /// Time, s.
    pub t_s: Vec<f64>,
    /// Commanded aileron (right trailing edge down, left up), deg.
    pub command_deg: Vec<f64>,
    /// The aileron itself, deg.
    pub aileron_deg: Vec<f64>,
    /// Angle of attack of the centre (the wing's root), deg.
    pub alpha_deg: Vec<f64>,
    /// Height of the right tip's accelerometer over the plane of the centre, without load, m.
    pub tip_deflection_m: Vec<f64>,
    /// Acceleration of that accelerometer upwards, without the steady load factor, m/s2.
    pub tip_acceleration_m_s2: Vec<f64>,
    /// Roll, pitch and yaw rate of that accelerometer, deg/s.
    pub tip_rates_deg_s: [Vec<f64>; 3],
    /// Root loads of the right wing: Fz (N), Mx, My (N m), aircraft axes.
    pub root_right: [Vec<f64>; 3],
    /// Root loads of the left wing.
    pub root_left: [Vec<f64>; 3],
}

impl FlightHistory {
    /// Column heads and columns, in the order of the CSV file.
    pub fn columns(&self) -> Vec<(&'static str, &[f64])> {
        let mut columns: Vec<(&'static str, &[f64])> = vec![
            ("t_s", &self.t_s),
            ("delta_command_deg", &self.command_deg),
            ("delta_deg", &self.aileron_deg),
            ("alpha_deg", &self.alpha_deg),
            ("tip_deflection_m", &self.tip_deflection_m),
            ("tip_acceleration_m_s2", &self.tip_acceleration_m_s2),
        ];
        let rates = ["tip_roll_rate_deg_s", "tip_pitch_rate_deg_s", "tip_yaw_rate_deg_s"];
        let right = ["Fz_right_N", "Mx_right_Nm", "My_right_Nm"];
        let left = ["Fz_left_N", "Mx_left_Nm", "My_left_Nm"];
        for (names, values) in
            [(rates, &self.tip_rates_deg_s), (right, &self.root_right), (left, &self.root_left)]
        {
            columns.extend(names.into_iter().zip(values.iter().map(Vec::as_slice)));
        }
        columns
    }

    /// The histories as CSV with a header.
    pub fn csv(&self) -> String {
        let columns = self.columns();
        let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
        let mut text = names.join(",") + "\n";
        for row in 0..self.t_s.len() {
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
