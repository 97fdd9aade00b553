//! The page of `loads`: how many cases, what drives the wing, what goes to stress, and how well the cards give it back.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::{figures, taken};
use super::values::{at, digits, list, short, text, whole_at};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let mut numbers = vec![
        KeyNumber::new(
            "cases",
            whole_at(result, "cases"),
            format!("{} left out", whole_at(result, "left_out")),
        ),
        KeyNumber::new("flown", whole_at(result, "flown"), "initial and updated model"),
        KeyNumber::new("load sets for stress", list(result, "selected").len().to_string(), ""),
    ];
    if let Some(worst) = at(result, "round_trip/stations") {
        let note = "largest difference between loads flown and cards read back";
        numbers.push(KeyNumber::new("round trip", digits(worst, 2), note));
    }
    let failed = list(result, "failed");
    let mut lead = vec![
        "Loads by the numbers of the plan; compliance with any rule is the applicant's to show.".to_owned(),
    ];
    if !failed.is_empty() {
        lead.insert(0, format!("{} cases could not be flown; cases.csv says why.", failed.len()));
    }
    let mut sections = vec![
        figures("V-n diagrams", taken(plates, "vn_")),
        figures("Loads at stations", taken(plates, "potato_")),
        turbulence(result, plates),
        Section::new("Discrete gusts", gusts(result)),
        Section::new("Envelope", vec![Block::Table(envelope(result))]),
        Section::new("Load sets for stress", for_stress(result)),
    ];
    sections.retain(|section| !section.blocks.is_empty());
    Page { title: text(result, "name").to_owned(), lead, numbers, sections, ..Page::default() }
}

fn envelope(result: &Value) -> PageTable {
    let rows = list(result, "envelope");
    let is_interval = rows.iter().any(|row| row.get("interval_90").is_some());
    let mut head = vec!["model", "station", "load", "end", "value"];
    head.extend(is_interval.then_some("90 % interval"));
    head.extend(["case", "flown"]);
    let mut table = PageTable::new("", &head);
    for row in rows {
        let mut cells = ["model", "station", "load", "end"].map(|key| text(row, key).to_owned()).to_vec();
        cells.push(short(row["value"].as_f64()));
        if is_interval {
            let [low, high] = [0, 1].map(|end| row["interval_90"][end].as_f64());
            let words = low.and(high).map(|_| format!("{} to {}", short(low), short(high)));
            cells.push(words.unwrap_or_default());
        }
        cells.extend([whole_at(row, "case"), text(row, "flown").to_owned()]);
        table.row(cells);
    }
    table
}

/// Limit loads in continuous turbulence: figures, and those of both roots; on a deck, of all stations.
fn turbulence(result: &Value, plates: &mut Vec<Plate>) -> Section {
    let mut section = figures("Continuous turbulence", taken(plates, "turbulence_"));
    let head = [
        "model",
        "case",
        "station",
        "load",
        "level",
        "smallest",
        "largest",
        "A per m/s",
        "N0 (Hz)",
        "attitude",
    ];
    let mut table = PageTable::new("", &head);
    let is_root = |row: &Value| text(row, "station").ends_with(" root");
    let has_roots = list(result, "turbulence").iter().any(is_root);
    let roots = list(result, "turbulence").iter().filter(|row| !has_roots || is_root(row));
    for row in roots.clone() {
        let word = |key: &str| text(row, key).to_owned();
        table.row([
            word("model"),
            whole_at(row, "case"),
            word("station"),
            word("load"),
            short(row["one_g"].as_f64()),
            short(row["limits"][0].as_f64()),
            short(row["limits"][1].as_f64()),
            short(row["a_bar"].as_f64()),
            short(row["n0_hz"].as_f64()),
            word("attitude"),
        ]);
    }
    if roots.count() > 0 {
        section.blocks.push(Block::Table(table));
    }
    section
}

/// Worst gusts of the roots.
fn gusts(result: &Value) -> Vec<Block> {
    let rows = list(result, "gusts");
    if rows.is_empty() {
        return Vec::new();
    }
    let mut table =
        PageTable::new("", &["model", "station", "load", "end", "value", "H (m)", "case", "tuned"]);
    for row in rows {
        let word = |key: &str| text(row, key).to_owned();
        let tuned = row["tuned"].as_bool().unwrap_or(false);
        table.row([
            word("model"),
            word("station"),
            word("load"),
            word("end"),
            short(row["value"].as_f64()),
            short(row["H_m"].as_f64()),
            whole_at(row, "case"),
            if tuned { "yes" } else { "no: at the end of the range" }.to_owned(),
        ]);
    }
    vec![Block::Table(table)]
}

/// What the package holds, how well it gives back what was flown, and its load sets.
fn for_stress(result: &Value) -> Vec<Block> {
    let sets = Block::Table(selected(result));
    let Some(package) = result["package"].as_str() else { return vec![sets] };
    let off =
        |key: &str| at(result, &format!("round_trip/{key}")).map_or_else(String::new, |off| digits(off, 2));
    let words = format!(
        "{package}/ holds index.bdf (linear statics, a subcase a load set), the structure or the stations that the cards belong to, \
         case_00001.bdf to case_{:05}.bdf, index.csv (fingerprints), station_loads.csv, round_trip.csv, loads.h5 and README.md. Read back, the cards \
         give the loads of stations within {}, the whole aircraft's balance within {}, and the tips within {} of the largest.",
        list(result, "selected").len(),
        off("stations"),
        off("balance"),
        off("tip")
    );
    vec![Block::Text(words), sets]
}

fn selected(result: &Value) -> PageTable {
    let mut table = PageTable::new("", &["load set", "model", "case", "instant", "drives", "why"]);
    for row in list(result, "selected") {
        let why: Vec<&str> = list(row, "why").iter().filter_map(Value::as_str).collect();
        table.row([
            whole_at(row, "sid"),
            text(row, "model").to_owned(),
            whole_at(row, "case"),
            whole_at(row, "instant"),
            whole_at(row, "driven"),
            why.join("; "),
        ]);
    }
    table
}
