//! What `gust` says on the console.

use std::fmt::Write as _;

use report::Table;

use super::gust_files::LOADS;
use super::gust_result::{Extreme, GustResult, SubcaseGust};

/// Rows shown of a subcase; result.json has all.
const SHOWN: usize = 24;

pub(super) fn text(result: &GustResult) -> String {
    let mut text = String::new();
    for case in &result.subcases {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "subcase {} {}: GUST {}, velocity {}, q {}, Mach {}, {} boxes, {} modes, {} of them rigid",
            case.subcase,
            case.label,
            case.gust,
            case.velocity,
            case.dynamic_pressure,
            case.mach,
            case.boxes,
            case.frequencies_hz.len(),
            case.rigid_modes
        );
        let _ = write!(text, "{}", extremes(case));
        for remark in &case.remarks {
            let _ = writeln!(text, "{remark}");
        }
    }
    if !result.random.is_empty() {
        let mut table = Table::new(&["RANDPS", "of", "component", "root mean square", "N0 (Hz)"]);
        for row in result.random.iter().take(SHOWN) {
            table.row([
                row.set.to_string(),
                row.of.clone(),
                row.component.clone(),
                format!("{:.5e}", row.rms),
                format!("{:.4}", row.n0_hz),
            ]);
        }
        let _ = write!(text, "{table}");
    }
    text
}

/// The table of a subcase: heave and its acceleration of grids, loads of stations.
fn extremes(case: &SubcaseGust) -> Table {
    let at = if case.in_time { "at (s)" } else { "at (Hz)" };
    let mut table = Table::new(&["of", "component", "highest", at, "lowest", at]);
    let is_shown = |row: &&Extreme| row.component.ends_with("T3") || LOADS.contains(&row.component.as_str());
    for row in case.extremes.iter().filter(is_shown).take(SHOWN) {
        table.row([
            row.of.clone(),
            row.component.clone(),
            format!("{:.5e}", row.highest),
            format!("{:.4}", row.highest_at),
            format!("{:.5e}", row.lowest),
            format!("{:.4}", row.lowest_at),
        ]);
    }
    table
}
