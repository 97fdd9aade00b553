//! DMI matrices: every style in, one style out, and what rounding to 8 characters costs.

use nastran::{Dmi, parse_deck};
use proptest::prelude::*;

fn parse(text: &str) -> std::collections::BTreeMap<String, Dmi> {
    parse_deck("t.bdf", text).unwrap_or_else(|error| panic!("{error}")).matrices
}

fn error(text: &str) -> String {
    let error = parse_deck("t.bdf", text).expect_err("must be refused");
    format!("{}: {}", error.span.as_ref().expect("errors of decks have a place"), error.message)
}

#[test]
fn runs_of_values_are_read() {
    let matrices = parse(concat!(
        "DMI     W2GJ    0       2       1       0               6       1\n",
        "DMI     W2GJ    1       1       -.08    .05     -.08    .05     -.078\n        .049\n",
        "DMI     WKK     0       3       1       0               12      1\n",
        "DMI     WKK     1       1       1.3     1.0     1.05    1.0     .9\n",
        "        1.0     .85     1.0     .5      .9      .45     .9\n"
    ));
    assert_eq!(matrices["W2GJ"].columns, [[-0.08, 0.05, -0.08, 0.05, -0.078, 0.049]]);
    assert_eq!((matrices["W2GJ"].form, matrices["W2GJ"].rows), (2, 6));
    assert_eq!(matrices["WKK"].form, 3);
    assert_eq!(matrices["WKK"].columns, [[1.3, 1.0, 1.05, 1.0, 0.9, 1.0, 0.85, 1.0, 0.5, 0.9, 0.45, 0.9]]);
}

#[test]
fn repetition_gaps_and_explicit_pairs_are_read() {
    let header = "DMI,A,0,2,1,0,,8,1\n";
    let column = |text: &str| parse(&format!("{header}{text}"))["A"].columns[0].clone();
    assert_eq!(column("DMI,A,1,1,1.0,THRU,8\n"), [1.0; 8]);
    assert_eq!(column("DMI,A,1,2,.5,THRU,4,6,7.\n,8.\n"), [0.0, 0.5, 0.5, 0.5, 0.0, 7.0, 8.0, 0.0]);
    assert_eq!(column("DMI,A,1,1,1.,2,2.,3,3.\n,8,8.\n"), [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 0.0, 8.0]);
    assert_eq!(column(""), [0.0; 8], "columns that are not given are zero");
}

#[test]
fn several_columns_are_read_in_any_order() {
    let matrices = parse("DMI,B,2,1,3.,4.\nDMI,B,1,1,1.,2.\nDMI,B,0,2,2,0,,2,3\n");
    assert_eq!(matrices["B"].columns, [[1.0, 2.0], [3.0, 4.0], [0.0, 0.0]]);
}

#[test]
fn the_written_form_is_explicit_pairs_in_eight_columns() {
    let written = Dmi::column_vector("FA2J", vec![0.6, 0.25, 0.4, 0.1, 0.0, -0.2]).write();
    let expected = concat!(
        "DMI         FA2J       0       2       1       0               6       1\n",
        "DMI         FA2J       1       1     0.6       2    0.25       3     0.4\n",
        "               4     0.1       5     0.0       6    -0.2\n"
    );
    assert_eq!(written, expected);
    let diagonal = Dmi::diagonal("WKK", vec![1.0; 8]).write();
    assert!(
        diagonal.starts_with("DMI          WKK       0       3       1       0               8       1\n")
    );
    assert!(diagonal.ends_with("       3     1.0\n               4     1.0       5     1.0       6     1.0       7     1.0\n               8     1.0\n"));
}

#[test]
fn the_most_precise_eight_characters_are_chosen() {
    let cases = [
        (1.234_567_89, "1.234568"),
        (0.123_456_789, ".1234568"),
        (-0.123_456_789, "-.123457"),
        (1.234_567_89e-5, "1.2346-5"),
        (-1.234_567_89e-12, "-1.23-12"),
        (0.002, "0.002"),
        (1.234_567_89e7, "1.2346+7"),
        (4.0e20, "4.+20"),
    ];
    for (value, text) in cases {
        let written = nastran::real::format(value, 8);
        assert_eq!(written, text, "{value}");
    }
}

#[test]
fn a_value_that_is_not_finite_is_refused_by_the_reader() {
    let written = Dmi::column_vector("A", vec![f64::NAN]).write();
    assert_eq!(
        error(&written),
        "t.bdf:2:38: `NaN` in a column of DMI is neither a row number nor a real number"
    );
}

#[test]
fn what_does_not_fit_the_matrix_is_refused() {
    let header = "DMI,A,0,2,1,0,,2,1\n";
    let column = |text: &str| error(&format!("{header}{text}"));
    assert_eq!(column("DMI,A,1,1,1.,2.,3.\n"), "t.bdf:2:17: a value for row 3, but the matrix has 2 rows");
    assert_eq!(
        column("DMI,A,1,3,1.\n"),
        "t.bdf:2:9: row 3 does not fit: the matrix has 2 rows and 0 of them are passed"
    );
    assert_eq!(
        column("DMI,A,1,2,1.,1,1.\n"),
        "t.bdf:2:14: row 1 does not fit: the matrix has 2 rows and 2 of them are passed"
    );
    assert_eq!(column("DMI,A,1,1.\n"), "t.bdf:2:9: a value without a row number before it");
    assert_eq!(column("DMI,A,1,1,THRU,2\n"), "t.bdf:2:11: THRU repeats a value, but there is none before it");
    assert_eq!(column("DMI,A,2,1,1.\n"), "t.bdf:2:7: DMI A has 1 columns by its header; this is column 2");
    assert_eq!(column("DMI,A,1,1,1.\nDMI,A,1,1,1.\n"), "t.bdf:3:7: column 1 of this DMI is given twice");
    assert_eq!(column("DMI,A,0,2,1,0,,2,1\n"), "t.bdf:2:5: DMI A has two headers; the first is t.bdf:1:1");
    assert_eq!(error("DMI,A,1,1,1.\n"), "t.bdf:1:5: DMI A has columns but no header");
    assert_eq!(
        error("DMI,A,0,3,1,0,,2,2\n"),
        "t.bdf:1:18: `2` in field N of DMI is not 1, which a diagonal matrix (form 3) demands: its diagonal is one column"
    );
    assert_eq!(
        error("DMI,A,0,2,3,0,,2,2\n"),
        "t.bdf:1:11: `3` in field TIN of DMI is not 1 or 2; only real matrices are read"
    );
    assert!(error("DMI,A,0,2,1,0,,4000000000,4000000\n").contains("at most"));
}

/// Any finite number, subnormal ones and both zeros included.
fn any_number() -> impl Strategy<Value = f64> {
    use proptest::num::f64;
    f64::NORMAL | f64::SUBNORMAL | f64::ZERO | f64::POSITIVE | f64::NEGATIVE
}

fn magnitude(decades: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    decades.prop_map(|decade| 10.0_f64.powf(decade))
}

fn rounding_error(value: f64) -> f64 {
    let rounded = Dmi::column_vector("A", vec![value]).rounded_to_fields().columns[0][0];
    (rounded - value).abs() / value.abs()
}

proptest! {
    #[test]
    fn a_rounded_matrix_is_written_and_read_again_bit_by_bit(
        columns in prop::collection::vec(prop::collection::vec(any_number(), 9), 1..4)
    ) {
        let matrix = Dmi { name: "WKK".into(), form: 2, tin: 2, tout: 0, rows: 9, columns }.rounded_to_fields();
        let read = &parse(&matrix.write())["WKK"];
        let bits = |matrix: &Dmi| matrix.columns.concat().iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(bits(read), bits(&matrix));
        prop_assert_eq!(read, &matrix);
        prop_assert_eq!(matrix.rounded_to_fields(), matrix);
    }

    #[test]
    fn every_real_fits_its_field_and_is_near_the_number(value in any_number(), width in 8_usize..=16) {
        let text = nastran::real::format(value, width);
        prop_assert!(text.len() <= width, "{}", text);
        let read = nastran::real::parse(&text).expect("our own text is a real");
        // Numbers next to the largest and subnormal ones have fewer digits; the error is still bounded.
        prop_assert!((read - value).abs() <= 0.051 * value.abs() + f64::MIN_POSITIVE, "{} {}", value, text);
        prop_assert_eq!(nastran::real::format(read, width), text);
    }

    #[test]
    fn rounding_to_eight_characters_costs_what_the_documentation_says(
        near_one in magnitude(-1.0..1.0), usual in magnitude(-9.0..9.0)
    ) {
        prop_assert!(rounding_error(near_one) <= 5.1e-7);
        prop_assert!(rounding_error(-near_one) <= 5.1e-6);
        prop_assert!(rounding_error(usual) <= 5.1e-4);
        prop_assert!(rounding_error(-usual) <= 5.1e-4);
    }

    #[test]
    fn sixteen_characters_cost_what_the_documentation_says(usual in magnitude(-9.0..9.0), any in magnitude(-300.0..300.0)) {
        for (value, bound) in [(usual, 1e-11), (-usual, 1e-11), (any, 1e-9), (-any, 1e-9)] {
            let read = nastran::real::parse(&nastran::real::format(value, 16)).expect("our own text is a real");
            prop_assert!((read - value).abs() <= bound * value.abs());
        }
    }
}
