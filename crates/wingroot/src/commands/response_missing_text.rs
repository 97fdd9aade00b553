//! What `response --missing` prints, and its tables of candidates and families.

use std::fmt::Write as _;

use report::{Column, Table};
use response::missing::{Family, Missing, Named};
use response::verdict::{Gap, VerdictKind};

use super::response_files::csv;
use super::response_models::Asked;
use super::response_text::{number, probability};

/// Families that are printed; all are in the table.
const FAMILIES: usize = 4;

/// One response.
pub(super) fn response(asked: &Asked, found: &Missing) -> String {
    let mut text = format!("\n{}, {}: the model is {}", asked.file, asked.response, asked.origin);
    if let Some(hidden) = &asked.hidden {
        let _ = write!(text, " without {hidden}");
    }
    let terms: Vec<String> = asked.question.model.iter().map(ToString::to_string).collect();
    let _ = write!(text, "\n    {}", terms.join(", "));
    for blocks in &asked.question.blocks {
        let _ = write!(text, ", offsets of {blocks}");
    }
    if !asked.left_out.is_empty() {
        let _ = write!(text, "; not told from these at these points: {}", asked.left_out.join(", "));
    }
    text.push('\n');
    if found.families.iter().any(|family| found.is_located(family)) {
        let _ = writeln!(text, "  what it leaves, by family of regressors, in units of pure error:");
        let _ = writeln!(text, "{}", indented(&families(found)));
    }
    text.push_str(&answer(asked, found));
    let gap = |name: &str, gap: Gap| {
        let (before, after, floor) = (gap.before, gap.after, gap.floor);
        format!("  gap, {name:<9} {before:>7.3} -> {after:>6.3} (nothing missing: {floor:.3})\n")
    };
    if found.named.is_empty() {
        let (training, held) = (found.training, found.held_out);
        let _ = writeln!(
            text,
            "  gap: training {:.3}, held out {:.3} standard deviations of pure error (nothing missing: {:.3}, {:.3})",
            training.after, held.after, training.floor, held.floor
        );
    } else {
        text.push_str(&gap("training", found.training));
        text.push_str(&gap("held out", found.held_out));
        let closed = if found.closed() { "the held-out gap closed" } else { "no success is claimed" };
        let split = &found.split;
        let _ = writeln!(
            text,
            "  {closed}; {} points fitted, {} held out (settings drawn at random, with all their replicates)",
            split.training.len(),
            split.held_out.len()
        );
    }
    text
}

fn indented(table: &str) -> String {
    table.trim_end().lines().map(|line| format!("    {line}")).collect::<Vec<_>>().join("\n")
}

fn families(found: &Missing) -> String {
    let columns: [Column<'_, &Family>; 7] = [
        ("family", &|family| family.name.clone()),
        ("terms", &|family| family.members.len().to_string()),
        ("of the residual", &|family| format!("{:.1} %", 100.0 * family.share)),
        ("F", &|family| format!("{:.2}", family.alone.f)),
        ("p", &|family| probability(family.alone.p_value)),
        ("F beside others", &|family| {
            family.beside_others.map_or("-".into(), |test| format!("{:.2}", test.f))
        }),
        ("p", &|family| family.beside_others.map_or("-".into(), |test| probability(test.p_value))),
    ];
    Table::of(found.families.iter().take(FAMILIES), &columns).to_string()
}

fn answer(asked: &Asked, found: &Missing) -> String {
    let mut text = String::new();
    match found.verdict {
        VerdictKind::None => {
            let best = found.candidates.first().map_or(String::new(), |(name, factor)| {
                format!(
                    " (best of {}: {name} with a log Bayes factor of {factor:.1}, {:.1} needed)",
                    found.candidates.len(),
                    found.threshold
                )
            });
            let _ = writeln!(text, "  none: the model explains the points to their pure error{best}");
            let hidden = asked.hidden.as_deref();
            if let Some(unseen) =
                found.detection_limits.iter().find(|one| Some(one.term.to_string().as_str()) == hidden)
            {
                let _ = writeln!(
                    text,
                    "  detection limit of {}: a coefficient of {}; published is {}",
                    unseen.term,
                    number(unseen.coefficient),
                    asked.published.map_or("nothing".into(), number)
                );
            }
        }
        VerdictKind::Unknown => {
            let [before, after] = found.misfit;
            let _ = writeln!(
                text,
                "  unknown: lack of fit is {before:.2} of pure error, {after:.2} with what comes closest, and at most {:.2} where nothing is missing",
                found.misfit_limit
            );
        }
        VerdictKind::Effects | VerdictKind::Ambiguous | VerdictKind::DataDefect => {}
    }
    let word = if found.verdict == VerdictKind::Unknown { "closest" } else { "missing" };
    for named in &found.named {
        text.push_str(&name(asked, named, word));
    }
    text
}

fn name(asked: &Asked, named: &Named, word: &str) -> String {
    let what = if named.is_block { "offsets of " } else { "" };
    let mut text = format!("  {word}: {what}{}", named.name);
    for parameter in &named.parameters {
        let label = if named.is_block { format!("{} ", parameter.name) } else { "coefficient ".into() };
        let _ = write!(text, ", {label}{}", number(parameter.value));
        if let Some(sigma) = parameter.sigma {
            let _ = write!(text, " +- {}", number(sigma));
        }
    }
    if let Some(published) = asked.published.filter(|_| asked.hidden.as_ref() == Some(&named.name)) {
        let _ = write!(text, " (published {})", number(published));
    }
    let _ = writeln!(
        text,
        "\n    log Bayes factor {:.1} against the model without it ({:.1} needed), {:.1} % of the lack of fit, confidence {:.2}",
        named.log_bayes_factor,
        named.threshold,
        100.0 * named.share,
        named.confidence
    );
    if !named.confused_with.is_empty() {
        let rivals = named.confused_with.iter().zip(&named.correlation);
        let rivals: Vec<String> = rivals.map(|(name, r)| format!("{name} (correlation {r:.4})")).collect();
        let _ = writeln!(text, "    these points do not tell it from {}", rivals.join(", "));
    }
    text
}

/// Log Bayes factor of every candidate.
pub(super) fn candidates_csv(pairs: &[(&Asked, &Missing)]) -> String {
    let rows = pairs.iter().flat_map(|(asked, found)| {
        let (file, response, threshold) = (&asked.file, &asked.response, found.threshold);
        let row = move |(name, factor): &(String, f64)| {
            format!("{file},{response},{name},{factor:e},{threshold:e}")
        };
        found.candidates.iter().map(row)
    });
    csv("data,response,candidate,log_bayes_factor,threshold", rows)
}

/// F tests of every family.
pub(super) fn families_csv(pairs: &[(&Asked, &Missing)]) -> String {
    let rows = pairs.iter().flat_map(|(asked, found)| {
        let row = move |family: &Family| {
            let (file, response, name) = (&asked.file, &asked.response, &family.name);
            let (share, alone) = (family.share, family.alone);
            let beside = family.beside_others.map(|test| format!("{:e},{:e}", test.f, test.p_value));
            let beside = beside.unwrap_or_else(|| ",".into());
            format!("{file},{response},{name},{share:e},{:e},{:e},{beside}", alone.f, alone.p_value)
        };
        found.families.iter().map(row)
    });
    csv("data,response,family,share_of_residual,f,p_value,f_beside_others,p_value_beside_others", rows)
}
