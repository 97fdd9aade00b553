//! The reduced-order model is the rig: the same responses as its state space, the same steady loads as the steady wing.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{uneven, wing_with};
use aero::{Corrections, Flow};
use coupling::{ElasticWing, SteadyCase};
use faer::{Mat, c64};
use maneuver::rom::{Change, Constants, Drive, Driven, Outputs, ReducedOrderModel, ResponseTable};
use maneuver::{Actuator, Motion, Rig, RigSettings, Smooth};
use std::f64::consts::TAU;

fn flow(v_m_s: f64) -> Flow {
    Flow { v_m_s, rho_kg_m3: 1.225 }
}

/// Root pitch with gravity's share, then the controls: what [`maneuver::RigModel::frequency_response`] gives.
fn as_the_rig_gives_it(rom: &ReducedOrderModel, response: &Mat<c64>, servo: c64) -> Mat<c64> {
    Mat::from_fn(4, 1 + rom.controls.len(), |row, motion| match motion {
        0 => response[(row, Drive::PITCH)] + response[(row, Drive::G_SIN)] * rom.gravity_m_s2(),
        // its state space has the servo within
        control => response[(row, Drive::CONTROLS + control - 1)] * servo,
    })
}

#[test]
fn the_reduced_order_model_answers_as_its_state_space_does() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let corrections = uneven(&wing);
    for v_m_s in [0.0, 18.0, 34.0] {
        let model = rig.at(flow(v_m_s), &corrections).unwrap();
        let rom = ReducedOrderModel::new(&rig, flow(v_m_s), &corrections, None).unwrap();
        let omegas: Vec<f64> = [0.3, 2.0, 4.5, 9.0, 20.0].iter().map(|f| TAU * f).collect();
        let change = Change::none(rom.zones.len());
        let responses = rom.responses(&change, &omegas, true);
        for (omega, response) in omegas.iter().zip(&responses) {
            let (ours, theirs) = (
                as_the_rig_gives_it(&rom, response, Actuator::from(file.servos).response(*omega)),
                model.frequency_response(*omega),
            );
            for row in 0..4 {
                for column in 0..ours.ncols() {
                    let largest = (0..ours.ncols()).map(|j| theirs[(row, j)].norm()).fold(0.0, f64::max);
                    let off = (ours[(row, column)] - theirs[(row, column)]).norm();
                    // round-off of the state space, whose lags are far from the modes in size
                    assert!(
                        off < 1e-8 * largest,
                        "{v_m_s} m/s, {omega} rad/s, {row} by {column}: {off:e} of {largest:e}"
                    );
                }
            }
        }
    }
}

fn steady_difference(
    wing: &ElasticWing,
    rom: &ReducedOrderModel,
    corrections: &Corrections,
    v_m_s: f64,
) -> f64 {
    let change = Change::none(rom.zones.len());
    let rest = rom.at_rest(&change, &Constants::default(), false);
    let response = &rom.responses(&change, &[0.0], false)[0];
    let (alpha, g) = (0.06_f64, rom.gravity_m_s2());
    let ours = |row: usize| {
        rest[row]
            + response[(row, Drive::PITCH)].re * alpha
            + response[(row, Drive::G_SIN)].re * g * alpha.sin()
            + response[(row, Drive::G_COS)].re * g * alpha.cos()
    };
    let state = &wing.at(flow(v_m_s), corrections).unwrap().solve(&[SteadyCase::new(flow(v_m_s), alpha)])[0];
    let theirs = state.root.to_array();
    let loads = (0..3).map(|row| (ours(row) - theirs[row]).abs() / theirs[0].abs().max(1.0));
    let tip = (ours(Outputs::TIP) - state.tip_z_m).abs();
    loads.chain([tip]).fold(0.0, f64::max)
}

#[test]
fn at_rest_the_reduced_order_model_carries_the_steady_wing_s_loads() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    for corrections in [Corrections::neutral(wing.correctable.len()), uneven(&wing)] {
        for v_m_s in [0.0, 22.0, 34.0] {
            let rom = ReducedOrderModel::new(&rig, flow(v_m_s), &corrections, None).unwrap();
            let off = steady_difference(&wing, &rom, &corrections, v_m_s);
            assert!(off < 1e-9, "{v_m_s} m/s: {off:e}");
        }
    }
}

#[test]
fn a_factor_on_every_zone_is_that_factor_on_every_box_of_the_wing() {
    let (file, wing) = wing_with(|_| ());
    // few modes: what the truncated ones do statically is the only difference
    let settings = RigSettings { modes: 40, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
    let rig = Rig::new(&wing, settings).unwrap();
    let neutral = Corrections::neutral(wing.correctable.len());
    let factor = 0.1;
    let changed = Corrections {
        force: vec![1.0 + factor; neutral.len()],
        moment: vec![1.0 + factor; neutral.len()],
        ..neutral.clone()
    };
    let rom = ReducedOrderModel::new(&rig, flow(30.0), &neutral, None).unwrap();
    let direct = ReducedOrderModel::new(&rig, flow(30.0), &changed, None).unwrap();
    let none = Change::none(rom.zones.len());
    let change = Change { zone_force: vec![factor; rom.zones.len()], ..none.clone() };
    let omegas = [0.0, 12.0, 30.0];
    let (ours, theirs) = (rom.responses(&change, &omegas, true), direct.responses(&none, &omegas, true));
    for (a, b) in ours.iter().zip(&theirs) {
        for row in 0..3 {
            let largest = (0..2).map(|j| b[(row, j)].norm()).fold(0.0, f64::max);
            for column in 0..2 {
                let off = (a[(row, column)] - b[(row, column)]).norm() / largest;
                assert!(off < 1e-3, "{row} by {column}: {off:e}");
            }
        }
    }
}

/// A run of 3 s: a bell of root pitch or of a control, without kinks whose ringing would lie beyond the band.
fn motion(dt: f64, pitch: bool, controls: usize) -> Motion {
    let times: Vec<f64> = (0..4000).map(|i| f64::from(i) * dt).take_while(|t| *t < 3.0 + 0.5 * dt).collect();
    let (height, width) = (0.06, 0.09);
    let bell = |t: f64| height * (-((t - 1.0) / width).powi(2)).exp();
    let x = |t: f64| -2.0 * (t - 1.0) / width.powi(2);
    let of = |value: &dyn Fn(f64) -> f64| times.iter().map(|&t| value(t)).collect::<Vec<f64>>();
    let mut alpha = Smooth { value: vec![0.02; times.len()], rate: of(&|_| 0.0), second: of(&|_| 0.0) };
    let mut controls_rad = vec![vec![0.0; times.len()]; controls];
    if pitch {
        alpha = Smooth {
            value: of(&|t| 0.02 + bell(t)),
            rate: of(&|t| x(t) * bell(t)),
            second: of(&|t| (x(t).powi(2) - 2.0 / width.powi(2)) * bell(t)),
        };
    } else {
        controls_rad[0] = of(&bell);
    }
    Motion { time_step_s: dt, alpha, controls_rad }
}

#[test]
fn a_history_by_fourier_transform_is_the_one_stepped_in_time() {
    let (file, wing) = wing_with(|_| ());
    let rig = Rig::new(&wing, RigSettings::new(file.damping_ratio, file.pitch_axis_x())).unwrap();
    let corrections = uneven(&wing);
    for (v_m_s, pitch) in [(0.0, true), (22.0, true), (30.0, false)] {
        let model = rig.at(flow(v_m_s), &corrections).unwrap();
        let rom = ReducedOrderModel::new(&rig, flow(v_m_s), &corrections, None).unwrap();
        let change = Change::none(rom.zones.len());
        let table = ResponseTable::new(&rom, &change, &Constants::default(), false);
        // the stepped one has drives that are straight between samples: fine steps for it
        let (coarse, fine) =
            (motion(0.01, pitch, model.controls.len()), motion(0.001, pitch, model.controls.len()));
        let g = rom.gravity_m_s2();
        let sin: Vec<f64> = coarse.alpha.value.iter().map(|a| g * a.sin()).collect();
        let cos: Vec<f64> = coarse.alpha.value.iter().map(|a| g * a.cos()).collect();
        let pitch = Driven::new(Drive::PITCH, coarse.alpha.value.clone());
        let mut drives = vec![pitch, Driven::new(Drive::G_SIN, sin), Driven::new(Drive::G_COS, cos)];
        let servo = Actuator::from(file.servos);
        let controls = coarse.controls_rad.iter().map(|command| servo.follow(command, 0.01)).enumerate();
        drives.extend(controls.map(|(c, values)| Driven::new(Drive::CONTROLS + c, values)));
        let rows: Vec<usize> = (0..table.rest.len()).collect();
        let mut ours: Vec<Vec<f64>> =
            table.rest.iter().map(|rest| vec![*rest; coarse.alpha.value.len()]).collect();
        table.add_flown(&drives.iter().collect::<Vec<_>>(), 0.01, &rows, &mut ours);
        let theirs = model.fly(&fine);
        for (row, name) in ["Fz_N", "Mx_Nm", "My_Nm", "tip_z_m"].into_iter().enumerate() {
            let theirs: Vec<f64> = theirs.get(name).unwrap().iter().step_by(10).copied().collect();
            let swing = theirs.iter().map(|x| (x - theirs[0]).abs()).fold(1e-6, f64::max);
            let off = ours[row].iter().zip(&theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-3 * swing, "{v_m_s} m/s {name}: {off:.2e} of {swing:.2e}");
        }
    }
}
