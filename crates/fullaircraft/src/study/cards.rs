//! Cards in large fields, which every program reads without rounding.

use std::fmt::Write as _;

/// Characters of a field, and fields of a line.
const WIDTH: usize = 16;
const A_LINE: usize = 4;

/// Numbers of what a study adds begin here.
pub(super) const FIRST: u32 = 90_000_000;

/// A card by its fields; empty ones are blank. Lines come in pairs, as the format asks for.
pub(super) fn card(name: &str, fields: &[String]) -> String {
    let mut text = String::new();
    for number in 0..fields.len().div_ceil(A_LINE).next_multiple_of(2) {
        let head = if number == 0 { format!("{name}*") } else { "*".to_owned() };
        let _ = write!(text, "{head:<8}");
        for field in fields.iter().skip(number * A_LINE).take(A_LINE) {
            let _ = write!(text, "{field:<WIDTH$}");
        }
        text.truncate(text.trim_end().len());
        text.push('\n');
    }
    text
}

/// A number as a field: as many digits as it has room for.
pub(super) fn real(value: f64) -> String {
    nastran::real::format(value, WIDTH)
}

/// So many empty fields.
pub(super) fn blanks(count: usize) -> impl Iterator<Item = String> {
    std::iter::repeat_n(String::new(), count)
}

/// A name as LABEL has it: nothing that a case control would take for more.
pub(super) fn label(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric() || " ._-+".contains(*c)).collect()
}

/// What a section asks for: lines of case control, and cards.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Asked {
    /// Lines of case control.
    pub(super) control: String,
    /// Cards.
    pub(super) cards: String,
}

impl Asked {
    /// Adds a command of case control that selects a number.
    pub(super) fn select(&mut self, command: &str, id: u32) {
        let _ = writeln!(self.control, "{command} = {id}");
    }

    /// Adds a card.
    pub(super) fn add(&mut self, name: &str, fields: &[String]) {
        self.cards += &card(name, fields);
    }

    /// Adds what another section asks for.
    pub(super) fn join(&mut self, other: &Self) {
        self.control += &other.control;
        self.cards += &other.cards;
    }
}
