//! What the user sees: errors with their source line on standard error, summaries on standard output.
//!
//! ```text
//! error: wing.ron:3:5: expected a number, found "five"
//!   ┌─ wing.ron:3:5
//!   │
//! 3 │     chord_m: "five",
//!   │              ^^^^^^ expected a number, found "five"
//!   │
//! hint: write 0.5
//! ```

use std::io::Write;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use anstyle::{AnsiColor, Effects, Style};
use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::SimpleFile;
use codespan_reporting::term::termcolor::Buffer;
use codespan_reporting::term::{self, Config};
use nastran::{InputError, Span};
use serde::Serialize;
use tracing::Level;
use tracing_subscriber::Layer as _;
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;

use crate::common::Common;
use crate::failure::Failure;
use crate::{progress, said};

const RED: Style = AnsiColor::Red.on_default().effects(Effects::BOLD);
const BOLD: Style = Style::new().bold();

/// Whether remarks are left out.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Sends the crates' events to standard error (warnings, or what `RUST_LOG` asks for), and remarks unless `--quiet`.
pub fn start(common: &Common) {
    QUIET.store(common.quiet, Ordering::Relaxed);
    let default = Targets::new().with_default(if common.quiet { Level::ERROR } else { Level::WARN });
    let asked: Option<Targets> = std::env::var("RUST_LOG").ok().and_then(|asked| asked.parse().ok());
    let asked = asked.unwrap_or(default).with_target(progress::TARGET, LevelFilter::OFF);
    let lines = tracing_subscriber::fmt::layer().with_writer(progress::Aside::default);
    let lines = lines.with_target(false).without_time().with_ansi(true).with_filter(asked);
    let bars = progress::Bars.with_filter(Targets::new().with_target(progress::TARGET, Level::TRACE));
    let subscriber = tracing_subscriber::registry().with(lines).with(bars);
    // A second subscriber (tests) is refused, and the first one stays: nothing to do.
    let _ = subscriber.try_init();
}

/// Prints a failure to standard error.
pub fn failure(failure: &Failure) {
    let text = match failure {
        Failure::Input(error) => explained(error),
        Failure::Computation(message) => format!("{RED}error{RED:#}: {message}\n").into_bytes(),
    };
    // If standard error is closed there is nobody left to tell.
    let _ = progress::aside(|| anstream::stderr().write_all(&text));
}

/// Prints a remark to standard error, unless `--quiet`.
pub fn note(text: &str) {
    if QUIET.load(Ordering::Relaxed) || said::kept(|said| said.notes.push(text.to_owned())) {
        return;
    }
    // If standard error is closed there is nobody left to tell.
    let _ = progress::aside(|| writeln!(anstream::stderr(), "{BOLD}note{BOLD:#}: {text}"));
}

/// Prints a summary for people: to standard output, or to standard error if that carries JSON.
pub fn summary(common: &Common, text: &str) {
    let text = text.trim_end();
    if common.quiet || said::kept(|said| text.clone_into(&mut said.summary)) {
        return;
    }
    // A reader that closed the pipe (`| head`) has seen enough.
    let _ = progress::aside(|| {
        if common.json {
            writeln!(std::io::stderr(), "{text}")
        } else {
            writeln!(std::io::stdout(), "{text}")
        }
    });
}

/// With `--json`: prints the result, and nothing else, to standard output.
///
/// # Errors
/// If the value cannot be written as JSON, or not to standard output.
pub fn json<T: Serialize>(common: &Common, value: &T) -> Result<(), Failure> {
    if !common.json {
        return Ok(());
    }
    text(&(serde_json::to_string_pretty(value).map_err(Failure::computation)? + "\n"))
}

/// Prints what was asked for to standard output.
///
/// # Errors
/// If it cannot be written there.
pub fn text(text: &str) -> Result<(), Failure> {
    let written = progress::aside(|| {
        let mut out = std::io::stdout();
        out.write_all(text.as_bytes()).and_then(|()| out.flush())
    });
    match written {
        // A reader that closed the pipe (`| head`) has seen enough; a full disk has not.
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            let message = format!("standard output cannot be written: {error}");
            Err(InputError::general(message)
                .with_help("make room where it goes, or send it elsewhere")
                .into())
        }
        _ => Ok(()),
    }
}

/// The error as text: `file:line:column: message`, the source line with a caret, the hint; in colours, which the stream takes
/// out where nobody sees them.
fn explained(error: &InputError) -> Vec<u8> {
    let place = error.span.as_ref().map(|span| format!("{span}: ")).unwrap_or_default();
    let mut text = format!("{RED}error{RED:#}: {place}{}\n", error.message).into_bytes();
    if let Some(snippet) = error.span.as_ref().and_then(snippet) {
        text.extend(snippet);
    }
    if let Some(help) = &error.help {
        text.extend(format!("{BOLD}hint{BOLD:#}: {help}\n").into_bytes());
    }
    text
}

/// The most characters of a source line that are shown.
const WIDEST: usize = 160;

/// The source line with the place underlined; none if the place is no line of a readable file.
fn snippet(span: &Span) -> Option<Vec<u8>> {
    let (source, range) = excerpt(&nastran::read_text(span.file.as_path()).ok()?, span)?;
    let file = SimpleFile::new(span.file.display().to_string(), source);
    let diagnostic: Diagnostic<()> = Diagnostic::error().with_labels(vec![Label::primary((), range)]);
    let mut buffer = Buffer::ansi();
    term::emit_to_write_style(&mut buffer, &Config::default(), &file, &diagnostic).ok()?;
    // The first line only says "error", which stands above already.
    let bytes = buffer.into_inner();
    let head = bytes.iter().position(|b| *b == b'\n')? + 1;
    let end = bytes.iter().rposition(|b| !b.is_ascii_whitespace())? + 1;
    let mut kept = bytes.get(head..end)?.to_vec();
    kept.push(b'\n');
    Some(kept)
}

/// The line of the place under its number, cut to [`WIDEST`] characters about the place, and the bytes of the place in it;
/// columns count characters from one, and a column of zero is the whole line.
fn excerpt(source: &str, span: &Span) -> Option<(String, Range<usize>)> {
    let before = span.line.checked_sub(1)?;
    let line: Vec<char> = source.lines().nth(before)?.chars().collect();
    let whole = span.column == 0;
    let from = if whole { 0 } else { (span.column - 1).min(line.len()) };
    let to = if whole { line.len() } else { (span.end_column - 1).clamp(from, line.len()) };
    let first = if line.len() <= WIDEST { 0 } else { from.saturating_sub(WIDEST / 4) };
    let last = line.len().min(first + WIDEST);
    let part = |range: Range<usize>| line[range].iter().collect::<String>();
    let mut text = "\n".repeat(before) + if first > 0 { "..." } else { "" };
    let start = text.len() + part(first..from).len();
    let end = start + part(from..to.min(last)).len();
    text += &part(first..last);
    text += if last < line.len() { "...\n" } else { "\n" };
    Some((text, start..end))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;

    /// The text as it stands in a file.
    fn plain(error: &InputError) -> Vec<u8> {
        anstream::adapter::strip_bytes(&explained(error)).into_vec()
    }

    #[test]
    fn the_place_is_shown_with_its_line_a_caret_and_the_hint() {
        let folder = std::env::temp_dir().join(format!("wingroot-show-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("wing.ron");
        std::fs::write(&path, "Wing(\n    naïve: 1, chord_m: \"five\",\n)\n").unwrap();
        let file = Arc::new(path.clone());
        let error = InputError::at(&Span::new(&file, 2, 24, 30), "expected a number, found \"five\"");
        let text = String::from_utf8(plain(&error.with_help("write 0.5"))).unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], format!("error: {}:2:24: expected a number, found \"five\"", path.display()));
        let source = lines.iter().position(|l| l.contains("naïve")).unwrap();
        assert_eq!(
            lines[source].find('"').map(|_| column(lines[source], '"')),
            Some(column(lines[source + 1], '^'))
        );
        assert!(lines[source + 1].ends_with("^^^^^^"), "{text}");
        assert_eq!(lines.last(), Some(&"hint: write 0.5"));
    }

    fn column(line: &str, wanted: char) -> usize {
        line.chars().position(|c| c == wanted).unwrap()
    }

    #[test]
    fn a_place_that_is_no_line_of_a_file_still_gives_the_message() {
        let error = InputError::in_file(std::path::Path::new("no/such.ron"), "the file does not exist");
        assert_eq!(plain(&error), b"error: no/such.ron: the file does not exist\n");
        let span = Span { line: 99, ..Span::generated("x") };
        assert_eq!(excerpt("one line", &span), None);
    }

    #[test]
    fn of_a_long_line_the_place_is_shown() {
        let line = format!("{}ä!ö{}", "é".repeat(1000), "x".repeat(200_000));
        let span = Span { line: 2, column: 1002, end_column: 1003, ..Span::generated("a.csv") };
        let (text, range) = excerpt(&format!("\r\n{line}\r\n"), &span).unwrap();
        assert_eq!((&text[range], text.chars().count()), ("!", 1 + 3 + WIDEST + 3 + 1));
        assert!(text.starts_with("\n...é") && text.ends_with("xx...\n"), "{text}");
        let whole = Span { column: 0, end_column: 0, ..span };
        let (text, range) = excerpt(&format!("\r\n{line}"), &whole).unwrap();
        assert_eq!(text[range].chars().count(), WIDEST);
    }
}
