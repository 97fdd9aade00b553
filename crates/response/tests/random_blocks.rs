//! Random blocks by restricted maximum likelihood: the closed form of a balanced experiment, and independent values for
//! one that is not.

use std::path::Path;

use nastran::Table;
use response::{Blocking, Blocks, Data, Regression, Term};

fn close(got: f64, want: f64, relative: f64, what: &str) {
    assert!((got - want).abs() <= relative * want.abs(), "{what}: {got}, expected {want}");
}

fn terms(texts: &[&str]) -> Vec<Term> {
    texts.iter().map(|text| text.parse().expect("a term")).collect()
}

#[test]
fn a_balanced_experiment_has_the_variances_of_its_analysis_of_variance() {
    // three blocks with the same points: variances (MS_blocks - MS_error) / n and MS_error
    let noise = [0.3, -0.2, 0.1, -0.4, 0.2, 0.5, -0.1, 0.2, -0.3, 0.4, 0.1, -0.2];
    let block = [1.0, 4.0, -2.0];
    let x: Vec<f64> = (0..12_u32).map(|i| f64::from(i % 4)).collect();
    let y: Vec<f64> = (0..12).map(|i| 2.0 + 0.5 * x[i] + block[i / 4] + noise[i]).collect();
    let labels = (0..12).map(|i| ["a", "b", "c"][i / 4]);
    let data = Data::new()
        .factor("x", x)
        .and_then(|data| data.response("y", y.clone()))
        .and_then(|data| data.block(Blocks::from_labels("run", labels)))
        .expect("data");
    let fixed = Regression::fit(&data, "y", &terms(&["1", "x"]), Blocking::Fixed).expect("a fit");
    let random = Regression::fit(&data, "y", &terms(&["1", "x"]), Blocking::Random).expect("a fit");
    let mean = y.iter().sum::<f64>() / 12.0;
    let of_block = |b: usize| y[4 * b..4 * b + 4].iter().sum::<f64>() / 4.0 - mean;
    let between = (0..3).map(|b| 4.0 * of_block(b).powi(2)).sum::<f64>() / 2.0;
    close(random.error_variance, fixed.error_variance, 1e-6, "error variance");
    close(random.block_variance, (between - fixed.error_variance) / 4.0, 1e-6, "block variance");
    // the slope is all within blocks
    close(random.coefficients[1].value, fixed.coefficients[1].value, 1e-9, "slope");
    close(random.coefficients[1].standard_error, fixed.coefficients[1].standard_error, 1e-6, "its error");
}

#[test]
fn an_unbalanced_experiment_has_the_variances_of_two_independent_programs() {
    // Longley's employment in thousands over unemployment in thousands, blocks of unequal size
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/nist");
    let table = Table::read(&folder.join("longley.csv")).expect("a table");
    let thousands = |name| table.numbers(name).expect("numbers").into_iter().map(|v| v / 1000.0).collect();
    let labels = ["a", "b", "b", "c", "a", "c", "c", "b", "a", "d", "d", "d", "d", "c", "a", "d"];
    let data = Data::new()
        .factor("UNEMP", thousands("UNEMP"))
        .and_then(|data| data.response("TOTEMP", thousands("TOTEMP")))
        .and_then(|data| data.block(Blocks::from_labels("group", labels)))
        .expect("data");
    let fitted = Regression::fit(&data, "TOTEMP", &terms(&["1", "UNEMP"]), Blocking::Random).expect("a fit");
    // statsmodels 0.15.0, MixedLM(...).fit(reml=True), and the restricted likelihood of dense matrices minimised with
    // SciPy 1.17 (Nelder and Mead): both 6.614445 and 4.177132, coefficients 59.986723 and 1.587852; the standard errors and
    // predictions from the dense matrices
    close(fitted.error_variance, 6.614_445, 1e-6, "error variance");
    close(fitted.block_variance, 4.177_132, 1e-6, "block variance");
    close(fitted.coefficients[0].value, 59.986_723_12, 1e-8, "constant");
    close(fitted.coefficients[1].value, 1.587_852_41, 1e-7, "slope");
    close(fitted.coefficients[0].standard_error, 2.672_754_26, 1e-6, "error of the constant");
    close(fitted.coefficients[1].standard_error, 0.751_227_6, 1e-6, "error of the slope");
    for (offset, want) in
        fitted.offsets.iter().zip([-0.066_108_65, -2.209_175_85, 0.328_173_16, 1.947_111_34])
    {
        close(offset.value, want, 1e-5, &offset.label);
    }
}
