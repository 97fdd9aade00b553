//! The V-n envelope against its closed form, strips against the lift they add up to, and warnings where they are due.

use crate::common::{assert_near, whole};
use coupling::GRAVITY_M_S2;
use fullaircraft::LiftLimits;
use fullaircraft::aircraft::lift_limits::{lift_limits, limits_at};

#[test]
fn limits_are_linear_between_polars_and_constant_beyond() {
    let limits = [LiftLimits { v_m_s: 20.0, cl: [-0.4, 1.4] }, LiftLimits { v_m_s: 40.0, cl: [-0.6, 1.6] }];
    assert_eq!(limits_at(&limits, 10.0), [-0.4, 1.4]);
    assert_eq!(limits_at(&limits, 50.0), [-0.6, 1.6]);
    let [least, most] = limits_at(&limits, 30.0);
    assert!((least + 0.5).abs() < 1e-12 && (most - 1.5).abs() < 1e-12);
}

#[test]
fn the_stall_line_is_lift_at_the_limit_over_weight_and_ends_at_the_limit_load_factors() {
    let aircraft = whole();
    let envelope = aircraft.envelope(&[LiftLimits { v_m_s: 30.0, cl: [-0.45, 1.155] }]);
    let last = envelope.v_m_s.len() - 1;
    assert_near("last airspeed", envelope.v_m_s[last], 42.0, 1e-12);
    let by_hand = 0.5 * 1.225 * 42.0 * 42.0 * 0.81 / (20.0 * GRAVITY_M_S2);
    assert_near("upper stall line", envelope.stall[1][last], 1.155 * by_hand, 1e-3);
    assert_near("lower stall line", envelope.stall[0][last], -0.45 * by_hand, 1e-3);
    assert_eq!(envelope.limit[1][last], 4.0);
    assert_eq!(envelope.limit[0][0], 0.0);
}

#[test]
fn strips_add_up_to_the_wings_lift_and_the_push_down_leaves_the_polars() {
    let aircraft = whole();
    let model = aircraft.uncorrected();
    let level = model.trim("trim", &aircraft.file.trim).unwrap();
    let lift = aircraft.strip_lift(&aircraft.right, &level);
    assert_eq!(lift.len(), 56);
    let boxes: f64 = aircraft.right.boxes.iter().map(|at| level.box_loads[2 * at]).sum();
    let q_pa = 0.5 * 1.225 * 25.7 * 25.7;
    // All boxes of a strip are as wide as it; strips' areas come from the boxes.
    let areas: Vec<f64> = aircraft
        .right
        .boxes
        .chunks(12)
        .map(|strip| strip.iter().map(|at| aircraft.flow.lattice.boxes[*at].area_m2()).sum())
        .collect();
    let summed: f64 = lift.iter().zip(&areas).map(|(cl, area)| cl * area * q_pa).sum();
    assert_near("lift of the strips", summed, boxes, 1e-9);
    let limits = aircraft.file.lift_limits().unwrap().expect("the shipped aircraft names polars");
    assert!(aircraft.validity("trim", &level, Some(&limits)).is_empty());
    // Minus 2 g needs a lift coefficient of -0.45; the polars end at -8 degrees with -0.38 and more.
    let down = model.trim("push_down", &aircraft.file.push_down).unwrap();
    let text = aircraft.validity("push_down", &down, Some(&limits)).join(" ");
    assert!(text.contains("strips leave the section's polar"), "{text}");
    let up = model.trim("pull_up", &aircraft.file.pull_up).unwrap();
    assert!(aircraft.validity("pull_up", &up, None)[0].contains("% of the semispan"));
}

#[test]
fn a_polar_that_is_no_number_is_refused_with_its_line() {
    let path = std::env::temp_dir().join(format!("polars_{}.csv", std::process::id()));
    std::fs::write(&path, "V_mps,Re,alpha_deg,cl\n18,1,0,0.5\n18,1,1,nought\n").unwrap();
    let refused = lift_limits(&path).unwrap_err().to_string();
    std::fs::remove_file(&path).unwrap();
    assert!(refused.contains("line 3"), "{refused}");
}
