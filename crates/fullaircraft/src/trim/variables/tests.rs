//! Variables of trims on a small aircraft: thrust along its line, controls in their shares, rates about the centre of
//! gravity.

use super::{Acts, TrimVariables, incidence_of_control, motion, thrust};
use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::ThrustLine;
use crate::aircraft::small;
use nalgebra::{Point3, Vector3};
use std::sync::OnceLock;

fn along(line: Option<ThrustLine>) -> [f64; 6] {
    static OTHER: OnceLock<std::sync::Mutex<Aircraft>> = OnceLock::new();
    let other = OTHER.get_or_init(|| {
        let (file, wing) = small::files();
        std::sync::Mutex::new(Aircraft::new(file, wing).expect("an aircraft"))
    });
    let mut other = other.lock().expect("nobody panics with it");
    other.file.thrust_line = line;
    thrust(&other)
}

#[test]
fn thrust_pulls_ahead_and_up_along_its_line_and_turns_by_its_arm() {
    assert_eq!(along(None), [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    // 0.3 m ahead of the centre of gravity (x = 0.4), 0.2 m to the right, 0.1 m above, 30 deg up
    let found = along(Some(ThrustLine { point_m: (0.1, 0.2, 0.1), up_deg: 30.0 }));
    let (cos, sin) = (0.75_f64.sqrt(), 0.5);
    // Mx = y Fz, My = z Fx - x Fz, Mz = -y Fx
    let law = [-cos, 0.0, sin, 0.2 * sin, -0.1 * cos + 0.3 * sin, 0.2 * cos];
    found.iter().zip(law).for_each(|(ours, law)| assert!((ours - law).abs() < 1e-14, "{found:?} {law}"));
}

#[test]
fn both_halves_of_the_elevator_go_together_and_ailerons_against_one_another() {
    let aircraft = small::aircraft();
    let lattice = &aircraft.flow.lattice;
    let names: Vec<String> = TrimVariables::new(aircraft).all.into_iter().map(|one| one.name).collect();
    let rates = ["roll_rate_deg_s", "pitch_rate_deg_s", "yaw_rate_deg_s"];
    assert_eq!(names[..2], ["alpha_deg", "beta_deg"]);
    assert_eq!((&names[2..5], names[5].as_str()), (&rates.map(str::to_owned)[..], "thrust_N"));
    let mut controls = names[6..].to_vec();
    controls.sort();
    assert_eq!(controls, ["elevator_deg", "inner_deg", "outer_deg", "rudder_deg"]);
    for (name, left) in [("elevator", 1.0), ("inner", -1.0), ("outer", -1.0)] {
        let column = incidence_of_control(aircraft, name).expect("it is there");
        let moved: Vec<usize> = (0..lattice.len()).filter(|j| column[*j] != 0.0).collect();
        assert!(!moved.is_empty());
        for &j in &moved {
            let at = lattice.boxes[j].mid_point();
            let image =
                |k: &usize| (lattice.boxes[*k].mid_point() - Point3::new(at.x, -at.y, at.z)).norm() < 1e-9;
            let other = moved.iter().copied().find(image).expect("an image");
            assert!((column[other] - left * column[j]).abs() < 1e-12, "{name}: box {j} and {other}");
            assert!(at.y < 0.0 || column[j] > 0.0, "trailing edge down on the right");
        }
    }
    assert!(incidence_of_control(aircraft, "flap").is_none());
    assert!(
        TrimVariables::new(aircraft)
            .place("flap_deg")
            .expect_err("none")
            .to_string()
            .contains("flap_deg is no variable")
    );
    assert_eq!((motion("n_z").expect("a motion"), motion("n_x").expect("a motion")), (2, 0));
    assert!(motion("n").is_err());
}

#[test]
fn pressures_of_rates_are_those_of_incidences_by_turning_about_the_centre_of_gravity() {
    let aircraft = small::aircraft();
    let variables = TrimVariables::new(aircraft);
    let lattice = &aircraft.flow.lattice;
    // right wing down, nose up, nose right: rotations about -x, +y and -z; a point that moves by w x r meets air of
    // -w x r
    let axes = [-Vector3::x(), Vector3::y(), -Vector3::z()];
    for (at, axis) in axes.into_iter().enumerate() {
        let incidence = |j: usize| {
            let panel = &lattice.boxes[j];
            let arm = panel.three_quarter_point() - Point3::new(0.4, 0.0, 0.0);
            -axis.cross(&arm).dot(&panel.normal())
        };
        let w = faer::Mat::from_fn(lattice.len(), 1, |j, _| incidence(j));
        let law = aircraft.flow.pressures(w.as_ref());
        assert_eq!(variables.all[2 + at].acts, Acts::Rate(3 + at));
        let largest = (0..lattice.len()).map(|j| law[(j, 0)].abs()).fold(0.0, f64::max);
        for j in 0..lattice.len() {
            let ours = variables.pressures[(j, 3 + at)];
            assert!(
                (ours - law[(j, 0)]).abs() < 1e-9 * largest,
                "rate {at}, box {j}: {ours} {}",
                law[(j, 0)]
            );
        }
    }
}
