//! The name somebody probably meant: the nearest by edit distance (Levenshtein 1965), case ignored.

/// The candidate nearest to `name`, if it is near enough to be a slip of the pen: about a third of the letters
/// may differ, one of two and none of one.
///
/// A word that one candidate begins with (`rho` of `rho_kg_m3`) is meant to be that; very long ones are no slips.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = name.chars().count();
    if length > LONGEST {
        return None;
    }
    let candidates: Vec<&str> = candidates.into_iter().collect();
    let near = candidates
        .iter()
        .map(|candidate| (distance(name, candidate), *candidate))
        .filter(|(distance, _)| *distance <= (length + 1) / 3)
        .min_by_key(|(distance, _)| *distance);
    let begins = |candidate: &&&str| {
        length >= 3 && candidate.to_lowercase().starts_with(&format!("{}_", name.to_lowercase()))
    };
    let mut longer = candidates.iter().filter(begins);
    match (near, longer.next(), longer.next()) {
        (Some((_, candidate)), ..) => Some(candidate),
        (None, Some(candidate), None) => Some(candidate),
        _ => None,
    }
}

/// Longer words are not compared.
const LONGEST: usize = 100;

/// The number of letters to insert, delete or replace to turn one word into the other, case ignored.
pub fn distance(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.to_lowercase().chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (i, a) in one.to_lowercase().chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, b) in other.iter().enumerate() {
            let replaced = diagonal + usize::from(a != *b);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[other.len()]
}
