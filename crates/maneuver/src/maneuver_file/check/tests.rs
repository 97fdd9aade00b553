//! Bounds of a maneuver's numbers, of its length and of the surfaces' limits.

use super::*;
use crate::motion::{Doublet, OneMinusCosine, Step};
use coupling::wing_file::Source;
use std::path::Path;

fn maneuver(motions: Vec<MotionSpec>) -> ManeuverFile {
    ManeuverFile {
        v_m_s: 30.0,
        rho_kg_m3: 1.225,
        alpha_deg: Some(1.0),
        sample_rate_hz: 200.0,
        length_s: 2.0,
        actuator: ActuatorChoice::Assumed,
        motions,
        path: "nowhere.ron".into(),
    }
}

#[test]
fn numbers_are_taken_up_to_their_bounds() {
    let holds = |change: &dyn Fn(&mut ManeuverFile)| {
        let mut file = maneuver(Vec::new());
        change(&mut file);
        numbers(&file).is_ok()
    };
    for (v, expected) in [(0.0, true), (340.0, true), (-1e-3, false), (340.1, false), (f64::NAN, false)] {
        assert_eq!(holds(&|file| file.v_m_s = v), expected, "{v} m/s");
    }
    for (rho, expected) in [(1e-3, true), (99.9, true), (0.0, false), (100.0, false), (-1.0, false)] {
        assert_eq!(holds(&|file| file.rho_kg_m3 = rho), expected, "{rho} kg/m3");
    }
    for (alpha, expected) in [(Some(90.0), true), (Some(-90.0), true), (None, true), (Some(90.1), false)] {
        assert_eq!(holds(&|file| file.alpha_deg = alpha), expected, "{alpha:?}");
    }
    // 2 to a million steps
    for (length_s, rate, expected) in [
        (0.01, 200.0, true),
        (0.0095, 200.0, false),
        (5000.0, 200.0, true),
        (5000.1, 200.0, false),
        (1.0, 1e5, true),
        (1.0, 1.1e5, false),
        (-1.0, 200.0, false),
        (4.0, 0.25, false),
    ] {
        let change = |file: &mut ManeuverFile| (file.length_s, file.sample_rate_hz) = (length_s, rate);
        assert_eq!(holds(&change), expected, "{length_s} s at {rate} Hz");
    }
    for (frequency_hz, damping_ratio, expected) in [
        (8.0, 0.7, true),
        (1e4, 10.0, true),
        (0.0, 0.7, false),
        (-8.0, 0.7, false),
        (8.0, 0.0, false),
        (8.0, -0.7, false),
        (1.001e4, 0.7, false),
        (8.0, 10.1, false),
    ] {
        let actuator = ActuatorChoice::SecondOrder { frequency_hz, damping_ratio };
        assert_eq!(holds(&|file| file.actuator = actuator), expected, "{frequency_hz} Hz, {damping_ratio}");
    }
    let late = || MotionSpec::new("inner", Step { height: 0.1, start_s: -0.1 });
    assert!(!holds(&|file| file.motions.push(late())));
}

fn wing() -> (WingFile, Vec<String>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let mut file = WingFile::read(&path).expect("the shipped wing");
    let Source::Parametric(planform) = &mut file.source else { panic!("the shipped wing is parametric") };
    planform.controls[0].limit_deg = Some(10.0);
    let names = planform.controls.iter().map(|control| control.name.clone()).collect();
    (file, names)
}

fn said(file: &ManeuverFile) -> Result<Vec<String>, String> {
    let (wing, names) = wing();
    file.checked(&wing, &names).map_err(|error| error.message)
}

#[test]
fn a_deflection_may_reach_its_limit() {
    let (_, names) = wing();
    let of = |name: &str, degrees: f64| {
        let smooth = OneMinusCosine::new(degrees.to_radians(), 1.0, 0.0);
        said(&maneuver(vec![MotionSpec::new(name, smooth)]))
    };
    // the first has its own limit, the second the assumed one; the height is reached at half a second
    for (place, degrees, holds) in [
        (0, 10.0, true),
        (0, -10.0, true),
        (0, 10.5, false),
        (0, -10.5, false),
        (1, 30.0, true),
        (1, 30.5, false),
    ] {
        assert_eq!(of(&names[place], degrees).is_ok(), holds, "{} {degrees}", names[place]);
    }
    assert!(
        of(&names[0], 10.5).expect_err("too far").contains("10.50 degrees, beyond 10 degrees (its limit")
    );
    assert!(of(&names[1], 31.0).expect_err("too far").contains("(assumed"));
    assert_eq!(of(ANGLE, 45.0), Ok(Vec::new()), "angles of attack have no such limit");
    assert!(of("nobody", 1.0).expect_err("unknown").contains("moves \"nobody\""));
}

#[test]
fn jumps_are_refused_where_nothing_rounds_them() {
    let (_, names) = wing();
    let with = |of: &str, jumps: bool, actuator: ActuatorChoice| {
        let spec = if jumps {
            MotionSpec::new(of, Step { height: 0.1, start_s: 0.5 })
        } else {
            MotionSpec::new(of, OneMinusCosine::new(0.1, 1.0, 0.0))
        };
        said(&ManeuverFile { actuator, ..maneuver(vec![spec]) })
    };
    let own = ActuatorChoice::SecondOrder { frequency_hz: 8.0, damping_ratio: 0.7 };
    assert!(with(&names[0], true, ActuatorChoice::None).expect_err("a jump").contains("no actuator"));
    for (jumps, actuator) in [(true, ActuatorChoice::Assumed), (true, own), (false, ActuatorChoice::None)] {
        assert_eq!(with(&names[0], jumps, actuator), Ok(Vec::new()));
    }
    let remarks = with(ANGLE, true, ActuatorChoice::None).expect("an angle is rounded");
    assert!(remarks.len() == 1 && remarks[0].contains("jumps"), "{remarks:?}");
    assert_eq!(with(ANGLE, false, ActuatorChoice::Assumed), Ok(Vec::new()));
}

#[test]
fn what_outlasts_the_maneuver_and_what_ends_half_a_sample_early_is_remarked_upon() {
    let (_, names) = wing();
    let doublet = |start_s: f64| {
        let shape = Doublet { height: 0.1, frequency_hz: 1.0, start_s };
        said(&maneuver(vec![MotionSpec::new(&names[0], shape)])).expect("a maneuver")
    };
    assert!(doublet(1.0).is_empty() && doublet(0.5).is_empty());
    let late = doublet(1.5);
    assert!(late.len() == 1 && late[0].contains("ends at 2.5 s"), "{late:?}");
    assert_eq!(doublet(1.001).len(), 1);
    let folder = std::env::temp_dir().join(format!("wingroot-check-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    for (last, count) in [("1.998", 0), ("2.0", 0), ("2.5", 0), ("1.997", 1), ("1.2", 1)] {
        std::fs::write(folder.join("own.csv"), format!("t_s,delta_{}_deg\n0,1\n{last},3\n", names[0]))
            .expect("a file");
        let shape = serde_json::from_value(serde_json::json!({ "FromFile": { "file": "own.csv" } }));
        let mut spec: MotionSpec = shape.expect("a motion");
        spec.complete(0.0, &folder.join("maneuver.ron")).expect("its columns");
        let remarks = said(&maneuver(vec![spec])).expect("a maneuver");
        assert_eq!(remarks.len(), count, "{last} s: {remarks:?}");
    }
    let _ = std::fs::remove_dir_all(&folder);
}
