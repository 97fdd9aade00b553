//! A model of three modes, two controls and three zones with arbitrary numbers, against the equations of the module.

use super::structural::Structural;
use super::{
    BALANCE, Change, Constants, Drive, Outputs, PointMass, ReducedOrderModel, StiffnessParts, Zones,
};
use crate::linear::Layout;
use crate::rig::Actuator;
use aero::Flow;
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

const MODES: usize = 3;
const MOTIONS: usize = 6;
const POLES: [&[f64]; 2] = [&[0.5, 2.0], &[1.3]];
/// Lags in the order of their columns: pole of its family (the third mode is a fast one) and motion.
const LAGS: [(f64, usize); 11] = [
    (0.5, 0),
    (0.5, 1),
    (0.5, 3),
    (0.5, 4),
    (0.5, 5),
    (2.0, 0),
    (2.0, 1),
    (2.0, 3),
    (2.0, 4),
    (2.0, 5),
    (1.3, 2),
];
const ONE: usize = 29;
const OMEGAS: [f64; 4] = [0.0, 7.0, 21.0, 50.0];

fn numbers(rows: usize, columns: usize, seed: usize, size: f64) -> Mat<f64> {
    Mat::from_fn(rows, columns, |i, j| size * ((13 * i + 5 * j + 7 * seed) as f64 * 1.7 + 0.3).sin())
}

/// Arbitrary numbers throughout.
pub(crate) fn small(v_m_s: f64) -> ReducedOrderModel {
    let layout = Layout { modes: MODES, slow_modes: 2, controls: 2, poles: [2, 1], fields: 3 };
    let (rows, columns) = (MODES + BALANCE, layout.len());
    let zones = Zones {
        boxes: vec![vec![0], vec![1], vec![2]],
        y_norm: vec![0.2, 0.5, 0.9],
        y_m: vec![0.3, 0.8, 1.4],
        x_m: vec![0.05, 0.07, 0.12],
        chord_m: vec![0.3, 0.25, 0.2],
        area_m2: vec![0.15, 0.12, 0.1],
        width_m: vec![0.5, 0.48, 0.5],
    };
    ReducedOrderModel {
        flow: Flow { v_m_s, rho_kg_m3: 1.2 },
        controls: vec!["inner".into(), "outer".into()],
        zones,
        layout,
        poles_per_m: POLES.map(<[f64]>::to_vec),
        air: numbers(rows, columns, 1, 0.4),
        zone_air: (0..3).map(|z| numbers(rows, columns, 2 + z, 0.2)).collect(),
        zone_moment: (0..3).map(|z| numbers(rows, columns, 5 + z, 0.2)).collect(),
        apparent: numbers(rows, MOTIONS, 8, 0.1),
        quasi_steady_rate: numbers(rows, MOTIONS, 9, 0.3),
        wake: (0..2)
            .map(|k| [(10, 3.0), (19, 0.6)].map(|(seed, size)| numbers(rows, MOTIONS, seed + k, size)))
            .collect(),
        wake_poles_per_m: vec![0.4, 1.1],
        lift: numbers(3, columns, 12, 0.5),
        zone_drive: numbers(rows, 3, 13, 1.0),
        unit_moment: numbers(rows, 3, 14, 1.0),
        unit_upwash: (0..rows).map(|row| (row as f64 + 0.4).cos()).collect(),
        tip: numbers(1, columns, 15, 0.3),
        inertia: numbers(BALANCE, columns, 16, 0.2),
        modal_fields: numbers(MODES, 3, 17, 0.3),
        heights: numbers(3, MODES, 18, 1.0),
        twists: numbers(3, MODES, 19, 1.0),
        omega_rad_s: vec![20.0, 33.0, 61.0],
        damping_ratio: 0.02,
        actuator: Actuator { frequency_hz: 7.0, damping_ratio: 0.7 },
        gravity_m_s2: 9.81,
        balance_m: [0.02, 0.1],
        pitch_axis_x_m: 0.06,
        stiffness: None,
        cutoff_hz: 25.0,
    }
}

/// `s/(s + g V)`; nothing at rest.
fn lag(s: c64, g_per_s: f64) -> c64 {
    if s.norm() > 0.0 { s / (s + c64::from(g_per_s)) } else { c64::from(0.0) }
}

/// Rows by motions at s: displacements, rates, accelerations and lags.
fn at(by: &Mat<f64>, s: c64, v_m_s: f64) -> Mat<c64> {
    let mut sum = Mat::from_fn(by.nrows(), MOTIONS, |row, motion| {
        s * s * by[(row, 12 + motion)] + s * by[(row, 6 + motion)] + by[(row, motion)]
    });
    for (k, (g, motion)) in LAGS.into_iter().enumerate() {
        for row in 0..by.nrows() {
            sum[(row, motion)] += lag(s, g * v_m_s) * by[(row, 18 + k)];
        }
    }
    sum
}

/// What a change makes of the parts of the equations.
struct Parts {
    z: Mat<c64>,
    lift: Mat<c64>,
    mass: Mat<f64>,
    damping: Mat<f64>,
    stiffness: Mat<f64>,
    modal_fields: Mat<f64>,
    inertia: Mat<f64>,
}

fn parts(rom: &ReducedOrderModel, s: c64) -> Parts {
    let (air, v) = (&rom.air, rom.flow.v_m_s);
    Parts {
        z: at(air, s, v),
        lift: at(&rom.lift, s, v),
        mass: Mat::identity(MODES, MODES),
        damping: Mat::from_fn(MODES, MODES, |i, j| if i == j { 0.04 * rom.omega_rad_s[i] } else { 0.0 }),
        stiffness: Mat::from_fn(MODES, MODES, |i, j| if i == j { rom.omega_rad_s[i].powi(2) } else { 0.0 }),
        modal_fields: Mat::from_fn(MODES, 3, |i, f| rom.modal_fields[(i, f)]),
        inertia: rom.inertia.clone(),
    }
}

/// All outputs by all drives from the parts.
fn solved(rom: &ReducedOrderModel, s: c64, p: &Parts) -> Mat<c64> {
    let fields = Mat::from_fn(MODES + BALANCE, 3, |row, f| {
        rom.air[(row, ONE + 1 + f)]
            + if row < MODES { p.modal_fields[(row, f)] } else { p.inertia[(row - MODES, ONE + 1 + f)] }
    });
    // forces on a set of rows by the drives, the modes held
    let held =
        |z: &Mat<c64>, field: &dyn Fn(usize, usize) -> f64, zone_lift: &dyn Fn(usize, usize) -> f64| {
            Mat::from_fn(z.nrows(), 11, |row, drive| match drive {
                0 => z[(row, 3)] - s * s * field(row, 2),
                1 => z[(row, 3)],
                2 => c64::from(field(row, 0)),
                3 => c64::from(-field(row, 1)),
                4 | 5 => z[(row, drive)],
                6..9 => c64::from(zone_lift(row, drive - 6)),
                _ => c64::from(0.0),
            })
        };
    let mut direct = held(&p.z, &|row, f| fields[(row, f)], &|row, zone| rom.zone_drive[(row, zone)]);
    for mode in 0..2 {
        direct[(mode, 9 + mode)] = c64::from(1.0);
    }
    let dynamic = Mat::from_fn(MODES, MODES, |i, j| {
        s * s * p.mass[(i, j)] + s * p.damping[(i, j)] + p.stiffness[(i, j)] - p.z[(i, j)]
    });
    let xi = dynamic.partial_piv_lu().solve(direct.subrows(0, MODES).to_owned());
    let balance =
        Mat::from_fn(BALANCE, MODES, |row, k| p.z[(MODES + row, k)] + s * s * p.inertia[(row, 12 + k)]);
    let tip = at(&rom.tip, s, rom.flow.v_m_s);
    let none = |_: usize, _: usize| 0.0;
    let tip_held = held(&tip, &|_, f| rom.tip[(0, ONE + 1 + f)], &none);
    let unit = |zone: usize, drive: usize| f64::from(u8::from(zone == drive));
    let lift_held = held(&p.lift, &|zone, f| rom.lift[(zone, ONE + 1 + f)], &unit);
    let loads = &balance * &xi + direct.subrows(MODES, BALANCE);
    let tip = tip.subcols(0, MODES) * &xi + tip_held;
    let lifts = p.lift.subcols(0, MODES) * &xi + lift_held;
    let real = |by: &Mat<f64>| Mat::from_fn(3, MODES, |zone, k| c64::from(by[(zone, k)])) * &xi;
    let (heights, twists) = (real(&rom.heights), real(&rom.twists));
    Mat::from_fn(13, 11, |row, drive| match row {
        0..3 => loads[(row, drive)],
        3 => tip[(0, drive)],
        4..7 => lifts[(row - 4, drive)],
        7..10 => heights[(row - 7, drive)],
        _ => twists[(row - 10, drive)],
    })
}

fn assert_near(ours: &Mat<c64>, wanted: &Mat<c64>, what: &str) {
    assert_eq!((ours.nrows(), ours.ncols()), (wanted.nrows(), wanted.ncols()), "{what}");
    let (off, size) = ((ours - wanted).norm_max(), wanted.norm_max());
    assert!(off < 1e-10 * size, "{what}: {off:e} of {size:e}");
}

/// The responses with a change are those of the parts that `act` makes.
fn assert_change(rom: &ReducedOrderModel, what: &str, change: &Change, act: impl Fn(c64, &mut Parts)) {
    for v_m_s in [25.0, 0.0] {
        let rom = ReducedOrderModel { flow: Flow { v_m_s, ..rom.flow }, ..rom.clone() };
        let (all, few) = (rom.responses(change, &OMEGAS, true), rom.responses(change, &OMEGAS, false));
        for (k, omega) in OMEGAS.into_iter().enumerate() {
            let s = c64::new(0.0, omega);
            let mut wanted = parts(&rom, s);
            act(s, &mut wanted);
            let wanted = solved(&rom, s, &wanted);
            assert_near(&all[k], &wanted, &format!("{what}, {v_m_s} m/s, {omega} rad/s"));
            assert_near(&few[k], &wanted.submatrix(0, 0, 4, 6).to_owned(), what);
        }
    }
}

fn none() -> Change {
    Change::none(3)
}

#[test]
fn drives_and_outputs_stand_in_the_order_of_their_names() {
    let rom = small(25.0);
    let (drive, outputs) = (rom.drive(), rom.outputs());
    assert_eq!((drive.lifts(), drive.modal(), drive.len(false), drive.len(true)), (6, 9, 6, 11));
    assert_eq!((outputs.lifts(), outputs.heights(), outputs.twists()), (4, 7, 10));
    assert_eq!((Outputs::TIP, outputs.len(false), outputs.len(true)), (3, 4, 13));
    assert!(!drive.is_empty() && !outputs.is_empty());
    assert_eq!((rom.modes(), rom.gravity_m_s2(), rom.cutoff_hz(), rom.balance_y_m()), (3, 9.81, 25.0, 0.1));
    assert_eq!((rom.outer_shape(), rom.first_stiffness()), (rom.heights[(2, 0)], 400.0));
    let still = ReducedOrderModel { zones: Zones::default(), omega_rad_s: Vec::new(), ..rom };
    assert_eq!((still.outer_shape(), still.first_stiffness()), (0.0, 0.0));
}

#[test]
fn responses_solve_the_equations_of_modes_and_balance() {
    assert_change(&small(25.0), "unchanged", &none(), |_, _| ());
}

#[test]
fn factors_of_the_air_act_on_what_their_names_say() {
    let rom = small(25.0);
    assert_change(&rom, "pressure", &Change { pressure: 0.1, ..none() }, |_, p| {
        p.z = &p.z * faer::Scale(c64::from(1.1));
        p.lift = &p.lift * faer::Scale(c64::from(1.1));
    });
    assert_change(&rom, "slope", &Change { lift_slope: -0.2, ..none() }, |_, p| {
        for z in [&mut p.z, &mut p.lift] {
            *z = Mat::from_fn(z.nrows(), MOTIONS, |i, j| z[(i, j)] * if j < 4 { 0.8 } else { 1.0 });
        }
    });
    assert_change(&rom, "apparent", &Change { apparent_mass: 0.3, ..none() }, |s, p| {
        p.z = Mat::from_fn(6, MOTIONS, |i, j| p.z[(i, j)] + s * s * 0.3 * rom.apparent[(i, j)]);
    });
}

#[test]
fn zones_add_their_shares_and_move_them_aft_as_moments() {
    let rom = small(25.0);
    for (force, aft) in
        [([0.1, 0.0, -0.3], [0.0; 3]), ([0.0; 3], [0.0, 0.2, 0.05]), ([0.0, 0.4, 0.1], [0.3, 0.0, 0.1])]
    {
        let change = Change { zone_force: force.to_vec(), zone_aft_over_c: aft.to_vec(), ..none() };
        assert!(change.by_zone() && !none().by_zone());
        for v_m_s in [25.0, 0.0] {
            let rom = ReducedOrderModel { flow: Flow { v_m_s, ..rom.flow }, ..rom.clone() };
            for omega in OMEGAS {
                let s = c64::new(0.0, omega);
                let mut wanted = parts(&rom, s);
                for zone in 0..3 {
                    let [share, moment] =
                        [&rom.zone_air[zone], &rom.zone_moment[zone]].map(|by| at(by, s, v_m_s));
                    wanted.z += share * faer::Scale(c64::from(force[zone]));
                    wanted.z += moment * faer::Scale(c64::from(-aft[zone]));
                    for motion in 0..MOTIONS {
                        wanted.lift[(zone, motion)] *= 1.0 + force[zone];
                    }
                }
                let ours = &rom.responses(&change, &[omega], true)[0];
                // the field's direct share of a zone's lift is that of the unchanged wing
                assert_near(ours, &solved(&rom, s, &wanted), "zones");
            }
        }
    }
}

#[test]
fn the_unsteady_part_is_all_beyond_the_steady_answer_and_a_longer_memory_moves_the_wake_s_poles() {
    let rom = small(25.0);
    let beyond = |s: c64| {
        let z = at(&rom.air, s, 25.0);
        Mat::from_fn(6, MOTIONS, |i, j| z[(i, j)] - rom.air[(i, j)] - s * rom.quasi_steady_rate[(i, j)])
    };
    let wake = |s: c64, lag_factor: f64| {
        let part = |k: usize| {
            lag(s, rom.wake_poles_per_m[k] * 25.0 / lag_factor) - lag(s, rom.wake_poles_per_m[k] * 25.0)
        };
        let of = |k: usize, i, j| rom.wake[k][0][(i, j)] + s / c64::from(25.0) * rom.wake[k][1][(i, j)];
        Mat::from_fn(6, MOTIONS, |i, j| (0..2).map(|k| part(k) * of(k, i, j)).sum::<c64>())
    };
    for omega in OMEGAS {
        let s = c64::new(0.0, omega);
        let expect = |change: &Change, add: Mat<c64>| {
            let mut wanted = parts(&rom, s);
            wanted.z += add;
            assert_near(&rom.responses(change, &[omega], true)[0], &solved(&rom, s, &wanted), "unsteady");
        };
        expect(&Change { unsteady: 0.5, ..none() }, beyond(s) * faer::Scale(c64::from(0.5)));
        expect(&Change { lag: 0.6, ..none() }, wake(s, 1.6));
        let both = beyond(s) * faer::Scale(c64::from(-0.4)) + wake(s, 1.6) * faer::Scale(c64::from(0.6));
        expect(&Change { lag: 0.6, unsteady: -0.4, ..none() }, both);
    }
    let still = small(0.0);
    let longer = still.responses(&Change { lag: 0.6, ..none() }, &OMEGAS, true);
    assert_eq!(longer, still.responses(&none(), &OMEGAS, true), "no wake without a stream");
}

#[test]
fn stiffness_damping_and_mass_change_by_their_shares() {
    let rom = small(25.0);
    assert_change(&rom, "bending without parts", &Change { bending: 0.2, torsion: 0.7, ..none() }, |_, p| {
        p.stiffness = &p.stiffness * faer::Scale(1.2);
    });
    let split = StiffnessParts { bending: numbers(3, 3, 30, 40.0), torsion: numbers(3, 3, 31, 50.0) };
    let parted = ReducedOrderModel { stiffness: Some(split.clone()), ..rom.clone() };
    assert_change(&parted, "parts", &Change { bending: 0.2, torsion: -0.3, ..none() }, |_, p| {
        p.stiffness += &split.bending * faer::Scale(0.2) + &split.torsion * faer::Scale(-0.3);
    });
    assert_change(&rom, "more damping", &Change { damping: 0.5, ..none() }, |_, p| {
        p.damping = &p.damping * faer::Scale(1.5);
    });
    assert_change(&rom, "mass", &Change { mass: 0.25, ..none() }, |_, p| {
        let by = faer::Scale(1.25);
        (p.mass, p.modal_fields, p.inertia) = (&p.mass * by, &p.modal_fields * by, &p.inertia * by);
    });
}

/// A body at .6 of the span and a tenth of the chord aft: between the zones at .5 and .9, a quarter of the way.
fn body() -> (PointMass, [f64; 2], Change) {
    let point = PointMass { mass_kg: 0.3, y_norm: 0.6, aft_over_c: 0.1 };
    let (x, y) = (0.75 * (0.07 + 0.025) + 0.25 * (0.12 + 0.02), 0.75 * 0.8 + 0.25 * 1.4);
    (point, [x, y], Change { points: vec![point], ..none() })
}

#[test]
fn a_body_on_the_wing_has_inertia_and_weight_where_it_is() {
    let rom = small(25.0);
    let (point, [x, y], change) = body();
    let shape: Vec<f64> = (0..3).map(|k| 0.75 * rom.heights[(1, k)] + 0.25 * rom.heights[(2, k)]).collect();
    // a force down of the body's mass times its acceleration; the fields push up and nose up about the axis
    let (field, arm) = ([0.0, 1.0, 0.06 - x], [1.0, y - 0.1, 0.02 - x]);
    assert_change(&rom, "body", &change, |_, p| {
        for i in 0..3 {
            for j in 0..3 {
                p.mass[(i, j)] += point.mass_kg * shape[i] * shape[j];
                p.modal_fields[(i, j)] += point.mass_kg * shape[i] * field[j];
                p.inertia[(i, 12 + j)] -= point.mass_kg * arm[i] * shape[j];
                p.inertia[(i, ONE + 1 + j)] += point.mass_kg * arm[i] * field[j];
            }
        }
    });
    let tare = Structural::new(&rom, &change);
    for (row, arm) in arm.into_iter().enumerate() {
        assert!((tare.points_tare(row, 10.0) - 3.0 * arm).abs() < 1e-12, "{row}");
    }
    let bare = ReducedOrderModel { zones: Zones::default(), ..rom };
    assert_eq!(Structural::new(&bare, &change).points_tare(0, 10.0), 0.0, "no zone to stand on");
}

mod steady;
