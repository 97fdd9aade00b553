//! What of a wing's effects flies with the wing: those of tunnel, balance and sensors stay behind, those of the air along
//! the span become corrections of its boxes, those of control surfaces another deflection. Others a flying wing of
//! linear structure and corrected air cannot carry.

use super::place::REFERENCE_V_M_S;
use super::{Active, Inputs, Place};
use crate::rig::Actuator;
use crate::rom::Zones;
use crate::smoothing::Smooth;
use aero::{Corrections, Flow};
use coupling::ElasticWing;

/// Effects of control surfaces that are another deflection, whatever else moves.
const DEFLECTIONS: [&str; 3] = ["ctl_saturation", "ctl_scale", "ctl_compliance"];

/// What becomes of effects when the wing flies.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Carried {
    /// Names of those that act through corrections or deflections.
    pub carried: Vec<&'static str>,
    /// Names of those that stay in the tunnel: of balance, stream and sensors.
    pub tunnel: Vec<&'static str>,
    /// Names of those that would travel, but that corrections and deflections cannot express.
    pub left: Vec<&'static str>,
}

/// Puts effects of the air into corrections of a wing's boxes at an airspeed, and tells what becomes of each.
///
/// `lift_slope` as a factor of boxes changes the lift of control surfaces, too; that of camber is taken back. An
/// `ac_shift` leaves what pressure offsets of the calibration do where it is.
pub fn carry(effects: &[Active], wing: &ElasticWing, v_m_s: f64, corrections: &mut Corrections) -> Carried {
    let mut result = Carried::default();
    let slower = if v_m_s > 0.0 { REFERENCE_V_M_S / v_m_s - 1.0 } else { 0.0 };
    for active in effects {
        let (spec, p) = (active.effect.spec(), &active.values);
        if !spec.side.travels() {
            result.tunnel.push(spec.name);
            continue;
        }
        match spec.name {
            "lift_slope" => slope(wing, corrections, p[0]),
            "re_dependence" => {
                slope(wing, corrections, p[0] * slower);
                incidence(wing, corrections, p[1].to_radians() * slower);
            }
            "tip_loss" => lost_to_tip(wing, corrections, p[0]),
            "ac_shift" => further_aft(wing, corrections, p[0]),
            "camber" => {
                incidence(wing, corrections, p[0].to_radians());
                moment(wing, corrections, p[1]);
            }
            name if DEFLECTIONS.contains(&name) => {}
            name => {
                result.left.push(name);
                continue;
            }
        }
        result.carried.push(spec.name);
    }
    result
}

/// What a control surface does with a deflection (rad) at an airspeed, by the effects that are another deflection.
pub fn acting_deflection(
    effects: &[Active],
    controls: &[String],
    control: &str,
    v_m_s: f64,
    delta_rad: f64,
) -> f64 {
    let Some(index) = controls.iter().position(|name| name == control) else { return delta_rad };
    let none = Vec::new;
    let zones = Zones {
        boxes: Vec::new(),
        y_norm: none(),
        y_m: none(),
        x_m: none(),
        chord_m: none(),
        area_m2: none(),
        width_m: none(),
    };
    let place = Place {
        flow: Flow { v_m_s, rho_kg_m3: 0.0 },
        zones: &zones,
        controls,
        time_step_s: 1.0,
        steady: true,
        clock_h: 0.0,
        // at rest no servo acts
        actuator: Actuator { frequency_hz: 1.0, damping_ratio: 1.0 },
        gravity_m_s2: 0.0,
        balance_y_m: 0.0,
        outer_shape: 0.0,
        first_stiffness: 0.0,
    };
    let still = || vec![0.0];
    let mut inputs = Inputs {
        alpha: Smooth { value: still(), rate: still(), second: still() },
        incidence_rad: still(),
        controls_rad: vec![still(); controls.len()],
    };
    inputs.controls_rad[index][0] = delta_rad;
    for active in effects.iter().filter(|active| DEFLECTIONS.contains(&active.effect.spec().name)) {
        active.effect.inputs(&active.values, &place, &mut inputs);
    }
    inputs.controls_rad[index][0]
}

/// Lift by angle changes by a share, that of camber does not.
fn slope(wing: &ElasticWing, corrections: &mut Corrections, share: f64) {
    for (k, &j) in wing.correctable.places.iter().enumerate() {
        corrections.pressure_offset[k] -= share * corrections.force[k] * wing.pressures_of_camber()[j];
        corrections.force[k] *= 1.0 + share;
        corrections.moment[k] *= 1.0 + share;
    }
}

/// All lift times `1 - d y²`.
fn lost_to_tip(wing: &ElasticWing, corrections: &mut Corrections, d: f64) {
    for (k, y) in wing.correctable.y_norm.iter().enumerate() {
        let factor = 1.0 - d * y * y;
        corrections.force[k] *= factor;
        corrections.moment[k] *= factor;
        corrections.pressure_offset[k] *= factor;
    }
}

/// Lift acts a share of the chord further aft: a moment nose down on every box.
fn further_aft(wing: &ElasticWing, corrections: &mut Corrections, dx_over_c: f64) {
    for (k, &j) in wing.correctable.places.iter().enumerate() {
        let chord_m = wing.correctable.chord_rows[k] as f64 * wing.lattice.boxes[j].chord_m();
        corrections.moment[k] -= dx_over_c * chord_m * corrections.force[k] / wing.integration.moment_arm(j);
    }
}

/// An angle of attack of all strips that gravity does not see.
fn incidence(wing: &ElasticWing, corrections: &mut Corrections, angle_rad: f64) {
    for (k, &j) in wing.correctable.places.iter().enumerate() {
        corrections.pressure_offset[k] += angle_rad * corrections.force[k] * wing.pressures_by_alpha()[j];
    }
}

/// A moment coefficient of all strips: pressures that fall in a straight line along the chord and carry no lift. A strip
/// of one box has none.
fn moment(wing: &ElasticWing, corrections: &mut Corrections, coefficient: f64) {
    for k in 0..wing.correctable.len() {
        let (row, rows) = (wing.correctable.chord_row[k] as f64, wing.correctable.chord_rows[k] as f64);
        let square = (rows * rows - 1.0) / 12.0;
        if square > 0.0 {
            corrections.pressure_offset[k] += coefficient * rows * (0.5 * (rows - 1.0) - row) / square;
        }
    }
}
