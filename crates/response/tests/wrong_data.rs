//! Wrong data give one sentence that names the factor, term or cell, and no number.

use nastran::{InputError, Table};
use response::design::{Generator, fractional_factorial, full_factorial};
use response::{
    Blocking, Blocks, Data, Fault, Regression, Rules, Term, candidates, choose, effects, lack_of_fit,
    pure_error,
};

const GOOD: &str =
    "run,alpha,q,CL\nr1,4,60,0.2\nr1,8,60,0.4\nr1,12,60,0.6\nr2,4,90,0.25\nr2,8,90,0.44\nr2,12,90,0.61\n";

fn table(text: &str) -> Table {
    Table::parse("runs.csv", text).expect("a table")
}

fn data(text: &str) -> Result<Data, InputError> {
    Data::from_table(&table(text), &["alpha", "q"], &["CL"], &[])
}

fn good() -> Data {
    data(GOOD).expect("good data")
}

fn terms(texts: &[&str]) -> Vec<Term> {
    texts.iter().map(|text| text.parse().expect("a term")).collect()
}

fn refused(terms: &[Term]) -> String {
    Regression::fit(&good(), "CL", terms, Blocking::Ignored).expect_err("a fault").to_string()
}

fn says(message: &str, parts: &[&str]) {
    for part in parts {
        assert!(message.contains(part), "`{message}` does not say `{part}`");
    }
}

#[test]
fn text_in_a_column_is_named_with_its_place() {
    let error = data(&GOOD.replace("0.44", "o.44")).expect_err("text").to_string();
    says(&error, &["runs.csv:6:9", "`o.44`", "`CL`"]);
    let error = data(&GOOD.replace("CL", "Cl")).expect_err("another name").to_string();
    says(&error, &["`CL`"]);
}

#[test]
fn a_constant_factor_is_named() {
    let error = data(&GOOD.replace(",90,", ",60,")).expect_err("constant").to_string();
    says(&error, &["`q`", "60", "all points"]);
}

#[test]
fn aliased_terms_are_named_with_those_they_are_confused_with() {
    // two levels of q: its square is a straight line
    says(&refused(&terms(&["1", "q", "q^2"])), &["`q^2`", "`1`, `q`"]);
    says(&refused(&terms(&["1", "alpha", "alpha"])), &["`alpha`"]);
    let chosen = choose(&good(), "CL", &terms(&["1", "q", "q^2"]), Rules::default()).expect_err("aliased");
    assert!(matches!(chosen, Fault::Aliased { term, .. } if term == "q^2"));
    // candidates up to an order leave them out, and say so
    let found = candidates(&good(), &["alpha", "q"], 2, Blocking::Ignored).expect("candidates");
    assert_eq!(found.terms, terms(&["1", "alpha", "q", "alpha^2", "alpha*q"]));
    assert_eq!(found.left_out[0].0, terms(&["q^2"])[0]);
    says(&found.left_out[0].1, &["`q`"]);
    // a factor that follows the blocks
    let blocked = Data::from_table(&table(GOOD), &["alpha", "q"], &["CL"], &["run"]).expect("data");
    let fault =
        Regression::fit(&blocked, "CL", &terms(&["1", "alpha", "q"]), Blocking::Fixed).expect_err("aliased");
    says(&fault.to_string(), &["`run r1`", "`q`"]);
}

#[test]
fn fewer_points_than_terms_are_counted() {
    let many = terms(&["1", "alpha", "q", "alpha^2", "alpha*q", "alpha^2*q"]);
    says(&refused(&many), &["6 points", "6 terms", "estimate of the error"]);
}

#[test]
fn missing_replicates_are_said() {
    let fault = pure_error(&good(), "CL", Blocking::Ignored).expect_err("no replicates").to_string();
    says(&fault, &["no point is measured twice", "`alpha`, `q`"]);
    let fitted = Regression::fit(&good(), "CL", &terms(&["1", "alpha"]), Blocking::Ignored).expect("a fit");
    assert!(matches!(lack_of_fit(&good(), &fitted, Blocking::Ignored), Err(Fault::NoReplicates { .. })));
    // one point repeated, but in another block: the repeat only shows the offset
    let data =
        Data::from_table(&table("run,x,y\na,1,1\na,2,2\nb,2,3\n"), &["x"], &["y"], &["run"]).expect("data");
    let fault = pure_error(&data, "y", Blocking::Fixed).expect_err("no replicates").to_string();
    says(&fault, &["offsets of blocks"]);
}

#[test]
fn a_pole_of_a_term_and_a_missing_factor_are_named() {
    let pole = data(&GOOD.replace("r1,4,", "r1,0,")).expect("data");
    let fault = Regression::fit(&pole, "CL", &terms(&["1", "q/alpha"]), Blocking::Ignored);
    says(&fault.expect_err("a pole").to_string(), &["point 1", "`q/alpha`", "inf"]);
    says(&refused(&terms(&["1", "beta"])), &["`beta`", "`alpha`, `q`"]);
    let fitted = Regression::fit(&good(), "CL", &terms(&["1", "alpha"]), Blocking::Ignored).expect("a fit");
    says(&fitted.predict(&[("q", 60.0)]).expect_err("no alpha").to_string(), &["`alpha`"]);
}

#[test]
fn constant_responses_single_blocks_and_names_are_refused() {
    let flat = Data::new().factor("x", vec![1.0, 2.0, 3.0]).and_then(|d| d.response("y", vec![2.0; 3]));
    let fault = Regression::fit(&flat.expect("data"), "y", &terms(&["1"]), Blocking::Ignored);
    says(&fault.expect_err("constant").to_string(), &["`y`", "2"]);
    let one = Data::new().block(Blocks::from_labels("day", ["a", "a"])).expect_err("one block").to_string();
    says(&one, &["`day`"]);
    let taken = Data::new().factor("x", vec![1.0, 2.0]).and_then(|d| d.response("x", vec![1.0, 2.0]));
    says(&taken.expect_err("twice").to_string(), &["`x`", "twice"]);
    let short = Data::new().factor("x", vec![1.0, 2.0]).and_then(|d| d.response("y", vec![1.0]));
    says(&short.expect_err("short").to_string(), &["`y`", "1 values", "2"]);
    let infinite = Data::new().factor("x", vec![1.0, f64::NAN]).expect_err("NaN").to_string();
    says(&infinite, &["`x`", "point 2"]);
}

#[test]
fn random_blocks_need_one_column_of_them() {
    let fault =
        Regression::fit(&good(), "CL", &terms(&["1", "alpha"]), Blocking::Random).expect_err("no blocks");
    says(&fault.to_string(), &["random blocks", "there are 0"]);
    let rules = Rules { blocking: Blocking::Random, ..Rules::default() };
    assert!(choose(&good(), "CL", &terms(&["1", "alpha"]), rules).is_err());
}

#[test]
fn designs_that_do_not_hang_together_are_refused() {
    let fault = effects(&good(), "CL", &["alpha"], 1, (Blocking::Ignored, 0.95)).expect_err("three levels");
    says(&fault.to_string(), &["`alpha`", "4, 8 and 12"]);
    assert!(Generator::parse("d = a^2*b").is_err());
    assert!(Generator::parse("d").is_err());
    let fault = fractional_factorial(&["a", "b"], &[Generator::parse("c = a*x").expect("a generator")]);
    says(&fault.expect_err("no x").to_string(), &["`x`", "`a`, `b`"]);
    assert!(full_factorial(&[]).is_err());
    assert!(full_factorial(&["a", "a"]).is_err());
}
