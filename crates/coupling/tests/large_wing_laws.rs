//! Laws of the wing that really bends: its linear limit, rigid motions, virtual work, balance of forces, divergence.

#![expect(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::large::without_skin;
use aero::{Corrections, Flow, MirrorPlane};
use coupling::{LargeState, LargeWing, Mount, SteadyCase, WingFile};
use nalgebra::{DMatrix, Point3, Rotation3, Vector3};
use std::path::Path;
use structure::nonlinear::{Carried, CarriedPoint, Loads, State};

fn case(v_m_s: f64, alpha_deg: f64) -> SteadyCase {
    SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, alpha_deg.to_radians())
}

fn solved(wing: &LargeWing, case: &SteadyCase) -> LargeState {
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    wing.solve(std::slice::from_ref(case), &neutral).unwrap().remove(0)
}

/// The shipped beam wing (swept, tapered, cambered) with few boxes.
fn shipped() -> LargeWing {
    shipped_as("wing_beam", 14)
}

/// A shipped wing with few boxes.
fn shipped_as(name: &str, strips: usize) -> LargeWing {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../data/tuflex/{name}.ron"));
    let mut file = WingFile::read(&path).unwrap();
    let coupling::wing_file::Source::Parametric(planform) = &mut file.source else { panic!("parametric") };
    (planform.boxes.chordwise, planform.boxes.spanwise) = (4, strips);
    planform.controls.clear();
    // Its loads reach the clamp, not the balance.
    planform.fairing = None;
    LargeWing::from_bulk(&file, &file.bulk(Mount::Tunnel).unwrap()).unwrap()
}

#[test]
fn small_loads_give_what_the_linear_wing_gives_and_the_difference_falls_with_the_load() {
    let mut wing = shipped().weightless().unwrap();
    let camber = wing.elastic.camber.clone();
    let count = wing.elastic.correctable.len();
    let wave = |b: usize, phase: f64| (b as f64 * 0.37 + phase).sin();
    let mut shares = Vec::new();
    for size in [0.1, 0.05, 0.0001] {
        wing.elastic.camber = camber.iter().map(|own| own * size).collect();
        // camber was solved for when the wing was assembled
        let corrections = Corrections {
            force: (0..count).map(|b| 1.0 + 0.2 * wave(b, 0.0)).collect(),
            moment: (0..count).map(|b| 1.0 + 0.3 * wave(b, 1.0)).collect(),
            pressure_offset: (0..count).map(|b| 0.1 * size * wave(b, 2.0)).collect(),
        };
        let (case, zero) = (
            case(25.0, 4.0 * size),
            Corrections { pressure_offset: vec![0.0; count], ..corrections.clone() },
        );
        let large = wing.solve(std::slice::from_ref(&case), &corrections).unwrap().remove(0);
        let at = |alpha: f64, corrections: &Corrections| {
            let case = SteadyCase { alpha_rad: alpha, ..case.clone() };
            let state = wing.elastic.at(case.flow, corrections).unwrap().solve(&[case]).remove(0);
            let [fz, mx, my] = state.root.to_array();
            [fz, mx, my, state.tip_z_m]
        };
        // The linear wing keeps the whole camber: its share is taken by superposition.
        let (all, whole) = (at(case.alpha_rad, &corrections), at(0.0, &zero));
        let linear: Vec<f64> =
            all.iter().zip(whole).map(|(all, camber)| all - (1.0 - size) * camber).collect();
        let [fz, mx, my] = large.root.to_array();
        let own = [fz, mx, my, large.tip_m.z];
        assert!(own.iter().chain(&linear).all(|value| value.is_finite()), "{own:?} {linear:?}");
        shares.push(own.iter().zip(&linear).map(|(own, of)| (own / of - 1.0).abs()).fold(0.0, f64::max));
    }
    println!("largest share by which large deflections differ: {shares:?}");
    assert!(shares[2] < 2e-4 * shares[0].max(1e-3) + 1e-6, "the limit is another: {shares:?}");
    let falls = shares[0] / shares[1];
    assert!(falls > 1.9, "the difference falls by {falls} for half the load: {shares:?}");
}

/// The axis of the shells is not their neutral one: it stretches and shortens as they bend, and strips on it come apart. The beam's
/// strips do not.
#[test]
fn in_shells_bending_takes_no_more_lift_than_on_the_beam_of_the_same_wing() {
    let case = case(30.0, 2.0);
    let lost = ["wing", "wing_beam"].map(|name| {
        let wing = shipped_as(name, 28);
        let neutral = Corrections::neutral(wing.elastic.correctable.len());
        let linear = wing.elastic.at(case.flow, &neutral).unwrap().solve(std::slice::from_ref(&case));
        1.0 - solved(&wing, &case).root.fz_n / linear[0].root.fz_n
    });
    assert!((lost[0] - lost[1]).abs() < 0.003, "lift lost in shells and on the beam: {lost:?}");
}

#[test]
fn a_wing_turned_with_the_stream_carries_the_same_loads() {
    let wing = without_skin([4, 10], MirrorPlane::Symmetric { y_m: 0.0 });
    let neutral = [Corrections::neutral(wing.elastic.correctable.len())];
    let plain = solved(&wing, &case(45.0, 5.0));
    // Nose up by 5 degrees instead of the stream; the clamp turns too.
    let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), 5.0_f64.to_radians());
    let turned =
        wing.solve_from(&wing.wind_off().turned(&turn), &[case(45.0, 0.0)], &neutral).unwrap().remove(0);
    same(&plain, &turned, &turn);
}

#[test]
fn a_wing_rolled_as_a_whole_carries_the_same_loads() {
    let mut wing = without_skin([4, 10], MirrorPlane::None);
    wing.elastic.camber = vec![0.06; wing.elastic.lattice.len()];
    let neutral = [Corrections::neutral(wing.elastic.correctable.len())];
    let plain = solved(&wing, &case(45.0, 0.0));
    assert!(plain.tip_m.z > 0.05, "it bends: {}", plain.tip_m.z);
    for angle in [90.0_f64, 172.0] {
        let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), angle.to_radians());
        let turned =
            wing.solve_from(&wing.wind_off().turned(&turn), &[case(45.0, 0.0)], &neutral).unwrap().remove(0);
        same(&plain, &turned, &turn);
    }
}

/// Places and loads are those of the other, turned.
fn same(plain: &LargeState, turned: &LargeState, turn: &Rotation3<f64>) {
    for (node, (a, b)) in plain.state.places.iter().zip(&turned.state.places).enumerate() {
        assert!((turn * a - b).norm() < 1e-9, "node {node} is at {b}, not {}", turn * a);
    }
    for (j, (a, b)) in plain.box_loads.values.iter().zip(&turned.box_loads.values).enumerate() {
        assert!((a - b).abs() < 1e-8 * (1.0 + a.abs()), "load {j}: {a}, turned {b}");
    }
}

#[test]
fn the_clamp_gives_what_the_balance_feels() {
    let wing = shipped();
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    let states = wing.solve(&[case(20.0, 0.0), case(30.0, 6.0)], &neutral).unwrap();
    let clamp = |state: &State, applied: &[f64]| {
        let inner = wing.structure.inner_forces(state);
        let felt: Vec<f64> = applied.iter().zip(inner).map(|(applied, inner)| applied - inner).collect();
        let held: Vec<usize> =
            (0..state.places.len()).filter(|node| state.rotations[*node] == Rotation3::identity()).collect();
        let point = wing.elastic.balance.point;
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for node in held {
            let f = Vector3::from_column_slice(&felt[6 * node..6 * node + 3]);
            let m = Vector3::from_column_slice(&felt[6 * node + 3..6 * node + 6]);
            force += f;
            moment += m + (Point3::from(state.places[node]) - point).cross(&f);
        }
        (force, moment)
    };
    let gravity_m_s2 = Vector3::new(0.0, 0.0, -coupling::GRAVITY_M_S2);
    let weight = Loads { gravity_m_s2, ..Loads::default() };
    let (tare_force, tare_moment) =
        clamp(wing.wind_off(), &wing.structure.load_forces(wing.wind_off(), &weight));
    for state in &states {
        let (force, moment) = clamp(&state.state, &state.forces);
        let expected = [force.z - tare_force.z, moment.x - tare_moment.x, moment.y - tare_moment.y];
        for (own, of) in state.root.to_array().iter().zip(expected) {
            assert!((own - of).abs() < 1e-6 * (1.0 + of.abs()), "{own} at the balance, {of} at the clamp");
        }
    }
}

#[test]
fn the_gain_of_the_straight_wing_is_the_share_of_its_divergence_pressure() {
    let wing = without_skin([4, 16], MirrorPlane::Symmetric { y_m: 0.0 });
    let neutral = Corrections::neutral(wing.elastic.correctable.len());
    let limit_pa = wing.elastic.divergence_pressure(&neutral).unwrap().unwrap();
    let at = |share: f64| case((2.0 * share * limit_pa / 1.225).sqrt(), 0.0);
    for share in [0.3, 0.98] {
        let gain = solved(&wing, &at(share)).gain;
        assert!((gain - share).abs() < 1e-4, "gain {gain} at {share} of the divergence pressure");
    }
    let refused = wing.solve(&[at(0.9), at(1.02)], &neutral).unwrap_err().to_string();
    println!("{refused}");
    let reached = format!("the last one was at {:.2} m/s", at(0.9).flow.v_m_s);
    assert!(refused.contains(&reached) && refused.contains("divergence"), "{refused}");
}

#[test]
fn loads_on_carried_points_do_the_work_that_reaches_the_nodes() {
    let nodes = [[0.0, 0.0, 0.0], [0.1, 1.0, 0.05], [0.3, 1.8, 0.0]].map(Vector3::from);
    let rows = |seed: f64| {
        // Any rows that carry rigid motions: those of node one, and a part that sees differences only.
        DMatrix::from_fn(6, 12, |i, j| {
            let same = f64::from(u8::from(i == j % 6));
            let share = 0.4 + 0.05 * (seed + i as f64).sin();
            if j < 6 { same * (1.0 - share) } else { same * share }
        })
    };
    let point = |at: usize, origin: [f64; 3]| CarriedPoint {
        origin: Point3::from(origin),
        nodes: vec![at, at + 1],
        rows: rows(at as f64),
    };
    let points = [point(0, [0.3, 0.4, 0.1]), point(1, [0.0, 1.5, 0.0]), point(1, [0.5, 1.7, 0.2])];
    let carried = Carried::new(&nodes, &points);
    let turn = |a: f64| Rotation3::from_scaled_axis(Vector3::new(1.1 + 0.2 * a, -0.4 * a, 0.7 + 0.1 * a));
    let state = State {
        places: nodes
            .iter()
            .enumerate()
            .map(|(i, x)| turn(0.1) * x + Vector3::new(0.02, 0.01, 0.03) * i as f64)
            .collect(),
        rotations: (0..3).map(|i| turn(0.3 * f64::from(i))).collect(),
    };
    let loads: Vec<[Vector3<f64>; 2]> = (0..3)
        .map(|i| [Vector3::new(3.0, -1.0 + f64::from(i), 2.0), Vector3::new(0.5, 0.7, -f64::from(i))])
        .collect();
    let forces = carried.forces(&carried.placed(&state), &loads, 3);
    let moved = |dof: usize, step: f64| {
        let mut state = state.clone();
        if dof % 6 < 3 {
            state.places[dof / 6][dof % 3] += step;
        } else {
            let spin = Rotation3::from_scaled_axis(Vector3::ith(dof % 3, step));
            state.rotations[dof / 6] = spin * state.rotations[dof / 6];
        }
        let placed = carried.placed(&state);
        (0..3).map(|at| carried.place(&placed, at)).collect::<Vec<_>>()
    };
    // A logarithm by the arc cosine has no digits left of rotations this small.
    let spin = |r: &Rotation3<f64>| {
        Vector3::new(r[(2, 1)] - r[(1, 2)], r[(0, 2)] - r[(2, 0)], r[(1, 0)] - r[(0, 1)]) * 0.5
    };
    let step = 1e-5;
    for (dof, force) in forces.iter().enumerate() {
        let (up, down) = (moved(dof, step), moved(dof, -step));
        let mut work = 0.0;
        for at in 0..3 {
            let [force, moment] = loads[at];
            work +=
                force.dot(&(up[at].0 - down[at].0)) + moment.dot(&spin(&(up[at].1 * down[at].1.inverse())));
        }
        let work = work / (2.0 * step);
        assert!(
            (work - force).abs() < 1e-7 * (1.0 + force.abs()),
            "motion {dof}: work {work}, force {force}"
        );
    }
}
