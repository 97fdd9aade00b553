//! Replication: a line that begins with `=` repeats the card before it with changes.
//!
//! `=` in a field takes it over, `==` takes it and all after it over, `*(x)` or `*x` adds x, anything else stands for itself;
//! a line with only `=(n)` or `=n` repeats the line before it n times more.

use crate::card::line::{Field, Line};
use crate::real;
use crate::source::InputError;

/// The most cards that one line may stand for: a slip in a number must not fill the memory.
const MOST: usize = 1_000_000;

/// The card that replications in a row go out from, and what the last of them changed.
#[derive(Debug, Default)]
pub(super) struct Replication {
    /// Name and fields.
    last: Option<(String, Vec<String>)>,
    /// The fields of the last line that began with `=`.
    rule: Option<Vec<String>>,
}

/// Whether a line is a replication.
pub(super) fn is_replication(line: &Line) -> bool {
    line.head.text().starts_with('=')
}

impl Replication {
    /// A replication that goes out from a card of one line.
    pub(super) fn of(card: Option<Line>) -> Self {
        Self { last: card.map(|card| (card.head.text().to_owned(), texts(&card))), rule: None }
    }

    /// The cards that a replication stands for.
    pub(super) fn expanded(&mut self, line: &Line) -> Result<Vec<Line>, InputError> {
        let head = line.head.text();
        let count = head.trim_start_matches('=');
        let copies = if count.is_empty() {
            self.rule = Some(texts(line));
            1
        } else {
            let number = count.trim_matches(['(', ')']).trim();
            number.parse::<usize>().ok().filter(|number| *number <= MOST).ok_or_else(|| {
                InputError::at(&line.head.span, format!("`{head}` repeats nothing"))
                    .with_help("expected = and how often the line before it is repeated, such as =(8)")
            })?
        };
        let (Some((name, mut fields)), Some(rule)) = (self.last.clone(), self.rule.clone()) else {
            let message = "a replication (`=`) has no card of one line before it";
            return Err(InputError::at(&line.head.span, message).with_help("write the cards out"));
        };
        let mut lines = Vec::new();
        for _ in 0..copies {
            fields = changed(line, &fields, &rule)?;
            let data = fields.iter().map(|raw| field(line, raw)).collect();
            lines.push(Line { head: field(line, &name), data, tail: String::new(), is_free: line.is_free });
        }
        self.last = Some((name, fields));
        Ok(lines)
    }
}

fn texts(line: &Line) -> Vec<String> {
    line.data.iter().map(|field| field.text().to_owned()).collect()
}

/// A field with another text, which stands where the replication does.
fn field(line: &Line, raw: &str) -> Field {
    Field { raw: raw.to_owned(), span: line.head.span.clone() }
}

/// The fields of the next card.
fn changed(line: &Line, fields: &[String], rule: &[String]) -> Result<Vec<String>, InputError> {
    let rest = rule.iter().position(|text| text == "==").unwrap_or(usize::MAX);
    let count = fields.len().max(rule.len());
    let old = |at: usize| fields.get(at).map_or("", String::as_str);
    (0..count)
        .map(|at| match rule.get(at).map_or("", String::as_str) {
            text if at >= rest || text == "=" => Ok(old(at).to_owned()),
            step if step.starts_with('*') => {
                let step = step[1..].trim_matches(['(', ')']);
                sum(old(at), step).ok_or_else(|| {
                    InputError::at(&line.head.span, format!("`{step}` cannot be added to `{}`", old(at)))
                        .with_help("add whole numbers to whole numbers and reals to reals")
                })
            }
            text => Ok(text.to_owned()),
        })
        .collect()
}

fn sum(old: &str, step: &str) -> Option<String> {
    // An empty field counts as zero.
    let whole = if old.is_empty() { Ok(0) } else { old.parse::<i64>() };
    if let (Ok(old), Ok(step)) = (whole, step.parse::<i64>()) {
        return Some(old.checked_add(step)?.to_string());
    }
    let old = if old.is_empty() { 0.0 } else { real::parse(old)? };
    Some(real::format(old + real::parse(step)?, 16))
}
