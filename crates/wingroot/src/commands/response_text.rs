//! What `response` prints: of each response the chosen terms with their errors, the curve of the predicted squared error,
//! and the tests; of two-level factors their effects.

use std::fmt::Write as _;

use report::{Column, Table};
use response::{
    Analysis, BlockShare, Coefficient, Effect, EffectTest, Effects, FTest, Fault, PureError, Regression,
    Step, TableAnalysis, TableStudy,
};

use super::response_figures::worth_a_look;
use super::response_files::{aliases, change};

/// Sizes beyond the chosen one that are printed; all are in the tables.
const SIZES_BEYOND: usize = 3;

/// A number with five significant digits.
pub(super) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || !(1e-4..1e6).contains(&size) {
        return if value == 0.0 { "0".into() } else { format!("{value:.4e}") };
    }
    let mut decimals: usize = 8;
    let mut limit = 1e-3;
    while decimals > 0 && size >= limit {
        (decimals, limit) = (decimals - 1, 10.0 * limit);
    }
    format!("{value:.decimals$}")
}

/// An interval.
pub(super) fn interval((low, high): (f64, f64)) -> String {
    format!("{} to {}", number(low), number(high))
}

/// A share of the variance; rounding below zero is none.
fn share(value: f64) -> String {
    format!("{:.5}", if value.abs() < 5e-6 { 0.0 } else { value })
}

/// A probability: small ones by their order.
pub(super) fn probability(p: f64) -> String {
    if p < 1e-300 {
        "<1e-300".into()
    } else if p < 1e-4 {
        format!("{p:.1e}")
    } else {
        format!("{p:.4}")
    }
}

/// All of a table.
pub(super) fn table(study: &TableStudy, analysis: &TableAnalysis) -> String {
    let data = &analysis.data;
    let blocks: Vec<String> =
        data.blocks().iter().map(|blocks| format!("{} ({})", blocks.name, blocks.labels.len())).collect();
    let mut text = format!(
        "{}: {} points, factors {}; blocks: {}\n",
        study.data,
        data.points(),
        data.factor_names().join(", "),
        if blocks.is_empty() {
            "none".into()
        } else {
            format!("{}, {:?}", blocks.join(", "), study.blocking)
        }
    );
    for (term, others) in &analysis.left_out {
        let _ = writeln!(text, "no candidate: {term}, which the points do not tell from {others}");
    }
    for of_response in &analysis.responses {
        text.push('\n');
        response(&mut text, study, analysis, of_response);
    }
    for effects in &analysis.effects {
        text.push('\n');
        effect_table(&mut text, study, effects);
    }
    text
}

fn response(text: &mut String, study: &TableStudy, table: &TableAnalysis, analysis: &Analysis) {
    let choice = &analysis.choice;
    let (fitted, chosen) = (&choice.fitted, &choice.curve[choice.chosen].criteria);
    let _ = writeln!(
        text,
        "{}: {} of {} terms; R2 {:.5}, adjusted {:.5}; PSE {} (sigma0^2 {}); one reading {} with {} degrees of freedom{}",
        fitted.response,
        fitted.coefficients.len(),
        table.candidates.len(),
        chosen.r_squared,
        chosen.adjusted_r_squared,
        number(chosen.pse),
        number(choice.sigma0_squared),
        number(fitted.error_variance.sqrt()),
        fitted.degrees_of_freedom,
        if choice.complete {
            ""
        } else {
            "; the search of all subsets was ended early, another may have a lower PSE"
        }
    );
    let head = format!("{} % interval", 100.0 * study.level);
    let bounds =
        |c: &Coefficient| c.interval(study.level, fitted.degrees_of_freedom).unwrap_or((f64::NAN, f64::NAN));
    let t = |t: f64| if t.abs() < 1e6 { format!("{t:.2}") } else { format!("{t:.1e}") };
    let columns: [Column<'_, &Coefficient>; 6] = [
        ("term", &|c| c.term.to_string()),
        ("coefficient", &|c| number(c.value)),
        ("standard error", &|c| number(c.standard_error)),
        ("t", &|c| t(c.t)),
        ("p", &|c| probability(c.p_value)),
        (&head, &|c| interval(bounds(c))),
    ];
    let terms = Table::of(&fitted.coefficients, &columns);
    let _ = write!(text, "{terms}");
    let shown = (choice.chosen + 1 + SIZES_BEYOND).min(choice.curve.len());
    let _ = write!(text, "{}", curve(&choice.curve[..shown], choice.chosen));
    for line in tests(study, analysis) {
        let _ = writeln!(text, "{line}");
    }
}

fn curve(steps: &[Step], chosen: usize) -> Table {
    let head = ["size", "PSE", "MSE", "R2", "adjusted R2", "leave-one-out", "BIC", "from the size before"];
    let mut table = Table::new(&head);
    for (index, step) in steps.iter().enumerate() {
        let criteria = &step.criteria;
        let before = index.checked_sub(1).map_or(&[][..], |before| &steps[before].terms);
        table.row([
            criteria.terms.to_string(),
            number(criteria.pse) + if index == chosen { " *" } else { "" },
            number(criteria.mse),
            share(criteria.r_squared),
            share(criteria.adjusted_r_squared),
            number(criteria.leave_one_out),
            format!("{:.1}", criteria.bic),
            change(before, &step.terms),
        ]);
    }
    table
}

fn f_test(test: &FTest) -> String {
    format!("F({}, {}) = {}, p = {}", test.above, test.below, number(test.f), probability(test.p_value))
}

fn or_reason<T>(result: &Result<T, Fault>, say: impl Fn(&T) -> String) -> String {
    result.as_ref().map_or_else(|fault| format!("not known: {fault}"), say)
}

fn tests(study: &TableStudy, analysis: &Analysis) -> Vec<String> {
    let fitted = &analysis.choice.fitted;
    let pure = |pure: &PureError| {
        let sigma = number(pure.variance().sqrt());
        format!("{sigma} with {} degrees of freedom", pure.degrees_of_freedom)
    };
    let share = |share: &BlockShare| {
        format!("{:.0} % of the variance; {}", 100.0 * share.removed(), f_test(&share.test()))
    };
    let random = |fitted: &Regression| {
        let (between, within) = (fitted.block_variance.sqrt(), fitted.error_variance.sqrt());
        format!("{} between, {} within", number(between), number(within))
    };
    let rms = |mean_square: &f64| number(mean_square.sqrt());
    let (share_of, random_blocks) = (&analysis.block_share, &analysis.random_blocks);
    let lines = [
        ("all terms", Some(or_reason(&analysis.all_terms, f_test))),
        ("pure error of a reading", Some(or_reason(&analysis.pure_error, pure))),
        ("lack of fit", Some(or_reason(&analysis.lack_of_fit, f_test))),
        ("of the pure error blocks explain", share_of.as_ref().map(|known| or_reason(known, share))),
        (
            "standard deviations of random blocks",
            random_blocks.as_ref().map(|known| or_reason(known, random)),
        ),
        (
            "each block predicted from the others, rms",
            analysis.left_out_blocks.as_ref().map(|known| or_reason(known, rms)),
        ),
    ];
    let through_all = fitted.residual_sum <= 1e-24 * fitted.total_sum;
    let warning = "the surface goes through all points: errors and tests below are rounding only";
    let lsd = number(analysis.least_significant_difference);
    let last = format!("least significant difference at {} %: {lsd}", 100.0 * study.level);
    let said = lines.into_iter().filter_map(|(label, said)| Some(format!("{label}: {}", said?)));
    through_all.then(|| warning.to_string()).into_iter().chain(said).chain([last]).collect()
}

fn effect_table(text: &mut String, study: &TableStudy, effects: &Effects) {
    let _ = writeln!(
        text,
        "effects on {} from low to high; mean {}, {} degrees of freedom of the error, blocks {} ({})",
        effects.response,
        number(effects.mean),
        effects.degrees_of_freedom,
        effects.block_degrees_of_freedom,
        f_or_none(effects)
    );
    let of = |effect: &Effect, say: &dyn Fn(&EffectTest) -> String| {
        effect.test.as_ref().map_or_else(|| "-".into(), say)
    };
    let detectable =
        |test: &EffectTest| effects.detectable(test, study.level, 0.9).map_or_else(|_| "-".into(), number);
    let columns: [Column<'_, &Effect>; 8] = [
        ("effect", &|effect| effect.term.to_string()),
        ("value", &|effect| number(effect.value)),
        ("standard error", &|effect| of(effect, &|test| number(test.standard_error))),
        ("t", &|effect| of(effect, &|test| format!("{:.2}", test.t))),
        ("p", &|effect| of(effect, &|test| probability(test.p_value))),
        ("real", &|effect| of(effect, &|test| if test.significant { "yes".into() } else { "no".into() })),
        ("90 % found from", &|effect| of(effect, &detectable)),
        ("not told from", &|effect| aliases(effect).join(", ")),
    ];
    let table = Table::of(&effects.effects, &columns);
    let _ = write!(text, "{table}");
    if let Some(lenth) = worth_a_look(effects) {
        let _ = writeln!(
            text,
            "Lenth: pseudo standard error {}, margin {}, simultaneous margin {}",
            number(lenth.pseudo_standard_error),
            number(lenth.margin),
            number(lenth.simultaneous_margin)
        );
    }
}

fn f_or_none(effects: &Effects) -> String {
    effects.block_test().as_ref().map_or_else(|| "no test".into(), f_test)
}
