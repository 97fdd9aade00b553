//! Broken and mixed decks made from users' decks: one fault or a few each, drawn from a seed, so that a deck is made again by its number.

use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::fs;
use std::path::Path;

use nastran::{InputError, read_text};
use wingroot::failure::Failure;

/// Longest deck that is broken, bytes: faults, not sizes, are tried here.
const LONGEST: usize = 400_000;
/// What is written over a field.
const JUNK: [&str; 14] = [
    "1.O",
    "-7",
    "0",
    "99999999",
    "4294967296",
    "1.E999",
    "NAN",
    "",
    "THRU",
    "1.2.3",
    "+",
    "é",
    "=",
    "-1.E-320",
];
/// What a line is turned into or preceded by.
const LINES: [&str; 8] = [
    "+       1       2       3",
    "=(3)",
    "BEGIN SUPER=1",
    "INCLUDE 'nowhere.bdf'",
    "SUBCASE 1",
    "&",
    "GRID,1,1,0.,0.,0.,1",
    "PARAM,WTMASS,0.",
];

/// Writes `count` broken decks made from `names` in `from` into `into`, and gives their names.
///
/// # Errors
/// If a deck cannot be read or written, or none is short enough.
pub(super) fn broken(
    from: &Path,
    names: &[String],
    into: &Path,
    count: usize,
) -> Result<Vec<String>, Failure> {
    let read = |name: &String| {
        let path = from.join(name);
        let text = read_text(&path).ok().filter(|text| text.len() <= LONGEST && text.lines().count() > 3)?;
        Some(with_whole_paths(&text, path.parent().unwrap_or(from)))
    };
    let decks: Vec<String> = names.iter().filter_map(read).collect();
    if decks.is_empty() {
        return Err(InputError::in_file(from, "there is no deck of a size that is broken").into());
    }
    fs::create_dir_all(into).map_err(|error| InputError::in_file(into, error.to_string()))?;
    let mut made = Vec::new();
    for number in 0..count {
        let name = format!("broken_{number:04}.bdf");
        let path = into.join(&name);
        fs::write(&path, one(&decks, number))
            .map_err(|error| InputError::in_file(&path, error.to_string()))?;
        made.push(name);
    }
    Ok(made)
}

/// The text with included files by their whole path, as the broken deck stands elsewhere.
fn with_whole_paths(text: &str, folder: &Path) -> String {
    let folder = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
    let whole = |line: &str| {
        let rest = line.trim_start().get(7..).map(|rest| rest.trim().trim_matches(['\'', '"']));
        match rest.filter(|_| line.trim_start().to_ascii_uppercase().starts_with("INCLUDE")) {
            Some(rest) if !rest.is_empty() => format!("INCLUDE '{}'", folder.join(rest).display()),
            _ => line.to_owned(),
        }
    };
    text.lines().map(whole).collect::<Vec<_>>().join("\n")
}

/// The broken deck of a number.
fn one(decks: &[String], number: usize) -> Vec<u8> {
    let mut random = ChaCha12Rng::seed_from_u64(number as u64);
    let mut draw = |below: usize| random.next_u32() as usize % below.max(1);
    let mut lines: Vec<String> = decks[draw(decks.len())].lines().map(str::to_owned).collect();
    for _ in 0..=draw(3) {
        let at = draw(lines.len());
        match draw(9) {
            0 => _ = lines.remove(at),
            1 => lines.insert(at, lines[at].clone()),
            2 => lines.insert(at, LINES[draw(LINES.len())].to_owned()),
            3 => LINES[draw(LINES.len())].clone_into(&mut lines[at]),
            4 => lines.truncate(at.max(4)),
            5 => {
                // The tail of another deck: numbers meet, references point elsewhere.
                let other: Vec<&str> = decks[draw(decks.len())].lines().collect();
                lines.truncate(at.max(4));
                lines.extend(other[draw(other.len())..].iter().map(|line| (*line).to_owned()));
            }
            6 => {
                let to = draw(lines.len());
                lines.swap(at, to);
            }
            _ => lines[at] = with_junk(&lines[at], draw(9), JUNK[draw(JUNK.len())]),
        }
        if lines.is_empty() {
            lines.push(String::new());
        }
    }
    let mut bytes = lines.join("\n").into_bytes();
    if draw(10) == 0 {
        let at = draw(bytes.len());
        bytes[at] = u8::try_from(draw(256)).unwrap_or(0);
    }
    bytes
}

/// A line with a field overwritten.
fn with_junk(line: &str, field: usize, junk: &str) -> String {
    if line.contains(',') {
        let mut fields: Vec<&str> = line.split(',').collect();
        let at = field % fields.len();
        fields[at] = junk;
        return fields.join(",");
    }
    let letters: Vec<char> =
        line.chars().chain(std::iter::repeat(' ')).take(line.chars().count().max(80)).collect();
    let (start, end) = (8 * field, 8 * field + 8);
    let before: String = letters[..start].iter().collect();
    let after: String = letters[end.min(letters.len())..].iter().collect();
    format!("{before}{junk:<8}{}", after.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_makes_the_same_deck_again_and_another_one_another() {
        let deck =
            "CEND\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID    2               1.      0.      0.\nENDDATA\n"
                .to_owned();
        let made: Vec<Vec<u8>> = (0..40).map(|number| one(std::slice::from_ref(&deck), number)).collect();
        assert_eq!(made[7], one(std::slice::from_ref(&deck), 7));
        let mut different = made.clone();
        different.sort();
        different.dedup();
        assert!(different.len() > 25, "{} different decks of 40", different.len());
    }

    #[test]
    fn a_field_is_overwritten_where_it_stands() {
        assert_eq!(with_junk("GRID,1,,0.,0.", 3, "1.O"), "GRID,1,,1.O,0.");
        assert_eq!(
            with_junk("GRID    2               1.      0.", 1, "-7"),
            "GRID    -7              1.      0."
        );
        assert_eq!(with_whole_paths("GRID,1\ninclude 'a.blk'", Path::new("/")), "GRID,1\nINCLUDE '/a.blk'");
    }
}
