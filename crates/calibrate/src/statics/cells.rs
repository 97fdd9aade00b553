//! Rows of static cases that are replicates of each other, and the blocks that they are of.

use crate::campaign::StaticPoint;
use aero::flow::{same_airspeed, same_angle};

/// A cell: rows of one airspeed and angle.
pub(crate) struct Cell<'a> {
    /// Mean airspeed, m/s.
    pub(crate) v_m_s: f64,
    /// Mean angle of attack, rad.
    pub(crate) alpha_rad: f64,
    /// Its rows, replicates of each other.
    pub(crate) rows: Vec<&'a StaticPoint>,
}

/// Cells of one block each, in the order of the cells, then of the blocks.
pub(super) fn split_by_block<'a>(cells: &[Cell<'a>], names: &[&str]) -> Vec<Cell<'a>> {
    let mut split = Vec::new();
    for cell in cells {
        for name in names {
            let rows: Vec<&StaticPoint> =
                cell.rows.iter().copied().filter(|row| block_name(row) == *name).collect();
            let count = rows.len() as f64;
            if rows.is_empty() {
                continue;
            }
            split.push(Cell {
                v_m_s: rows.iter().map(|row| row.v_m_s).sum::<f64>() / count,
                alpha_rad: rows.iter().map(|row| row.alpha_rad).sum::<f64>() / count,
                rows,
            });
        }
    }
    split
}

/// The block that a row is of; rows without one are of one block.
pub(crate) fn block_name(row: &StaticPoint) -> &str {
    row.block.as_deref().unwrap_or("")
}

/// Groups rows by airspeed, then angle, both ascending.
pub(super) fn cells<'a>(rows: &[&'a StaticPoint]) -> Vec<Cell<'a>> {
    let mut sorted = rows.to_vec();
    sorted.sort_by(|a, b| a.v_m_s.total_cmp(&b.v_m_s));
    let mut groups: Vec<Vec<&StaticPoint>> = Vec::new();
    for row in sorted {
        match groups.last_mut() {
            Some(group) if same_airspeed(group[0].v_m_s, row.v_m_s) => group.push(row),
            _ => groups.push(vec![row]),
        }
    }
    let mut cells: Vec<Cell<'a>> = Vec::new();
    for mut group in groups {
        group.sort_by(|a, b| a.alpha_rad.total_cmp(&b.alpha_rad));
        let first = cells.len();
        for row in group {
            match cells[first..].last_mut() {
                Some(cell) if same_angle(cell.rows[0].alpha_rad, row.alpha_rad) => {
                    cell.rows.push(row);
                }
                _ => cells.push(Cell { v_m_s: 0.0, alpha_rad: 0.0, rows: vec![row] }),
            }
        }
    }
    for cell in &mut cells {
        let count = cell.rows.len() as f64;
        cell.v_m_s = cell.rows.iter().map(|row| row.v_m_s).sum::<f64>() / count;
        cell.alpha_rad = cell.rows.iter().map(|row| row.alpha_rad).sum::<f64>() / count;
    }
    cells
}
