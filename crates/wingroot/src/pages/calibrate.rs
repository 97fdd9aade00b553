//! The page of `calibrate`.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::plates::{figures, taken};
use super::values::{Column, LOADS, at, counted, digits, from_to, list, short_at, table_of, text, word};

pub(super) fn page(result: &Value, plates: &mut Vec<Plate>) -> Page {
    let airspeeds = list(result, "airspeeds");
    let mut sections = vec![figures("Root loads", taken(plates, "static_loads"))];
    sections.push(figures("The bent wing", taken(plates, "wing_shapes")));
    sections.push(figures("What is left", taken(plates, "residuals")));
    sections.push(Section::new("The fit at each airspeed", vec![Block::Table(fits(airspeeds))]));
    let mut determined = vec![Block::Text(determined_text(airspeeds))];
    determined.push(Block::Table(determined_table(airspeeds)));
    determined.extend(figures("", taken(plates, "singular_values")).blocks);
    sections.push(Section::new("What the data determine", determined));
    let mut predicted = figures("", taken(plates, "predicted_lift")).blocks;
    if let Some(at) = list(result, "predictions").last() {
        predicted.push(Block::Table(predictions(at)));
    }
    if !predicted.is_empty() {
        sections.push(Section::new("What the corrected wing predicts, and how well it is known", predicted));
    }
    let mut maps = vec![Block::Text(
        "Seen from above, flight direction up. A factor of one and an offset of zero, the middle of the colours, are theory; a \
         colour means the same at all airspeeds. Of all corrections that meet the data these change the pressures least, so what \
         the data do not determine is the program's choice. Rest the pointer on a box to read its value."
            .into(),
    )];
    maps.extend(taken(plates, "corrections_").into_iter().map(|plate| Block::Plate(Box::new(plate))));
    if maps.len() > 1 {
        sections.push(Section::new("Corrections on the planform", maps));
    }
    sections.retain(|section| !section.blocks.is_empty());
    Page {
        title: format!("Corrections of the panel model: {}", text(result, "campaign")),
        lead: lead(result, airspeeds),
        numbers: numbers(result, airspeeds),
        sections,
        ..Page::default()
    }
}

fn lead(result: &Value, airspeeds: &[Value]) -> Vec<String> {
    if let Some(common) = result.get("common") {
        return vec![format!(
            "One set of corrections for all airspeeds brings the misfit from {} to {}; a free curve through the readings \
             leaves {}.",
            short_at(common, "objective_before"),
            short_at(common, "objective_after"),
            short_at(common, "curve_floor")
        )];
    }
    let speeds: Vec<f64> = airspeeds.iter().filter_map(|a| at(a, "V_m_s")).collect();
    let (Some(slow), Some(fast)) = (speeds.first(), speeds.last()) else { return Vec::new() };
    let ended = |ending: &str| airspeeds.iter().filter(|a| text(a, "ending") == ending).count();
    let bent: usize = airspeeds
        .iter()
        .flat_map(|a| list(a, "nonlinearity"))
        .filter(|test| test["significant"] == true)
        .count();
    let speeds = format!(
        "{} from {} to {} m/s",
        counted(speeds.len(), "airspeed", "airspeeds"),
        digits(*slow, 3),
        digits(*fast, 3)
    );
    let mut lead = vec![match (ended("PosteriorMean"), ended("Converged")) {
        (0, reached) => format!(
            "At {reached} of {speeds} the corrected model reaches the measured root loads as closely as a straight line over \
             the angle of attack does; no model that is linear in the angle can come nearer."
        ),
        (means, _) => format!(
            "At {means} of {speeds} more than root loads was measured. Corrections there are those that all measurements and the prior \
             leave most likely, with the root loads met by the structure as given."
        ),
    }];
    if bent > 0 {
        lead.push(format!(
            "{bent} of the measured curves are bent beyond chance: no correction of a linear model follows that."
        ));
    }
    lead
}

fn numbers(result: &Value, airspeeds: &[Value]) -> Vec<KeyNumber> {
    let sets: Vec<&Value> = match result.get("common") {
        Some(common) => vec![common],
        None => airspeeds.iter().collect(),
    };
    let worst = |path: &str| {
        sets.iter()
            .filter_map(|set| at(set, path))
            .fold(None, |most: Option<f64>, v| Some(most.map_or(v, |m| m.max(v))))
    };
    let mut numbers = Vec::new();
    for (key, name, unit) in LOADS.into_iter().chain([("tip_z_m", "tip deflection", "m")]) {
        let (before, after) = (worst(&format!("rmse_before/{key}")), worst(&format!("rmse_after/{key}")));
        if let (Some(was), Some(is)) = (before, after) {
            let note = "rms error, initial to updated; worst airspeed";
            numbers.push(KeyNumber::new(name, from_to(before, after, unit), note).judged(is < was));
        }
    }
    let (before, after) = (worst("left_out/objective_before"), worst("left_out/objective_after"));
    if let (Some(was), Some(is)) = (before, after) {
        let note = "misfit F at the end angles when they were left out of the fit";
        numbers.push(
            KeyNumber::new("prediction of unseen angles", from_to(before, after, ""), note).judged(is < was),
        );
    }
    if let Some(determined) = worst("determined_directions") {
        let note = "combinations of corrections that the data fix; the rest is the least change of pressure that goes with them";
        numbers.push(KeyNumber::new("directions determined", digits(determined, 3), note));
    }
    if let Some(lift) = result.pointer("/common/lift_factor").filter(|lift| !lift.is_null()) {
        let value = format!("{} \u{b1} {}", short_at(lift, "value"), short_at(lift, "sigma"));
        numbers.push(KeyNumber::new(
            "uniform factor on lift",
            value,
            "one factor for all boxes, with its standard error",
        ));
    }
    numbers.extend(both_geometries(result));
    numbers
}

/// Where deflections are large: how the factor on lift changes up to the largest one, and how it would with small ones.
fn both_geometries(result: &Value) -> Option<KeyNumber> {
    let [small, ..] = list(result, "lift_factors_with_small_deflections") else { return None };
    let large =
        result.pointer("/common/lift_factor").or_else(|| result.pointer("/airspeeds/0/lift_factor"))?;
    let change = |lift: &Value| {
        let of = |key: &str| short_at(lift, &format!("change_up_to_largest_deflection/{key}"));
        format!("{} \u{b1} {}", of("value"), of("sigma"))
    };
    let note = "change of the factor on lift up to the largest deflection: large deflections, and in brackets what small ones would ask for";
    Some(KeyNumber::new("trend of the lift", format!("{} ({})", change(large), change(small)), note))
}

fn fits(airspeeds: &[Value]) -> PageTable {
    let caption = "F: root mean square misfit over the measured loads, weighted (N). Line floor: misfit of the best \
                   straight line over the angle (of a wing that bends far: through what it misses). Noise floor: what noise alone gives.";
    let columns: [Column; 11] = [
        ("V (m/s)", "V_m_s", short_at),
        ("F before", "objective_before", short_at),
        ("F after", "objective_after", short_at),
        ("line floor", "line_floor", short_at),
        ("noise floor", "noise_floor", short_at),
        ("Fz rms (N)", "rmse_after/Fz_N", short_at),
        ("Mx rms (N m)", "rmse_after/Mx_Nm", short_at),
        ("My rms (N m)", "rmse_after/My_Nm", short_at),
        ("left out: before", "left_out/objective_before", short_at),
        ("after", "left_out/objective_after", short_at),
        ("ending", "ending", word),
    ];
    table_of(caption, airspeeds, &columns)
}

/// Sections, tip and controls at the highest airspeed.
fn predictions(airspeed: &Value) -> PageTable {
    let caption = format!(
        "At {} m/s and {} degrees, the highest airspeed and angle that were measured: 90 % intervals. Decided by data: the share of \
         what was uncertain before the data that they took away; near zero, the interval is what panel models are usually off by.",
        short_at(airspeed, "V_m_s"),
        short_at(airspeed, "alpha_deg")
    );
    let shown: Vec<Value> = list(airspeed, "predictions")
        .iter()
        .filter(|p| text(p, "quantity") != "strip_lift")
        .cloned()
        .collect();
    let columns: [Column; 9] = [
        ("quantity", "quantity", |value, key| word(value, key).replace('_', " ")),
        ("control", "control", word),
        ("y over span", "y_over_span", short_at),
        ("theory", "theory", short_at),
        ("updated", "value", short_at),
        ("from", "low", short_at),
        ("to", "high", short_at),
        ("unit", "unit", word),
        ("decided by data", "decided_by_data", short_at),
    ];
    table_of(&caption, &shown, &columns)
}

fn determined_text(airspeeds: &[Value]) -> String {
    let mut open: Vec<&str> = airspeeds
        .iter()
        .flat_map(|a| list(a, "identifiability/undetermined"))
        .filter_map(Value::as_str)
        .collect();
    open.sort_unstable();
    open.dedup();
    let families = if open.is_empty() {
        String::new()
    } else {
        format!(
            " Root loads hardly hang on these: {}. They are not determined, and what their maps show is the least change of \
             pressure that goes with the others.",
            open.join(", ").replace('_', " ")
        )
    };
    format!(
        "Root loads over the angle of attack are six straight-line numbers an airspeed, so they fix six combinations of the \
         corrections at most. The remaining spread is the share of the freedom before the data that is left after them: near \
         one means the data say nothing.{families}"
    )
}

fn determined_table(airspeeds: &[Value]) -> PageTable {
    let columns: [Column; 9] = [
        ("V (m/s)", "V_m_s", short_at),
        ("directions", "determined_directions", short_at),
        ("spread left: force", "identifiability/remaining_spread/force", short_at),
        ("moment", "identifiability/remaining_spread/moment", short_at),
        ("offset", "identifiability/remaining_spread/pressure_offset", short_at),
        ("sigma: force", "identifiability/posterior_sigma/force", short_at),
        ("moment", "identifiability/posterior_sigma/moment", short_at),
        ("offset", "identifiability/posterior_sigma/pressure_offset", short_at),
        ("neighbour bounds active", "neighbour_bound_active", short_at),
    ];
    table_of("", airspeeds, &columns)
}
