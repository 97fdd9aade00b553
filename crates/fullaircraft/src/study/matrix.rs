//! Mass matrices of a study: their terms, and these as cards.

use super::cards::{card, real};
use nastran::{BulkData, InputError, Motion};

/// Most terms that are read: two gigabytes.
pub(super) const MOST_TERMS: usize = 50_000_000;

/// Terms of a symmetric mass matrix, of one triangle or of both.
#[derive(Debug, Clone, PartialEq)]
pub enum MassTerms {
    /// By row and column, counted from zero: six a grid in rising number, one a scalar point.
    Rows {
        /// Number of rows.
        count: usize,
        /// Row, column and value.
        terms: Vec<(usize, usize, f64)>,
    },
    /// By motions.
    Motions(Vec<(Motion, Motion, f64)>),
}

impl MassTerms {
    /// The terms as DMIG cards of a name, its head first.
    ///
    /// # Errors
    /// If the matrix has not as many rows as the decks' grids have motions.
    pub(super) fn cards(&self, name: &str, bulk: &BulkData) -> Result<String, InputError> {
        let by_motions = match self {
            Self::Motions(terms) => terms.clone(),
            Self::Rows { count, terms } => {
                let motions = motions(bulk);
                if motions.len() != *count {
                    let message = format!(
                        "the matrix has {count} rows, but the decks' {} grids and {} scalar points have {} motions",
                        bulk.grids.len(),
                        bulk.scalar_points.len(),
                        motions.len()
                    );
                    return Err(InputError::general(message).with_help(
                        "six rows a grid in rising number and one a scalar point (Nastran's g-set)",
                    ));
                }
                terms.iter().map(|(row, column, value)| (motions[*row], motions[*column], *value)).collect()
            }
        };
        let mut sorted: Vec<(Motion, Motion, f64)> =
            by_motions.into_iter().map(|(row, column, value)| (column, row, value)).collect();
        sorted.sort_by_key(|(column, row, _)| (*column, *row));
        let head = [name, "0", "6", "2", "0"].map(str::to_owned);
        let mut text = card("DMIG", &head);
        for column in sorted.chunk_by(|a, b| a.0 == b.0) {
            let (grid, component) = column[0].0;
            let mut fields = vec![name.to_owned(), grid.to_string(), component.to_string(), String::new()];
            for (_, (grid, component), value) in column {
                fields.extend([grid.to_string(), component.to_string(), real(*value), String::new()]);
            }
            text += &card("DMIG", &fields);
        }
        Ok(text)
    }
}

/// All motions of the g-set, in its order.
fn motions(bulk: &BulkData) -> Vec<Motion> {
    let points =
        bulk.grids.keys().map(|id| (*id, false)).chain(bulk.scalar_points.keys().map(|id| (*id, true)));
    let mut points: Vec<(u32, bool)> = points.collect();
    points.sort_unstable();
    let of_point = |(id, is_scalar): (u32, bool)| -> Vec<Motion> {
        if is_scalar { vec![(id, 0)] } else { (1..=6).map(|component| (id, component)).collect() }
    };
    points.into_iter().flat_map(of_point).collect()
}

#[cfg(test)]
mod tests;
