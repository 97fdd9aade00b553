//! The data checks name every defect that is put into the shipped campaign, and nothing where only the model is wrong.

use crate::common::{Flight, shipped};
use discover::data::Dataset;
use discover::data_checks::{Defect, DefectKind, defects, rough_noise};
use maneuver::effects::{Active, library};

fn checked(flight: &Flight, data: &Dataset) -> Vec<Defect> {
    defects(data, &flight.flown, &rough_noise(data))
}

/// The only defect that a change of the shipped campaign brings.
fn only(change: impl Fn(&mut Dataset)) -> Defect {
    let flight = shipped();
    let mut data = flight.data.clone();
    change(&mut data);
    let mut found = checked(flight, &data);
    assert_eq!(found.len(), 1, "{found:#?}");
    found.remove(0)
}

fn names(defect: &Defect, kind: DefectKind, run: Option<&str>, channel: Option<&str>) {
    assert_eq!(
        (defect.kind, defect.run.as_deref(), defect.channel.as_deref()),
        (kind, run, channel),
        "{defect:?}"
    );
    assert!(defect.sentence.contains(run.unwrap_or("all data")), "{}", defect.sentence);
    assert!(defect.sentence.contains(channel.unwrap_or("")), "{}", defect.sentence);
}

#[test]
fn the_shipped_campaign_passes() {
    let flight = shipped();
    let found = checked(flight, &flight.data);
    assert!(found.is_empty(), "{found:#?}");
}

/// At its upper and lower bounds with RUN_SLOW_TESTS=1, else at one of them in turn.
#[test]
fn every_effect_at_its_bounds_passes() {
    let flight = shipped();
    let all = std::env::var_os("RUN_SLOW_TESTS").is_some();
    let mut fired = Vec::new();
    for (number, effect) in library(&flight.controls).into_iter().enumerate() {
        for upper in [false, true].into_iter().filter(|upper| all || *upper == (number % 2 == 0)) {
            let bound = |p: maneuver::effects::Parameter| if upper { p.upper } else { p.lower };
            let values: Vec<f64> = effect.parameters().into_iter().map(bound).collect();
            let active = Active::new(effect.clone(), &values);
            if active.is_zero() {
                continue;
            }
            let truth = flight.with(std::slice::from_ref(&active));
            let found = checked(flight, &flight.pretend(&truth, 7));
            if !found.is_empty() {
                fired.push(format!(
                    "{} {} {:?}: {} {:?}",
                    effect.spec().name,
                    effect.form(),
                    active.values,
                    found.len(),
                    found[0]
                ));
            }
        }
    }
    assert!(fired.is_empty(), "{}", fired.join("\n"));
}

#[test]
fn exchanged_labels_are_named_in_a_run_and_everywhere() {
    let run = shipped().run("doublet_middle_15_26");
    let found = only(|data| data.runs[run].measured.swap(0, 1));
    names(&found, DefectKind::SwappedChannels, Some("doublet_middle_15_26"), Some("Fz_N"));
    let found = only(|data| data.runs[run].measured.swap(1, 2));
    names(&found, DefectKind::SwappedChannels, Some("doublet_middle_15_26"), Some("Mx_Nm"));
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        let found = only(|data| {
            data.runs.iter_mut().for_each(|run| run.measured.swap(a, b));
            data.statics.iter_mut().flat_map(|group| &mut group.measured).for_each(|loads| loads.swap(a, b));
        });
        names(&found, DefectKind::SwappedChannels, None, Some(["Fz_N", "Mx_Nm", "My_Nm"][a]));
    }
}

#[test]
fn a_flipped_sign_is_named_in_a_run_and_everywhere() {
    for (name, c, channel) in
        [("aoa_2hz_30", 2, "My_Nm"), ("chirp_outer_5_22", 0, "Fz_N"), ("wind_off_4hz", 1, "Mx_Nm")]
    {
        let run = shipped().run(name);
        let found = only(|data| data.runs[run].measured[c].iter_mut().for_each(|value| *value = -*value));
        names(&found, DefectKind::SignFlipped, Some(name), Some(channel));
    }
    for (c, channel) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().enumerate() {
        let found = only(|data| {
            let runs = data.runs.iter_mut().flat_map(|run| &mut run.measured[c]);
            let points = data.statics.iter_mut().flat_map(|group| &mut group.measured);
            runs.chain(points.filter_map(|loads| loads[c].as_mut())).for_each(|value| *value = -*value);
        });
        names(&found, DefectKind::SignFlipped, None, Some(channel));
    }
}

/// What is wrong in the runs alone is said so: the static points were taken with another program.
#[test]
fn what_is_wrong_in_all_runs_alone_is_not_said_of_all_data() {
    for c in 0..3 {
        let found =
            only(|data| data.runs.iter_mut().flat_map(|run| &mut run.measured[c]).for_each(|v| *v = -*v));
        assert_eq!((found.kind, &found.run), (DefectKind::SignFlipped, &None));
        assert!(found.sentence.contains("in all runs and not in the static points"), "{}", found.sentence);
    }
    let found = only(|data| data.runs.iter_mut().for_each(|run| run.measured.swap(1, 2)));
    assert_eq!((found.kind, &found.run), (DefectKind::SwappedChannels, &None));
    assert!(
        found.sentence.contains("exchanged in all runs and not in the static points"),
        "{}",
        found.sentence
    );
}

/// A wing that turns nose down as its tip goes up has moments that are each other's opposites, nearly: exchanged, both go against
/// their simulations.
#[test]
fn exchanged_moments_that_go_against_each_other_are_no_two_signs() {
    let flight = shipped();
    for seed in [3, 4] {
        let joiner = library(&flight.controls).into_iter().find(|e| e.spec().name == "joiner_inertia");
        let joiner = Active::new(joiner.expect("an effect"), &[-0.1, 0.3, -0.1, 0.1]);
        let mut data = flight.pretend(&flight.with(&[joiner]), seed);
        data.runs.iter_mut().for_each(|run| run.measured.swap(1, 2));
        data.statics.iter_mut().flat_map(|group| &mut group.measured).for_each(|loads| loads.swap(1, 2));
        let found = checked(flight, &data);
        let kinds: Vec<DefectKind> = found.iter().map(|defect| defect.kind).collect();
        assert_eq!(kinds, [DefectKind::SwappedChannels], "{found:#?}");
    }
}

/// Twice a hundred (a range of the amplifier), pounds in a run (4.448), and inches for metres in moments (39.37).
#[test]
fn a_channel_of_another_scale_is_named_in_its_runs_alone() {
    let flight = shipped();
    for (names, c, factor, channel) in [
        (["doublet_inner_15_30", "aoa_2hz_30"], 1, 100.0, "Mx_Nm"),
        (["chirp_outer_5_22", "doublet_middle_15_22"], 0, 1.0 / 4.448, "Fz_N"),
        (["aoa_0p5hz_30", "aoa_4hz_30"], 2, 39.37, "My_Nm"),
    ] {
        let mut data = flight.data.clone();
        for name in names {
            data.runs[flight.run(name)].measured[c].iter_mut().for_each(|value| *value *= factor);
        }
        let mut found = checked(flight, &data);
        found.retain(|defect| defect.kind != DefectKind::Repeat);
        let mut said: Vec<_> =
            found.iter().map(|d| (d.kind, d.run.as_deref(), d.channel.as_deref())).collect();
        let mut expected = names.map(|name| (DefectKind::Scaled, Some(name), Some(channel)));
        said.sort_by_key(|one| one.1);
        expected.sort_by_key(|one| one.1);
        assert_eq!(said, expected, "{found:#?}");
    }
}

#[test]
fn a_wrong_airspeed_is_named_with_its_estimate() {
    // measured at 30 m/s, labelled 34, and the other way round
    for (name, other, v_m_s) in [
        ("doublet_inner_15_34", "doublet_inner_15_30", 30.0),
        ("chirp_middle_5_22", "chirp_middle_5_18", 18.0),
        ("doublet_outer_5_30", "doublet_outer_5_34", 34.0),
    ] {
        let (run, other) = (shipped().run(name), shipped().run(other));
        let found = only(|data| data.runs[run].measured = data.runs[other].measured.clone());
        names(&found, DefectKind::WrongAirspeed, Some(name), None);
        let words: Vec<&str> = found.sentence.split_whitespace().collect();
        let at = words.iter().rposition(|word| *word == "at").expect("the estimate");
        let estimate: f64 = words[at + 1].parse().expect("a number");
        assert!((estimate / v_m_s - 1.0).abs() < 0.05, "{}", found.sentence);
    }
}

#[test]
fn a_clipped_and_a_stuck_channel_are_named() {
    let run = shipped().run("chirp_inner_5_30");
    let found = only(|data| {
        let values = &mut data.runs[run].measured[0];
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        for value in values {
            *value = value.min(mean + 0.6 * (most - mean));
        }
    });
    names(&found, DefectKind::Clipped, Some("chirp_inner_5_30"), Some("Fz_N"));
    let run = shipped().run("aoa_0p5hz_30_day_1");
    let found = only(|data| {
        let values = &mut data.runs[run].measured[2];
        let from = values.len() / 3;
        let stands = values[from];
        values[from..].iter_mut().for_each(|value| *value = stands);
    });
    names(&found, DefectKind::Stuck, Some("aoa_0p5hz_30_day_1"), Some("My_Nm"));
}

#[test]
fn a_late_run_is_named_and_late_runs_all_together_are_not() {
    for (name, samples) in [("aoa_4hz_30", 6), ("doublet_outer_15_22", 5), ("chirp_middle_5_34", 4)] {
        let run = shipped().run(name);
        let found = only(|data| {
            for values in &mut data.runs[run].measured {
                values.rotate_right(samples);
            }
        });
        names(&found, DefectKind::Lag, Some(name), None);
    }
    let flight = shipped();
    let mut data = flight.data.clone();
    let records = data.runs.iter_mut().flat_map(|run| &mut run.measured);
    records.for_each(|values| values.rotate_right(6));
    let found = checked(flight, &data);
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn spikes_are_named() {
    let run = shipped().run("doublet_inner_25_30");
    // one sample behind a filter
    let found = only(|data| {
        for (i, share) in [(249, 0.5), (250, 1.0), (251, 0.5)] {
            data.runs[run].measured[1][i] += 12.0 * share;
        }
    });
    names(&found, DefectKind::Spikes, Some("doublet_inner_25_30"), Some("Mx_Nm"));
}

#[test]
fn a_repeat_that_does_not_repeat_is_named() {
    let run = shipped().run("doublet_inner_25_30");
    let found = only(|data| {
        let mut change = 0.0;
        for (i, value) in data.runs[run].measured[0].iter_mut().enumerate() {
            // a slow wave that no peer has
            change += 0.05 * (i as f64 * 0.03).cos() * 4.0;
            *value += 2.0 * change;
        }
    });
    names(&found, DefectKind::Repeat, Some("doublet_inner_25_30"), Some("Fz_N"));
}
