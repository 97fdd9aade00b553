//! The formats of files that mass matrices are read from.

use super::matrix::{MOST_TERMS, MassTerms};
use super::op4;
use nastran::{InputError, Motion, Span, Table, read_text};
use std::path::Path;
use std::sync::Arc;

/// Reads a matrix by the ending of its name: `.op4`, `.mtx` or `.csv`.
///
/// # Errors
/// If it cannot be read or is not what its ending says; the line (of a binary file the byte) is blamed.
pub fn read_terms(path: &Path) -> Result<MassTerms, InputError> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
    match ending.as_str() {
        "op4" => op4::read(path),
        "mtx" => matrix_market(path),
        "csv" => by_motions(path),
        _ => Err(InputError::in_file(path, "this is no matrix that is read, by its name").with_help(
            "expected .h5 (Nastran's HDF5), .op4 (OUTPUT4), .mtx (MatrixMarket) or .csv (by motions)",
        )),
    }
}

/// A table of `row_grid, row_component, column_grid, column_component, value`; component 0 is a scalar point's motion.
fn by_motions(path: &Path) -> Result<MassTerms, InputError> {
    let table = Table::read(path)?;
    let motion = |row: usize, [grid, component]: [&str; 2]| -> Result<Motion, InputError> {
        let whole = |column: &str, most: f64| {
            let value = table.number(row, column)?;
            if value.fract() == 0.0 && (0.0..=most).contains(&value) {
                return Ok(value);
            }
            let message = format!("{column} {value} is no whole number from 0 to {most}");
            Err(InputError::at(&table.span(row, column), message))
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "whole and in range, as checked"
        )]
        Ok((whole(grid, f64::from(u32::MAX))? as u32, whole(component, 6.0)? as u8))
    };
    let term = |row: usize| {
        let (of_row, of_column) = (["row_grid", "row_component"], ["column_grid", "column_component"]);
        Ok((motion(row, of_row)?, motion(row, of_column)?, table.number(row, "value")?))
    };
    (0..table.len()).map(term).collect::<Result<_, InputError>>().map(MassTerms::Motions)
}

/// MatrixMarket's coordinate format: `%%MatrixMarket matrix coordinate real symmetric` (or `general`), rows, columns and number of
/// terms, then a row, a column and a value a line, counted from one.
fn matrix_market(path: &Path) -> Result<MassTerms, InputError> {
    let text = read_text(path)?;
    let file = Arc::new(path.to_path_buf());
    let wrong = |line: usize, message: String| {
        Err(InputError::at(&Span::new(&file, line + 1, 1, 2), message).with_help(
            "expected `%%MatrixMarket matrix coordinate real symmetric`, a line with rows, columns and number of terms, then the terms",
        ))
    };
    let mut lines = text.lines().enumerate();
    let head = lines.next().map(|(_, line)| line.to_ascii_lowercase()).unwrap_or_default();
    let words: Vec<&str> = head.split_whitespace().collect();
    let is_read = matches!(
        words[..],
        ["%%matrixmarket", "matrix", "coordinate", "real" | "integer", "symmetric" | "general"]
    );
    if !is_read {
        return wrong(0, format!("`{head}` is no real symmetric matrix in coordinates"));
    }
    let mut rest = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('%'));
    let numbers = |line: &str| -> Option<Vec<usize>> {
        line.split_whitespace().map(|word| word.parse().ok()).collect()
    };
    let Some((at, size)) = rest.next() else { return wrong(0, "the line of sizes is not there".to_owned()) };
    let Some([count, columns, wanted]) = numbers(size).and_then(|all| <[usize; 3]>::try_from(all).ok())
    else {
        return wrong(at, format!("`{size}` does not say rows, columns and number of terms"));
    };
    if count != columns || wanted > MOST_TERMS {
        return wrong(
            at,
            format!("{count} rows, {columns} columns and {wanted} terms are no mass matrix that is read"),
        );
    }
    let mut terms = Vec::with_capacity(wanted.min(text.len() / 4));
    for (at, line) in rest {
        let words: Vec<&str> = line.split_whitespace().collect();
        let term = match words[..] {
            [row, column, value] => row.parse().ok().zip(column.parse().ok()).zip(value.parse::<f64>().ok()),
            _ => None,
        };
        match term {
            Some(((row, column), value))
                if (1..=count).contains(&row) && (1..=count).contains(&column) && value.is_finite() =>
            {
                terms.push((row - 1, column - 1, value));
            }
            _ => return wrong(at, format!("`{line}` is no term of a matrix with {count} rows")),
        }
    }
    if terms.len() != wanted {
        return wrong(at, format!("{wanted} terms are announced, {} are there", terms.len()));
    }
    Ok(MassTerms::Rows { count, terms })
}

#[cfg(test)]
mod tests;
