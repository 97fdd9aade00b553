//! Cards in large fields, which every program reads without rounding.

use std::fmt::Write as _;

/// Characters of a field, and fields of a line.
const WIDTH: usize = 16;
const A_LINE: usize = 4;

/// A card by its fields; empty ones are blank.
pub(super) fn card(name: &str, fields: &[String]) -> String {
    let mut text = String::new();
    for (number, line) in fields.chunks(A_LINE).enumerate() {
        let head = if number == 0 { format!("{name}*") } else { "*".to_owned() };
        let _ = write!(text, "{head:<8}");
        for field in line {
            let _ = write!(text, "{field:<WIDTH$}");
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// A number as a field: ten digits.
pub(super) fn real(value: f64) -> String {
    format!("{value:.9E}")
}
