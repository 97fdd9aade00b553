//! What of a wing's effects flies with the wing: those of tunnel, balance and sensors stay behind, those of the air along
//! the span become corrections of its boxes, those of control surfaces another deflection. Others a flying wing of
//! linear structure and corrected air cannot carry. Which is which, each effect's own file declares.

use super::active::Active;
use super::flight_air::{Flight, FlightAir};
use super::place::{Inputs, Place};
use crate::rig::Actuator;
use crate::rom::Zones;
use crate::smoothing::Smooth;
use aero::{Corrections, Flow};
use coupling::ElasticWing;

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
pub fn carry(effects: &[Active], wing: &ElasticWing, v_m_s: f64, corrections: &mut Corrections) -> Carried {
    let mut result = Carried::default();
    let mut air = FlightAir { wing, v_m_s, corrections };
    for Active { effect, values } in effects {
        let spec = effect.spec();
        let among = match effect.flight() {
            _ if !spec.side.travels() => &mut result.tunnel,
            Flight::Left => &mut result.left,
            Flight::Deflection => &mut result.carried,
            Flight::Corrections => {
                effect.correct(values, &mut air);
                &mut result.carried
            }
        };
        among.push(spec.name);
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
    let zones = Zones::default();
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
    for active in effects.iter().filter(|active| active.effect.flight() == Flight::Deflection) {
        active.effect.inputs(&active.values, &place, &mut inputs);
        active.effect.surfaces(&active.values, &place, &mut inputs);
    }
    inputs.controls_rad[index][0]
}
