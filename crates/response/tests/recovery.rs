//! From generated runs the published structure is found again: 100 draws of the runs behind Eqs. 4 to 7 of paper 2, candidates up to the
//! order of the equation, all subsets, the default rule for sigma0^2. With the structure given, the published coefficients
//! are in their 95 % intervals as often as they should.

use std::path::Path;

use response::mav::{Errors, Published, Runs, Series, draw};
use response::{Blocking, Blocks, Data, Regression, Rules, Search, Term, choose};

const DRAWS: u64 = 100;

fn published() -> Published {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav/published");
    Published::read(&folder).expect("the shipped coefficients")
}

fn data(runs: &Runs) -> Data {
    let mut data = Data::new();
    for (factor, _) in runs.factors() {
        data = data.factor(factor.symbol(), runs.factor(factor)).expect("a factor");
    }
    for name in &runs.responses {
        data = data.response(name, runs.response(name).expect("a response")).expect("a response");
    }
    let labels: Vec<String> = runs.rows.iter().map(|row| format!("run_{}", row.block)).collect();
    data.block(Blocks::from_labels("block", labels.iter().map(String::as_str))).expect("blocks")
}

/// Published terms with their true effect in standard errors of the given structure; errors as declared.
fn true_effects(published: &Published, series: Series, response: usize, draws: &[Data]) -> Vec<(Term, f64)> {
    let (equations, wing) = series.equations();
    let model = published.equation(equations[response], wing).expect("the series' equation");
    let parse = |text: String| text.parse().expect("a term");
    let terms: Vec<Term> = model.coefficients.iter().map(|c| parse(c.term.to_string())).collect();
    let mut errors = vec![0.0; terms.len()];
    for data in draws {
        let fitted = Regression::fit(data, &model.response, &terms, Blocking::Fixed).expect("a fit");
        for (sum, coefficient) in errors.iter_mut().zip(&fitted.coefficients) {
            *sum += coefficient.standard_error / draws.len() as f64;
        }
    }
    let value = |k: usize| model.coefficients[k].value.expect("Eqs. 4 to 7 are complete");
    terms.into_iter().enumerate().map(|(k, term)| (term, value(k).abs() / errors[k])).collect()
}

fn recovery(published: &Published, series: Series, response: usize, order: u32, search: Search) -> f64 {
    let draws: Vec<Data> = (1..=DRAWS)
        .map(|seed| data(&draw(published, series, &Errors::default(), seed).expect("runs")))
        .collect();
    let name = draws[0].response_names()[response].to_string();
    let true_terms = true_effects(published, series, response, &draws);
    let candidates = Term::up_to_order(&draws[0].factor_names(), order);
    let mut kept = vec![0; true_terms.len()];
    let mut spurious = 0;
    for data in &draws {
        let choice =
            choose(data, &name, &candidates, Rules { search, ..Rules::default() }).expect("a choice");
        assert!(choice.complete);
        let chosen = choice.fitted.terms();
        for ((term, _), kept) in true_terms.iter().zip(&mut kept) {
            *kept += u32::from(chosen.contains(term));
        }
        spurious += chosen.iter().filter(|term| !true_terms.iter().any(|(known, _)| known == *term)).count();
    }
    for ((term, effect), kept) in true_terms.iter().zip(&kept) {
        if *effect >= 5.0 {
            assert!(f64::from(*kept) >= 0.95 * DRAWS as f64, "{name}: {term} of {effect} kept {kept}");
        }
    }
    spurious as f64 / DRAWS as f64
}

#[test]
fn the_published_structure_is_found_again_in_generated_runs() {
    let published = published();
    // Morelli's ranking is not among them: without steps back it keeps 2 terms too many in Eq. 7 of paper 2
    for search in [Search::BestSubset, Search::Stepwise] {
        assert!(recovery(&published, Series::PropellerSpeed, 0, 2, search) <= 1.0);
        for response in 0..3 {
            assert!(recovery(&published, Series::PropellerOff, response, 3, search) <= 1.0);
        }
    }
}

#[test]
fn with_the_structure_given_95_percent_intervals_of_a_fit_hold_the_published_coefficients() {
    let published = published();
    let (mut all, mut worst) = (Vec::new(), 1.0_f64);
    for (series, responses) in [(Series::PropellerSpeed, 1), (Series::PropellerOff, 3)] {
        let (equations, wing) = series.equations();
        for &equation in &equations[..responses] {
            let model = published.equation(equation, wing).expect("the series' equation");
            let terms: Vec<Term> =
                model.coefficients.iter().map(|c| c.term.to_string().parse().expect("a term")).collect();
            let mut inside = vec![0.0; terms.len()];
            for seed in 1..=DRAWS {
                let data = data(&draw(&published, series, &Errors::default(), seed).expect("runs"));
                let fitted = Regression::fit(&data, &model.response, &terms, Blocking::Fixed).expect("a fit");
                for (k, coefficient) in fitted.coefficients.iter().enumerate() {
                    let (low, high) = coefficient.interval(0.95, fitted.degrees_of_freedom).expect("95 %");
                    let value = model.coefficients[k].value.expect("Eqs. 4 to 7 are complete");
                    inside[k] += f64::from(u8::from((low..=high).contains(&value))) / DRAWS as f64;
                }
            }
            worst = inside.iter().copied().fold(worst, f64::min);
            all.extend(inside);
        }
    }
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    assert_eq!(all.len(), 9 + 12 + 15 + 8);
    assert!((0.93..=0.97).contains(&mean), "{mean}");
    // one of 44 coefficients: four standard errors of 100 draws below 0.95
    assert!(worst > 0.86, "{all:?}");
}
