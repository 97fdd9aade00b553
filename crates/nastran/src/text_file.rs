//! Text files: read whole, whatever their encoding, and never more than the machine can hold.
//!
//! UTF-8 and plain ASCII; UTF-16 in both byte orders with a mark at its start. A byte order mark is dropped. Only files are
//! read: a folder, a device or a pipe is refused by name, as it may never end and cannot be read again.

use crate::memory;
use crate::source::{InputError, Span};
use std::fs::{File, Metadata};
use std::io::{ErrorKind, Read};
use std::path::Path;
use std::sync::Arc;

/// The largest file that is read, bytes.
pub const LARGEST_FILE: u64 = 2_000_000_000;
/// What a file takes in memory for each byte of it: its bytes, its text, and the cards or cells made of them.
const MEMORY_A_BYTE: f64 = 4.0;

/// Reads a text file, or says which file could not be read and why.
///
/// # Errors
/// If it is missing, no file, unreadable, larger than [`LARGEST_FILE`] or the memory, or no text; the latter with the line.
pub fn read_text(path: &Path) -> Result<String, InputError> {
    let bytes = read_bytes(path)?;
    decode(path, bytes)
}

/// As [`read_text`], of a deck: its comments and titles (what follows `$` or `=` in a line) may be in an older encoding with a byte a letter,
/// which says nothing to Nastran.
///
/// # Errors
/// As [`read_text`], but for letters that are not UTF-8.
pub(crate) fn read_deck_text(path: &Path) -> Result<String, InputError> {
    let bytes = read_bytes(path)?;
    let is_utf_16 = bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]);
    let says_nothing = |line: &[u8]| {
        let words = line.iter().position(|byte| [b'$', b'='].contains(byte)).unwrap_or(line.len());
        line[..words].is_ascii()
    };
    if is_utf_16
        || std::str::from_utf8(&bytes).is_ok()
        || !bytes.split(|byte| *byte == b'\n').all(says_nothing)
    {
        return decode(path, bytes);
    }
    decode(path, bytes.into_iter().map(char::from).collect::<String>().into_bytes())
}

fn read_bytes(path: &Path) -> Result<Vec<u8>, InputError> {
    let about = std::fs::metadata(path).map_err(|error| unreadable(path, &error))?;
    if let Some((what, help)) = no_file(&about) {
        return Err(
            InputError::in_file(path, format!("this is {what}; expected a text file")).with_help(help)
        );
    }
    let too_large = |message: String| {
        InputError::in_file(path, message)
            .with_help("is this the right file? keep what is needed of it, or split it")
    };
    let most =
        format!("the file has more than {}, the most that is read", memory::words(LARGEST_FILE as f64));
    if about.len() > LARGEST_FILE {
        return Err(too_large(most));
    }
    memory::demand("this file and what is made of it", MEMORY_A_BYTE * about.len() as f64)
        .map_err(|error| too_large(error.message))?;
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| unreadable(path, &error))?;
    // A file may grow while it is read, and some of the system's have no size.
    file.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(|error| unreadable(path, &error))?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(too_large(most));
    }
    Ok(bytes)
}

/// What something is that is no file, and what to do; none for a file.
pub(crate) fn no_file(about: &Metadata) -> Option<(&'static str, &'static str)> {
    if about.is_file() {
        None
    } else if about.is_dir() {
        Some(("a folder", "name the file in it"))
    } else {
        Some(("a device or a pipe", "save what it gives as a file, and name that"))
    }
}

fn unreadable(path: &Path, error: &std::io::Error) -> InputError {
    match error.kind() {
        ErrorKind::NotFound => InputError::in_file(path, "the file does not exist")
            .with_help("check the path; relative paths start from the folder the command runs in"),
        ErrorKind::NotADirectory => {
            InputError::in_file(path, "the file does not exist: part of its path is no folder")
                .with_help("check the path; relative paths start from the folder the command runs in")
        }
        _ => InputError::in_file(path, format!("the file cannot be read: {error}"))
            .with_help("it must be a text file that you may read"),
    }
}

/// The text of a file's bytes.
fn decode(path: &Path, bytes: Vec<u8>) -> Result<String, InputError> {
    let text = match bytes.get(..2) {
        Some([0xFF, 0xFE]) => decode_utf16(path, &bytes[2..], u16::from_le_bytes)?,
        Some([0xFE, 0xFF]) => decode_utf16(path, &bytes[2..], u16::from_be_bytes)?,
        _ => decode_utf8(path, bytes)?,
    };
    if let Some(at) = text.find('\0') {
        let line = text[..at].matches('\n').count() + 1;
        let place = Span::new(&Arc::new(path.to_path_buf()), line, 0, 0);
        return Err(InputError::at(&place, "the file has zero bytes, so it is no text file")
            .with_help("UTF-16 without a mark at its start is a usual cause; save it again as UTF-8"));
    }
    Ok(text.strip_prefix('\u{FEFF}').map(str::to_owned).unwrap_or(text))
}

fn decode_utf8(path: &Path, bytes: Vec<u8>) -> Result<String, InputError> {
    String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let before = String::from_utf8_lossy(&error.as_bytes()[..good]).into_owned();
        let message = format!("byte {:#04X} is not UTF-8", error.as_bytes()[good]);
        InputError::at(&end_of(path, &before), message).with_help(
            "save the file as UTF-8; letters such as umlauts in an older encoding are the usual cause",
        )
    })
}

fn decode_utf16(path: &Path, bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, InputError> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let mut text = String::with_capacity(bytes.len());
    for decoded in char::decode_utf16(pairs.iter().map(|pair| unit(*pair))) {
        match decoded {
            Ok(character) => text.push(character),
            Err(_) => return Err(broken_utf16(path, &text)),
        }
    }
    if rest.is_empty() { Ok(text) } else { Err(broken_utf16(path, &text)) }
}

fn broken_utf16(path: &Path, before: &str) -> InputError {
    InputError::at(&end_of(path, before), "the file begins as UTF-16, and this is none")
        .with_help("save it again as UTF-8")
}

/// The place behind the text that was read so far.
fn end_of(path: &Path, before: &str) -> Span {
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
    Span::new(&Arc::new(path.to_path_buf()), line, column, column + 1)
}
