//! Effects in a wing's file: what is refused and where; what is written reads back and flies the same, bit for bit.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::copy::{Copy, data};
use crate::common::flown::run;
use aero::{Corrections, Flow};
use coupling::wing_file::{EffectValidity, WingEffect};
use coupling::{ElasticWing, Mount, WingFile};
use maneuver::effects::{Active, Beside, library, library_with, of_wing, without};
use maneuver::{Actuator, Motion, Rig, RigSettings, TimeHistory};

const EMPTY: &str = "effects: [],";

/// The shipped beam wing.
fn text() -> String {
    let text = nastran::read_text(&data("wing_beam.ron")).unwrap();
    assert!(text.contains(EMPTY));
    text
}

fn some(controls: &[String]) -> Vec<Active> {
    let one = |name: &str, values: &[f64]| {
        Active::new(library(controls).into_iter().find(|e| e.spec().name == name).unwrap(), values)
    };
    vec![
        one("joiner_inertia", &[0.3, 0.1 / 3.0, 0.5, 0.0]),
        one("ctl_saturation", &[1.0 / 0.7, 2.0, 0.0, 0.1]),
        one("stall", &[12.0, 0.7]),
    ]
}

fn flown(wing: &ElasticWing, rig: &Rig<'_>, file: &WingFile, effects: &[Active]) -> TimeHistory {
    let flow = Flow { v_m_s: 30.0, rho_kg_m3: 1.225 };
    let corrections = Corrections::neutral(wing.correctable.len());
    let model = rig.at(flow, &corrections).unwrap();
    let inputs = run(wing.controls.len()).inputs;
    let motion = Motion { time_step_s: 0.01, alpha: inputs.alpha, controls_rad: inputs.controls_rad };
    let mut history = model.fly(&motion);
    let bulk = file.bulk(Mount::Tunnel).unwrap();
    if let Some(beside) = Beside::new(rig, flow, &corrections, effects, &bulk).unwrap() {
        beside.add(&motion, &mut history);
    }
    history
}

#[test]
fn effects_written_into_a_wing_s_file_read_back_and_fly_the_same_bits() {
    let copy = Copy::new("round", &text());
    let file = copy.read().unwrap();
    let wing = ElasticWing::from_bulk(&file, &file.bulk(Mount::Tunnel).unwrap()).unwrap();
    let controls = wing.control_names();
    let effects = some(&controls);
    let mut listed: Vec<WingEffect> = effects.iter().map(Active::to_wing).collect();
    listed[0].sigma = vec![("Iyy_kg_m2".into(), 0.01)];
    listed[0].evidence = Some(321.5);
    listed[0].rivals = vec!["added_mass".into()];
    listed[0].data_hash = "0123456789abcdef".into();
    listed[0].validity = Some(EffectValidity { v_m_s: Some((18.0, 34.0)), ..EffectValidity::default() });
    listed[2].covariance = vec![vec![1.0, 0.1], vec![0.1, 0.04]];
    let written = file.with_effects(listed.clone()).unwrap();
    assert!(written.text.contains("// ") && !written.text.contains(EMPTY), "comments stay");
    let second = Copy::new("round2", &written.text);
    let read = second.read().unwrap();
    assert_eq!(read.effects, listed);
    assert_ne!(read.hash, file.hash);
    // once more: a list that is there is replaced
    let again = read.with_effects(listed[1..].to_vec()).unwrap();
    assert_eq!(Copy::new("round3", &again.text).read().unwrap().effects, listed[1..]);

    let rig = Rig::new(
        &wing,
        RigSettings { modes: 8, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) },
    )
    .unwrap();
    let from_file = of_wing(&read, &controls).unwrap();
    let plain = flown(&wing, &rig, &file, &[]);
    let in_memory = flown(&wing, &rig, &file, &effects);
    assert!(in_memory == flown(&wing, &rig, &read, &from_file), "the file's effects fly otherwise");
    assert!(in_memory != plain);
    let names: Vec<String> = listed.iter().map(|effect| effect.name.clone()).collect();
    let none = without(&from_file, &names).unwrap();
    assert!(flown(&wing, &rig, &read, &none) == plain, "all switched off is the wing without effects");
    let two = without(&from_file, &names[..1]).unwrap();
    assert!(two.len() == 2 && flown(&wing, &rig, &read, &two) != in_memory);
    let unknown = without(&from_file, &["joiner_inertja".to_owned()]).unwrap_err();
    assert!(unknown.help.unwrap().contains("joiner_inertia"));
}

#[test]
fn effects_that_cannot_be_are_refused_at_their_place() {
    let controls = ["inner", "middle", "outer"].map(str::to_owned);
    // (list, part of the message, part of the hint, what stands at the place)
    let cases = [
        ("(name: \"joiner\", parameters: {})", "no effect \"joiner\"", "", "\"joiner\""),
        ("(name: \"gainn\", parameters: {})", "no effect \"gainn\"", "did you mean \"gain\"", "\"gainn\""),
        ("(name: \"delay\", parameters: {\"tau\": 0.01})", "no parameter \"tau\"", "tau_s", "\"tau\""),
        ("(name: \"delay\", parameters: {\"tau_s\": 0.1})", "expected -0.06 to 0.06", "unit", "\"tau_s\""),
        ("(name: \"ctl_saturation\", form: \"tan\", parameters: {})", "no form \"tan\"", "tanh", "form"),
        (
            "(name: \"joiner_inertia\", parameters: {\"mx_kg_m\": 0.2})",
            "other parameters allow",
            "",
            "parameters",
        ),
        (
            "(name: \"delay\", parameters: {}), (name: \"delay\", parameters: {})",
            "listed twice",
            "once",
            "\"delay\"",
        ),
        (
            "(name: \"delay\", parameters: {\"tau_s\": 0.0}, sigma: {\"tau_x\": 1.0})",
            "no parameter listed",
            "tau_s",
            "\"tau_x\"",
        ),
        (
            "(name: \"delay\", parameters: {\"tau_s\": 0.0, \"tau_s\": 0.0})",
            "listed twice",
            "once",
            "\"tau_s\"",
        ),
        ("(name: \"delay\", parameters: {}, validity: (V_m_s: (3.0, 1.0)))", "does not ascend", "", "V_m_s"),
        (
            "(name: \"delay\", parameters: {}, covariance: [[1.0]])",
            "symmetric matrix of 0 by 0",
            "",
            "covariance",
        ),
    ];
    for (index, (list, message, help, at)) in cases.into_iter().enumerate() {
        let changed = text().replace(EMPTY, &format!("effects: [{list}],"));
        let copy = Copy::new(&format!("refused{index}"), &changed);
        let error = copy.read().and_then(|file| of_wing(&file, &controls)).unwrap_err();
        assert!(error.message.contains(message), "{list}: {}", error.message);
        assert!(error.help.clone().unwrap_or_default().contains(help), "{list}: {:?}", error.help);
        let span = error.span.unwrap();
        let line = changed.lines().nth(span.line - 1).unwrap();
        assert!(line[span.column - 1..].starts_with(at), "{list}: {}", &line[span.column - 1..]);
    }
}

/// The servos of the shipped wing's file.
const SERVOS: &str = "servos: SecondOrder(frequency_hz: 15.0, damping_ratio: 0.8, frequency_sd_hz: 1.0, damping_ratio_sd: 0.05),";

#[test]
fn servos_are_those_of_the_file_and_how_well_they_are_known_is_in_the_effects() {
    assert!(text().contains(SERVOS));
    let with = |name: &str, servos: &str| Copy::new(name, &text().replace(SERVOS, servos)).read();
    let known = |file: &WingFile| -> Vec<Option<f64>> {
        let library = library_with(&["one".to_owned()], &file.into());
        let forms = library.iter().filter(|effect| effect.spec().name == "act_lag");
        forms.flat_map(|form| form.parameters()).map(|p| p.calibrated.map(|known| known.sigma)).collect()
    };
    let actuator = |file: &WingFile| RigSettings::of_wing(file).actuator;
    // left out: as the shipped file says
    let (left_out, said) = (with("out", "").unwrap(), with("said", SERVOS).unwrap());
    assert_eq!((left_out.servos, actuator(&left_out)), (said.servos, actuator(&said)));
    assert_eq!(actuator(&said), Actuator { frequency_hz: 15.0, damping_ratio: 0.8 });
    // shares of period and damping, and the delay 2 zeta / w of both: 1.6 / (2 pi 15) times these in quadrature
    let shares = [1.0 / 15.0, 0.05 / 0.8];
    let delay_s = 1.6 / (std::f64::consts::TAU * 15.0) * f64::hypot(shares[0], shares[1]);
    for (known, expected) in known(&said).into_iter().zip([shares[0], shares[1], delay_s, delay_s]) {
        assert!((known.unwrap() - expected).abs() < 1e-12, "{known:?} {expected}");
    }
    let own = "servos: SecondOrder(frequency_hz: 9.0, damping_ratio: 0.5, frequency_sd_hz: 0.9, damping_ratio_sd: 0.0),";
    let own = with("own", own).unwrap();
    assert_eq!(actuator(&own), Actuator { frequency_hz: 9.0, damping_ratio: 0.5 });
    assert_eq!(known(&own)[..2], [Some(0.1), None]);
    // without servos a command that does not jump is followed to a thousandth
    let none = with("none", "servos: None,").unwrap();
    assert_eq!(known(&none), [None; 4]);
    let command: Vec<f64> = (0..200).map(|i| (0.1 * f64::from(i)).sin()).collect();
    for (turned, command) in actuator(&none).follow(&command, 0.005).iter().zip(&command) {
        assert!((turned - command).abs() < 1e-3, "{turned} {command}");
    }
}

#[test]
fn servos_and_standard_deviations_that_cannot_be_are_refused_at_their_line() {
    let line = text().lines().position(|line| line.contains("servos: SecondOrder")).unwrap() + 1;
    for (servos, says) in [
        (SERVOS.replace("15.0", "0.0"), "servos of 0.0 +- 1.0 Hz"),
        (SERVOS.replace("hz: 1.0", "hz: -1.0"), "servos of 15.0 +- -1.0 Hz"),
        (SERVOS.replace("0.05", "0.5"), "a damping ratio of 0.8 +- 0.5"),
    ] {
        let error = Copy::new("bad_servos", &text().replace(SERVOS, &servos)).read().unwrap_err();
        assert!(error.message.contains(says), "{}", error.message);
        assert!(error.help.unwrap().contains("servos: None"));
        assert_eq!(error.span.unwrap().line, line);
    }
    let error = Copy::new("bad_known", &text().replace("bending: 0.01", "bending: 1.0")).read().unwrap_err();
    assert!(error.message.contains("bending"), "{}", error.message);
}

/// A wing that is known worse: what the file says is what an effect takes as known.
#[test]
fn what_the_file_says_of_the_tests_before_the_tunnel_is_what_effects_take_as_known() {
    let file = Copy::new(
        "known",
        &text().replace("bending: 0.01", "bending: 0.03").replace("mass: 0.007", "mass: 0.0"),
    );
    let library = library_with(&[], &(&file.read().unwrap()).into());
    let sigma = |name: &str| {
        let effect = library.iter().find(|effect| effect.spec().name == name).unwrap();
        effect.parameters()[0].calibrated.map(|known| known.sigma)
    };
    assert_eq!(sigma("bend_stiff"), Some(0.03));
    assert_eq!(sigma("wing_mass_error"), None);
    assert_eq!(sigma("tors_stiff"), Some(0.02));
}
