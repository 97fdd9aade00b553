//! A deck under one of its load sets with large deflections, linear theory beside it:
//!
//! `cargo run -p wingroot-structure --example large_deflections_of_a_deck -- wing.bdf 20 1389 61`
//! prints the displacements of grids 1389 and 61 under load set 20 at every load step.

use std::error::Error;
use std::io::Write as _;
use std::time::Instant;

use structure::nonlinear::LargeDeflection;
use structure::{Flexibility, Model, System, load_sets, loads_of};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let deck = arguments.next().unwrap_or_else(|| "data/published/decks/ha144a_fsw.bdf".into());
    let bulk = nastran::read_deck(deck.as_ref())?;
    let set = match arguments.next() {
        Some(set) => set.parse()?,
        None => load_sets(&bulk).first().copied().ok_or("the deck has no loads")?,
    };
    let grids = arguments.map(|grid| grid.parse()).collect::<Result<Vec<u32>, _>>()?;
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
