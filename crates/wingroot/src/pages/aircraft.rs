//! The pages of `fullaircraft` and `fullaircraft --cases`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::{figures, taken};
use super::values::{
    Column, at, counted, decimals_at, from_to, list, short, short_at, table_of, text, with_unit, word,
};

/// Path below a model, what it is, its unit.
type Row = (&'static str, &'static str, &'static str);

const KEYS: [Row; 6] = [
    ("pull_up/tip_deflection_m", "tip in the pull-up", "m"),
    ("push_down/tip_deflection_m", "tip in the push-down", "m"),
    ("trim/alpha_deg", "angle of attack in trim", "deg"),
    ("trim/elevator_deg", "elevator in trim", "deg"),
    ("doublet/peak_tip_acceleration_m_s2", "tip acceleration, doublet", "m/s2"),
    ("gust/peak_load_factor", "load factor, gust", "g"),
];

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let both = |path: &str| ["initial", "updated"].map(|model| at(result, &format!("models/{model}/{path}")));
    let mut numbers = Vec::new();
    for (path, label, unit) in KEYS {
        let [before, after] = both(path);
        if before.is_some() {
            numbers.push(KeyNumber::new(label, from_to(before, after, unit), "initial to updated model"));
        }
    }
    let [before, after] =
        ["initial", "updated"].map(|model| at(result, &format!("derivatives/{model}/neutral_point_x_m/2")));
    if before.is_some() {
        numbers.push(KeyNumber::new(
            "neutral point x",
            from_to(before, after, "m"),
            "flexible aircraft, free",
        ));
    }
    let mut shapes = taken(plates, "pull_up");
    shapes.extend(taken(plates, "push_down"));
    let mut sections = vec![figures("Deformed shapes", shapes)];
    sections.push(Section::new("Steady flight", vec![Block::Table(steady(result))]));
    if result.get("large_deflections").is_some() {
        sections.push(Section::new("Large deflections", vec![Block::Table(bent(result))]));
    }
    sections.push(figures("Maneuvers and gust in time", std::mem::take(plates)));
    sections.push(Section::new("Peaks", vec![Block::Table(peaks(result))]));
    if result.get("derivatives").is_some() {
        sections.push(Section::new("Derivatives", vec![Block::Table(derivatives(result))]));
    }
    let warnings: Vec<Block> =
        list(result, "warnings").iter().filter_map(Value::as_str).map(|w| Block::Text(w.into())).collect();
    if !warnings.is_empty() {
        sections.push(Section::new("Remarks", warnings));
    }
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("{} in flight, initial beside updated", text(result, "aircraft")),
        lead: vec![format!(
            "The wing with its corrections at {} m/s, mirrored, with tail and fuselage ({} boxes), trimmed, pulled up, pushed \
             down, and flown through aileron commands{}.",
            short_at(result, "correction_airspeed_m_s"),
            at(result, "boxes").unwrap_or_default(),
            if both("gust/peak_load_factor")[0].is_some() { " and a vertical gust" } else { "" }
        )],
        numbers,
        sections,
        ..Page::default()
    }
}

/// Steady flight of the aircraft that bends, small deflections beside it.
fn bent(result: &Value) -> PageTable {
    let columns = [
        ("alpha_deg", "alpha (deg)"),
        ("elevator_deg", "elevator (deg)"),
        ("tip_deflection_m", "tip (m)"),
        ("spread_m", "tip to tip (m)"),
        ("right_root_Mx_Nm", "right root Mx (N m)"),
    ];
    let mut head = vec!["model", "state", "load factor"];
    head.extend(columns.iter().flat_map(|(_, words)| [*words, "small deflections"]));
    let mut table =
        PageTable::new("Loads act at the places of the bent aircraft; the time histories are linear.", &head);
    for model in ["initial", "updated"] {
        for point in list(result, &format!("large_deflections/{model}")) {
            let name = text(point, "name").replace('_', "-");
            let mut row = vec![model.to_owned(), name, short_at(point, "load_factor")];
            for (key, _) in columns {
                row.extend(["large", "linear"].map(|which| short_at(point, &format!("{which}/{key}"))));
            }
            table.row(row);
        }
    }
    table
}

fn steady(result: &Value) -> PageTable {
    let head = [
        "state",
        "V (m/s)",
        "load factor",
        "alpha initial (deg)",
        "updated",
        "elevator initial (deg)",
        "updated",
        "tip initial (m)",
        "updated",
    ];
    let mut table = PageTable::new("", &head);
    for (key, name) in [("trim", "trim"), ("pull_up", "pull-up"), ("push_down", "push-down")] {
        let of = |model: &str, what: &str| short(at(result, &format!("models/{model}/{key}/{what}")));
        let mut row = vec![name.to_owned(), of("initial", "V_m_s"), of("initial", "load_factor")];
        for what in ["alpha_deg", "elevator_deg", "tip_deflection_m"] {
            row.extend(["initial", "updated"].map(|model| of(model, what)));
        }
        table.row(row);
    }
    table
}

fn peaks(result: &Value) -> PageTable {
    let mut table =
        PageTable::new("Largest values in time.", &["maneuver", "quantity", "initial", "updated"]);
    for maneuver in ["doublet", "chirp", "gust"] {
        let of = |model: &str| &result["models"][model][maneuver];
        for (name, value) in of("initial").as_object().into_iter().flatten() {
            let quantity = with_unit(name.trim_start_matches("peak_"));
            table.row([
                maneuver.to_owned(),
                quantity,
                short(value.as_f64()),
                short(of("updated")[name.as_str()].as_f64()),
            ]);
        }
    }
    table
}

fn derivatives(result: &Value) -> PageTable {
    let caption = "Stability and control derivatives of the free flexible aircraft (unrestrained), per radian or per unit rate.";
    let head = [
        "variable",
        "CL initial",
        "updated",
        "Cm initial",
        "updated",
        "Cl initial",
        "updated",
        "Cn initial",
        "updated",
    ];
    let mut table = PageTable::new(caption, &head);
    let of = |model: &str| list(result, &format!("derivatives/{model}/derivatives"));
    for (initial, updated) in of("initial").iter().zip(of("updated")) {
        let mut row = vec![text(initial, "variable").to_owned()];
        for coefficient in ["CL", "Cm", "Cl", "Cn"] {
            let path = format!("unrestrained/{coefficient}");
            row.extend([initial, updated].map(|model| decimals_at(model, &path)));
        }
        table.row(row);
    }
    table
}

pub(super) fn cases(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let envelope = list(result, "envelope");
    let mut columns: Vec<Column> = vec![
        ("model", "model", word),
        ("load", "load", |extreme, key| with_unit(text(extreme, key))),
        ("end", "end", word),
        ("value", "value", short_at),
    ];
    if envelope.iter().any(|extreme| extreme.get("interval_90").is_some()) {
        columns.push(("90 % interval", "interval_90", |extreme, key| {
            let [low, high] = [0, 1].map(|end| at(extreme, &format!("{key}/{end}")));
            low.and(high).map_or_else(String::new, |_| format!("{} to {}", short(low), short(high)))
        }));
    }
    columns.push(("case", "flown", |extreme, key| text(extreme, key).replace('_', " ")));
    let at_root = envelope.iter().filter(|extreme| text(extreme, "station") == "right root");
    let table = table_of("Smallest and largest loads of all cases at the right root.", at_root, &columns);
    let most = |model: &str| {
        let of_model = |e: &&Value| {
            text(e, "model") == model && text(e, "station") == "right root" && text(e, "load") == "Mx_Nm"
        };
        envelope.iter().filter(of_model).filter_map(|e| at(e, "value")).map(f64::abs).reduce(f64::max)
    };
    let count = short_at(result, "cases");
    Page {
        title: format!("Load envelope: {}", text(result, "name")),
        lead: vec![format!(
            "{count} flown cases of both models over a grid of airspeeds, load factors and maneuvers; {} refused.",
            list(result, "refused").len()
        )],
        numbers: vec![
            KeyNumber::new(
                "largest root bending",
                from_to(most("initial"), most("updated"), "N m"),
                "initial to updated model",
            ),
            KeyNumber::new("cases", count, counted(envelope.len(), "extreme value", "extreme values")),
        ],
        sections: vec![
            figures("Envelope", std::mem::take(plates)),
            Section::new("At the root", vec![Block::Table(table)]),
        ],
        ..Page::default()
    }
}
