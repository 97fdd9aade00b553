//! p-k roots of a wing given by a deck, for scripts that compare them with other programs.
//!
//! `pk_of_deck DECK.bdf MACH DENSITY MODES K_PER_M,... V,...`: boxes hang on a beam spline through all grids in their order; no
//! plane of symmetry; the doublets' fit is the parabolic one. A line that comes out is `frequency` with the natural
//! frequencies, or `root`, airspeed, mode, damping g and frequency (Hz).

use aero::{DlmSettings, DoubletLattice, Flow, KernelIntegral, Lattice, MirrorPlane, SpanFit};
use coupling::Spline;
use maneuver::flutter::{Aeroelastic, gaf_table};
use std::error::Error;
use std::f64::consts::TAU;
use std::io::Write;
use structure::{Model, System, normal_modes};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [deck, mach, density, modes, kappa, speeds] = arguments.as_slice() else {
        return Err("expected DECK.bdf MACH DENSITY MODES K_PER_M,... V,...".into());
    };
    let list = |text: &str| text.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>();
    let (kappa, rho_kg_m3) = (list(kappa)?, density.parse()?);
    let bulk = nastran::read_deck(deck.as_ref())?;
    let lattice = Lattice::from_bulk(&bulk)?;
    let system = System::assemble(&Model::from_bulk(&bulk)?)?;
    let found = normal_modes(&system, modes.parse()?)?;
    let nodes: Vec<usize> = (0..system.node_count()).collect();
    let spline = Spline::beam(&lattice, system.points(), &nodes);
    let motion = spline.displace(system.expand(found.shapes.as_ref()).as_ref());
    let settings = DlmSettings { integral: KernelIntegral::Laschka, fit: SpanFit::Parabolic };
    let doublets = DoubletLattice::new(&lattice, MirrorPlane::None, mach.parse()?, &settings)?;
    let forces = gaf_table(&lattice, &doublets, motion.as_ref(), None, &kappa)?;
    let wing = Aeroelastic::of_modes(&found.omega_rad_s, 0.0, &forces)?;
    let flows: Vec<Flow> = list(speeds)?.into_iter().map(|v_m_s| Flow { v_m_s, rho_kg_m3 }).collect();
    let curves = wing.pk(&flows)?;
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    let hertz: Vec<String> = found.omega_rad_s.iter().map(|omega| format!("{:e}", omega / TAU)).collect();
    writeln!(out, "frequency,{}", hertz.join(","))?;
    for (mode, branch) in curves.branches.iter().enumerate() {
        for (flow, root) in flows.iter().zip(branch) {
            let g = root.damping_g().unwrap_or(f64::NAN);
            writeln!(out, "root,{},{},{g:e},{:e}", flow.v_m_s, mode + 1, root.frequency_hz())?;
        }
    }
    Ok(())
}
