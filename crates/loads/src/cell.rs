//! Cells of CSV files that we write.

/// A text as a cell: quoted where it must be.
pub(crate) fn cell(text: &str) -> String {
    if text.contains([',', '"', ';', '\t', '\n', '\r']) || text.starts_with('#') {
        let line = text.replace(['\n', '\r'], " ");
        format!("\"{}\"", line.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
