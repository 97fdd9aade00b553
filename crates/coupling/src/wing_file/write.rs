//! A wing's file with another deflection correction: the given text with the tables added at its end, comments kept,
//! or all of it written anew where the text already has tables or names files in other folders.

use super::{DeflectionTable, Source, WingFile};
use nastran::{InputError, ron_file};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A wing's file to write, with the files it names.
#[derive(Debug, Clone, PartialEq)]
pub struct Rewritten {
    /// The text of the file.
    pub text: String,
    /// Files that must stand beside it: name there, and where each is now.
    pub beside: Vec<(String, PathBuf)>,
}

impl WingFile {
    /// The file of the same wing with these deflection corrections instead of its own. Files it names are to be
    /// copied beside it; a deck, which may include others, is named by its absolute path instead.
    ///
    /// # Errors
    /// If a named file is missing, or the new text does not read back as the same wing.
    pub fn with_deflection(&self, tables: Vec<DeflectionTable>) -> Result<Rewritten, InputError> {
        let mut wanted = Self { deflection: tables, ..self.clone() };
        let mut beside = Vec::new();
        let files = self.named_files()?;
        match &mut wanted.source {
            Source::Deck(deck) => {
                let path = std::path::absolute(&files[0]).unwrap_or_else(|_| files[0].clone());
                deck.file = path.to_string_lossy().into_owned();
            }
            Source::Parametric(planform) => {
                let distribution =
                    planform.structure.as_mut().and_then(|structure| structure.distribution_mut());
                for (name, from) in planform.airfoil.iter_mut().chain(distribution).zip(files) {
                    if let Some(plain) = Path::new(name.as_str()).file_name() {
                        *name = plain.to_string_lossy().into_owned();
                    }
                    beside.push((name.clone(), from));
                }
            }
        }
        let original = nastran::read_text(&self.path)?;
        let same = |text: &str| {
            let read: Option<Self> = ron_file::parse("wing.ron", text).ok();
            read.is_some_and(|read| {
                Self { path: self.path.clone(), hash: self.hash.clone(), ..read } == wanted
            })
        };
        if let Some(text) = with_tables(&original, &wanted.deflection).filter(|text| same(text)) {
            return Ok(Rewritten { text, beside });
        }
        let text = format!("Wing{}\n", ron_file::to_text(&wanted)?);
        if same(&text) {
            return Ok(Rewritten { text, beside });
        }
        Err(InputError::in_file(
            &self.path,
            "the wing with its deflection correction does not read back the same",
        )
        .with_help("paste the tables of out/deflection/deflection.csv into the file by hand"))
    }
}

/// The text with the tables in front of its last parenthesis.
fn with_tables(original: &str, tables: &[DeflectionTable]) -> Option<String> {
    let end = original.rfind(')')?;
    let (head, tail) = original.split_at(end);
    let code = head.trim_end();
    // A comment on the last line would hide a comma behind it, so the comma goes on a line of its own if needed.
    let comma = if code.ends_with(',') { "" } else { "," };
    Some(format!("{code}{comma}\n\n{}{tail}", tables_text(tables)))
}

/// The field `deflection` as it stands in a file.
fn tables_text(tables: &[DeflectionTable]) -> String {
    let list =
        |values: &[f64]| values.iter().map(|value| format!("{value:?}")).collect::<Vec<_>>().join(", ");
    let mut text = String::from(
        "    // Deflection correction (Eq. 10): the deflection that acts, by commanded deflection and airspeed. The factor\n    \
         // equivalent/commanded is linear between; below the smallest and above the largest deflection it is kept.\n    \
         deflection: [\n",
    );
    for table in tables {
        let _ = writeln!(
            text,
            "        (control: {:?}, odd: {:?}, outside: {:?}, rows: [",
            table.control, table.odd, table.outside
        );
        for row in &table.rows {
            let _ = write!(
                text,
                "            (V_m_s: {:?}, commanded_deg: [{}], ",
                row.v_m_s,
                list(&row.commanded_deg)
            );
            if let Some(values) = &row.equivalent_deg {
                let _ = write!(text, "equivalent_deg: [{}]", list(values));
            }
            if let Some(values) = &row.factor {
                let _ = write!(text, "factor: [{}]", list(values));
            }
            text.push_str("),\n");
        }
        text.push_str("        ]),\n");
    }
    text.push_str("    ],\n");
    text
}
