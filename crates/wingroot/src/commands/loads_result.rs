//! What `result.json` of `loads` holds.

use fullaircraft::CasesFile;
use fullaircraft::cases::envelope::Extreme;
use loads::matrix::Status;
use loads::select::Selected;
use loads::{Matrix, Selection};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use crate::args::Common;
use crate::commands::loads_gusts::{self as gusts, WorstGust};
use crate::commands::loads_turbulence::{self as turbulence, TurbulenceRow};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::show;

/// See the module.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub(crate) struct LoadsResult {
    /// Name of the command.
    command: &'static str,
    /// Name of the plan.
    name: String,
    /// How many cases the matrix has.
    pub(crate) cases: usize,
    /// How many of them were flown with both models.
    pub(crate) flown: usize,
    /// How many were left out; cases.csv says why.
    left_out: usize,
    /// Cases that could not be flown.
    pub(crate) failed: Vec<Failed>,
    /// Smallest and largest net loads.
    pub(crate) envelope: Vec<Extreme>,
    /// Where the wings are from whose envelopes the intervals are of; left out without them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) intervals_from: Option<String>,
    /// Worst discrete gusts of both wings' roots; on a deck, of each station.
    pub(crate) gusts: Vec<WorstGust>,
    /// Loads in continuous turbulence.
    pub(crate) turbulence: Vec<TurbulenceRow>,
    /// What goes to stress.
    pub(crate) selected: Vec<SelectedCase>,
    /// The largest differences between solver and cards read back.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) round_trip: Option<RoundTripResult>,
    /// The folder of the package.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) package: Option<String>,
}

/// A case that could not be flown.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Failed {
    /// Its number.
    pub(crate) case: usize,
    /// Which model.
    pub(crate) model: String,
    /// Why.
    pub(crate) why: String,
}

/// An instant that goes to stress.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SelectedCase {
    /// Load set and subcase.
    sid: u32,
    /// Which model.
    model: &'static str,
    /// Number of the case.
    case: usize,
    /// Number within the case, from one.
    instant: usize,
    /// What asked for it.
    why: Vec<String>,
    /// How many ends and corners it drives.
    driven: usize,
}

impl From<&Selected> for SelectedCase {
    fn from(selected: &Selected) -> Self {
        let Selected { sid, model, case, instant, driven, why } = selected.clone();
        Self { sid, model: model.name(), case, instant, why, driven }
    }
}

/// Largest differences as shares of the largest of each kind.
#[derive(Debug, Clone, Copy, Default, Serialize, JsonSchema)]
pub(crate) struct RoundTripResult {
    /// Loads at stations.
    pub(crate) stations: f64,
    /// The whole aircraft, over the sum of sizes.
    pub(crate) balance: f64,
    /// Height of the tips, over what each load does to them.
    pub(crate) tip: f64,
    /// Coefficients of stiffness of the structure that was read, over the geometric mean of their diagonals.
    pub(crate) structure: f64,
    /// Height of the tips as trims have them beside that of their loads on the structure, over the same: how exactly the structure is solved.
    pub(crate) trim_tip: f64,
    /// Sums of nodal loads at stations, of selected cases flown again, beside the first flight's loads there.
    pub(crate) repeat: f64,
}

impl LoadsResult {
    /// What the matrix says.
    pub(crate) fn of(plan: &CasesFile, matrix: &Matrix) -> Self {
        let count = |status| matrix.cases.iter().filter(|case| case.status == status).count();
        Self {
            command: "loads",
            name: plan.name.clone(),
            cases: matrix.cases.len(),
            flown: count(Status::Flown),
            left_out: count(Status::LeftOut),
            ..Self::default()
        }
    }

    /// A selection among the loads of another result.
    pub(crate) fn selected_from(from: &str, selection: &Selection) -> Self {
        let selected = selection.selected.iter().map(Into::into).collect();
        Self { command: "loads", name: format!("selection from {from}"), selected, ..Self::default() }
    }

    /// The matrix in a line.
    fn matrix_line(&self) -> String {
        format!("matrix       {} cases, {} left out (cases.csv says why)\n", self.cases, self.left_out)
    }

    /// Ends a command that was asked for the matrix alone.
    ///
    /// # Errors
    /// If the results cannot be written or shown.
    pub(crate) fn end_with_matrix(&self, folder: ResultFolder, common: &Common) -> Result<(), Failure> {
        folder.write_json("result.json", self)?;
        let out = folder.commit()?;
        show::summary(common, &format!("{}results in {}\n", self.matrix_line(), out.display()));
        show::json(common, self)
    }

    /// Shows what was flown, and the package in a line.
    ///
    /// # Errors
    /// If it cannot be shown, or no case could be flown.
    pub(crate) fn end(
        &self,
        packed: &str,
        start: Instant,
        target: &Path,
        common: &Common,
    ) -> Result<(), Failure> {
        let (seconds, text) = (start.elapsed().as_secs_f64(), self.text());
        show::summary(common, &format!("{text}{packed}{seconds:.1} s\nresults in {}\n", target.display()));
        show::json(common, self)?;
        if self.flown == 0 {
            return Err(Failure::Computation("none of the cases can be flown".into()));
        }
        Ok(())
    }

    /// All in a few lines.
    pub(crate) fn text(&self) -> String {
        // Writing to a String cannot fail.
        let mut text = String::new();
        if self.cases > 0 {
            text += &self.matrix_line();
            let _ = writeln!(
                text,
                "flown        {} cases, {} failures; initial and updated",
                self.flown,
                self.failed.len()
            );
        }
        if let Some(first) = self.failed.first() {
            let _ = writeln!(
                text,
                "failed       case {} ({}): {}; cases.csv has all",
                first.case, first.model, first.why
            );
        }
        if let Some(from) = &self.intervals_from {
            let _ = writeln!(text, "envelope     90 % intervals: {from}");
        }
        text += &gusts::line(&self.gusts).unwrap_or_default();
        text += &turbulence::line(&self.turbulence).unwrap_or_default();
        let cases: std::collections::BTreeSet<usize> = self.selected.iter().map(|one| one.case).collect();
        let _ = writeln!(text, "selected     {} instants of {} cases", self.selected.len(), cases.len());
        if let Some(RoundTripResult { stations, balance, tip, structure, trim_tip, repeat }) = self.round_trip
        {
            let _ = writeln!(
                text,
                "round trip   stations {stations:.1e}, whole aircraft {balance:.1e} of the load, tip {tip:.1e}, structure {structure:.1e}: reproduced (tips of trims {trim_tip:.1e}, flown again {repeat:.1e})"
            );
        }
        text
    }
}
