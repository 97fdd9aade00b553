//! What `response` writes: result.json and the tables of terms, curves, points and effects as CSV.

use response::{Analysis, Coefficient, Effects, PureError, TableAnalysis, TableStudy, Term};

use super::response_result::{
    BlocksResult, CandidateLeftOut, EffectsResult, OrReason, PureErrorResult, RandomBlocks, SurfaceResult,
    TermResult, Tests, TwoLevelEffect,
};

/// A table of its head and its rows.
pub(super) fn csv(head: &str, rows: impl IntoIterator<Item = String>) -> String {
    std::iter::once(head.to_owned()).chain(rows).map(|line| line + "\n").collect()
}

/// What was added to and taken out of terms.
pub(super) fn change(before: &[Term], after: &[Term]) -> String {
    let added = after.iter().filter(|term| !before.contains(term)).map(|term| format!("+ {term}"));
    let gone = before.iter().filter(|term| !after.contains(term)).map(|term| format!("- {term}"));
    added.chain(gone).collect::<Vec<_>>().join(" ")
}

/// One response in result.json.
pub(super) fn response(study: &TableStudy, table: &TableAnalysis, analysis: &Analysis) -> SurfaceResult {
    let choice = &analysis.choice;
    let (fitted, chosen) = (&choice.fitted, &choice.curve[choice.chosen].criteria);
    let term = |c: &Coefficient| TermResult {
        term: c.term.clone(),
        coefficient: c.value,
        standard_error: c.standard_error,
        t: c.t,
        p_value: c.p_value,
        interval: c.interval(study.level, fitted.degrees_of_freedom).ok(),
    };
    let left_out = |(term, others): &(Term, String)| CandidateLeftOut {
        term: term.clone(),
        not_told_from: others.clone(),
    };
    let two_level = table.effects.iter().find(|e| e.response == fitted.response);
    SurfaceResult {
        name: fitted.response.clone(),
        data: study.data.clone(),
        points: table.data.points(),
        terms: fitted.coefficients.iter().map(term).collect(),
        r2: chosen.r_squared,
        adjusted_r2: chosen.adjusted_r_squared,
        pse: chosen.pse,
        mse: chosen.mse,
        bic: chosen.bic,
        leave_one_out: chosen.leave_one_out,
        sigma0_squared: choice.sigma0_squared,
        level: study.level,
        degrees_of_freedom: fitted.degrees_of_freedom,
        error_standard_deviation: fitted.error_variance.sqrt(),
        search_complete: choice.complete,
        curve_complete: choice.curve_complete,
        candidates: table.candidates.clone(),
        candidates_left_out: table.left_out.iter().map(left_out).collect(),
        curve: choice.curve.clone(),
        tests: tests(analysis),
        block_offsets: fitted.offsets.clone(),
        effects: two_level.map(|found| effects(study, found)),
    }
}

fn pure(error: &PureError) -> PureErrorResult {
    PureErrorResult {
        standard_deviation: error.variance().sqrt(),
        sum: error.sum,
        degrees_of_freedom: error.degrees_of_freedom,
    }
}

fn tests(analysis: &Analysis) -> Tests {
    Tests {
        all_terms: OrReason::of(&analysis.all_terms, |test| *test),
        pure_error: OrReason::of(&analysis.pure_error, pure),
        lack_of_fit: OrReason::of(&analysis.lack_of_fit, |test| *test),
        blocks: analysis.block_share.as_ref().map(|share| {
            OrReason::of(share, |share| BlocksResult {
                share_of_pure_error: share.removed(),
                test: share.test(),
                without: pure(&share.without),
                with: pure(&share.with),
            })
        }),
        random_blocks: analysis.random_blocks.as_ref().map(|random| {
            OrReason::of(random, |fitted| RandomBlocks {
                between: fitted.block_variance.sqrt(),
                within: fitted.error_variance.sqrt(),
            })
        }),
        left_out_blocks_rms: analysis
            .left_out_blocks
            .as_ref()
            .map(|left| OrReason::of(left, |square| square.sqrt())),
        least_significant_difference: analysis.least_significant_difference,
    }
}

fn effects(study: &TableStudy, effects: &Effects) -> EffectsResult {
    let of_effect = |effect: &response::Effect| TwoLevelEffect {
        term: effect.term.clone(),
        value: effect.value,
        sum_of_squares: effect.sum_of_squares,
        standard_error: effect.test.map(|t| t.standard_error),
        t: effect.test.map(|t| t.t),
        p_value: effect.test.map(|t| t.p_value),
        significant: effect.test.map(|t| t.significant),
        found_with_90_percent_from: effect.test.and_then(|t| effects.detectable(&t, study.level, 0.9).ok()),
        not_told_from: aliases(effect),
    };
    EffectsResult {
        mean: effects.mean,
        degrees_of_freedom: effects.degrees_of_freedom,
        residual_sum: effects.residual_sum,
        block_degrees_of_freedom: effects.block_degrees_of_freedom,
        block_sum: effects.block_sum,
        effects: effects.effects.iter().map(of_effect).collect(),
        lenth: effects.lenth,
    }
}

/// What an effect is not told from, with its sign.
pub(super) fn aliases(effect: &response::Effect) -> Vec<String> {
    let signed = |(term, opposite): &(Term, bool)| format!("{}{term}", if *opposite { "-" } else { "" });
    effect.aliases.iter().map(signed).collect()
}

/// Terms and coefficients.
pub(super) fn terms_csv(study: &TableStudy, analysis: &Analysis) -> String {
    let fitted = &analysis.choice.fitted;
    let rows = fitted.coefficients.iter().map(|c| {
        let (low, high) = c.interval(study.level, fitted.degrees_of_freedom).unwrap_or((f64::NAN, f64::NAN));
        let (value, error, t, p) = (c.value, c.standard_error, c.t, c.p_value);
        format!("{},{value:e},{error:e},{t:e},{p:e},{low:e},{high:e}", c.term)
    });
    csv("term,coefficient,standard_error,t,p_value,low,high", rows)
}

/// The curve over the number of terms.
pub(super) fn curve_csv(analysis: &Analysis) -> String {
    let steps = &analysis.choice.curve;
    let rows = steps.iter().enumerate().map(|(index, step)| {
        let c = &step.criteria;
        let before = index.checked_sub(1).map_or(&[][..], |before| &steps[before].terms);
        let (chosen, changed) = (u8::from(index == analysis.choice.chosen), change(before, &step.terms));
        format!(
            "{},{chosen},{:e},{:e},{:.8},{:.8},{:e},{:.6},{changed}",
            c.terms, c.pse, c.mse, c.r_squared, c.adjusted_r_squared, c.leave_one_out, c.bic
        )
    });
    csv("terms,chosen,pse,mse,r2,adjusted_r2,leave_one_out,bic,from_the_size_before", rows)
}

/// Measured and fitted values of all points; offsets of blocks are in the fitted ones.
pub(super) fn points_csv(table: &TableAnalysis, analysis: &Analysis) -> String {
    let (data, fitted) = (&table.data, &analysis.choice.fitted);
    let blocks = data.blocks().iter().map(|blocks| blocks.name.as_str());
    let head: Vec<&str> = blocks.chain(data.factor_names()).collect();
    let measured = data.response_values(&fitted.response).unwrap_or_default();
    let rows = measured.iter().enumerate().map(|(point, measured)| {
        let labels = data.blocks().iter().map(|blocks| blocks.labels[blocks.of_point[point]].clone());
        let values = data.point(point).into_iter().map(|(_, value)| value.to_string());
        let place: Vec<String> = labels.chain(values).collect();
        let (residual, leverage) = (fitted.residuals[point], fitted.leverages[point]);
        format!("{},{measured},{},{residual:e},{leverage:.6}", place.join(","), measured - residual)
    });
    csv(&format!("{},{},fitted,residual,leverage", head.join(","), fitted.response), rows)
}

/// Effects of all responses of a table.
pub(super) fn effects_csv(table: &TableAnalysis) -> String {
    let all = table.effects.iter().flat_map(|of_response| {
        of_response.effects.iter().map(move |effect| (of_response.response.as_str(), effect))
    });
    let rows = all.map(|(response, effect)| {
        let tested = effect.test.as_ref().map_or_else(
            || ",,".to_string(),
            |test| format!("{:e},{:e},{:e}", test.standard_error, test.t, test.p_value),
        );
        let (value, sum, aliases) = (effect.value, effect.sum_of_squares, aliases(effect).join(" "));
        format!("{response},{},{value:e},{sum:e},{tested},{aliases}", effect.term)
    });
    csv("response,effect,value,sum_of_squares,standard_error,t,p_value,not_told_from", rows)
}
