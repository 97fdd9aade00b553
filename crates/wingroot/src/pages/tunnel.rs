//! The page of `tunnel`: what the virtual wind tunnel wrote, and how far the uncorrected model is from what it hides.

use report::Page;
use report::page::{Block, KeyNumber, PageTable, Plate, Section};
use serde_json::Value;

use super::values::{Column, LOADS, at, from_to, list, short, short_at, table_of, text, whole_at, word};

pub(super) fn page(result: &Value, _: &mut Vec<Plate>) -> Page {
    let compared = list(result, "truth_and_model");
    let worst = |key: &str| {
        compared
            .iter()
            .filter_map(|row| at(row, &format!("{key}/relative_error")))
            .map(f64::abs)
            .reduce(f64::max)
    };
    let mut numbers =
        vec![KeyNumber::new("static points", short_at(result, "static_rows"), "rows of static.csv")];
    for (key, name, _) in LOADS {
        let error = worst(key).map(|error| 100.0 * error);
        numbers.push(KeyNumber::new(
            format!("{name}, uncorrected model"),
            format!("{} %", short(error)),
            "largest error over the airspeeds, beside what the tunnel hides",
        ));
    }
    Page {
        title: format!("Virtual wind tunnel: {}", text(result, "campaign")),
        lead: vec![
            "These are not measurements. A virtual wind tunnel with a model of its own made them; the campaign's README says \
             what it hides."
                .into(),
            format!("Drawn with seed {}.", whole_at(result, "seed")),
        ],
        numbers,
        sections: vec![
            Section::new("The uncorrected model beside the truth", vec![Block::Table(errors(compared))]),
            Section::new("What calibration makes of it", vec![Block::Table(fits(list(result, "calibration")))]),
            Section::new("The half wing in flight", vec![Block::Table(flight(result))]),
        ],
        ..Page::default()
    }
}

fn errors(compared: &[Value]) -> PageTable {
    let mut table = PageTable::new(
        "The truth, then the model: load at zero degrees, and slope. The error is the rms difference in parts of the rms load.",
        &["V (m/s)", "load", "offset (N, N m)", "slope (N, N m a degree)", "error (%)"],
    );
    for row in compared {
        for (key, name, _) in LOADS {
            let of = |what: &str| {
                let [truth, model] = [0, 1].map(|which| at(row, &format!("{key}/{what}/{which}")));
                from_to(truth, model, "")
            };
            let error = at(row, &format!("{key}/relative_error")).map(|error| 100.0 * error);
            table.row([
                short_at(row, "V_m_s"),
                name.to_owned(),
                of("offset"),
                of("slope_per_deg"),
                short(error),
            ]);
        }
    }
    table
}

fn fits(found: &[Value]) -> PageTable {
    let caption =
        "The objective is what is left of the loads; a straight line over the angle leaves the last column.";
    let columns: [Column; 6] = [
        ("V (m/s)", "V_m_s", short_at),
        ("objective before", "objective_before", short_at),
        ("after", "objective_after", short_at),
        ("straight line", "line_floor", short_at),
        ("cone programs", "iterations", short_at),
        ("ending", "ending", word),
    ];
    table_of(caption, found, &columns)
}

fn flight(result: &Value) -> PageTable {
    let mut table = PageTable::new(
        "Without corrections, then with those of the highest airspeed.",
        &["state", "angle of attack (deg)", "tip (m)"],
    );
    for (key, name) in [("trim", "trim"), ("pull_up", "pull-up"), ("push_down", "push-down")] {
        let both = |what: &str| {
            let of = |model: usize| {
                at(result, &format!("half_wing_uncorrected_and_corrected/{key}/{model}/{what}"))
            };
            from_to(of(0), of(1), "")
        };
        table.row([name.to_owned(), both("alpha_deg"), both("tip_deflection_m")]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_page_says_that_these_are_no_measurements_and_how_far_the_model_is_off() {
        let channel = |error: f64| json!({ "offset": [30.0, 20.0], "slope_per_deg": [7.5, 7.25], "relative_error": error });
        let result = json!({
            "campaign": "<b>mine</b>", "seed": 7, "static_rows": 90,
            "truth_and_model": [
                { "V_m_s": 18.0, "Fz_N": channel(0.1), "Mx_Nm": channel(-0.25), "My_Nm": channel(0.0) },
            ],
            "calibration": [{ "V_m_s": 18.0, "objective_before": 3.0, "objective_after": 0.5, "line_floor": 0.5,
                "iterations": 3, "ending": "Converged" }],
            "half_wing_uncorrected_and_corrected": {
                "trim": [{ "alpha_deg": 2.2, "tip_deflection_m": 0.1 }, { "alpha_deg": 1.9, "tip_deflection_m": 0.08 }],
            },
        });
        let page = page(&result, &mut Vec::new());
        assert!(page.lead[0].contains("not measurements") && page.lead[1].contains("seed 7."));
        assert_eq!(page.numbers[2].value, "25 %");
        let html = page.html().unwrap();
        assert!(html.contains("&lt;b&gt;mine") && !html.contains("<b>mine"));
        assert!(html.contains("2.20 \u{2192} 1.90"), "the trim of both models");
        assert!(html.contains("7.50 \u{2192} 7.25"), "the slope of truth and model");
    }
}
