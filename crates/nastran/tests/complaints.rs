//! Complaints: where in a file they point, and how long they get.

use nastran::{InputError, place_of};
use std::path::Path;

const TEXT: &str = "Wing( // mass_kg: 1\n    total: (mass_kg: 2),\n    ä: (x: 1), tail: (\n  mass_kg: 3))\n";

fn line_and_column(anchors: &[&str]) -> (usize, usize) {
    let span = place_of(anchors, TEXT, Path::new("a.ron"));
    (span.line, span.column)
}

#[test]
fn a_field_is_found_behind_the_one_around_it_and_not_in_comments() {
    assert_eq!(line_and_column(&["mass_kg:"]), (2, 13));
    assert_eq!(line_and_column(&["tail:", "mass_kg:"]), (4, 3));
    assert_eq!(line_and_column(&["tail:"]), (3, 16));
}

#[test]
fn a_field_of_json_is_found_in_its_quotes() {
    let text = "{\"name\": \"total\", \"url\": \"a//b\", \"total\" : {\n \"mass_kg\": 1}}";
    let place = |anchors: &[&str]| {
        let span = place_of(anchors, text, Path::new("a.json"));
        (span.line, span.column, span.end_column)
    };
    assert_eq!(place(&["total:"]), (1, 35, 40));
    assert_eq!(place(&["total:", "mass_kg:"]), (2, 3, 10));
}

#[test]
fn a_field_left_out_leads_to_the_one_around_it_or_to_the_file() {
    assert_eq!(line_and_column(&["tail:", "span_m:"]), (3, 16));
    assert_eq!(line_and_column(&["kg:"]), (0, 0));
}

#[test]
fn a_long_quotation_is_cut_in_its_middle() {
    let error = InputError::general(format!("`{}` is no number", "9".repeat(200_000)));
    assert!(error.message.len() < 150 && error.message.contains("99...99"), "{error}");
    assert!(error.message.ends_with("` is no number"), "{error}");
    let error = error.with_help("ä ".repeat(100_000));
    assert!(error.help.is_some_and(|help| help.chars().count() <= 703));
}
