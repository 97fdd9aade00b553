//! The V-n diagram beside `rules.json`, and the case matrix.

use crate::close::close;
use crate::common::{number, reference};
use crate::plan::{design, mass};
use loads::design::{Attitude, Direction, Gradients, Gust, GustSpeeds, Rules, Spectrum, Speed};
use loads::matrix::{Action, Status};
use loads::{Airframe, Condition, Design, Diagram, matrix};

/// The airframe of the plan.
const AIRFRAME: Airframe = Airframe { area_m2: 0.81, mean_chord_m: 0.225, lift_slope_per_rad: 5.2 };

#[test]
fn corners_gust_lines_and_where_they_meet_the_stall_line_are_those_of_the_reference() {
    let all = reference("rules.json");
    let result = &all["vn"]["UAV 20 kg (TU-Flex-like, data assumed)"]["result"];
    let diagram = Diagram::of(&design(), &AIRFRAME, 20.0, 0.0).unwrap();
    let stall = diagram.stall.unwrap();
    close(stall.upright_m_s, &result["V_S1"], 1e-9, "stall");
    close(stall.inverted_m_s, &result["V_S_negative"], 1e-9, "inverted stall");
    close(diagram.v_a_m_s.unwrap(), &result["V_A"], 1e-9, "VA");
    close(diagram.v_g_m_s.unwrap(), &result["V_G"], 1e-9, "VG");
    // The reference has no corner at VC with n1, which lies on the line from A to D.
    let ours = diagram.corners.iter().filter(|corner| corner.name != "C");
    for (corner, row) in ours.zip(result["maneuver_corners"].as_array().unwrap()) {
        close(corner.v_eas_m_s, &row[0], 1e-9, corner.name);
        assert_eq!(corner.n, number(&row[1]), "{}", corner.name);
        assert_eq!(corner.left_out, None, "{}", corner.name);
    }
    for (point, name) in diagram.gusts.iter().zip(["VC", "VD"]) {
        close(1.0 + point.pratt.delta_n, &result["gust_at"][name][0], 1e-9, name);
        close(1.0 - point.pratt.delta_n, &result["gust_at"][name][1], 1e-9, name);
    }
    let (v, n) = diagram.gusts[0].stall_meets.unwrap();
    close(v, &result["stall_meets_VC_gust_line"][0], 1e-9, "where the stall line meets the gust line");
    close(n, &result["stall_meets_VC_gust_line"][1], 1e-9, "where the stall line meets the gust line");
}

#[test]
fn a_gust_beyond_the_stall_line_is_flown_at_it_and_says_so() {
    let plan = design();
    let all = matrix(&plan, &AIRFRAME, &[]).unwrap();
    let gusts: Vec<_> = all.cases.iter().filter(|case| case.kind == "pratt").collect();
    // At VC 37 m/s Pratt asks 6.66, and (37/17.44)^2 = 4.50.
    assert!((gusts[0].n_z - 4.50).abs() < 0.005, "{}", gusts[0].n_z);
    assert!(gusts[0].why.contains("6.66") && gusts[0].why.contains("4.50"), "{}", gusts[0].why);
    assert!((gusts[1].n_z + (37.0f64 / 20.958_419_310_531_998).powi(2)).abs() < 1e-9);
    assert!(gusts[2].why.is_empty(), "the gust at VD is inside: {}", gusts[2].why);
}

fn two_by_two() -> Design {
    Design {
        masses: vec![mass("full", 20.0), mass("light", 15.0)],
        altitudes_m: vec![0.0, 1500.0],
        gusts: Vec::new(),
        ..design()
    }
}

#[test]
fn two_masses_two_altitudes_and_six_corners_are_twenty_four_numbered_lines_with_a_status() {
    let plan = two_by_two();
    let all = matrix(&plan, &AIRFRAME, &[]).unwrap();
    let csv = all.csv(&plan);
    assert_eq!(csv.lines().count(), 1 + 24);
    for (row, line) in csv.lines().skip(1).enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells[0], (row + 1).to_string(), "numbers go on: {line}");
        assert!(["planned", "left_out"].contains(&cells[10]), "{line}");
    }
    assert_eq!(csv, matrix(&plan, &AIRFRAME, &[]).unwrap().csv(&plan), "the same plan twice");
}

#[test]
fn every_corner_is_a_case_and_none_outside_the_stall_line_is_flown() {
    // So heavy that n1 is only reached beyond VC.
    let plan = Design { masses: vec![mass("full", 20.0), mass("heavy", 26.0)], ..two_by_two() };
    let all = matrix(&plan, &AIRFRAME, &[]).unwrap();
    for (place, diagram) in &all.diagrams {
        let cases = all.cases.iter().filter(|case| case.mass == *place && case.h_m == diagram.h_m);
        let cases: Vec<_> = cases.collect();
        for corner in &diagram.corners {
            let is_it = |case: &&&loads::Case| {
                case.v_eas_m_s == corner.v_eas_m_s && case.n_z == corner.n && case.kind == "corner"
            };
            assert!(cases.iter().any(|case| is_it(&case)), "{corner:?}");
        }
        let stall = diagram.stall.unwrap();
        for case in cases.iter().filter(|case| case.status == Status::Planned) {
            let (smallest, largest) = stall.factors(case.v_eas_m_s);
            let inside = case.n_z <= largest * (1.0 + 1e-9) && case.n_z >= smallest * (1.0 + 1e-9);
            assert!(inside, "{} is flown at n {}", case.condition, case.n_z);
        }
    }
    let left_out = all.cases.iter().find(|case| case.mass == 1 && case.condition == "corner C").unwrap();
    assert_eq!(left_out.status, Status::LeftOut);
    assert!(left_out.why.contains("above the stall line"), "{}", left_out.why);
}

#[test]
fn conditions_of_the_caller_outside_the_envelope_stay_in_the_list_with_the_reason() {
    let condition =
        |v_eas_m_s, n_z| Condition { kind: "roll".into(), words: "roll, outer".into(), v_eas_m_s, n_z };
    let conditions = [condition(30.0, 1.0), condition(25.0, 3.8), condition(40.0, 4.5), condition(50.0, 1.0)];
    let plan = design();
    let all = matrix(&plan, &AIRFRAME, &conditions).unwrap();
    let rolls: Vec<_> = all.cases.iter().filter(|case| case.kind == "roll").collect();
    assert_eq!(rolls[0].status, Status::Planned);
    for (case, words) in rolls[1..].iter().zip(["above the stall line", "outside -1.00 to 3.80", "above VD"])
    {
        assert_eq!(case.status, Status::LeftOut);
        assert!(case.why.contains(words), "{}", case.why);
    }
    assert!(all.csv(&plan).contains("\"roll, outer\""), "a comma in a cell is quoted");
}

#[test]
fn discrete_gusts_and_turbulence_are_cases_with_their_velocities_in_true_airspeed() {
    let plan = Design {
        rules: Rules::Cs25,
        altitudes_m: vec![3048.0],
        gusts: vec![
            Gust::Discrete {
                at: vec![Speed::VC],
                gradients_m: Gradients::Default,
                directions: vec![Direction::Up, Direction::Down],
                refine: false,
            },
            Gust::Turbulence {
                at: vec![Speed::VD],
                scale_m: 762.0,
                cut_off_hz: 30.0,
                spectrum: Spectrum::Karman,
                directions: vec![Direction::Up],
                attitude: Attitude::Stable,
            },
        ],
        gust_speeds: GustSpeeds { f_g: Some(1.0), ..GustSpeeds::default() },
        ..design()
    };
    let all = matrix(&plan, &AIRFRAME, &[]).unwrap();
    let gusts: Vec<_> = all.cases.iter().filter(|case| case.kind == "discrete").collect();
    assert_eq!(gusts.len(), 20, "ten gradients, two directions");
    let Action::Discrete { gradient_m, u_ds_m_s, .. } = gusts[9].action else { panic!("{:?}", gusts[9]) };
    assert!((gradient_m - 107.0).abs() < 1e-9);
    // U_ref 14.63 m/s EAS at 3048 m, density 0.9046369.
    assert!((u_ds_m_s - 14.63 * (1.225f64 / 0.904_636_906_558_544_8).sqrt()).abs() < 1e-6, "{u_ds_m_s}");
    let Action::Discrete { gradient_m, .. } = gusts[0].action else { panic!("{:?}", gusts[0]) };
    assert!((gradient_m - 12.5 * 0.225).abs() < 1e-12, "12.5 chords of a small aircraft: {gradient_m}");
    let turbulence = all.cases.last().unwrap();
    let Action::Turbulence { u_sigma_m_s, longest_gradient_m, .. } = turbulence.action else {
        panic!("{turbulence:?}")
    };
    assert!((longest_gradient_m - 107.0).abs() < 1e-12, "as long as the plan's gusts: {longest_gradient_m}");
    assert!((u_sigma_m_s - 26.034_128_503_075_87 / 2.0).abs() < 1e-9, "half at VD: {u_sigma_m_s}");
}

#[test]
fn turbulence_lasts_as_long_as_the_longest_gust_of_the_plan_and_its_words_say_who_holds_the_attitude() {
    let turbulence = |attitude| Gust::Turbulence {
        at: vec![Speed::VC],
        scale_m: 762.0,
        cut_off_hz: 30.0,
        spectrum: Spectrum::Karman,
        directions: vec![Direction::Up],
        attitude,
    };
    let gusts = |own: &[f64]| Gust::Discrete {
        at: vec![Speed::VC],
        gradients_m: Gradients::Of(own.to_vec()),
        directions: vec![Direction::Up],
        refine: false,
    };
    let of = |before: &[Gust], attitude| {
        let gusts = before.iter().cloned().chain([turbulence(attitude)]).collect();
        let gust_speeds = GustSpeeds { f_g: Some(1.0), ..GustSpeeds::default() };
        let plan = Design { rules: Rules::Cs25, gusts, gust_speeds, ..design() };
        let case = matrix(&plan, &AIRFRAME, &[]).unwrap().cases.pop().expect("turbulence is last");
        let Action::Turbulence { longest_gradient_m, attitude, .. } = case.action else { panic!("{case:?}") };
        (longest_gradient_m, attitude, case.condition)
    };
    assert_eq!(of(&[], Attitude::Stable).0, 107.0, "a plan without gusts: the longest of CS 25.341(a)");
    assert_eq!(of(&[gusts(&[20.0, 40.0, 30.0]), gusts(&[5.0])], Attitude::Stable).0, 40.0, "the plan's own");
    let [(_, stable, free), (_, held, kept)] = [Attitude::Stable, Attitude::Held].map(|who| of(&[], who));
    assert_eq!((stable, held), (Attitude::Stable, Attitude::Held));
    assert_eq!(kept, format!("{free} with airspeed and attitude held"));
}
