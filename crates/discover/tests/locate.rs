//! What a residual goes with: effects put into a campaign of the shipped wing are located, none is where there is none,
//! and the shipped campaign shows its ailerons' curves and the fast pitch in My.

use crate::common::{Flight, shipped};
use calibrate::Use;
use discover::data::Dataset;
use discover::locate::{Cell, Located, Maneuver, PureError, Residuals, chirps, map, regressors, variances};
use discover::rules::LocateRules;
use maneuver::effects::{Active, Flown, library};

/// Residuals in units of the stated noise.
fn residuals(flight: &Flight, data: &Dataset, flown: &[Flown], only: Option<Use>) -> Residuals {
    let stated = data.stated.expect("the shipped campaign states its noise");
    let (sample, point) = (stated.sample.to_array(), stated.point);
    let coefficient = |_: usize, c: usize, _: f64| sample[c] / std::f64::consts::SQRT_2;
    let error = PureError { coefficient: &coefficient, point, degrees_of_freedom: None };
    Residuals::new(data, flown, &error, &flight.controls, only)
}

/// Residuals of a campaign flown by the wing with an effect.
fn pretended(name: &str, values: &[f64]) -> Residuals {
    let flight = shipped();
    let effects: Vec<Active> = library(&flight.controls)
        .into_iter()
        .find(|effect| effect.spec().name == name)
        .map(|effect| Active::new(effect, values))
        .into_iter()
        .collect();
    assert_eq!(effects.is_empty(), name.is_empty(), "{name}");
    residuals(flight, &flight.pretend(&flight.with(&effects), 11), &flight.flown, None)
}

fn first<'a>(located: &'a [Located], channel: &str) -> &'a Located {
    located.iter().find(|located| located.channel == channel).expect("a channel of the balance")
}

fn fast_pitch(cell: &Cell) -> bool {
    // 4 and 6 Hz, with or without wind
    let frequency: f64 = cell.maneuver.split(' ').rev().nth(1).and_then(|hz| hz.parse().ok()).unwrap_or(0.0);
    cell.maneuver.contains("pitch") && frequency > 3.5 && LocateRules::default().bands_hz[cell.band].1 > 3.5
}

#[test]
fn nothing_is_located_where_there_is_only_noise() {
    let residuals = pretended("", &[]);
    let cells = map(&residuals);
    let above = cells.iter().filter(|cell| cell.power > cell.limit).count();
    // one in a hundred is expected
    assert!(above * 30 < cells.len(), "{above} of {}", cells.len());
    let mean = cells.iter().map(|cell| cell.power * cell.rows as f64).sum::<f64>()
        / cells.iter().map(|cell| cell.rows as f64).sum::<f64>();
    assert!((mean - 1.0).abs() < 0.02, "{mean}");
    let p_values: Vec<f64> = regressors(&residuals).iter().map(|located| located.p_value).collect();
    let small = p_values.iter().filter(|p| **p < 0.01).count();
    assert!(small <= 2, "{p_values:?}");
    for cell in chirps(&residuals) {
        assert!(cell.linear < 0.1, "{cell:?}");
        assert!(cell.repeats.is_none_or(|share| share < 0.05), "{cell:?}");
    }
    let variances = variances(&residuals);
    // repeats at 30 m/s only: nothing to compare
    assert!(variances.tests.is_empty());
    let rows: usize = variances.cells.iter().map(|cell| cell.rows).sum();
    let ratio = variances.cells.iter().map(|cell| cell.ratio * cell.rows as f64).sum::<f64>() / rows as f64;
    assert!((ratio - 1.0).abs() < 0.1, "{ratio}");
}

#[test]
fn a_joiner_is_located_in_the_fast_pitch_of_my() {
    let residuals = pretended("joiner_inertia", &[0.0, 0.02, 0.0, 0.0]);
    let cells = map(&residuals);
    assert!(cells[0].channel == "My_Nm" && fast_pitch(&cells[0]), "{:?}", cells[0]);
    let located = regressors(&residuals);
    assert_eq!((&*located[0].channel, &*located[0].regressor), ("My_Nm", "alpha_ddot"), "{located:#?}");
    assert!(located[0].share_of_residual > 0.5 && located[0].p_value < 0.01, "{:?}", located[0]);
    assert!(located[0].place.contains("pitch"), "{:?}", located[0]);
}

#[test]
fn the_shipped_campaign_shows_its_ailerons_curves() {
    let flight = shipped();
    let residuals = residuals(flight, &flight.data, &flight.flown, Some(Use::Train));
    let located = regressors(&residuals);
    for channel in ["Fz_N", "Mx_Nm"] {
        let top = first(&located, channel);
        assert_eq!(top.regressor, "delta|delta|, delta^3", "{located:#?}");
        assert!(top.share_of_residual > 0.2 && top.p_value < 1e-3, "{top:?}");
    }
    let cells = map(&residuals);
    assert!(
        cells[0].maneuver.starts_with("doublet") && cells[0].maneuver.ends_with("25 deg"),
        "{:?}",
        cells[0]
    );
    // no control moves: what is left is the pitch
    let of_my = located.iter().filter(|located| located.channel == "My_Nm");
    let others: Vec<&Located> = of_my.filter(|located| !located.regressor.starts_with("delta")).collect();
    assert_eq!(others[0].regressor, "alpha_ddot", "{others:#?}");
}

#[test]
fn the_shipped_campaigns_my_goes_with_the_second_derivative_of_the_angle() {
    let flight = shipped();
    let mut residuals = residuals(flight, &flight.data, &flight.flown, None);
    residuals.units.retain(|unit| matches!(unit.maneuver, Maneuver::Angle { .. } | Maneuver::Static { .. }));
    let cells = map(&residuals);
    let top = cells.iter().find(|cell| cell.channel == "My_Nm").expect("My");
    assert!(fast_pitch(top) && top.power > 100.0 * top.limit, "{top:?}");
    let located = regressors(&residuals);
    let top = first(&located, "My_Nm");
    assert_eq!(top.regressor, "alpha_ddot", "{located:#?}");
    assert!(top.share_of_residual > 0.3 && top.p_value < 0.05, "{top:?}");
}

#[test]
fn the_chirps_residual_is_mostly_linear_in_the_input_and_repeats() {
    let flight = shipped();
    let cells = chirps(&residuals(flight, &flight.data, &flight.flown, None));
    // the outer aileron does less than the model thinks already at five degrees
    let strong: Vec<_> =
        cells.iter().filter(|cell| cell.run == "chirp_outer_5_22" && cell.band == 2).collect();
    assert_eq!(strong.len(), 3);
    for cell in strong {
        assert!(cell.linear > 0.5 && cell.linear > 10.0 * (cell.second + cell.third), "{cell:?}");
    }
    let repeated: Vec<_> = cells.iter().filter(|cell| cell.repeats.is_some() && cell.band == 2).collect();
    assert_eq!(repeated.len(), 6);
    for cell in repeated {
        assert!(cell.linear > 10.0 * cell.by_chance, "{cell:?}");
        assert!(cell.repeats.is_some_and(|share| share > 0.05), "{cell:?}");
    }
}
