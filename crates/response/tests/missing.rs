//! What a response surface lacks is named, and nothing where nothing is missing. Campaigns are drawn from the published
//! equations of the micro air vehicle; the model is the same equation without the hidden term. What is to be named, and its
//! size, is the published coefficient.

use std::path::Path;

use response::mav::{Errors, Published, Series, draw};
use response::missing::{Missing, Question, find_missing};
use response::verdict::VerdictKind;
use response::{Blocking, Blocks, Data, Term, estimable};

fn published() -> Published {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav/published");
    Published::read(&folder).expect("the shipped coefficients")
}

fn term(text: &str) -> Term {
    text.parse().expect("a term")
}

/// A campaign of a series.
fn campaign(published: &Published, series: Series, seed: u64) -> Data {
    let runs = draw(published, series, &Errors::default(), seed).expect("the series' equations");
    let mut data = Data::new();
    for (factor, _) in runs.factors() {
        data = data.factor(factor.symbol(), runs.factor(factor)).expect("a factor");
    }
    for name in &runs.responses {
        data = data.response(name, runs.response(name).expect("a response")).expect("a response");
    }
    let labels = runs.blocks();
    data.block(Blocks::from_labels("run", labels.iter().map(String::as_str))).expect("blocks")
}

/// The published equation of a response: its terms with their values, those that the paper gives.
fn equation(published: &Published, series: Series, response: &str) -> Vec<(Term, f64)> {
    let (equations, wing) = series.equations();
    let models = equations.iter().map(|number| published.equation(*number, wing).expect("an equation"));
    let model = models.into_iter().find(|model| model.response == response).expect("the response");
    let given = model.coefficients.iter().filter_map(|c| Some((term(&c.term.to_string()), c.value?)));
    given.collect()
}

/// A campaign, and what is looked for in it.
struct Case<'a> {
    series: Series,
    response: &'a str,
    /// A term, `run` for the offsets of runs, or nothing.
    hidden: &'a str,
    /// Factors and order of the candidates.
    factors: &'a [&'a str],
    order: u32,
}

const OFF: [&str; 3] = ["q", "delta", "alpha"];
const ON: [&str; 4] = ["q", "delta", "alpha", "n"];

impl Case<'_> {
    fn data(&self, published: &Published, seed: u64) -> Data {
        campaign(published, self.series, seed)
    }

    /// The published equation without what is hidden, and the candidates.
    fn question(&self, published: &Published, data: &Data) -> Question {
        let given = equation(published, self.series, self.response);
        let names: Vec<Term> = given.into_iter().map(|(term, _)| term).collect();
        let told = estimable(data, &names, Blocking::Fixed).expect("terms").terms;
        let hidden = (!self.hidden.is_empty()).then(|| term(self.hidden));
        let model = told.into_iter().filter(|one| Some(one) != hidden.as_ref()).collect();
        let mut candidates = Term::up_to_order(self.factors, self.order);
        if self.factors.contains(&"n") {
            candidates.push(term("n^2/q"));
        }
        let blocks = if self.hidden == "run" { Vec::new() } else { vec!["run".to_string()] };
        Question::new(model, blocks, candidates)
    }

    fn answer(&self, published: &Published, seed: u64) -> Missing {
        let data = self.data(published, seed);
        find_missing(&data, self.response, &self.question(published, &data)).expect("an answer")
    }

    /// The hidden term is named alone in every campaign, with its published coefficient, and the gap closes.
    fn is_named(&self, published: &Published, seeds: u64) {
        let true_terms = equation(published, self.series, self.response);
        let hidden = true_terms.iter().find(|(one, _)| *one == term(self.hidden));
        let value = hidden.expect("a published coefficient").1;
        for seed in 1..=seeds {
            let found = self.answer(published, seed);
            let label = format!(
                "{} {} without {}, seed {seed}: {found:?}",
                self.series.name(),
                self.response,
                self.hidden
            );
            assert_eq!(found.verdict, VerdictKind::Effects, "{label}");
            assert_eq!(found.named.len(), 1, "{label}");
            let named = &found.named[0];
            assert_eq!(term(&named.name), term(self.hidden), "{label}");
            let sigma = named.parameters[0].sigma.expect("a standard error");
            assert!((named.parameters[0].value - value).abs() < 4.0 * sigma, "{value}: {label}");
            assert!(found.closed(), "{label}");
            // of all families the hidden term's is first
            assert!(found.families[0].members.contains(&named.name), "{label}");
        }
    }
}

#[test]
fn a_hidden_product_of_pressure_and_elevator_is_named_with_its_published_coefficient() {
    let published = published();
    for response in ["CL", "Cm"] {
        let case =
            Case { series: Series::PropellerOff, response, hidden: "q*delta", factors: &OFF, order: 3 };
        case.is_named(&published, 5);
    }
    Case { series: Series::PropellerOn, response: "CL", hidden: "q*delta", factors: &ON, order: 2 }
        .is_named(&published, 5);
}

#[test]
fn the_hidden_propeller_terms_are_named_with_their_published_coefficients() {
    let published = published();
    for (response, hidden) in [("CD", "n^2/q"), ("CL", "n*delta")] {
        let case = Case { series: Series::PropellerOn, response, hidden, factors: &ON, order: 2 };
        case.is_named(&published, 5);
    }
}

#[test]
fn hidden_offsets_of_runs_are_named_as_blocks_with_their_size() {
    let published = published();
    for (response, spread) in [("CL", 0.008), ("CD", 0.003), ("Cm", 0.003)] {
        let case = Case { series: Series::PropellerOff, response, hidden: "run", factors: &OFF, order: 3 };
        for seed in 1..=5 {
            let found = case.answer(&published, seed);
            assert_eq!(found.verdict, VerdictKind::Effects, "{response} {seed}: {found:?}");
            let [named] = found.named.as_slice() else { panic!("{response} {seed}: {found:?}") };
            assert!(named.is_block && named.name == "run", "{found:?}");
            assert!(found.closed(), "{found:?}");
            // means of runs over all points, which all runs have, are the offsets but for the scatter of a mean
            let data = case.data(&published, seed);
            let y = data.response_values(response).expect("a response");
            let mean = y.iter().sum::<f64>() / y.len() as f64;
            for (block, parameter) in named.parameters.iter().enumerate() {
                let own = y.iter().zip(&data.blocks()[0].of_point).filter(|(_, of)| **of == block);
                let values: Vec<f64> = own.map(|(y, _)| *y).collect();
                let offset = values.iter().sum::<f64>() / values.len() as f64 - mean;
                assert!(
                    (parameter.value - offset).abs() < 4.0 * spread / 96.0_f64.sqrt(),
                    "{response} {seed}"
                );
            }
        }
    }
}

#[test]
fn nothing_is_named_where_nothing_is_missing() {
    let published = published();
    let mut campaigns = 0;
    for (series, responses, factors, order) in [
        (Series::PropellerOff, ["CL", "CD", "Cm"], &OFF[..], 3),
        (Series::PropellerOn, ["CL", "CD", "Cm"], &ON[..], 2),
    ] {
        for seed in 1..=20 {
            for response in responses {
                let case = Case { series, response, hidden: "", factors, order };
                let found = case.answer(&published, seed);
                assert_eq!(
                    found.verdict,
                    VerdictKind::None,
                    "{} {response} {seed}: {found:?}",
                    series.name()
                );
                assert!(found.named.is_empty() && !found.detection_limits.is_empty());
                campaigns += 1;
            }
        }
    }
    assert_eq!(campaigns, 120);
}

#[test]
fn terms_that_the_design_does_not_tell_apart_are_all_given() {
    // two pressures and two elevator angles, one of them 0: q delta, q^2 delta and q delta^2 are the same but for terms of the
    // model, so Eq. 10 of paper 2 without q delta lacks any of them
    let published = published();
    let case =
        Case { series: Series::NegativeElevator, response: "Cm", hidden: "q*delta", factors: &OFF, order: 3 };
    let found = case.answer(&published, 1);
    assert_eq!(found.verdict, VerdictKind::Ambiguous, "{found:?}");
    let [named] = found.named.as_slice() else { panic!("{found:?}") };
    let mut names: Vec<Term> = named.confused_with.iter().map(|name| term(name)).collect();
    names.push(term(&named.name));
    for expected in ["q*delta", "q^2*delta", "q*delta^2"] {
        assert!(names.contains(&term(expected)), "{expected} of {names:?}");
    }
    assert_eq!(names.len(), 3, "{names:?}");
    assert!(named.correlation.iter().all(|correlation| *correlation > 0.999_999), "{named:?}");
    assert!((named.confidence - 1.0 / 3.0).abs() < 1e-3, "{named:?}");
}

#[test]
fn what_no_candidate_explains_is_unknown() {
    // every other angle of attack is high, which no polynomial of this order follows
    let published = published();
    let case = Case { series: Series::PropellerOff, response: "CL", hidden: "", factors: &OFF, order: 3 };
    let data = case.data(&published, 1);
    let alphas = data.factor_values("alpha").expect("a factor").to_vec();
    let y = data.response_values("CL").expect("a response").iter().zip(&alphas);
    let y: Vec<f64> = y.map(|(y, a)| if (a / 2.0) % 2.0 < 0.5 { y + 0.02 } else { *y }).collect();
    let mut rough = Data::new();
    for factor in OFF {
        rough =
            rough.factor(factor, data.factor_values(factor).expect("a factor").to_vec()).expect("a factor");
    }
    let rough = rough.response("CL", y).expect("values").block(data.blocks()[0].clone()).expect("blocks");
    let found = find_missing(&rough, "CL", &case.question(&published, &rough)).expect("an answer");
    assert_eq!(found.verdict, VerdictKind::Unknown, "{found:?}");
    assert!(!found.closed());
}

#[test]
fn the_same_seed_gives_the_same_answer_and_replicates_stay_together() {
    let published = published();
    let case =
        Case { series: Series::PropellerOff, response: "Cm", hidden: "q*delta", factors: &OFF, order: 3 };
    let (one, other) = (case.answer(&published, 3), case.answer(&published, 3));
    assert_eq!(one, other);
    let data = case.data(&published, 3);
    assert_eq!(one.split.training.len() + one.split.held_out.len(), data.points());
    assert_eq!(one.split.held_out.len(), 32 * 3);
    for row in &one.split.held_out {
        assert!(one.split.training.iter().all(|other| data.point(*other) != data.point(*row)));
    }
}

#[test]
fn without_replicates_the_noise_has_to_be_stated() {
    let x: Vec<f64> = (0..40).map(f64::from).collect();
    let y: Vec<f64> = x.iter().map(|x| 1.0 + 0.1 * x + 0.003 * x * x + 0.05 * (x * 12.9898).sin()).collect();
    let data = Data::new().factor("x", x).expect("x").response("y", y).expect("y");
    let model = vec![term("1"), term("x")];
    let candidates = Term::up_to_order(&["x"], 3);
    let mut question = Question::new(model, Vec::new(), candidates);
    let complaint = find_missing(&data, "y", &question).expect_err("no replicates").to_string();
    assert!(complaint.contains("no point is measured twice"), "{complaint}");
    question.noise = Some(0.04);
    let found = find_missing(&data, "y", &question).expect("an answer");
    assert_eq!(found.named[0].name, "x^2", "{found:?}");
    question.noise = Some(f64::NAN);
    assert!(find_missing(&data, "y", &question).is_err());
}
