//! OUTPUT4 files in ASCII, out only: one dense real matrix, the way Nastran's OUTPUT4 writes it and pyNastran, pyYeti
//! and others read it.
//!
//! A header (columns, rows, form, type 2 for double precision, name, format of the numbers), then every column that is
//! not all zero as one record (column, first row, number of values) with three numbers a line, then the record of a
//! column beyond the last. Seventeen digits: nothing is lost.

use std::fmt::Write as _;

/// A matrix by columns as the text of an OP4 file; `name` has one to eight letters and digits.
///
/// Rows are as many as the longest column has. A value that is not finite is written as it prints (`NaN`), which every
/// reader refuses.
pub fn op4_text(name: &str, columns: &[Vec<f64>]) -> String {
    let rows = columns.iter().map(Vec::len).max().unwrap_or(0);
    let form = if rows == columns.len() { 1 } else { 2 };
    let mut text = format!("{:8}{rows:8}{form:8}{:8}{name:<8}1P,3E24.16\n", columns.len(), 2);
    for (index, column) in columns.iter().enumerate() {
        let Some(first) = column.iter().position(|value| *value != 0.0) else { continue };
        let last = column.iter().rposition(|value| *value != 0.0).unwrap_or(first);
        let _ = writeln!(text, "{:8}{:8}{:8}", index + 1, first + 1, last + 1 - first);
        for line in column[first..=last].chunks(3) {
            for value in line {
                let _ = write!(text, "{:>24}", exponential(*value));
            }
            text.push('\n');
        }
    }
    let _ = writeln!(text, "{:8}{:8}{:8}\n{:>24}", columns.len() + 1, 1, 1, exponential(1.0));
    text
}

/// `1.2345678901234567E-03`: Fortran wants a sign and two digits in the exponent.
fn exponential(value: f64) -> String {
    let text = format!("{value:.16E}");
    match text.split_once('E') {
        Some((mantissa, exponent)) => {
            let (sign, digits) = match exponent.strip_prefix('-') {
                Some(digits) => ('-', digits),
                None => ('+', exponent),
            };
            format!("{mantissa}E{sign}{digits:0>2}")
        }
        None => text,
    }
}
