//! The section beside closed forms and published values: its air, its flutter, its motion with springs and friction that
//! are not linear.

use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

use free::air::{Strip, circulation};
use free::balance::Model;
use free::effect::{Active, Effect};
use free::motion::Motion;
use free::rig::LinearRig;
use free::section::{Section, State, Stream};
use nalgebra::Complex;
use serde_json::Value;

fn published(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).expect("a published case")).expect("JSON")
}

/// A rotor on a pitch spring, which heave and air leave alone: 20 rad/s without effects.
fn rotor() -> Section {
    Section {
        mass_kg: 10.0,
        unbalance_kgm: 0.0,
        inertia_kg_m2: 0.1,
        heave_stiffness_n_per_m: 1e3,
        heave_damping_n_s_per_m: 1.0,
        pitch_stiffness_nm: 40.0,
        pitch_damping_nm_s: 0.0,
        strip: Strip { semichord_m: 0.15, axis: -0.5, lifting_span_m: 1e-12, lag: 1.0 },
    }
}

const STILL: Stream = Stream { rho_kg_m3: 1.2, v_m_s: 1.0 };

/// Time between zeros of the pitch's rate, s, when let go from an angle, and the angle reached, rad.
fn swing(effect: Active, from_rad: f64) -> (f64, f64) {
    let (section, effects) = (rotor(), [effect]);
    let motion = Motion::new(&section, &effects, STILL, 20.0);
    let mut state = State::zeros();
    state[1] = from_rad;
    let dt_s = 1e-4;
    for k in 1..100_000 {
        let next = motion.step(&state, dt_s);
        if k > 10 && next[3] > 0.0 {
            let part = state[3] / (state[3] - next[3]);
            return (dt_s * (f64::from(k) - 1.0 + part), next[1]);
        }
        state = next;
    }
    panic!("no turn")
}

#[test]
fn the_lag_is_that_of_theodorsen_within_what_two_exponentials_can() {
    for row in published("unsteady2d__theodorsen.json")["expected"]["C"].as_array().expect("rows") {
        let [k, real, imaginary] = ["k", "F", "G"].map(|name| row[name].as_f64().expect("a number"));
        let difference = circulation(Complex::new(0.0, k), 1.0) - Complex::new(real, imaginary);
        assert!(difference.norm() < 0.025, "k = {k}: {difference} from Theodorsen");
    }
}

#[test]
fn a_typical_section_flutters_where_the_published_one_does() {
    let case = published("flutter__typical_section_theodorsen.json");
    let (rho, b, omega) = (1.225, 0.5, 20.0);
    let mass = 20.0 * PI * rho * b * b;
    let inertia = 0.24 * mass * b * b;
    let section = Section {
        mass_kg: mass,
        unbalance_kgm: 0.1 * mass * b,
        inertia_kg_m2: inertia,
        heave_stiffness_n_per_m: mass * (0.4 * omega) * (0.4 * omega),
        heave_damping_n_s_per_m: 0.0,
        pitch_stiffness_nm: inertia * omega * omega,
        pitch_damping_nm_s: 0.0,
        strip: Strip { semichord_m: b, axis: -0.2, lifting_span_m: 1.0, lag: 1.0 },
    };
    let v_m_s = section.onset_m_s(rho, [1.0, 60.0]).expect("flutter");
    let frequency = section.roots(Stream { rho_kg_m3: rho, v_m_s })[0].im / omega;
    let known = &case["expected"]["flutter"][0];
    let speed = v_m_s / (b * omega);
    let [known_speed, known_frequency] =
        ["V_over_b_wtheta", "omega_over_wtheta"].map(|name| known[name].as_f64().expect("a number"));
    assert!((speed / known_speed - 1.0).abs() < 0.01, "V/(b w) {speed}, published {known_speed}");
    assert!((frequency / known_frequency - 1.0).abs() < 0.01, "w {frequency}, published {known_frequency}");
}

#[test]
fn roots_of_the_states_are_roots_of_the_dynamic_stiffness() {
    let mut section = rotor();
    section.unbalance_kgm = 0.3;
    section.strip = Strip { lifting_span_m: 0.8, axis: -0.4, lag: 0.6, ..section.strip };
    let stream = Stream { rho_kg_m3: 1.2, v_m_s: 17.0 };
    for root in section.roots(stream) {
        let here = section.dynamic_stiffness(stream, root).determinant();
        let near = section.dynamic_stiffness(stream, root * 1.01).determinant();
        assert!(here.norm() < 1e-8 * near.norm(), "at {root} the determinant is {here}");
    }
}

/// K by the arithmetic-geometric mean; a Duffing oscillator's period is `4 K(m) / sqrt((k + k3 A²)/I)`,
/// `m = k3 A² / (2 (k + k3 A²))` (Nayfeh and Mook).
#[test]
fn a_cubic_spring_swings_with_the_period_of_the_elliptic_integral() {
    let (k3, amplitude) = (5e3_f64, 0.12_f64);
    let stiff = 40.0 + k3 * amplitude * amplitude;
    let (mut a, mut g) = (1.0_f64, (1.0 - k3 * amplitude * amplitude / (2.0 * stiff)).sqrt());
    while (a - g).abs() > 1e-14 {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    let half = 2.0 * FRAC_PI_2 / a / (stiff / 0.1_f64).sqrt();
    let (time, reached) = swing(Active { effect: Effect::CubicPitch, values: vec![k3] }, amplitude);
    assert!((time / half - 1.0).abs() < 1e-6, "half a period {time} s, elliptic integral {half} s");
    assert!((reached + amplitude).abs() < 1e-6, "energy: it comes to {reached} from {amplitude}");
}

#[test]
fn dry_friction_takes_the_same_angle_off_every_swing() {
    let friction = 0.4;
    let (_, reached) = swing(Active { effect: Effect::DryPitch, values: vec![friction] }, 0.12);
    // Den Hartog: 2 F/k a half swing
    let lost = 0.12 + reached;
    assert!((lost / (2.0 * friction / 40.0) - 1.0).abs() < 1e-2, "{lost} rad, closed form {}", 0.8 / 40.0);
}

/// First harmonics in closed form (Gelb and Vander Velde): 3/4 k3 A² for a cube, 8 k/(3 pi) A for angle times size,
/// 5/8 k5 A⁴ for a fifth power, and the growth -2 F/(pi A I w) of dry friction.
#[test]
fn harmonic_balance_gives_the_describing_functions_of_the_handbook() {
    let amplitude = 0.1;
    let stiffer = [
        (Effect::CubicPitch, 5e3, 0.75 * 5e3 * amplitude * amplitude),
        (Effect::AbsolutePitch, 400.0, 8.0 / (3.0 * PI) * 400.0 * amplitude),
        (Effect::QuinticPitch, 3e5, 0.625 * 3e5 * amplitude.powi(4)),
    ];
    let respond = |effect: Effect, value: f64| {
        let rig = LinearRig { section: rotor(), heave_gain: 1.0, heave_delay_s: 0.0 };
        let effects = vec![Active { effect, values: vec![value] }];
        let model = Model { rig, effects, centre_rad: 0.0, stiffness: 1.0, damping: 1.0 };
        let guess = [Complex::new(0.0, 20.0), Complex::new(0.0, 0.0)];
        model.respond(STILL, amplitude, guess).expect("a solution")[0]
    };
    for (effect, value, stiffness) in stiffer {
        let (found, known) = (respond(effect, value).im, ((40.0 + stiffness) / 0.1).sqrt());
        // |x| x has corners that 32 instants see within a thousandth
        assert!((found / known - 1.0).abs() < 1e-3, "{}: {found} rad/s, handbook {known}", effect.name());
    }
    let (found, known) = (respond(Effect::DryPitch, 0.1).re, -2.0 * 0.1 / (PI * amplitude * 0.1 * 20.0));
    assert!((found / known - 1.0).abs() < 0.02, "growth {found} 1/s, handbook {known}");
}

/// A root of the section, seen by a heave sensor of a tenth of the scale that is 3 ms late.
#[test]
fn harmonic_balance_of_a_linear_rig_gives_its_roots_as_the_sensors_see_them() {
    let mut section = rotor();
    section.unbalance_kgm = 0.3;
    section.strip = Strip { lifting_span_m: 0.8, axis: -0.4, lag: 0.6, ..section.strip };
    let stream = Stream { rho_kg_m3: 1.2, v_m_s: 17.0 };
    let (gain, delay_s) = (0.1, 0.003);
    let rig = LinearRig { section, heave_gain: gain, heave_delay_s: delay_s };
    let model = Model { rig, effects: Vec::new(), centre_rad: 0.0, stiffness: 1.0, damping: 1.0 };
    let p = section.roots(stream)[0];
    let own = section.dynamic_stiffness(stream, p);
    let heave = -own[(0, 1)] / own[(0, 0)] * gain * (-p * delay_s).exp();
    let found = model.respond(stream, 0.05, [p * 1.02, heave * 1.05]).expect("a solution");
    assert!((found[0] - p).norm() < 1e-6 * p.norm(), "{} from the root {p}", found[0]);
    assert!((found[1] - heave).norm() < 1e-6 * heave.norm(), "heave {} seen, closed form {heave}", found[1]);
}

#[test]
fn a_window_gives_back_growth_frequency_and_harmonics() {
    let (growth, omega, dt_s) = (-0.3, 17.0, 0.004);
    let time = |i: usize| dt_s * (i as f64 - 124.5);
    let wave = |t: f64, n: f64, phase: f64| (growth * n * t).exp() * (n * omega * t + phase).cos();
    let pitch: Vec<f64> =
        (0..250).map(|i| 0.002 + 0.05 * wave(time(i), 1.0, 0.4) + 0.001 * wave(time(i), 3.0, 1.2)).collect();
    let heave: Vec<f64> = (0..250).map(|i| 0.004 * wave(time(i), 1.0, 1.9)).collect();
    let found = free::window::oscillation(&pitch, &heave, dt_s, 1.05 * omega, false);
    let close = |name: &str, found: f64, known: f64| {
        assert!((found - known).abs() < 1e-5 * known.abs().max(1.0), "{name}: {found}, made with {known}");
    };
    close("growth", found.p.re, growth);
    close("frequency", found.p.im, omega);
    close("amplitude", found.amplitude_rad, 0.05);
    close("heave", found.heave[0].norm(), 0.08);
    close("phase", found.heave[0].arg(), 1.5);
    close("third harmonic", found.pitch[2].norm(), 0.02);
    // counted from where the first is largest, three times as fast: 1.2 - 3 * 0.4
    close("its phase", found.pitch[2].arg(), 0.0);
}
