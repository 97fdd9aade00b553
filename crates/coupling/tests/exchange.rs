//! Corrections for programs that know neither WKK nor FA2J: what is carried is carried exactly.

use aero::{Corrections, Flow};
use coupling::{ElasticWing, Exchange, SteadyCase};
use std::path::Path;

fn example() -> ElasticWing {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/own_wing/wing.ron");
    ElasticWing::read(&path).expect("the shipped example").1
}

/// Corrections that differ from box to box.
fn uneven(boxes: usize) -> Corrections {
    let wave = |i: usize, factor: f64| (factor * i as f64).sin();
    Corrections {
        force: (0..boxes).map(|i| 1.0 + 0.4 * wave(i, 0.7)).collect(),
        moment: (0..boxes).map(|i| 1.0 + 0.3 * wave(i, 1.3)).collect(),
        pressure_offset: (0..boxes).map(|i| 0.1 * wave(i, 0.3)).collect(),
    }
}

#[test]
fn pressures_of_any_incidence_are_those_of_the_corrected_model() {
    let wing = example();
    let corrections = uneven(wing.correctable.len());
    let exchange = Exchange::of(&wing, &corrections).expect("no factor is zero");
    let padded = wing.padded(&corrections).expect("one a box");
    let boxes = wing.lattice.len();
    // An incidence as camber, bending and a surface together make it: something in every box.
    let w = faer::Mat::from_fn(boxes, 1, |j, _| 0.05 + 0.03 * (1.7 * j as f64).cos());
    let theory = wing.pressures(w.as_ref());
    let added =
        faer::Mat::from_fn(boxes, 1, |j, _| w[(j, 0)] + exchange.w2gj_rad[j] - exchange.camber_rad[j]);
    let carried = &exchange.qjj * &added;
    for j in 0..boxes {
        let corrected = padded.force[j] * theory[(j, 0)] + padded.pressure_offset[j];
        assert!((carried[(j, 0)] - corrected).abs() < 1e-11, "box {j}: {} and {corrected}", carried[(j, 0)]);
    }
}

#[test]
fn a_force_factor_of_zero_cannot_be_carried_and_is_refused() {
    let wing = example();
    let mut corrections = uneven(wing.correctable.len());
    corrections.force[17] = 0.0;
    let refused = Exchange::of(&wing, &corrections).expect_err("an offset there cannot be an incidence");
    assert!(refused.to_string().contains("force factor"), "{refused}");
}

#[test]
fn what_is_left_out_are_the_moment_factors_alone() {
    let wing = example();
    let flow = Flow { v_m_s: 20.0, rho_kg_m3: 1.2 };
    let mut corrections = uneven(wing.correctable.len());
    let loads = |corrections: &Corrections| {
        let operator = wing.at(flow, corrections).expect("below divergence");
        operator.solve(&[SteadyCase::new(flow, 0.05)])[0].root.to_array()
    };
    let difference = Exchange::left_out(&wing, &corrections, flow, 0.05).expect("below divergence");
    let mut carried = corrections.clone();
    carried.moment.clone_from(&carried.force);
    let (all, without) = (loads(&corrections), loads(&carried));
    for c in 0..3 {
        assert!((difference.complete.to_array()[c] - all[c]).abs() < 1e-12);
        assert!((difference.carried.to_array()[c] - without[c]).abs() < 1e-12);
    }
    corrections.moment.clone_from(&corrections.force);
    let nothing = Exchange::left_out(&wing, &corrections, flow, 0.05).expect("below divergence");
    assert_eq!(nothing.complete, nothing.carried);
}
