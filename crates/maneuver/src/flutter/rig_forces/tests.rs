//! What is unsteady in pressures, by hand.

use super::*;
use crate::RigSettings;
use crate::air::AirModel;
use crate::small::{goland, rigid};

#[test]
fn a_factor_multiplies_what_pressures_have_beyond_the_steady_answer() {
    let of = |re: f64, im: f64| Mat::from_fn(2, 1, |i, _| c64::new(re + i as f64, im));
    let pressures = ModePressures {
        omega_over_v: vec![0.5, 1.0],
        motion: Mat::from_fn(4, 1, |i, _| i as f64),
        cp: vec![of(3.0, 1.0), of(5.0, -2.0)],
        steady: vec![of(1.0, 0.0), of(2.0, 0.5)],
    };
    let half = pressures.with_unsteady(0.25);
    for (found, wanted) in half.cp.iter().zip([of(1.5, 0.25), of(2.75, -0.125)]) {
        assert!((found - wanted).norm_max() < 1e-12);
    }
    assert_eq!(
        (half.omega_over_v.len(), half.motion[(3, 0)], half.steady == pressures.steady),
        (2, 3.0, true)
    );
}

#[test]
fn boxes_of_a_rigid_wing_have_motions_but_no_modes() {
    let bent = goland().elastic;
    let settings = || RigSettings { modes: 2, air: AirModel::QuasiSteady, ..RigSettings::new(0.02, 0.6) };
    let rigid = rigid([2, 4], |_| 0.0);
    let motion = Rig::new(&rigid, settings()).expect("a rig").box_motion();
    assert_eq!((motion.nrows(), motion.ncols()), (16, 0));
    let motion = Rig::new(&bent, settings()).expect("a rig").box_motion();
    assert_eq!((motion.nrows(), motion.ncols()), (16, 2));
    // the first mode bends: boxes heave the more the farther out they are, in one direction
    let heave: Vec<f64> = (0..4).map(|strip| motion[(4 * strip, 0)] / motion[(12, 0)]).collect();
    assert!(heave[0] > 0.0 && heave.windows(2).all(|pair| pair[1] > 1.5 * pair[0]), "{heave:?}");
}
