//! RON files: what is read, and the errors that name the line, the column and the field that was meant.

use nastran::ron_file;
use serde::Deserialize;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Wing {
    span_m: f64,
    taper: Option<f64>,
}

#[test]
fn ron_files_name_line_and_column_and_the_field_that_was_meant() {
    let wing: Wing = ron_file::parse("w.ron", "(span_m: 1.8, taper: 0.5)").expect("a good file");
    assert_eq!((wing.span_m, wing.taper), (1.8, Some(0.5)), "options need no Some");
    let error = |text: &str| ron_file::parse::<Wing>("w.ron", text).expect_err("must be refused");
    let misspelt = error("(\n    spam_m: 1.8,\n)");
    assert_eq!(misspelt.message, "there is no field `spam_m` here; expected one of `span_m`, `taper`");
    assert_eq!(misspelt.help.as_deref(), Some("did you mean `span_m`?"));
    assert_eq!(misspelt.span.map(|span| span.line), Some(2));
    let missing = error("(\n    taper: 0.5,\n)");
    assert_eq!(missing.message, "the field `span_m` of Wing is missing");
    let syntax = error("(\n    span_m: abc,\n)");
    assert_eq!(syntax.span.map(|span| (span.line, span.column)), Some((2, 13)));
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Numbers {
    name: String,
    values: Vec<f64>,
}

#[test]
fn numbers_that_are_not_finite_are_refused_where_they_stand() {
    for (word, line, column) in [("NaN", 3, 18), ("-inf", 3, 18), ("1e400", 3, 18), ("-1_0e999", 3, 18)] {
        let text = format!("// NaN\n(name: \"inf, \\\"NaN\", /* NaN\n inf */ values: [{word}, 1.0])");
        let error = ron_file::parse::<Numbers>("a.ron", &text).unwrap_err();
        assert!(error.message.contains(word), "{error}");
        let span = error.span.unwrap();
        assert_eq!((span.line, span.column), (line, column), "{word}");
    }
}

#[test]
fn what_only_looks_so_is_taken() {
    let text = "(name: \"NaN and inf, 1e400 // no comment\", values: [1e300, 0.1, -2]) // inf";
    let numbers: Numbers = ron_file::parse("a.ron", text).unwrap();
    assert!(numbers.name.starts_with("NaN") && numbers.values == [1e300, 0.1, -2.0]);
}
