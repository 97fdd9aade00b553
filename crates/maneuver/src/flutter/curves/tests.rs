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
fn crossings_stand_in_the_order_of_the_way_whichever_way_it_goes() {
    // faster, then higher, then slower, then faster and higher by 50, 54 and 49 Pa, then back to where it was
    let flows = [(10.0, 1.0), (20.0, 1.0), (20.0, 0.5), (10.0, 1.0), (14.0, 0.5), (10.0, 1.0)];
    let on_the_way = [
        (0, 15.0, 1.0),
        (0, 18.0, 1.0),
        (1, 20.0, 0.75),
        (1, 20.0, 0.6),
        (2, 18.0, 0.6),
        (2, 12.0, 0.9),
        (3, 10.4, 0.95),
        (3, 12.0, 0.75),
        (3, 13.6, 0.55),
        (4, 13.0, 0.625),
        (4, 11.0, 0.875),
    ];
    let at = |place: usize| {
        let (leg, v_m_s, rho_kg_m3) = on_the_way[place];
        (leg, crossing(v_m_s, rho_kg_m3, place as f64, true))
    };
    for order in [[10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0], [3, 8, 1, 10, 4, 7, 2, 0, 9, 5, 6]] {
        let along = curves(&flows, Vec::new()).flows;
        assert_eq!(
            in_order(&along, order.map(at).to_vec()),
            on_the_way.iter().enumerate().map(|(place, _)| at(place).1).collect::<Vec<_>>()
        );
    }
}

#[test]
fn a_share_of_the_way_is_that_of_airspeed_or_of_density_whichever_changes() {
    let flow = |v_m_s: f64, rho_kg_m3: f64| Flow { v_m_s, rho_kg_m3 };
    for (from, to, at) in [
        (flow(10.0, 1.0), flow(50.0, 1.0), flow(20.0, 1.0)),
        (flow(10.0, 1.0), flow(10.0, 0.2), flow(10.0, 0.8)),
        (flow(40.0, 0.4), flow(20.0, 0.8), flow(35.0, 0.5)),
    ] {
        assert!((share(&from, &to, &at) - 0.25).abs() < 1e-12, "{at:?}");
        assert!((share(&to, &from, &at) - 0.75).abs() < 1e-12, "{at:?}");
        assert_eq!(share(&from, &to, &from), 0.0);
    }
}

#[test]
fn damping_is_twice_the_growth_over_the_frequency_and_a_real_root_has_none() {
    let root = |re: f64, im: f64| Root { p: c64::new(re, im), beyond_table: false };
    assert_eq!(root(-0.3, 4.0).damping_g(), Some(-0.15));
    assert_eq!(root(-0.3, 0.0).damping_g(), None);
    assert!((root(-0.3, 4.0).frequency_hz() - 4.0 / TAU).abs() < 1e-12);
}
