//! Laws of flight on an aircraft that is assembled within milliseconds: balance, linearisation, superposition,
//! symmetry, turbulence.

use crate::aircraft::file::FlightPoint;
use crate::aircraft::small::{air, aircraft};
use crate::flight::gust::{Gust, GustAxis};
use crate::flight::history::FlightHistory;
use crate::flight::loads::{FlightLoads, FlownLoads, LoadedTrim};
use crate::flight::model::FlyingAircraft;
use crate::flight::nonlinear::Integration;
use crate::flight::rows::{LoadParts, PRODUCTS, momentum};
use crate::flight::small_motions::FreeFlight;
use crate::stations::nodal::Component;
use crate::stations::places::Station;
use crate::trim::case::TrimTools;
use crate::trim::maneuvers::Steady;
use crate::trim::model::Trimmed;
use faer::c64;
use loads::design::Spectrum;
use loads::turbulence::{Grid, Turbulence};
use maneuver::Signal;
use maneuver::motion::{Doublet, OneMinusCosine};
use nalgebra::Vector3;
use std::f64::consts::PI;

const V_M_S: f64 = 30.0;
const GUST: Gust = Gust { velocity_m_s: 2.0, length_m: 6.0, start_s: 0.02 };

fn stations() -> Vec<Station> {
    let mut all = aircraft().wing_stations(&[]).expect("they are on the wing");
    all.extend(aircraft().body_stations());
    all
}

/// Loads in flight from level flight with ailerons and a rudder, in steps of two milliseconds.
fn flying(axis: GustAxis, then: impl FnOnce(&FlightLoads<'_>, &Trimmed)) {
    let tools = TrimTools::new(aircraft(), &[]).expect("stations");
    let model = aircraft().uncorrected();
    let at = tools.at(&model, V_M_S).expect("it does not diverge");
    let found = at.solve(&Steady::Level.case(&aircraft().file, V_M_S)).expect("it is trimmed");
    let trimmed = at.trimmed(&found, &FlightPoint { v_m_s: V_M_S, load_factor: 1.0, pitch_rate_deg_s: 0.0 });
    let drives = ["outer", "rudder"].map(|name| aircraft().drive(name).expect("a control")).to_vec();
    let steady = at.nodal_loads(&found);
    let trim = LoadedTrim { model: &model, air: air(), trimmed: &trimmed, steady, drives, axis };
    then(&FlightLoads::new(trim, stations(), 0.002).expect("it flies"), &trimmed);
}

/// Net loads of all stations at a sample.
fn net(flown: &FlownLoads<'_>, sample: usize) -> Vec<f64> {
    (0..stations().len()).flat_map(|at| flown.at_station(at, Component::Net, sample)).collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| f64::max(most, value.abs()))
}

#[test]
fn nodal_loads_in_flight_add_up_to_the_stations_and_are_in_balance_as_a_whole() {
    for axis in [GustAxis::Vertical, GustAxis::Lateral] {
        flying(axis, |flight, _| {
            let commands = vec![vec![0.1; 90], vec![-0.05; 90]];
            let flown = flight.fly(Some(GUST), &commands, 90);
            let points = aircraft().free.points();
            for sample in [0, 30, 89] {
                let loads = flown.nodal_loads(sample);
                let scale = largest(&loads.of(Component::Air));
                for (at, station) in flight.stations().iter().enumerate() {
                    for component in Component::ALL {
                        let sum = station.sums(points, &loads.of(component));
                        let rows = flown.at_station(at, component, sample);
                        let off = largest(&[0, 1, 2, 3, 4, 5].map(|load| sum[load] - rows[load]));
                        let what = format!("{} {} at {sample}", station.name, component.name());
                        assert!(off < 1e-8 * scale, "{what}: {sum:?} {rows:?}");
                    }
                    if station.name == "whole" {
                        let net = largest(&station.sums(points, &loads.of(Component::Net)));
                        assert!(net < 1e-6 * scale, "balance at {sample}: {net} of {scale}");
                    }
                }
            }
            let change: Vec<f64> = net(&flown, 89).iter().zip(net(&flown, 0)).map(|(a, b)| a - b).collect();
            assert!(largest(&change) > 1.0, "they change");
        });
    }
}

#[test]
fn loads_of_a_gust_and_of_commands_superpose_and_gusts_side_by_side_are_those_one_by_one() {
    flying(GustAxis::Vertical, |flight, _| {
        let commands = vec![vec![0.1; 60], vec![-0.05; 60]];
        let both = flight.fly(Some(GUST), &commands, 60);
        let parts = [flight.fly(Some(GUST), &[], 60), flight.fly(None, &commands, 60)];
        let still = flight.fly(None, &[], 60);
        let longer = Gust { length_m: 9.0, velocity_m_s: -1.0, start_s: 0.0 };
        let beside = flight.fly_gusts(&[GUST, longer], 60);
        for sample in [0, 20, 59] {
            let trim: Vec<f64> =
                (0..stations().len()).flat_map(|at| flight.at_trim(at, Component::Net)).collect();
            let scale = largest(&net(&both, 59));
            let same = |what: &str, one: &[f64], other: &[f64]| {
                let off: Vec<f64> = one.iter().zip(other).map(|(a, b)| a - b).collect();
                assert!(largest(&off) < 1e-9 * scale, "{what} at {sample}");
            };
            let sum: Vec<f64> = (net(&parts[0], sample).iter().zip(net(&parts[1], sample)).zip(&trim))
                .map(|((gust, command), trim)| gust + command - trim)
                .collect();
            same("both", &net(&both, sample), &sum);
            same("nothing", &net(&still, sample), &trim);
            same("beside one another", &net(&beside[0], sample), &net(&parts[0], sample));
            same("the longer", &net(&beside[1], sample), &net(&flight.fly(Some(longer), &[], 60), sample));
        }
        assert!(both.t_s.len() == 60 && (both.t_s[59] - 0.118).abs() < 1e-12);
        let root = |sample: usize| parts[0].at_station(0, Component::Net, sample)[3];
        let [low, high] = parts[0].ends(0, 3);
        assert!((0..60).all(|sample| root(low) <= root(sample) && root(sample) <= root(high)));
        assert!((0..60).all(|at| parts[0].tip_deflection_m(at)[0] - parts[0].tip_deflection_m(at)[1] < 1e-9));
    });
}

fn trimmed() -> Trimmed {
    aircraft().uncorrected().trim("trim", &aircraft().file.trim).expect("it is trimmed")
}

fn free(names: &[&str], gust: Option<Gust>) -> FlyingAircraft {
    let drives = names.iter().map(|name| aircraft().drive(name).expect("a control")).collect();
    FlyingAircraft::new(&aircraft().uncorrected(), air(), &trimmed(), drives, gust).expect("it flies")
}

/// What is looked at of a flight.
fn looked_at(history: &FlightHistory) -> Vec<(String, Vec<f64>)> {
    let mut all: Vec<(String, Vec<f64>)> =
        history.columns().into_iter().map(|(name, values)| (name, values.to_vec())).collect();
    for unit in &history.units {
        all.push((format!("{} height", unit.name), unit.deflection_m.clone()));
        for axis in 0..3 {
            all.push((format!("{} acceleration {axis}", unit.name), unit.acceleration_m_s2[axis].clone()));
            all.push((format!("{} rate {axis}", unit.name), unit.rates_deg_s[axis].clone()));
        }
    }
    all
}

#[test]
fn small_inputs_give_what_the_linearised_equations_give_in_every_channel() {
    let wave = OneMinusCosine::new(2e-3, 8.0, 0.02);
    let names = ["outer", "elevator", "rudder"];
    let flying = free(&names, None);
    let commands: [&dyn Signal; 3] = [&wave; 3];
    let whole = flying.fly(&commands, 0.3, &Integration::default()).expect("it flies");
    let sampled = vec![maneuver::motion::sampled(&wave, 0.001, 301); 3];
    let linear = FreeFlight::of(flying).fly_at(0.001, &sampled, 301);
    assert_eq!(whole.units.len(), 9, "four on each wing and one at the centre");
    let mut seen = 0;
    for ((name, full), (_, small)) in looked_at(&whole).into_iter().zip(looked_at(&linear)) {
        let change =
            |values: &[f64]| largest(&values.iter().map(|value| value - values[0]).collect::<Vec<_>>());
        let off = largest(&full.iter().zip(&small).map(|(a, b)| a - b).collect::<Vec<_>>());
        let scale = change(&full).max(1e-9 * largest(&full));
        if change(&full) > 1e-7 * largest(&full) {
            seen += 1;
            assert!(off < 0.02 * scale, "{name}: {off} of {scale}");
        }
    }
    assert!(seen > 60, "{seen} channels move");
}

#[test]
fn loads_over_the_whole_aircraft_balance_mass_times_acceleration_in_any_flight() {
    let doublet = Doublet { height: 0.2, frequency_hz: 4.0, start_s: 0.02 };
    let commands: [&dyn Signal; 3] = [&doublet; 3];
    let history =
        free(&["outer", "elevator", "rudder"], Some(GUST)).fly(&commands, 0.3, &Integration::default());
    let history = history.expect("it flies");
    let weight_n = aircraft().mass.mass_kg * 9.806_65;
    let bending = largest(&history.root_right[1]);
    assert!(largest(&history.unbalanced[0]) < 1e-6 * weight_n, "{}", largest(&history.unbalanced[0]));
    for moment in &history.unbalanced[1..] {
        assert!(largest(moment) < 1e-6 * bending, "{} of {bending}", largest(moment));
    }
    // the gust reaches the centre of gravity that far behind its first station, at the airspeed of the trim
    let behind_m = aircraft().mass.centre.x - air().gust_x_m[0];
    for (t_s, met) in history.t_s.iter().zip(&history.gust_m_s) {
        let into = (aircraft().file.trim.v_m_s * (t_s - GUST.start_s) - behind_m) / GUST.length_m;
        let law = if (0.0..1.0).contains(&into) { 1.0 - (2.0 * PI * into).cos() } else { 0.0 };
        assert!((met - law).abs() < 0.02, "{t_s} s: {met} m/s, {law}");
    }
    assert!(largest(&history.gust_m_s) > 1.9, "it has passed");
}

#[test]
fn states_and_inputs_are_counted_and_a_flight_without_input_stays_in_trim() {
    let flight = FreeFlight::of(free(&["outer"], Some(GUST)));
    let (modes, stations) = (air().modes.elastic(), air().gust_x_m.len());
    let motions = 5 + modes + 1 + stations;
    // twelve rigid ones, modes and a drive with their rates, ten lags a motion
    assert_eq!(flight.states(), 12 + 2 * modes + 2 + 10 * motions);
    assert_eq!((flight.a.ncols(), flight.b.ncols()), (flight.states(), 1 + 2 * stations));
    let (speed, history) =
        (aircraft().file.trim.v_m_s, FreeFlight::of(free(&["outer"], None)).fly(&[0.0; 40]));
    assert_eq!(flight.v_m_s(), speed);
    let still =
        |values: &[f64], law: f64| values.iter().all(|value| (value - law).abs() < 1e-9 * law.abs().max(1.0));
    let trim = trimmed();
    assert!(still(&history.v_m_s, speed) && still(&history.alpha_deg, trim.alpha_rad.to_degrees()));
    let [right, left] = [0, 1].map(|side| trim.root_loads[side].to_array());
    for load in 0..3 {
        assert!(still(&history.root_right[load], right[load]), "{:?} {right:?}", history.root_right[load][0]);
        assert!(still(&history.root_left[load], left[load]));
    }
    assert!(history.load_factor.iter().all(|n| (n - 1.0).abs() < 1e-6), "{:?}", history.load_factor[0]);
    for (t_s, back_m) in history.t_s.iter().zip(&history.place_m[0]) {
        assert!((back_m + speed * t_s).abs() < 1e-9, "{back_m} m back after {t_s} s");
    }
}

#[test]
fn units_on_board_feel_their_weight_in_trim_and_an_aileron_moves_one_wing_against_the_other() {
    let flight = FreeFlight::of(free(&["outer"], None));
    let still = flight.fly(&[0.0; 3]);
    assert_eq!(still.units.last().map(|unit| unit.name.as_str()), Some("centre"));
    for unit in &still.units {
        let felt = [0, 1, 2].map(|axis| unit.acceleration_m_s2[axis][0]);
        let size = felt.iter().map(|a| a * a).sum::<f64>().sqrt();
        // a slope of the structure turns what is felt, in the first order of the slope
        assert!(felt[2] > 9.0 && (size - 9.806_65).abs() < 0.2, "{}: {felt:?}", unit.name);
        assert!((0..3).all(|axis| unit.rates_deg_s[axis][0].abs() < 1e-9), "{}", unit.name);
    }
    assert!(still.units[8].deflection_m[0].abs() < 1e-12 && still.units[0].deflection_m[0] > 0.0);
    let rolling = flight.fly(&[0.01; 60]);
    let change = |values: &[f64]| values.iter().map(|value| value - values[0]).collect::<Vec<_>>();
    for (load, sign) in [(0, -1.0), (1, 1.0), (2, -1.0)] {
        let [right, left] = [&rolling.root_right, &rolling.root_left].map(|loads| change(&loads[load]));
        let size = largest(&right);
        assert!(size > 1e-3, "load {load} changes");
        for (one, other) in right.iter().zip(&left) {
            assert!((one - sign * other).abs() < 1e-6 * size, "load {load}: {one} {other}");
        }
    }
    let angle = rolling.aileron_deg[59];
    assert!(angle > 0.0 && rolling.command_deg[59] == 0.01_f64.to_degrees());
}

#[test]
fn a_gust_in_time_is_the_sum_of_its_waves_in_turbulence() {
    flying(GustAxis::Vertical, |flight, _| {
        let held = flight.held();
        let grid = || Grid::new(V_M_S, 762.0, 10.0, &[], 2.0);
        let turbulence = Turbulence { v_m_s: V_M_S, scale_m: 762.0, spectrum: Spectrum::Karman };
        let rough = flight.in_turbulence(&held, turbulence, grid());
        let response = rough.response();
        // vertical turbulence loads both wings alike: Fz the same, Mx opposite
        for (load, sign) in [(2, 1.0), (3, -1.0), (4, 1.0)] {
            let [right, left] = [0, 1].map(|side| rough.transfer(side, load));
            let size = right.iter().map(|value| value.norm()).fold(0.0, f64::max);
            for (one, other) in right.iter().zip(left) {
                assert!((one - other * sign).norm() < 1e-6 * size, "load {load}: {one} {other}");
            }
        }
        // mass times the whole's load factor is the air's lift: A of a slow wave is that of the load factor
        let whole = stations().len() - 1;
        let something = rough.is_something(&response);
        assert!(something[2] && something[3] && something[4] && !something[6 * whole + 1]);
        let count = 6 * stations().len();
        assert!(something[count] && something.len() == count + 1);
        assert!(response.a_bar(count) > 0.0 && response.a_bar(count) < 1.0);
        let limits = [true, false].map(|is_largest| crate::flight::turbulence::AtLimit {
            station: 0,
            along: GustAxis::Vertical.along()[1],
            is_largest,
        });
        let flown = rough.at_limits(&limits, 7.0);
        let trim = flight.at_trim(0, Component::Net)[3];
        for (sample, sign) in [(0, 1.0), (1, -1.0)] {
            let law = trim + sign * 7.0 * response.a_bar(3);
            let mx = flown.at_station(0, Component::Net, sample)[3];
            assert!((mx - law).abs() < 1e-6 * law.abs(), "{mx} {law}");
        }
        let zero = c64::new(0.0, 0.0);
        assert!(rough.transfer(0, 3).iter().any(|value| *value != zero));
    });
}

#[test]
fn momentum_of_the_whole_is_its_mass_and_inertia_and_that_of_rates_the_change_of_spin() {
    let aircraft = aircraft();
    let modes = &air().modes;
    let all = momentum(aircraft, modes);
    let whole = aircraft.body_stations().pop().expect("the whole is the last");
    let sums = whole.motions(&aircraft.free, &aircraft.mass.centre).transpose() * &all;
    let (mass, inertia) = (aircraft.mass.mass_kg, aircraft.mass.inertia_kg_m2);
    let scale = mass;
    for row in 0..6 {
        for column in 0..6 {
            let law = match (row / 3, column / 3) {
                (0, 0) if row == column => mass,
                (1, 1) => inertia[(row - 3, column - 3)],
                _ => 0.0,
            };
            assert!(
                (sums[(row, column)] - law).abs() < 1e-9 * scale,
                "{row} {column}: {}",
                sums[(row, column)]
            );
        }
        // mean axes: modes have no momentum
        for mode in 0..modes.elastic() {
            assert!(sums[(row, 6 + mode)].abs() < 1e-9 * scale, "mode {mode}");
        }
    }
    for (product, &(i, j)) in PRODUCTS.iter().enumerate() {
        let [a, b] = [i, j].map(|axis| Vector3::ith(axis, 1.0));
        let law =
            if i == j { a.cross(&(inertia * a)) } else { a.cross(&(inertia * b)) + b.cross(&(inertia * a)) };
        for axis in 0..3 {
            let column = 6 + modes.elastic() + product;
            assert!(sums[(axis, column)].abs() < 1e-9 * scale, "no force: {}", sums[(axis, column)]);
            assert!(
                (sums[(3 + axis, column)] - law[axis]).abs() < 1e-9 * scale,
                "product {i}{j}, moment {axis}"
            );
        }
    }
    let parts = LoadParts::new(aircraft, &all).expect("parts");
    assert_eq!(parts.names, ["right", "left", "half_right", "half_left", "whole"]);
    let root = aircraft.mass.centre - aircraft.root_point();
    assert!((parts.to_centre[0] - root).norm() < 1e-12 && parts.to_centre[4].norm() < 1e-12);
    for (part, station) in aircraft.wing_stations(&[]).expect("stations").iter().enumerate() {
        let points = aircraft.free.points();
        for column in 0..all.ncols() {
            let law = station.sums(points, all.col_as_slice(column));
            for row in 0..3 {
                assert!((parts.inertia[(3 * part + row, column)] - law[2 + row]).abs() < 1e-9 * scale);
            }
        }
    }
}
