//! Noise beside what a campaign states of it: white noise of the stated size is not remarked on, coloured noise of the same size is,
//! by as much as its spectral density says.

use calibrate::{Campaign, Use};
use coupling::ElasticWing;
use discover::data::Dataset;
use discover::stated_noise::{beyond_stated, sentence};
use maneuver::effects::Flown;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

/// Pairs of runs.
const PAIRS: usize = 20;

/// Runs and repeats of nothing but noise of first order: each sample keeps a share of the one before, and its standard deviation is
/// the stated one.
fn campaign(keeps: f64) -> Dataset {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
    let (_, wing) = ElasticWing::read(&data.join("wing_beam.ron")).expect("the shipped wing");
    let campaign = Campaign::read(&data.join("measured")).expect("the shipped campaign");
    let mut data = Dataset::read(&campaign, &wing, &Arc::default()).expect("the shipped campaign");
    let sigma = data.stated.expect("the shipped campaign states its noise").sample.to_array();
    let mut random = ChaCha8Rng::seed_from_u64(5);
    let mut normal = || -> f64 { StandardNormal.sample(&mut random) };
    let first = data.runs[0].clone();
    data.runs = (0..2 * PAIRS)
        .map(|i| {
            let mut run = first.clone();
            (run.usage, run.decimation) = (Use::Train, 1);
            run.repeat_of = (i % 2 == 1).then(|| i - 1);
            for (load, sigma) in run.measured.iter_mut().zip(sigma) {
                let mut state = normal();
                for value in load {
                    *value = sigma * state;
                    state = keeps * state + (1.0 - keeps * keeps).sqrt() * normal();
                }
            }
            run
        })
        .collect();
    data
}

/// The loads of a model that stands still.
fn still(data: &Dataset) -> Vec<Flown> {
    let zeros = |run: &discover::data::RunData| vec![0.0; run.measured[0].len()];
    let flown = |run| Flown { loads: [zeros(run), zeros(run), zeros(run)], tip_m: zeros(run) };
    data.runs.iter().map(flown).collect()
}

#[test]
fn white_noise_of_the_stated_size_is_what_was_stated() {
    let data = campaign(0.0);
    assert_eq!(beyond_stated(&data, &still(&data)), []);
    assert_eq!(sentence(&[]), None);
}

/// Spectral density over that of white noise of the same size: `(1 - c²)/(1 - 2 c cos(2 pi f dt) + c²)`.
#[test]
fn coloured_noise_of_the_stated_size_is_told_band_by_band() {
    let keeps: f64 = 0.7;
    let data = campaign(keeps);
    let dt = data.runs[0].stimulus.time_step_s;
    let density =
        |f_hz: f64| (1.0 - keeps * keeps) / (1.0 - 2.0 * keeps * (TAU * f_hz * dt).cos() + keeps * keeps);
    let bands = beyond_stated(&data, &still(&data));
    let loads = data.run_loads.iter().filter(|there| **there).count();
    assert_eq!(bands.len(), 5 * loads, "{bands:?}");
    for one in &bands {
        let mean = (0..100)
            .map(|i| density(one.from_hz + (f64::from(i) + 0.5) / 100.0 * (one.to_hz - one.from_hz)))
            .sum::<f64>()
            / 100.0;
        // a variance of at least a hundred coefficients
        assert!((one.over_stated / mean.sqrt() - 1.0).abs() < 0.2, "{one:?}, by its density {}", mean.sqrt());
    }
    let said = sentence(&bands).expect("bands");
    assert!(said.contains("not what campaign.ron states") && said.contains("more bands"), "{said}");
    // without repeats, and without a statement, there is nothing to compare
    let mut alone = data.clone();
    alone.runs.iter_mut().for_each(|run| run.repeat_of = None);
    assert_eq!(beyond_stated(&alone, &still(&alone)), []);
    let silent = Dataset { stated: None, ..data };
    assert_eq!(beyond_stated(&silent, &still(&silent)), []);
}
