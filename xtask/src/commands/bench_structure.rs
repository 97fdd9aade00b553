//! The structure's part of `bench`: a large deck read, then the shipped wing's mesh and longer ones, from cards to twenty modes.

use std::fmt::Write as _;
use std::time::Instant;

use coupling::Mount;
use coupling::planform::Structure;
use coupling::wing_file::WingFile;
use serde_json::{Value, json};
use structure::{Model, System, normal_modes};

use super::bench_clock::{median, peak_mb, row};
use wingroot::failure::Failure;

/// Elements along the span in each strip, times those of the file: grids from 3000 to 48000.
const LENGTHS: [usize; 5] = [1, 2, 4, 8, 16];

/// Modes of each mesh.
const MODES: usize = 20;

/// Grids of a side of the deck that is read.
const SIDE: usize = 316;

/// Reading a deck of shells with 99,856 grids, from its text to checked cards.
pub(super) fn reading() -> Result<Value, Failure> {
    let mut text = String::from("PSHELL,1,1,.004,1,,1\nMAT1,1,7.+10,,.3,2700.\n");
    for (i, j) in (0..SIDE * SIDE).map(|k| (k / SIDE, k % SIDE)) {
        let grid = i * SIDE + j + 1;
        // Writing to a String cannot fail.
        let _ = writeln!(text, "GRID    {grid:8}        {:8.3}{:8.3}{:8.3}", i as f64, j as f64, 0.0);
        if i + 1 < SIDE && j + 1 < SIDE {
            let [right, above] = [grid + SIDE, grid + 1];
            let _ = writeln!(text, "CQUAD4  {grid:8}       1{grid:8}{right:8}{:8}{above:8}", right + 1);
        }
    }
    let seconds = median(|| {
        nastran::parse_deck("deck", &text)?;
        Ok(())
    })?;
    Ok(row(&format!("read_deck_of_{}_grids", SIDE * SIDE), seconds))
}

/// One row a mesh, from the smallest to the largest, so that the peak of the memory is each one's own; none for a wing
/// that is no mesh.
pub(super) fn rows(file: &WingFile) -> Result<Vec<Value>, Failure> {
    let mut rows = Vec::new();
    let Some(planform) = file.planform() else { return Ok(rows) };
    let folder = file.path.parent().unwrap_or(std::path::Path::new(""));
    for length in LENGTHS {
        let mut planform = planform.clone();
        let Some(Structure::ShellSolid(shell)) = &mut planform.structure else { return Ok(rows) };
        shell.mesh.spanwise_per_strip *= length;
        let bulk = planform.bulk(folder, Mount::Tunnel)?;
        let start = Instant::now();
        let system = System::assemble(&Model::from_bulk(&bulk)?)?;
        let assembly = start.elapsed().as_secs_f64();
        let modes = normal_modes(&system, MODES).map_err(Failure::computation)?;
        rows.push(json!({
            "name": format!("structure_{}_grids_{MODES}_modes", system.node_count()),
            "seconds": start.elapsed().as_secs_f64(),
            "assembly_seconds": assembly,
            "motions": system.free_count(),
            "first_hz": modes.omega_rad_s[0] / std::f64::consts::TAU,
            "peak_MB": peak_mb(),
        }));
    }
    Ok(rows)
}
