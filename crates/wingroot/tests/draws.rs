//! Intervals of the load envelope: the updated model's cases flown with every wing of the ensemble, the envelope taken draw by draw; in one
//! process and in parts.

use crate::own_wing::OwnWing;
use crate::result_files::files;
use crate::segments::told;
use serde_json::Value;

const CASES: &str = r#"Cases(
    name: "a few trims",
    airspeeds_V_m_s: [18.0, 24.0],
    load_factors: [-1.0, 2.5],
    maneuvers: [Level, Pull, Roll(control: "aileron", rates_deg_s: [30.0])],
)
"#;
/// The standard Gaussian's 95 % quantile (Abramowitz and Stegun, table 26.5: 1.64485 36270).
pub(crate) const QUANTILE_95: f64 = 1.644_853_627_0;

fn own_wing(name: &str) -> OwnWing {
    OwnWing::calibrated_with(&format!("draws-{name}"), "cases.ron", CASES)
}

fn result(own: &OwnWing, out: &str) -> Value {
    serde_json::from_str(&own.read(&format!("{out}/result.json"))).expect("JSON")
}

/// Ends of a load at a station over cases, each as the store has it.
fn end(cases: &[&Value], station: &str, load: &str, is_largest: bool) -> f64 {
    let of = |case: &&Value| {
        let loads = case["loads"].as_array().expect("loads").iter();
        let place = loads.clone().find(|place| place["station"] == station).expect("the station");
        place[load][usize::from(is_largest)].as_f64().expect("a load")
    };
    let all = cases.iter().map(of);
    if is_largest { all.fold(f64::NEG_INFINITY, f64::max) } else { all.fold(f64::INFINITY, f64::min) }
}

#[test]
fn intervals_of_the_envelope_are_of_envelopes_taken_draw_by_draw() {
    let own = own_wing("envelope");
    let cases = ["fullaircraft", "--cases", "cases.ron", "--out", "parts"];
    let with = |more: &[&'static str]| [&cases[..], more].concat();
    let merge = |more: &[&'static str]| [&["merge"], &with(more)[..]].concat();
    own.finishes(&with(&["--part", "2/2"]));
    own.finishes(&with(&["--part", "1/2"]));
    own.finishes(&merge(&[]));
    let other = own.run(&merge(&["--no-intervals"]));
    let said = String::from_utf8_lossy(&other.stderr);
    assert!(other.status.code() == Some(2) && said.contains("another state of: ensemble"), "{said}");

    // the store names draws; envelopes and intervals by hand
    let stored = told(&own.path(".parts.finished"));
    let flown = |what: &str| -> Vec<&Value> {
        stored.iter().filter(|(part, _)| part.starts_with(what)).map(|(_, case)| case).collect()
    };
    let draws: Vec<Vec<&Value>> = (1..=8).map(|draw| flown(&format!("draw {draw} "))).collect();
    assert!(draws.iter().all(|draw| draw.len() == flown("1 ").len() && !draw.is_empty()), "{}", stored.len());
    let result = result(&own, "parts");
    let envelope = result["envelope"].as_array().expect("an envelope");
    let mut wide = 0;
    for extreme in envelope {
        let interval = &extreme["interval_90"];
        if extreme["model"] == "initial" {
            assert!(interval.is_null(), "the initial model is what it is: {extreme}");
            continue;
        }
        let text = |key: &str| extreme[key].as_str().expect("words");
        let of = |cases: &[&Value]| end(cases, text("station"), text("load"), text("end") == "largest");
        let value = of(&flown("1 "));
        assert_eq!(extreme["value"].as_f64(), Some(value));
        let squares: f64 = draws.iter().map(|draw| (of(draw) - value).powi(2)).sum();
        let half = QUANTILE_95 * (squares / draws.len() as f64).sqrt();
        for (place, sign) in [(0, -1.0), (1, 1.0)] {
            let found = interval[place].as_f64().expect("an end");
            assert!((found - value - sign * half).abs() < 1e-8 * (value.abs() + half), "{extreme}: {half}");
        }
        wide += usize::from(half > 1e-3 * value.abs());
    }
    assert!(wide > envelope.len() / 4, "draws differ: {wide} of {}", envelope.len());
    let csv = own.read("parts/envelope.csv");
    assert!(csv.starts_with("model,station,load,end,value,case,flown,low_90,high_90\n"), "{csv}");
}

#[test]
fn draws_in_parts_give_the_bytes_of_one_process_and_leave_the_envelope_itself_as_it_is() {
    if !crate::slow::runs("flies a grid with nine wings, in one process and in parts") {
        return;
    }
    let own = own_wing("bytes");
    let with = |more: &[&'static str]| [&["fullaircraft", "--cases", "cases.ron"], more].concat();
    own.finishes(&with(&["--out", "whole"]));
    own.finishes(&[&["prepare"], &with(&["--out", "parts"])[..]].concat());
    for part in ["2/3", "1/3", "3/3"] {
        own.finishes(&with(&["--out", "parts", "--part", part]));
    }
    own.finishes(&[&["merge"], &with(&["--out", "parts"])[..]].concat());
    assert!(files(&own.path("parts")) == files(&own.path("whole")), "the bytes of one process");
    own.finishes(&with(&["--no-intervals", "--out", "alone"]));
    let (alone, result) = (result(&own, "alone"), result(&own, "whole"));
    assert!(alone.get("intervals_from").is_none() && result["intervals_from"].is_string());
    let [alone, with_draws] = [&alone, &result].map(|all| all["envelope"].as_array().expect("an envelope"));
    for (a, b) in alone.iter().zip(with_draws) {
        assert!(
            a.get("interval_90").is_none() && a["value"] == b["value"] && a["case"] == b["case"],
            "{a} {b}"
        );
    }
}

#[test]
fn a_draw_in_a_grid_of_cases_is_trimmed_as_the_same_wing_in_the_maneuvers_of_the_aircraft() {
    if !crate::slow::runs("flies all maneuvers with the nine wings") {
        return;
    }
    let own = own_wing("trim");
    own.finishes(&["fullaircraft", "--out", "maneuvers"]);
    let maneuvers = result(&own, "maneuvers");
    let trim = &maneuvers["models"]["updated"]["trim"];
    let cases = format!(
        "Cases(name: \"one\", airspeeds_V_m_s: [{:?}], load_factors: [1.0], maneuvers: [Level])",
        trim["V_m_s"].as_f64().expect("an airspeed")
    );
    std::fs::write(own.path("cases.ron"), cases).expect("a file of our own");
    own.finishes(&["fullaircraft", "--cases", "cases.ron", "--out", "one", "--part", "1/2"]);
    own.finishes(&["fullaircraft", "--cases", "cases.ron", "--out", "one", "--part", "2/2"]);
    let stored = told(&own.path(".one.finished"));
    let alpha = |what: &str| -> Vec<f64> {
        let own = stored.iter().filter(|(part, _)| part.starts_with(what));
        own.map(|(_, case)| case["values"]["alpha_deg"].as_f64().expect("an angle")).collect()
    };
    let (value, draws) = (alpha("1 ")[0], alpha("draw "));
    assert_eq!(draws.len(), 8);
    let squares: f64 = draws.iter().map(|draw| (draw - value).powi(2)).sum();
    let half = QUANTILE_95 * (squares / 8.0).sqrt();
    let interval = &maneuvers["intervals_90"]["of_updated"]["model"]["trim"]["alpha_deg"];
    let found = interval[1].as_f64().expect("an end") - trim["alpha_deg"].as_f64().expect("an angle");
    assert!((found - half).abs() < 1e-6 * half, "{found} beside {half}");
}
