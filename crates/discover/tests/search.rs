//! What is found, ranked and judged on problems whose answers are known.

use crate::known::{Known, effect, exact, nulls};
use discover::consistency::{scatter, shares};
use discover::current_model::CurrentModel;
use discover::detection_limit::detection_limits;
use discover::found::Outcome;
use discover::null_campaigns::{NullCampaign, NullStore, from_null_campaigns};
use discover::rank::rank;
use discover::search::search;
use discover::verdict::{Gap, Judgement, VerdictKind};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

fn searched(known: &Known) -> Outcome {
    search(&known.setting(), known.problem(), &nulls(25.0), 1).0
}

fn kind(known: &Known, outcome: &Outcome) -> VerdictKind {
    // gaps as the chi square a row has them; the floor is the noise
    let [before, after] = outcome.misfit.map(f64::sqrt);
    let training = Gap { before, after, floor: 0.9 };
    Judgement::new(&known.setting().rules().verdict, outcome, training, None).kind()
}

/// For `y = theta x + e` with e of variance one, theta normal with a standard deviation of one, and a further column z with
/// a normal amplitude of standard deviation s: with `(a, b)' = a'b - s² a'z z'b / (1 + s² z'z)` the logarithm of the Bayes
/// factor is `(x, y)² / (2 (1 + (x, x))) - ½ ln(1 + (x, x))`.
#[test]
fn the_log_bayes_factor_is_that_of_the_linear_gaussian_model() {
    for sigma in [0.0, 0.5] {
        let known = Known::new(exact(), &["pitch"], &[("pitch", [0.8, 0.8]), ("twin", [0.1, 0.1])]);
        let known = if sigma > 0.0 { known.uncertain_of("twin", sigma) } else { known };
        let inner = |a: &str, b: &str| {
            let weight = sigma * sigma / (1.0 + sigma * sigma * known.product("twin", "twin"));
            known.product(a, b) - weight * known.product(a, "twin") * known.product("twin", b)
        };
        let precision = 1.0 + inner("pitch", "pitch");
        let expected = 0.5 * inner("pitch", "measured").powi(2) / precision - 0.5 * precision.ln();
        let ranked = rank(&known.setting(), &known.bare(), &nulls(25.0));
        assert!((ranked[0].evidence - expected).abs() < 1e-6, "{} {expected}", ranked[0].evidence);
        let size = inner("pitch", "measured") / precision;
        assert!(
            (ranked[0].refit.active.values[0] - size).abs() < 1e-6,
            "{:?} {size}",
            ranked[0].refit.active
        );
        assert!((ranked[0].refit.sigma[0] - precision.sqrt().recip()).abs() < 1e-6);
    }
}

#[test]
fn candidates_are_ranked_by_evidence_and_judged_by_their_thresholds() {
    let known = Known::new(exact(), &["slope", "pitch"], &[("pitch", [0.8, 0.8])]);
    let mut limits = nulls(25.0);
    limits.evidence.insert("slope ".to_owned(), 40.0);
    let ranked = rank(&known.setting(), &known.bare(), &limits);
    let listed: Vec<(&str, f64)> = ranked.iter().map(|one| (one.name(), one.threshold)).collect();
    assert_eq!(listed, [("pitch", 25.0), ("slope", 40.0)]);
    assert!(ranked[0].evidence > 25.0 && ranked[1].evidence < 0.0);
}

#[test]
fn a_planted_effect_is_named_with_its_size_and_nothing_else() {
    let known = Known::new(exact(), &["pitch", "slope"], &[("pitch", [2.0, 2.0])]);
    let outcome = searched(&known);
    assert_eq!(outcome.names(), ["pitch"], "{:?}", outcome.trace);
    let found = &outcome.found[0];
    assert!((found.active.values[0] - 2.0).abs() < 3.0 * found.sigma[0], "{found:?}");
    assert!(outcome.misfit[0] > 1.2 && (outcome.misfit[1] - 0.81).abs() < 0.02, "{:?}", outcome.misfit);
    assert_eq!(kind(&known, &outcome), VerdictKind::Effects);
    assert!(!outcome.unexplained);
}

#[test]
fn noise_alone_names_nothing() {
    let known = Known::new(exact(), &["pitch", "twin", "slope"], &[]);
    let outcome = searched(&known);
    assert!(outcome.found.is_empty() && !outcome.unexplained, "{:?}", outcome.trace);
    assert_eq!(kind(&known, &outcome), VerdictKind::None);
    assert!(outcome.next_best.is_some_and(|best| best.evidence < 0.0));
}

#[test]
fn two_effects_are_both_named_and_no_more_than_the_rules_allow() {
    let planted = [("pitch", [2.0, 2.0]), ("slope", [1.5, 1.5])];
    let mut names = searched(&Known::new(exact(), &["pitch", "slope"], &planted)).names();
    names.sort_unstable();
    assert_eq!(names, ["pitch", "slope"]);
    let mut rules = exact();
    rules.naming.most_effects = 1;
    // the larger one, and what is left is said to be unexplained
    let known = Known::new(rules, &["pitch", "slope"], &planted);
    let outcome = searched(&known);
    assert_eq!(outcome.names(), ["pitch"], "{:?}", outcome.trace);
    assert!(outcome.unexplained);
}

#[test]
fn collinear_candidates_are_ambiguous() {
    let known = Known::new(exact(), &["pitch", "twin", "slope"], &[("pitch", [2.0, 2.0])]);
    let outcome = searched(&known);
    assert_eq!(outcome.found.len(), 1, "{:?}", outcome.trace);
    let found = &outcome.found[0];
    let mut set = vec![found.name()];
    set.extend(&found.confused_with);
    set.sort_unstable();
    assert_eq!(set, ["pitch", "twin"]);
    assert_eq!(found.rivals.len(), 1);
    assert_eq!(kind(&known, &outcome), VerdictKind::Ambiguous);
}

#[test]
fn what_no_column_of_the_library_explains_is_unknown_and_unnamed() {
    let known = Known::new(exact(), &["pitch", "slope"], &[("stranger", [3.0, 3.0])]);
    let outcome = searched(&known);
    assert!(outcome.found.is_empty() && outcome.unexplained, "{:?}", outcome.trace);
    assert_eq!(kind(&known, &outcome), VerdictKind::Unknown);
}

#[test]
fn an_effect_that_has_another_size_at_each_airspeed_only_resembles() {
    let known = Known::new(exact(), &["pitch", "slope"], &[("pitch", [-4.0, 4.0])]);
    let outcome = searched(&known);
    assert!(outcome.found.is_empty() && outcome.unexplained, "{:?}", outcome.trace);
    // the size of each airspeed over the one that was fitted to both: they scatter, and equal ones do not
    let setting = known.setting();
    let of = |known: &Known, size: f64| {
        let current = CurrentModel::new(&setting, known.problem(), &[effect("pitch", size)]);
        shares(&setting, &current.strict(0), 0)
    };
    let apart = of(&known, 4.0);
    assert_eq!(apart.len(), 2);
    assert!((apart[0].share + 1.0).abs() < 0.3 && (apart[1].share - 1.0).abs() < 0.1, "{apart:?}");
    let rules = setting.rules();
    assert!(
        scatter(rules, &effect("pitch", 4.0), &apart).is_some_and(|chi2| chi2 > rules.consistency.scatter)
    );
    let alike = of(&Known::new(exact(), &["pitch"], &[("pitch", [4.0, 4.0])]), 4.0);
    assert!(scatter(rules, &effect("pitch", 4.0), &alike).is_some_and(|chi2| chi2 < 0.1), "{alike:?}");
    // one part alone judges nothing
    assert_eq!(scatter(rules, &effect("pitch", 4.0), &alike[..1]), None);
}

#[test]
fn what_calibration_leaves_open_is_not_named() {
    let planted = [("pitch", [2.0, 2.0])];
    let known = Known::new(exact(), &["pitch", "slope"], &planted).uncertain_of("pitch", 2.0);
    let outcome = searched(&known);
    assert!(outcome.found.is_empty(), "{:?}", outcome.trace);
}

/// Loads that are a tenth too large everywhere, at points of an airspeed that may be off by a gain g together: of what is left,
/// d, chi square keeps `d²/(1 + g² s²)`, s the simulated loads.
#[test]
fn points_may_be_off_by_their_tolerance() {
    let size = 9.0;
    let off = |gain: f64| {
        let mut rules = exact();
        rules.tolerance.static_gain = gain;
        let known = Known::new(rules, &["pitch"], &[("pitch", [1.1 * size; 2])]);
        CurrentModel::new(&known.setting(), known.problem(), &[effect("pitch", size)]).chi2
    };
    let noise = 0.81 * 2.0 * crate::known::POINTS as f64;
    let kept = |gain: f64| -> f64 {
        let square = |airspeed: usize| -> f64 {
            (0..crate::known::POINTS)
                .map(|i| (size * crate::known::column("pitch", airspeed, i)).powi(2))
                .sum()
        };
        [0, 1].map(square).map(|s2| 0.01 * s2 / (1.0 + gain * gain * s2)).iter().sum()
    };
    for gain in [0.0, 0.05, 0.1, 1.0] {
        assert!((off(gain) - noise - kept(gain)).abs() < 0.3, "{gain}: {} {}", off(gain) - noise, kept(gain));
    }
    assert!(kept(0.0) > 90.0 && kept(1.0) < 0.1);
}

/// Evidence of an effect of exact form with `I = (x, x)`, at a size s: `½ (I s² - s² - ln(1 + I s²))`.
#[test]
fn the_detection_limit_is_where_the_evidence_is_the_threshold() {
    let known = Known::new(exact(), &["pitch"], &[]);
    let information = known.product("pitch", "pitch");
    let evidence = |s: f64| 0.5 * (information * s * s - s * s - (information * s * s).ln_1p());
    let limits = detection_limits(&known.setting(), &known.bare(), &nulls(25.0));
    assert_eq!((limits.len(), &*limits[0].name, &*limits[0].parameter), (1, "pitch", "size"));
    let size = limits[0].value.expect("within bounds");
    assert!(evidence(size) >= 25.0 && evidence(size / 1.415) < 25.0, "{size}: {}", evidence(size));
    // what would have to be larger than it can be has none
    let none = detection_limits(&known.setting(), &known.bare(), &nulls(1e6));
    assert_eq!(none[0].value, None);
}

#[test]
fn null_campaigns_have_a_misfit_of_one_and_thresholds_above_model_form() {
    let known = Known::new(exact(), &["pitch", "slope"], &[("pitch", [5.0, 5.0])]);
    let judged = [known.problem(), known.problem()];
    let made = |seed: u64| from_null_campaigns(&known.setting(), known.problem(), &judged, seed, &());
    let nulls = made(1);
    // 20 campaigns of 400 rows of unit noise, whatever was measured
    assert!((nulls.misfit - 1.0).abs() < 0.05 && nulls.misfit_limit > nulls.misfit + 0.15, "{nulls:?}");
    assert!(nulls.floor.iter().all(|floor| (floor - 1.0).abs() < 0.03), "{:?}", nulls.floor);
    // noise alone varies hardly enough for model form to account for anything
    let least = known.setting().rules().naming.least;
    assert!(nulls.model_form < 0.1 && nulls.evidence.values().all(|needed| *needed == least), "{nulls:?}");
    assert!(made(1) == nulls && made(2) != nulls);
}

#[test]
fn what_model_form_accounts_for_goes_with_the_square_of_how_loads_vary_over_the_noise() {
    let made = |share: f64| {
        let mut rules = exact();
        rules.naming.model_form = share;
        let known = Known::new(rules, &["pitch", "slope"], &[("pitch", [5.0, 5.0])]);
        let judged = [known.problem(), known.problem()];
        from_null_campaigns(&known.setting(), known.problem(), &judged, 1, &())
    };
    // 400 rows of unit noise
    let (half, whole) = (made(0.5), made(1.0));
    assert!((half.model_form / (0.5 * 0.25 * 400.0) - 1.0).abs() < 0.05, "{}", half.model_form);
    assert!((whole.model_form / half.model_form - 4.0).abs() < 1e-9);
    for (label, needed) in &whole.evidence {
        let more = needed - half.evidence[label];
        assert!((more - (whole.model_form - half.model_form)).abs() < 1e-9, "{label}: {more}");
    }
}

/// Campaigns of a run that was stopped.
#[derive(Default)]
struct Stopped {
    kept: Mutex<BTreeMap<u64, NullCampaign>>,
    flown: AtomicUsize,
}

impl NullStore for Stopped {
    fn get(&self, k: u64) -> Option<NullCampaign> {
        self.kept.lock().expect("no other panicked").get(&k).cloned()
    }

    fn put(&self, k: u64, campaign: &NullCampaign, _: f64) {
        self.flown.fetch_add(1, Ordering::Relaxed);
        self.kept.lock().expect("no other panicked").insert(k, campaign.clone());
    }
}

#[test]
fn null_campaigns_that_a_stopped_run_kept_are_not_flown_again_and_change_nothing() {
    let known = Known::new(exact(), &["pitch", "slope"], &[("pitch", [5.0, 5.0])]);
    let judged = [known.problem(), known.problem()];
    let made =
        |store: &dyn NullStore| from_null_campaigns(&known.setting(), known.problem(), &judged, 1, store);
    let store = Stopped::default();
    let whole = made(&store);
    let campaigns = store.flown.swap(0, Ordering::Relaxed);
    store.kept.lock().expect("no other panicked").retain(|k, _| k % 3 == 1);
    let left = store.kept.lock().expect("no other panicked").len();
    assert_eq!(made(&store), whole);
    assert_eq!(store.flown.load(Ordering::Relaxed), campaigns - left);
}
