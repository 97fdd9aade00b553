//! How often a wrong name is given: campaigns of the tests' own integrator, each with other sizes, airspeeds and scatter.
//! Minutes, so with `RUN_SLOW_TESTS=1` only, and `FREE_CAMPAIGNS=300` for as many of each kind (38 minutes); the numbers stand in docs/benchmarks.md.

use std::io::Write as _;
use std::path::Path;

use crate::independent::{Moment, campaign};
use free::effect::Family;
use free::points::points;
use free::rig::Rig;
use free::search::{Found, search};
use free::verdict::Answer;
use rayon::prelude::*;

/// Campaigns of each kind, if `FREE_CAMPAIGNS` names no other number.
const CAMPAIGNS: u32 = 20;
/// One wrong name in so many is allowed.
const ONE_IN: usize = 100;

/// A number from 0 to 1 that goes evenly through the campaigns.
fn even(k: u32, turn: f64) -> f64 {
    (f64::from(k) * turn).fract()
}

fn found(k: u32, cycles_m_s: &[f64], taps_m_s: &[f64], moment: Moment<'_>) -> Found {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/bristol/rig.ron");
    let rig = Rig::read(&path).expect("the shipped rig");
    let moved = |all: &[f64]| all.iter().map(|v| v + 1.5 * even(k, 0.618_034)).collect::<Vec<_>>();
    search(&rig, &points(&campaign(&moved(cycles_m_s), &moved(taps_m_s), moment), &rig.scatter))
}

fn said(text: &str) {
    writeln!(std::io::stderr(), "{text}").expect("standard error");
}

/// Asserts that something wrong holds of hardly any; not run without `RUN_SLOW_TESTS=1`.
fn rare(what: &str, is_wrong: impl Fn(u32) -> bool + Sync) {
    if std::env::var_os("RUN_SLOW_TESTS").is_none() {
        said("not run, as it takes minutes: RUN_SLOW_TESTS=1 runs it");
        return;
    }
    let asked =
        std::env::var("FREE_CAMPAIGNS").ok().map(|count| count.parse().expect("a number of campaigns"));
    let campaigns: u32 = asked.unwrap_or(CAMPAIGNS);
    let wrong = (0..campaigns).into_par_iter().filter(|k| is_wrong(*k)).count();
    said(&format!("{what}: {wrong} of {campaigns}"));
    assert!(wrong <= campaigns as usize / ONE_IN, "{what}: {wrong} of {campaigns}");
}

#[test]
fn a_spring_that_hardens_gets_no_second_name() {
    rare("hardening with another or a second name", |k| {
        let (k3, power) = (1500.0 + 3000.0 * even(k, 0.414_214), if k.is_multiple_of(2) { 3 } else { 2 });
        let size = if power == 3 { k3 } else { 0.12 * k3 };
        let moment = move |a: f64, _: f64, _: f64| size * a.abs().powi(power).copysign(a);
        let found = found(k, &[18.0, 22.0, 26.5], &[18.0, 24.0], &moment);
        !matches!(found.answer(), Answer::Named([one]) if one.family() == Family::HardeningPitch)
    });
}

#[test]
fn a_stall_of_the_moment_is_not_called_a_spring() {
    rare("stall of the moment called a spring", |k| {
        let (slope, mean) = (6.0 + 6.0 * even(k, 0.414_214), 0.08 + 0.04 * even(k, 0.732_051));
        let moment = move |a: f64, _: f64, q: f64| q * 0.063 * slope * (a + mean - 0.14).max(0.0);
        let found = found(k, &[18.0, 22.0, 26.5], &[18.0, 24.0], &moment);
        matches!(found.answer(), Answer::Named([one, ..]) if one.family() == Family::HardeningPitch)
    });
}

#[test]
fn decays_of_a_linear_rig_get_no_name() {
    rare("linear decays with a name", |k| {
        found(k, &[], &[12.0, 14.5], &|_: f64, _: f64, _: f64| 0.0).answer() != Answer::Nothing
    });
}
