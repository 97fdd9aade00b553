//! JSON in the place of RON: the same types, and errors that say as much.

use nastran::ron_file;
use serde::Deserialize;

#[derive(Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wing {
    span_m: f64,
    #[serde(default)]
    kind: Option<Kind>,
    taper: f64,
}

#[derive(Debug, PartialEq, Deserialize)]
enum Kind {
    Rigid,
    Beam { elements: u32 },
}

#[test]
fn choices_and_what_may_be_left_out_are_read() {
    let read = |text: &str| ron_file::parse::<Wing>("w.json", text).unwrap().kind;
    assert_eq!(read(r#"{"span_m": 1, "taper": 0.5, "kind": null}"#), None);
    assert_eq!(read(r#"{"span_m": 1, "taper": 0.5, "kind": "Rigid"}"#), Some(Kind::Rigid));
    let beam = r#"{"span_m": 1, "taper": 0.5, "kind": {"Beam": {"elements": 3}}}"#;
    assert_eq!(read(beam), Some(Kind::Beam { elements: 3 }));
}

#[test]
fn a_fault_is_named_where_it_stands() {
    for (text, place, message, help) in [
        ("{\n  \"ü\": 1}", (2, 3, 6), "no field \"ü\"", ""),
        ("{\n  \"sapn_m\": 1}", (2, 3, 11), "no field \"sapn_m\"", "\"span_m\"?"),
        ("{\"kind\": \"Rigit\"}", (1, 10, 17), "no choice \"Rigit\"", "\"Rigid\"?"),
        ("{\"kind\": {\"Beem\": 1}}", (1, 11, 17), "no choice \"Beem\"", "\"Beam\"?"),
        ("{\"span_m\": 1\n}", (2, 1, 2), "field \"taper\" is missing", "\"taper\": ..."),
        ("{\"span_m\": \"five\"}", (1, 12, 18), "invalid type", "schema"),
        ("{\"span_m\": 1e400}", (1, 12, 17), "out of range", "JSON"),
        ("{\"span_m\": NaN}", (1, 12, 13), "expected value", "JSON"),
        ("{\"span_m\": 1,}", (1, 14, 15), "trailing comma", "comma"),
        ("", (1, 1, 2), "EOF", "JSON"),
    ] {
        let error = ron_file::parse::<Wing>("w.json", text).unwrap_err();
        assert!(error.message.contains(message), "{text}: {error}");
        assert!(error.help.as_deref().unwrap_or("").contains(help), "{text}: {error}");
        let span = error.span.unwrap();
        assert_eq!((span.line, span.column, span.end_column), place, "{text}: {}", error.message);
    }
}
