//! The page of `discover`.

use report::Page;
use report::page::{Block, Content, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::figures;
use super::values::{at, from_to, list, rms_beside_measured, short, short_at, text};

/// Runs of the paper's Figures 11 to 14, which stand first where a campaign has them.
const FIGURES: [(u32, &str); 4] = [
    (11, "aoa_4hz_30"),
    (12, "doublet_inner_5_30"),
    (13, "doublet_inner_15_30"),
    (14, "doublet_inner_25_30"),
];

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let mut sections = Vec::new();
    let defects: Vec<Block> =
        list(result, "defects").iter().map(|d| Block::Text(text(d, "sentence").to_owned())).collect();
    if !defects.is_empty() {
        sections.push(Section::new("Faults of the data", defects));
    }
    if !list(result, "effects").is_empty() {
        sections.push(Section::new("What was missing", effects(result)));
    }
    if !list(result, "located").is_empty() {
        sections.push(Section::new("Where the simulation disagreed", vec![Block::Table(located(result))]));
    }
    if result.get("gap").is_some() {
        sections.push(Section::new("The gap before and after", vec![Block::Table(gap(result))]));
    }
    if !list(result, "map").is_empty() {
        let table = Block::Table(super::discover_map::table(result));
        sections.push(Section::new("The map before and after", vec![table]));
    }
    if !list(result, "experiments").is_empty() {
        sections.push(Section::new("The next experiment", vec![Block::Table(experiments(result))]));
    }
    let runs = std::mem::take(plates);
    if !runs.is_empty() {
        let told = held_out(&runs);
        let mut shown = figures("Held-out runs", ordered(runs));
        let text = "These runs had no part in the search. Before: the corrected model without the effects; after: with them, and with \
                    corrections calibrated again beside them. The dashed edges of one colour are two standard deviations to either side of \
                    the model after: noise of a sample, parameters that calibration knows only so well, model-form variants.";
        shown.blocks.insert(0, Block::Text(text.into()));
        shown.blocks.push(Block::Table(told));
        sections.push(shown);
    }
    if !list(result, "candidates").is_empty() {
        sections.push(Section::new("All candidates", vec![Block::Table(candidates(result))]));
    }
    if !list(result, "detection_limits").is_empty() {
        sections.push(Section::new("Detection limits", vec![Block::Table(detection_limits(result))]));
    }
    Page {
        title: title(result).into(),
        lead: lead(result),
        numbers: numbers(result),
        sections,
        ..Page::default()
    }
}

fn title(result: &Value) -> &'static str {
    match text(result, "verdict") {
        _ if result["supported"] == false => "An effect was named that the data do not support",
        "effects" => "An effect was missing from the model, and is found",
        "ambiguous" => "An effect is missing; these data do not tell which of several",
        "unknown" => "Something is missing; these data do not say which effect",
        "data_defect" => "The data are at fault: nothing was searched",
        _ => "No effect is missing above the floor",
    }
}

fn lead(result: &Value) -> Vec<String> {
    let mut lead: Vec<String> = list(result, "effects")
        .iter()
        .map(|effect| format!("{}: {}.", text(effect, "name"), text(effect, "title")))
        .collect();
    let said = text(result, "sentence");
    if !said.is_empty() {
        lead.push(said.into());
    }
    let next = text(result, "next_experiment");
    if !next.is_empty() {
        lead.push(format!("The measurement that would tell more: {next}."));
    }
    let not_used: Vec<&str> = list(result, "not_used").iter().filter_map(Value::as_str).collect();
    if !not_used.is_empty() {
        lead.push(format!("Not used, as residuals are root loads: {}.", not_used.join(", ")));
    }
    lead
}

fn numbers(result: &Value) -> Vec<KeyNumber> {
    let mut numbers = Vec::new();
    for (key, name) in [("holdout", "gap on held-out runs"), ("training", "gap on training data")] {
        let (before, after) =
            (at(result, &format!("gap/{key}/before")), at(result, &format!("gap/{key}/after")));
        let floor = at(result, &format!("gap/{key}/floor"));
        if before.is_some() {
            let note = format!(
                "rms residual in standard deviations of the noise; nothing missing: {}",
                short(floor)
            );
            let number = KeyNumber::new(name, from_to(before, after, ""), note);
            numbers.push(match (after, floor) {
                (Some(after), Some(floor)) if !list(result, "effects").is_empty() => {
                    number.judged(after <= 2.0 * floor)
                }
                _ => number,
            });
        }
    }
    for effect in list(result, "effects") {
        let note = format!("confidence; log Bayes factor {}", short_at(effect, "log_bayes_factor"));
        let rivals = list(effect, "confused_with").len();
        numbers.push(
            KeyNumber::new(text(effect, "name"), short_at(effect, "confidence"), note).judged(rivals == 0),
        );
    }
    numbers
}

fn effects(result: &Value) -> Vec<Block> {
    let mut table = PageTable::new(
        "Fitted to training data; one standard deviation.",
        &["effect", "parameter", "value", "standard deviation"],
    );
    let mut said = Vec::new();
    for effect in list(result, "effects") {
        for (name, fitted) in effect["parameters"].as_object().into_iter().flatten() {
            table.row([
                text(effect, "name").to_owned(),
                name.clone(),
                short_at(fitted, "value"),
                short_at(fitted, "sigma"),
            ]);
        }
        let rivals: Vec<&str> = list(effect, "confused_with").iter().filter_map(Value::as_str).collect();
        let stays = if effect["stays_with_the_wing"] == true {
            "it belongs to the wing and flies with it"
        } else {
            "it belongs to tunnel, balance or sensors and stays there"
        };
        let told =
            if rivals.is_empty() { String::new() } else { format!("; not told from {}", rivals.join(", ")) };
        said.push(Block::Text(format!("{}: {stays}{told}.", text(effect, "name"))));
    }
    said.insert(0, Block::Table(table));
    said
}

fn located(result: &Value) -> PageTable {
    let caption = "What the residual of the model without the effects goes with, on training data.";
    let head = ["load", "goes with", "share of the residual", "p-value", "where"];
    let mut table = PageTable::new(caption, &head);
    for l in list(result, "located") {
        let share =
            at(l, "share_of_residual").map_or_else(|| "-".into(), |share| format!("{:.0} %", 100.0 * share));
        table.row([
            text(l, "channel").to_owned(),
            text(l, "regressor").to_owned(),
            share,
            short_at(l, "p_value"),
            text(l, "where").to_owned(),
        ]);
    }
    table
}

fn gap(result: &Value) -> PageTable {
    let caption = "In standard deviations of the noise; in brackets in percent of the load's variation.";
    let mut table = PageTable::new(caption, &["data", "load", "before", "after", "nothing missing"]);
    for (key, name) in [("training", "training"), ("holdout", "held out")] {
        let of = |path: &str| short(at(result, &format!("gap/{key}/{path}")));
        if at(result, &format!("gap/{key}/before")).is_none() {
            table.row([name.to_owned(), "no data".into(), String::new(), String::new(), String::new()]);
            continue;
        }
        table.row([name.to_owned(), "all".into(), of("before"), of("after"), of("floor")]);
        let there = |load: &&str| at(result, &format!("gap/{key}/by_channel/before/{load}")).is_some();
        for load in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().filter(there) {
            let both = |when: &str| {
                format!(
                    "{} ({} %)",
                    of(&format!("by_channel/{when}/{load}")),
                    of(&format!("raw_percent/{when}/{load}"))
                )
            };
            table.row([name.to_owned(), load.into(), both("before"), both("after"), String::new()]);
        }
    }
    table
}

fn experiments(result: &Value) -> PageTable {
    let caption = "What each would separate the named effect from its rivals by, by a forecast with the floor of the new runs; 5 \
                   is a distinction. A run with wind costs 1.";
    let mut table = PageTable::new(caption, &["experiment", "cost", "expected log Bayes factor"]);
    for experiment in list(result, "experiments") {
        let factors = experiment["expected_log_bayes_factor"].as_object().into_iter().flatten();
        let factors: Vec<String> =
            factors.map(|(rival, factor)| format!("{rival} {}", short(factor.as_f64()))).collect();
        table.row([
            text(experiment, "experiment").to_owned(),
            short_at(experiment, "cost"),
            factors.join(", "),
        ]);
    }
    table
}

fn candidates(result: &Value) -> PageTable {
    let mut table = PageTable::new(
        "Evidence of each effect alone, before any is in the model.",
        &["effect", "log Bayes factor", "needed"],
    );
    for c in list(result, "candidates") {
        table.row([text(c, "name").to_owned(), short_at(c, "log_bayes_factor"), short_at(c, "threshold")]);
    }
    table
}

fn detection_limits(result: &Value) -> PageTable {
    let mut table = PageTable::new(
        "The smallest size, to a factor of 1.4, at which these data would have given an effect the evidence that it needs, if its \
         form were exact; a dash where it would have to be larger than it can be.",
        &["effect", "parameter", "smallest size"],
    );
    for limit in list(result, "detection_limits") {
        let name = format!("{} {}", text(limit, "name"), text(limit, "form"));
        table.row([name.trim().to_owned(), text(limit, "parameter").to_owned(), short_at(limit, "value")]);
    }
    table
}

/// Name of a held-out run: its figure's name without the folder.
fn run_name(plate: &Plate) -> &str {
    plate.name.rsplit('/').next().unwrap_or(&plate.name)
}

/// The paper's figures first, and the rest folded up if there are any of those.
fn ordered(runs: Vec<Plate>) -> Vec<Plate> {
    let number =
        |plate: &Plate| FIGURES.iter().find(|(_, name)| *name == run_name(plate)).map(|(number, _)| *number);
    let (mut first, mut rest): (Vec<Plate>, Vec<Plate>) =
        runs.into_iter().partition(|plate| number(plate).is_some());
    first.sort_by_key(number);
    for plate in &mut first {
        let figure = number(plate).map_or(String::new(), |figure| format!("Figure {figure} of the paper: "));
        plate.title = format!("{figure}{}", plate.title);
    }
    let folded = !first.is_empty();
    for plate in &mut rest {
        plate.folded = folded;
    }
    first.extend(rest);
    first
}

fn held_out(runs: &[Plate]) -> PageTable {
    let head = ["run", "Fz before (N)", "after", "Mx before (N m)", "after", "My before (N m)", "after"];
    let mut table = PageTable::new("Held-out runs: root mean square of measured less simulated.", &head);
    for plate in runs {
        let Content::Curves(figure) = &plate.content else { continue };
        let (before, after) = (rms_beside_measured(figure, "before"), rms_beside_measured(figure, "after"));
        let pairs =
            before.iter().zip(&after).flat_map(|(before, after)| [short(Some(*before)), short(Some(*after))]);
        let mut row = vec![run_name(plate).to_owned()];
        row.extend(pairs);
        table.row(row);
    }
    table
}
