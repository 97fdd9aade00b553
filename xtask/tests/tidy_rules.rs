//! Each house rule that reads source files finds a bad sample, and passes a good one.

use xtask::tidy::parsed::Source;
use xtask::tidy::{Complaint, circles, decisions, effect_names, lines, parameters};

fn source(name: &str, text: &str) -> Source {
    Source::parse(name, text).expect("the sample is Rust")
}

fn places(complaints: &[Complaint]) -> Vec<&str> {
    complaints.iter().map(|complaint| complaint.place.as_str()).collect()
}

#[test]
fn a_parameter_that_is_a_tuple_of_references_is_found_over_several_lines_and_in_traits() {
    let text = "fn plain(pair: (usize, f64), one: &str) {}\n\
                fn bad(\n    first: usize,\n    (a, b): (\n        &str,\n        &str,\n    ),\n) {}\n\
                trait T {\n    fn declared(&self, pair: (Option<&u8>, u8));\n}\n\
                impl X {\n    fn views(_: (View<'_>, View<'_>)) {}\n}\n\
                #[cfg(test)]\nmod tests {\n    fn of_tests(_: (&u8, &u8)) {}\n}\n\
                fn closure() -> usize {\n    let of = |(a, b): (&usize, &usize)| a + b;\n    of((&1, &2))\n}\n";
    let found = parameters::check(&[source("crates/a/src/b.rs", text)]);
    assert_eq!(places(&found), ["crates/a/src/b.rs:4", "crates/a/src/b.rs:10", "crates/a/src/b.rs:13"]);
}

#[test]
fn an_effect_named_outside_its_file_is_found_in_code_and_in_macros() {
    let text = "/// The effect `gain`.\nfn f(name: &str) -> bool {\n    name == \"gain\" || matches!(name, \"drift\")\n}\n\
                const WORDS: &str = \"a gain of 2\";\n";
    let check = |file: &str| effect_names::check(&[source(file, text)], &["gain", "drift"].into());
    assert_eq!(places(&check("crates/discover/src/travel.rs")).len(), 2);
    for allowed in [
        "crates/maneuver/src/effects/library/gain.rs",
        "crates/discover/src/rules/effects.rs",
        "crates/hidden/src/plan.rs",
        "crates/discover/tests/rivals.rs",
        "tests/tests/effects.rs",
    ] {
        assert!(check(allowed).is_empty(), "{allowed}");
    }
}

#[test]
fn names_of_effects_come_from_the_library() {
    let names = effect_names::names();
    assert!(names.contains("backlash") && names.contains("ctl_saturation") && names.len() > 40);
}

#[test]
fn a_constant_of_a_decision_outside_the_rules_is_found() {
    let text = "const NAMES: [&str; 2] = [\"a\", \"b\"];\nconst MARGIN: f64 = 25.0;\nstruct S;\n\
                impl S {\n    const MOST: usize = 4;\n}\nfn f() {\n    const INSIDE: [f64; 2] = [0.1, -0.2];\n}\n";
    let file = "crates/discover/src/search.rs";
    assert_eq!(
        places(&decisions::check(&[source(file, text)])),
        [2, 5, 8].map(|line| format!("{file}:{line}"))
    );
    for elsewhere in
        ["crates/discover/src/rules.rs", "crates/discover/src/rules/defaults.rs", "crates/aero/src/dlm.rs"]
    {
        assert!(decisions::check(&[source(elsewhere, text)]).is_empty(), "{elsewhere}");
    }
}

#[test]
fn files_that_take_names_from_each_other_are_found_through_re_exports_and_modules() {
    let circle = circles::all(&[
        source("crates/a/src/lib.rs", "mod alpha;\nmod beta;\nmod folder;\npub use alpha::Alpha;\n"),
        // a path through a module, and a name that lib.rs passes on
        source("crates/a/src/alpha.rs", "use crate::beta;\npub struct Alpha(beta::Beta);\n"),
        source("crates/a/src/beta.rs", "pub struct Beta;\nimpl Beta {\n    fn of(_: &crate::Alpha) {}\n}\n"),
        // a folder's file takes a name that mod.rs only passes on: no circle
        source("crates/a/src/folder/mod.rs", "mod one;\nmod two;\npub use one::One;\npub struct Own;\n"),
        source("crates/a/src/folder/one.rs", "use super::Own;\npub struct One(Own);\n"),
        source("crates/a/src/folder/two.rs", "use super::One;\nfn f(_: One) {}\n"),
        // a name of another crate is not the file of that name
        source("crates/b/src/lib.rs", "mod alpha;\npub struct Own;\n"),
        source("crates/b/src/alpha.rs", "use super::Own;\nuse alpha::Alpha;\nfn f(_: Own, _: Alpha) {}\n"),
    ]);
    assert_eq!(circle, [["crates/a/src/alpha.rs", "crates/a/src/beta.rs"]]);
}

#[test]
fn a_folder_and_its_file_are_a_circle_where_names_go_both_ways() {
    let circle = circles::all(&[
        source("crates/a/src/lib.rs", "mod folder;\n"),
        source("crates/a/src/folder/mod.rs", "mod one;\nuse one::One;\npub struct Own(One);\n"),
        source("crates/a/src/folder/one.rs", "use super::*;\npub struct One(Option<Box<Own>>);\n"),
    ]);
    assert_eq!(circle, [["crates/a/src/folder/mod.rs", "crates/a/src/folder/one.rs"]]);
}

#[test]
fn lines_of_code_are_neither_blank_nor_comments() {
    let text = "//! What it is.\n\nfn f() {\n    // why\n    g(); // and how\n}\n\n/// Docs.\nfn g() {}\n";
    assert_eq!(lines::lines_of_code(text), 4);
}
