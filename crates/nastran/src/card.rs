//! A whole card: its name and the fields of all its lines, with typed access that blames the right columns.

use crate::field::{FIELDS_PER_LINE, Field, Line};
use crate::real;
use crate::source::{InputError, Span};

/// The longest list that `THRU` may stand for: a slip in a number must not fill the memory.
const LONGEST_RANGE: u32 = 1_000_000;

/// A card with the data fields of all its lines; index 0 is the first field after the name.
#[derive(Debug)]
pub(crate) struct Card {
    /// Name in capitals, without `*`.
    pub(crate) name: String,
    /// Where the name stands.
    pub(crate) span: Span,
    fields: Vec<Field>,
    starts_free: bool,
    tail: String,
}

impl Card {
    /// Starts a card with its first line.
    pub(crate) fn start(line: Line) -> Result<Self, InputError> {
        let name = line.head.text().trim_end_matches('*').trim_end().to_uppercase();
        let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        if !is_name {
            let error =
                InputError::at(&line.head.span, format!("`{}` is not the name of a card", line.head.text()));
            return Err(error.with_help(
                "fields are 8 columns wide or separated by commas; what stands before the cards must end with BEGIN BULK",
            ));
        }
        Ok(Self { name, span: line.head.span, fields: line.data, starts_free: line.is_free, tail: line.tail })
    }

    /// Adds a continuation line.
    pub(crate) fn extend(&mut self, line: Line) -> Result<(), InputError> {
        let mark = line.head.text().get(1..).unwrap_or("").trim();
        if !mark.is_empty() && !self.tail.is_empty() && mark != self.tail {
            let message = format!("continuation `{mark}` follows a line that announces `{}`", self.tail);
            return Err(InputError::at(&line.head.span, message)
                .with_help("put continuations right after the line they continue"));
        }
        let half_line = !self.fields.len().is_multiple_of(FIELDS_PER_LINE);
        if half_line && line.data.len() == FIELDS_PER_LINE {
            let span = line.head.span.clone();
            let blank = || Field { raw: String::new(), span: span.clone() };
            self.fields.resize_with(self.fields.len().next_multiple_of(FIELDS_PER_LINE), blank);
        }
        self.fields.extend(line.data);
        self.tail = line.tail;
        Ok(())
    }

    /// The number of fields, up to the last one that is not empty.
    pub(crate) fn len(&self) -> usize {
        self.fields.iter().rposition(|field| !field.text().is_empty()).map_or(0, |last| last + 1)
    }

    /// A field's text without blanks; empty if the field is or does not exist.
    pub(crate) fn text(&self, index: usize) -> &str {
        self.fields.get(index).map_or("", Field::text)
    }

    /// Where a field stands; the card's name if the card ends before.
    pub(crate) fn span_of(&self, index: usize) -> &Span {
        self.fields.get(index).map_or(&self.span, |field| &field.span)
    }

    /// An error that blames a field.
    pub(crate) fn error(&self, index: usize, message: impl Into<String>) -> InputError {
        InputError::at(self.span_of(index), message)
    }

    /// Text that runs over several fields of the first line, such as a label.
    pub(crate) fn long_text(&self, range: std::ops::Range<usize>) -> String {
        let fields = self.fields.iter().take(range.end).skip(range.start);
        let text = if self.starts_free {
            fields
                .map(|field| field.raw.as_str())
                .collect::<Vec<_>>()
                .join(",")
                .trim_end_matches(',')
                .to_owned()
        } else {
            fields.map(|field| format!("{:8}", field.raw)).collect::<Vec<_>>().concat()
        };
        text.trim().to_owned()
    }

    /// A name of at most 8 characters.
    pub(crate) fn name_at(&self, index: usize, what: &str) -> Result<String, InputError> {
        match self.text(index) {
            "" => Err(self.empty(index, what, "a name")),
            text if text.chars().count() <= 8 => Ok(text.to_uppercase()),
            text => Err(self.error(
                index,
                format!("`{text}` in field {what} of {} is longer than 8 characters", self.name),
            )),
        }
    }

    /// An identification number, at least 1.
    pub(crate) fn id(&self, index: usize, what: &str) -> Result<u32, InputError> {
        match self.text(index) {
            "" => Err(self.empty(index, what, "a positive whole number")),
            text => text
                .parse()
                .ok()
                .filter(|id| *id > 0)
                .ok_or_else(|| self.wrong(index, what, "a positive whole number")),
        }
    }

    /// A whole number that may be zero, or the default of an empty field.
    pub(crate) fn count_or(&self, index: usize, what: &str, default: u32) -> Result<u32, InputError> {
        match self.text(index) {
            "" => Ok(default),
            text => text.parse().map_err(|_| self.wrong(index, what, "a whole number, zero or more")),
        }
    }

    /// A whole number of either sign, or the default of an empty field.
    pub(crate) fn integer_or(&self, index: usize, what: &str, default: i32) -> Result<i32, InputError> {
        match self.text(index) {
            "" => Ok(default),
            text => text.parse().map_err(|_| self.wrong(index, what, "a whole number")),
        }
    }

    /// A real that must be there.
    pub(crate) fn real(&self, index: usize, what: &str) -> Result<f64, InputError> {
        self.optional_real(index, what)?.ok_or_else(|| self.empty(index, what, "a real number"))
    }

    /// A real, or the default of an empty field.
    pub(crate) fn real_or(&self, index: usize, what: &str, default: f64) -> Result<f64, InputError> {
        Ok(self.optional_real(index, what)?.unwrap_or(default))
    }

    /// A real, or nothing if the field is empty.
    pub(crate) fn optional_real(&self, index: usize, what: &str) -> Result<Option<f64>, InputError> {
        let text = self.text(index);
        if text.is_empty() {
            return Ok(None);
        }
        real::parse(text).map(Some).ok_or_else(|| {
            let error = self.wrong(index, what, "a real number");
            if text.parse::<i64>().is_ok() {
                error.with_help(format!("write `{text}.` with a decimal point"))
            } else {
                error
            }
        })
    }

    /// Three reals in a row; empty ones are zero.
    pub(crate) fn vector(&self, index: usize, what: [&str; 3]) -> Result<[f64; 3], InputError> {
        Ok([
            self.real_or(index, what[0], 0.0)?,
            self.real_or(index + 1, what[1], 0.0)?,
            self.real_or(index + 2, what[2], 0.0)?,
        ])
    }

    /// Component digits 1 to 6 in ascending order, each once; empty or `0` gives none.
    pub(crate) fn components(&self, index: usize, what: &str) -> Result<Vec<u8>, InputError> {
        let text = self.text(index);
        let mut digits: Vec<u8> = text.bytes().filter(|b| *b != b'0').map(|b| b.wrapping_sub(b'0')).collect();
        digits.sort_unstable();
        let twice = digits.windows(2).any(|pair| pair[0] == pair[1]);
        if twice || digits.iter().any(|digit| !(1..=6).contains(digit)) {
            return Err(self.wrong(index, what, "a combination of the digits 1 to 6"));
        }
        Ok(digits)
    }

    /// The numbers from a field to the end of the card, `THRU` expanded; at least one.
    pub(crate) fn id_list(&self, from: usize, what: &str) -> Result<Vec<u32>, InputError> {
        self.id_list_until(from, self.len(), what)
    }

    /// As [`Card::id_list`], up to a field.
    pub(crate) fn id_list_until(&self, from: usize, end: usize, what: &str) -> Result<Vec<u32>, InputError> {
        let mut ids: Vec<u32> = Vec::new();
        let mut index = from;
        while index < end {
            if self.text(index).eq_ignore_ascii_case("THRU") {
                let first = *ids.last().ok_or_else(|| self.wrong(index, what, "a positive whole number"))?;
                let last = self.id(index + 1, what)?;
                if last < first || last - first > LONGEST_RANGE {
                    return Err(self
                        .error(index + 1, format!("{first} THRU {last} is not a range that can be meant")));
                }
                ids.extend(first + 1..=last);
                index += 1;
            } else if !self.text(index).is_empty() {
                ids.push(self.id(index, what)?);
            }
            index += 1;
        }
        if ids.is_empty() { Err(self.empty(from, what, "at least one number")) } else { Ok(ids) }
    }

    /// The error for a field that must not be empty.
    pub(crate) fn empty(&self, index: usize, what: &str, expected: &str) -> InputError {
        self.error(index, format!("field {what} of {} is empty; expected {expected}", self.name))
    }

    /// The error for a field with the wrong content.
    pub(crate) fn wrong(&self, index: usize, what: &str, expected: &str) -> InputError {
        let text = self.text(index);
        self.error(index, format!("`{text}` in field {what} of {} is not {expected}", self.name))
    }
}
