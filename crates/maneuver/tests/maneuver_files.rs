//! Declared maneuvers: what moves and how, and what is refused or remarked upon, by name and place.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{Corrections, Flow};
use coupling::{ElasticWing, WingFile};
use maneuver::growth::growing;
use maneuver::motion::{About, Chirp, OneMinusCosine, Signal};
use maneuver::{DeflectionAt, ManeuverFile, Rig, RigModel, RigSettings, fly_commanded};
use nastran::InputError;
use std::path::PathBuf;

/// A maneuver's file in a folder of its own, with the signal some of them name.
struct Declared(PathBuf);

const OWN: &str = "t_s,delta_inner_deg\n0,0\n0.1,4\n0.3,-2\n";

impl Declared {
    fn new(test: &str, text: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-maneuver-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("maneuver.ron"), text).unwrap();
        std::fs::write(folder.join("own.csv"), OWN).unwrap();
        std::fs::write(folder.join("angle.csv"), "t_s,alpha_deg\n0,1\n0.5,1\n1,3\n").unwrap();
        std::fs::write(folder.join("unknown.csv"), "t_s,delta_iner_deg\n0,1\n1,3\n").unwrap();
        Self(folder)
    }

    fn read(&self) -> Result<ManeuverFile, InputError> {
        ManeuverFile::read(&self.0.join("maneuver.ron"))
    }
}

impl Drop for Declared {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// One motion at 30 m/s and 1.3 degrees, 200 samples a second for two seconds.
fn with(motion: &str) -> String {
    format!(
        "Maneuver(\n  V_m_s: 30.0,\n  alpha_deg: 1.3,\n  sample_rate_hz: 200.0,\n  length_s: 2.0,\n  motions: [\n    {motion},\n  ],\n)\n"
    )
}

const DOUBLET: &str = "Doublet(of: \"inner\", height_deg: 15.0, frequency_hz: 1.0, start_s: 0.5)";

fn controls() -> Vec<String> {
    ["inner", "middle", "outer"].map(str::to_owned).to_vec()
}

fn wing_file() -> WingFile {
    crate::common::wing_with(|_| ()).0
}

/// Reads and checks; the complaint with its line and column.
fn complaint(test: &str, text: &str) -> (String, (usize, usize)) {
    let declared = Declared::new(test, text);
    let error = declared.read().and_then(|file| file.checked(&wing_file(), &controls())).unwrap_err();
    let span = error.span.clone().unwrap();
    assert!(error.help.is_some(), "{test}: {error}");
    (error.to_string(), (span.line, span.column))
}

fn remarks(test: &str, text: &str) -> Vec<String> {
    Declared::new(test, text).read().and_then(|file| file.checked(&wing_file(), &controls())).unwrap()
}

fn model_of(wing: &ElasticWing, file: &WingFile) -> RigModel {
    let rig = Rig::new(wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    rig.at(Flow { v_m_s: 30.0, rho_kg_m3: 1.225 }, &Corrections::neutral(wing.correctable.len())).unwrap()
}

#[test]
fn a_negative_time_or_length_is_refused() {
    let (said, place) = complaint("length", &with(DOUBLET).replace("length_s: 2.0", "length_s: -2.0"));
    assert!(said.contains("length -2.0 s") && place == (5, 3), "{said}");
    let (said, place) = complaint("start", &with(&DOUBLET.replace("0.5", "-0.5")));
    assert!(said.contains("Doublet starts at -0.5 s") && place == (7, 63), "{said}");
    let chirp = "Chirp(of: \"inner\", height_deg: 5.0, from_hz: 0.0, to_hz: 10.0, duration_s: -1.0)";
    let (said, place) = complaint("duration", &with(&format!("{DOUBLET},\n    {chirp}")));
    assert!(said.contains("duration_s of Chirp is -1.0") && place == (8, 68), "{said}");
}

#[test]
fn a_frequency_above_half_the_sampling_rate_is_refused() {
    let (said, _) = complaint("doublet", &with(&DOUBLET.replace("frequency_hz: 1.0", "frequency_hz: 120.0")));
    assert!(said.contains("120 Hz") && said.contains("half the sampling rate of 200 Hz"), "{said}");
    let chirp = "Chirp(of: \"inner\", height_deg: 5.0, from_hz: 0.0, to_hz: 101.0, duration_s: 1.0)";
    assert!(complaint("chirp", &with(chirp)).0.contains("101 Hz"));
    let units = "ThreeTwoOneOne(of: \"inner\", height_deg: 5.0, unit_s: 0.004)";
    assert!(complaint("units", &with(units)).0.contains("125 Hz"));
    // at half the sampling rate itself nothing is refused
    assert!(
        Declared::new("half", &with(&DOUBLET.replace("frequency_hz: 1.0", "frequency_hz: 100.0")))
            .read()
            .is_ok()
    );
}

#[test]
fn an_unknown_surface_is_refused_with_the_one_that_was_meant() {
    let (said, place) = complaint("surface", &with(&DOUBLET.replace("inner", "iner")));
    assert!(said.contains("moves \"iner\"") && said.contains("did you mean \"inner\"?"), "{said}");
    assert_eq!(place, (7, 13));
    let (said, place) = complaint("column", &with("FromFile(file: \"unknown.csv\")"));
    assert!(
        said.contains("did you mean \"inner\"?") && said.contains("unknown.csv") && place == (2, 3),
        "{said}"
    );
    let (said, _) = complaint("none", &with(&DOUBLET.replace("inner", "rudder")));
    assert!(said.contains("what can move: alpha, inner, middle, outer"), "{said}");
}

#[test]
fn a_deflection_beyond_its_limit_is_refused_and_the_assumed_limit_says_so() {
    let (said, place) = complaint("limit", &with(&DOUBLET.replace("15.0", "31.0")));
    assert!(said.contains("31.00 degrees") && said.contains("30 degrees (assumed"), "{said}");
    assert_eq!(place, (7, 26));
    // two motions of one surface add up
    let sum = format!("{DOUBLET},\n    Step(of: \"inner\", height_deg: 20.0)");
    assert!(complaint("sum", &with(&sum)).0.contains("35.00 degrees"));
    let (limited, _) = crate::common::wing_with(|planform| planform.controls[0].limit_deg = Some(10.0));
    let error =
        Declared::new("own", &with(DOUBLET)).read().unwrap().checked(&limited, &controls()).unwrap_err();
    assert!(error.message.contains("beyond 10 degrees (its limit in the wing's file)"), "{error}");
}

#[test]
fn a_step_or_doublet_in_a_command_without_an_actuator_is_refused() {
    for motion in [
        DOUBLET,
        "Step(of: \"inner\", height_deg: 5.0)",
        "ThreeTwoOneOne(of: \"inner\", height_deg: 5.0, unit_s: 0.1)",
    ] {
        let kind = motion.split('(').next().unwrap();
        let text = with(motion).replace("  motions:", "  actuator: None,\n  motions:");
        let (said, place) = complaint(kind, &text);
        assert!(said.contains(&format!("{kind} of inner jumps, and there is no actuator")), "{said}");
        assert_eq!(place.0, 8);
    }
    let smooth = with("OneMinusCosine(of: \"inner\", height_deg: 5.0, frequency_hz: 2.0)");
    assert!(remarks("smooth", &smooth.replace("  motions:", "  actuator: None,\n  motions:")).is_empty());
}

#[test]
fn a_model_whose_motion_grows_by_itself_is_above_flutter() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let mut model = model_of(&wing, &file);
    assert_eq!(growing(&model), None, "the wing is stable at 30 m/s");
    // one oscillation of 5 Hz that grows by 0.3 a second, one that decays
    let omega = std::f64::consts::TAU * 5.0;
    model.a = faer::mat![
        [0.3, omega, 0.0, 0.0],
        [-omega, 0.3, 0.0, 0.0],
        [0.0, 0.0, -1.0, 60.0],
        [0.0, 0.0, -60.0, -1.0],
    ];
    let found = growing(&model).unwrap();
    assert!((found.frequency_hz - 5.0).abs() < 1e-9 && (found.growth_per_s - 0.3).abs() < 1e-9, "{found}");
    assert!(found.to_string().contains("above the flutter speed"));
}

#[test]
fn an_airspeed_above_divergence_is_refused() {
    // a flexible wing swept forward diverges
    let (file, wing) = crate::common::wing_with(|planform| planform.quarter_chord_sweep_deg = -40.0);
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let v_d = wing.divergence_speed(1.225, &neutral).unwrap().unwrap();
    assert!(rig.at(Flow { v_m_s: 0.98 * v_d, rho_kg_m3: 1.225 }, &neutral).is_ok());
    let error = rig.at(Flow { v_m_s: 1.02 * v_d, rho_kg_m3: 1.225 }, &neutral).unwrap_err();
    assert!(error.to_string().contains("diverge"), "{error}");
}

#[test]
fn a_motion_that_outlasts_the_maneuver_and_a_jump_of_the_angle_are_remarked_upon() {
    let late = remarks("late", &with(&DOUBLET.replace("0.5", "1.5")));
    assert!(late.len() == 1 && late[0].contains("Doublet ends at 2.5 s"), "{late:?}");
    let jump = remarks("jump", &with("Step(of: \"alpha\", height_deg: 1.0, start_s: 0.5)"));
    assert!(jump.len() == 1 && jump[0].contains("angle of attack jumps"), "{jump:?}");
    let short = remarks("short", &with("FromFile(file: \"own.csv\")"));
    assert!(short.len() == 1 && short[0].contains("its last value is kept"), "{short:?}");
    assert!(remarks("none", &with(DOUBLET)).is_empty());
}

#[test]
fn the_angle_of_attack_is_given_once() {
    let both = complaint("both", &with("FromFile(file: \"angle.csv\")"));
    assert!(both.0.contains("given more than once") && both.1 == (3, 3), "{}", both.0);
    let text = with(DOUBLET).replace("  alpha_deg: 1.3,\n", "");
    assert!(Declared::new("missing", &text).read().unwrap_err().message.contains("`alpha_deg` is missing"));
}

#[test]
fn numbers_and_fields_that_cannot_be_are_refused_at_their_place() {
    for (test, from, to, place, said) in [
        ("airspeed", "V_m_s: 30.0", "V_m_s: -3.0", (2, 3), "airspeed -3.0"),
        ("angle", "alpha_deg: 1.3", "alpha_deg: 130.0", (3, 3), "beyond 90 degrees"),
        ("rate", "sample_rate_hz: 200.0", "sample_rate_hz: 0.0", (4, 3), "sample_rate_hz is 0.0"),
        ("samples", "length_s: 2.0", "length_s: 1e9", (5, 3), "samples"),
        ("field", "start_s: 0.5", "startt_s: 0.5", (7, 63), "no field `startt_s`"),
        ("kind", "Doublet(", "Doublett(", (7, 5), "no choice `Doublett`"),
    ] {
        let (message, found) = complaint(test, &with(DOUBLET).replace(from, to));
        assert!(message.contains(said), "{test}: {message}");
        assert!(found.0 == place.0, "{test}: {found:?}");
    }
    let named = Declared::new("file", &with("FromFile(file: \"nowhere.csv\")")).read().unwrap_err();
    assert!(named.message.contains("nowhere.csv does not exist") && named.span.unwrap().line == 7);
}

#[test]
fn declared_motions_are_the_signals_they_name() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model_of(&wing, &file);
    let text = with(
        "OneMinusCosine(of: \"alpha\", height_deg: 3.7, frequency_hz: 2.0, start_s: 0.5),\n\
         Chirp(of: \"outer\", height_deg: 5.0, from_hz: 0.0, to_hz: 10.0, duration_s: 1.0, start_s: 0.5),\n\
         FromFile(file: \"own.csv\", start_s: 0.5)",
    );
    let declared = Declared::new("signals", &text).read().unwrap();
    let motion = declared.motion(&model);
    assert_eq!((motion.time_step_s, motion.alpha.value.len()), (0.005, 401));
    let angle = About(1.3_f64.to_radians(), OneMinusCosine::new(3.7_f64.to_radians(), 2.0, 0.5));
    let chirp =
        Chirp { height: 5.0_f64.to_radians(), from_hz: 0.0, to_hz: 10.0, duration_s: 1.0, start_s: 0.5 };
    for (i, t_s) in declared.times().into_iter().enumerate() {
        assert!((motion.alpha.value[i] - angle.at(t_s)).abs() < 1e-14);
        assert!((motion.alpha.rate[i] - angle.rate(t_s)).abs() < 1e-14);
        assert!((motion.alpha.second[i] - angle.second(t_s)).abs() < 1e-13);
        assert!((motion.controls_rad[2][i] - chirp.at(t_s)).abs() < 1e-14);
    }
    // the file's samples, and what is linear between them; kept before and behind
    for (t_s, degrees) in
        [(0.0, 0.0), (0.5, 0.0), (0.55, 2.0), (0.6, 4.0), (0.7, 1.0), (0.8, -2.0), (2.0, -2.0)]
    {
        let i = declared.times().iter().position(|t| (t - t_s).abs() < 1e-9).unwrap();
        assert!((motion.controls_rad[0][i].to_degrees() - degrees).abs() < 1e-9, "{t_s} s");
    }
    assert!(motion.controls_rad[1].iter().all(|delta| *delta == 0.0));
}

#[test]
fn an_angle_of_ones_own_starts_from_rest_and_is_followed() {
    let (file, wing) = crate::common::wing_with(|_| ());
    let model = model_of(&wing, &file);
    let text = with("FromFile(file: \"angle.csv\")").replace("  alpha_deg: 1.3,\n", "");
    let declared = Declared::new("angle", &text).read().unwrap();
    let motion = declared.motion(&model);
    assert!((motion.alpha.value[0] - 1.0_f64.to_radians()).abs() < 1e-9);
    assert!((motion.alpha.value[400] - 3.0_f64.to_radians()).abs() < 1e-9);
    // a ramp of 4 degrees a second in its middle
    assert!(
        (motion.alpha.rate[150].to_degrees() - 4.0).abs() < 1e-3,
        "{}",
        motion.alpha.rate[150].to_degrees()
    );
    let history = fly_commanded(&model, &motion, &DeflectionAt::default());
    assert_eq!(history.t_s.len(), 401);
}

#[test]
fn an_actuator_of_ones_own_replaces_the_assumed_one() {
    let base = RigSettings::new(0.02, 0.0);
    let of = |actuator: &str| {
        let text = with(DOUBLET).replace("  motions:", &format!("  actuator: {actuator},\n  motions:"));
        Declared::new("actuator", &text).read().map(|file| file.settings(&base).actuator)
    };
    let own = of("SecondOrder(frequency_hz: 8.0, damping_ratio: 0.6)").unwrap();
    assert_eq!((own.frequency_hz, own.damping_ratio), (8.0, 0.6));
    assert_eq!(of("Assumed").unwrap(), base.actuator);
    assert_eq!(of("None").unwrap().frequency_hz, 2000.0);
    assert!(
        of("SecondOrder(frequency_hz: -8.0, damping_ratio: 0.6)").unwrap_err().message.contains("-8.0 Hz")
    );
}
