//! The doublet lattice's time: a whole aircraft of 1831 boxes at eight frequencies, 70 columns each.

use aero::{DlmSettings, DoubletLattice, Lattice, MirrorPlane};
use faer::{Mat, c64};

use crate::repository;
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use wingroot::failure::Failure;

/// omega `c_ref`/(2 V), with `c_ref` = 0.225 m.
const REDUCED_FREQUENCIES: [f64; 8] = [0.001, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0, 1.5];
const HALF_CHORD_M: f64 = 0.1125;
const MACH: f64 = 0.1;
const COLUMNS: usize = 70;

/// Wing of 56 by 12 boxes a half, horizontal tail of 12 by 8, fin of 15 by 9, fuselage as a cross of 4 by 20.
pub(crate) fn aircraft() -> Result<Lattice, Failure> {
    let tip_x_m = 0.075 + 1.8 * 20_f64.to_radians().tan() - 0.0375;
    let wing = Lattice::trapezoid(10_001, [0.0; 3], 0.30, [tip_x_m, 1.8, 0.0], 0.15, [12, 56])?;
    let tail = Lattice::trapezoid(30_001, [1.45, 0.0, 0.4], 0.18, [1.6, 0.45, 0.4], 0.11, [8, 12])?;
    let fin = Lattice::trapezoid(50_001, [1.25, 0.0, 0.0505], 0.28, [1.43, 0.0, 0.3995], 0.2, [9, 15])?;
    let flat = Lattice::trapezoid(60_001, [-0.9, -0.05, 0.0], 0.85, [-0.9, 0.05, 0.0], 0.85, [20, 4])?;
    let upright = Lattice::trapezoid(70_001, [-0.9, 0.0, -0.05], 0.85, [-0.9, 0.0, 0.05], 0.85, [20, 4])?;
    let halves =
        [&wing, &wing.mirrored(0.0).0.renumbered(10_000)?, &tail, &tail.mirrored(0.0).0.renumbered(10_000)?];
    let parts = halves.into_iter().chain([&fin, &flat, &upright]);
    Ok(parts.skip(1).try_fold(wing.clone(), |all, part| all.joined(part))?)
}

/// All frequencies: matrices, factorisations and the pressures of 70 columns.
pub(crate) fn eight_frequencies(lattice: &Lattice) -> Result<(), Failure> {
    let doublets = DoubletLattice::new(lattice, MirrorPlane::None, MACH, &DlmSettings::default())
        .map_err(Failure::computation)?;
    let columns = Mat::from_fn(lattice.len(), COLUMNS, |i, j| {
        let at = lattice.boxes[i].three_quarter_point();
        c64::new((at.y * j as f64).cos(), (at.x * j as f64).sin())
    });
    for k in REDUCED_FREQUENCIES {
        let pressures =
            doublets.at(k / HALF_CHORD_M).map_err(Failure::computation)?.pressures(columns.as_ref());
        // Nothing else may be kept of a frequency than this.
        std::hint::black_box(pressures);
    }
    Ok(())
}

/// PanelAero's time and memory on the same boxes and frequencies, as its script prints them; none where it is absent.
pub(crate) fn panelaero(lattice: &Lattice, python: &Path) -> Result<Option<Value>, Failure> {
    let mut corners = String::new();
    for panel in &lattice.boxes {
        let numbers: Vec<String> =
            panel.corners.iter().flat_map(|c| [c.x, c.y, c.z]).map(|v| format!("{v:?}")).collect();
        let _ = writeln!(corners, "{}", numbers.join(","));
    }
    let file = std::env::temp_dir().join(format!("wingroot_boxes_{}.csv", std::process::id()));
    std::fs::write(&file, corners).map_err(Failure::computation)?;
    let mut command = Command::new(python);
    command.arg(repository::path("tests/peers/time_panelaero.py")).arg(&file).arg(MACH.to_string());
    command.args(REDUCED_FREQUENCIES.map(|k| (k / HALF_CHORD_M).to_string()));
    let output = command.output();
    // A file in the folder for temporary files harms nobody if it stays.
    drop(std::fs::remove_file(&file));
    let Ok(output) = output else { return Ok(None) };
    Ok(serde_json::from_slice(&output.stdout).ok())
}
