//! Least squares on reference data of NIST (data/nist/README.md): Longley and the two Wampler sets that are exact
//! polynomials. At least nine digits of every coefficient must be right.

use std::path::Path;

use nastran::Table;
use response::{Blocking, Data, Regression, Term};

/// Correct digits, as NIST counts them.
fn digits(got: f64, certified: f64) -> f64 {
    if got == certified { 16.0 } else { -((got - certified) / certified).abs().log10() }
}

fn terms(texts: &[&str]) -> Vec<Term> {
    texts.iter().map(|text| text.parse().expect("a term")).collect()
}

fn table(name: &str) -> Table {
    Table::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/nist").join(name)).expect("a table")
}

#[test]
fn longley_has_nine_certified_digits() {
    let factors = ["GNPDEFL", "GNP", "UNEMP", "ARMED", "POP", "YEAR"];
    let data = Data::from_table(&table("longley.csv"), &factors, &["TOTEMP"], &[]).expect("Longley");
    let certified = table("longley_certified.csv");
    let names: Vec<&str> = (0..certified.len()).map(|row| certified.text(row, "quantity").unwrap()).collect();
    let fitted = Regression::fit(&data, "TOTEMP", &terms(&names), Blocking::Ignored).expect("a fit");
    let values = certified.numbers("value").unwrap();
    let errors = certified.numbers("standard_error").unwrap();
    for (coefficient, (value, error)) in fitted.coefficients.iter().zip(values.iter().zip(errors)) {
        assert!(digits(coefficient.value, *value) > 9.0, "{}", coefficient.term);
        assert!(digits(coefficient.standard_error, error) > 9.0, "{}", coefficient.term);
    }
    // the rest of data/nist/README.md
    assert!(digits(fitted.error_variance, 92_936.006_167_323_8) > 9.0);
    assert!(digits(fitted.residual_sum, 836_424.055_505_915) > 9.0);
    assert!(digits(1.0 - fitted.residual_sum / fitted.total_sum, 0.995_479_004_577_296) > 9.0);
}

#[test]
fn wampler_one_and_two_have_nine_digits() {
    let x: Vec<f64> = (0..=20).map(f64::from).collect();
    for coefficients in [[1.0; 6], [1.0, 0.1, 0.01, 0.001, 0.0001, 0.000_01]] {
        let polynomial = |x: &f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
        let y = x.iter().map(polynomial).collect();
        let data = Data::new().factor("x", x.clone()).unwrap().response("y", y).unwrap();
        let powers = terms(&["1", "x", "x^2", "x^3", "x^4", "x^5"]);
        let fitted = Regression::fit(&data, "y", &powers, Blocking::Ignored).expect("a fit");
        for (coefficient, certified) in fitted.coefficients.iter().zip(coefficients) {
            assert!(digits(coefficient.value, certified) > 9.0, "{}", coefficient.term);
        }
    }
}
