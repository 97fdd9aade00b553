//! Loads of a rigid wing in theory and with corrections: lattice, pressures, box loads (Eq. 7 of paper 1), sums about the root.
//!
//! `corrected_loads` takes no argument: a half wing of aspect ratio 8 beside a wall, at 3 degrees and 20 m/s.

use aero::{Corrections, Flow, Integration, Lattice, MirrorPlane, SteadyAero, incidence};
use nalgebra::Point3;
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    let lattice = Lattice::trapezoid(1, [0.0, 0.0, 0.0], 1.0, [0.0, 4.0, 0.0], 1.0, [4, 20])?;
    let steady = SteadyAero::new(&lattice, MirrorPlane::Symmetric { y_m: 0.0 }, 0.0)?;
    let alpha_rad = 3.0_f64.to_radians();
    let incidence: Vec<f64> = incidence::angle_of_attack(&lattice).iter().map(|w| w * alpha_rad).collect();
    let cp = steady.pressures_of(&incidence);

    let theory = Corrections::neutral(lattice.len());
    let mut corrected = theory.clone();
    for (j, panel) in lattice.boxes.iter().enumerate() {
        // ten per cent less lift towards the tip, and a small offset that no angle changes
        corrected.force[j] = 1.0 - 0.1 * panel.mid_point().y / 4.0;
        corrected.pressure_offset[j] = 0.01;
    }
    let q_pa = Flow { v_m_s: 20.0, rho_kg_m3: 1.225 }.dynamic_pressure_pa();
    let integration = Integration::new(&lattice);
    for (name, corrections) in [("theory", &theory), ("corrected", &corrected)] {
        let loads = integration.corrected(corrections).box_loads(q_pa, &cp);
        let (force, moment) = loads.resultant(&lattice, 0..lattice.len(), &Point3::origin());
        writeln!(out, "{name}: Fz {:.2} N, Mx {:.2} N m, My {:.2} N m", force[2], moment[0], moment[1])?;
    }
    Ok(())
}
