//! What is named on campaigns of a rig that the crate did not make, and that nothing is named where nothing is missing.

use std::path::{Path, PathBuf};

use crate::independent::{Moment, campaign};
use free::effect::{Effect, Family};
use free::fit::Problem;
use free::held_out::HeldOut;
use free::points::points;
use free::predict::{predictions, score};
use free::rig::Rig;
use free::search::{Found, search};
use free::verdict::Answer;

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/bristol")
}

fn rig() -> Rig {
    Rig::read(&data().join("rig.ron")).expect("the shipped rig")
}

const CYCLES_M_S: [f64; 3] = [18.0, 22.5, 28.0];
const TAPS_M_S: [f64; 2] = [18.0, 24.0];

fn found(moment: Moment<'_>) -> Found {
    let rig = rig();
    search(&rig, &points(&campaign(&CYCLES_M_S, &TAPS_M_S, moment), &rig.scatter))
}

#[test]
fn a_spring_that_hardens_is_named_alone_and_its_cycles_are_predicted() {
    let cubic: Moment<'_> = &|a: f64, _, _| 3000.0 * a.powi(3);
    let found = found(cubic);
    let Answer::Named([one]) = found.answer() else {
        panic!("{:?}: {}", found.answer(), found.answer().sentence());
    };
    assert_eq!(one.family(), Family::HardeningPitch, "{}", found.answer().sentence());
    let unseen = campaign(&[19.5, 26.0], &[], cubic);
    let predicted = predictions(&rig(), &found.fitted, &unseen, &vec![true; unseen.len()]);
    let score = score(predicted.iter());
    assert_eq!((score.cycles, score.missing), (4, 0));
    assert!(score.amplitude < 0.02, "pitch amplitude {:.4} rms", score.amplitude);
    assert!(score.frequency < 0.005, "frequency {:.4} rms", score.frequency);
}

#[test]
fn a_moment_that_stalls_is_not_called_a_spring() {
    // per dynamic pressure, span and chord: beyond eight degrees of incidence, about a mean of six
    let found = found(&|a: f64, _, q| q * 0.063 * 8.0 * (a + 0.1 - 0.14).max(0.0));
    if let Answer::Named(named) | Answer::Ambiguous(named, _) = found.answer() {
        assert_eq!(named[0].family(), Family::MomentStall, "{}", found.answer().sentence());
    }
}

#[test]
fn decays_of_a_linear_rig_name_nothing() {
    let rig = rig();
    let runs = campaign(&[], &[13.0, 16.0], &|_, _, _| 0.0);
    let found = search(&rig, &points(&runs, &rig.scatter));
    assert_eq!(found.answer(), Answer::Nothing, "{}", found.answer().sentence());
}

#[test]
fn a_model_is_never_worse_than_a_part_of_it() {
    let rig = rig();
    let points = points(&campaign(&[20.0, 26.0], &[24.0], &|a: f64, _, _| 3000.0 * a.powi(3)), &rig.scatter);
    let problem = Problem::new(&rig, &points);
    let part = problem.fit(&[Effect::CubicPitch], Some(&problem.fit(&[], None)));
    for more in [Effect::DryPitch, Effect::QuadraticPitch, Effect::LiftStall] {
        let whole = problem.fit(&[Effect::CubicPitch, more], Some(&part));
        let best = |f: &free::fit::Fitted| {
            f.log_likelihood.values().sum::<f64>() - 0.5 * f.x.iter().map(|x| x * x).sum::<f64>()
        };
        assert!(
            best(&whole) >= best(&part) - 1e-6,
            "{}: {} after {}",
            more.name(),
            best(&whole),
            best(&part)
        );
    }
}

#[test]
fn every_second_airspeed_and_a_whole_day_are_kept_from_a_fit() {
    let runs = campaign(&[20.0, 20.1, 21.0, 22.0], &[], &|_, _, _| 0.0);
    let held = HeldOut { every_second_airspeed: true, days: vec![2] }.of(&runs);
    assert_eq!(held[..4], [false, false, true, false], "20.0 and 20.1 are one airspeed");
    assert!(held[4..].iter().all(|held| *held), "the second day");
}
