//! Claims of the micro air vehicle's paper on its statistics: M6 (Eq. 1), M12 and M13 (runs as blocks, how the
//! error is split), M15, M16 and M18 (the experiments with negative elevator). The runs are the shipped ones of data/mav. Expected numbers of M12, M15 and M16 are those
//! of `NumPy` and `SciPy` (full normal equations, `scipy.stats.f.sf`) on the same file, to the digits given here; an effect is
//! the mean at high minus the mean at low.

use std::path::Path;

use nastran::Table;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use response::design::full_factorial;
use response::{
    Blocking, Blocks, Data, Effects, ErrorRule, FTest, Regression, Rules, Search, Term, analyse, block_share,
    choose, effects,
};

fn table(name: &str) -> Table {
    Table::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/mav").join(name)).expect("a table")
}

fn runs(name: &str) -> Data {
    Data::from_table(&table(name), &["q_Pa", "delta_deg", "alpha_deg"], &["CL", "CD", "Cm"], &["block"])
        .expect("data")
}

fn close(got: f64, want: f64, share: f64, what: &str) {
    assert!((got - want).abs() <= share * want.abs(), "{what}: {got} instead of {want}");
}

#[test]
fn m06_the_choice_is_the_global_minimum_of_mse_plus_twice_sigma0_squared_m_over_n() {
    let data = runs("propeller_off.csv");
    let candidates = Term::up_to_order(&data.factor_names(), 3);
    for response in ["CL", "CD", "Cm"] {
        for error in [ErrorRule::LeastT(3.0), ErrorRule::AboutMean, ErrorRule::Given(1e-4)] {
            for search in [Search::BestSubset, Search::Stepwise, Search::Ranked] {
                let rules = Rules { search, error, ..Rules::default() };
                let choice = choose(&data, response, &candidates, rules).expect("a choice");
                let pse = |k: usize| choice.curve[k].criteria.pse;
                for (k, step) in choice.curve.iter().enumerate() {
                    // Eq. 1 of paper 2 with the residual of a fit made anew
                    let fitted =
                        Regression::fit(&data, response, &step.terms, Blocking::Fixed).expect("a fit");
                    let (m, n) = (step.terms.len() as f64, data.points() as f64);
                    let want = fitted.residual_sum / n + 2.0 * choice.sigma0_squared * m / n;
                    close(pse(k), want, 1e-9, "PSE");
                    assert!(pse(choice.chosen) <= pse(k), "{response} {search:?}: {k} is lower");
                }
                assert_eq!(choice.fitted.terms(), choice.curve[choice.chosen].terms);
                // the error falls and the penalty grows with every term
                for pair in choice.curve.windows(2) {
                    assert!(pair[1].criteria.mse <= pair[0].criteria.mse, "{response} {search:?}");
                    assert!(
                        pair[1].criteria.pse - pair[1].criteria.mse
                            > pair[0].criteria.pse - pair[0].criteria.mse
                    );
                }
            }
        }
    }
}

#[test]
fn m06_a_larger_sigma0_never_keeps_more_terms() {
    let data = runs("propeller_off.csv");
    let candidates = Term::up_to_order(&data.factor_names(), 3);
    let kept = |error| {
        let rules = Rules { error, ..Rules::default() };
        choose(&data, "CD", &candidates, rules).expect("a choice").fitted.coefficients.len()
    };
    let by_t: Vec<usize> = [1.0, 2.0, 3.0, 5.0, 10.0, 100.0].map(|t| kept(ErrorRule::LeastT(t))).into();
    assert!(by_t.windows(2).all(|pair| pair[1] <= pair[0]), "{by_t:?}");
    assert!(by_t[0] > by_t[5], "{by_t:?}");
    // Morelli's upper bound, the variance of the response about its mean, is far above any error here
    assert!(kept(ErrorRule::AboutMean) < kept(ErrorRule::LeastT(3.0)));
}

#[test]
fn m12_offsets_of_runs_remove_the_share_of_the_pure_error_that_an_independent_program_finds() {
    let off = runs("propeller_off.csv");
    let factors = ["q_Pa", "alpha_deg", "E_V"];
    let speed =
        Data::from_table(&table("propeller_speed.csv"), &factors, &["n_krpm"], &["block"]).expect("data");
    // variances of the pure error without and with offsets
    for (data, response, without, with) in [
        (&off, "CL", 0.000_371_530_252_343_749_9, 7.206_989_723_794_294e-5),
        (&off, "CD", 3.887_477_708_333_334_4e-5, 1.034_625_230_273_950_4e-5),
        (&off, "Cm", 2.279_327_213_541_667_6e-5, 9.127_080_608_185_7e-6),
        (&speed, "n_krpm", 0.007_545_538_879_084_965, 0.002_334_976_950_590_804_7),
    ] {
        let share = block_share(data, response).expect("replicates");
        close(share.without.variance(), without, 1e-9, response);
        close(share.with.variance(), with, 1e-9, response);
        assert!(share.removed() > 0.5 && share.test().p_value < 1e-10, "{response}: {}", share.removed());
    }
}

#[test]
fn m13_the_error_is_split_into_pure_error_and_lack_of_fit() {
    let data = runs("propeller_off.csv");
    let candidates = Term::up_to_order(&data.factor_names(), 3);
    for response in ["CL", "CD", "Cm"] {
        let all = analyse(&data, response, &candidates, Rules::default(), 0.95).expect("an analysis");
        let fitted = &all.choice.fitted;
        let (pure, lack) = (all.pure_error.expect("three runs"), all.lack_of_fit.expect("128 points"));
        // 384 points at 128 states in 3 runs: 128 means and 2 offsets go off the pure error
        assert_eq!(pure.degrees_of_freedom, 254.0);
        assert_eq!(lack.above + lack.below, fitted.degrees_of_freedom);
        assert_eq!(fitted.degrees_of_freedom, 384.0 - 2.0 - fitted.coefficients.len() as f64);
        close(
            lack.f * lack.above * pure.variance() + pure.sum,
            fitted.residual_sum,
            1e-10,
            "the sum of both",
        );
        // the chosen structure leaves nothing but pure error, a plane does
        assert!(lack.p_value > 0.05, "{response} {lack:?}");
        let small = Term::up_to_order(&data.factor_names(), 1);
        let plane = analyse(&data, response, &small, Rules::default(), 0.95).expect("an analysis");
        assert!(plane.lack_of_fit.expect("a test").p_value < 1e-6, "{response}");
    }
}

#[test]
fn m13_the_prediction_error_grows_away_from_the_sites_of_the_data() {
    let data = runs("propeller_off.csv");
    let candidates = Term::up_to_order(&data.factor_names(), 3);
    let fitted = choose(&data, "CL", &candidates, Rules::default()).expect("a choice").fitted;
    let at = |alpha_deg: f64| {
        fitted
            .predict(&[("q_Pa", 70.0), ("delta_deg", 15.0), ("alpha_deg", alpha_deg)])
            .expect("a prediction")
    };
    assert!(!at(11.0).extrapolated && at(40.0).extrapolated);
    assert!(at(40.0).standard_error > at(25.0).standard_error);
    assert!(at(25.0).standard_error > 2.0 * at(11.0).standard_error);
    // the share of the surface in the variance of its data's points is parameters over points
    let mean = fitted.leverages.iter().sum::<f64>() / 384.0;
    close(mean, (fitted.coefficients.len() + 2) as f64 / 384.0, 1e-12, "mean leverage");
}

#[test]
fn m13_differences_below_the_least_significant_one_are_rarely_declared() {
    // a true difference of zero: two states on a line of constant response, which the surface may tilt by error only
    let mut declared = 0;
    for seed in 0..2000 {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let x: Vec<f64> = (0..12).map(f64::from).collect();
        let y = (0..12).map(|_| StandardNormal.sample(&mut random)).collect();
        let data = Data::new().factor("x", x).and_then(|d| d.response("y", y)).expect("data");
        let terms: Vec<Term> = ["1", "x"].map(|t| t.parse().expect("a term")).into();
        let fitted = Regression::fit(&data, "y", &terms, Blocking::Ignored).expect("a fit");
        let (one, other) = ([("x", 2.0)], [("x", 9.0)]);
        let difference = (fitted.value(&one).unwrap() - fitted.value(&other).unwrap()).abs();
        declared += u32::from(difference > fitted.least_significant_difference(&one, &other, 0.95).unwrap());
    }
    // 5 % of 2000 are 100, with a standard deviation of 9.7
    assert!((61..=139).contains(&declared), "{declared}");
}

/// The rows of the shipped runs that pass, with factors A (pressure), B (elevator) and C (angle of attack).
fn negative_elevator(keep: impl Fn(&str, f64) -> bool) -> Data {
    let table = table("negative_elevator.csv");
    let number = |row: usize, name: &str| table.number(row, name).expect("a number");
    let passes = |row: &usize| keep(table.text(*row, "block").expect("a run"), number(*row, "alpha_deg"));
    let rows: Vec<usize> = (0..table.len()).filter(passes).collect();
    let column = |name: &str| rows.iter().map(|row| number(*row, name)).collect::<Vec<f64>>();
    let blocks: Vec<String> = column("alpha_deg").iter().map(ToString::to_string).collect();
    let mut data = Data::new();
    for (letter, name) in [("A", "q_Pa"), ("B", "delta_deg"), ("C", "alpha_deg")] {
        data = data.factor(letter, column(name)).expect("a factor");
    }
    for name in ["CL", "CD", "Cm"] {
        data = data.response(name, column(name)).expect("a response");
    }
    data.block(Blocks::from_labels("alpha", blocks.iter().map(String::as_str))).expect("blocks")
}

fn value(all: &Effects, term: &str) -> f64 {
    let term: Term = term.parse().expect("a term");
    all.effects.iter().find(|effect| effect.term == term).expect("an effect").value
}

#[test]
fn m15_two_to_the_three_with_its_seven_effects_and_tests_at_95_percent() {
    let data = negative_elevator(|_, alpha| [4.0, 18.0].contains(&alpha));
    let terms = ["C", "A", "B", "A*C", "B*C", "A*B", "A*B*C"];
    let expected = [
        ("CL", [0.629_289, -0.028_366, 0.124_236, 0.001_449, -0.004_079, 0.014_186, 0.000_406]),
        ("CD", [0.105_475, -0.012_158, 0.017_235, -0.001_325, 0.000_932, 0.002_07, -0.000_272]),
        ("Cm", [-0.143_406, 0.079_929, -0.243_186, 0.002_586, 0.000_176, -0.074_774, 0.001_324]),
    ];
    for (response, want) in expected {
        let all = effects(&data, response, &["A", "B", "C"], 3, (Blocking::Ignored, 0.95)).expect("effects");
        // two runs of eight points: seven effects and the mean, eight degrees of freedom for the error
        assert_eq!((data.points(), all.effects.len(), all.degrees_of_freedom), (16, 7, 8.0));
        for (term, want) in terms.into_iter().zip(want) {
            assert!((value(&all, term) - want).abs() < 6e-7, "{response} {term}: {}", value(&all, term));
        }
        for effect in &all.effects {
            let test = effect.test.expect("replicates");
            assert_eq!(test.significant, test.p_value < 0.05);
            // the square of t is the F of the sum of squares
            let f = effect.sum_of_squares / (all.residual_sum / 8.0);
            close(f, test.t * test.t, 1e-9, "F");
        }
        // one run alone has no error: effects without a test, judged by Lenth's margin
        let one = negative_elevator(|run, alpha| run == "run_1" && [4.0, 18.0].contains(&alpha));
        let alone = effects(&one, response, &["A", "B", "C"], 3, (Blocking::Ignored, 0.95)).expect("effects");
        assert!(alone.effects.iter().all(|effect| effect.test.is_none()) && alone.lenth.is_some());
    }
}

#[test]
fn m15_the_eight_points_are_a_full_factorial_with_orthogonal_contrasts() {
    let design = full_factorial(&["A", "B", "C"]).expect("a design");
    let columns: Vec<Vec<f64>> = ["1", "A", "B", "C", "A*B", "A*C", "B*C", "A*B*C"]
        .map(|text| design.column(&text.parse().expect("a term")).expect("a column"))
        .into();
    for (i, one) in columns.iter().enumerate() {
        for (j, other) in columns.iter().enumerate() {
            let product: f64 = one.iter().zip(other).map(|(a, b)| a * b).sum();
            assert_eq!(product, if i == j { 8.0 } else { 0.0 });
        }
    }
    // and the shipped runs have them all
    let data = negative_elevator(|run, alpha| run == "run_1" && [4.0, 18.0].contains(&alpha));
    let mut levels: Vec<[bool; 3]> = (0..8)
        .map(|i| {
            ["A", "B", "C"].map(|f| data.factor_values(f).unwrap()[i] > data.factor_values(f).unwrap()[0])
        })
        .collect();
    levels.sort_unstable();
    levels.dedup();
    assert_eq!(levels.len(), 8);
}

#[test]
fn m16_two_to_the_two_in_eight_blocks_has_31_degrees_of_freedom_as_7_and_3_and_21() {
    let data = negative_elevator(|run, _| run == "run_1");
    // effect, F and its p of A, B and AB; sums of squares of blocks and error
    let expected = [
        (
            "CL",
            [
                (-0.032_715, 137.275, 1.130_323_823_601_722e-10),
                (0.115_314, 1_705.53, 1.352_262_227_817_745_8e-21),
                (0.0132, 22.348, 0.000_114_363_391_657_851_67),
            ],
            (1.367_399_322_887_5, 0.001_309_821_287_500_183_5),
        ),
        (
            "CD",
            [
                (-0.015_02, 136.879, 1.160_655_590_420_683_8e-10),
                (0.017_916, 194.756, 4.291_189_804_126_922e-12),
                (0.000_779, 0.368, 0.550_624_179_463_0),
            ],
            (0.042_384_893_3, 0.000_276_893_574_999_999_8),
        ),
        (
            "Cm",
            [
                (0.081_499, 5_322.881, 9.489_626_087_358_605e-27),
                (-0.244_297, 47_827.098, 9.560_326_001_993_388e-37),
                (-0.075_368, 4_552.119, 4.871_308_843_959_224e-26),
            ],
            (0.069_961_307_071_874_99, 0.000_209_638_515_624_985_26),
        ),
    ];
    for (response, want, (block_sum, error_sum)) in expected {
        let all = effects(&data, response, &["A", "B"], 2, (Blocking::Fixed, 0.95)).expect("effects");
        let split = (all.block_degrees_of_freedom, all.effects.len(), all.degrees_of_freedom);
        assert_eq!((data.points(), split), (32, (7.0, 3, 21.0)));
        close(all.block_sum, block_sum, 1e-9, "blocks");
        close(all.residual_sum, error_sum, 1e-9, "error");
        for (term, (effect, f, p)) in ["A", "B", "A*B"].into_iter().zip(want) {
            let found = all.effects.iter().find(|e| e.term == term.parse().unwrap()).expect("an effect");
            let test = found.test.expect("21 degrees of freedom");
            assert!((found.value - effect).abs() < 6e-7, "{response} {term}: {}", found.value);
            assert!((test.t * test.t - f).abs() < 6e-3, "{response} {term}: {}", test.t * test.t);
            close(test.p_value, p, 1e-6, "p");
            let own = FTest::new(found.sum_of_squares, 1.0, all.residual_sum, 21.0);
            close(own.f, test.t * test.t, 1e-9, "F");
        }
    }
}

#[test]
fn m18_seven_of_the_nine_verdicts_of_table_3_come_out_of_the_runs() {
    let data = negative_elevator(|_, _| true);
    let real = |response: &str, term: &str| {
        let all = effects(&data, response, &["A", "B"], 2, (Blocking::Fixed, 0.95)).expect("effects");
        let term: Term = term.parse().expect("a term");
        let found = all.effects.iter().find(|effect| effect.term == term).expect("an effect");
        found.test.expect("replicates").significant
    };
    for (response, term) in
        [("CL", "B"), ("CL", "A*B"), ("CD", "A"), ("CD", "B"), ("Cm", "A"), ("Cm", "B"), ("Cm", "A*B")]
    {
        assert!(real(response, term), "{response} {term}");
    }
    // the other two are not in the equations that the runs are drawn from: Eq. 8 of paper 2 has a pressure effect on lift, twice the
    // interaction, where the table has none; Eq. 9 of paper 2 has no value for the interaction in drag, where the table has one
    assert!(real("CL", "A") && !real("CD", "A*B"));
}
