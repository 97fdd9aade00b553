//! Runs that are a multiple of their model.

use super::*;
use crate::history::TimeHistory;

fn said(v_m_s: f64, fz: f64, mx: f64) -> Option<String> {
    let wave: Vec<f64> = (0..20).map(|k| 3.0 + f64::from(k).sin()).collect();
    let times = |factor: f64| wave.iter().map(|x| factor * x - 7.0).collect::<Vec<f64>>();
    let mut history = TimeHistory::default();
    history.push("Fz_N", wave.clone());
    history.push("Mx_Nm", wave.clone());
    let run = Run {
        name: "run".into(),
        t_s: (0..20).map(|k| 0.01 * f64::from(k)).collect(),
        time_step_s: 0.01,
        v_m_s,
        alpha_rad: vec![0.0; 20],
        loads: Some([times(fz), times(mx), times(1.0)]),
        some_loads: [None, None, None],
        controls_rad: Vec::new(),
        tip_z_m: None,
        accelerations: Vec::new(),
    };
    of_run(&run, &Simulated { history, residual_rms: None, residual_percent: None })
}

#[test]
fn both_loads_must_be_near_the_factor_of_a_mistaken_unit() {
    for (factor, words) in [(57.3, "radians"), (1e-3, "kN"), (1e3, "mN")] {
        for near in [1.0 / 1.7, 1.0, 1.7] {
            let text = said(20.0, factor * near, factor * near).expect("a mistaken unit");
            assert!(text.contains(words) && text.contains("times as much as in the model"), "{text}");
        }
        assert!(
            said(20.0, factor * 1.9, factor * 1.9).is_none()
                && said(20.0, factor / 1.9, factor / 1.9).is_none()
        );
        assert!(said(20.0, factor, factor * 1.9).is_none() && said(20.0, factor * 1.9, factor).is_none());
        assert!(said(0.0, factor, factor).is_none(), "without wind");
        assert!(said(20.0, 0.0, factor).is_none() && said(20.0, factor, 0.0).is_none());
    }
    assert!(said(20.0, 1.0, 1.0).is_none());
    // the mean of both is the geometric one: 1.7 and 1/1.05
    let text = said(20.0, 57.3 * 1.7, 57.3).expect("radians");
    assert!(text.contains(&format!("{:.3} times", 57.3 * 1.7_f64.sqrt())), "{text}");
    assert!((variation(&[1.0, 3.0, 1.0, 3.0]) - 1.0).abs() < 1e-12);
}
