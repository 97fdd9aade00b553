//! `selection.csv`: everything that was asked for, with the case that gives it.

use super::Selection;
use crate::cell::cell;
use std::fmt::Write as _;

impl Selection {
    /// A row each end, corner and whatever else was asked for; `covered` says whether its instant is selected.
    pub fn csv(&self) -> String {
        let mut text = String::from("model,policy,what,values,case,instant,covered\n");
        for drive in &self.drives {
            let values: Vec<String> = drive.values.iter().map(|value| format!("{value:.9e}")).collect();
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{}",
                drive.model.name(),
                drive.policy,
                cell(&drive.what),
                values.join(" "),
                drive.case,
                drive.instant,
                if drive.covered { "yes" } else { "no" },
            );
        }
        for (case, because) in &self.never {
            let _ = writeln!(text, ",never,{},,{case},,no", cell(because));
        }
        text
    }
}
