//! Flight of small bodies beside sums over their boxes: forces across the stream and moments vanish.

use super::super::samples::{
    AXIS_M, CHORD_M, MASS_KG, NOSE_ARM_M, NOSE_KG, beam, body, flying_boxes, model, uneven,
};
use super::*;
use crate::GRAVITY_M_S2;
use aero::{MirrorPlane, Seams, SteadyAero};

const V_M_S: f64 = 25.0;
const RHO: f64 = 1.2;
/// So stiff that nothing bends: N m^2.
const RIGID: f64 = 1e8;
/// Of all masses.
const KG: f64 = 5.0 * MASS_KG + NOSE_KG;

fn level(elastic: &ElasticWing, load_factor: f64) -> SteadyFlight {
    SteadyFlight {
        flow: Flow { v_m_s: V_M_S, rho_kg_m3: RHO },
        load_factor,
        pitch_rate_rad_s: 0.0,
        about: Point3::new(AXIS_M, 0.0, 0.0),
        control: Some(elastic.controls[0].column(elastic.lattice.len())),
        wake: Wake::Stream,
    }
}

fn neutral(elastic: &ElasticWing) -> Corrections {
    Corrections::neutral(elastic.lattice.len())
}

/// Lifts and moments of undeformed boxes by the angles at their three-quarter points alone.
fn by_hand(
    elastic: &ElasticWing,
    flight: &SteadyFlight,
    corrections: &Corrections,
    [alpha, flap]: [f64; 2],
) -> Vec<[f64; 2]> {
    let turn = match flight.wake {
        Wake::Stream => alpha,
        Wake::Body => 0.0,
    };
    let turn_boxes = Rotation3::from_axis_angle(&Vector3::y_axis(), turn);
    let mut boxes = elastic.lattice.clone();
    for corner in boxes.boxes.iter_mut().flat_map(|panel| panel.corners.iter_mut()) {
        *corner = turn_boxes * *corner;
    }
    let seams = Seams::of(&elastic.lattice, MirrorPlane::None);
    let solved = SteadyAero::moved(&boxes, &seams, MirrorPlane::None, 0.0).expect("boxes");
    let nothing = vec![0.0; elastic.lattice.len()];
    let slopes = flight.control.as_ref().unwrap_or(&nothing);
    let w: Vec<f64> = elastic
        .lattice
        .boxes
        .iter()
        .enumerate()
        .map(|(j, panel)| {
            let aft_m = panel.three_quarter_point().x - flight.about.x;
            alpha.sin()
                + alpha.cos() * (elastic.camber[j] + slopes[j] * flap)
                + aft_m * flight.pitch_rate_rad_s / V_M_S
        })
        .collect();
    let q_pa = 0.5 * RHO * V_M_S * V_M_S;
    // Circulation is by the chord along the wake.
    let cp = solved.pressures_of(&w).into_iter().map(|cp| cp * turn.cos());
    let (area, arm) = (2.0 * CHORD_M / 16.0, CHORD_M / 8.0);
    cp.enumerate()
        .map(|(j, cp)| {
            let offset = corrections.pressure_offset[j];
            [corrections.force[j] * cp + offset, arm * (corrections.moment[j] * cp + offset)]
                .map(|load| load * q_pa * area)
        })
        .collect()
}

fn near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} beside {expected}");
}

#[test]
fn a_rigid_body_flies_where_the_loads_of_its_boxes_carry_and_turn_it_as_its_weight_asks() {
    let boxes = flying_boxes(0.03);
    let rigid = body(&boxes, RIGID, RIGID, 2);
    near(rigid.weight_n(), KG * GRAVITY_M_S2, 1e-10, "weight");
    let corrections = uneven(&boxes.lattice);
    for (wake, load_factor, pitch_rate_rad_s) in [(Wake::Stream, 2.5, 0.7), (Wake::Body, -1.5, -0.4)] {
        let about = Point3::new(-0.4, 0.3, 0.2);
        let flight = SteadyFlight { pitch_rate_rad_s, about, wake, ..level(&boxes, load_factor) };
        let found = rigid.fly(&flight, &corrections).expect("it flies");
        let alpha = found.alpha_rad;
        let loads = by_hand(&boxes, &flight, &corrections, [alpha, found.control_rad]);
        for (j, own) in loads.iter().enumerate() {
            near(found.box_loads.values[2 * j], own[0], 1e-4, "lift");
            near(found.box_loads.values[2 * j + 1], own[1], 1e-4, "moment");
        }
        let felt = load_factor * GRAVITY_M_S2;
        let lift: f64 = loads.iter().map(|own| own[0]).sum();
        near(lift, KG * felt, 1e-4, "lift and weight");
        let arms = boxes.lattice.boxes.iter().zip(&loads);
        let nose_up: f64 = arms.map(|(panel, own)| own[1] - (panel.mid_point().x - AXIS_M) * own[0]).sum();
        // The mass in front pulls the nose down.
        near(nose_up, NOSE_ARM_M * NOSE_KG * felt, 1e-4, "moments");
        for (node, six) in found.inertia.chunks_exact(6).enumerate() {
            let kg = if node == 5 { NOSE_KG } else { MASS_KG };
            let expected = [kg * felt * alpha.sin(), 0.0, -kg * felt * alpha.cos(), 0.0, 0.0, 0.0];
            six.iter().zip(expected).for_each(|(own, of)| near(*own, of, 1e-7, "weight of a grid"));
        }
        let along: f64 = found.air.chunks_exact(6).map(|six| six[0]).sum();
        near(along, -lift * alpha.sin(), 1e-4, "lift stands on the stream");
        assert!(found.held.iter().all(|load| load.abs() < 1e-4), "the hold gives {:?}", found.held);
        assert!(alpha.abs() > 0.01 && found.control_rad.abs() > 0.01, "{alpha}, {}", found.control_rad);
        assert!(found.iterations > 0 && found.lattice.len() == 16);
    }
}

/// Of rigid boxes without camber whose wake leaves along them: lift is q (d lift / d alpha) sin alpha.
fn load_factor_by_sine(boxes: &ElasticWing) -> f64 {
    let by_alpha = boxes.pressures_by_alpha();
    let slope: f64 = by_alpha.iter().zip(&boxes.lattice.boxes).map(|(cp, panel)| cp * panel.area_m2()).sum();
    0.5 * RHO * V_M_S * V_M_S * slope / (KG * GRAVITY_M_S2)
}

#[test]
fn steep_flight_is_found_as_flat_flight_up_to_a_radian() {
    let boxes = flying_boxes(0.0);
    let rigid = body(&boxes, RIGID, RIGID, 2);
    for angle_rad in [0.1, 0.7, 0.8, -0.8, 0.99] {
        let load_factor = f64::sin(angle_rad) * load_factor_by_sine(&boxes);
        let flight = SteadyFlight { control: None, wake: Wake::Body, ..level(&boxes, load_factor) };
        let flying = rigid.flying(&flight, &neutral(&boxes), 1.0);
        let undeformed = rigid.structure.undeformed();
        let found = flying.balanced(&undeformed).expect("it is found from no angle");
        near(found.trim[0], angle_rad, 1e-9, "angle of attack of the undeformed body");
        let flown = rigid.fly(&flight, &neutral(&boxes)).expect("it flies");
        near(flown.alpha_rad, angle_rad, 1e-5, "angle of attack");
    }
}

#[test]
fn without_a_control_the_hold_takes_the_moment_alone() {
    let boxes = flying_boxes(0.0);
    let rigid = body(&boxes, RIGID, RIGID, 2);
    let flight = SteadyFlight { control: None, wake: Wake::Body, ..level(&boxes, 1.0) };
    let found = rigid.fly(&flight, &neutral(&boxes)).expect("it flies");
    near(found.alpha_rad.sin(), 1.0 / load_factor_by_sine(&boxes), 1e-6, "angle of attack");
    assert_eq!(found.control_rad, 0.0);
    let loads = by_hand(&boxes, &flight, &neutral(&boxes), [found.alpha_rad, 0.0]);
    let arms = boxes.lattice.boxes.iter().zip(&loads);
    let nose_up: f64 = arms.map(|(panel, own)| own[1] - (panel.mid_point().x - AXIS_M) * own[0]).sum();
    let whole = found.alpha_rad.cos() * (nose_up - NOSE_ARM_M * NOSE_KG * GRAVITY_M_S2);
    assert!(whole.abs() > 1.0, "out of balance: {whole}");
    near(found.held[4], -whole, 1e-4, "the hold's moment");
    for part in [0, 1, 2, 3, 5] {
        near(found.held[part], 0.0, 1e-6, "the hold's other parts");
    }
}

#[test]
fn what_its_lift_cannot_carry_is_refused_with_the_load_factor_that_it_can() {
    let boxes = flying_boxes(0.0);
    let rigid = body(&boxes, RIGID, RIGID, 2);
    let asked = 60.0;
    let flight = SteadyFlight { control: None, wake: Wake::Body, ..level(&boxes, asked) };
    // No angle beyond a radian is looked for.
    let most = 1.0_f64.sin() * load_factor_by_sine(&boxes);
    assert!(most > 2.0 && most < 0.8 * asked, "{most}");
    match rigid.fly(&flight, &neutral(&boxes)).expect_err("too much") {
        CouplingError::NotBalanced { v_m_s, load_factor, reached, .. } => {
            assert!(v_m_s == V_M_S && load_factor == asked);
            assert!(reached < most && reached > 0.999 * most, "reached {reached}, of at most {most}");
        }
        other => panic!("{other}"),
    }
}

#[test]
fn a_body_without_weight_does_not_fly() {
    let parts = [CarriedPart { boxes: [0, 16], kind: crate::SplineKind::Beam, nodes: (0..5).collect() }];
    let mut boxes = flying_boxes(0.0);
    let deck = beam(&[-1.0, -0.5, 0.0, 0.5, 1.0], 1e4, 1e4, 2);
    assert!(FreeBody::new(&boxes, &model(&deck), 2, &parts).is_ok());
    let massless = deck.lines().filter(|l| !l.starts_with("CONM2")).collect::<Vec<_>>().join("\n");
    let refused = FreeBody::new(&boxes, &model(&massless), 2, &parts).expect_err("no mass");
    assert!(refused.to_string().contains("without mass"), "{refused}");
    boxes.gravity_m_s2 = 0.0;
    assert!(FreeBody::new(&boxes, &model(&deck), 2, &parts).is_err());
}

#[test]
fn a_body_bends_the_same_wherever_it_is_held() {
    let boxes = flying_boxes(0.02);
    let corrections = uneven(&boxes.lattice);
    let flight = level(&boxes, 2.0);
    let flown = [2, 5].map(|held| {
        let soft = body(&boxes, 40.0, 60.0, held);
        let found = soft.fly(&flight, &corrections).expect("it flies");
        let inner = soft.structure.inner_forces(&found.state);
        for (dof, inner) in inner.iter().enumerate() {
            near(*inner, found.air[dof] + found.inertia[dof], 2e-4, "equilibrium of a grid");
        }
        assert!(found.held.iter().all(|load| load.abs() < 1e-6), "the hold gives {:?}", found.held);
        assert!(found.iterations <= 12, "Newton's method took {} iterations", found.iterations);
        let places = found.state.places.clone();
        let bent = 0.5 * (places[0].z + places[4].z) - places[2].z;
        (found, bent)
    });
    let [(a, bent), (b, _)] = flown;
    assert!(bent > 0.05, "the tips rise by {bent} m");
    near(a.control_rad, b.control_rad, 2e-6, "the flap");
    assert!((a.alpha_rad - b.alpha_rad).abs() > 1e-4, "the mass in front hangs down: {}", a.alpha_rad);
    for (j, (a, b)) in a.box_loads.values.iter().zip(&b.box_loads.values).enumerate() {
        near(*a, *b, 1e-4, &format!("load {j}"));
    }
    for (left, right) in [(0, 4), (1, 3)] {
        near(a.state.places[left].z, a.state.places[right].z, 1e-9, "both sides");
    }
    for (one, other) in [(0, 4), (0, 2), (1, 5)] {
        let apart = |state: &State| (state.places[one] - state.places[other]).norm();
        near(apart(&a.state), apart(&b.state), 1e-6, "distances");
    }
}

#[test]
fn beside_a_state_forces_begin_with_those_at_it_and_turn_as_the_trim_says() {
    let boxes = flying_boxes(0.02);
    let soft = body(&boxes, 40.0, 60.0, 2);
    let corrections = uneven(&boxes.lattice);
    for control in [true, false] {
        let mut flight = level(&boxes, 2.0);
        if !control {
            flight.control = None;
        }
        let state = soft.structure.undeformed();
        let flying = soft.flying(&flight, &corrections, 0.5);
        assert!(Acting::follows(&flying));
        let balancing = flying.balanced(&state).expect("a balance");
        assert_eq!(*flying.known.lock().expect("a number"), balancing.trim);
        let (at, following) = (Near::forces(&balancing), Near::following(&balancing, &state));
        assert!(at.len() == following.len() && at.len() == 36);
        assert!(at.iter().any(|force| force.abs() > 1.0));
        at.iter().zip(&following).for_each(|(a, b)| near(*a, *b, 1e-8, "the same state"));
        let [air, inertia] = balancing.forces_at(&state, balancing.trim);
        for (dof, at) in at.iter().enumerate() {
            near(*at, air[dof] + inertia[dof], 1e-12, "air and weight");
        }
        // The whole turned with its hold flies as before, as the stream stays: all forces turn with it.
        let turn = Rotation3::from_axis_angle(&Vector3::y_axis(), -0.05);
        let turned = balancing.following(&state.turned(&turn));
        for (node, (a, b)) in at.chunks_exact(6).zip(turned.chunks_exact(6)).enumerate() {
            for part in [0, 3] {
                let [there, here] = [a, b].map(|six| Vector3::from_column_slice(&six[part..part + 3]));
                assert!((turn * there - here).norm() < 1e-6, "node {node}: {b:?}, turned {a:?}");
            }
        }
        assert!(control || balancing.trim[1] == 0.0);
    }
}

#[test]
fn the_matrix_of_the_balance_undoes_the_change_of_lift_and_moment() {
    let boxes = flying_boxes(0.02);
    let soft = body(&boxes, 40.0, 60.0, 2);
    let state = soft.structure.undeformed();
    let flight = level(&boxes, 2.0);
    let flying = soft.flying(&flight, &neutral(&boxes), 1.0);
    let balancing = flying.balanced(&state).expect("a balance");
    let at = [0.05, -0.1];
    let change: [[f64; 2]; 2] = [0, 1].map(|which| {
        let beside = |step: f64| {
            let mut at = at;
            at[which] += step;
            balancing.unbalanced(&state, at)
        };
        let (up, down) = (beside(1e-4), beside(-1e-4));
        [0, 1].map(|part| (up[part] - down[part]) / 2e-4)
    });
    let inverse = balancing.differences(&state, at).expect("an inverse");
    for (i, row) in inverse.iter().enumerate() {
        for (which, change) in change.iter().enumerate() {
            let product = row[0] * change[0] + row[1] * change[1];
            near(product, f64::from(u8::from(i == which)), 5e-3, "inverse times matrix");
        }
    }
    let alone = SteadyFlight { control: None, ..flight.clone() };
    let flying = soft.flying(&alone, &neutral(&boxes), 1.0);
    let balancing = flying.balanced(&state).expect("a balance");
    let inverse = balancing.differences(&state, at).expect("an inverse");
    assert!(inverse[0][1] == 0.0 && inverse[1] == [0.0; 2]);
    let lift = |alpha: f64| balancing.unbalanced(&state, [alpha, at[1]])[0];
    near(inverse[0][0] * (lift(at[0] + 1e-4) - lift(at[0] - 1e-4)) / 2e-4, 1.0, 5e-3, "by the angle alone");
    // Without air nothing is lifted, whatever the angle; a flap that does nothing balances nothing.
    let still = SteadyFlight { flow: Flow { v_m_s: V_M_S, rho_kg_m3: 0.0 }, load_factor: 0.0, ..alone };
    assert!(soft.flying(&still, &neutral(&boxes), 1.0).balanced(&state).is_none());
    let idle = SteadyFlight { control: Some(vec![0.0; 16]), ..flight };
    assert!(soft.flying(&idle, &neutral(&boxes), 1.0).balanced(&state).is_none());
}

#[test]
fn sums_about_the_hold_count_forces_moments_and_arms() {
    let boxes = flying_boxes(0.0);
    let rigid = body(&boxes, RIGID, RIGID, 1);
    let mut state = rigid.structure.undeformed();
    state.places[4] += Vector3::new(0.3, -0.1, 0.4);
    let mut forces = vec![0.0; 36];
    forces[24..30].copy_from_slice(&[2.0, -3.0, 5.0, 0.7, -0.4, 0.9]);
    forces[6..12].copy_from_slice(&[1.0, 1.5, -2.5, 0.1, 0.2, 0.3]);
    // Grid 5 is 1.5 m right of the hold at grid 2, moved by (0.3, -0.1, 0.4): arm (0.3, 1.4, 0.4).
    let arm = [0.3, 1.4, 0.4];
    let expected = [
        3.0,
        -1.5,
        2.5,
        0.8 + arm[1] * 5.0 + arm[2] * 3.0,
        -0.2 + arm[2] * 2.0 - arm[0] * 5.0,
        1.2 - arm[0] * 3.0 - arm[1] * 2.0,
    ];
    rigid.resultant(&state, &forces).iter().zip(expected).for_each(|(a, b)| near(*a, b, 1e-12, "sum"));
    let fields = rigid.fields(&rigid.structure.undeformed());
    for (field, axis) in fields.iter().zip([0, 2]) {
        for (dof, force) in field.iter().enumerate() {
            let kg = if dof / 6 == 5 { NOSE_KG } else { MASS_KG };
            near(*force, if dof % 6 == axis { kg } else { 0.0 }, 1e-12, "a unit field");
        }
    }
}
