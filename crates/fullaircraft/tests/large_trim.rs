//! Balanced flight of the aircraft that bends: laws of balance, and small deflections as the limit of small loads.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be computed must fail")]

use crate::common::{beam_wing, path, whole, wings};
use aero::Corrections;
use coupling::{GRAVITY_M_S2, Wake, WingFile};
use fullaircraft::{Aircraft, AircraftFile, FlightPoint};

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
            let linear = model.trim(what, &point).unwrap();
            println!(
                "{what}: {:?}, {:?} left over; small deflections: {:.3} deg, elevator {:.3}, tip {:.4} m, Mx {:.2}",
                large.numbers(),
                large.unbalanced,
                linear.alpha_rad.to_degrees(),
                linear.elevator_rad.to_degrees(),
                linear.tip_deflection_m[0],
                linear.root_loads[0].mx_nm
            );
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

/// By what share the tips of the bent aircraft are off small deflections, and by how many degrees the elevator.
fn off(aircraft: &Aircraft, load_factor: f64) -> [f64; 2] {
    let (body, model) = (aircraft.large().unwrap(), aircraft.uncorrected());
    let point = without_angle(aircraft, load_factor);
    let (large, linear) = (body.trim(&model, &point).unwrap(), model.trim("small", &point).unwrap());
    let tip = (large.tip_deflection_m[0] / linear.tip_deflection_m[0] - 1.0).abs();
    [tip, (large.elevator_rad - linear.elevator_rad).to_degrees().abs()]
}

#[test]
fn what_bending_changes_falls_with_the_load_to_the_trim_of_small_deflections() {
    let alone = off(wings(), 1e-3);
    assert!(alone[0] < 1e-4, "wings alone: {alone:?}");
    let (some, few) = (off(whole(), 1e-2), off(whole(), 1e-3));
    println!("tip and elevator differ by {some:?} at a hundredth of the load, {few:?} at a tenth of that");
    assert!(few[0] < 1e-4 && few[1] < 1e-3, "{few:?}");
    for (what, some, few) in [("tip", some[0], few[0]), ("elevator", some[1], few[1])] {
        // Round-off says nothing.
        let fall = some / few;
        assert!(
            some < 1e-6 || (8.0..120.0).contains(&fall),
            "{what}: {some} falls to {few} with a tenth of the load"
        );
    }
}

/// A trim of next to no load at the angle of attack of the whole one.
fn hardly_loaded(point: FlightPoint) -> FlightPoint {
    let share = 1e-4;
    FlightPoint {
        v_m_s: point.v_m_s * f64::sqrt(share),
        load_factor: point.load_factor * share,
        pitch_rate_deg_s: point.pitch_rate_deg_s * f64::sqrt(share),
    }
}

#[test]
fn at_an_angle_of_attack_the_elevator_without_load_is_that_of_small_deflections() {
    let aircraft = whole();
    let (body, model) = (aircraft.large().unwrap(), aircraft.uncorrected());
    for (what, point) in [("trim", aircraft.file.trim), ("pull-up", aircraft.file.pull_up)] {
        let point = hardly_loaded(point);
        let (large, linear) = (body.trim(&model, &point).unwrap(), model.trim("small", &point).unwrap());
        let [own, of] = [large.elevator_rad, linear.elevator_rad].map(f64::to_degrees);
        let [alpha, linear_alpha] = [large.alpha_rad, linear.alpha_rad].map(f64::to_degrees);
        println!("{what}: elevator {own:.4} for {of:.4}, angle of attack {alpha:.4} for {linear_alpha:.4}");
        // A sine is not the angle: some shares of the square of the angle, of incidences of 10 degrees with the camber's.
        let most = 10.0 * (large.alpha_rad.powi(2) + 1e-4);
        assert!((own - of).abs() < most, "{what}: elevator {own} for {of}");
        assert!((alpha - linear_alpha).abs() < most, "{what}: {alpha} for {linear_alpha}");
    }
}

/// The horizontal tail moved up, m.
fn with_tail_moved(up_m: f64) -> Aircraft {
    let mut file = AircraftFile::read(&path()).unwrap();
    file.htp.root_leading_edge_m.2 += up_m;
    Aircraft::new(file, WingFile::read(&beam_wing()).unwrap()).unwrap()
}

#[test]
fn a_tail_a_few_millimetres_higher_needs_the_same_elevator() {
    if std::env::var_os("RUN_SLOW_TESTS").is_none() {
        eprintln!("skipped: trims of tails at five heights take a minute (RUN_SLOW_TESTS=1)");
        return;
    }
    let elevator = |up_m: f64| {
        let aircraft = with_tail_moved(up_m);
        let model = aircraft.uncorrected();
        let of = |wake: Wake| {
            let large = aircraft.large().unwrap().with_wake(wake).trim(&model, &aircraft.file.trim).unwrap();
            large.elevator_rad.to_degrees()
        };
        let linear = model.trim("trim", &aircraft.file.trim).unwrap().elevator_rad.to_degrees();
        let [body, stream] = [Wake::Body, Wake::Stream].map(of);
        println!(
            "tail {:+.0} mm: elevator {linear:.3} linear, {body:.3} with the wake along the fuselage, {stream:.3} along the stream",
            1e3 * up_m
        );
        [linear, body]
    };
    let all = [-0.02, -0.008, -0.004, 0.0, 0.004, 0.008, 0.02].map(elevator);
    for pair in all.windows(2) {
        for (what, which) in [("small", 0), ("large", 1)] {
            let change = (pair[1][which] - pair[0][which]).abs();
            assert!(change < 0.1, "{what} deflections: the elevator jumps by {change} degrees");
        }
    }
}
