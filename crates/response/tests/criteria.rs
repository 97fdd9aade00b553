//! The numbers that compare models, beside those that R prints for the same data.

use response::{Data, Rules, Term, choose};

/// Speed (mph) of fifty cars, and the distance (ft) in which they stopped: Ezekiel, "Methods of Correlation Analysis"
/// (1930), R's data set `cars`.
const SPEED: [f64; 50] = [
    4.0, 4.0, 7.0, 7.0, 8.0, 9.0, 10.0, 10.0, 10.0, 11.0, 11.0, 12.0, 12.0, 12.0, 12.0, 13.0, 13.0, 13.0,
    13.0, 14.0, 14.0, 14.0, 14.0, 15.0, 15.0, 15.0, 16.0, 16.0, 17.0, 17.0, 17.0, 18.0, 18.0, 18.0, 18.0,
    19.0, 19.0, 19.0, 20.0, 20.0, 20.0, 20.0, 20.0, 22.0, 23.0, 24.0, 24.0, 24.0, 24.0, 25.0,
];
const DISTANCE: [f64; 50] = [
    2.0, 10.0, 4.0, 22.0, 16.0, 10.0, 18.0, 26.0, 34.0, 17.0, 28.0, 14.0, 20.0, 24.0, 28.0, 26.0, 34.0, 34.0,
    46.0, 26.0, 36.0, 60.0, 80.0, 20.0, 26.0, 54.0, 32.0, 40.0, 32.0, 40.0, 50.0, 42.0, 56.0, 76.0, 84.0,
    36.0, 46.0, 68.0, 32.0, 48.0, 52.0, 56.0, 64.0, 66.0, 54.0, 70.0, 92.0, 93.0, 120.0, 85.0,
];

/// `summary(lm(dist ~ speed, cars))` prints R-squared 0.6511 and adjusted R-squared 0.6438, `BIC(lm(dist ~ speed, cars))`
/// prints 424.8929. R's has the constant of the normal density, N (1 + ln 2 pi), and counts the variance as a parameter.
#[test]
fn a_line_through_stopping_distances_has_the_criteria_that_r_prints() {
    let data = Data::new()
        .factor("speed", SPEED.to_vec())
        .and_then(|data| data.response("dist", DISTANCE.to_vec()))
        .expect("fifty cars");
    let terms: Vec<Term> = ["1", "speed"].iter().map(|text| text.parse().expect("a term")).collect();
    let choice = choose(&data, "dist", &terms, Rules::default()).expect("a choice");
    let line = choice.curve.iter().find(|step| step.terms.len() == 2).expect("the line").criteria;
    let close = |what: &str, got: f64, printed: f64| {
        assert!((got - printed).abs() <= 0.5e-4, "{what}: {got}, where R prints {printed}");
    };
    close("R-squared", line.r_squared, 0.6511);
    close("adjusted R-squared", line.adjusted_r_squared, 0.6438);
    let constant = 50.0 * (1.0 + (2.0 * std::f64::consts::PI).ln()) + 50.0_f64.ln();
    close("BIC", line.bic + constant, 424.8929);
}
