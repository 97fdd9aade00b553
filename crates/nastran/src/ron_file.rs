//! Reading RON files with errors that name the line, the column and the field that was probably meant.

use crate::source::{InputError, Span, read_text};
use crate::suggest::nearest;
use ron::error::SpannedError;
use ron::extensions::Extensions;
use ron::ser::PrettyConfig;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reads and parses a RON file; `Option` fields may be written without `Some`.
///
/// # Errors
/// If the file cannot be read or does not say what `T` expects.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, InputError> {
    parse_at(path, &read_text(path)?)
}

/// Parses RON text; `name` is the file name that errors give.
///
/// # Errors
/// If the text does not say what `T` expects.
pub fn parse<T: DeserializeOwned>(name: &str, text: &str) -> Result<T, InputError> {
    parse_at(Path::new(name), text)
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
    let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    options.from_str(text).map_err(|error| explain(path, text, &error))
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
        code => InputError::at(&span, format!("not understood as RON: {code}"))
            .with_help("compare with a shipped file of the same kind, such as data/tuflex/wing.ron"),
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
