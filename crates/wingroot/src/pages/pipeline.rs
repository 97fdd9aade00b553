//! The page of `pipeline`: the most important number of each step, and links to the pages of all.

use report::Page;
use report::page::{Block, KeyNumber, Link, Plate, Section};
use serde_json::Value;

use super::changes::{self, RunChange};
use super::plates::figures;
use super::values::{at, from_to, list, short, short_at, text};

/// Steps with what their pages show.
const STEPS: [(&str, &str, &str); 5] = [
    ("calibrate", "Calibration", "corrections of the panel model from static root loads"),
    ("deflection", "Deflections", "how much of a commanded deflection acts"),
    (
        "simulate",
        "Simulation",
        "all wind-tunnel runs flown again, initial and updated beside the measurement",
    ),
    ("discover", "Discovery", "the effect the model lacks: where, what, the gap before and after"),
    (
        "fullaircraft",
        "Aircraft",
        "the mirrored aircraft in trim, pull-up, push-down, doublet, chirp and gust",
    ),
];

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let links: Vec<Link> = STEPS
        .into_iter()
        .filter(|(name, ..)| result.get(name).is_some())
        .map(|(name, text, note)| Link {
            text: text.into(),
            to: format!("../{name}/report.html"),
            note: note.into(),
        })
        .collect();
    let effects: Vec<&str> =
        list(result, "discover/effects").iter().map(|effect| text(effect, "name")).collect();
    let found = if effects.is_empty() {
        "The search found nothing that the model lacks.".to_owned()
    } else {
        format!("The search found what the model lacked: {}.", effects.join(", ").replace('_', " "))
    };
    let runs: Vec<RunChange> = list(result, "held_out_runs").iter().map(RunChange::of_entry).collect();
    let mut numbers = numbers(result);
    numbers.extend(changes::number(&runs));
    let mut sections = vec![Section::new("The steps", vec![Block::Links(links)])];
    if !runs.is_empty() {
        let caption = "Root mean square of measured less simulated, before and after what the search found.";
        let table = changes::table(caption, &["run"], ["before", "after"], &runs);
        let blocks = vec![Block::Text(changes::sentence(&runs)), Block::Table(table)];
        sections.push(Section::new("Held-out runs, better and worse", blocks));
    }
    sections.push(figures("Figures of the paper", std::mem::take(plates)));
    sections.push(Section::new(
        "More figures of the paper, on the steps' pages",
        vec![Block::Links(elsewhere(result))],
    ));
    Page {
        title: "From root loads to a flying aircraft".into(),
        lead: vec![
            "The wing calibrated from its root loads, its maneuvers simulated, the missing effect looked for, and the mirrored \
             aircraft flown with what was found."
                .into(),
            found,
        ],
        numbers,
        sections,
        ..Page::default()
    }
}

/// Figures 7 and 20 to 23, which are pictures and shapes of two steps.
fn elsewhere(result: &Value) -> Vec<Link> {
    let link =
        |text: &str, to: &str, note: &str| Link { text: text.into(), to: to.into(), note: note.into() };
    let speeds = list(result, "calibrate/airspeeds");
    let mut links = Vec::new();
    if let Some(v) = speeds.iter().filter_map(|a| at(a, "V_m_s")).next_back() {
        let to = format!("../calibrate/report.html#corrections_{}", crate::commands::speed_name(v));
        links.push(link("Figure 7", &to, "the corrections on the planform, a picture an airspeed"));
    }
    if result.get("fullaircraft").is_some() {
        for (text, anchor, note) in [
            ("Figure 20", "envelope", "the envelope with the two limit points"),
            ("Figure 21", "pull_up", "the aircraft in the pull-up and the push-down, to turn"),
            ("Figures 22 and 23", "doublet", "aileron doublet and chirp in free flight"),
        ] {
            links.push(link(text, &format!("../fullaircraft/report.html#{anchor}"), note));
        }
    }
    links
}

fn numbers(result: &Value) -> Vec<KeyNumber> {
    let airspeeds = list(result, "calibrate/airspeeds");
    let worst = |path: &str| airspeeds.iter().filter_map(|a| at(a, path)).reduce(f64::max);
    let mut numbers = vec![KeyNumber::new(
        "lift, static",
        from_to(worst("rmse_before/Fz_N"), worst("rmse_after/Fz_N"), "N"),
        "rms error, initial to updated; worst airspeed",
    )];
    let pair = |path: &str| ["before", "after"].map(|when| at(result, &format!("{path}/{when}")));
    let [before, after] = pair("deflection/holdout/gap");
    numbers.push(KeyNumber::new(
        "held-out doublets",
        from_to(before, after, ""),
        "rms residual over noise, deflections as commanded, then corrected",
    ));
    let [before, after] = pair("discover/gap/holdout");
    let note = format!(
        "rms residual over noise, without effects, then with; nothing missing: {}",
        short_at(result, "discover/gap/holdout/floor")
    );
    numbers.push(KeyNumber::new("held-out gap", from_to(before, after, ""), note));
    let tip = ["initial", "updated"]
        .map(|model| at(result, &format!("fullaircraft/models/{model}/pull_up/tip_deflection_m")));
    let factor = short(at(result, "fullaircraft/models/initial/pull_up/load_factor"));
    numbers.push(KeyNumber::new(
        "tip in the pull-up",
        from_to(tip[0], tip[1], "m"),
        format!("at {factor} g, initial to updated"),
    ));
    numbers
}
