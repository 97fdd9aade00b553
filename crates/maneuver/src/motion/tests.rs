//! Motions in files, what is wrong with them, and what can be read from a record.

use super::*;
use schemars::JsonSchema;
use serde_json::{Value, from_value, json};

type Refused = serde::de::value::Error;

fn doublet(height: f64, frequency_hz: f64, start_s: f64) -> Doublet {
    Doublet { height, frequency_hz, start_s }
}

#[test]
fn a_motion_moves_what_it_names_and_nothing_else() {
    let spec = MotionSpec::new("inner", doublet(0.1, 2.0, 0.5));
    assert_eq!((spec.control(), spec.moves("inner"), spec.moves("outer")), (Some("inner"), true, false));
    assert_eq!((spec.at("inner", 0.6), spec.at("inner", 0.9), spec.at("outer", 0.6)), (0.1, -0.1, 0.0));
    assert_eq!((spec.end_s(), spec.record_s(), spec.shape.name()), (1.0, 1.0, "Doublet"));
    assert_eq!(MotionSpec { duration_s: Some(3.0), ..spec.clone() }.record_s(), 3.0);
    assert_eq!(spec.with_height(0.25).at("inner", 0.6), 0.25);
    let angle = MotionSpec::new(ANGLE, Step { height: 0.2, start_s: 0.5 });
    assert_eq!((angle.control(), angle.moves(ANGLE), angle.at(ANGLE, 1.0)), (None, true, 0.2));
    assert_eq!((angle.kind().words(), angle.kind().jumps(), angle.end_s()), ("step", true, 0.5));
    assert_eq!(MotionSpec { of: None, ..angle }.control(), None);
    assert!((tidy_degrees(15.3_f64.to_radians()) - 15.3).abs() == 0.0 && tidy_degrees(-0.1) < -5.7);
}

#[test]
fn the_first_number_that_cannot_be_is_named() {
    let field = |spec: &MotionSpec| spec.fault(200.0).map(|fault| fault.field);
    let of = |degrees: f64, hz: f64, start_s: f64| {
        field(&MotionSpec::new("inner", doublet(degrees.to_radians(), hz, start_s)))
    };
    assert_eq!((of(15.0, 1.0, 0.0), of(-90.0, 100.0, 5.0), of(90.0, 1e-3, 0.0)), (None, None, None));
    for start_s in [-0.1, f64::INFINITY, f64::NAN] {
        assert_eq!(of(15.0, 1.0, start_s), Some("start_s"), "{start_s}");
    }
    for degrees in [90.1, -90.1, f64::NAN] {
        assert_eq!(of(degrees, 1.0, 0.0), Some("height_deg"), "{degrees}");
    }
    for hz in [0.0, -1.0, f64::INFINITY, f64::NAN, 100.1] {
        assert_eq!(of(15.0, hz, 0.0), Some("frequency_hz"), "{hz}");
    }
    let fault = MotionSpec::new("inner", doublet(0.1, 120.0, 0.0)).fault(200.0).expect("too fast");
    assert!(fault.message.contains("0 to 100 Hz"), "{}", fault.message);
    assert_eq!(field(&MotionSpec::new("inner", Step { height: 0.1, start_s: 0.0 })), None);
    let chirp = |from_hz: f64, to_hz: f64, duration_s: f64| {
        field(&MotionSpec::new("inner", Chirp { height: 0.1, from_hz, to_hz, duration_s, start_s: 0.0 }))
    };
    assert_eq!((chirp(0.0, 100.0, 1.0), chirp(0.0, 100.0, 0.0)), (None, Some("duration_s")));
    assert!(chirp(-1.0, 10.0, 1.0).is_some() && chirp(1.0, 100.5, 1.0).is_some());
}

#[test]
fn a_motion_in_a_file_has_its_fields_what_moves_and_nothing_else() {
    let read = |value: Value| from_value::<MotionSpec>(json!({ "Doublet": value }));
    let wanted = MotionSpec::new("inner", doublet(15.0_f64.to_radians(), 2.0, 0.5));
    for (height, of) in [("height_deg", "of"), ("deflection_deg", "control"), ("amplitude_deg", "of")] {
        let found = read(json!({ height: 15.0, of: "inner", "frequency_hz": 2.0, "start_s": 0.5 }));
        assert_eq!(found.expect("fields of the kind"), wanted);
    }
    let refused = |value: Value, says: &str| {
        let error = read(value).expect_err(says).to_string();
        assert!(error.contains(says), "{error}");
    };
    refused(json!({ "height_deg": 15.0, "frequency_hz": 2.0 }), "missing field `of`");
    refused(json!({ "of": "inner", "frequency_hz": 2.0 }), "missing field `height_deg`");
    refused(json!({ "of": "a", "control": "b", "height_deg": 1.0, "frequency_hz": 2.0 }), "unknown field `");
    refused(
        json!({ "of": "a", "height_deg": 1.0, "frequency_hz": 2.0, "color": 3 }),
        "`color`, expected one of",
    );
    refused(json!({ "of": "a", "height_deg": 1.0, "frequency_hz": 2.0, "duration_s": 3.0 }), "`duration_s`");
    let unknown = from_value::<MotionSpec>(json!({ "Dublet": {} })).expect_err("no such kind").to_string();
    assert!(unknown.contains("Dublet") && unknown.contains("Doublet"), "{unknown}");
    let columns = |value: Value| from_value::<MotionSpec>(json!({ "FromFile": value }));
    assert_eq!(columns(json!({ "file": "own.csv" })).expect("columns say what moves").of, None);
    assert!(columns(json!({ "file": "own.csv", "of": "inner" })).is_err());
    assert!(columns(json!({ "file": "own.csv", "deflection_deg": 3.0 })).is_err(), "it has no height");
    // an angle to go to is the angle of attack, counted from the beginning
    let to = json!({ "OneMinusCosine": { "to_deg": 5.0, "frequency_hz": 1.0 } });
    let mut to = from_value::<MotionSpec>(to).expect("no height is needed");
    assert_eq!(to.of.as_deref(), Some(ANGLE));
    to.complete(2.0_f64.to_radians(), std::path::Path::new("nowhere.ron")).expect("nothing beside");
    assert!((tidy_degrees(to.kind().height()) - 3.0).abs() < 1e-9);
    let neither = json!({ "OneMinusCosine": { "of": "inner", "frequency_hz": 1.0 } });
    assert!(from_value::<MotionSpec>(neither).expect_err("no height").to_string().contains("height_deg"));
}

#[test]
fn parts_that_do_not_go_together_are_refused() {
    let parts = |shape: Shape, of: Option<&str>| {
        let of = of.map(str::to_owned);
        MotionSpec::of_parts::<Refused>(shape, Beside { of, duration_s: Some(4.0) })
    };
    let step = |height: f64| Shape::from(Step { height, start_s: 0.0 });
    let found = parts(step(0.1), Some("inner")).expect("a motion");
    assert_eq!((found.control(), found.record_s()), (Some("inner"), 4.0));
    assert!(parts(step(0.1), None).is_err() && parts(step(f64::NAN), Some("inner")).is_err());
    let to = Shape::from(OneMinusCosine { height: f64::NAN, to: Some(0.1), frequency_hz: 1.0, start_s: 0.0 });
    assert_eq!(parts(to.clone(), None).expect("the angle").of.as_deref(), Some(ANGLE));
    assert_eq!(parts(to, Some("inner")).expect("as named").of.as_deref(), Some("inner"));
}

/// What else a file may name.
#[derive(Debug, PartialEq, Deserialize, JsonSchema)]
enum Rest {
    Still { length_s: f64 },
}

impl Others for Rest {
    const NAMES: &'static [&'static str] = &["Still"];
}

#[test]
fn a_record_may_be_a_motion_with_its_length_or_something_else() {
    let read = |value: Value| from_value::<MotionOr<Rest>>(value);
    let fields = json!({ "of": "inner", "height_deg": 15.0, "frequency_hz": 2.0, "duration_s": 3.0 });
    let MotionOr::Motion(motion) = read(json!({ "Doublet": fields })).expect("a motion") else {
        panic!("a motion")
    };
    assert_eq!((motion.duration_s, motion.record_s()), (Some(3.0), 3.0));
    let rest = read(json!({ "Still": { "length_s": 2.5 } })).expect("something else");
    assert_eq!(rest, MotionOr::Other(Rest::Still { length_s: 2.5 }));
    let error = read(json!({ "Stil": {} })).expect_err("neither").to_string();
    assert!(error.contains("Still") && error.contains("Doublet"), "{error}");
    let alone = of_kind::<Doublet, _>(fields.clone()).expect("the fields of a doublet");
    assert_eq!((alone.control(), alone.duration_s, alone.end_s()), (Some("inner"), Some(3.0), 0.5));
    assert!(of_kind::<Step, _>(fields).is_err(), "a step has no frequency");
    let list = of_kind::<Doublet, _>(json!([15.0, 2.0])).expect_err("no fields").to_string();
    assert!(list.contains("expected the fields of a motion"), "{list}");
}

/// The schema of one kind among those of a type, with the number of kinds.
fn schema_of(all: &Value, kind: &str) -> (Value, usize) {
    let each = all["oneOf"].as_array().expect("a list");
    let own = each.iter().find(|one| one["required"] == json!([kind])).expect("the kind");
    assert_eq!((&own["type"], &own["additionalProperties"]), (&json!("object"), &json!(false)));
    (own["properties"][kind].clone(), each.len())
}

#[test]
fn schemas_have_one_height_and_one_name_of_what_moves_where_both_are_needed() {
    let plain = schemars::schema_for!(MotionSpec).to_value();
    let timed = schemars::schema_for!(MotionOr<Rest>).to_value();
    let one_of = |names: &[&str]| {
        let each: Vec<Value> = names.iter().map(|name| json!({ "required": [name] })).collect();
        json!({ "oneOf": each })
    };
    let choices =
        json!([one_of(&["height_deg", "deflection_deg", "amplitude_deg"]), one_of(&["of", "control"])]);
    for (all, kinds, has_length) in [(&plain, KINDS.len(), false), (&timed, KINDS.len() + 1, true)] {
        let (own, count) = schema_of(all, "Doublet");
        assert_eq!(count, kinds);
        assert_eq!((&own["allOf"], &own["required"]), (&choices, &json!(["frequency_hz"])));
        let fields = &own["properties"];
        for height in ["height_deg", "deflection_deg", "amplitude_deg"] {
            assert_eq!(fields[height], fields["height_deg"]);
            assert!(fields[height].is_object());
        }
        assert!(fields["of"]["type"] == "string" && fields["of"] == fields["control"]);
        assert_eq!(fields["duration_s"]["type"] == "number", has_length);
        // where the height may be left out, so may the name
        let (own, _) = schema_of(all, "OneMinusCosine");
        assert!(own.get("allOf").is_none() && own["properties"]["of"].is_object());
        let (own, _) = schema_of(all, "FromFile");
        assert!(own.get("allOf").is_none() && own["properties"].get("of").is_none());
    }
    assert_eq!((&*MotionSpec::schema_name(), &*MotionOr::<Rest>::schema_name()), ("Motion", "MotionOrRest"));
    assert_eq!(&*OfKind::<Doublet>::schema_name(), "OnlyDoublet");
    let alone = schemars::schema_for!(OfKind<Doublet>).to_value();
    assert!(alone["allOf"] == choices && alone["properties"]["duration_s"]["type"] == "number");
}

#[test]
fn a_record_oscillates_when_it_changes_its_sign_eight_times_beyond_a_twentieth_of_its_height() {
    let oscillates = |values: &[f64]| Record { values, time_step_s: 0.01, is_angle: false }.oscillates();
    let waves = |halves: usize| -> Vec<f64> {
        (0..halves)
            .flat_map(|k| [0.0, if k % 2 == 0 { 2.0 } else { -2.0 }, 1.0 - 2.0 * (k % 2) as f64])
            .collect()
    };
    assert!(oscillates(&waves(9)) && !oscillates(&waves(8)));
    // what is as small as that has no sign
    let small = |value: f64| -> Vec<f64> { [[2.0, -value], [value, -2.0]].concat().repeat(4) };
    assert!(oscillates(&small(0.11)));
    let mostly = |value: f64| -> Vec<f64> { [vec![2.0], [-value, value].repeat(9)].concat() };
    assert!(oscillates(&mostly(0.11)) && !oscillates(&mostly(0.1)) && !oscillates(&mostly(0.09)));
    assert!(!oscillates(&[0.0; 40]) && !oscillates(&[]));
    let record = Record { values: &[0.5, -3.0, 2.0], time_step_s: 0.01, is_angle: false };
    assert_eq!(record.height(), 3.0);
}

#[test]
fn a_column_is_straight_between_its_samples_and_kept_outside() {
    let span = nastran::Span::generated("a column");
    let column = Column { of: "inner".into(), span, t_s: vec![1.0, 3.0, 4.0], values: vec![0.5, 2.5, -1.5] };
    for (t_s, wanted) in
        [(0.0, 0.5), (1.0, 0.5), (1.5, 1.0), (3.0, 2.5), (3.25, 1.5), (4.0, -1.5), (9.0, -1.5)]
    {
        assert_eq!(column.at(t_s), wanted, "{t_s} s");
    }
    assert_eq!((column.rate(1.5), column.second(1.5)), (0.0, 0.0));
    let about = About(0.25, doublet(0.5, 1.0, 0.0));
    assert_eq!((about.at(0.25), about.rate(0.25), about.second(0.25)), (0.75, 0.0, 0.0));
    assert_eq!(sampled(&about, 0.25, 4), [0.75, 0.75, -0.25, -0.25]);
}
