//! An effect's name stands in its own file: nothing else asks for an effect by a text, so that adding one touches its file
//! and one list.

use std::collections::BTreeSet;

use super::complaint::Complaint;
use super::parsed::{Source, about, strings};

/// Where names may stand: each effect's file, the benchmark's own effects in both truths, and the table of discover's rules.
const MAY: [&str; 4] =
    ["crates/maneuver/src/effects/library/", "crates/hidden/", "crates/truth/", "crates/discover/src/rules"];
/// Texts that mean something else than the effect of the same name.
const OTHER_MEANING: &[(&str, &str, &str)] = &[];

/// Names of all effects of the library.
pub fn names() -> BTreeSet<&'static str> {
    maneuver::effects::library(&["any".to_owned()]).iter().map(|effect| effect.spec().name).collect()
}

/// Complaints about names outside the places where they may stand; tests may name what they test.
pub fn check(sources: &[Source], names: &BTreeSet<&str>) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    let judged = sources.iter().filter(|source| !source.is_test());
    for source in judged.filter(|source| !MAY.iter().any(|place| source.name.starts_with(place))) {
        for (text, line) in strings(source).iter().filter(|(text, _)| names.contains(text.as_str())) {
            let other = OTHER_MEANING.iter().any(|(file, meant, _)| *file == source.name && meant == text);
            if !other {
                let message = format!(
                    "asks for the effect `{text}` by name: declare what it needs in the effect's file"
                );
                complaints.push(about(&source.name, *line, message));
            }
        }
    }
    complaints
}
