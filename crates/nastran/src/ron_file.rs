//! The one reader of RON files, and of JSON in their place where a name ends in `.json`; errors name the line, the column
//! and the field that was probably meant.

use crate::json_file;
use crate::ron_or_json::is_json;
use crate::source::{InputError, Span};
use crate::suggest::nearest;
use crate::text_file::read_text;
use ron::error::SpannedError;
use ron::extensions::Extensions;
use ron::ser::PrettyConfig;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reads and parses a RON file, or JSON by its ending; `Option` fields may be written without `Some`.
///
/// # Errors
/// If the file cannot be read or does not say what `T` expects.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, InputError> {
    parse_at(path, &read_text(path)?)
}

/// Parses RON text; `name` is the file name that errors give, and `.json` at its end says that the text is JSON.
///
/// # Errors
/// If the text does not say what `T` expects.
pub fn parse<T: DeserializeOwned>(name: &str, text: &str) -> Result<T, InputError> {
    parse_at(Path::new(name), text)
}

/// A value as the text of a file that [`read`] understands: JSON if its path ends so, else RON with the name of its kind in front.
///
/// # Errors
/// If the value cannot be written in that form.
pub fn file_text<T: Serialize>(path: &Path, kind: &str, value: &T) -> Result<String, InputError> {
    if !is_json(path) {
        return Ok(format!("{kind}{}\n", to_text(value)?));
    }
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| InputError::general(format!("this cannot be written as JSON: {error}")))?;
    Ok(text + "\n")
}

/// A value as RON text that [`read`] understands, four spaces a level, with the name of its type in front.
///
/// # Errors
/// If the value cannot be written as RON.
pub fn to_text<T: Serialize>(value: &T) -> Result<String, InputError> {
    let config = PrettyConfig::new().struct_names(false).extensions(Extensions::IMPLICIT_SOME);
    ron::Options::default()
        .with_default_extension(Extensions::IMPLICIT_SOME)
        .to_string_pretty(value, config)
        .map_err(|error| InputError::general(format!("this cannot be written as RON: {error}")))
}

fn parse_at<T: DeserializeOwned>(path: &Path, text: &str) -> Result<T, InputError> {
    if is_json(path) {
        return json_file::parse_at(path, text);
    }
    let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    let value = options.from_str(text).map_err(|error| explain(path, text, &error))?;
    refuse_not_finite(path, text)?;
    Ok(value)
}

/// Refuses `NaN`, `inf` and numbers too large for a computer (`1e400`), which RON takes for numbers; outside text in
/// quotes and comments. One place for all files, so that no field can be forgotten.
fn refuse_not_finite(path: &Path, text: &str) -> Result<(), InputError> {
    let mut comments = 0;
    for (index, line) in text.lines().enumerate() {
        for (column, word) in words(line, &mut comments) {
            let unsigned = word.trim_start_matches(['-', '+']);
            let named = ["NaN", "inf"].contains(&unsigned);
            let overflows = unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.')
                && unsigned.replace('_', "").parse::<f64>().is_ok_and(|number| !number.is_finite());
            if named || overflows {
                let file = Arc::new(path.to_path_buf());
                let place = Span::new(&file, index + 1, column, column + word.chars().count());
                return Err(InputError::at(&place, format!("`{word}` is not a finite number"))
                    .with_help("write a number such as 1.5 or -2e-3, or leave the field out if it may be"));
            }
        }
    }
    Ok(())
}

/// The words of a line outside quotes and comments, each with its column; `comments` counts open `/*`.
///
/// Text in quotes that goes over several lines is not followed: RON files of ours have none.
fn words<'a>(line: &'a str, comments: &mut usize) -> Vec<(usize, &'a str)> {
    let mut found = Vec::new();
    let (mut quoted, mut escaped) = (false, false);
    let mut start: Option<(usize, usize)> = None;
    let mut before = ' ';
    for (column, (at, character)) in line.char_indices().chain([(line.len(), ' ')]).enumerate() {
        let pair = (before, character);
        before = character;
        let part =
            !quoted && *comments == 0 && (character.is_ascii_alphanumeric() || "._+-".contains(character));
        if part && start.is_none() {
            start = Some((column + 1, at));
        } else if !part && let Some((column, from)) = start.take() {
            found.push((column, &line[from..at]));
        }
        match (pair, quoted, *comments) {
            (('/', '/'), false, 0) => break,
            (('/', '*'), false, _) => *comments += 1,
            (('*', '/'), false, 1..) => *comments -= 1,
            ((_, '"'), _, 0) if !escaped => quoted = !quoted,
            _ => {}
        }
        escaped = quoted && character == '\\' && !escaped;
    }
    found
}

fn explain(path: &Path, text: &str, error: &SpannedError) -> InputError {
    let file: Arc<PathBuf> = Arc::new(path.to_path_buf());
    let (start, end) = (&error.span.start, &error.span.end);
    // The parser starts at the blanks before the word it does not like.
    let line = text.lines().nth(start.line.saturating_sub(1)).unwrap_or("");
    let rest = line.chars().skip(start.col.saturating_sub(1));
    let column = start.col + rest.take_while(|character| character.is_whitespace()).count();
    let end_column = if end.line == start.line { end.col.max(column + 1) } else { column + 1 };
    let span = Span::new(&file, start.line, column, end_column);
    match &error.code {
        ron::Error::NoSuchStructField { expected, found, .. } => unknown(&span, "field", found, expected),
        ron::Error::NoSuchEnumVariant { expected, found, .. } => unknown(&span, "choice", found, expected),
        ron::Error::MissingStructField { field, outer } => {
            let place = outer.as_ref().map_or(String::new(), |name| format!(" of {name}"));
            InputError::at(&span, format!("the field `{field}`{place} is missing"))
                .with_help(format!("add `{field}: ...` inside the parentheses that end here"))
        }
        code => InputError::at(&span, format!("not understood as RON: {code}")).with_help(kind_of_file(code)),
    }
}

/// What to do about a text that is no RON of this kind.
fn kind_of_file(code: &ron::Error) -> &'static str {
    match code {
        ron::Error::ExpectedDifferentStructName { .. } | ron::Error::ExpectedNamedStructLike(_) => {
            "this is a file of another kind: is it the one that was meant?"
        }
        ron::Error::ExceededRecursionLimit => "parentheses are nested too deep here: look for one too many",
        _ => "look for a comma, a quote or a parenthesis too many or missing, here or just before",
    }
}

fn unknown(span: &Span, kind: &str, found: &str, expected: &[&str]) -> InputError {
    let list = expected.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let error = InputError::at(span, format!("there is no {kind} `{found}` here; expected one of {list}"));
    match nearest(found, expected.iter().copied()) {
        Some(name) => error.with_help(format!("did you mean `{name}`?")),
        None => error,
    }
}
