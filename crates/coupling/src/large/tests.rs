//! Laws of the bent wing on small samples: what acts, what the balance feels, controls, small motions and derivatives.

use super::air::chord;
use super::samples::{
    ARM_KG, CHORD_M, MASS_KG, flying_boxes, half_wing, model as model_of, uneven, with_arm,
};
use super::*;
use crate::{CouplingError, GRAVITY_M_S2, RootSensitivity, SplineKind, SteadyCase, SteadyModel};
use aero::{AeroBox, Corrections, Flow, MirrorPlane, Seams, SteadyAero};
use faer::Mat;
use nalgebra::{Point3, Rotation3, Vector3};
use structure::nonlinear::{Acting, Loads, Near, NodeLoad, State};
use structure::normal_modes;

const PLANE: MirrorPlane = MirrorPlane::Symmetric { y_m: 0.0 };

fn case(v_m_s: f64, alpha_rad: f64, flap: f64) -> SteadyCase {
    SteadyCase { controls_rad: vec![flap], ..SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.2 }, alpha_rad) }
}

fn neutral(wing: &LargeWing) -> Corrections {
    Corrections::neutral(wing.elastic.lattice.len())
}

fn solved(wing: &LargeWing, case: &SteadyCase, corrections: &Corrections) -> LargeState {
    wing.solve(std::slice::from_ref(case), corrections).expect("an equilibrium").remove(0)
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} beside {expected}");
}

fn three(six: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(six[first], six[first + 1], six[first + 2])
}

/// Force and moment about the middle of a box, of a lift and a moment in a stream.
fn directed(panel: &AeroBox, alpha: f64, [lift, moment]: [f64; 2]) -> [Vector3<f64>; 2] {
    let stream = Vector3::new(alpha.cos(), 0.0, alpha.sin());
    let [from, to] = panel.bound_vortex();
    let up = stream.cross(&(to - from)).normalize();
    let [c1, c2, c3, c4] = panel.corners;
    let along = ((c2 - c1) + (c3 - c4)).normalize();
    assert!((along - chord(panel)).norm() < 1e-14);
    [up * lift, up.cross(&along) * moment]
}

#[test]
fn weight_alone_follows_no_motion_and_air_does() {
    let wing = half_wing(200.0, 100.0, 0.02);
    let alpha = 0.3_f64;
    let still = wing.air(&case(0.0, alpha, 0.0), &neutral(&wing)).expect("air");
    assert!(!still.follows());
    let state = wing.structure.undeformed();
    let weight = still.at(&wing.structure, &state).expect("weight");
    let forces = weight.forces();
    assert_eq!(forces.len(), 30);
    for six in forces.chunks_exact(6) {
        let felt = MASS_KG * GRAVITY_M_S2;
        let expected = [felt * alpha.sin(), 0.0, -felt * alpha.cos(), 0.0, 0.0, 0.0];
        six.iter().zip(expected).for_each(|(own, of)| near(*own, of, 1e-12, "weight of a grid"));
    }
    assert_eq!(weight.following(&state), [0.0; 30]);
    let moving = wing.air(&case(20.0, alpha, 0.0), &neutral(&wing)).expect("air");
    assert!(moving.follows());
    let acting = moving.at(&wing.structure, &state).expect("air and weight");
    let (all, air) = (acting.forces(), acting.following(&state));
    assert!(air.len() == 30 && air[26] > 0.1, "{air:?}");
    for (dof, all) in all.iter().enumerate() {
        near(*all, air[dof] + forces[dof], 1e-12, "air and weight");
    }
}

#[test]
fn loads_that_are_kept_roll_with_the_boxes() {
    let wing = half_wing(200.0, 100.0, 0.02);
    let (case, corrections) = (case(20.0, 0.0, 0.1), uneven(&wing.elastic.lattice));
    let state = solved(&wing, &case, &corrections);
    let air = wing.air(&case, &corrections).expect("air");
    let about = air.solved(&state.state).expect("a lattice");
    let loaded = about.loaded(&state.state);
    let here = about.same_loads_on_nodes(&loaded, &state.state);
    let followed = about.following(&state.state);
    assert_eq!(here.len(), 30);
    here.iter().zip(&followed).for_each(|(a, b)| near(*a, *b, 1e-10, "the same state"));
    // Resultants are those of the boxes.
    let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
    for (place, six) in state.state.places.iter().zip(here.chunks_exact(6)) {
        force += three(six, 0);
        moment += three(six, 3) + place.cross(&three(six, 0));
    }
    for (j, panel) in state.lattice.boxes.iter().enumerate() {
        let [f, m] = directed(panel, 0.0, [0, 1].map(|part| state.box_loads.values[2 * j + part]));
        force -= f;
        moment -= m + panel.mid_point().coords.cross(&f);
    }
    assert!(force.norm() < 1e-9 && moment.norm() < 1e-9, "left over: {force} {moment}");
    let roll = Rotation3::from_axis_angle(&Vector3::x_axis(), 0.6);
    let rolled = about.same_loads_on_nodes(&loaded, &state.state.turned(&roll));
    for (a, b) in here.chunks_exact(6).zip(rolled.chunks_exact(6)) {
        for first in [0, 3] {
            assert!((roll * three(a, first) - three(b, first)).norm() < 1e-9, "{a:?} rolled is {b:?}");
        }
    }
}

#[test]
fn a_flap_is_camber_of_its_boxes() {
    let mut wing = half_wing(200.0, 100.0, 0.01);
    let corrections = uneven(&wing.elastic.lattice);
    let flapped = solved(&wing, &case(20.0, 0.05, 0.1), &corrections);
    for (j, camber) in wing.elastic.camber.iter_mut().enumerate() {
        *camber += if j % 2 == 1 { 0.9 * 0.1 } else { 0.0 };
    }
    let cambered = solved(&wing, &case(20.0, 0.05, 0.0), &corrections);
    assert!(flapped.tip_m.z.abs() > 0.01);
    near(flapped.tip_m.z, cambered.tip_m.z, 1e-9, "the tip");
    for (a, b) in flapped.box_loads.values.iter().zip(&cambered.box_loads.values) {
        near(*a, *b, 1e-7, "a load");
    }
}

#[test]
fn the_balance_feels_what_the_clamp_gives_but_for_boxes_that_do_not_hang_on_it() {
    let mut wing = with_arm(120.0, 80.0, 0.02);
    let point = Point3::new(0.1, -0.2, 0.05);
    wing.elastic.balance.point = point;
    wing.elastic.balance.metric[1] = false;
    wing.elastic.balance.metric[6] = false;
    let (alpha, corrections) = (0.15, uneven(&wing.elastic.lattice));
    let state = solved(&wing, &case(18.0, alpha, 0.05), &corrections);
    let clamp = |at: &State, applied: &[f64]| {
        let inner = wing.structure.inner_forces(at);
        let felt: Vec<f64> = applied.iter().zip(inner).map(|(applied, inner)| applied - inner).collect();
        let force = three(&felt, 0);
        (force, three(&felt, 3) + (Point3::from(at.places[0]) - point).cross(&force))
    };
    let gravity_m_s2 = Vector3::new(0.0, 0.0, -GRAVITY_M_S2);
    let weight = wing.structure.load_forces(wing.wind_off(), &Loads { gravity_m_s2, ..Loads::default() });
    let ((mut force, mut moment), tare) =
        (clamp(&state.state, &state.forces), clamp(wing.wind_off(), &weight));
    force -= tare.0;
    moment -= tare.1;
    for j in [1, 6] {
        let panel = &state.lattice.boxes[j];
        let [f, m] = directed(panel, alpha, [0, 1].map(|part| state.box_loads.values[2 * j + part]));
        force -= f;
        moment -= m + (panel.mid_point() - point).cross(&f);
    }
    let scale = 1.0 + force.norm();
    for (own, of) in state.root.to_array().into_iter().zip([force.z, moment.x, moment.y]) {
        near(own, of, 2e-6 * scale, "a root load");
    }
    let nose = |at: &State| (-at.rotations[4].matrix()[(2, 0)]).asin();
    near(state.twist_rad, nose(&state.state) - nose(wing.wind_off()), 1e-12, "twist");
    assert!(state.twist_rad.abs() > 1e-3 && state.tip_m.z.abs() > 1e-2);
    let tip = state.state.places[4] - wing.wind_off().places[4];
    assert!((state.tip_m - tip).norm() < 1e-12);
    assert!(wing.wind_off().places[4].z < -0.01, "it hangs");
    let light = half_wing(120.0, 80.0, 0.02).weightless().expect("at rest");
    assert!(light.wind_off().places[4].z.abs() < 1e-12);
}

#[test]
fn carried_boxes_move_rigidly_and_do_the_work_of_their_nodes() {
    let wing = half_wing(60.0, 40.0, 0.02);
    let lattice = &wing.elastic.lattice;
    let state = solved(&wing, &case(20.0, 0.1, 0.0), &neutral(&wing)).state;
    let (shift, spin) = (Vector3::new(0.3, -0.2, 0.5), Vector3::new(0.4, 0.7, -0.6));
    let rigid: Vec<f64> = state
        .places
        .iter()
        .flat_map(|place| {
            let moved = shift + spin.cross(place);
            [moved.x, moved.y, moved.z, spin.x, spin.y, spin.z]
        })
        .collect();
    let boxes = wing.boxes.moved(lattice, &state);
    for (panel, [moved, turned]) in
        boxes.lattice.boxes.iter().zip(wing.boxes.motions(lattice, &state, &rigid))
    {
        let expected = shift + spin.cross(&panel.mid_point().coords);
        assert!((moved - expected).norm() < 1e-7 && (turned - spin).norm() < 1e-7, "{moved} {turned}");
    }
    let motion: Vec<f64> = (0..30).map(|i| (1.7 * f64::from(i)).sin()).collect();
    let loads: Vec<[Vector3<f64>; 2]> = (0..lattice.len())
        .map(|j| {
            let wave = |k: f64| (0.9 * j as f64 + k).cos();
            [Vector3::new(wave(0.0), wave(1.0), wave(2.0)), Vector3::new(wave(3.0), wave(4.0), wave(5.0))]
        })
        .collect();
    let on_nodes: f64 = wing.boxes.to_nodes(&boxes, &loads).iter().zip(&motion).map(|(f, u)| f * u).sum();
    let motions = wing.boxes.motions(lattice, &state, &motion);
    let on_boxes: f64 = loads.iter().zip(&motions).map(|(f, u)| f[0].dot(&u[0]) + f[1].dot(&u[1])).sum();
    near(on_nodes, on_boxes, 1e-6 * on_boxes.abs().max(1.0), "virtual work");
}

/// Displacements along the normal and nose-up rotations of boxes in the motions of the nodes.
fn splined(wing: &LargeWing, shapes: &Mat<f64>) -> Mat<f64> {
    wing.elastic.structure.as_ref().expect("a structure").1.displace(shapes.as_ref())
}

#[test]
fn at_rest_small_motions_are_those_of_the_straight_wing() {
    let wing = with_arm(200.0, 100.0, 0.0).weightless().expect("at rest");
    let corrections = uneven(&wing.elastic.lattice);
    let (system, _) = wing.elastic.structure.as_ref().expect("a structure");
    let straight = normal_modes(system, 4).expect("modes");
    let (area, arm) = (CHORD_M / 8.0, CHORD_M / 8.0);
    for alpha in [0.0, 0.25_f64] {
        let still = case(0.0, alpha, 0.0);
        let state = solved(&wing, &still, &corrections);
        let motion = wing.small_motion(&still, &corrections, &state, 4).expect("a motion");
        let moved = splined(&wing, &motion.shapes);
        for mode in 0..4 {
            near(motion.omega_rad_s[mode] / straight.omega_rad_s[mode], 1.0, 1e-6, "frequency");
            let kg: f64 = motion
                .shapes
                .col(mode)
                .iter()
                .enumerate()
                .map(
                    |(dof, u)| {
                        if dof % 6 < 3 { u * u * if dof < 30 { MASS_KG } else { ARM_KG } } else { 0.0 }
                    },
                )
                .sum();
            near(kg, 1.0, 1e-6, "generalised mass");
            for j in 0..8 {
                let (h, theta) = (moved[(2 * j, mode)], moved[(2 * j + 1, mode)]);
                near(motion.incidence[(j, mode)], alpha.cos() * theta, 1e-6, "incidence");
                near(motion.heave[(j, mode)], h - theta * arm, 1e-6, "heave");
                if alpha == 0.0 {
                    let work = area * (corrections.force[j] * h + corrections.moment[j] * arm * theta);
                    near(motion.work[(mode, j)], work, 1e-7, "work of a pressure");
                }
            }
            (0..4).for_each(|other| near(motion.load_stiffness[(other, mode)], 0.0, 1e-9, "no load"));
        }
        assert!(moved.norm_max() > 0.3, "the boxes move");
    }
}

/// Pressures that answer incidences, and loads that turn with the boxes: both together are all that the air does.
#[test]
fn steady_work_is_that_of_pressures_and_of_loads_that_turn() {
    let wing = with_arm(80.0, 60.0, 0.03);
    let corrections = uneven(&wing.elastic.lattice);
    let (alpha, v) = (0.2, 14.0);
    let case = case(v, alpha, 0.1);
    let state = solved(&wing, &case, &corrections);
    assert!(state.tip_m.z > 0.02, "{}", state.tip_m.z);
    let motion = wing.small_motion(&case, &corrections, &state, 4).expect("a motion");
    let all = wing.following_work(&case, &corrections, &state, &motion).expect("steady work");
    let to_wake = Rotation3::from_axis_angle(&Vector3::y_axis(), alpha);
    let mut boxes = state.lattice.clone();
    for corner in boxes.boxes.iter_mut().flat_map(|panel| panel.corners.iter_mut()) {
        *corner = to_wake * *corner;
    }
    let seams = Seams::of(&wing.elastic.lattice, PLANE);
    let cp =
        SteadyAero::moved(&boxes, &seams, PLANE, 0.0).expect("boxes").pressures(motion.incidence.as_ref());
    let pressures = (&motion.work * &cp) * faer::Scale(case.flow.dynamic_pressure_pa());
    let size = motion.load_stiffness.norm_max();
    assert!(size > 0.01 * all.norm_max(), "loads that turn: {size} of {}", all.norm_max());
    for i in 0..4 {
        for mode in 0..4 {
            let both = pressures[(i, mode)] + motion.load_stiffness[(i, mode)];
            near(all[(i, mode)], both, 1e-5 * size, "work");
        }
    }
    // Doublets: sides along the stream at y and z of their middles.
    let closed = seams.closed(&boxes);
    for (j, panel) in motion.lattice.boxes.iter().enumerate() {
        let strip = &closed.boxes[2 * (j / 2)..2 * (j / 2) + 2];
        let side =
            |lead: usize, trail: usize| nalgebra::center(&strip[0].corners[lead], &strip[1].corners[trail]);
        let sides = [side(0, 1), side(3, 2)];
        for (corner, (own, of)) in panel.corners.iter().zip(&closed.boxes[j].corners).enumerate() {
            let side = sides[[0, 0, 1, 1][corner]];
            assert!(own.x == of.x && (own.y - side.y).abs() < 1e-12 && (own.z - side.z).abs() < 1e-12);
        }
    }
}

#[test]
fn tangent_modes_are_those_of_the_forces_beside_the_loaded_state() {
    let wing = with_arm(60.0, 40.0, 0.02);
    let corrections = neutral(&wing);
    let state = solved(&wing, &case(14.0, 0.2, 0.0), &corrections);
    let (modes, shapes) = wing.tangent_modes(&state, 4).expect("modes");
    assert_eq!((shapes.nrows(), shapes.ncols()), (36, 4));
    let dead = state
        .forces
        .chunks_exact(6)
        .enumerate()
        .map(|(node, six)| NodeLoad { node, force: three(six, 0), moment: three(six, 3) })
        .collect();
    let loads = Loads { dead, ..Loads::default() };
    let short = wing.structure.residual(&state.state, &loads);
    assert!(short.iter().all(|force| force.abs() < 1e-4), "no equilibrium: {short:?}");
    for mode in 0..4 {
        let shape: Vec<f64> = modes.shapes.col(mode).iter().copied().collect();
        let beside = |step: f64| {
            let motion: Vec<f64> = shape.iter().map(|u| u * step).collect();
            wing.structure.residual(&wing.structure.moved(&state.state, &motion), &loads)
        };
        let step = 1e-5;
        let work: f64 =
            beside(step).iter().zip(beside(-step)).zip(&shape).map(|((up, down), u)| (up - down) * u).sum();
        let squared = modes.omega_rad_s[mode].powi(2);
        near(work / (2.0 * step), squared, 1e-5 * squared, "stiffness in a mode");
    }
}

/// A family of corrections and its derivatives.
type Family = (f64, fn(&mut Corrections) -> &mut Vec<f64>, fn(&RootSensitivity) -> &Mat<f64>);

const FAMILIES: [Family; 3] = [
    (0.05, |c| &mut c.force, |s| &s.by_force),
    (0.15, |c| &mut c.moment, |s| &s.by_moment),
    (0.015, |c| &mut c.pressure_offset, |s| &s.by_offset),
];

#[test]
fn derivatives_of_readings_are_those_of_differences() {
    let mut wing = with_arm(90.0, 60.0, 0.02);
    wing.elastic.balance.point = Point3::new(0.1, -0.2, 0.05);
    wing.elastic.balance.metric[3] = false;
    let (about, case) = (uneven(&wing.elastic.lattice), case(18.0, 0.12, 0.05));
    let model = wing.model();
    let cases = std::slice::from_ref(&case);
    let own = model.sensitivities(cases, &about).expect("derivatives").remove(0);
    let state = solved(&wing, &case, &about);
    assert!(state.tip_m.z > 0.03, "{}", state.tip_m.z);
    for (own, of) in own.readings().into_iter().zip(state.root.to_array().into_iter().chain([state.tip_m.z]))
    {
        near(own, of, 1e-6 * (1.0 + of.abs()), "reading");
    }
    for (step, family, derivative) in FAMILIES {
        for phase in [0.0, 2.0_f64] {
            let along = |b: usize| (1.3 * b as f64 + phase).cos();
            let at = |step: f64| {
                let mut moved = about.clone();
                family(&mut moved).iter_mut().enumerate().for_each(|(b, value)| *value += step * along(b));
                let state = wing.continued_from(&state, &case, &case, &moved).expect("beside it");
                let [fz, mx, my] = state.root.to_array();
                [fz, mx, my, state.tip_m.z]
            };
            let [up, down, up_2, down_2] = [step, -step, 2.0 * step, -2.0 * step].map(at);
            for reading in 0..4 {
                let close = (up[reading] - down[reading]) / (2.0 * step);
                let far = (up_2[reading] - down_2[reading]) / (4.0 * step);
                let gradient = derivative(&own);
                let terms: Vec<f64> = (0..8).map(|b| gradient[(reading, b)] * along(b)).collect();
                let size: f64 = terms.iter().map(|term| term.abs()).sum();
                assert!(size > 1e-6);
                near(terms.iter().sum(), (4.0 * close - far) / 3.0, 1e-5 * size, "derivative");
            }
        }
    }
}

#[test]
fn without_wind_no_correction_is_felt_and_a_model_is_its_wing() {
    let wing = half_wing(120.0, 80.0, 0.02);
    let (model, corrections) = (wing.model(), uneven(&wing.elastic.lattice));
    let still = model.sensitivities(&[case(0.0, 0.3, 0.0)], &corrections).expect("derivatives").remove(0);
    assert!(still.by_force.norm_max() == 0.0 && still.by_offset.norm_max() == 0.0);
    let relieved = 5.0 * MASS_KG * GRAVITY_M_S2 * (1.0 - 0.3_f64.cos());
    near(still.loads.fz_n, relieved, 1e-9, "the tilt takes off weight");
    let cases = [case(15.0, 0.05, 0.0), case(15.0, 0.05, 0.2), case(15.0, 0.1, 0.0), case(18.0, 0.05, 0.0)];
    for corrections in [neutral(&wing), corrections] {
        for _ in 0..2 {
            let roots = model.root_loads(&cases, &corrections).expect("loads");
            let tips = model.tip_deflections(&cases, &corrections).expect("tips");
            for (i, case) in cases.iter().enumerate() {
                let alone = solved(&wing, case, &corrections);
                near(roots[i].fz_n, alone.root.fz_n, 1e-5, "lift");
                near(tips[i], alone.tip_m.z, 1e-6, "tip");
                (0..i).for_each(|j| assert!((roots[i].fz_n - roots[j].fz_n).abs() > 0.1, "{i} and {j}"));
            }
        }
    }
    let cp = model.pressure_coefficients(&cases[0]).expect("pressures");
    // Found on another way: what Newton's steps leave apart.
    cp.iter()
        .zip(solved(&wing, &cases[0], &neutral(&wing)).cp)
        .for_each(|(a, b)| near(*a, b, 1e-9, "pressure"));
    assert!(model.bends_far() && model.has_tip() && model.correctable().len() == 8);
}

#[test]
fn a_rigid_wing_cannot_bend() {
    let deck = super::samples::beam(&[0.0, 0.5, 1.0], 1e3, 1e3, 0);
    let refused = LargeWing::new(flying_boxes(0.0), &model_of(&deck), SplineKind::Beam, &[0, 1, 2]);
    assert!(matches!(refused, Err(CouplingError::Input(error)) if error.to_string().contains("rigid")));
    let wing = half_wing(120.0, 80.0, 0.02);
    assert!(wing.solve(&[case(10.0, 0.0, 0.0)], &Corrections::neutral(7)).is_err());
}
