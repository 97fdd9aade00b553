//! Cases of a plan flown on an aircraft that is assembled within milliseconds: loads at grids add up to those at
//! stations.

use crate::aircraft::assembly::Aircraft;
use crate::aircraft::file::FlightPoint;
use crate::aircraft::small;
use crate::cases::file::Action as Own;
use crate::design_loads::fly::{Nodal, PlanFlight};
use crate::design_loads::in_time::{AFTER_S, TIME_STEP_S, axis_of};
use crate::design_loads::instants::FlownCase;
use crate::design_loads::search::tests::{case, discrete};
use crate::error::AircraftError;
use crate::flight::air::FlightAir;
use crate::flight::gust::GustAxis;
use crate::flight::model::FlyingAircraft;
use crate::flight::small_motions::FreeFlight;
use crate::stations::nodal::Component;
use crate::trim::case::TrimTools;
use crate::trim::maneuvers::Steady;
use loads::design::{Attitude, Direction, Spectrum};
use loads::matrix::{Action, Case};
use maneuver::motion::{Doublet, MotionSpec};
use std::sync::OnceLock;

const V_M_S: f64 = 30.0;

/// The small aircraft with its centre of gravity so far ahead that it is stable, and its air.
fn stable() -> &'static (Aircraft, FlightAir) {
    static STABLE: OnceLock<(Aircraft, FlightAir)> = OnceLock::new();
    let with_cg_at = |x_cg_m: f64| {
        let mut file = small::aircraft().file.clone();
        file.total.x_cg_m = x_cg_m;
        (file.total.ixx_kg_m2, file.total.iyy_kg_m2, file.total.izz_kg_m2) = (4.0, 5.0, 7.0);
        let aircraft = small::aircraft().of_totals(file, &()).expect("a body has the rest");
        let air = FlightAir::new(&aircraft).expect("it can be solved");
        let model = aircraft.uncorrected();
        let level = FlightPoint { v_m_s: V_M_S, load_factor: 1.0, pitch_rate_deg_s: 0.0 };
        let trimmed = model.trim("level", &level).expect("it is trimmed");
        let flying = FlyingAircraft::new(&model, &air, &trimmed, Vec::new(), None).expect("it flies");
        let doubling_s = FreeFlight::of(flying).doubling_s();
        (doubling_s.is_none_or(|doubling_s| doubling_s > 8.0), (aircraft, air))
    };
    STABLE.get_or_init(|| {
        let found =
            [0.36, 0.32, 0.28, 0.24, 0.2, 0.16, 0.12].into_iter().map(with_cg_at).find(|found| found.0);
        found.expect("far enough ahead any aircraft is stable").1
    })
}

fn aircraft() -> &'static Aircraft {
    &stable().0
}

/// Flies cases; checks each instant's loads by those at grids, which must be in balance as a whole.
fn flown(cases: Vec<Case>, search: bool) -> Vec<FlownCase> {
    let tools = TrimTools::new(aircraft(), &[]).expect("stations");
    let model = aircraft().uncorrected();
    let mut stations = aircraft().wing_stations(&[]).expect("stations");
    stations.extend(aircraft().body_stations());
    let doublet = Doublet { height: 0.1, frequency_hz: 4.0, start_s: 0.02 };
    let motion = MotionSpec { duration_s: Some(0.3), ..MotionSpec::new("outer", doublet) };
    let maneuvers = [Own::Steady(Steady::Pull { load_factor: 2.0 }), Own::Motion(motion)];
    let plan = PlanFlight {
        tools: &tools,
        air: Some(&stable().1),
        stations: &stations,
        maneuvers: &maneuvers,
        search,
    };
    let all: Vec<Case> = cases.into_iter().map(|case| Case { v_m_s: V_M_S, ..case }).collect();
    let all: Vec<&Case> = all.iter().collect();
    let points = aircraft().free.points();
    let mut found = Vec::new();
    let done = &mut |flown: FlownCase, nodal: &Nodal<'_>| {
        assert_eq!((flown.refused.as_deref(), flown.model), (None, 1));
        for instant in &flown.instants {
            let Some(loads) = nodal(instant) else { continue };
            let scale = loads.of(Component::Air).iter().fold(0.0, |most, load| f64::max(most, load.abs()));
            for (station, law) in stations.iter().zip(&instant.loads) {
                for (component, law) in Component::ALL.into_iter().zip(law) {
                    let sums = station.sums(points, &loads.of(component));
                    for (sum, law) in sums.iter().zip(law) {
                        assert!((sum - law).abs() < 1e-7 * scale, "{} of {}", station.name, flown.number);
                    }
                }
            }
            let whole = instant.net().pop().expect("the whole is the last");
            assert!(whole.iter().all(|load| load.abs() < 1e-5 * scale), "{whole:?} of {scale}");
        }
        found.push(flown);
        Ok::<(), AircraftError>(())
    };
    plan.fly(&model, 1, &all, done).expect("nothing stops it");
    found.sort_by_key(|flown| flown.number);
    found
}

/// Smallest and largest bending moment at the right root.
fn bending(flown: &FlownCase) -> [f64; 2] {
    let all = || flown.instants.iter().map(|instant| instant.net()[0][3]);
    [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
}

fn once(mut case: Case) -> Case {
    if let Action::Discrete { refine, .. } = &mut case.action {
        *refine = false;
    }
    case
}

#[test]
fn trims_motions_and_gusts_of_a_plan_are_in_balance_and_last_as_long_as_they_must() {
    let trim = |number: usize, n_z: f64| Case { n_z, ..case(number, Action::Trim) };
    let found = flown(
        vec![
            trim(1, 1.0),
            trim(2, 2.0),
            case(3, Action::Condition(0)),
            case(4, Action::Condition(1)),
            once(discrete(5, 6.0, Direction::Up)),
            once(discrete(6, 6.0, Direction::Down)),
            once(discrete(7, 3.0, Direction::Lateral)),
            once(discrete(8, 3.0, Direction::Up)),
        ],
        false,
    );
    assert_eq!(found.iter().map(|flown| flown.number).collect::<Vec<_>>(), (1..9).collect::<Vec<_>>());
    let [level, pulled] = [0, 1].map(|at| bending(&found[at])[0]);
    assert!((bending(&found[2])[0] - pulled).abs() < 1e-9 * pulled.abs(), "a trim by either name");
    assert!(pulled > 1.5 * level && level > 0.0, "{pulled} at 2 g, {level} at 1 g");
    // what one upwards adds one downwards takes away, at the same moment
    let ([low, high], [down, up]) = (bending(&found[4]), bending(&found[5]));
    let scale = high - low;
    assert!(
        (high - level + down - level).abs() < 1e-6 * scale && (low - level + up - level).abs() < 1e-6 * scale
    );
    assert!(high - level > 0.05 * level, "{high} in the gust");
    for (at, flown_s) in [(3, 0.3), (4, 12.0 / V_M_S), (6, 6.0 / V_M_S), (7, 6.0 / V_M_S)] {
        let last_s = found[at].instants.iter().map(|instant| instant.t_s).fold(0.0, f64::max);
        assert!(last_s <= flown_s + AFTER_S + 1.5 * TIME_STEP_S && last_s > 0.0, "case {at}: {last_s} s");
        assert!(found[at].instants.iter().any(|instant| instant.t_s == 0.0) || last_s > 0.05);
    }
}

#[test]
fn a_gradient_that_is_searched_for_is_flown_between_those_of_the_plan() {
    let gradients = [1.0, 4.0, 16.0, 64.0];
    let cases = gradients.iter().enumerate().map(|(at, m)| discrete(at, *m, Direction::Up)).collect();
    let found = flown(cases, true);
    assert_eq!(found.len(), 4);
    let more: Vec<f64> =
        found.iter().flat_map(|flown| &flown.instants).filter_map(|instant| instant.gradient_m).collect();
    assert!(!more.is_empty() && more.iter().all(|m| (1.0..=64.0).contains(m)), "{more:?}");
    assert!(found.iter().all(|flown| flown.instants.iter().any(|instant| instant.gradient_m.is_none())));
}

#[test]
fn turbulence_has_each_load_at_its_limit_and_the_axis_of_a_case_is_its_direction() {
    let rough = |direction: Direction| Action::Turbulence {
        direction,
        u_sigma_m_s: 5.0,
        scale_m: 762.0,
        cut_off_hz: 10.0,
        spectrum: Spectrum::Karman,
        attitude: Attitude::Held,
        longest_gradient_m: 107.0,
    };
    let trim = Case { n_z: 1.0, ..case(1, Action::Trim) };
    let found = flown(vec![trim, case(2, rough(Direction::Up))], false);
    let level = bending(&found[0])[0];
    let facts = found[1].turbulence.as_ref().expect("it was flown in turbulence");
    let a_bar = facts.loads.iter().find(|load| (load.station, load.load) == (0, 3)).expect("bending").a_bar;
    let [low, high] = bending(&found[1]);
    // CS-25.341(b): the limit is level flight plus and minus U_sigma times A
    assert!((high - level - 5.0 * a_bar).abs() < 1e-6 * level, "{high} {level} {a_bar}");
    assert!((level - low - 5.0 * a_bar).abs() < 1e-6 * level, "{low} {level} {a_bar}");
    assert_eq!(facts.u_sigma_m_s, 5.0);
    let axis = |action: Action| axis_of(&case(1, action));
    assert_eq!(
        [axis(rough(Direction::Up)), axis(rough(Direction::Lateral))],
        [GustAxis::Vertical, GustAxis::Lateral]
    );
    assert_eq!(axis_of(&discrete(1, 9.0, Direction::Lateral)), GustAxis::Lateral);
    assert_eq!([axis_of(&discrete(1, 9.0, Direction::Down)), axis(Action::Trim)], [GustAxis::Vertical; 2]);
}
