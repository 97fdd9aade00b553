//! What several tests of decks need.

use nastran::BulkData;

/// A deck's content as text, without the places, which differ between a file and its copy.
pub(crate) fn content(deck: &BulkData) -> String {
    let debug = format!("{deck:#?}");
    let mut kept = String::new();
    let mut depth = 0;
    for line in debug.lines() {
        if depth == 0 && line.trim_end().ends_with("Span {") {
            depth = 1;
        } else if depth > 0 {
            depth += line.matches(['{', '(', '[']).count();
            depth -= line.matches(['}', ')', ']']).count();
        } else {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}
