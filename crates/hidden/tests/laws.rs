//! Laws of the generator: sizes of zero, sizes that show, seeds, and answers, on a coarse truth.

use hidden::campaign::Record;
use hidden::effects::{KINDS, Kind, Parameter, Role, Sign};
use hidden::plan::Hidden;
use hidden::{Bench, CasePlan, Class, Fineness, Mix, TrueServos, cases};
use std::path::Path;

fn bench() -> Bench {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    Bench::new(&path, Fineness::TEST).expect("the shipped wing")
}

fn plan(effects: Vec<Hidden>) -> CasePlan {
    CasePlan {
        list_seed: 0,
        index: 0,
        seed: 4711,
        class: Class::Single,
        effects,
        target_d2: None,
        defect: None,
        leave_out: None,
        wind_off: false,
        servos: TrueServos::Drawn,
    }
}

/// An effect of a kind, at a share of its largest size.
fn hidden(kind: &Kind, size: f64) -> Hidden {
    let value = |parameter: &Parameter| match (parameter.role, parameter.sign) {
        (Role::Size, Sign::Minus) => -size * parameter.high,
        (Role::Size, _) => size * parameter.high,
        (Role::Shape, _) => (parameter.low * parameter.high).sqrt(),
        (Role::Choice(_), _) => 1.0,
    };
    Hidden { name: kind.name.into(), values: kind.parameters.iter().map(value).collect() }
}

#[test]
fn effects_of_size_zero_change_no_byte() {
    let bench = bench();
    let none = bench.case(&plan(KINDS.iter().map(|kind| hidden(kind, 0.0)).collect()));
    assert!(none.files == bench.case(&plan(Vec::new())).files);
}

/// About 40 campaigns: with RUN_SLOW_TESTS=1 all kinds, else every eighth.
#[test]
fn every_effect_shows_at_its_largest_size_and_leaves_the_reference_alone() {
    let bench = bench();
    let without = bench.case(&plan(Vec::new()));
    let apart_by = if std::env::var_os("RUN_SLOW_TESTS").is_some() { 1 } else { 8 };
    for kind in KINDS.iter().step_by(apart_by) {
        // the noise is the same, so what differs is the effect
        let large = bench.case(&plan(vec![hidden(kind, 1.0)]));
        let noise = [0.2, 0.12, 0.05];
        let apart = |(a, b): (&Record, &Record)| {
            let largest = |c: usize| {
                a.loads[c].iter().zip(&b.loads[c]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / noise[c]
            };
            let angle = a.alpha_deg.iter().zip(&b.alpha_deg).map(|(a, b)| (a - b).abs() / 0.005);
            (0..3).map(largest).chain(angle).fold(0.0, f64::max)
        };
        let pairs = large.measured.records.iter().zip(&without.measured.records);
        let most = pairs.map(apart).fold(0.0, f64::max);
        assert!(most > 2.0, "{}: {most} standard deviations of a sample", kind.name);
        assert!(large.files.reference == without.files.reference, "{}", kind.name);
    }
}

#[test]
fn the_same_plan_gives_the_same_bytes_on_any_number_of_threads() {
    let plans = cases(3, 4, &Mix::default());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let bench = bench();
            plans
                .iter()
                .map(|plan| bench.case(plan))
                .map(|case| (case.files, case.answer))
                .collect::<Vec<_>>()
        })
    };
    let (one, three) = (on(1), on(3));
    assert!(one == three);
}

#[test]
fn weak_cases_have_the_detectability_they_are_scaled_to() {
    let bench = bench();
    for plan in cases(8, 3, &Mix::only(Class::Weak)) {
        let answer = bench.case(&plan).answer;
        let (d2, target) = (answer.d2.expect("an effect"), plan.target_d2.expect("weak"));
        assert!((d2 / target).ln().abs() < 0.3, "{:?}: {d2} for {target}", answer.effects[0].name);
    }
}

#[test]
fn twice_an_effect_is_seen_about_four_times_as_well() {
    let bench = bench();
    let d2 = |size: f64| {
        let hidden = Hidden { name: "ctl_scale".into(), values: vec![size] };
        bench.case(&plan(vec![hidden])).answer.d2.expect("an effect")
    };
    let ratio = d2(0.2) / d2(0.1);
    assert!((ratio - 4.0).abs() < 0.2, "{ratio}");
}

#[test]
fn without_wind_a_joiner_shows_and_a_lift_slope_does_not() {
    let bench = bench();
    let moment = |effects: Vec<Hidden>| -> Vec<f64> {
        let case = bench.case(&CasePlan { wind_off: true, ..plan(effects) });
        let entry = &case.files.measured[0].1;
        assert_eq!(entry.matches("wind_off: true").count(), 6);
        let run = case.measured.records.iter().find(|record| record.file == "wind_off_6hz.csv");
        run.expect("a run without wind").loads[2].clone()
    };
    let hidden = |name: &str, values: &[f64]| vec![Hidden { name: name.into(), values: values.to_vec() }];
    let without = moment(Vec::new());
    let apart = |with: Vec<f64>| with.iter().zip(&without).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // I alpha'' of a pitch of 5 degrees at 6 Hz: .1 times 5/2 degrees times (12 pi)², and what the filter leaves of it
    let joiner = apart(moment(hidden("joiner_inertia", &[0.1, 0.05, 0.05])));
    let largest = 0.1 * 2.5_f64.to_radians() * (12.0 * std::f64::consts::PI).powi(2);
    assert!((joiner / largest - 1.0).abs() < 0.1, "{joiner} for {largest}");
    // there is apparent mass alone, which no circulation changes (the flap's factor has no part in pitch)
    let slope = apart(moment(hidden("lift_slope", &[0.2])));
    assert!(slope < 1e-6 * joiner, "{slope}");
}
