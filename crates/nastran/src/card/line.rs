//! From lines to fields: small (8 columns), large (16 columns, `*`) and free (commas) lines, with tabs,
//! comments and continuations. Every field keeps its line and columns.
//!
//! A line is free if a comma stands in its first ten columns, or right after a whole number that begins in the ninth. Its fields are separated by
//! commas, numbers by blanks, too; those beyond the eighth are those of continuations (MSC Nastran's automatic continuation), unless the
//! ninth names one. A continuation starts with `+`, `*`, a blank or
//! a comma and continues the card before it; if both ends carry a continuation name, the names must agree,
//! because sorted continuations are not supported. `$` starts a comment anywhere.

use crate::real;
use crate::source::{InputError, Span};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

/// The data fields of one whole line; a large line has half of them.
pub(crate) const FIELDS_PER_LINE: usize = 8;

/// One field as it stands in the file.
#[derive(Debug, Clone)]
pub(crate) struct Field {
    /// The text with the blanks around it.
    pub(crate) raw: String,
    /// The columns of the text without the blanks; of the whole field if it is empty.
    pub(crate) span: Span,
}

impl Field {
    pub(crate) fn text(&self) -> &str {
        self.raw.trim()
    }
}

/// One line cut into fields.
#[derive(Debug)]
pub(crate) struct Line {
    /// The card's name, or the continuation mark.
    pub(crate) head: Field,
    /// Eight data fields, four on a large line, eight for each line that a long free one stands for.
    pub(crate) data: Vec<Field>,
    /// The name of the continuation that follows ([`continuation_name`]); often empty.
    pub(crate) tail: String,
    /// True for comma-separated lines.
    pub(crate) is_free: bool,
}

impl Line {
    /// True if the line continues the card before it.
    pub(crate) fn is_continuation(&self) -> bool {
        let head = self.head.text();
        head.is_empty() || head.starts_with(['+', '*'])
    }

    /// Cuts a line; nothing if it is blank or only a comment.
    pub(crate) fn cut(file: &Arc<PathBuf>, number: usize, text: &str) -> Result<Option<Self>, InputError> {
        let source = Columns::new(file, number, text);
        if source.characters.iter().all(|(character, _)| character.is_whitespace()) {
            return Ok(None);
        }
        let is_free = source.characters.iter().take(10).any(|(character, _)| *character == ',')
            || source.counts_with_comma();
        if is_free { source.free().map(Some) } else { Ok(Some(source.fixed())) }
    }
}

/// The name of a continuation, as the line before announces it and the continuation itself begins with it.
///
/// Nastran compares columns 74 to 80 with columns 2 to 8, so that `+000003` in column 74 goes with `++000003`; but decks shift names
/// within their fields, so signs and blanks before a name say nothing here.
pub(crate) fn continuation_name(text: &str) -> &str {
    text.trim_start_matches(|c: char| c.is_whitespace() || "+*".contains(c)).trim_end()
}

/// A line's characters, comment removed and tabs expanded, each with its column in the file.
struct Columns<'a> {
    file: &'a Arc<PathBuf>,
    number: usize,
    characters: Vec<(char, usize)>,
}

impl<'a> Columns<'a> {
    fn new(file: &'a Arc<PathBuf>, number: usize, text: &str) -> Self {
        let mut characters = Vec::with_capacity(80);
        for (index, character) in text.chars().take_while(|character| *character != '$').enumerate() {
            if character == '\t' {
                characters.push((' ', index + 1));
                while characters.len() % 8 != 0 {
                    characters.push((' ', index + 1));
                }
            } else {
                characters.push((character, index + 1));
            }
        }
        Self { file, number, characters }
    }

    /// The column in the file, also beyond the end of the line.
    fn column(&self, index: usize) -> usize {
        match (self.characters.get(index), self.characters.last()) {
            (Some((_, column)), _) => *column,
            (None, Some((_, last))) => last + 1 + index - self.characters.len(),
            (None, None) => index + 1,
        }
    }

    fn field(&self, range: Range<usize>) -> Field {
        let end = range.end.min(self.characters.len());
        let inside = self.characters.get(range.start..end).unwrap_or(&[]);
        let is_text = |(character, _): &(char, usize)| !character.is_whitespace();
        let (first, last) = match (inside.iter().position(is_text), inside.iter().rposition(is_text)) {
            (Some(first), Some(last)) => (range.start + first, range.start + last + 1),
            _ => (range.start, range.end.max(range.start + 1)),
        };
        let start_column = self.column(first);
        let end_column = self.column(last - 1) + 1;
        let span = Span::new(self.file, self.number, start_column, end_column.max(start_column + 1));
        Field { raw: inside.iter().map(|(character, _)| *character).collect(), span }
    }

    fn fixed(&self) -> Line {
        let head = self.field(0..8);
        let width = if head.text().contains('*') { 16 } else { 8 };
        let data = (8..72).step_by(width).map(|start| self.field(start..start + width)).collect();
        let tail = self.field(72..80);
        let is_named = tail.text().starts_with(['+', '*']);
        let tail = if is_named { continuation_name(tail.text()).to_owned() } else { String::new() };
        Line { head, data, tail, is_free: false }
    }

    /// Whether the first data field is a whole number and a comma: a free line whose commas begin late.
    fn counts_with_comma(&self) -> bool {
        let first: String = self.characters.iter().skip(8).take(8).map(|(character, _)| *character).collect();
        let number = first.trim().strip_suffix(',').unwrap_or("").trim_end();
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    }

    /// The fields between two commas: one, or as many as there are numbers with blanks between them.
    fn separated(&self, range: Range<usize>, into: &mut Vec<Field>) {
        let is_blank = |at: &usize| self.characters[*at].0.is_whitespace();
        let places: Vec<usize> = range.clone().collect();
        let words: Vec<&[usize]> = places.split(|at| is_blank(at)).filter(|word| !word.is_empty()).collect();
        let is_number = |word: &&[usize]| {
            let text: String = word.iter().map(|at| self.characters[*at].0).collect();
            real::parse(&text).is_some() || text.bytes().all(|byte| byte.is_ascii_digit())
        };
        // The name of the card stands before the first number.
        let named = usize::from(into.is_empty());
        if words.len() < 2 || !words.iter().skip(named).all(is_number) {
            into.push(self.field(range));
            return;
        }
        into.extend(words.iter().map(|word| self.field(word[0]..word[word.len() - 1] + 1)));
    }

    fn free(&self) -> Result<Line, InputError> {
        let mut pieces = Vec::new();
        let mut start = 0;
        for end in 0..=self.characters.len() {
            if end == self.characters.len() || self.characters[end].0 == ',' {
                self.separated(start..end, &mut pieces);
                start = end + 1;
            }
        }
        let mut data = pieces.split_off(1);
        let head = pieces.remove(0);
        let count = if head.text().contains('*') { FIELDS_PER_LINE / 2 } else { FIELDS_PER_LINE };
        data.truncate(data.iter().rposition(|field| !field.text().is_empty()).map_or(0, |last| last + 1));
        let replicates = head.text().starts_with('=');
        let is_mark =
            |field: &Field| field.text().starts_with('+') || (field.text().starts_with('*') && !replicates);
        // An empty ninth field may be data or a continuation without a name; so what follows it is no long line.
        let goes_on = |field: &Field| !field.text().is_empty() && !is_mark(field);
        let is_long = count == FIELDS_PER_LINE && data.get(count).is_some_and(goes_on);
        let is_named = data.len() > count && data.len() % count == 1;
        // A `+` that begins no number is a name, even where fields before it were left out.
        let is_short_of = |field: &Field| {
            field.text().starts_with('+')
                && !field.text()[1..].starts_with(|c: char| c.is_ascii_digit() || c == '.')
        };
        let tail = data.pop_if(|last| (is_named && is_mark(last)) || is_short_of(last));
        if data.len() > count && !is_long {
            let surplus = data[count..].iter().find(|field| goes_on(field)).unwrap_or(&data[count]);
            let message = format!(
                "a free-field line has at most {count} fields between its name and that of its continuation"
            );
            return Err(
                InputError::at(&surplus.span, message).with_help("go on in a line that starts with a comma")
            );
        }
        let beyond = self.characters.len();
        let whole = data.len().max(1).next_multiple_of(count);
        data.resize_with(whole, || self.field(beyond..beyond));
        let tail = tail.map_or_else(String::new, |mark| continuation_name(mark.text()).to_owned());
        Ok(Line { head, data, tail, is_free: true })
    }
}
