//! Trimmed flight against an independent program's table, closed forms, and laws of balance and symmetry.
//!
//! The table is the one in data/tuflex/README.md, "The aircraft": a vortex lattice of 28 by 12 boxes with an image, beam
//! of 36 elements, wings carrying all lift, made by an independent program when the stand-in was sized.

use crate::common::{assert_near, path, whole, wings};
use aero::{BoxLoads, Corrections, Integration, MirrorPlane, SteadyAero, incidence};
use coupling::GRAVITY_M_S2;
use faer::Mat;
use fullaircraft::{Aircraft, AircraftError, AircraftFile, FlightPoint};
use nalgebra::Point3;

#[test]
fn wings_alone_meet_the_table_of_the_independent_program() {
    let (aircraft, model) = (wings(), wings().uncorrected());
    let trim = model.trim("trim", &aircraft.file.trim).unwrap();
    let pull_up = model.trim("pull_up", &aircraft.file.pull_up).unwrap();
    let push_down = model.trim("push_down", &aircraft.file.push_down).unwrap();
    assert_near("alpha at 25.7 m/s", trim.alpha_rad.to_degrees(), 2.24, 0.03);
    assert_near("tip at 1 g", trim.tip_deflection_m[0], 0.163, 0.03);
    assert_near("tip at 4 g and 37 m/s", pull_up.tip_deflection_m[0], 0.599, 0.03);
    assert_near("tip at -2 g and 42 m/s", push_down.tip_deflection_m[0], -0.314, 0.03);
}

#[test]
fn the_whole_aircraft_is_near_what_was_expected_of_it() {
    // 2.3 deg, 0.58 m and -0.28 m: estimates of the same sizing study for a trimming tail, given as rough.
    let (aircraft, model) = (whole(), whole().uncorrected());
    let trim = model.trim("trim", &aircraft.file.trim).unwrap();
    let pull_up = model.trim("pull_up", &aircraft.file.pull_up).unwrap();
    let push_down = model.trim("push_down", &aircraft.file.push_down).unwrap();
    assert_near("alpha", trim.alpha_rad.to_degrees(), 2.3, 0.10);
    assert_near("tip at 4 g", pull_up.tip_deflection_m[0], 0.58, 0.10);
    assert_near("tip at -2 g", push_down.tip_deflection_m[0], -0.28, 0.20);
}

#[test]
fn trimmed_flight_balances_weight_and_moment_and_is_symmetric() {
    let aircraft = whole();
    let uneven = uneven(aircraft.right.boxes.len());
    for model in [aircraft.uncorrected(), aircraft.with_corrections(&uneven).unwrap()] {
        for point in [aircraft.file.trim, aircraft.file.pull_up, aircraft.file.push_down] {
            let trimmed = model.trim("point", &point).unwrap();
            let weight_n = point.load_factor * 20.0 * GRAVITY_M_S2;
            assert_near("lift", trimmed.fz_n, weight_n, 1e-9);
            assert!(trimmed.my_nm.abs() < 1e-8);
            let [right, left] = trimmed.tip_deflection_m;
            assert!((right - left).abs() < 1e-11 * right.abs(), "tips {right} and {left}");
            let [right, left] = trimmed.root_loads;
            assert_near("Fz of the left wing", left.fz_n, right.fz_n, 1e-11);
            assert_near("Mx of the left wing", left.mx_nm, -right.mx_nm, 1e-11);
            assert_near("My of the left wing", left.my_nm, right.my_nm, 1e-11);
        }
    }
}

#[test]
fn the_wings_carry_the_fuselage() {
    // Without tail and fuselage in the flow, the two roots carry what is not wing: 20 kg less two wings of 2.2 kg (which
    // the table of masses over the span meets to 0.02 %).
    let trimmed = wings().uncorrected().trim("pull_up", &wings().file.pull_up).unwrap();
    let carried = trimmed.root_loads[0].fz_n + trimmed.root_loads[1].fz_n;
    assert_near("root loads", carried, 4.0 * GRAVITY_M_S2 * (20.0 - 2.0 * 2.2), 2e-4);
}

#[test]
fn a_rigid_aircraft_is_trimmed_as_two_equations_by_hand_say() {
    let aircraft = rigid();
    let point = aircraft.file.pull_up;
    let trimmed = aircraft.uncorrected().trim("pull_up", &point).unwrap();
    let lattice = &aircraft.flow.lattice;
    let aero = SteadyAero::new(lattice, MirrorPlane::None, 0.0).unwrap();
    let centre = Point3::new(0.40, 0.0, 0.0);
    let q_pa = 0.5 * 1.225 * point.v_m_s * point.v_m_s;
    let (integration, neutral) = (Integration::new(lattice), Corrections::neutral(lattice.len()));
    let sums = |w: &[f64]| {
        let loads: BoxLoads = integration.corrected(&neutral).box_loads(q_pa, &aero.pressures_of(w));
        let (force, moment) = loads.resultant(lattice, 0..lattice.len(), &centre);
        [force[2], moment[1]]
    };
    let rate = incidence::pitch_rate(lattice, 0.40, point.v_m_s);
    let rate_rad_s = point.pitch_rate_deg_s.to_radians();
    let fixed: Vec<f64> =
        aircraft.flow.camber.iter().zip(rate).map(|(camber, rate)| camber + rate * rate_rad_s).collect();
    let elevator =
        aircraft.control_pair("elevator").unwrap().map(|at| aircraft.flow.controls[at].column(lattice.len()));
    let both: Vec<f64> = elevator[0].iter().zip(&elevator[1]).map(|(right, left)| right + left).collect();
    let (f, a, e) = (sums(&fixed), sums(&incidence::angle_of_attack(lattice)), sums(&both));
    let b = [4.0 * 20.0 * GRAVITY_M_S2 - f[0], -f[1]];
    let determinant = a[0] * e[1] - e[0] * a[1];
    assert_near("alpha", trimmed.alpha_rad, (b[0] * e[1] - e[0] * b[1]) / determinant, 1e-9);
    assert_near("elevator", trimmed.elevator_rad, (a[0] * b[1] - b[0] * a[1]) / determinant, 1e-9);
    assert_eq!(trimmed.tip_deflection_m, [0.0; 2]);
}

#[test]
fn an_aircraft_without_elevator_is_reported_as_not_trimmable() {
    let mut aircraft = rigid();
    aircraft.file.htp.control.name = "nothing".to_owned();
    let error = aircraft.uncorrected().trim("pull_up", &aircraft.file.pull_up).unwrap_err();
    let AircraftError::NotTrimmable { point, v_m_s, .. } = &error else { panic!("{error}") };
    assert_eq!((point.as_str(), *v_m_s), ("pull_up", 37.0));
    assert!(error.to_string().contains("elevator"), "{error}");
}

#[test]
fn only_the_second_published_point_has_a_pitch_rate_that_contradicts_its_load_factor() {
    let file = AircraftFile::read(&path()).unwrap();
    assert_eq!(file.pull_up.warning("pull_up"), None);
    assert_eq!(file.trim.warning("trim"), None);
    let warning = file.push_down.warning("push_down").unwrap();
    assert!(warning.contains("-40.13"), "{warning}");
    let level = FlightPoint { v_m_s: 30.0, load_factor: 1.0, pitch_rate_deg_s: 5.0 };
    assert!(level.warning("level").is_some());
}

/// The shipped aircraft with a structure that neither bends nor sags.
fn rigid() -> Aircraft {
    let mut aircraft =
        Aircraft::read(&path(), Some(&crate::common::beam_wing())).expect("shipped files are right");
    let held = aircraft.flow.supported.as_mut().expect("it has a structure");
    held.flexibility = Mat::zeros(held.flexibility.nrows(), held.flexibility.ncols());
    held.sag = Mat::zeros(held.sag.nrows(), 3);
    aircraft
}

/// Corrections that differ from box to box.
fn uneven(count: usize) -> Corrections {
    let wave = |k: f64| (0..count).map(|i| 1.0 + 0.1 * (k * i as f64).sin()).collect::<Vec<f64>>();
    let pressure_offset = wave(0.3).iter().map(|value| value - 1.0).collect();
    Corrections { force: wave(0.7), moment: wave(1.3), pressure_offset }
}
