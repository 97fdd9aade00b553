//! Trims of the whole aircraft with any free variables and motions: laws of balance, symmetry and mirroring, closed forms of
//! turn and roll, and refusals in words.

use crate::common::{assert_near, whole, wings};
use coupling::GRAVITY_M_S2;
use coupling::wing_file::StationAt;
use fullaircraft::{AircraftError, Steady, TrimCase, TrimTools};

const OUTER: &str = "outer";

fn strings(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| (*name).to_owned()).collect()
}

fn pairs(values: &[(&str, f64)]) -> Vec<(String, f64)> {
    values.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
}

fn maneuvers(left: f64) -> Vec<Steady> {
    let control = OUTER.to_owned();
    vec![
        Steady::Roll { load_factor: 1.0, rate_deg_s: 40.0 * left, control: control.clone() },
        Steady::Turn { load_factor: 2.0, left: left < 0.0, control: control.clone() },
        Steady::Sideslip { load_factor: 1.0, beta_deg: 5.0 * left, control },
    ]
}

#[test]
fn air_loads_and_thrust_balance_mass_times_what_an_accelerometer_feels() {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let mut all = maneuvers(1.0);
    all.extend([Steady::Level, Steady::Pull { load_factor: 3.0 }, Steady::Pull { load_factor: -1.0 }]);
    for steady in all {
        let found = at.solve(&steady.case(&aircraft.file, 30.0)).unwrap();
        let air = at.air_loads(&found);
        let weight_n = 20.0 * GRAVITY_M_S2;
        assert_near(steady.kind(), air[2], steady.load_factor() * weight_n, 1e-9);
        let side_n = at.value(&found, "n_y").unwrap() * weight_n;
        assert!((air[1] - side_n).abs() < 1e-9 * weight_n, "{}: {} {side_n}", steady.kind(), air[1]);
        for moment in &air[3..] {
            assert!(moment.abs() < 1e-8, "{}: {air:?}", steady.kind());
        }
    }
}

#[test]
fn a_maneuver_to_the_left_is_the_image_of_the_one_to_the_right() {
    let aircraft = whole();
    let point = StationAt { name: "half".to_owned(), x_m: Some(0.3), y_m: 0.9, z_m: None };
    let tools = TrimTools::new(aircraft, &[point]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    for (right, left) in maneuvers(1.0).iter().zip(maneuvers(-1.0)) {
        let [right, left] =
            [right, &left].map(|steady| at.solve(&steady.case(&aircraft.file, 30.0)).unwrap());
        for name in ["alpha_deg", "elevator_deg"] {
            assert_near(name, at.value(&left, name).unwrap(), at.value(&right, name).unwrap(), 1e-8);
        }
        for name in ["outer_deg", "rudder_deg", "beta_deg"] {
            assert_near(name, at.value(&left, name).unwrap(), -at.value(&right, name).unwrap(), 1e-8);
        }
        let (one, other) = (at.station_loads(&right), at.station_loads(&left));
        for side in [0, 2] {
            for (row, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
                assert_near("load", sign * other[side + 1][row], one[side][row], 1e-7);
            }
        }
    }
}

#[test]
fn signs_are_those_of_flight_mechanics() {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let [roll, turn, slip] = <[Steady; 3]>::try_from(maneuvers(1.0)).unwrap();
    let solve = |steady: &Steady| at.solve(&steady.case(&aircraft.file, 30.0)).unwrap();
    // right wing down needs the right aileron's trailing edge up
    assert!(at.value(&solve(&roll), "outer_deg").unwrap() < 0.0);
    // a turn to the right: nose right, and more lift than level flight
    let turning = solve(&turn);
    assert!(at.value(&turning, "yaw_rate_deg_s").unwrap() > 0.0);
    assert!(
        at.value(&turning, "alpha_deg").unwrap() > at.value(&solve(&Steady::Level), "alpha_deg").unwrap()
    );
    // wind from the right pushes the fin to the left
    assert!(at.value(&solve(&slip), "n_y").unwrap() < 0.0);
    // and the rudder holds the nose out of the wind: trailing edge to the right turns the nose right, so it is to the left
    assert!(at.value(&solve(&slip), "rudder_deg").unwrap() < 0.0);
}

#[test]
fn rates_of_a_level_turn_are_those_of_its_bank() {
    // n = 2: bank 60 deg, turn rate g tan(60)/V; its parts about the aircraft's axes.
    let case =
        Steady::Turn { load_factor: 2.0, left: false, control: OUTER.to_owned() }.case(&whole().file, 30.0);
    let turn_deg_s = (GRAVITY_M_S2 * 60.0_f64.to_radians().tan() / 30.0).to_degrees();
    let rate = |name: &str| case.given.iter().find(|(known, _)| known == name).unwrap().1;
    assert_near("pitch", rate("pitch_rate_deg_s"), turn_deg_s * 60.0_f64.to_radians().sin(), 1e-12);
    assert_near("yaw", rate("yaw_rate_deg_s"), turn_deg_s * 60.0_f64.to_radians().cos(), 1e-12);
}

#[test]
fn a_roll_left_to_itself_goes_as_fast_as_the_one_trimmed_with_that_aileron() {
    // Two questions with one answer: the aileron for a rate, and the rate of an aileron.
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let roll = maneuvers(1.0).swap_remove(0);
    let found = at.solve(&roll.case(&aircraft.file, 30.0)).unwrap();
    let mut other = roll.case(&aircraft.file, 30.0);
    other.given = vec![("outer_deg".to_owned(), at.value(&found, "outer_deg").unwrap())];
    other.free.retain(|name| name != "outer_deg");
    other.free.push("roll_rate_deg_s".to_owned());
    let again = at.solve(&other).unwrap();
    assert_near("rate", at.value(&again, "roll_rate_deg_s").unwrap(), 40.0, 1e-9);
}

#[test]
fn a_motion_not_asked_for_comes_out_and_asked_for_gives_the_variable_back() {
    // An elevator of -5 degrees beyond nothing: some pitching acceleration; that acceleration asked for: the elevator.
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let mut case = TrimCase {
        name: "kick".to_owned(),
        v_m_s: 30.0,
        given: pairs(&[("elevator_deg", -5.0)]),
        free: strings(&["alpha_deg"]),
        targets: pairs(&[("n_z", 1.0)]),
        held: Vec::new(),
    };
    let found = at.solve(&case).unwrap();
    let acceleration = at.value(&found, "pitch_acceleration_deg_s2").unwrap();
    case.given.clear();
    case.free.push("elevator_deg".to_owned());
    case.targets.push(("pitch_acceleration_deg_s2".to_owned(), acceleration));
    let again = at.solve(&case).unwrap();
    assert_near("elevator", at.value(&again, "elevator_deg").unwrap(), -5.0, 1e-9);
    // moment equals inertia times acceleration: 2.6 kg m2 about the centre of gravity
    let moment_nm = at.air_loads(&found)[4];
    assert_near("moment", moment_nm, 2.6 * acceleration.to_radians(), 1e-6);
}

#[test]
fn thrust_pushes_by_its_weight_s_share_and_pitches_by_its_arm() {
    let mut file = whole().file.clone();
    file.thrust_line =
        Some(fullaircraft::aircraft::file::ThrustLine { point_m: (0.4, 0.0, -0.1), up_deg: 0.0 });
    let wing = coupling::WingFile::read(&crate::common::beam_wing()).unwrap();
    let aircraft = fullaircraft::Aircraft::new(file, wing).unwrap();
    let tools = TrimTools::new(&aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let mut case = Steady::Level.case(&aircraft.file, 30.0);
    case.free.push("thrust_N".to_owned());
    case.targets.push(("n_x".to_owned(), 0.1));
    let found = at.solve(&case).unwrap();
    let thrust_n = 0.1 * 20.0 * GRAVITY_M_S2;
    // the air has no part along x (flat boxes), so thrust is mass times n_x g, and its arm of 0.1 m is the air's to balance
    assert_near("thrust", at.value(&found, "thrust_N").unwrap(), thrust_n, 1e-6);
    assert_near("nose-up moment of the air", at.air_loads(&found)[4], -0.1 * thrust_n, 1e-6);
}

#[test]
fn stations_add_up_and_the_tip_carries_less_than_the_root() {
    let aircraft = wings();
    let point = |name: &str, y_m| StationAt { name: name.to_owned(), x_m: Some(0.2), y_m, z_m: None };
    let tools = TrimTools::new(aircraft, &[point("a", 0.45), point("b", 1.35)]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let found = at.solve(&Steady::Pull { load_factor: 4.0 }.case(&aircraft.file, 30.0)).unwrap();
    let loads = at.station_loads(&found);
    let names: Vec<&str> = tools.stations.iter().map(|station| station.name.as_str()).collect();
    assert_eq!(names, ["right root", "left root", "right a", "left a", "right b", "left b"]);
    assert!(loads[0][0] > loads[2][0] && loads[2][0] > loads[4][0] && loads[4][0] > 0.0, "{loads:?}");
    assert!(loads[0][1] > loads[2][1] && loads[2][1] > loads[4][1] && loads[4][1] > 0.0, "{loads:?}");
    assert!(TrimTools::new(aircraft, &[point("beyond", 1.9)]).is_err());
}

#[test]
fn a_trim_that_does_not_exist_says_what_limits_it() {
    let aircraft = whole();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, 30.0).unwrap();
    let refused = |free: &[&str], targets: &[(&str, f64)]| {
        let case = TrimCase {
            name: "asked".to_owned(),
            v_m_s: 30.0,
            free: strings(free),
            targets: pairs(targets),
            ..TrimCase::default()
        };
        at.solve(&case).unwrap_err().to_string()
    };
    let lift = ("n_z", 1.0);
    let text = refused(&["alpha_deg", "rudder_deg"], &[lift, ("pitch_acceleration_deg_s2", 0.0)]);
    assert!(text.contains("rudder_deg has no effect"), "{text}");
    let text = refused(&["alpha_deg", "elevator_deg"], &[lift, ("yaw_acceleration_deg_s2", 0.0)]);
    assert!(text.contains("yawing moment"), "{text}");
    let text = refused(&["alpha_deg"], &[lift, ("pitch_acceleration_deg_s2", 0.0)]);
    assert!(text.contains("1 variables are free (alpha_deg) for 2 motions"), "{text}");
    let text = refused(&["alpha_deg", "flaps_deg"], &[lift, ("n_x", 0.0)]);
    assert!(text.contains("flaps_deg is no variable"), "{text}");
    // beyond divergence: a wing swept back has none, one that gives way against its loads has
    let wing = coupling::WingFile::read(&crate::common::beam_wing()).unwrap();
    let mut soft = fullaircraft::Aircraft::new(aircraft.file.clone(), wing).unwrap();
    let held = soft.flow.supported.as_mut().unwrap();
    held.flexibility = &held.flexibility * faer::Scale(-1.0);
    let tools = TrimTools::new(&soft, &[]).unwrap();
    let error = tools.at(&soft.uncorrected(), 400.0).unwrap_err();
    assert!(matches!(error, AircraftError::Coupling(_)) && error.to_string().contains("diverge"), "{error}");
}
