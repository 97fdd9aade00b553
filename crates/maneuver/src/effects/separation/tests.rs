//! Stalled lift by hand.

use super::*;
use crate::rig::Actuator;
use crate::rom::Zones;
use aero::Flow;

#[test]
fn beyond_its_limit_a_strip_keeps_a_share_of_its_slope() {
    assert!((limit_rad(4.0) - 12.0_f64.to_radians()).abs() < 1e-12);
    // at .3 rad with a limit of .2 and k = 3 a quarter of the excess stays: three quarters of .1 times 50 N are lost
    assert!((stalled(15.0, 50.0, 0.2, 3.0) - 3.75).abs() < 1e-12);
    assert!((stalled(-15.0, 50.0, 0.2, 3.0) + 3.75).abs() < 1e-12);
    for (lift, by, k) in [(9.9, 50.0, 3.0), (15.0, 50.0, 0.0), (15.0, 0.0, 3.0), (15.0, -50.0, 3.0)] {
        assert_eq!(stalled(lift, by, 0.2, k).abs(), 0.0, "{lift} {by} {k}");
    }
}

#[test]
fn a_strip_s_lift_by_angle_is_two_pi_times_pressure_and_area() {
    let zones = Zones { area_m2: vec![0.1, 0.25], ..Zones::default() };
    let place = Place {
        flow: Flow { v_m_s: 60.0, rho_kg_m3: 1.2 },
        zones: &zones,
        controls: &[],
        time_step_s: 0.01,
        steady: false,
        clock_h: 0.0,
        actuator: Actuator { frequency_hz: 5.0, damping_ratio: 0.7 },
        gravity_m_s2: 9.81,
        balance_y_m: 0.0,
        outer_shape: 0.0,
        first_stiffness: 0.0,
    };
    assert!((lift_by_angle(&place, 1) - std::f64::consts::TAU * 0.6 * 3600.0 * 0.25).abs() < 1e-9);
    assert!((place.q_over_reference() - 4.0).abs() < 1e-12 && (place.q_pa() - 2160.0).abs() < 1e-9);
}
