//! Tables of numbers with named columns: a header, then rows, commas between; lines that begin with `#` do not count.

use crate::fault::{Fault, text_of};
use std::path::Path;

/// A table by columns.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    /// Reads a file.
    pub(crate) fn read(path: &Path) -> Result<Self, Fault> {
        let text = text_of(path)?;
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(place, line)| (place + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let (_, header) = lines.next().ok_or_else(|| Fault::new(path, "has no header"))?;
        let names: Vec<String> = header.split(',').map(|name| name.trim().to_owned()).collect();
        let row = |(number, line): (usize, &str)| {
            let values: Result<Vec<f64>, _> = line.split(',').map(|value| value.trim().parse()).collect();
            match values {
                Ok(values) if values.len() == names.len() => Ok(values),
                _ => Err(Fault::new(path, format!("line {number} is no row of {} numbers", names.len()))),
            }
        };
        let rows = lines.map(row).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { names, rows })
    }

    /// A column by its name.
    pub(crate) fn column(&self, name: &str, path: &Path) -> Result<Vec<f64>, Fault> {
        let place = self.names.iter().position(|known| known == name);
        let place = place.ok_or_else(|| Fault::new(path, format!("has no column {name}")))?;
        Ok(self.rows.iter().map(|row| row[place]).collect())
    }
}

/// The value of a table at a place, linear between its points and constant outside.
pub(crate) fn between(places: &[f64], values: &[f64], at: f64) -> f64 {
    let after = places.partition_point(|place| *place < at);
    match (after.checked_sub(1), values.get(after)) {
        (None, _) => values.first().copied().unwrap_or_default(),
        (Some(before), None) => values[before],
        (Some(before), Some(above)) => {
            let share = (at - places[before]) / (places[after] - places[before]);
            values[before] + share * (above - values[before])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::between;

    #[test]
    fn values_are_linear_between_points_and_constant_outside() {
        let (x, y) = ([0.0, 1.0, 3.0], [2.0, 4.0, 0.0]);
        for (at, value) in [(-1.0, 2.0), (0.5, 3.0), (1.0, 4.0), (2.0, 2.0), (9.0, 0.0)] {
            assert_eq!(between(&x, &y, at), value);
        }
    }
}
