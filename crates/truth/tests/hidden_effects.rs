//! Laws of what is hidden: sizes of zero change no number, sizes that a tunnel sees show, the reference never knows, and one
//! order gives one campaign.

use std::path::Path;
use truth::campaign::Measured;
use truth::effects::Effect;
use truth::rig::Fineness;
use truth::{Order, Tunnel};

/// Every effect with sizes of the middle of what is drawn.
const SIZES: [(&str, &[f64]); 40] = [
    ("ac_shift", &[0.02]),
    ("act_lag", &[0.03]),
    ("act_rate", &[0.4]),
    ("added_mass", &[0.5]),
    ("aero_lag", &[1.0]),
    ("alpha_encoder", &[0.03]),
    ("alpha_offset", &[0.5]),
    ("backlash", &[1.5]),
    ("balance_creep", &[0.1, 0.5]),
    ("balance_nonlin", &[0.1, 1.0]),
    ("bend_stiff", &[0.2]),
    ("cable_stiffness", &[8.0]),
    ("camber", &[0.5, 0.01]),
    ("crosstalk", &[0.03]),
    ("ctl_alpha_interaction", &[3.0]),
    ("ctl_asym", &[0.2]),
    ("ctl_compliance", &[0.3]),
    ("ctl_saturation", &[2.0]),
    ("ctl_scale", &[0.15]),
    ("damping", &[3.0]),
    ("daq_filter", &[0.15]),
    ("delay", &[0.02]),
    ("delta_offset", &[1.0, 1.0]),
    ("drift", &[1.5, 0.0]),
    ("flow_upwash_gradient", &[0.5]),
    ("friction", &[-0.7]),
    ("gain", &[0.1, 2.0]),
    ("inplane_force", &[0.8, 0.01]),
    ("joiner_inertia", &[0.1, -0.2, 0.2]),
    ("large_deflection", &[1.0]),
    ("lift_slope", &[0.1]),
    ("mx_alpha_squared", &[0.4]),
    ("q_error", &[0.08]),
    ("re_dependence", &[0.2]),
    ("shedding_tone", &[1.5, 0.5]),
    ("stall", &[0.6, 4.0]),
    ("tip_loss", &[0.3]),
    ("tip_mass", &[0.12, 0.9, 0.4]),
    ("tors_stiff", &[0.4]),
    ("wing_mass_error", &[0.15]),
];

/// Coarse and quick: the machinery, not a truth.
fn tunnel() -> Tunnel {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
    let coarse = Fineness { chordwise: 4, strips_per_m: 5.0, step_over_chord: 0.4, slices: 16, modes: 8 };
    let (wing, polars) = (data.join("wing_beam.ron"), data.join("e214_neuralfoil_polars.csv"));
    Tunnel::divided(&wing, &polars, coarse).expect("the shipped wing")
}

fn measured(tunnel: &Tunnel, sizes: &[(&str, &[f64])], seed: u64) -> Measured {
    let effect = |(name, values): &(&str, &[f64])| Effect { name: (*name).into(), values: values.to_vec() };
    tunnel.measure(&Order {
        seed,
        wing: Some(3),
        effects: sizes.iter().map(effect).collect(),
        servo: None,
        wind_off: false,
    })
}

/// Largest change of a load in runs over its noise, and of the angle.
fn change(a: &Measured, b: &Measured) -> f64 {
    let noise = [0.2, 0.12, 0.05];
    let mut most = 0.0_f64;
    for (a, b) in a.records.iter().zip(&b.records) {
        for ((x, y), noise) in a.loads.iter().zip(&b.loads).zip(noise) {
            for (x, y) in x.iter().zip(y) {
                most = most.max((x - y).abs() / noise);
            }
        }
        for (x, y) in a.alpha_deg.iter().zip(&b.alpha_deg) {
            most = most.max((x - y).abs() / 0.005);
        }
    }
    most
}

#[test]
fn effects_of_size_zero_change_no_number() {
    let tunnel = tunnel();
    let zeros: Vec<(&str, &[f64])> = SIZES.iter().map(|(name, _)| (*name, &[0.0; 3][..])).collect();
    assert!(measured(&tunnel, &zeros, 4) == measured(&tunnel, &[], 4));
}

#[test]
fn every_effect_shows_and_the_reference_never_knows() {
    let tunnel = tunnel();
    let none = measured(&tunnel, &[], 4);
    assert!(none.is_bounded());
    for sizes in SIZES {
        let with = measured(&tunnel, &[sizes], 4);
        let most = change(&with, &none);
        assert!(most > 3.0, "{}: {most:.2} standard deviations of a sample", sizes.0);
        assert!(with.reference == none.reference, "{}", sizes.0);
    }
}

#[test]
fn one_order_gives_one_campaign_and_another_wing_another() {
    let tunnel = tunnel();
    let one = measured(&tunnel, &[], 4);
    assert!(one == measured(&tunnel, &[], 4));
    assert!(change(&one, &measured(&tunnel, &[], 5)) > 3.0);
    let other =
        tunnel.measure(&Order { seed: 4, wing: Some(4), effects: Vec::new(), servo: None, wind_off: false });
    assert!(change(&one, &other) > 3.0);
}
