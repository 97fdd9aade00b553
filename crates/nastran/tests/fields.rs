//! The forms a line may have: small, large and free fields, tabs, comments and continuations, and real numbers.

use nastran::{BulkData, InputError, parse_deck};

fn parse(text: &str) -> BulkData {
    parse_deck("t.bdf", text).unwrap_or_else(|error| panic!("{error}"))
}

fn error(text: &str) -> String {
    let error: InputError =
        parse_deck("t.bdf", text).and_then(|deck| deck.refuse_unread_air()).expect_err("must be refused");
    format!("{}: {}", error.span.as_ref().expect("errors of decks have a place"), error.message)
}

#[test]
fn small_large_and_free_fields_say_the_same() {
    let small = "GRID    7               1.5     -2.     .25             123\n";
    let large = "GRID*                  7                             1.5             -2.\n*                    .25                             123\n";
    let free = "GRID,7,,1.5,-2.,.25,,123\n";
    let tabs = "GRID\t7\t\t1.5\t-2.\t.25\t\t123\n";
    let free_large = "grid*,7,,1.5,-2.\n*,.25,,123\n";
    for text in [small, large, free, tabs, free_large] {
        let deck = parse(text);
        let grid = &deck.grids[&7];
        assert_eq!((grid.cp, grid.xyz, grid.cd), (0, [1.5, -2.0, 0.25].into(), 0), "{text}");
        assert_eq!(grid.ps, [1, 2, 3], "{text}");
    }
}

#[test]
fn a_continuation_needs_no_mark_but_may_have_one() {
    let first = "AEFACT  3       0.      .1      .2      .3      .4      .5      .6      ";
    for (end, start) in
        [("", "        "), ("", "+       "), ("+A1", "+A1     "), ("+", "+"), ("+A1", "        ")]
    {
        let start = format!("{start:8}");
        let deck = parse(&format!("{first:72}{end}\n{start}.7      1.\n"));
        assert_eq!(
            deck.factors[&3].values,
            [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 1.0],
            "`{end}` `{start}`"
        );
    }
    for text in ["AEFACT,3,0.,.1,.2,.3,.4,.5,.6,+\n+,.7,1.", "AEFACT,3,0.,.1,.2,.3,.4,.5,.6\n,.7,1."] {
        assert_eq!(parse(text).factors[&3].values.len(), 9, "{text}");
    }
}

#[test]
fn names_of_continuations_are_compared_without_what_stands_before_them() {
    let first = "AEFACT  3       0.      .1      .2      .3      .4      .5      .6      ";
    // Nastran compares columns 74 to 80 with columns 2 to 8.
    for (end, start) in [
        (" +000003", "++000003"),
        (" +000003", "+ 000003"),
        (" +000003", "+000003"),
        ("+ 000003", "+ 000003"),
        ("+000003", "++000003"),
        ("*+000003", "++000003"),
        ("QED12", "+ED12"),
    ] {
        let deck = parse(&format!("{first:72}{end}\n{start:8}.7      1.\n"));
        assert_eq!(deck.factors[&3].values.len(), 9, "`{end}` `{start}`");
    }
    let large = "GRID*                  7                             1.5             -2. +G1";
    assert_eq!(parse(&format!("{large}\n*+G1    .25\n")).grids[&7].xyz.z, 0.25);
    assert_eq!(
        error(&format!("{first:72} +000003\n++000004.7\n")),
        "t.bdf:2:1: continuation `000004` follows a line that announces `000003`"
    );
}

#[test]
fn a_long_free_line_goes_on_as_its_continuations_would() {
    // The example of MSC's Quick Reference Guide, "Format of Bulk Data Entries".
    let long = parse("SPC1,100,12456,1,2,3,4,5,6,7,8,9,10\n");
    assert_eq!(long.constraints[0].grids, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
    let factors = |text: &str| parse(text).factors[&3].values.len();
    assert_eq!(factors("AEFACT,3,0.,.1,.2,.3,.4,.5,.6,.7,.8\n"), 9);
    assert_eq!(factors("AEFACT,3,0.,.1,.2,.3,.4,.5,.6,.7,.71,.72,.73,.74,.75,.76,.77,+A\n+A,.8\n"), 16);
    assert_eq!(factors("AEFACT,3,0.,.1,.2,.3,.4,.5,.6\n,.7,.71,.72,.73,.74,.75,.76,.77,.8\n"), 16);
    let material = parse("MAT1,10,1.76+6,,.3,5.435-5,3.0-6,72.,.02,1900.,1900.\n");
    assert_eq!(material.materials[&10].rho, 5.435e-5);
    assert_eq!(error("PSOLID,2,9,,,,,,,5\n"), "t.bdf:1:18: `5` stands behind the last field of PSOLID");
    assert_eq!(
        error("AEFACT,3,0.,.1,.2,.3,.4,.5,.6,+A,.8\n"),
        "t.bdf:1:34: a free-field line has at most 8 fields between its name and that of its continuation"
    );
}

#[test]
fn a_small_continuation_after_one_large_line_starts_a_new_line() {
    let deck = parse(
        "CONM2*                 1               2                              3.\n+       1.      2.      3.\n",
    );
    assert_eq!(deck.masses[&1].mass, 3.0);
    assert_eq!(deck.masses[&1].inertia, [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]);
}

#[test]
fn comments_and_blank_lines_are_skipped_also_inside_a_card() {
    let deck = parse("$ a comment\nAEFACT  3       0.      .5 $ half\n\n$ another\n");
    assert_eq!(deck.factors[&3].values, [0.0, 0.5]);
    let deck = parse("SPC1,1,123456,1,2,3,4,5,6\n$ between\n+,7\n");
    assert_eq!(deck.constraints[0].grids, [1, 2, 3, 4, 5, 6, 7]);
}

#[test]
fn control_sections_are_skipped_and_enddata_ends_the_deck() {
    let deck = parse("SOL 144\nCEND\nSPC = 1\nBEGIN BULK\nGRID,1,,0.,0.,0.\nENDDATA\nGRID,1,,nonsense");
    assert_eq!(deck.grids.len(), 1);
}

#[test]
fn reals_may_have_any_exponent_mark() {
    let cases = [
        ("1.5-3", 1.5e-3),
        ("1.D2", 100.0),
        (".5", 0.5),
        ("-.5", -0.5),
        ("+2.+1", 20.0),
        ("7.", 7.0),
        ("1.e-2", 0.01),
        ("-1.25d+1", -12.5),
        ("1e5", 1e5),
        ("1E+9", 1e9),
    ];
    for (text, value) in cases {
        assert_eq!(nastran::real::parse(text), Some(value), "{text}");
    }
    for text in [
        "", ".", "1", "1+5", "1.e", "1.5-", "1.2.3", "1. 5", "nan", "inf", "1.+999", "-", "0x1.", "1.5-3.",
        "é.",
    ] {
        assert_eq!(nastran::real::parse(text), None, "{text}");
    }
}

#[test]
fn errors_name_line_and_columns() {
    assert_eq!(
        error("$\nGRID    1               0.      abc     0.\n"),
        "t.bdf:2:33: `abc` in field X2 of GRID is not a real number"
    );
    let column = |text: &str| {
        let span = parse_deck("t.bdf", text)
            .and_then(|deck| deck.refuse_unread_air())
            .expect_err("must be refused")
            .span
            .expect("a place");
        (span.line, span.column, span.end_column)
    };
    assert_eq!(column("GRID    1               0.      abc     0.\n"), (1, 33, 36));
    assert_eq!(column("GRID\t1\t\t0.\tabc\t0.\n"), (1, 12, 15), "tabs count as one column");
    assert_eq!(
        column("GRID*                  1                              0.             abc\n*   0.\n"),
        (1, 70, 73)
    );
    assert_eq!(column("AEFACT,3,0.,.1,.2,.3,.4,.5,.6,+\n+,.7,one\n"), (2, 6, 9));
    assert_eq!(column("CONM2,1\n"), (1, 8, 9), "an empty field after the end of the line");
}

#[test]
fn lines_that_are_no_cards_are_refused() {
    assert_eq!(error("GRID 1 0. 0.\n"), "t.bdf:1:1: `GRID 1 0` is not the name of a card");
    assert_eq!(error("\n        1       2\n"), "t.bdf:2:1: a continuation without a card before it");
    assert_eq!(
        error("SPC1    1       123456  1       2       3       4       5       6       +A\n+B      7\n"),
        "t.bdf:2:1: continuation `B` follows a line that announces `A`"
    );
    assert_eq!(
        error("GRID*,3,,0.,0.,0.\n"),
        "t.bdf:1:16: a free-field line has at most 4 fields between its name and that of its continuation"
    );
}
