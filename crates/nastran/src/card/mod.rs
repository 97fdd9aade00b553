//! A whole card: its name and the fields of all its lines, and errors that blame the right columns.

pub(crate) mod fields;
pub(crate) mod line;
pub(crate) mod lists;
mod values;

use crate::source::{InputError, Span};
pub(crate) use line::FIELDS_PER_LINE;
use line::{Field, Line, continuation_name};

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

    /// The name of the continuation that it announces; empty if it has all its lines, or announces one without a name.
    pub(crate) fn announced(&self) -> &str {
        &self.tail
    }

    /// Adds a continuation line.
    pub(crate) fn extend(&mut self, line: Line) -> Result<(), InputError> {
        let mark = continuation_name(line.head.text());
        if !mark.is_empty() && !self.tail.is_empty() && mark != self.tail {
            let message = format!("continuation `{mark}` follows a line that announces `{}`", self.tail);
            return Err(InputError::at(&line.head.span, message)
                .with_help("put continuations right after the line they continue"));
        }
        let half_line = !self.fields.len().is_multiple_of(FIELDS_PER_LINE);
        if half_line && line.data.len() >= FIELDS_PER_LINE {
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

    /// Takes a field that is empty from another card.
    pub(crate) fn fill(&mut self, index: usize, from: &Self) {
        if !self.text(index).is_empty() || from.text(index).is_empty() {
            return;
        }
        let span = self.span.clone();
        let blank = || Field { raw: String::new(), span: span.clone() };
        if self.fields.len() <= index {
            self.fields.resize_with(index + 1, blank);
        }
        self.fields[index] =
            Field { raw: from.fields[index].raw.clone(), span: from.fields[index].span.clone() };
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

    /// The error for a field that must not be empty.
    pub(crate) fn empty(&self, index: usize, what: &str, expected: &str) -> InputError {
        self.error(index, format!("field {what} of {} is empty; expected {expected}", self.name))
    }

    /// The error for a field with the wrong content.
    pub(crate) fn wrong(&self, index: usize, what: &str, expected: &str) -> InputError {
        let text = self.text(index);
        self.error(index, format!("`{text}` in field {what} of {} is not {expected}", self.name))
    }

    /// The error for a number or name that another card has, which stands at `first`.
    pub(crate) fn twice(&self, what: &str, first: &Span) -> InputError {
        let message = format!("{what} is given twice; the number or name is taken since {first}");
        self.error(0, message).with_help("give every card its own number or name")
    }
}
