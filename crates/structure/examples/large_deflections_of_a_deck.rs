//! A deck under one of its load sets with large deflections, linear theory beside it.
//!
//! `large_deflections_of_a_deck [DECK.bdf LOAD_SET GRID...]`; without a deck, a cantilever under an end force of P L^2 / E I = 4, whose end
//! sinks by 0.66996 of its length (Bisshopp and Drucker 1945).

use std::error::Error;
use std::fmt::Write as _;
use std::io::Write as _;
use std::time::Instant;

use structure::nonlinear::LargeDeflection;
use structure::{Flexibility, Model, System, load_sets, loads_of};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let bulk = match arguments.next() {
        Some(deck) => nastran::read_deck(deck.as_ref())?,
        None => nastran::parse_deck("cantilever.bdf", &cantilever())?,
    };
    let set = match arguments.next() {
        Some(set) => set.parse()?,
        None => load_sets(&bulk).first().copied().ok_or("the deck has no loads")?,
    };
    let mut grids = arguments.map(|grid| grid.parse()).collect::<Result<Vec<u32>, _>>()?;
    if grids.is_empty() {
        grids.extend(bulk.grids.keys().last());
    }
    let (model, loads) = (Model::from_bulk(&bulk)?, loads_of(&bulk, set)?);
    let (system, mut out) = (System::assemble(&model)?, std::io::stdout().lock());
    let show = |out: &mut std::io::StdoutLock, what: &str, u: &dyn Fn(usize) -> f64| -> std::io::Result<()> {
        for grid in &grids {
            let Some(node) = system.node_index(*grid) else { continue };
            let values: Vec<String> = (0..6).map(|c| format!("{:.6}", u(6 * node + c))).collect();
            writeln!(out, "{what} GRID {grid}: {}", values.join(" "))?;
        }
        Ok(())
    };
    let forces = system.reduce(system.forces_of(&loads).as_ref());
    let linear = system.expand(Flexibility::new(&system)?.displacements(forces.as_ref()).as_ref());
    show(&mut out, "linear", &|dof| linear[(dof, 0)])?;
    let start = Instant::now();
    let wing = LargeDeflection::new(&model)?;
    let path = wing.under(&loads)?;
    for point in &path.points {
        let u = point.state.displacements(wing.nodes());
        let what = format!("{:.4} of the load, {} iterations,", point.load_factor, point.iterations);
        show(&mut out, &what, &|dof| u[dof])?;
    }
    let iterations: usize = path.points.iter().map(|point| point.iterations).sum();
    writeln!(
        out,
        "{} free motions, {iterations} iterations in {:.2} s",
        wing.free_count(),
        start.elapsed().as_secs_f64()
    )?;
    Ok(())
}

/// Sixteen bars of one metre in all along y, E I = 1, 4 N along -z at the end.
fn cantilever() -> String {
    let mut deck = String::from(
        "MAT1,1,1.+6,5.+5,,1.\nPBAR,1,1,1.,1.-6,1.-6,2.-6\nSPC1,1,123456,1\nFORCE,1,17,,4.,0.,0.,-1.\n",
    );
    for node in 0..=16 {
        let _ = writeln!(deck, "GRID,{},,0.,{:?},0.", node + 1, f64::from(node) / 16.0);
    }
    for bar in 1..=16 {
        let _ = writeln!(deck, "CBAR,{bar},1,{bar},{},0.,0.,1.", bar + 1);
    }
    deck
}
