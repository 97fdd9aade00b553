//! Laws of the wing on its balance: flights end where the wing rests, still air leaves inertia and weight, superposition.

use std::path::{Path, PathBuf};
use truth::rig::{Coupled, Flight, Inputs, Rig};
use truth::setting::Setting;
use truth::wing::{Polars, Wing};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

fn rig() -> Rig {
    let wing = Wing::read(&data("wing_beam.ron")).expect("the shipped wing");
    Rig::new(wing, Some(Polars::read(&data("e214_neuralfoil_polars.csv")).expect("the polars")))
}

fn drawn(rig: &Rig) -> Setting {
    Setting::drawn(rig.wing.damping_ratio, rig.wing.controls.len())
}

/// A smooth step from 0 to 1 within `width_s`, with its derivatives.
fn rise(t_s: f64, width_s: f64) -> [f64; 3] {
    let x = (t_s / width_s).clamp(0.0, 1.0);
    let (one, two) = (1.0 / width_s, 1.0 / width_s / width_s);
    let inside = if x > 0.0 && x < 1.0 { 1.0 } else { 0.0 };
    [
        x.powi(3) * (10.0 - 15.0 * x + 6.0 * x * x),
        inside * one * 30.0 * (x * (1.0 - x)).powi(2),
        inside * two * 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x),
    ]
}

/// Inputs in which pitch rises from `alpha_rad` by `up_rad` and a control by `delta_rad` within `width_s`.
fn inputs(
    coupled: &Coupled<'_>,
    alpha_rad: f64,
    up_rad: f64,
    delta_rad: f64,
    width_s: f64,
    length_s: f64,
) -> Inputs {
    let mut inputs = Inputs {
        alpha: [Vec::new(), Vec::new(), Vec::new()],
        controls: vec![[Vec::new(), Vec::new(), Vec::new()]; 3],
    };
    let mut t_s = 0.0;
    while t_s < length_s {
        let values = rise(t_s - 0.02, width_s);
        for (derivative, value) in values.iter().enumerate() {
            let base = if derivative == 0 { alpha_rad } else { 0.0 };
            inputs.alpha[derivative].push(base + up_rad * value);
            for (control, record) in inputs.controls.iter_mut().enumerate() {
                record[derivative].push(if control == 1 { delta_rad * value } else { 0.0 });
            }
        }
        t_s += coupled.time_step_s;
    }
    inputs
}

fn last(flight: &Flight) -> [f64; 4] {
    let end = |values: &Vec<f64>| *values.last().expect("a step");
    [end(&flight.loads[0]), end(&flight.loads[1]), end(&flight.loads[2]), end(&flight.tip_z_m)]
}

#[test]
fn a_flight_ends_where_the_wing_rests() {
    let rig = rig();
    let mut setting = drawn(&rig);
    setting.slack_rad = 1e-3;
    setting.wall_rad = 0.002;
    let coupled = Coupled::new(&rig, setting, 30.0, 1.225);
    let motion = inputs(&coupled, 0.02, 0.06, 0.05, 0.3, 8.0);
    let flight = coupled.fly(&motion, false);
    let rest = coupled.at_rest(0.08, &[0.0, 0.05, 0.0]);
    for (found, expected) in
        last(&flight).iter().zip([rest.loads[0], rest.loads[1], rest.loads[2], rest.tip_z_m])
    {
        println!("{found:.4} {expected:.4}");
        // what is left of the wake's memory after 8 s: 240 m
        assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
    }
}

#[test]
fn half_the_motion_gives_half_the_change() {
    let rig = rig();
    let coupled = Coupled::new(&rig, drawn(&rig), 22.0, 1.225);
    let change = |share: f64| {
        let flight = coupled.fly(&inputs(&coupled, 0.0, 0.0, 0.1 * share, 0.05, 0.4), false);
        flight.loads.map(|load| load.iter().map(|value| value - load[0]).collect::<Vec<f64>>())
    };
    let (whole, half) = (change(1.0), change(0.5));
    for channel in 0..3 {
        let largest = whole[channel].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        assert!(largest > 0.5);
        for (a, b) in whole[channel].iter().zip(&half[channel]) {
            assert!((a - 2.0 * b).abs() < 1e-9 * largest);
        }
    }
}

/// Slowly pitched without wind the balance sees the weight of a tilted wing, and nothing else: m g x (cos a - 1).
#[test]
fn without_wind_a_slow_pitch_shows_weight_alone() {
    let rig = rig();
    let coupled = Coupled::new(&rig, drawn(&rig), 0.0, 1.225);
    let flight = coupled.fly(&inputs(&coupled, 0.0, 0.3, 0.0, 6.0, 6.3), false);
    let [fz, mx, _, _] = last(&flight);
    let weight_n = 2.2 * 9.806_65 * (1.0 - 0.3_f64.cos());
    println!("{fz:.4} N, {weight_n:.4} N; {mx:.4} N m");
    assert!((fz / weight_n - 1.0).abs() < 0.01, "{fz}");
    assert!(mx > 0.0 && mx < 0.5 * weight_n);
}

/// A pitch that swings long enough in time has the amplitude and phase of the steady oscillation.
#[test]
fn a_long_swing_in_time_is_the_steady_oscillation() {
    let rig = rig();
    let coupled = Coupled::new(&rig, drawn(&rig), 30.0, 1.225);
    let omega = std::f64::consts::TAU * 3.0;
    let steps = 6.0 / coupled.time_step_s;
    let mut motion = inputs(&coupled, 0.0, 0.0, 0.0, 0.1, 6.0);
    for i in 0..motion.alpha[0].len() {
        let t_s = i as f64 * coupled.time_step_s;
        let [a, b, c] = rise(t_s, 1.0);
        let (sin, cos) = (omega * t_s).sin_cos();
        motion.alpha[0][i] = 1e-3 * a * sin;
        motion.alpha[1][i] = 1e-3 * (b * sin + a * omega * cos);
        motion.alpha[2][i] = 1e-3 * (c * sin + 2.0 * b * omega * cos - a * omega * omega * sin);
    }
    let flight = coupled.fly(&motion, false);
    let expected = coupled.swing(omega);
    // the last three periods: projections on sine and cosine
    let count = flight.tip_z_m.len();
    let last = 1.0 / coupled.time_step_s;
    assert!(steps > 4.0 * last);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a number of steps")]
    let first = count - last.round() as usize;
    for channel in 0..3 {
        let (mut re, mut im) = (0.0, 0.0);
        for (i, load) in flight.loads[channel].iter().enumerate().skip(first) {
            let change = (load - flight.loads[channel][0]) / 1e-3;
            let (sin, cos) = (omega * i as f64 * coupled.time_step_s).sin_cos();
            re += 2.0 * change * sin / last;
            im += 2.0 * change * cos / last;
        }
        let exact = expected[(channel, 0)];
        let off = ((re - exact.re).hypot(im - exact.im)) / exact.norm();
        println!("channel {channel}: {re:.3} {im:.3}, {:.3} {:.3}: {:.2} %", exact.re, exact.im, 100.0 * off);
        assert!(off < 0.005, "channel {channel}: {off}");
    }
}

/// A stiff wing in a vacuum, pitched: the balance sees mass times arms of the drawing's bodies, summed here anew.
#[test]
fn a_stiff_wing_in_a_vacuum_shows_its_inertia() {
    let rig = rig();
    let mut setting = drawn(&rig);
    setting.bending.scale(|_| 1e5);
    setting.torsion.scale(|_| 1e5);
    let coupled = Coupled::new(&rig, setting, 0.0, 1e-9);
    let omega = 20.0;
    let found = coupled.swing(omega);
    let beam = truth::beam::Beam::of_wing(&rig.wing, rig.slices);
    let slices =
        beam.slices.iter().map(|s| (s.mass_kg, beam.axis.x_m(s.y_m) + s.aft_m, s.y_m, s.pitch_kg_m2));
    let lumps = beam.extras.iter().map(|e| (e.mass_kg, e.x_m, e.y_m, 0.0));
    let (mut fz, mut mx, mut my) = (0.0, 0.0, 0.0);
    for (mass_kg, x_m, y_m, own) in slices.chain(lumps) {
        let aft_m = x_m - rig.wing.pitch_x_m;
        // nose up with -omega² : what is aft is thrown down, so inertia pulls up against it
        fz -= omega * omega * mass_kg * aft_m;
        mx -= omega * omega * mass_kg * aft_m * y_m;
        my += omega * omega * (mass_kg * aft_m * aft_m + own);
    }
    for (channel, expected) in [fz, mx, my].into_iter().enumerate() {
        let load = found[(channel, 0)];
        println!("{:.5} {expected:.5}", load.re);
        assert!((load.re / expected - 1.0).abs() < 2e-3, "channel {channel}: {} {expected}", load.re);
    }
}

/// The angle without lift lies among the angles of zero lift of the strips' polars, which are cambered.
#[test]
fn a_wing_of_polars_has_no_lift_where_its_sections_have_none() {
    let rig = rig();
    let mut setting = drawn(&rig);
    setting.bending.scale(|_| 1e5);
    setting.torsion.scale(|_| 1e5);
    let coupled = Coupled::new(&rig, setting, 30.0, 1.225);
    let lift = |alpha_deg: f64| {
        let rest = coupled.at_rest(f64::to_radians(alpha_deg), &[0.0; 3]);
        rest.lift_n.iter().sum::<f64>()
    };
    let (none, one) = (lift(0.0), lift(1.0));
    let without_deg = -none / (one - none);
    let polars = rig.polars.as_ref().expect("polars");
    let zeros = [0.15, 0.2, 0.25, 0.3].map(|chord_m| polars.section(30.0, chord_m).zero_rad.to_degrees());
    println!("no lift at {without_deg:.3} degrees, sections {zeros:.3?}");
    assert!(none > 0.0);
    let (low, high) = zeros.iter().fold((f64::MAX, f64::MIN), |(a, b), zero| (a.min(*zero), b.max(*zero)));
    assert!((low - 0.05..=high + 0.05).contains(&without_deg), "{without_deg} {zeros:?}");
}
