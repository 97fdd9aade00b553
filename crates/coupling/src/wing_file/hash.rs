//! The fingerprint of a wing: FNV-1a with 64 bits (Fowler, Noll and Vo; offset basis and prime as published).
//!
//! It tells versions of a file apart, no more: it is no protection against intent. Line ends are unified, so a
//! checkout on another platform keeps the fingerprint.

use nastran::InputError;
use std::path::{Path, PathBuf};

const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;
/// How deep decks may include one another.
const DEEPEST_INCLUDE: usize = 20;

/// The hash of `text` and of all `files` with the decks they include, as 16 hexadecimal digits.
pub(super) fn of_files(text: &str, files: &[PathBuf]) -> Result<String, InputError> {
    let mut hash = extend(OFFSET_BASIS, text);
    for file in files {
        hash = extend_by_file(hash, file, 0)?;
    }
    Ok(format!("{hash:016x}"))
}

/// The hash of one text, as 16 hexadecimal digits.
pub fn of_text(text: &str) -> String {
    format!("{:016x}", extend(OFFSET_BASIS, text))
}

fn extend(hash: u64, text: &str) -> u64 {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(PRIME);
    let hash = text.bytes().filter(|&byte| byte != b'\r').fold(hash, step);
    // A byte no text contains keeps the border between two files.
    step(hash, 0xff)
}

fn extend_by_file(hash: u64, file: &Path, depth: usize) -> Result<u64, InputError> {
    let text = nastran::read_text(file)?;
    let mut hash = extend(hash, &text);
    if depth == DEEPEST_INCLUDE {
        return Ok(hash);
    }
    for line in text.lines().map(str::trim) {
        let keyword = line.get(..7).is_some_and(|word| word.eq_ignore_ascii_case("INCLUDE"));
        if let Some(name) = line.get(7..).filter(|_| keyword) {
            let name = name.trim().trim_matches(['\'', '"']);
            let folder = file.parent().unwrap_or_else(|| Path::new(""));
            hash = extend_by_file(hash, &folder.join(name), depth + 1)?;
        }
    }
    Ok(hash)
}

#[cfg(test)]
mod tests {
    use super::{OFFSET_BASIS, PRIME, extend};

    #[test]
    fn the_hash_of_a_known_text_is_the_published_one() {
        // FNV-1a 64 of "foobar", from the authors' table of test vectors, without our border byte.
        let bordered = extend(OFFSET_BASIS, "foo\rbar");
        assert_eq!(bordered, (0x8594_4171_f739_67e8_u64 ^ 0xff).wrapping_mul(PRIME));
    }
}
