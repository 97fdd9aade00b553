//! DMI: matrices given in the deck, such as Nastran's load corrections WKK and FA2J and the camber W2GJ.
//!
//! Read in every style Nastran allows: runs of values after a row number (`I1 A(I1) A(I1+1) ... I2 A(I2)`) and
//! repetition (`A THRU I`). Written in one style only: explicit (row, value) pairs for every row, zeros too, in
//! 8-character fields, because some other programs read runs and `THRU` wrongly without a word.
//!
//! # What is lost
//! [`Dmi::rounded_to_fields`] rounds to what an 8-character field can hold; what is rounded is written and read
//! again without any loss, bit by bit. The rounding changes a positive number from 0.1 to 10 by at most 5.1e-7
//! of itself and a negative one by at most 5.1e-6 (the sign takes a digit); for magnitudes from 1e-9 to 1e9
//! it is at most 5.1e-4 of the number, and 0.051 if the exponent takes three digits.

use crate::real;
use std::fmt::Write as _;

/// A real matrix (DMI).
#[derive(Debug, Clone, PartialEq)]
pub struct Dmi {
    /// Name, 1 to 8 characters.
    pub name: String,
    /// Form: 1 square, 2 rectangular, 3 diagonal, 6 symmetric.
    pub form: u32,
    /// Type of the input: 1 real single, 2 real double precision.
    pub tin: u32,
    /// Type of the output: 0 as the machine prefers, 1 or 2 real.
    pub tout: u32,
    /// Number of rows M (of a diagonal matrix: its order).
    pub rows: usize,
    /// The columns, each with `rows` values; a diagonal matrix has its diagonal as the only column.
    pub columns: Vec<Vec<f64>>,
}

impl Dmi {
    /// A matrix of one column (form 2).
    pub fn column_vector(name: &str, values: Vec<f64>) -> Self {
        Self { name: name.to_owned(), form: 2, tin: 1, tout: 0, rows: values.len(), columns: vec![values] }
    }

    /// A diagonal matrix (form 3).
    pub fn diagonal(name: &str, values: Vec<f64>) -> Self {
        Self { name: name.to_owned(), form: 3, tin: 1, tout: 0, rows: values.len(), columns: vec![values] }
    }

    /// The same matrix with every value rounded to the nearest that an 8-character field can hold.
    #[must_use]
    pub fn rounded_to_fields(&self) -> Self {
        let round = |value: &f64| real::parse(&real::format(*value, 8)).unwrap_or(*value);
        let columns = self.columns.iter().map(|column| column.iter().map(round).collect()).collect();
        Self { columns, ..self.clone() }
    }

    /// The cards, each line ended: the header, then every column as explicit (row, value) pairs.
    ///
    /// Exact for values that [`Dmi::rounded_to_fields`] leaves alone; others are rounded the same way. A value
    /// that is not finite is written as it prints (`NaN`), which every reader refuses.
    pub fn write(&self) -> String {
        let mut text = String::new();
        let Self { name, form, tin, tout, rows, .. } = self;
        let header = format!(
            "DMI     {name:>8}{:>8}{form:>8}{tin:>8}{tout:>8}{:>8}{rows:>8}{:>8}",
            0,
            "",
            self.columns.len()
        );
        text.push_str(&header);
        text.push('\n');
        for (index, column) in self.columns.iter().enumerate() {
            let _ = write!(text, "DMI     {name:>8}{:>8}", index + 1);
            for (row, value) in column.iter().enumerate() {
                if row >= 3 && (row - 3) % 4 == 0 {
                    text.push_str("\n        ");
                }
                let _ = write!(text, "{:>8}{:>8}", row + 1, real::format(*value, 8));
            }
            text.push('\n');
        }
        text
    }
}
