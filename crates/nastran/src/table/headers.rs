//! Which column a header means that is not one of ours: `V [m/s]` is `V_m_s`, and `alpha_rad` would be `alpha_deg` in
//! another unit, which no renaming mends.

use crate::suggest::nearest;

/// Units that headers carry at their end, as letters and digits only; longer ones first where one ends in another.
const UNITS: [&str; 24] = [
    "kms2", "mms2", "ms2", "kmh", "kph", "kts", "fts", "nmm", "knm", "lbfft", "deg", "rad", "mm", "cm", "km",
    "us", "nm", "kn", "hz", "ms", "s", "m", "n", "g",
];

/// Longer headers are no spellings of ours.
const LONGEST: usize = 100;

/// The name among some that was probably meant, and what to heed about its unit (nothing if that is the same).
pub(super) fn meant<'a>(
    name: &str,
    others: impl Iterator<Item = &'a str>,
) -> Option<(&'a str, &'static str)> {
    if name.len() > LONGEST {
        return None;
    }
    let others: Vec<&str> = others.filter(|other| other.len() <= LONGEST).collect();
    if let Some(same) = others.iter().find(|other| letters(other) == letters(name)) {
        return Some((same, ""));
    }
    if let Some(other) = others.iter().find(|other| differs_in_unit(name, other)) {
        return Some((other, " The unit is in the name: convert the column if it has another."));
    }
    nearest(name, others).map(|other| (other, ""))
}

/// Letters and digits in lower case.
fn letters(name: &str) -> String {
    let name = name.replace('°', "deg").replace(['²', '³'], "2").to_lowercase();
    name.chars().filter(|c| c.is_alphanumeric()).collect()
}

/// The same quantity in another unit.
fn differs_in_unit(header: &str, ours: &str) -> bool {
    let (theirs, ours) = (parted(header), parted(ours));
    matches!((theirs, ours), (Some((a, x)), Some((b, y))) if a == b && x != y)
}

/// A name's quantity and unit: behind a bracket, blank, stroke or underscore.
fn parted(name: &str) -> Option<(String, String)> {
    name.char_indices().filter(|(_, c)| !c.is_alphanumeric() && *c != '°').find_map(|(at, _)| {
        let (quantity, unit) = (letters(&name[..at]), letters(&name[at..]));
        (!quantity.is_empty() && UNITS.contains(&unit.as_str())).then_some((quantity, unit))
    })
}
