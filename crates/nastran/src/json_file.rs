//! Reading JSON in the place of RON: the same types, and errors that say as much. Numbers that are not finite are none in JSON.

use crate::source::{InputError, Span};
use crate::suggest::nearest;
use serde::de::DeserializeOwned;
use serde_json::error::Category;
use std::path::Path;
use std::sync::Arc;

pub(crate) fn parse_at<T: DeserializeOwned>(path: &Path, text: &str) -> Result<T, InputError> {
    serde_json::from_str(text).map_err(|error| explain(path, text, &error))
}

/// serde's errors are sentences only; those that name a field or a choice are taken apart for what was probably meant.
fn explain(path: &Path, text: &str, error: &serde_json::Error) -> InputError {
    let sentence = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let sentence = sentence.strip_suffix(&place).unwrap_or(&sentence);
    let line = text.lines().nth(error.line().saturating_sub(1)).unwrap_or("");
    // The reader counts bytes and stands behind what it does not like.
    let read = line.get(..error.column()).unwrap_or(line);
    let span = |start: &str, end: usize| {
        let column = start.chars().count() + 1;
        Span::new(&Arc::new(path.to_path_buf()), error.line(), column, column + end.max(1))
    };
    for (kind, begins) in [("field", "unknown field `"), ("choice", "unknown variant `")] {
        let Some((found, expected)) = sentence.strip_prefix(begins).and_then(|rest| rest.split_once('`'))
        else {
            continue;
        };
        let quoted = format!("\"{found}\"");
        let start = read.rfind(&quoted).map_or(read, |at| &read[..at]);
        let known: Vec<&str> = expected.split('`').skip(1).step_by(2).collect();
        let list = known.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ");
        let message = format!("there is no {kind} \"{found}\" here; expected one of {list}");
        let error = InputError::at(&span(start, quoted.chars().count()), message);
        return match nearest(found, known) {
            Some(name) => error.with_help(format!("did you mean \"{name}\"?")),
            None => error,
        };
    }
    let start = token_start(read);
    let here = span(&read[..start], read[start..].chars().count());
    if let Some(field) = sentence.strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`')) {
        return InputError::at(&here, format!("the field \"{field}\" is missing"))
            .with_help(format!("add \"{field}\": ... inside the braces that end here"));
    }
    let help = match error.classify() {
        Category::Data => "`wingroot schema` prints what a file of each kind may say",
        _ => {
            "JSON has no comments and no comma behind the last entry; texts and names stand in double quotes"
        }
    };
    InputError::at(&here, format!("not understood as JSON: {sentence}")).with_help(help)
}

/// Where the last word, number or text of what was read begins.
fn token_start(read: &str) -> usize {
    if let Some(before) = read.strip_suffix('"') {
        return before.rfind('"').unwrap_or(before.len());
    }
    let in_word = |c: char| c.is_alphanumeric() || "._+-".contains(c);
    let word = read.trim_end_matches(in_word).len();
    if word < read.len() { word } else { read.char_indices().next_back().map_or(0, |(at, _)| at) }
}
