//! Finds the line and column in a wing file that a complaint about a field or a name belongs to.

use nastran::Span;
use std::path::Path;
use std::sync::Arc;

/// The first place of `anchor` outside comments and not inside a longer word; the whole file if it is nowhere.
pub(super) fn of(anchor: &str, text: &str, path: &Path) -> Span {
    let file = Arc::new(path.to_path_buf());
    for (index, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap_or(line);
        for (start, _) in code.match_indices(anchor) {
            let in_word = code[..start].ends_with(|before: char| before.is_alphanumeric() || before == '_');
            if !in_word {
                let column = code[..start].chars().count() + 1;
                return Span::new(
                    &file,
                    index + 1,
                    column,
                    column + anchor.trim_end_matches(':').chars().count(),
                );
            }
        }
    }
    Span::whole_file(path)
}
