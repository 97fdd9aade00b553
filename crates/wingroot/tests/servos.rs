//! Servos that are not those of the wing's file, in campaigns of the vortex lattice, which shares no line with what judges them:
//! within what the file knows of its servos they are no finding, beyond it they are named as what they are, quicker or slower.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use coupling::ElasticWing;
use discover::analysis::{Prepared, Rigs};
use discover::finding::Finding;
use discover::null_distribution::NullDistribution;
use discover::result::DiscoverResult;
use discover::rules::{EffectRules, Rules};
use discover::verdict::VerdictKind;
use hidden::plan::Hidden;
use hidden::{Bench, CasePlan, Class, Fineness, Mix, TrueServos, cases};
use wingroot::blind::read;

fn wing_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron")
}

fn bench() -> &'static Bench {
    static BENCH: OnceLock<Bench> = OnceLock::new();
    BENCH.get_or_init(|| {
        let bench = Bench::new(&wing_file(), Fineness::TEST).expect("the shipped wing");
        bench.with_vortices(&wing_file()).expect("the shipped wing")
    })
}

/// Searches a campaign of a wing with these servos, and with what else is hidden. Thresholds are bare margins; where nothing is
/// missing, campaigns of the vortex lattice have a misfit of about one and gaps of 2.2 and 2.4.
fn searched(name: &str, servos: TrueServos, effects: Vec<Hidden>) -> (DiscoverResult, Vec<String>) {
    let plan = cases(43, 1, &Mix::only(Class::Null)).remove(0);
    let plan = CasePlan { servos, effects, ..plan };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("servos_{name}"));
    bench().case(&plan).files.write(&folder).expect("a generated case");
    let (file, elastic) = ElasticWing::read(&wing_file()).expect("the shipped wing");
    let rigs = Rigs::new(&file, &elastic, None, Rules::default()).expect("the shipped wing");
    let prepared: Prepared = read(&rigs, &folder, false, None).expect("a generated case").prepared;
    let library = maneuver::effects::library(&["any".to_owned()]);
    let margins = NullDistribution::of_margins(&library, &EffectRules::default());
    let nulls = NullDistribution { misfit: 1.0, misfit_limit: 1.4, floor: [2.2, 2.4], ..margins };
    let finding = Finding::search(&prepared, &nulls, plan.seed);
    let result = finding.result(&discover::finding::Sources::default(), false, 0.0);
    let mut trace = finding.report.outcome.trace.clone();
    let first = finding.report.outcome.first_ranking.iter().take(8);
    trace.extend(
        first.map(|one| format!("{} {:.0} {:?}", one.label(), one.evidence, one.refit.active.values)),
    );
    (result, trace)
}

/// Both campaigns of a test with RUN_SLOW_TESTS=1, else the first; `other` is the one that is left out.
fn campaigns(other: &str) -> usize {
    if std::env::var_os("RUN_SLOW_TESTS").is_some() {
        return 2;
    }
    let _ = writeln!(std::io::stderr(), "skipped: RUN_SLOW_TESTS=1 searches the campaign with {other}, too");
    1
}

#[test]
fn servos_within_what_the_file_knows_of_them_are_no_finding() {
    // one standard deviation of frequency and damping, stiffer and softer
    let all = [("stiffer", 16.6, 0.875), ("softer", 13.5, 0.72)];
    for (name, frequency_hz, damping_ratio) in all.into_iter().take(campaigns("a softer servo")) {
        let servos = TrueServos::SecondOrder { frequency_hz, damping_ratio };
        let (result, trace) = searched(name, servos, Vec::new());
        let named: Vec<&str> = result.effects.iter().map(|effect| effect.name.as_str()).collect();
        assert!(named.is_empty(), "{frequency_hz} Hz, {damping_ratio}: {named:?} {trace:?}");
    }
}

#[test]
fn servos_beyond_what_the_file_knows_of_them_are_named_quicker_or_slower() {
    let slow = TrueServos::SecondOrder { frequency_hz: 7.0, damping_ratio: 0.8 };
    let all = [("none", TrueServos::None), ("slow", slow)];
    for (name, servos) in all.into_iter().take(campaigns("a slow servo")) {
        let (result, trace) = searched(name, servos, Vec::new());
        let named: Vec<&str> = result.effects.iter().map(|effect| effect.name.as_str()).collect();
        assert_eq!(named, ["act_lag"], "{name}: {trace:?}");
        assert!(matches!(result.verdict, VerdictKind::Effects | VerdictKind::Ambiguous));
        // quicker only another servo can be; slower one more lag, too
        let share = result.effects[0].parameters.get("period_share").map(|share| share.value);
        match servos {
            TrueServos::None => {
                assert!(share.is_some_and(|share| share < -0.8), "{name}: {share:?} {trace:?}");
            }
            _ => {
                assert!(
                    share.is_none_or(|share| (share - 15.0 / 7.0 + 1.0).abs() < 0.3),
                    "{name}: {share:?}"
                );
            }
        }
        let gap = result.gap().expect("gaps").holdout;
        assert!(gap.after < 0.8 * gap.before, "{name}: {} -> {}", gap.before, gap.after);
    }
}

/// The true saturation stands behind the servo, in a form of its own (1/sqrt(1 + x²)): a stop of the surface.
#[test]
fn a_saturation_behind_the_servo_is_named_and_closes_the_gap() {
    let saturation = Hidden { name: "ctl_saturation".to_owned(), values: vec![3.0] };
    let (result, trace) = searched("saturation", TrueServos::Drawn, vec![saturation]);
    let named: Vec<&str> = result.effects.iter().map(|effect| effect.name.as_str()).collect();
    assert_eq!(named, ["ctl_saturation"], "{trace:?}");
    assert_eq!(result.effects[0].form, "tanh behind the servo", "{trace:?}");
    let gap = result.gap().expect("gaps").holdout;
    assert!(gap.after < 0.4 * gap.before, "{} -> {}", gap.before, gap.after);
}
