//! `fullaircraft` with large deflections as a user runs it.

use crate::own_wing::OwnWing;
use serde_json::Value;

#[test]
fn steady_points_of_the_bent_aircraft_stand_beside_those_of_small_deflections() {
    if !crate::slow::runs("flies all maneuvers and trims the bent aircraft of both models") {
        return;
    }
    let own = OwnWing::calibrated_with("large", "empty.ron", "");
    own.finishes(&["fullaircraft", "--nonlinear", "--no-intervals", "--out", "large"]);
    let result: Value = serde_json::from_str(&own.read("large/result.json")).expect("JSON");
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap_or_else(|| panic!("{key} in {value}"));
    for model in ["initial", "updated"] {
        let points = result["large_deflections"][model].as_array().expect("points");
        let names: Vec<&Value> = points.iter().map(|point| &point["name"]).collect();
        assert_eq!(names, ["trim", "pull_up", "push_down"], "{model}");
        for point in points {
            assert!(
                number(point, "force_left_over") < 1e-8 && number(point, "moment_left_over") < 1e-8,
                "{point}"
            );
            let name = point["name"].as_str().expect("a name");
            // What stands beside is the linear point of the same model.
            let linear = number(&result["models"][model][name], "tip_deflection_m");
            assert!((number(&point["linear"], "tip_deflection_m") - linear).abs() < 1e-9, "{point}");
            let (large, tip) = (&point["large"], number(&point["large"], "tip_deflection_m"));
            assert!((tip / linear - 1.0).abs() < 0.1, "tip {tip} for {linear}");
            // Pressed down, a wing with dihedral becomes flatter, and wider.
            let nearer = number(large, "spread_m") < number(&point["linear"], "spread_m");
            assert_eq!(nearer, name != "push_down", "{point}");
        }
    }
    assert!(own.read("large/report.html").contains("Large deflections"), "the page has its table");
    // Without the option nothing of it is there.
    own.finishes(&["fullaircraft", "--no-intervals", "--out", "small"]);
    let result: Value = serde_json::from_str(&own.read("small/result.json")).expect("JSON");
    assert!(result.get("large_deflections").is_none());
}
