//! Separation follows the angle late: what stall takes off passes a lag of `t c/V`.
//! The first parameter as in `stall`.

use super::prelude::*;

/// See the module.
#[derive(Debug)]
pub(crate) struct DynamicStall;

impl Effect for DynamicStall {
    fn spec(&self) -> &'static Spec {
        &Spec {
            name: "dynamic_stall",
            title: "stall with a lag",
            side: Side::Aerodynamics,
            rivals: &["stall", "aero_lag", "static_hysteresis"],
            experiment: "one minus cosine into stall at three rates",
        }
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            Parameter::new("earlier_than_16_deg", (0.0, 14.0), 8.0),
            Parameter::new("k", (0.0, 3.0), 0.5),
            Parameter::new("chords", (0.0, 20.0), 5.0),
        ]
    }

    fn starts(&self) -> Vec<Vec<f64>> {
        super::stall::STARTS.iter().map(|earlier| vec![*earlier, 0.3, 5.0]).collect()
    }

    fn needs_zones(&self) -> bool {
        true
    }

    fn forces(&self, p: &[f64], place: &Place<'_>, seen: &Seen<'_>, forces: &mut Forces) {
        let limit = (16.0 - p[0]).to_radians();
        for zone in 0..forces.lift_n.len() {
            let by_angle = lift_by_angle(place, zone);
            if by_angle == 0.0 || p[1] == 0.0 {
                continue;
            }
            let lost = |lift: &f64| stalled(*lift, by_angle, limit, p[1]);
            let mut late: Vec<f64> = seen.lift_n[zone].iter().map(lost).collect();
            if !place.steady {
                let lag_s = p[2] * place.zones.chord_m[zone] / place.flow.v_m_s;
                late = signal::first_order(&late, place.time_step_s, lag_s);
            }
            for (lift, late) in forces.lift_n[zone].iter_mut().zip(late) {
                *lift -= late;
            }
        }
    }
}
