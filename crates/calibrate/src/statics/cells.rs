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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::point;

    #[test]
    fn rows_of_one_airspeed_and_angle_are_a_cell_and_blocks_split_it() {
        let mut points: Vec<StaticPoint> =
            [(20.0, 0.1), (10.0, 0.2), (20.02, 0.1), (10.0, -0.1), (10.0, 0.2005), (20.0, 0.2)]
                .iter()
                .enumerate()
                .map(|(i, &(v_m_s, alpha_rad))| point(i + 2, v_m_s, alpha_rad, [0.0; 4]))
                .collect();
        points[2].block = Some("B".into());
        let rows: Vec<&StaticPoint> = points.iter().collect();
        let cells = cells(&rows);
        let of = |cells: &[Cell<'_>]| -> Vec<(f64, f64, Vec<usize>)> {
            let lines = |cell: &Cell<'_>| cell.rows.iter().map(|row| row.span.line).collect();
            cells.iter().map(|cell| (cell.v_m_s, cell.alpha_rad, lines(cell))).collect()
        };
        let found = of(&cells);
        let expected = [
            (10.0, -0.1, vec![5]),
            (10.0, 0.200_25, vec![3, 6]),
            (20.01, 0.1, vec![2, 4]),
            (20.0, 0.2, vec![7]),
        ];
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (a, b) in found.iter().zip(&expected) {
            assert!((a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-12 && a.2 == b.2, "{a:?} {b:?}");
        }
        let split = of(&split_by_block(&cells, &["", "B"]));
        assert_eq!(split.len(), 5);
        assert_eq!((split[2].0, &split[2].2, split[3].0, &split[3].2), (20.0, &vec![2], 20.02, &vec![4]));
        assert_eq!((block_name(&points[2]), block_name(&points[0])), ("B", ""));
    }
}
