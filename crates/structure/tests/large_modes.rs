//! Natural modes about a loaded state, against closed forms.

use crate::large::{beam_along_x, force, large};
use nalgebra::Vector3;
use std::f64::consts::PI;
use structure::nonlinear::{LargeDeflection, Loads, State};
use structure::normal_modes;

/// A beam on two supports, free to stretch; E I = 100 about the weak axis, 0.1 kg/m, length 10.
fn supported() -> LargeDeflection {
    large(&(beam_along_x(24, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,1234,1\nSPC1,1,234,25\n"))
}

fn hertz(wing: &LargeDeflection, state: &State, loads: &Loads, count: usize) -> Vec<f64> {
    let modes = normal_modes(&wing.tangent_system(state, loads), count).expect("modes");
    modes.omega_rad_s.iter().map(|omega| omega / (2.0 * PI)).collect()
}

#[test]
fn a_beam_under_tension_or_compression_sounds_as_a_stiff_string() {
    let wing = supported();
    // (n pi / L)^2 sqrt(E I / m) sqrt(1 + T L^2 / (n^2 pi^2 E I))
    for tension in [50.0, 0.0, -8.0] {
        let loads = Loads { dead: vec![force(24, [tension, 0.0, 0.0])], ..Loads::default() };
        let path = wing.under(&loads).expect("carried");
        let own = hertz(&wing, &path.end().state, &loads, 2);
        for (n, own) in [1.0, 2.0].into_iter().zip(own) {
            let wave: f64 = n * PI / 10.0;
            let bare = wave * wave * (100.0_f64 / 0.1).sqrt();
            let expected = bare * (1.0 + tension / (wave * wave * 100.0)).sqrt() / (2.0 * PI);
            println!("T = {tension}: mode {n}: {own:.5} Hz for {expected:.5}");
            assert!((own / expected - 1.0).abs() < 5e-3, "T = {tension}, mode {n}: {own} for {expected}");
        }
    }
}

#[test]
fn a_bent_wing_turned_in_space_keeps_its_frequencies() {
    let wing =
        large(&(beam_along_x(12, 10.0, 1.2e6, [0.1, 1.0]) + "SPC1,1,123456,1\nCONM2,50,13,,.2,.3,.4,.1\n"));
    let turn = nalgebra::Rotation3::from_scaled_axis(Vector3::new(1.0, -0.7, 1.9));
    let straight = Loads { dead: vec![force(12, [0.0, 0.5, 3.0])], ..Loads::default() };
    let turned = Loads { dead: vec![force(12, (turn * straight.dead[0].force).into())], ..Loads::default() };
    let state = wing.under(&straight).expect("carried").end().state.clone();
    let (before, after) =
        (hertz(&wing, &state, &straight, 6), hertz(&wing, &state.turned(&turn), &turned, 6));
    let unloaded = hertz(&wing, &wing.undeformed(), &Loads::default(), 6);
    println!("{unloaded:?} unloaded, {before:?} bent");
    for (one, other) in before.iter().zip(&after) {
        assert!((one / other - 1.0).abs() < 1e-8, "{before:?} {after:?}");
    }
    assert!(before.iter().zip(&unloaded).any(|(b, u)| (b / u - 1.0).abs() > 0.05), "bending changes them");
}
