//! The map of `discover`: where in channel, maneuver and frequency the residual is, before and after.

use discover::result::MapCell;
use report::page::PageTable;

use super::values::{short, with_unit};

/// So many rows are shown.
const SHOWN: usize = 15;

/// A load in a maneuver.
struct Row {
    head: [String; 2],
    /// Largest cell before.
    largest: f64,
    cells: Vec<String>,
}

/// Root mean square of the residual over that of pure error, the largest rows first.
pub(super) fn table(map: &[MapCell]) -> PageTable {
    let mut bands: Vec<(f64, f64)> = map.iter().map(|cell| (cell.from_hz, cell.to_hz)).collect();
    bands.sort_by(|a, b| a.0.total_cmp(&b.0));
    bands.dedup();
    let mut rows: Vec<Row> = Vec::new();
    for cell in map {
        let head = [with_unit(&cell.channel), cell.maneuver.clone()];
        let place = rows.iter().position(|row| row.head == head).unwrap_or_else(|| {
            rows.push(Row { head, largest: 0.0, cells: vec![String::new(); bands.len()] });
            rows.len() - 1
        });
        let band = bands.iter().position(|(from, _)| *from == cell.from_hz).unwrap_or(0);
        let [before, after] = [cell.before, cell.after].map(f64::sqrt);
        rows[place].cells[band] = format!("{} \u{2192} {}", short(Some(before)), short(Some(after)));
        rows[place].largest = rows[place].largest.max(before);
    }
    rows.sort_by(|a, b| b.largest.total_cmp(&a.largest));
    let all = rows.len();
    let more = if all > SHOWN {
        format!("; the {SHOWN} largest of {all} rows, all are in map.csv")
    } else {
        String::new()
    };
    let caption = format!(
        "Root mean square of the residual over that of pure error, before \u{2192} after, on training data by band of frequency{more}. \
         Where nothing is missing it is about 1."
    );
    let head: Vec<String> = ["load".to_owned(), "maneuver".to_owned()]
        .into_iter()
        .chain(bands.iter().map(|(from, to)| format!("{from} to {to} Hz")))
        .collect();
    let mut table = PageTable::new(caption, &head.iter().map(String::as_str).collect::<Vec<_>>());
    for row in rows.into_iter().take(SHOWN) {
        table.row(row.head.into_iter().chain(row.cells));
    }
    table
}
