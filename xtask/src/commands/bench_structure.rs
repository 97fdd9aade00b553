//! The structure's part of `bench`: the shipped wing's mesh, then longer ones, from cards to twenty modes.

use std::time::Instant;

use coupling::Mount;
use coupling::planform::Structure;
use coupling::wing_file::WingFile;
use serde_json::{Value, json};
use structure::{Model, System, normal_modes};

use super::bench_clock::peak_mb;
use wingroot::failure::Failure;

/// Elements along the span in each strip, times those of the file: grids from 3000 to 48000.
const LENGTHS: [usize; 5] = [1, 2, 4, 8, 16];

/// Modes of each mesh.
const MODES: usize = 20;

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
