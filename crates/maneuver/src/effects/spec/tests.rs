//! What is known before any data.

use super::*;

fn spec(name: &'static str, rivals: &'static [&'static str]) -> Spec {
    Spec { name, rivals, ..Spec::NONE }
}

#[test]
fn either_of_two_rivals_may_name_the_other() {
    let (one, other, third) = (spec("one", &["other"]), spec("other", &[]), spec("third", &["fourth"]));
    assert!(one.is_rival_of(&other) && other.is_rival_of(&one));
    assert!(!one.is_rival_of(&third) && !third.is_rival_of(&one) && !other.is_rival_of(&third));
    let (each, too) = (spec("each", &["too"]), spec("too", &["each"]));
    assert!(each.is_rival_of(&too) && too.is_rival_of(&each));
}

#[test]
fn a_parameter_that_is_known_exactly_is_none_of_what_stays_uncertain() {
    let mut parameter = Parameter::new("share", -0.5..=2.0, 0.1);
    assert_eq!((parameter.lower, parameter.upper, parameter.plausible), (-0.5, 2.0, 0.1));
    assert_eq!((parameter.name.as_str(), parameter.calibrated), ("share", None));
    parameter.know(Calibration::Air, 0.04);
    assert_eq!(parameter.calibrated, Some(Calibrated { by: Calibration::Air, sigma: 0.04 }));
    parameter.know(Calibration::Air, 0.0);
    assert_eq!(parameter.calibrated, None);
}

#[test]
fn what_belongs_to_the_wing_travels_with_it() {
    let travels = |sides: &[Side]| sides.iter().map(|side| side.travels()).collect::<Vec<bool>>();
    assert_eq!(travels(&[Side::Aerodynamics, Side::Control, Side::Structure]), [true; 3]);
    assert_eq!(travels(&[Side::Balance, Side::Flow, Side::Sensor]), [false; 3]);
    let mut stages = [Stage::Record, Stage::Load, Stage::Reading];
    stages.sort();
    assert_eq!(stages, Stage::ALL);
}

#[test]
fn how_well_a_wing_is_known_stands_in_its_file() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let mut file = WingFile::read(&path).expect("the shipped wing");
    file.known_to.mass = 0.123;
    file.servos = Servos::None;
    let known = Known::from(&file);
    assert_eq!((known.to.mass, known.servos, known.to), (0.123, Servos::None, file.known_to));
}
