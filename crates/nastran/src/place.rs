//! Finds where a field or a name stands in a text file, for complaints that come after parsing.

use crate::ron_or_json::is_json;
use crate::source::{InputError, Span};
use crate::text_file::{no_file, read_text};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Where the last of `anchors` stands, each searched for behind the one before, outside comments (`//`) and not
/// inside a longer word: `["total:", "mass_kg:"]` is the first `mass_kg` behind `total`. As far as they are
/// found; the whole file if not even the first is. In JSON, which has no comments, a field's name stands in quotes.
pub fn place_of(anchors: &[&str], text: &str, path: &Path) -> Span {
    let file = Arc::new(path.to_path_buf());
    let mut found = Span::whole_file(path);
    let json = is_json(path);
    let (mut anchors, mut wanted) = (anchors.iter(), None);
    for (index, line) in text.lines().enumerate() {
        let code = if json { line } else { line.split("//").next().unwrap_or(line) };
        let mut from = 0;
        while let Some(anchor) = wanted.or_else(|| anchors.next()) {
            let at = if json { json_word(code, anchor, from) } else { word(code, anchor, from) };
            let Some(start) = at else {
                wanted = Some(anchor);
                break;
            };
            let column = code[..start].chars().count() + 1;
            let width = anchor.trim_end_matches(':').chars().count();
            found = Span::new(&file, index + 1, column, column + width);
            (from, wanted) = (start + anchor.len(), None);
        }
    }
    found
}

/// The first place of `anchor` from byte `from` that is no part of a longer word.
fn word(code: &str, anchor: &str, from: usize) -> Option<usize> {
    let in_word = |start: usize| code[..start].ends_with(|c: char| c.is_alphanumeric() || c == '_');
    code.get(from..)?.match_indices(anchor).map(|(start, _)| from + start).find(|start| !in_word(*start))
}

/// As [`word`]: `name:` is the field `"name"` with its colon.
fn json_word(code: &str, anchor: &str, from: usize) -> Option<usize> {
    let Some(name) = anchor.strip_suffix(':') else { return word(code, anchor, from) };
    let quoted = format!("\"{name}\"");
    let is_field = |at: &usize| code[at + quoted.len()..].trim_start().starts_with(':');
    let found = code.get(from..)?.match_indices(&quoted).map(|(at, _)| from + at).find(is_field)?;
    Some(found + 1)
}

impl InputError {
    /// An error about a field of a RON or JSON file, given as `outer.inner`: at its line, which is looked up in the file.
    pub fn in_field(path: &Path, field: &str, message: impl Into<String>) -> Self {
        let anchors: Vec<String> = field.split('.').map(|name| format!("{name}:")).collect();
        let anchors: Vec<&str> = anchors.iter().map(String::as_str).collect();
        // The file was read before; should it be gone, its name has to do.
        let text = read_text(path).unwrap_or_default();
        Self::at(&place_of(&anchors, &text, path), message)
    }
}

/// The path of a file that another names, relative to the folder of the other.
///
/// # Errors
/// If it is not there: at the line that names it.
pub fn named_file(named_in: &Path, name: &str) -> Result<PathBuf, InputError> {
    let path = named_in.parent().unwrap_or_else(|| Path::new("")).join(name);
    let (fault, help) = match std::fs::metadata(&path).map(|about| no_file(&about)) {
        Ok(None) => return Ok(path),
        Ok(Some((what, help))) => (format!("{} is {what}; expected a file", path.display()), help),
        Err(_) => {
            let fault = format!("the file {} does not exist", path.display());
            (fault, "names of files are relative to the file they stand in")
        }
    };
    let text = read_text(named_in).unwrap_or_default();
    let quoted = format!("\"{name}\"");
    Err(InputError::at(&place_of(&[&quoted], &text, named_in), fault).with_help(help))
}
