//! The page of `discover`.

use coupling::Load;
use discover::held_out_runs;
use discover::result::{DiscoverResult, HeldOutRun, SearchResult, StatedGap};
use discover::verdict::VerdictKind;
use report::Page;
use report::page::{Block, Content, KeyNumber, PageTable, Plate, Section};
use serde::Deserialize;
use serde_json::Value;

use super::changes::{self, RunChange};
use super::plates::figures;
use super::values::{from_to, short, with_unit};

/// Runs of the paper's Figures 11 to 14, which stand first where a campaign has them.
const FIGURES: [(u32, &str); 4] = [
    (11, "aoa_4hz_30"),
    (12, "doublet_inner_5_30"),
    (13, "doublet_inner_15_30"),
    (14, "doublet_inner_25_30"),
];

/// The page of a result; an empty one if it is none of `discover`.
pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    DiscoverResult::deserialize(result).map_or_else(|_| Page::default(), |result| page_of(&result, plates))
}

fn page_of(result: &DiscoverResult, plates: &mut Vec<Plate>) -> Page {
    let nothing = SearchResult::default();
    let search = result.search.as_ref().unwrap_or(&nothing);
    let runs = std::mem::take(plates);
    let defects = result.defects.iter().map(|defect| Block::Text(defect.sentence.clone())).collect();
    let table = |title: &str, is_there: bool, table: &dyn Fn() -> PageTable| {
        is_there.then(|| Section::new(title, vec![Block::Table(table())]))
    };
    let map = search.map.as_deref().unwrap_or_default();
    let mut numbers = numbers(result, search);
    numbers.extend(changes::number(&held_out(&runs)));
    let sections = [
        (!result.defects.is_empty()).then(|| Section::new("Faults of the data", defects)),
        (!result.effects.is_empty()).then(|| Section::new("What was missing", effects(result))),
        table("Where the simulation disagreed", !search.located.is_empty(), &|| located(search)),
        table("The gap before and after", search.gap.is_some(), &|| gap(search)),
        table("The map before and after", !map.is_empty(), &|| super::discover_map::table(map)),
        table("The next experiment", !search.experiments.is_empty(), &|| experiments(search)),
        (!runs.is_empty()).then(|| held_out_section(runs, &search.held_out_runs)),
        table("All candidates", !search.candidates.is_empty(), &|| candidates(search)),
        table("Detection limits", !search.detection_limits.is_empty(), &|| detection_limits(search)),
    ];
    Page {
        title: title(result).into(),
        lead: lead(result, search),
        numbers,
        sections: sections.into_iter().flatten().collect(),
        ..Page::default()
    }
}

fn held_out_section(runs: Vec<Plate>, one_by_one: &[HeldOutRun]) -> Section {
    let mut changes = held_out(&runs);
    for change in &mut changes {
        let run = one_by_one.iter().find(|run| run.run == change.cells[0]);
        let repeats = run.and_then(|run| run.repeats.clone());
        change.cells.push(repeats.unwrap_or_else(|| "-".into()));
    }
    let mut shown = figures("Held-out runs", ordered(runs));
    let text = "These runs had no part in the search. Before: the corrected model without the effects; after: with them, and with \
                corrections calibrated again beside them. The band is two standard deviations to either side of \
                the model after: noise of a sample, uncertainty of calibrated parameters, model-form variants.";
    let caption = "Held-out runs: root mean square of measured less simulated; and the training run that moves in the same way at the same \
                   airspeed.";
    let told = changes::table(caption, &["run", "repeats"], ["before", "after"], &changes);
    let repeating = held_out_runs::sentence(one_by_one).map(|sentence| Block::Text(format!("{sentence}.")));
    let blocks = [Block::Text(text.into()), Block::Text(changes::sentence(&changes))];
    shown.blocks.splice(0..0, blocks.into_iter().chain(repeating).chain([Block::Table(told)]));
    shown
}

fn title(result: &DiscoverResult) -> &'static str {
    match result.verdict {
        VerdictKind::DataDefect => "The data are at fault: nothing was searched",
        _ if result.search.as_ref().is_some_and(|search| !search.supported) => {
            "Something is missing; the effect that was weighed makes it no better, and none is named"
        }
        VerdictKind::Effects => "An effect was missing from the model, and is found",
        VerdictKind::Ambiguous => "An effect is missing; these data do not tell which of several",
        VerdictKind::Unknown => "Something is missing; these data do not say which effect",
        VerdictKind::None => "No effect is missing beyond the detection limits",
    }
}

fn lead(result: &DiscoverResult, search: &SearchResult) -> Vec<String> {
    let mut lead: Vec<String> =
        result.effects.iter().map(|effect| format!("{}: {}.", effect.name, effect.title)).collect();
    lead.extend((!search.sentence.is_empty()).then(|| search.sentence.clone()));
    let next = search.next_experiment.as_ref();
    lead.extend(next.map(|next| format!("The measurement that would tell more: {next}.")));
    if !search.not_used.is_empty() {
        lead.push(format!("Not used, as residuals are root loads: {}.", search.not_used.join(", ")));
    }
    lead
}

/// Training and held-out gaps.
fn gaps(search: &SearchResult) -> Vec<(&'static str, StatedGap)> {
    let both = search.gap.map(|gap| [("training data", gap.training), ("held-out runs", gap.holdout)]);
    both.into_iter().flatten().collect()
}

fn numbers(result: &DiscoverResult, search: &SearchResult) -> Vec<KeyNumber> {
    let mut numbers = Vec::new();
    for (name, gap) in gaps(search).into_iter().rev().filter(|(_, gap)| gap.before.is_finite()) {
        let floor = short(Some(gap.floor));
        let note = format!("rms residual in standard deviations of the noise; nothing missing: {floor}");
        let gaps = from_to(Some(gap.before), Some(gap.after), "");
        let number = KeyNumber::new(format!("gap on {name}"), gaps, note);
        let judged = !result.effects.is_empty() && gap.floor.is_finite();
        numbers.push(if judged { number.judged(gap.after <= 2.0 * gap.floor) } else { number });
    }
    for effect in &result.effects {
        let note = format!("confidence; log Bayes factor {}", short(effect.log_bayes_factor));
        let number = KeyNumber::new(effect.name.as_str(), short(effect.confidence), note);
        numbers.push(number.judged(effect.confused_with.is_empty()));
    }
    numbers
}

fn effects(result: &DiscoverResult) -> Vec<Block> {
    let mut table = PageTable::new(
        "Fitted to training data; one standard deviation.",
        &["effect", "parameter", "value", "standard deviation"],
    );
    let mut said = Vec::new();
    for effect in &result.effects {
        for (name, fitted) in &effect.parameters {
            let [value, sigma] = [Some(fitted.value), fitted.sigma].map(short);
            table.row([effect.name.clone(), name.clone(), value, sigma]);
        }
        let stays = if effect.stays_with_the_wing {
            "it belongs to the wing and flies with it"
        } else {
            "it belongs to tunnel, balance or sensors and stays there"
        };
        let told = if effect.confused_with.is_empty() {
            String::new()
        } else {
            format!("; not told from {}", effect.confused_with.join(", "))
        };
        said.push(Block::Text(format!("{}: {stays}{told}.", effect.name)));
    }
    said.insert(0, Block::Table(table));
    said
}

fn located(search: &SearchResult) -> PageTable {
    let caption =
        "Motions that the residual of the model without the effects is proportional to, on training data.";
    let head = ["load", "proportional to", "share of the residual", "p-value", "where"];
    let mut table = PageTable::new(caption, &head);
    for l in &search.located {
        let share = format!("{:.0} %", 100.0 * l.share_of_residual);
        let p_value = short(Some(l.p_value));
        table.row([with_unit(l.channel.as_ref()), l.regressor.to_string(), share, p_value, l.place.clone()]);
    }
    table
}

fn gap(search: &SearchResult) -> PageTable {
    let caption = "In standard deviations of the noise; in brackets in percent of the load's variation.";
    let mut table = PageTable::new(caption, &["data", "load", "before", "after", "nothing missing"]);
    for (name, gap) in gaps(search) {
        if !gap.before.is_finite() {
            table.row([name.to_owned(), "no data".into(), String::new(), String::new(), String::new()]);
            continue;
        }
        let [before, after, floor] = [gap.before, gap.after, gap.floor].map(|gap| short(Some(gap)));
        table.row([name.to_owned(), "all".into(), before, after, floor]);
        let (Some(gaps), Some(percent)) = (gap.by_channel, gap.raw_percent) else { continue };
        for load in Load::ALL.into_iter().filter(|load| gaps.before[*load].is_some()) {
            let both =
                |gap: Option<f64>, percent: Option<f64>| format!("{} ({} %)", short(gap), short(percent));
            let [before, after] =
                [both(gaps.before[load], percent.before[load]), both(gaps.after[load], percent.after[load])];
            table.row([name.to_owned(), with_unit(load.column()), before, after, String::new()]);
        }
    }
    table
}

fn experiments(search: &SearchResult) -> PageTable {
    let caption = "Log Bayes factor between the named effect and each rival that an experiment is expected to give, by a forecast \
                   with the floor of the new runs; from 5 on they are told apart. A run with wind costs 1.";
    let mut table = PageTable::new(caption, &["experiment", "cost", "expected log Bayes factor"]);
    for advice in &search.experiments {
        let factors = advice.log_bayes_factors.iter();
        let factors: Vec<String> =
            factors.map(|(rival, factor)| format!("{rival} {}", short(Some(*factor)))).collect();
        table.row([advice.experiment.to_string(), short(Some(advice.cost)), factors.join(", ")]);
    }
    table
}

fn candidates(search: &SearchResult) -> PageTable {
    let mut table = PageTable::new(
        "Each effect alone, before any is in the model.",
        &["effect", "log Bayes factor", "needed"],
    );
    for c in &search.candidates {
        table.row([c.name.clone(), short(Some(c.log_bayes_factor)), short(Some(c.threshold))]);
    }
    table
}

fn detection_limits(search: &SearchResult) -> PageTable {
    let mut table = PageTable::new(
        "The smallest size, to a factor of 1.4, at which these data would have given an effect the log Bayes factor that it needs, \
         if its form were exact; a dash where it would have to be larger than it can be.",
        &["effect", "parameter", "smallest size"],
    );
    for limit in &search.detection_limits {
        let name = format!("{} {}", limit.name, limit.form);
        table.row([name.trim().to_owned(), limit.parameter.clone(), short(limit.value)]);
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

fn held_out(runs: &[Plate]) -> Vec<RunChange> {
    let change = |plate: &Plate| match &plate.content {
        Content::Curves(figure) => Some(RunChange::of_figure(run_name(plate), figure)),
        _ => None,
    };
    runs.iter().filter_map(change).collect()
}
