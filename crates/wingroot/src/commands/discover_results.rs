//! What `discover` found as a table for people, and its map as CSV.

use std::fmt::Write as _;
use std::path::Path;

use discover::finding::Finding;
use discover::held_out_runs;
use discover::result::{DiscoverResult, MapCell};
use discover::spectral_lines::sentence;
use discover::stated_noise;

/// The map as CSV.
pub(crate) fn map_csv(cells: &[MapCell]) -> String {
    let mut text = String::from("model,channel,maneuver,from_hz,to_hz,power,limit,rows,units\n");
    for model in ["before", "after"] {
        for cell in cells {
            let MapCell { channel, maneuver, from_hz, to_hz, before, after, limit, rows, units } = cell;
            let power = if model == "before" { before } else { after };
            let _ = writeln!(
                text,
                "{model},{channel},\"{maneuver}\",{from_hz},{to_hz},{power:.3},{limit:.3},{rows},{units}"
            );
        }
    }
    text
}

/// The table for people.
pub(crate) fn summary(finding: &Finding<'_>, result: &DiscoverResult, out: &Path) -> String {
    let mut text = String::new();
    let held_out = result.search.as_ref().map_or(&[][..], |search| &search.held_out_runs);
    for effect in &finding.report.outcome.found {
        let spec = effect.active.effect.spec();
        let _ = writeln!(
            text,
            "{}: {} (log Bayes factor {:.0}, confidence {:.2})",
            spec.name, spec.title, effect.evidence, effect.confidence
        );
        let values = effect.active.values.iter().zip(&effect.sigma);
        for (p, (value, sigma)) in effect.active.parameters().iter().zip(values) {
            let _ = writeln!(text, "    {:<24} {value:>10.4} +- {sigma:.4}", p.name);
        }
        if !effect.confused_with.is_empty() {
            let _ = writeln!(text, "    not told from: {}", effect.confused_with.join(", "));
        }
    }
    if let Some(next) = finding.next_experiment() {
        let _ = writeln!(text, "next: {next}");
    }
    let (data, judgement) = (&finding.prepared.data, finding.judgement());
    let gaps = [("training", Some(judgement.training)), ("held out", judgement.held_out)];
    for (name, gap) in gaps.into_iter().filter_map(|(name, gap)| Some((name, gap?))) {
        let _ = writeln!(
            text,
            "gap, {name:<9} {:>6.1} -> {:>5.1} standard deviations of the noise (nothing missing: {:.1})",
            gap.before, gap.after, gap.floor
        );
    }
    if let Some(line) = held_out_runs::sentence(held_out) {
        let _ = writeln!(text, "{line}");
    }
    if !data.not_used.is_empty() {
        let _ = writeln!(text, "not used: {} (residuals are root loads)", data.not_used.join(", "));
    }
    if let Some(line) = sentence(&data.rules.spectral_lines, &finding.prepared.spectral_lines) {
        let _ = writeln!(text, "{line}");
    }
    if let Some(line) = stated_noise::sentence(&finding.prepared.noise_beyond_stated) {
        let _ = writeln!(text, "{line}");
    }
    let _ = writeln!(text, "{}", judgement.sentence());
    let runs = finding.report.model_runs;
    let _ = writeln!(
        text,
        "{:.1} s, {runs} model runs; results in {}",
        result.seconds.unwrap_or(0.0),
        out.display()
    );
    text
}
