//! Natural frequencies, effective masses and mass of a Nastran deck.
//!
//! `modes_of_a_deck [DECK.bdf] [COUNT]`; without a deck, a cantilever of ten beams with its closed form beside it.

use std::error::Error;
use std::f64::consts::TAU;
use std::io::Write;
use structure::{Model, System, normal_modes};

/// Length (m), bending stiffness (N m2) and mass per length (kg/m) of the cantilever.
const CANTILEVER: (f64, f64, f64) = (1.0, 7.0, 0.27);
/// First root of 1 + cos(x) cosh(x) = 0, the bending of a cantilever.
const FIRST_ROOT: f64 = 1.875_104_068_711_961;

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = std::io::stdout().lock();
    let mut arguments = std::env::args().skip(1);
    let deck = arguments.next();
    let count = arguments.next().map_or(Ok(4), |count| count.parse())?;
    let bulk = match &deck {
        Some(path) => nastran::read_deck(path.as_ref())?,
        None => nastran::parse_deck("cantilever.bdf", &cantilever())?,
    };
    let system = System::assemble(&Model::from_bulk(&bulk)?)?;
    // refuses to return before a count of eigenvalues proves that no mode is missing
    let modes = normal_modes(&system, count)?;
    for (omega_rad_s, number) in modes.omega_rad_s.iter().zip(1..) {
        writeln!(out, "mode {number}: {:.4} Hz", omega_rad_s / TAU)?;
    }
    if deck.is_none() {
        let (length_m, bending_n_m2, mass_kg_m) = CANTILEVER;
        let omega_rad_s = (FIRST_ROOT / length_m).powi(2) * (bending_n_m2 / mass_kg_m).sqrt();
        writeln!(out, "closed form of the first bending: {:.4} Hz", omega_rad_s / TAU)?;
    }
    Ok(())
}

/// Ten CBARs along y, clamped at the first grid; E I = 7 N m2 about both axes, 0.27 kg/m.
fn cantilever() -> String {
    let grid = |grid: u32| format!("GRID,{grid},,0.,{},0.\n", f64::from(grid - 1) / 10.0);
    let bar = |bar: u32| format!("CBAR,{bar},1,{bar},{},0.,0.,1.\n", bar + 1);
    let rest = "MAT1,1,7.+10,,.3,2700.\nPBAR,1,1,1.-4,1.-10,1.-10,2.-10\nSPC1,1,123456,1\n";
    (1..=11).map(grid).chain((1..=10).map(bar)).collect::<String>() + rest
}
