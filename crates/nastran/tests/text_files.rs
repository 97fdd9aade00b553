//! Text files whatever their encoding, and what is no text file.

use nastran::{InputError, read_text};
#[cfg(unix)]
use std::path::Path;

/// Reads bytes as the text of a file, which is gone afterwards.
fn read_bytes(name: &str, bytes: &[u8]) -> Result<String, InputError> {
    let path = std::env::temp_dir().join(format!("wingroot-{}-{name}", std::process::id()));
    std::fs::write(&path, bytes).expect("a temporary file");
    let text = read_text(&path);
    std::fs::remove_file(&path).expect("the temporary file");
    text
}

fn in_units(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    std::iter::once(0xFEFF).chain(text.encode_utf16()).flat_map(bytes).collect()
}

#[test]
fn utf_16_is_read_in_both_byte_orders() {
    for bytes in [u16::to_le_bytes as fn(u16) -> [u8; 2], u16::to_be_bytes] {
        let mut written = in_units("α;1,5\r\n𝄞", bytes);
        assert_eq!(read_bytes("utf-16.csv", &written).unwrap(), "α;1,5\r\n𝄞");
        written.push(0);
        assert_eq!(read_bytes("utf-16.csv", &written).unwrap_err().span.unwrap().line, 2);
    }
}

#[test]
fn letters_of_an_older_encoding_are_refused_with_their_place() {
    let error = read_bytes("latin-1.csv", b"a\nFl\xFCgel\n").unwrap_err();
    assert!(error.message.contains("byte 0xFC is not UTF-8"), "{error}");
    assert_eq!(error.span.unwrap().line, 2);
}

#[cfg(unix)]
#[test]
fn devices_and_folders_are_refused_by_name_and_not_read() {
    let said = |path: &str| read_text(Path::new(path)).unwrap_err().to_string();
    assert!(said("/dev/zero").starts_with("/dev/zero: this is a device or a pipe"));
    assert!(said("/").starts_with("/: this is a folder"));
    assert!(said("/dev/null/x").contains("part of its path is no folder"));
}
