//! The elastic wing against Loads Kernel 2026.5 (independent tool): 25 steady cases, uncorrected and corrected.
//!
//! Goal: Fz, Mx, My to 1e-6 of N and N m, tip to 1e-6 m. Loads Kernel's own stiffness, mass, nearest-node spline and
//! ten modes are used; what its algebra does otherwise (data/loads_kernel/README.md) is repeated here on the outside:
//! sin(alpha) and sin(camber) as incidence; the elastic incidence times cos(alpha), which is a structure softer by
//! cos(alpha) whose displacement is cos(alpha) times Loads Kernel's; weight not tared at alpha = 0.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::loads_kernel::{GRAVITY_M_S2, LoadsKernelWing, RHO_KG_M3, data};
use aero::{Corrections, Flow, Lattice};
use coupling::SteadyCase;
use nastran::table::Table;

fn check(reference: &str, corrections: &Corrections) {
    let lattice = Lattice::from_bulk(&nastran::read_deck(&data("wing.bdf")).unwrap()).unwrap();
    let model = LoadsKernelWing::read();
    let table = Table::read(&data(reference)).unwrap();
    assert_eq!(table.len(), 25);
    for alpha_deg in [-4.0, -2.0, 0.0, 2.0, 4.0_f64] {
        let alpha_rad = alpha_deg.to_radians();
        let wing = model.at(&lattice, 0.0, Vec::new(), alpha_rad, alpha_rad.cos());
        let weight = &wing.supported.as_ref().unwrap().weight;
        for row in (0..25).filter(|&row| table.number(row, "alpha_deg").unwrap() == alpha_deg) {
            let flow = Flow { v_m_s: table.number(row, "V_m_s").unwrap(), rho_kg_m3: RHO_KG_M3 };
            let case = SteadyCase::new(flow, alpha_rad);
            let state = &wing.at(flow, corrections).unwrap().solve(&[case])[0];
            let loads = state.root.to_array();
            for (channel, name) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().enumerate() {
                let untared = loads[channel] - weight[(channel, 2)] * GRAVITY_M_S2;
                let expected = table.number(row, name).unwrap();
                assert!(
                    (untared - expected).abs() < 1e-6,
                    "{reference} row {row} {name}: {untared} against {expected}"
                );
            }
            // Loads Kernel gives the tip in earth axes: aft motion of the nose-up wing is down.
            let tip = |component: usize| state.displacement[6 * 28 + component] / alpha_rad.cos();
            let tip_up_m = tip(2) * alpha_rad.cos() - tip(0) * alpha_rad.sin();
            let expected_down_m = table.number(row, "tip_down_m").unwrap();
            assert!((tip_up_m + expected_down_m).abs() < 1e-6, "tip {tip_up_m} against {expected_down_m}");
        }
    }
}

#[test]
fn uncorrected_wing_agrees_with_loads_kernel_in_25_cases() {
    check("static_base.csv", &Corrections::neutral(672));
}

#[test]
fn corrected_wing_agrees_with_loads_kernel_in_25_cases() {
    let table = Table::read(&data("corrections.csv")).unwrap();
    let corrections = Corrections {
        force: table.numbers("force").unwrap(),
        moment: table.numbers("moment").unwrap(),
        pressure_offset: table.numbers("pressure_offset").unwrap(),
    };
    check("static_corr.csv", &corrections);
}
