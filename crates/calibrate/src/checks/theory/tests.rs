//! Further from theory than panel models are, and what is left open.

use super::super::lines::LineNoise;
use super::*;
use crate::checks::finding::Weight;
use crate::sensors::{Reading, Sensor, Zero};
use crate::tests::{Toy, point};

fn measured(channels: [bool; 3], factors: &[[f64; 2]]) -> Vec<Lines> {
    let theory = ByLoad {
        fz: Line { slope: 100.0, at_zero: 4.0 },
        mx: Line { slope: 70.0, at_zero: 3.0 },
        my: Line { slope: -5.0, at_zero: 0.6 },
    };
    let of = |&[fz, mx]: &[f64; 2]| Lines {
        v_m_s: 10.0,
        measured: ByLoad { fz: theory.fz.times(fz, fz), mx: theory.mx.times(mx, mx), ..theory },
        theory,
        noise: ByLoad::from_fn(|_| LineNoise::default()),
        chord_m: 0.4,
        channels: ByLoad::from_array(channels),
    };
    factors.iter().map(of).collect()
}

fn said(channels: [bool; 3], factors: &[[f64; 2]]) -> Vec<String> {
    far_from_theory(&measured(channels, factors)).into_iter().map(|found| found.sentence).collect()
}

#[test]
fn lift_slopes_and_arms_of_most_airspeeds_are_compared_with_theory() {
    let all = [true; 3];
    for good in [[1.0, 1.0], [0.86, 0.86], [1.14, 1.14], [1.0, 0.91], [1.0, 1.09]] {
        assert!(said(all, &[good]).is_empty(), "{good:?}");
    }
    let lift = said(all, &[[1.0, 1.0], [1.44, 1.44], [1.44, 1.44]]);
    assert!(
        lift.len() == 1 && lift[0].contains("1.44 times") && lift[0].contains("+44 % off (airspeed +20 %)"),
        "{lift:?}"
    );
    let less = said(all, &[[0.81, 0.81]]);
    assert!(less[0].contains("0.81 times") && less[0].contains("-19 % off (airspeed -10 %)"), "{less:?}");
    assert!(said(all, &[[1.0, 1.0], [1.0, 1.0], [1.44, 1.44]]).is_empty(), "one of three");
    let arm = said(all, &[[1.0, 1.2]]);
    assert!(
        arm.len() == 1 && arm[0].contains("0.840 m from the balance's axis, 0.700 m by theory"),
        "{arm:?}"
    );
    // without the lift, its moment says it; without the moment, no arm is known
    let moment = said([false, true, true], &[[9.0, 1.44]]);
    assert!(moment.len() == 1 && moment[0].contains("1.44 times"), "{moment:?}");
    assert!(said([true, false, true], &[[1.0, 1.5]]).is_empty());
    assert!(said([false, false, true], &[[9.0, 9.0]]).is_empty() && said(all, &[]).is_empty());
}

#[test]
fn a_load_at_zero_angle_may_be_the_weight_where_nothing_with_wind_off_tells() {
    let toy = Toy::new(2, 2);
    let mut campaign = toy.measured(&[10.0], &[0.0, 0.1, 0.2], &toy.uniform(1.0));
    let weight = |fz_n: f64| RootLoads { fz_n, ..RootLoads::default() };
    let found = |less_n: f64, fz_n: f64, fz: bool, campaign: &Campaign| {
        let mut lines = measured([fz, true, true], &[[1.0, 1.0]]);
        lines[0].measured.fz.at_zero -= less_n;
        weight_or_camber(weight(fz_n), campaign, &lines)
    };
    let said = found(5.0, -4.0, true, &campaign).expect("alike");
    assert_eq!(said.weight, Weight::Suspicion);
    // 5 N of 100 N/rad
    for words in ["at 10 m/s", "5.0 N less", "weight (4.0 N)", "angle +2.86 degrees"] {
        assert!(said.sentence.contains(words), "{said:?}");
    }
    for (less_n, fz_n, alike) in [
        (2.1, -4.0, true),
        (1.9, -4.0, false),
        (5.9, -4.0, true),
        (6.1, -4.0, false),
        (-4.0, 4.0, false),
        (0.0, 0.0, false),
    ] {
        assert_eq!(found(less_n, fz_n, true, &campaign).is_some(), alike, "{less_n} {fz_n}");
    }
    assert_eq!(found(5.0, -4.0, false, &campaign), None);
    campaign.points.push(point(9, 0.0, 0.0, [0.0; 4]));
    assert_eq!(found(5.0, -4.0, true, &campaign), None);
    assert_eq!(weight_or_camber(weight(-4.0), &campaign, &[]), None);
}

#[test]
fn what_is_missing_or_not_used_is_said_and_nothing_else() {
    let toy = Toy::new(2, 2);
    let mut campaign = toy.measured(&[10.0], &[0.0, 0.1, 0.2], &toy.uniform(1.0));
    let said = |campaign: &Campaign| -> Vec<String> {
        not_told(campaign).into_iter().map(|one| one.sentence).collect()
    };
    let tip = |all: &[String]| all.iter().any(|one| one.contains("tip_z_m of the static cases is not used"));
    assert!(said(&campaign).len() == 1 && tip(&said(&campaign)));
    campaign.tip = TipReading::Zeroed;
    assert!(said(&campaign).is_empty());
    for (c, name) in ["Fz_N", "Mx_Nm", "My_Nm"].into_iter().enumerate() {
        campaign.channels = std::array::from_fn(|other| other != c);
        let found = said(&campaign);
        assert!(found.len() == 1 && found[0].contains(&format!("no {name}:")), "{found:?}");
    }
    campaign.channels = [true; 3];
    // a control deflected at an airspeed that has neutral rows, then at others
    for (v_m_s, alone) in [(10.0, 0), (10.01, 0), (12.0, 1), (14.0, 2), (0.0, 2)] {
        let mut row = point(9, v_m_s, 0.0, [0.0; 4]);
        row.controls_rad = vec![("flap".into(), 0.1)];
        campaign.points.push(row);
        let found = said(&campaign);
        let words = format!("{alone} rows with a control deflected are not used");
        assert!(
            if alone == 0 { found.is_empty() } else { found.len() == 1 && found[0].contains(&words) },
            "{found:?}"
        );
    }
    campaign.points.truncate(3);
    campaign.sets = Sets::Common;
    assert!(said(&campaign).is_empty());
    let reads = Reading::Shear { y_over_span: 0.5 };
    campaign.sensors =
        vec![Sensor { column: "s".into(), reads, sigma: 1.0, zero: Zero::Free, scale: 0.0, under: None }];
    campaign.points[0].sensors = vec![Some(1.0)];
    let found = said(&campaign);
    assert!(
        found.len() == 1 && found[0].contains("sensors and rows with a control deflected are not used"),
        "{found:?}"
    );
}
