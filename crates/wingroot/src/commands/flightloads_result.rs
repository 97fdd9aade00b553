//! `result.json` and `flightloads.csv` of `flightloads`.

use std::fmt::Write as _;

use loads::FlightFile;
use loads::compare::coverage::Coverage;
use loads::compare::{Judged, Thresholds, Verdict};
use loads::flight::Channel;
use schemars::JsonSchema;
use serde::Serialize;

use super::flightloads_campaign::CampaignPoints;
use crate::pages::values::digits;

/// Measured against calculated loads.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct FlightloadsResult {
    /// Name of the command.
    command: &'static str,
    /// Name of the measurements.
    pub(crate) name: String,
    /// Where the corrections come from; absent where tables bring the calculated loads.
    #[serde(skip_serializing_if = "Option::is_none")]
    corrections: Option<String>,
    /// Number of conditions.
    pub(crate) conditions: usize,
    /// Points of all conditions that are compared.
    pub(crate) points: usize,
    /// Those among them that fitted the corrections and count in no verdict.
    pub(crate) fitted: usize,
    /// Rows with deflected controls in campaigns, which are not compared.
    left_out: usize,
    /// What was asked for, by the user.
    thresholds: Thresholds,
    /// A row each condition, station, load and model.
    pub(crate) rows: Vec<Row>,
    /// How far what was flown covers design loads, if these were given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) coverage: Option<Coverage>,
    /// Wall clock.
    pub(crate) seconds: f64,
}

/// A load at a station in a condition by a model.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Row {
    /// Condition.
    pub(crate) condition: String,
    /// Station.
    pub(crate) station: String,
    /// Load.
    pub(crate) load: &'static str,
    /// Its unit.
    unit: &'static str,
    /// `initial` or `updated`.
    pub(crate) model: &'static str,
    /// In a sentence.
    sentence: String,
    /// Statistics and verdict.
    #[serde(flatten)]
    pub(crate) judged: Judged,
}

impl Row {
    /// A row with its sentence.
    pub(super) fn new(condition: String, channel: &Channel, model: &'static str, judged: Judged) -> Self {
        let (station, load) = (channel.station.clone(), channel.load.name());
        let sentence = sentence(&condition, channel, model, &judged);
        Self { condition, station, load, unit: channel.load.unit(), model, sentence, judged }
    }
}

impl FlightloadsResult {
    /// All rows of a file.
    pub(super) fn new(
        file: &FlightFile,
        corrections: Option<String>,
        rows: Vec<Row>,
        campaigns: &[CampaignPoints],
    ) -> Self {
        // Every model and channel has the same points: those of the first model, by condition.
        let mut points: Vec<(&str, usize, usize)> = Vec::new();
        for row in &rows {
            let judged = &row.judged;
            let known = points.iter_mut().find(|(name, ..)| *name == row.condition);
            match known {
                Some((_, all, fitted)) => {
                    *all = (*all).max(judged.points + judged.fitted);
                    *fitted = (*fitted).max(judged.fitted);
                }
                None => points.push((&row.condition, judged.points + judged.fitted, judged.fitted)),
            }
        }
        Self {
            command: "flightloads",
            name: file.name.clone(),
            corrections,
            conditions: file.conditions.len(),
            points: points.iter().map(|(_, all, _)| all).sum(),
            fitted: points.iter().map(|(.., fitted)| fitted).sum(),
            left_out: campaigns.iter().map(|campaign| campaign.left_out).sum(),
            thresholds: file.thresholds(),
            rows,
            coverage: None,
            seconds: 0.0,
        }
    }
}

/// What is said of a row, in a sentence.
fn sentence(condition: &str, channel: &Channel, model: &str, judged: &Judged) -> String {
    let mut text = format!(
        "{condition} ({} points, {} more fitted): at station {}, {} by the {model} model",
        judged.points,
        judged.fitted,
        channel.station,
        channel.load.name()
    );
    if let Some(line) = &judged.line {
        let percent = |slope: f64| 100.0 * (1.0 - slope);
        let words = if line.slope.value <= 1.0 { "high" } else { "low" };
        let sign = if line.slope.value <= 1.0 { 1.0 } else { -1.0 };
        let mut ends = [sign * percent(line.slope.low), sign * percent(line.slope.high)];
        ends.sort_by(f64::total_cmp);
        let _ = write!(
            text,
            " is calculated {} % {words} (95 %: {} to {})",
            digits(sign * percent(line.slope.value), 3),
            digits(ends[0], 3),
            digits(ends[1], 3)
        );
    }
    if let Some(worst) = judged.worst_ratio {
        let _ = write!(text, "; at large loads calculated over measured is never below {}", digits(worst, 4));
    }
    let _ = write!(text, "; {}: {}.", judged.verdict.word(), judged.reasons.join("; "));
    text
}

/// All rows as a table.
pub(super) fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "condition,station,load,unit,model,points,fitted,slope,slope_low,slope_high,intercept,slope_through_zero,bias,bias_low,\
         bias_high,rms_percent,r2,residual_sigma,sigma,large,worst_ratio,conservative,verdict,reasons\n",
    );
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:.9e}"));
    for row in rows {
        let Judged { line, bias, conservative, verdict, .. } = &row.judged;
        let line = line.as_ref();
        let cells = [
            line.map(|line| line.slope.value),
            line.map(|line| line.slope.low),
            line.map(|line| line.slope.high),
            line.map(|line| line.intercept.value),
            line.map(|line| line.slope_through_zero.value),
            bias.map(|bias| bias.value),
            bias.map(|bias| bias.low),
            bias.map(|bias| bias.high),
            row.judged.rms_percent,
            line.map(|line| line.r2),
            line.map(|line| line.residual_sigma),
            row.judged.sigma,
        ]
        .map(number);
        let verdict: &Verdict = verdict;
        let _ = writeln!(
            text,
            "\"{}\",\"{}\",{},{},{},{},{},{},{},{},{} of {},{},\"{}\"",
            row.condition.replace('"', "'"),
            row.station.replace('"', "'"),
            row.load,
            row.unit,
            row.model,
            row.judged.points,
            row.judged.fitted,
            cells.join(","),
            row.judged.large,
            number(row.judged.worst_ratio),
            conservative.k,
            conservative.n,
            verdict.word(),
            row.judged.reasons.join("; ").replace('"', "'"),
        );
    }
    text
}
