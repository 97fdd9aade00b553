//! A wing's file with another deflection correction or other effects: the given text with them added at its end, comments
//! kept, or (and always in JSON) all of it written anew where the text already has some or names files in other folders.

use super::{DeflectionTable, Source, WingEffect, WingFile};
use nastran::ron_or_json::is_json;
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

/// How an empty list of effects is written.
const EMPTY_EFFECTS: [&str; 2] = ["    effects: [],\n", "    effects: [],\r\n"];

impl WingFile {
    /// What the file of this wing is called where it is written anew: JSON if it was read from JSON.
    pub fn written_name(&self) -> &'static str {
        if is_json(&self.path) { "wing.json" } else { "wing.ron" }
    }

    /// The file of the same wing with these deflection corrections instead of its own. Files it names are to be
    /// copied beside it; a deck, which may include others, is named by its absolute path instead.
    ///
    /// # Errors
    /// If a named file is missing, or the new text does not read back as the same wing.
    pub fn with_deflection(&self, tables: Vec<DeflectionTable>) -> Result<Rewritten, InputError> {
        let field = tables_text(&tables);
        let wanted = Self { deflection: tables, ..self.clone() };
        self.rewritten(wanted, |original| with_field(original, &field)).map_err(|error| {
            let by_hand = "paste the tables of out/deflection/deflection.csv into the file by hand";
            if error.help.is_none() { error.with_help(by_hand) } else { error }
        })
    }

    /// The file of the same wing with these effects instead of its own; files beside it as by [`Self::with_deflection`].
    ///
    /// # Errors
    /// If a named file is missing, or the new text does not read back as the same wing: values that are no numbers.
    pub fn with_effects(&self, effects: Vec<WingEffect>) -> Result<Rewritten, InputError> {
        let field = effects_text(&effects)?;
        let wanted = Self { effects, ..self.clone() };
        let add = |original: &str| {
            // a list that is there and empty makes room
            let code = EMPTY_EFFECTS.iter().fold(original.to_owned(), |text, empty| text.replace(empty, ""));
            with_field(&code, &field)
        };
        self.rewritten(wanted, add)
    }

    /// The file of a wing that was made in memory; what it names is looked for from the folder of its `path`, whose ending says
    /// whether it is JSON.
    ///
    /// # Errors
    /// If a named file is missing, or the wing cannot be written in that form.
    pub fn written(mut self) -> Result<Rewritten, InputError> {
        let beside = self.put_beside()?;
        Ok(Rewritten { text: ron_file::file_text(&self.path, "Wing", &self)?, beside })
    }

    /// Names files as they stand beside a new file, a deck by its absolute path; returns which are to be copied.
    fn put_beside(&mut self) -> Result<Vec<(String, PathBuf)>, InputError> {
        let mut beside = Vec::new();
        let files = self.named_files()?;
        match &mut self.source {
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
        Ok(beside)
    }

    fn rewritten(
        &self,
        mut wanted: Self,
        add: impl Fn(&str) -> Option<String>,
    ) -> Result<Rewritten, InputError> {
        let beside = wanted.put_beside()?;
        let original = nastran::read_text(&self.path)?;
        let name = self.written_name();
        let same = |text: &str| {
            let read: Option<Self> = ron_file::parse(name, text).ok();
            read.is_some_and(|read| {
                Self { path: self.path.clone(), hash: self.hash.clone(), ..read } == wanted
            })
        };
        // What is added to RON keeps comments; JSON has none.
        let added = if is_json(&self.path) { None } else { add(&original) };
        if let Some(text) = added.filter(|text| same(text)) {
            return Ok(Rewritten { text, beside });
        }
        let text = ron_file::file_text(&self.path, "Wing", &wanted)?;
        if same(&text) {
            return Ok(Rewritten { text, beside });
        }
        Err(InputError::in_file(&self.path, "the wing with what was added does not read back the same"))
    }
}

/// The text with a field in front of its last parenthesis.
fn with_field(original: &str, field: &str) -> Option<String> {
    let end = original.rfind(')')?;
    let (head, tail) = original.split_at(end);
    let code = head.trim_end();
    // A comment on the last line would hide a comma behind it, so the comma goes on a line of its own if needed.
    let comma = if code.ends_with(',') { "" } else { "," };
    Some(format!("{code}{comma}\n\n{field}{tail}"))
}

/// The field `effects` as it stands in a file.
fn effects_text(effects: &[WingEffect]) -> Result<String, InputError> {
    let mut text = String::from(
        "    // Effects beyond this model, with the values of their parameters; simulate --without NAME switches one off.\n    \
         effects: [\n",
    );
    for effect in effects {
        let lines: Vec<String> =
            ron_file::to_text(effect)?.lines().map(|line| format!("        {line}")).collect();
        let _ = writeln!(text, "{},", lines.join("\n"));
    }
    text.push_str("    ],\n");
    Ok(text)
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
