//! Dynamic maneuvers: laws that any aircraft obeys, and the size of the answer to a doublet.

use crate::common::{air, assert_near, whole, wings};
use fullaircraft::{FlightAir, FlightHistory, FlyingAircraft, FreeFlight, Integration};
use maneuver::motion::Doublet;
use nalgebra::Vector3;

#[test]
fn without_input_nothing_moves() {
    let (aircraft, model) = (whole(), whole().uncorrected());
    let trimmed = model.trim("trim", &aircraft.file.trim).unwrap();
    let history = FreeFlight::new(&model, air(), &trimmed, "outer").unwrap().fly(&[0.0; 200]);
    assert!(
        history
            .tip_acceleration_m_s2
            .iter()
            .chain(history.tip_rates_deg_s.iter().flatten())
            .all(|v| *v == 0.0)
    );
    // not a bit of change, and the trim's own numbers up to the last digits of another order of sums
    let still = |values: &[f64], trimmed: f64| {
        values.iter().all(|value| *value == values[0]) && (values[0] - trimmed).abs() < 1e-14 * trimmed.abs()
    };
    assert!(still(&history.alpha_deg, trimmed.alpha_rad.to_degrees()));
    assert!(still(&history.root_right[0], trimmed.root_loads[0].fz_n));
    // The accelerometer sits a little inboard of the tip.
    let tip_m = trimmed.tip_deflection_m[0];
    assert!(history.tip_deflection_m[0] > 0.9 * tip_m && history.tip_deflection_m[0] < tip_m);
}

#[test]
fn an_antisymmetric_doublet_rolls_the_aircraft_and_leaves_symmetric_motion_alone() {
    let (aircraft, model) = (whole(), whole().uncorrected());
    let trimmed = model.trim("trim", &aircraft.file.trim).unwrap();
    let flight = FreeFlight::new(&model, air(), &trimmed, aircraft.file.doublet.control().unwrap()).unwrap();
    let history = flight.fly_motion(&aircraft.file.doublet);
    let change = |values: &[f64]| values.iter().map(|v| v - values[0]).collect::<Vec<f64>>();
    assert!(FlightHistory::peak(&change(&history.alpha_deg)) < 1e-6);
    let (right, left) = (change(&history.root_right[0]), change(&history.root_left[0]));
    let size = FlightHistory::peak(&right);
    assert!(size > 1.0 && right.iter().zip(&left).all(|(r, l)| (r + l).abs() < 1e-6 * size));
    // Right trailing edge down first: the right wing goes up, a negative roll rate.
    let early = history.t_s.iter().position(|t| *t > 0.13).unwrap();
    assert!(history.aileron_deg[early] > 5.0 && history.tip_rates_deg_s[0][early] < -1.0);
    assert_near("largest aileron", FlightHistory::peak(&history.aileron_deg), 10.0, 0.10);
    let last = history.t_s.len() - 1;
    assert!(history.aileron_deg[last].abs() < 1e-3 && history.tip_acceleration_m_s2[last].abs() < 0.1);
}

#[test]
fn a_steady_aileron_gives_the_roll_rate_at_which_roll_damping_balances_it() {
    // After the transient the rolling moment of the ailerons and that of the roll rate cancel: no acceleration, and
    // with it no inertia in the root loads, while the roll rate stays.
    let (aircraft, model) = (whole(), whole().uncorrected());
    let trimmed = model.trim("trim", &aircraft.file.trim).unwrap();
    let flight = FreeFlight::new(&model, air(), &trimmed, "outer").unwrap();
    let history = flight.fly(&vec![0.02; 1200]);
    let (k, roll) = (1199, &history.tip_rates_deg_s[0]);
    assert!(roll[k] < 0.0, "right wing up: {}", roll[k]);
    let per_s = (roll[k] - roll[k - 200]).abs() / roll[k].abs() / 0.2;
    assert!(per_s < 0.2, "the roll rate still changes by {per_s} of itself per second");
    let twice = flight.fly(&vec![0.04; 1200]);
    assert_near("linearity", twice.tip_rates_deg_s[0][k], 2.0 * roll[k], 1e-9);
}

#[test]
fn a_control_that_is_not_there_is_named_with_those_that_are() {
    let (aircraft, model) = (whole(), whole().uncorrected());
    let trimmed = model.trim("trim", &aircraft.file.trim).unwrap();
    let error = FreeFlight::new(&model, air(), &trimmed, "outr").unwrap_err().to_string();
    assert!(error.contains("outr") && error.contains("L_outer"), "{error}");
}

#[test]
fn the_tail_makes_the_aircraft_stable() {
    // The centre of gravity (0.40 m) lies behind the aerodynamic centre of the wings (0.368 m, independent program), so
    // wings alone must diverge in pitch within a second or so; the tail is sized to prevent that.
    let growth = |aircraft: &fullaircraft::Aircraft, air: &FlightAir| {
        let model = aircraft.uncorrected();
        let trimmed = model.trim("trim", &aircraft.file.trim).unwrap();
        let flight = FreeFlight::new(&model, air, &trimmed, "outer").unwrap();
        (flight.growth_rate_per_s().unwrap(), flight.warning("doublet", 2.0))
    };
    let (alone, warning) = growth(wings(), &FlightAir::new(wings()).unwrap());
    assert!(alone > 1.0, "{alone}");
    assert!(warning.unwrap().contains("unstable"));
    let (whole, warning) = growth(whole(), air());
    assert!(whole < 0.1 * alone, "{whole}");
    assert_eq!(warning, None);
}

#[test]
fn angles_follow_the_rates_and_the_path_follows_the_angles() {
    let (aircraft, model) = (whole(), whole().uncorrected());
    let trimmed = model.trim("trim", &aircraft.file.trim).unwrap();
    let drives = ["rudder", "outer", "elevator"].map(|name| aircraft.drive(name).unwrap()).to_vec();
    let flying = FlyingAircraft::new(&model, air(), &trimmed, drives, None).unwrap();
    let [rudder, outer, elevator] = [(0.2, 0.5), (-0.1, 0.7), (-0.05, 1.0)]
        .map(|(height, frequency_hz)| Doublet { height, frequency_hz, start_s: 0.0 });
    let history = flying.fly(&[&rudder, &outer, &elevator], 2.0, &Integration::default()).unwrap();
    // the rudder's trailing edge to the right turns the nose right
    let early = history.t_s.iter().position(|t| *t > 0.4).unwrap();
    assert!(history.rates_deg_s[2][early] > 1.0 && history.angles_deg[2][early] > 0.1);
    let rad = |values: &[Vec<f64>; 3], k: usize| [0, 1, 2].map(|axis| values[axis][k].to_radians());
    let change = |values: &[f64], k: usize| {
        (values[k + 1] - values[k - 1]) / (history.t_s[k + 1] - history.t_s[k - 1])
    };
    let mut largest = [0.0_f64; 3];
    for k in (50..1950).step_by(50) {
        let ([p, q, r], [roll, pitch, yaw]) = (rad(&history.rates_deg_s, k), rad(&history.angles_deg, k));
        let ((s, c), (s_p, c_p), (s_y, c_y)) = (roll.sin_cos(), pitch.sin_cos(), yaw.sin_cos());
        // Etkin, Dynamics of Atmospheric Flight (1972), eq. 4.5,4
        let about_the_vertical = (q * s + r * c) / c_p;
        let law = [p + about_the_vertical * s_p, q * c - r * s, about_the_vertical];
        for (axis, law) in law.into_iter().enumerate() {
            let found = change(&history.angles_deg[axis], k).to_radians();
            assert!((found - law).abs() < 2e-4, "angle {axis} at {k} ms: {found} rad/s for {law}");
            largest[axis] = largest[axis].max(law.abs());
        }
        // the right wing as the earth sees it (back, right, up), and the wind on it
        let wing = Vector3::new(-(s * s_p * c_y - c * s_y), s * s_p * s_y + c * c_y, -s * c_p);
        let velocity = Vector3::from_fn(|axis, _| change(&history.place_m[axis], k));
        assert_near("airspeed", velocity.norm(), history.v_m_s[k], 1e-5);
        let wind = history.v_m_s[k] * history.beta_deg[k].to_radians().sin();
        assert!((velocity.dot(&wing) - wind).abs() < 1e-3, "{k} ms: {} m/s for {wind}", velocity.dot(&wing));
    }
    assert!(largest.iter().all(|rate| *rate > 0.05), "all three angles changed: {largest:?} rad/s");
    assert!(FlightHistory::peak(&history.beta_deg) > 0.5, "and the wind came from the side");
}

#[test]
fn the_same_gust_everywhere_is_an_angle_of_attack() {
    let (air, still) = (air(), &air().incidence.still);
    for j in 0..still.nrows() {
        let gusts: f64 = (0..air.columns.gusts).map(|station| still[(j, air.columns.gust(station))]).sum();
        assert!((gusts - still[(j, 0)]).abs() < 1e-14, "box {j}: {gusts} for {}", still[(j, 0)]);
    }
}
