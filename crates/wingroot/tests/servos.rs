//! Servos that are not those of the wing's file, in campaigns of the vortex lattice, which shares no line with what judges them:
//! within what the file knows of its servos they are no finding, beyond it they are named as what they are, quicker or slower.

use crate::vortex_campaigns::searched;
use discover::verdict::VerdictKind;
use hidden::TrueServos;
use hidden::plan::Hidden;

#[test]
fn servos_within_what_the_file_knows_of_them_are_no_finding() {
    if !crate::slow::runs("searches campaigns with a stiffer and a softer servo") {
        return;
    }
    // one standard deviation of frequency and damping, stiffer and softer
    for (name, frequency_hz, damping_ratio) in [("stiffer", 16.6, 0.875), ("softer", 13.5, 0.72)] {
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
    let count = if crate::slow::runs("searches the campaign with a slow servo, too") { 2 } else { 1 };
    for (name, servos) in all.into_iter().take(count) {
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
