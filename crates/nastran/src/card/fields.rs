//! The fields of a card being written: 8 characters wide if that is enough, 16 otherwise.

use super::line::FIELDS_PER_LINE;
use crate::motion::Motion;
use crate::real;

enum Value {
    Blank,
    Int(u32),
    Real(f64),
    Text(String),
}

impl Value {
    fn text(&self, width: usize) -> String {
        match self {
            Self::Blank => String::new(),
            Self::Int(number) => number.to_string(),
            Self::Real(number) => real::format(*number, width),
            Self::Text(text) => text.clone(),
        }
    }

    fn fits_small(&self) -> bool {
        match self {
            Self::Real(number) => real::parse(&real::format(*number, 8)) == Some(*number),
            other => other.text(8).len() <= 8,
        }
    }
}

/// A card being written.
pub(crate) struct Fields {
    name: &'static str,
    /// A line that is written as it is, before those of the fields.
    first_line: Option<String>,
    values: Vec<Value>,
}

impl Fields {
    pub(crate) fn new(name: &'static str) -> Self {
        Self { name, first_line: None, values: Vec::new() }
    }

    fn push(mut self, value: Value) -> Self {
        self.values.push(value);
        self
    }

    pub(crate) fn int(self, number: u32) -> Self {
        self.push(Value::Int(number))
    }

    pub(crate) fn ints(self, numbers: impl IntoIterator<Item = u32>) -> Self {
        numbers.into_iter().fold(self, Self::int)
    }

    pub(crate) fn real(self, number: f64) -> Self {
        self.push(Value::Real(number))
    }

    pub(crate) fn reals<'a>(self, numbers: impl IntoIterator<Item = &'a f64>) -> Self {
        numbers.into_iter().fold(self, |card, number| card.real(*number))
    }

    pub(crate) fn text(self, text: impl Into<String>) -> Self {
        self.push(Value::Text(text.into()))
    }

    pub(crate) fn digits(self, digits: &[u8]) -> Self {
        if digits.is_empty() {
            self.blanks(1)
        } else {
            self.text(digits.iter().map(u8::to_string).collect::<String>())
        }
    }

    pub(crate) fn blanks(self, count: usize) -> Self {
        (0..count).fold(self, |card, _| card.push(Value::Blank))
    }

    /// An identification number, or an empty field.
    pub(crate) fn optional(self, number: Option<u32>) -> Self {
        self.push(number.map_or(Value::Blank, Value::Int))
    }

    /// Grid and component; two empty fields for the ground.
    pub(crate) fn motion(self, motion: Option<Motion>) -> Self {
        match motion {
            Some((grid, component)) => self.int(grid).int(u32::from(component)),
            None => self.blanks(2),
        }
    }

    /// Empty fields up to the end of the line of eight.
    pub(crate) fn next_line(self) -> Self {
        let missing = self.values.len().next_multiple_of(FIELDS_PER_LINE) - self.values.len();
        self.blanks(missing)
    }

    /// A line as it is, before those of the fields.
    pub(crate) fn first_line(mut self, text: String) -> Self {
        self.first_line = Some(text);
        self
    }

    /// A real, or an empty field.
    pub(crate) fn optional_real(self, number: Option<f64>) -> Self {
        self.push(number.map_or(Value::Blank, Value::Real))
    }

    /// Grids and components.
    pub(crate) fn motions(self, motions: &[Motion]) -> Self {
        motions.iter().fold(self, |card, motion| card.motion(Some(*motion)))
    }

    /// The lines; none for a card without fields.
    pub(crate) fn write(&self) -> String {
        match &self.first_line {
            Some(first) => format!("{:<8}{first}\n{}", self.name, self.lines("")),
            None => self.lines(self.name),
        }
    }

    fn lines(&self, name: &str) -> String {
        let is_small = self.values.iter().all(Value::fits_small);
        let (width, per_line) = if is_small { (8, 8) } else { (16, 4) };
        let mut text = String::new();
        // Large lines come in pairs.
        let count =
            if is_small { self.values.len() } else { self.values.len().next_multiple_of(FIELDS_PER_LINE) };
        for start in (0..count).step_by(per_line) {
            let head = match (start == 0 && !name.is_empty(), is_small) {
                (true, true) => name.to_owned(),
                (true, false) => format!("{name}*"),
                (false, true) => "+".to_owned(),
                (false, false) => "*".to_owned(),
            };
            let fields = self.values.iter().skip(start).take(per_line);
            let line = fields
                .fold(format!("{head:<8}"), |line, value| format!("{line}{:>width$}", value.text(width)));
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}
