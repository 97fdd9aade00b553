//! The wing and its image in steady maneuvers: what their own lift slope and beam say.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use std::path::Path;
use truth::beam::{Beam, Extra};
use truth::rig::{Coupled, GRAVITY_M_S2, Rig};
use truth::setting::Setting;
use truth::wing::Wing;

fn rig() -> Rig {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    Rig::new(Wing::read(&path).unwrap(), None).on_aircraft()
}

/// A flat wing without weight to carry lies flat; all is linear in the load factor.
#[test]
fn angle_and_tip_grow_in_proportion_to_the_load_factor_of_a_flat_wing() {
    let rig = rig();
    let coupled = Coupled::new(&rig, Setting::drawn(0.02, 3), 30.0, 1.225);
    let at = |load_factor: f64| coupled.steady(10.0, load_factor).unwrap();
    assert!(at(0.0).alpha_rad.abs() < 1e-9 && at(0.0).tip_z_m.abs() < 1e-9);
    for load_factor in [-2.0, 4.0] {
        let (one, more) = (at(1.0), at(load_factor));
        assert!((more.alpha_rad / (load_factor * one.alpha_rad) - 1.0).abs() < 1e-6);
        assert!((more.tip_z_m / (load_factor * one.tip_z_m) - 1.0).abs() < 1e-6);
    }
}

/// `n m g = q S a alpha` with the lift slope at rest.
#[test]
fn a_stiff_wing_flies_where_its_lift_slope_says() {
    let rig = rig();
    let mut stiff = Setting::drawn(0.02, 3);
    stiff.bending.scale(|_| 1e6);
    stiff.torsion.scale(|_| 1e6);
    let coupled = Coupled::new(&rig, stiff, 30.0, 1.225);
    let lift_n = |alpha_rad: f64| coupled.at_rest(alpha_rad, &[]).lift_n.sum();
    let slope_n_rad = (lift_n(0.1) - lift_n(0.0)) / 0.1;
    let alpha_rad = 2.0 * 10.0 * GRAVITY_M_S2 / slope_n_rad;
    let flown = coupled.steady(10.0, 2.0).unwrap();
    assert!((flown.alpha_rad / alpha_rad - 1.0).abs() < 1e-6, "{} {alpha_rad}", flown.alpha_rad);
}

/// In slow air, where lift does not follow the bending, a mass lowers the tip by its weight times the beam's influence coefficient
/// (`L³/3EI` of `tests/beam.rs`) times the load factor.
#[test]
fn a_mass_near_the_tip_lowers_it_by_its_weight_times_the_load_factor() {
    let rig = rig();
    let beam = Beam::of_wing(&rig.wing, rig.slices);
    let y_m = beam.slices[rig.slices - 2].y_m;
    let (mass_kg, x_m) = (0.02, beam.axis.x_m(y_m));
    let mut heavy = Setting::drawn(0.02, 3);
    heavy.extras.push(Extra { y_m, x_m, mass_kg });
    let tip = |setting: Setting| Coupled::new(&rig, setting, 3.0, 1.225).steady(0.01, 3.0).unwrap().tip_z_m;
    let lower_m = tip(Setting::drawn(0.02, 3)) - tip(heavy);
    let expected_m = beam.end_under(3.0 * GRAVITY_M_S2 * mass_kg, x_m, y_m);
    assert!((lower_m / expected_m - 1.0).abs() < 0.01, "{lower_m} {expected_m}");
}
