//! An aircraft whose neutral point lies ahead of its centre of gravity: what it is refused in, and what an attitude that is held changes.

use fullaircraft::design_loads::fly::PlanFlight;
use fullaircraft::design_loads::instants::FlownCase;
use fullaircraft::{Aircraft, AircraftError, AircraftFile, FlightAir, TrimTools};
use loads::design::{Attitude, Direction, Rules, Spectrum};
use loads::matrix::{Action, Case, Status};

const V_M_S: f64 = 37.0;
/// Gradients that the unstable aircraft flies, and that it does not, m.
const SHORT_M: f64 = 2.0;
const LONG_M: f64 = 107.0;

/// The shipped aircraft with beams and the centre of gravity at x, m.
fn with_cg_at(x_cg_m: f64) -> Aircraft {
    let mut file = AircraftFile::read(&crate::common::path()).expect("shipped files are right");
    file.total.x_cg_m = x_cg_m;
    let wing = coupling::WingFile::read(&crate::common::beam_wing()).expect("shipped files are right");
    Aircraft::new(file, wing).expect("the body takes up the difference")
}

fn turbulence(attitude: Attitude, longest_gradient_m: f64) -> Action {
    Action::Turbulence {
        direction: Direction::Up,
        u_sigma_m_s: 5.0,
        scale_m: 762.0,
        cut_off_hz: 5.0,
        spectrum: Spectrum::Karman,
        attitude,
        longest_gradient_m,
    }
}

fn gust(gradient_m: f64) -> Action {
    Action::Discrete { direction: Direction::Up, gradient_m, u_ds_m_s: 3.0, refine: false }
}

/// Cases of these actions, flown with the wing as designed.
fn flown(aircraft: &Aircraft, air: &FlightAir, actions: &[Action]) -> Vec<FlownCase> {
    let case = |(place, action): (usize, &Action)| Case {
        number: place + 1,
        kind: String::new(),
        mass: 0,
        h_m: 0.0,
        v_m_s: V_M_S,
        v_eas_m_s: V_M_S,
        mach: 0.0,
        n_z: 1.0,
        condition: String::new(),
        rule: Rules::Own,
        status: Status::Planned,
        why: String::new(),
        action: action.clone(),
    };
    let cases: Vec<Case> = actions.iter().enumerate().map(case).collect();
    let tools = TrimTools::new(aircraft, &[]).expect("the aircraft flies");
    let stations = aircraft.wing_stations(&[]).expect("roots");
    let plan =
        PlanFlight { tools: &tools, air: Some(air), stations: &stations, maneuvers: &[], search: false };
    let model = aircraft.uncorrected();
    let mut all = Vec::new();
    plan.fly(&model, 0, &cases.iter().collect::<Vec<_>>(), &mut |flown, _| {
        all.push(flown);
        Ok::<(), AircraftError>(())
    })
    .expect("what cannot be flown is a result");
    all.sort_by_key(|flown| flown.number);
    all
}

#[test]
fn who_is_refused_in_the_longest_gust_is_refused_in_turbulence_by_the_same_sentence_unless_held() {
    let aircraft = with_cg_at(0.45);
    let air = FlightAir::new(&aircraft).expect("the shipped lattice is right");
    let all = flown(
        &aircraft,
        &air,
        &[
            gust(LONG_M),
            turbulence(Attitude::Stable, LONG_M),
            turbulence(Attitude::Held, LONG_M),
            gust(SHORT_M),
            turbulence(Attitude::Stable, SHORT_M),
        ],
    );
    let why: Vec<Option<&str>> = all.iter().map(|case| case.refused.as_deref()).collect();
    let sentence = why[0].expect("a motion doubles in the long gust");
    assert!(sentence.contains("level flight is unstable with this mass, a motion doubles in "), "{sentence}");
    assert_eq!(
        why[1..],
        [Some(sentence), None, None, None],
        "turbulence; held; a gust that is short; as short"
    );
    let attitudes = all.iter().map(|case| case.turbulence.as_ref().map(|facts| facts.attitude));
    let stable = Some(Attitude::Stable);
    assert_eq!(attitudes.collect::<Vec<_>>(), [None, None, Some(Attitude::Held), None, stable]);
    let a_bar = |case: &FlownCase| case.turbulence.as_ref().expect("it is flown").loads[0].a_bar;
    assert_eq!(
        a_bar(&all[2]),
        a_bar(&all[4]),
        "held or not, it is one computation: only who is refused differs"
    );
}

#[test]
fn a_stable_aircraft_is_flown_in_turbulence_whoever_holds_its_attitude() {
    let all = flown(crate::common::whole(), crate::common::air(), &[turbulence(Attitude::Stable, LONG_M)]);
    assert!(all.iter().all(|case| case.refused.is_none()), "{:?}", all[0].refused);
}
