//! The verdict says no more than the gaps show; a result is read with keys that are not known.

use discover::result::DiscoverResult;
use discover::verdict::{Gap, Judgement, VerdictKind};
use std::path::Path;

fn gap(before: f64, after: f64, floor: f64) -> Gap {
    Gap { before, after, floor }
}

/// Stall named, gaps closed.
fn closed() -> Judgement<'static> {
    Judgement {
        closed: 2.0,
        names: vec!["stall"],
        ambiguous: false,
        unexplained: false,
        nearest: None,
        training: gap(4.0, 1.4, 1.2),
        held_out: Some(gap(5.0, 2.0, 1.3)),
    }
}

#[test]
fn the_kind_follows_from_names_rivals_and_the_training_gap() {
    let nothing = Judgement { names: Vec::new(), training: gap(1.3, 1.3, 1.2), ..closed() };
    assert_eq!(closed().kind(), VerdictKind::Effects);
    assert_eq!(Judgement { ambiguous: true, ..closed() }.kind(), VerdictKind::Ambiguous);
    assert_eq!(nothing.kind(), VerdictKind::None);
    assert_eq!(Judgement { unexplained: true, ..nothing.clone() }.kind(), VerdictKind::Unknown);
    // a gap far above the floor is never none
    assert_eq!(Judgement { training: gap(2.5, 2.5, 1.2), ..nothing }.kind(), VerdictKind::Unknown);
}

#[test]
fn what_does_not_shrink_the_training_gap_is_named_by_no_verdict() {
    for (training, ambiguous) in [(gap(3.8, 6.9, 1.2), false), (gap(3.8, 3.8, 1.2), true)] {
        let worse = Judgement { training, ambiguous, ..closed() };
        assert_eq!(worse.kind(), VerdictKind::Unknown);
        assert!(!worse.is_supported() && !worse.is_success());
        let said = worse.sentence();
        assert!(said.contains("does not shrink (3.8 -> ") && said.contains("Nothing is named"), "{said}");
        assert!(!said.contains("closed"), "{said}");
    }
}

#[test]
fn success_is_claimed_of_held_out_data_alone() {
    assert!(closed().is_success() && closed().sentence().contains("from 5.0 to 2.0; it closed"));
    for held_out in [None, Some(gap(5.0, 4.0, 1.3)), Some(gap(5.0, 6.0, 1.3))] {
        let judgement = Judgement { held_out, ..closed() };
        let said = judgement.sentence();
        assert!(!judgement.is_success(), "{said}");
        assert!(said.contains("no success is claimed") && !said.contains("closed:"), "{said}");
    }
}

#[test]
fn a_gap_far_above_the_floor_does_not_read_as_if_all_were_fine() {
    let nothing = Judgement { names: Vec::new(), training: gap(13.2, 13.2, 2.4), ..closed() };
    assert!(nothing.sentence().starts_with("Something is missing"));
    let more = Judgement { training: gap(56.0, 55.0, 7.7), held_out: None, ..closed() }.sentence();
    assert!(more.contains("More is missing"), "{more}");
    let fine = Judgement { names: Vec::new(), training: gap(1.3, 1.3, 1.2), ..closed() }.sentence();
    assert!(fine.starts_with("No effect is missing beyond the detection limits"), "{fine}");
}

#[test]
fn a_result_is_read_with_more_keys_than_are_known_and_written_back() {
    let text = r#"{ "command": "discover", "verdict": "effects", "of_a_later_version": 1,
        "located": [ {"channel":"My_Nm","regressor":"alpha_ddot","share_of_residual":0.78,"p_value":1e-12,"where":"pitch"} ],
        "effects": [ {"name":"joiner_inertia","confidence":0.98,"confused_with":["added_mass"],
                      "parameters":{"Iyy_kg_m2":{"value":0.011,"sigma":0.0004}}} ],
        "next_experiment": "wind-off pitch",
        "gap": {"training":{"before":41.2,"after":11.0,"floor":9.8},
                "holdout":{"before":39.0,"after":12.1,"floor":null,
                           "by_channel":{"before":{"Fz_N":1.0,"Mx_Nm":2.0,"My_Nm":null},
                                         "after":{"Fz_N":1.0,"Mx_Nm":2.0,"My_Nm":null}}}} }"#;
    let read = |text: &str| DiscoverResult::from_json(text, Path::new("result.json"));
    let result = read(text).expect("a result");
    assert_eq!(result.set(), ["joiner_inertia", "added_mass"]);
    let gap = result.gap().expect("gaps");
    assert!(gap.holdout.after == 12.1 && gap.holdout.floor.is_nan());
    assert_eq!(gap.holdout.by_channel.expect("loads").before.to_array(), [Some(1.0), Some(2.0), None]);
    let search = result.search.as_ref().expect("a search");
    assert_eq!(search.located[0].place, "pitch");
    let again = read(&serde_json::to_string(&result).expect("text")).expect("the same");
    assert_eq!((again.effects, again.verdict), (result.effects.clone(), result.verdict));
    assert!(read("{}").is_err());
}
