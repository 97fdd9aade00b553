//! Balanced flight of the aircraft that bends: laws of balance, and small deflections as the limit of small loads.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be computed must fail")]

use crate::common::{whole, wings};
use aero::Corrections;
use coupling::GRAVITY_M_S2;
use fullaircraft::{Aircraft, FlightPoint};

#[test]
fn forces_and_moments_of_the_bent_aircraft_are_in_balance() {
    if std::env::var_os("RUN_SLOW_TESTS").is_none() {
        eprintln!(
            "skipped: the bent aircraft with and without corrections takes a minute (RUN_SLOW_TESTS=1)"
        );
        return;
    }
    let aircraft = whole();
    let body = aircraft.large().unwrap();
    let count = aircraft.right.boxes.len();
    let mut uneven = Corrections::neutral(count);
    for j in 0..count {
        uneven.force[j] = 1.0 - 0.1 * j as f64 / count as f64;
        uneven.pressure_offset[j] = 0.01;
    }
    for model in [aircraft.uncorrected(), aircraft.with_corrections(&uneven).unwrap()] {
        for (what, point) in [
            ("trim", aircraft.file.trim),
            ("pull-up", aircraft.file.pull_up),
            ("push-down", aircraft.file.push_down),
        ] {
            let large = body.trim(&model, &point).unwrap();
            assert!(large.unbalanced.iter().all(|left| *left < 1e-8), "{what}: {:?}", large.unbalanced);
            // The air carries n m g, by its own sum.
            let lift: f64 = large.flight.air.chunks_exact(6).map(|six| six[2]).sum();
            let wanted = point.load_factor * 20.0 * GRAVITY_M_S2 * large.alpha_rad.cos();
            assert!((lift / wanted - 1.0).abs() < 1e-8, "{what}: {lift} N for {wanted}");
            let [right, left] = large.tip_deflection_m;
            assert!((right - left).abs() < 1e-7 * right.abs(), "{what}: tips {right} and {left}");
        }
    }
}

/// The airspeed at which the aircraft flies at no angle of attack at a load factor (no pitch rate), m/s: lift over dynamic pressure
/// is that of camber then, and the wake leaves along the fuselage, as small deflections have it.
fn without_angle(aircraft: &Aircraft, load_factor: f64) -> FlightPoint {
    let model = aircraft.uncorrected();
    let at = |v_m_s: f64| FlightPoint { v_m_s, load_factor, pitch_rate_deg_s: 0.0 };
    let angle = |v_m_s: f64| model.trim("level", &at(v_m_s)).unwrap().alpha_rad;
    let (mut slow, mut fast) = (20.0 * load_factor.sqrt(), 60.0 * load_factor.sqrt());
    assert!(angle(slow) > 0.0 && angle(fast) < 0.0, "{} {}", angle(slow), angle(fast));
    for _ in 0..20 {
        let middle = 0.5 * (slow + fast);
        if angle(middle) > 0.0 { slow = middle } else { fast = middle }
    }
    at(slow)
}

#[test]
fn small_loads_give_the_trim_of_small_deflections() {
    for (what, aircraft) in [("wings alone", wings()), ("whole", whole())] {
        let body = aircraft.large().unwrap();
        let model = aircraft.uncorrected();
        let point = without_angle(aircraft, 1e-4);
        let (large, linear) = (body.trim(&model, &point).unwrap(), model.trim("small", &point).unwrap());
        let off = (large.tip_deflection_m[0] / linear.tip_deflection_m[0] - 1.0).abs();
        assert!(off < 1e-4, "{what}: tips differ by {off}");
        let elevator = (large.elevator_rad - linear.elevator_rad).to_degrees().abs();
        assert!(elevator < 1e-3, "{what}: elevators differ by {elevator} degrees");
    }
}
