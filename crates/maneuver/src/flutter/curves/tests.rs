//! Which crossing is flutter, and their order along the flows.

use super::*;

fn crossing(v_m_s: f64, rho_kg_m3: f64, omega_rad_s: f64, unstable: bool) -> Crossing {
    Crossing { branch: 0, flow: Flow { v_m_s, rho_kg_m3 }, omega_rad_s, unstable, beyond_table: false }
}

fn curves(flows: &[(f64, f64)], crossings: Vec<Crossing>) -> FlutterCurves {
    let flows = flows.iter().map(|(v_m_s, rho_kg_m3)| Flow { v_m_s: *v_m_s, rho_kg_m3: *rho_kg_m3 });
    FlutterCurves { flows: flows.collect(), branches: Vec::new(), crossings, lost: Vec::new() }
}

#[test]
fn flutter_is_the_first_oscillation_that_becomes_unstable() {
    let stable_again = crossing(10.0, 1.0, 5.0, false);
    let divergence = crossing(11.0, 1.0, 0.0, true);
    let (first, second) = (crossing(12.0, 1.0, 7.0, true), crossing(13.0, 1.0, 8.0, true));
    let all = curves(&[], vec![stable_again, divergence, first, second]);
    assert_eq!(all.flutter(), Some(&first));
    assert_eq!(curves(&[], vec![stable_again, divergence]).flutter(), None);
}

#[test]
fn crossings_stand_in_the_order_of_the_flows_and_of_pressure_between_two() {
    // faster, then higher, then slower again
    let flows = [(10.0, 1.0), (20.0, 1.0), (20.0, 0.5), (10.0, 0.5)];
    let on_the_way = [(15.0, 1.0), (18.0, 1.0), (20.0, 0.75), (12.0, 0.5)];
    let at = |place: usize| crossing(on_the_way[place].0, on_the_way[place].1, place as f64, true);
    let mut all = curves(&flows, [3, 1, 2, 0].map(at).to_vec());
    all.sort();
    assert_eq!(all.crossings, [0, 1, 2, 3].map(at));
}

#[test]
fn damping_is_twice_the_growth_over_the_frequency_and_a_real_root_has_none() {
    let root = |re: f64, im: f64| Root { p: c64::new(re, im), beyond_table: false };
    assert_eq!(root(-0.3, 4.0).damping_g(), Some(-0.15));
    assert_eq!(root(-0.3, 0.0).damping_g(), None);
    assert!((root(-0.3, 4.0).frequency_hz() - 4.0 / TAU).abs() < 1e-12);
}
