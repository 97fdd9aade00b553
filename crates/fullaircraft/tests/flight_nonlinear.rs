//! Nonlinear flight in unsteady air: laws it obeys, closed forms, and its linearisation.

use crate::common::{air, assert_near, whole};
use aero::incidence;
use faer::{Mat, MatRef};
use fullaircraft::{Drive, FlightHistory, FlyingAircraft, FreeFlight, Gust, Integration, Trimmed};
use maneuver::Signal;
use maneuver::motion::{Doublet, OneMinusCosine, Step};
use nalgebra::{Matrix4, Vector3};

fn trimmed() -> Trimmed {
    whole().uncorrected().trim("trim", &whole().file.trim).expect("the shipped aircraft is trimmed")
}

fn flying(drives: &[&str], gust: Option<Gust>) -> FlyingAircraft {
    let drives: Vec<Drive> = drives.iter().map(|name| whole().drive(name).expect("a control")).collect();
    FlyingAircraft::new(&whole().uncorrected(), air(), &trimmed(), drives, gust).expect("it flies")
}

fn change(values: &[f64]) -> Vec<f64> {
    values.iter().map(|value| value - values[0]).collect()
}

/// Largest difference of two histories over the largest change of the second.
fn apart(one: &[f64], other: &[f64]) -> f64 {
    let most = one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    most / FlightHistory::peak(&change(other))
}

fn looked_at(history: &FlightHistory) -> [(&'static str, &[f64]); 7] {
    [
        ("alpha", &history.alpha_deg),
        ("load factor", &history.load_factor),
        ("tip deflection", &history.tip_deflection_m),
        ("tip acceleration", &history.tip_acceleration_m_s2),
        ("pitch rate", &history.rates_deg_s[1]),
        ("right Mx", &history.root_right[1]),
        ("left My", &history.root_left[2]),
    ]
}

#[test]
fn small_inputs_give_what_the_linearised_equations_give() {
    let wave = OneMinusCosine::new(2e-3, 3.0, 0.1);
    let gust = Gust { velocity_m_s: 0.05, length_m: 6.0, start_s: 0.3 };
    let flying = flying(&["outer", "elevator", "rudder"], Some(gust));
    let commands: [&dyn Signal; 3] = [&wave, &wave, &wave];
    let whole = flying.fly(&commands, 2.0, &Integration::default()).unwrap();
    let sampled = vec![maneuver::motion::sampled(&wave, 0.001, 2001); 3];
    let small = FreeFlight::of(flying).fly_at(0.001, &sampled, 2001);
    for ((name, full), (_, linear)) in looked_at(&whole).into_iter().zip(looked_at(&small)) {
        let off = apart(full, linear);
        println!("{name}: {off:.2e}");
        assert!(off < 0.005, "{name}: {off}");
    }
    for (name, full, linear) in [
        ("roll rate", &whole.rates_deg_s[0], &small.rates_deg_s[0]),
        ("yaw rate", &whole.rates_deg_s[2], &small.rates_deg_s[2]),
        ("sideslip", &whole.beta_deg, &small.beta_deg),
        ("rudder", &whole.others[1].deflection_deg, &small.others[1].deflection_deg),
        ("airspeed", &whole.v_m_s, &small.v_m_s),
    ] {
        let off = apart(full, linear);
        println!("{name}: {off:.2e}");
        assert!(off < 0.005, "{name}: {off}");
    }
}

#[test]
fn halved_steps_and_tolerances_change_no_peak_by_a_thousandth() {
    let file = &whole().file;
    let doublet: &dyn Signal = file.doublet.kind();
    let flying = flying(&["outer"], None);
    let coarse = Integration::default();
    let fine = Integration {
        time_step_s: 0.5 * coarse.time_step_s,
        relative: 0.5 * coarse.relative,
        absolute: 0.5 * coarse.absolute,
        longest_step_s: 0.5 * coarse.longest_step_s,
    };
    let [coarse, fine] = [coarse, fine].map(|settings| flying.fly(&[doublet], 1.0, &settings).unwrap());
    let linear = FreeFlight::of(flying);
    let [half, whole] = [(0.0005, 2001), (0.001, 1001)].map(|(step, samples)| {
        linear.fly_at(step, &[maneuver::motion::sampled(doublet, step, samples)], samples)
    });
    for (one, two, kind, limit) in [(&coarse, &fine, "nonlinear", 1e-3), (&whole, &half, "linear", 1e-3)] {
        for ((name, a), (_, b)) in looked_at(one).into_iter().zip(looked_at(two)) {
            let [a, b] = [a, b].map(|values| FlightHistory::peak(&change(values)));
            println!("{kind} {name}: {a} {b}");
            if b > 1e-6 {
                assert!((a - b).abs() < limit * b, "{kind} {name}: {a} {b}");
            }
        }
    }
}

#[test]
fn loads_over_the_whole_aircraft_balance_mass_times_acceleration() {
    let gust = Gust { velocity_m_s: 3.0, length_m: 6.0, start_s: 0.2 };
    let flying = flying(&["outer", "elevator", "rudder"], Some(gust));
    let doublet = Doublet { height: 0.15, frequency_hz: 2.0, start_s: 0.1 };
    let commands: [&dyn Signal; 3] = [&doublet; 3];
    let history = flying.fly(&commands, 1.0, &Integration::default()).unwrap();
    let weight_n = whole().mass.mass_kg * 9.806_65;
    let force = FlightHistory::peak(&history.unbalanced[0]);
    println!("force {force:e} of {weight_n}");
    assert!(force < 1e-6 * weight_n, "{force} N of {weight_n} N");
    let bending = FlightHistory::peak(&change(&history.root_right[1]));
    for moment in &history.unbalanced[1..] {
        let moment = FlightHistory::peak(moment);
        println!("moment {moment:e} of {bending}");
        assert!(moment < 1e-6 * bending, "{moment} N m beside root bending of {bending} N m");
    }
}

#[test]
fn an_upward_gust_bends_both_wings_up_and_an_aileron_one_up_and_one_down() {
    let gust = Gust { velocity_m_s: 2.0, length_m: 5.0, start_s: 0.1 };
    let history = flying(&[], Some(gust)).fly(&[], 0.6, &Integration::default()).unwrap();
    let peak = history.load_factor.iter().copied().fold(f64::MIN, f64::max);
    assert!(peak > 1.2, "{peak}");
    let most = |values: &[f64]| {
        change(values).into_iter().fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a })
    };
    let [right, left] = [&history.root_right, &history.root_left];
    assert!(right[0][0] > 0.0 && right[1][0] > 0.0 && left[0][0] > 0.0 && left[1][0] < 0.0);
    assert!(most(&right[0]) > 0.0 && most(&left[0]) > 0.0, "lift");
    assert!(most(&right[1]) > 0.0 && most(&left[1]) < 0.0, "bending");
    // the nose meets it first, the centre of gravity 1.1 m later
    let met = history.gust_m_s.iter().position(|w| *w > 0.0).unwrap();
    assert_near("when the centre meets it", history.t_s[met], 0.1 + 1.09 / 25.7, 0.03);

    let step = OneMinusCosine::new(0.1, 4.0, 0.0);
    let history = flying(&["outer"], None).fly(&[&step], 0.12, &Integration::default()).unwrap();
    let last = history.t_s.len() - 1;
    let of = |side: &[Vec<f64>; 3], row: usize| side[row][last] - side[row][0];
    assert!(history.aileron_deg[last] > 2.0);
    let [right, left] = [&history.root_right, &history.root_left];
    // antisymmetric: lift to opposite sides, bending moments about the same axis to the same
    assert_near("lift", of(left, 0), -of(right, 0), 0.01);
    assert_near("bending", of(left, 1), of(right, 1), 0.01);
    assert!(history.rates_deg_s[0][last] < 0.0 && history.angles_deg[0][last] < 0.0);
}

#[test]
fn a_symmetric_input_has_no_antisymmetric_answer() {
    let gust = Gust { velocity_m_s: 3.0, length_m: 8.0, start_s: 0.2 };
    let flying = flying(&["elevator"], Some(gust));
    let doublet = Doublet { height: 0.1, frequency_hz: 2.0, start_s: 0.1 };
    let history = flying.fly(&[&doublet], 2.0, &Integration::default()).unwrap();
    let pitch = FlightHistory::peak(&history.rates_deg_s[1]);
    assert!(pitch > 5.0, "{pitch}");
    for (name, values, size) in [
        ("roll rate", &history.rates_deg_s[0], pitch),
        ("yaw rate", &history.rates_deg_s[2], pitch),
        ("sideslip", &history.beta_deg, FlightHistory::peak(&change(&history.alpha_deg))),
    ] {
        let most = FlightHistory::peak(values);
        println!("{name} {:e}", most / size);
        assert!(most < 1e-9 * size, "{name}: {most} beside {size}");
    }
    for (row, sign) in [(0, 1.0), (1, -1.0), (2, 1.0)] {
        let size = FlightHistory::peak(&history.root_right[row]);
        let pairs = history.root_right[row].iter().zip(&history.root_left[row]);
        let most = pairs.map(|(right, left)| (right - sign * left).abs()).fold(0.0, f64::max);
        println!("load {row} {:e}", most / size);
        assert!(most < 1e-9 * size, "load {row}: {most} beside {size}");
    }
}

#[test]
fn the_air_does_no_work_on_the_flight_path_and_nothing_moves_without_input() {
    // no drag and no thrust: v²/2 + g z stays
    let wave = OneMinusCosine::new(-0.08, 0.5, 0.0);
    let flying = flying(&["elevator"], None);
    let history = flying.fly(&[&wave], 3.0, &Integration::default()).unwrap();
    let energy = |k: usize| 0.5 * history.v_m_s[k].powi(2) + 9.806_65 * history.place_m[2][k];
    let highest = FlightHistory::peak(&history.place_m[2]);
    assert!(highest > 2.0, "{highest}");
    for k in 0..history.t_s.len() {
        assert!((energy(k) - energy(0)).abs() < 1e-6 * energy(0), "{}", history.t_s[k]);
    }
    let still = flying.fly(&[&Step { height: 0.0, start_s: 0.0 }], 2.0, &Integration::default()).unwrap();
    for (name, values) in looked_at(&still) {
        let most = FlightHistory::peak(&change(values));
        println!("still {name} {most:e}");
        // what the integrator's tolerance makes of the fastest modes
        assert!(most < 2e-4 * FlightHistory::peak(values).max(1.0), "{name}: {most}");
    }
}

#[test]
fn a_rigid_aircraft_s_short_period_and_phugoid_are_those_of_the_textbook_s_system() {
    let aircraft = whole();
    let (model, trimmed) = (aircraft.uncorrected(), trimmed());
    let rigid = air().rigid_and_quasi_steady(aircraft);
    let flying = FlyingAircraft::new(&model, &rigid, &trimmed, Vec::new(), None).unwrap();
    let found = FreeFlight::of(flying).eigenvalues().unwrap();
    let (v, q_pa) = (trimmed.point.v_m_s, model.flow(&trimmed.point).dynamic_pressure_pa());
    let wing = &aircraft.flow;
    let loads = |w: Vec<f64>| -> Mat<f64> {
        let cp = wing.pressures(MatRef::from_column_major_slice(&w, w.len(), 1));
        &wing.root_rows * wing.integration.corrected(&model.corrections).of_pressures(q_pa, cp.as_ref())
    };
    let alpha = loads(incidence::angle_of_attack(&wing.lattice));
    let rate = loads(incidence::rotation_rate(&wing.lattice, &Vector3::y(), &aircraft.mass.centre, v));
    let (m, g, i_yy) = (aircraft.mass.mass_kg, 9.806_65, aircraft.mass.inertia_kg_m2[(1, 1)]);
    let lift = trimmed.fz_n;
    // Etkin, Dynamics of Atmospheric Flight (1972), sec. 5.10: stability axes, lift without drag, no M_u, no rate of alpha
    let (x_w, z_u, z_w, z_q) = (lift / v, -2.0 * lift / v, -alpha[(0, 0)] / v, -rate[(0, 0)]);
    let (m_w, m_q) = (alpha[(2, 0)] / v, rate[(2, 0)]);
    #[rustfmt::skip]
    let system = Matrix4::new(
        0.0,      x_w / m,    0.0,          -g,
        z_u / m,  z_w / m,    v + z_q / m,  0.0,
        0.0,      m_w / i_yy, m_q / i_yy,   0.0,
        0.0,      0.0,        1.0,          0.0,
    );
    let expected = system.complex_eigenvalues();
    println!("{expected}");
    for value in &expected {
        let nearest = found.iter().map(|f| (f[0] - value.re).hypot(f[1] - value.im)).fold(f64::MAX, f64::min);
        println!("{value}: {nearest:e}");
        assert!(nearest < 1e-5 * value.norm(), "{value} is {nearest} from the nearest of {found:?}");
    }
    // Nelson, Flight Stability and Automatic Control, short period: constant speed
    let short = (z_w * m_q / (m * i_yy) - v * m_w / i_yy).sqrt();
    let fast = expected.iter().map(|value| value.norm()).fold(0.0, f64::max);
    assert_near("short period", fast, short, 0.05);
    // phugoid: the last two coefficients of the quartic; Lanchester's sqrt(2) g/v is its limit without damping in pitch
    let slow = expected.iter().map(|value| value.norm()).fold(f64::MAX, f64::min);
    let stiff = -v * m_w;
    let phugoid = 2.0_f64.sqrt() * g / v * (stiff / (stiff + z_w * m_q / m)).sqrt();
    println!("short period {fast} {short}, phugoid {slow} {phugoid}");
    assert_near("phugoid", slow, phugoid, 0.05);
}

#[test]
fn the_rational_air_follows_the_doublet_lattice_between_its_frequencies() {
    let columns = air().columns;
    let ranges =
        [0..5, 5..columns.control(0), columns.control(0)..columns.gust(0), columns.gust(0)..columns.count()];
    // rigid motions, modes, controls, gust stations: the limits of `unsteady.rs`
    for (k, limits) in
        [(0.04, [0.02, 0.01, 0.01, 0.04]), (0.13, [0.03, 0.01, 0.01, 0.05]), (0.32, [0.06, 0.03, 0.03, 0.12])]
    {
        let errors = air().error_at(whole(), k).unwrap();
        for (range, limit) in ranges.iter().zip(limits) {
            let entries = range.clone().flat_map(|j| (0..errors.nrows()).map(move |i| (i, j)));
            let worst = entries.map(|at| errors[at]).fold(0.0, f64::max);
            println!("k {k}, columns {range:?}: {worst}");
            assert!(worst < limit, "k {k}, columns {range:?}: {worst}");
        }
    }
}
