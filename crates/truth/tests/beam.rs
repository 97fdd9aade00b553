//! The beam beside closed forms, and beside numbers of the shipped wing that another program computed.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};
use truth::beam::{Axis, Beam, Slice};
use truth::wing::Wing;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// A uniform beam of length 2, EI 50, GJ 30, 0.8 kg/m, pitch inertia 0.02 kg m.
fn uniform(slices: usize, sweep_rad: f64) -> Beam {
    let axis = Axis { root_x_m: 0.0, sin: sweep_rad.sin(), cos: sweep_rad.cos() };
    let end_y_m = 2.0 * axis.cos;
    let width_m = end_y_m / slices as f64;
    let slice = |place: usize| {
        let mass_kg = 1.6 / slices as f64;
        let along_m = 2.0 / slices as f64;
        Slice {
            y_m: width_m * (place as f64 + 0.5),
            mass_kg,
            aft_m: 0.0,
            pitch_kg_m2: 0.02 * along_m,
            roll_kg_m2: mass_kg * along_m * along_m / 12.0,
        }
    };
    Beam::new(axis, end_y_m, (0..slices).map(slice).collect(), &|_: f64| [50.0, 30.0])
}

#[test]
fn a_cantilever_has_the_frequencies_of_euler_and_bernoulli() {
    let case: serde_json::Value = serde_json::from_str(
        &std::fs::read_to_string(data("published/fem__beam_modes.json")).expect("the file"),
    )
    .expect("JSON");
    let modes = uniform(80, 0.0).modes(8);
    let known = case["expected"]["cantilever_betaL"].as_array().expect("a list");
    // torsion of a clamped bar: an odd number of quarter waves, sqrt(GJ/I)/L times pi/2
    let torsion = |n: f64| n * 0.25 * TAU / 2.0 * (30.0_f64 / 0.02).sqrt();
    let mut expected: Vec<f64> = known[..4]
        .iter()
        .map(|beta| (beta.as_f64().expect("a number") / 2.0).powi(2) * (50.0_f64 / 0.8).sqrt())
        .chain([1.0, 3.0, 5.0, 7.0].map(torsion))
        .collect();
    expected.sort_by(f64::total_cmp);
    for (mode, (found, expected)) in modes.omega_rad_s.iter().zip(&expected).enumerate() {
        assert!((found / expected - 1.0).abs() < 1e-3, "mode {mode}: {found} rad/s, {expected}");
    }
}

#[test]
fn a_force_at_the_end_bends_the_end_by_a_third_of_its_length_cubed() {
    for sweep_rad in [0.0, 0.4] {
        let beam = uniform(20, sweep_rad);
        let x_m = beam.axis.x_m(beam.end_y_m);
        let found = beam.end_under(3.0, x_m, beam.end_y_m);
        assert!((found / (3.0 * 8.0 / (3.0 * 50.0)) - 1.0).abs() < 1e-4, "{found}");
    }
}

#[test]
fn modes_between_slices_are_smooth_and_bend_a_swept_wing_nose_down() {
    let beam = uniform(40, 0.4);
    let modes = beam.modes(3);
    let at = |y_m: f64| beam.shape(&modes, beam.axis.x_m(y_m), y_m);
    let (one, two) = (at(1.0), at(1.0 + 1e-4));
    assert!((one.height[0] - two.height[0]).abs() < 1e-3 * one.height[0].abs());
    // bent up: sections along x turn nose down
    assert!(one.height[0] * one.pitch[0] < 0.0);
}

/// The table of data/tuflex/README.md: frequencies of the beam, the tip under one kilogram, the mass.
#[test]
fn the_shipped_beam_has_the_frequencies_that_another_program_computed() {
    let wing = Wing::read(&data("tuflex/wing_beam.ron")).expect("the shipped wing");
    let beam = Beam::of_wing(&wing, 48);
    let hz: Vec<f64> = beam.modes(6).omega_rad_s.iter().map(|omega| omega / TAU).collect();
    println!("frequencies {hz:.3?} Hz");
    for (place, expected) in [(0, 4.56), (1, 20.4), (2, 51.4), (3, 76.2)] {
        assert!((hz[place] / expected - 1.0).abs() < 0.015, "mode {place}: {} Hz, {expected}", hz[place]);
    }
    let tip_x_m = beam.axis.x_m(1.8);
    let tip_m = beam.end_under(9.806_65, tip_x_m, 1.8);
    println!("tip under one kilogram {tip_m:.5} m");
    assert!((tip_m / 0.0756 - 1.0).abs() < 0.01, "{tip_m}");
    let mass_kg: f64 =
        beam.slices.iter().map(|s| s.mass_kg).chain(beam.extras.iter().map(|e| e.mass_kg)).sum();
    assert!((mass_kg - 2.2).abs() < 0.002, "{mass_kg} kg");
}
