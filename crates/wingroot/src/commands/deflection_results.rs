//! What `deflection` found as JSON, as CSV and as a table for people.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use calibrate::campaign::Use;
use coupling::ByLoad;
use coupling::wing_file::DeflectionTable;
use discover::result::BeforeAfter;
use maneuver::Run;
use maneuver::deflection_fit::{DoubletFit, FittedFactor, gap};

use crate::commands::deflection_result::{
    DeflectionResult, FactorResult, FittedDoublet, HeldOut, HeldOutGap, JudgedResult,
};
use crate::corrections::CorrectedWing;

/// A doublet of the campaign.
pub(crate) struct Measured {
    /// Its file.
    pub(crate) file: PathBuf,
    /// What was measured.
    pub(crate) run: Run,
    /// To fit or to judge.
    pub(crate) usage: Use,
    /// Which of the models flies it.
    pub(crate) model: usize,
}

/// A held-out doublet: root mean square residuals of Fz, Mx, My with deflections as commanded, and corrected.
pub(crate) struct Judged {
    /// Name of the run.
    pub(crate) name: String,
    /// Its length.
    pub(crate) samples: usize,
    /// Of the loads.
    pub(crate) loads: [ByLoad<f64>; 2],
    /// Of their changes, without the mean: no part of the trim.
    pub(crate) changes: [ByLoad<f64>; 2],
}

/// What was found.
pub(crate) struct Found<'a> {
    /// The wing and its corrections.
    pub(crate) corrected: &'a CorrectedWing,
    /// Training doublets with their fits.
    pub(crate) fits: Vec<(&'a Measured, DoubletFit)>,
    /// Repeats pooled.
    pub(crate) factors: Vec<FittedFactor>,
    /// Tables for the wing's file.
    pub(crate) tables: Vec<DeflectionTable>,
    /// Held-out doublets.
    pub(crate) judged: Vec<Judged>,
    /// Declared noise of a sample.
    pub(crate) sigma: Option<ByLoad<f64>>,
    /// Gap that the noise alone leaves.
    pub(crate) noise_gap: f64,
    /// What the user should know.
    pub(crate) remarks: Vec<String>,
}

impl Found<'_> {
    /// Gaps of the held-out doublets before and after, of the loads or of their changes; none without declared noise
    /// or held-out runs.
    pub(crate) fn gaps(&self, of: impl Fn(&Judged) -> [ByLoad<f64>; 2]) -> Option<[f64; 2]> {
        let sigma = self.sigma.filter(|_| !self.judged.is_empty())?;
        let at = |state: usize| {
            gap(&self.judged.iter().map(|run| (run.samples, of(run)[state])).collect::<Vec<_>>(), sigma)
        };
        Some([at(0), at(1)])
    }
}

/// `result.json`.
pub(crate) fn result(found: &Found<'_>, seconds: f64) -> DeflectionResult {
    let factor = |fitted: &FittedFactor| FactorResult {
        control: fitted.control.clone(),
        v_m_s: fitted.v_m_s,
        commanded_deg: fitted.commanded_rad.to_degrees(),
        equivalent_deg: fitted.factor * fitted.commanded_rad.to_degrees(),
        factor: fitted.factor,
        standard_error: fitted.standard_error,
        runs: fitted.runs,
    };
    let both = |[before, after]: [ByLoad<f64>; 2]| BeforeAfter { before, after };
    let run = |run: &Judged| JudgedResult {
        run: run.name.clone(),
        residual_rms: both(run.loads),
        residual_rms_of_changes: both(run.changes),
    };
    let noise_alone = found.noise_gap;
    let gap = |gaps: Option<[f64; 2]>| gaps.map(|[before, after]| HeldOutGap { before, after, noise_alone });
    let fitted = |(measured, fit): &(&Measured, DoubletFit)| FittedDoublet {
        file: measured.file.display().to_string(),
        factor: fit.factor,
        standard_error: fit.standard_error,
        noise_error: fit.noise_error,
        gap: fit.gap.map(|[before, after]| BeforeAfter { before, after }),
    };
    DeflectionResult {
        command: "deflection",
        corrections: found.corrected.origin.clone(),
        standard_errors: "the larger of: declared white noise through the zero-phase filter (exact); Bartlett's sum of the correlated \
                          residuals over 0.2 s",
        factors: found.factors.iter().map(factor).collect(),
        training: found.fits.iter().map(fitted).collect(),
        holdout: HeldOut {
            gap: gap(found.gaps(|run| run.loads)),
            gap_of_changes: gap(found.gaps(|run| run.changes)),
            runs: found.judged.iter().map(run).collect(),
        },
        remarks: found.remarks.clone(),
        seconds,
    }
}

/// `deflection.csv`.
pub(crate) fn csv(factors: &[FittedFactor]) -> String {
    let mut text = String::from("control,V_m_s,commanded_deg,equivalent_deg,factor,standard_error,runs\n");
    for fitted in factors {
        let commanded = fitted.commanded_rad.to_degrees();
        let _ = writeln!(
            text,
            "{},{:.3},{commanded:.4},{:.5},{:.6},{:.6},{}",
            fitted.control,
            fitted.v_m_s,
            fitted.factor * commanded,
            fitted.factor,
            fitted.standard_error,
            fitted.runs
        );
    }
    text
}

/// The table for people.
pub(crate) fn summary(found: &Found<'_>, out: &Path, seconds: f64) -> String {
    let degrees = |fitted: &FittedFactor| fitted.commanded_rad.to_degrees();
    let columns: [report::Column<'_, &FittedFactor>; 7] = [
        ("surface", &|fitted| fitted.control.clone()),
        ("V (m/s)", &|fitted| format!("{:.1}", fitted.v_m_s)),
        ("commanded (deg)", &|fitted| format!("{:.1}", degrees(fitted))),
        ("equivalent (deg)", &|fitted| format!("{:.2}", fitted.factor * degrees(fitted))),
        ("K", &|fitted| format!("{:.3}", fitted.factor)),
        ("standard error", &|fitted| format!("{:.3}", fitted.standard_error)),
        ("runs", &|fitted| fitted.runs.to_string()),
    ];
    let table = report::Table::of(&found.factors, &columns);
    let held = match found.gaps(|run| run.changes).zip(found.gaps(|run| run.loads)) {
        Some(([before, after], [whole_before, whole_after])) => format!(
            "{} held-out doublets, residual over noise ({:.2} is noise alone): {before:.2} with deflections as commanded, \
             {after:.2} corrected; {whole_before:.2} and {whole_after:.2} with what the trim is off",
            found.judged.len(),
            found.noise_gap
        ),
        None if found.judged.is_empty() => "no doublet is held out to judge by".to_owned(),
        None => "no noise is declared, so no gap is given; residuals are in result.json".to_owned(),
    };
    format!(
        "{table}\n{held}\nThe wing with this correction is {}\n{seconds:.2} s; results in {}\n",
        out.join(found.corrected.file.written_name()).display(),
        out.display()
    )
}
