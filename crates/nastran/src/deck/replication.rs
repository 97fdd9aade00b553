//! Replication: a line that repeats the card before it with changes.
//!
//! `=` in a field takes it over, `==` takes it and all after it over, `*(x)` or `*x` adds x, anything else stands for itself.
//! In the place of the name `=` takes the name over, and `=(n)` or `=n` repeats the line before it n times more (with fields of
//! its own, as NASTRAN-95 has it, these n times).

use crate::bulk_data::CARD_KINDS;
use crate::card::line::{Field, Line};
use crate::real;
use crate::source::InputError;

/// The most cards that one line may stand for: a slip in a number must not fill the memory.
const MOST: usize = 1_000_000;

/// Cards with a label that runs over several fields, in which the signs of a replication are letters.
const LABELLED: [&str; 2] = ["MONPNT1", "MONPNT3"];

/// The card that replications in a row go out from, and what the last of them changed.
#[derive(Debug, Default)]
pub(super) struct Replication {
    /// Name and fields.
    last: Option<(String, Vec<String>)>,
    /// The fields of the last line that replicated.
    rule: Option<Vec<String>>,
}

/// Whether a line is a replication: without a name of its own, or a card that is read with a field taken over or stepped on.
pub(super) fn is_replication(line: &Line) -> bool {
    line.head.text().starts_with('=')
        || (!line.is_continuation() && replicating(&name_of(line), line).is_some())
}

/// Refuses a continuation that takes over fields: it leaves open of which line.
pub(super) fn refuse_in_continuation(name: &str, line: &Line) -> Result<(), InputError> {
    replicating(name, line).map_or(Ok(()), |field| {
        let sign = field.text();
        let message = format!("`{sign}` in a continuation of {name}: only cards of one line are replicated");
        Err(InputError::at(&field.span, message).with_help("write the card out"))
    })
}

/// The first field that takes over or steps on, of a card that is read: in the text of others (DEQATN) the signs are letters.
fn replicating<'a>(name: &str, line: &'a Line) -> Option<&'a Field> {
    let found = line.data.iter().find(|field| is_sign(field.text()))?;
    let is_read = !LABELLED.contains(&name) && CARD_KINDS.iter().any(|kind| kind.names.contains(&name));
    is_read.then_some(found)
}

/// `=`, `==`, `*(x)` and `*x`.
fn is_sign(text: &str) -> bool {
    let is_number = |step: &str| step.parse::<i64>().is_ok() || real::parse(step).is_some();
    text == "=" || text == "==" || text.strip_prefix('*').is_some_and(|step| is_number(bare(step)))
}

/// A number without the brackets around it.
fn bare(text: &str) -> &str {
    text.trim_matches(['(', ')', ' '])
}

fn name_of(line: &Line) -> String {
    line.head.text().trim_end_matches('*').trim_end().to_uppercase()
}

impl Replication {
    /// A replication that goes out from a card of one line.
    pub(super) fn of(card: Option<Line>) -> Self {
        Self { last: card.map(|card| (name_of(&card), texts(&card))), rule: None }
    }

    /// The cards that a replication stands for.
    pub(super) fn expanded(&mut self, line: &Line) -> Result<Vec<Line>, InputError> {
        let copies = self.copies(line)?;
        let (Some((name, mut fields)), Some(rule)) = (self.last.clone(), self.rule.clone()) else {
            let message = "a replication (`=`) has no card of one line before it";
            return Err(InputError::at(&line.head.span, message).with_help("write the cards out"));
        };
        let own = name_of(line);
        if !own.starts_with('=') && own != name {
            let message = format!("{own} takes over fields of the card before it, which is a {name}");
            return Err(InputError::at(&line.head.span, message).with_help("write the fields out"));
        }
        let mut lines = Vec::new();
        for _ in 0..copies {
            fields = changed(line, &fields, &rule)?;
            let data = fields.iter().enumerate().map(|(at, raw)| field(line, at, raw)).collect();
            let head = Field { raw: name.clone(), span: line.head.span.clone() };
            lines.push(Line { head, data, tail: String::new(), is_free: line.is_free });
        }
        self.last = Some((name, fields));
        Ok(lines)
    }

    /// How many cards a line stands for; the rule by which each is made of the one before it is kept.
    fn copies(&mut self, line: &Line) -> Result<usize, InputError> {
        let head = line.head.text();
        let own = texts(line);
        let count = head.trim_start_matches('=');
        if !head.starts_with('=') || count.is_empty() {
            self.rule = Some(if head.starts_with("==") { vec!["==".to_owned()] } else { own });
            return Ok(1);
        }
        if own.iter().any(|text| !text.is_empty()) {
            self.rule = Some(own);
        }
        bare(count).parse::<usize>().ok().filter(|number| *number <= MOST).ok_or_else(|| {
            InputError::at(&line.head.span, format!("`{head}` repeats nothing"))
                .with_help("expected = and how often the line before it is repeated, such as =(8)")
        })
    }
}

fn texts(line: &Line) -> Vec<String> {
    line.data.iter().map(|field| field.text().to_owned()).collect()
}

/// A field with another text. What is not the line's own stands where the line begins.
fn field(line: &Line, at: usize, raw: &str) -> Field {
    let own = line.data.get(at).filter(|own| own.text() == raw && !raw.is_empty());
    Field { raw: raw.to_owned(), span: own.map_or(&line.head.span, |own| &own.span).clone() }
}

/// The fields of the next card.
fn changed(line: &Line, fields: &[String], rule: &[String]) -> Result<Vec<String>, InputError> {
    let rest = rule.iter().position(|text| text == "==").unwrap_or(usize::MAX);
    let count = fields.len().max(rule.len());
    let old = |at: usize| fields.get(at).map_or("", String::as_str);
    (0..count)
        .map(|at| match rule.get(at).map_or("", String::as_str) {
            text if at >= rest || text == "=" => Ok(old(at).to_owned()),
            sign if sign.starts_with('%') || (!sign.is_empty() && sign.trim_matches('/').is_empty()) => {
                let message = format!("`{sign}` in a replication is a form of NASTRAN-95 that is not read");
                Err(InputError::at(&line.head.span, message).with_help("write the step, such as *(.5)"))
            }
            step if step.starts_with('*') => {
                let step = bare(&step[1..]);
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
