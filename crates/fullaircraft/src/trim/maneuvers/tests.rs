//! Steady maneuvers as trims: what is given, free and asked for, by the closed forms of the module.

use super::Steady;
use crate::aircraft::file::Surfaces;
use crate::aircraft::small;
use crate::trim::case::TrimCase;
use std::collections::BTreeMap;

const G: f64 = 9.806_65;

/// Its trim at 25 m/s, with the tail in the flow or with wings only.
fn case(steady: &Steady, surfaces: Surfaces) -> TrimCase {
    let (mut file, _) = small::files();
    file.surfaces = surfaces;
    steady.case(&file, 25.0)
}

fn given(case: &TrimCase, name: &str) -> f64 {
    let found: Vec<f64> =
        case.given.iter().filter(|(known, _)| known == name).map(|(_, value)| *value).collect();
    assert_eq!(found.len(), 1, "{name} of {case:?}");
    found[0]
}

fn targets(case: &TrimCase) -> Vec<(&str, f64)> {
    case.targets.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

const PITCH: &str = "pitch_acceleration_deg_s2";
const ROLL: &str = "roll_acceleration_deg_s2";
const YAW: &str = "yaw_acceleration_deg_s2";

fn maneuvers() -> [Steady; 3] {
    let control = "outer".to_owned();
    [
        Steady::Roll { load_factor: 0.5, rate_deg_s: 40.0, control: control.clone() },
        Steady::Turn { load_factor: 2.0, left: false, control: control.clone() },
        Steady::Sideslip { load_factor: 1.0, beta_deg: 5.0, control },
    ]
}

#[test]
fn level_flight_and_pull_ups_are_trimmed_by_angle_of_attack_and_elevator() {
    for (steady, kind, n) in [
        (Steady::Level, "level", 1.0),
        (Steady::Pull { load_factor: 3.0 }, "pull_up", 3.0),
        (Steady::Pull { load_factor: 1.0 }, "pull_up", 1.0),
        (Steady::Pull { load_factor: -1.0 }, "push_down", -1.0),
    ] {
        let case = case(&steady, Surfaces::All);
        assert_eq!((steady.kind(), steady.load_factor(), case.name.as_str()), (kind, n, kind));
        assert_eq!((case.v_m_s, case.held.len()), (25.0, 0));
        assert_eq!(case.free, ["alpha_deg", "elevator_deg"]);
        assert_eq!(targets(&case), [("n_z", n), (PITCH, 0.0)]);
        if kind == "level" {
            assert!(case.given.is_empty());
        } else {
            let law = ((n - 1.0) * G / 25.0).to_degrees();
            assert!((given(&case, "pitch_rate_deg_s") - law).abs() < 1e-12);
        }
    }
}

#[test]
fn rolls_turns_and_sideslips_free_aileron_rudder_and_slip_for_side_force_and_moments() {
    let [roll, turn, slip] = maneuvers();
    let all = ["alpha_deg", "elevator_deg", "outer_deg", "rudder_deg", "beta_deg"];
    let asked = |n: f64| vec![("n_z", n), (PITCH, 0.0), ("n_y", 0.0), (ROLL, 0.0), (YAW, 0.0)];
    let rolled = case(&roll, Surfaces::All);
    assert_eq!((&*rolled.name, &rolled.free[..]), ("roll", &all.map(str::to_owned)[..]));
    assert_eq!((targets(&rolled), given(&rolled, "roll_rate_deg_s")), (asked(0.5), 40.0));
    let turned = case(&turn, Surfaces::All);
    assert_eq!((&*turned.name, &turned.free[..]), ("turn_right", &all.map(str::to_owned)[..]));
    assert_eq!(targets(&turned), asked(2.0));
    // bank 60 deg at n = 2: turn rate g tan(60)/V about the vertical, its parts along pitch and yaw axes
    let bank = 60.0_f64.to_radians();
    let turn_rate = (G * bank.tan() / 25.0).to_degrees();
    assert!((given(&turned, "pitch_rate_deg_s") - turn_rate * bank.sin()).abs() < 1e-9);
    assert!((given(&turned, "yaw_rate_deg_s") - turn_rate * bank.cos()).abs() < 1e-9);
    let left = Steady::Turn { load_factor: 2.0, left: true, control: "outer".to_owned() };
    let turned = case(&left, Surfaces::All);
    assert_eq!(turned.name, "turn_left");
    assert!((given(&turned, "yaw_rate_deg_s") + turn_rate * bank.cos()).abs() < 1e-9);
    let slipped = case(&slip, Surfaces::All);
    assert_eq!(
        (&*slipped.name, &slipped.free[..]),
        ("sideslip", &all[..4].iter().map(|s| (*s).to_owned()).collect::<Vec<_>>()[..])
    );
    assert_eq!(targets(&slipped), [("n_z", 1.0), (PITCH, 0.0), (ROLL, 0.0), (YAW, 0.0)]);
    assert_eq!(given(&slipped, "beta_deg"), 5.0);
}

#[test]
fn wings_alone_balance_lift_and_roll_and_are_held_in_all_else() {
    let [roll, turn, slip] = maneuvers();
    for steady in [Steady::Level, Steady::Pull { load_factor: 3.0 }, roll, turn, slip] {
        let (is_symmetric, n) = (matches!(steady, Steady::Level | Steady::Pull { .. }), steady.load_factor());
        let case = case(&steady, Surfaces::WingsOnly);
        if is_symmetric {
            assert_eq!((&case.free[..], targets(&case)), (&["alpha_deg".to_owned()][..], vec![("n_z", n)]));
            assert_eq!(case.held, ["n_x", "n_y", ROLL, PITCH, YAW]);
        } else {
            assert_eq!(case.free, ["alpha_deg", "outer_deg"], "{steady:?}");
            assert_eq!(targets(&case), [("n_z", n), (ROLL, 0.0)], "{steady:?}");
            assert_eq!(case.held, ["n_x", "n_y", PITCH, YAW]);
        }
    }
}

#[test]
fn any_trim_is_taken_as_it_is_given() {
    let map = |name: &str, value: f64| BTreeMap::from([(name.to_owned(), value)]);
    let of = |target: &str| Steady::Trim {
        name: "own".to_owned(),
        given: map("beta_deg", 2.0),
        free: vec!["alpha_deg".to_owned()],
        targets: map(target, 1.5),
    };
    let case = case(&of("n_z"), Surfaces::All);
    assert_eq!((case.name.as_str(), given(&case, "beta_deg")), ("own", 2.0));
    assert_eq!((&case.free[..], targets(&case)), (&["alpha_deg".to_owned()][..], vec![("n_z", 1.5)]));
    assert_eq!((of("n_z").kind(), of("n_z").load_factor(), of("n_y").load_factor()), ("own", 1.5, 1.0));
}
