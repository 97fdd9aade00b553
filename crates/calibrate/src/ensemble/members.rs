//! The wings of an ensemble, few and chosen well.
//!
//! Unknowns of the posterior are a square root of its covariance times independent Gaussians. Along the directions that most of
//! the predictions' variance lies in, the wings take the signs of a Hadamard matrix: the variance of what depends on these alone is
//! exact with eight wings. The tunnel's stream, which no load in it tells, has the signs of the last of them. What is left is random, in
//! pairs of opposite sign. The same Gaussians serve all airspeeds, as one wing is off alike at all of them.

use super::file::{Ensemble, Member};
use super::moved::{moved, short};
use crate::posterior::predictions::Quantity;
use crate::posterior::{AirspeedPosterior, Spread, Unknowns};
use crate::schedule::{CorrectionSet, Schedule};
use crate::sensors::Reading;
use coupling::wing_file::CorrectionPrior;
use coupling::{ElasticWing, wing_file};
use faer::{Mat, Side};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// Wings of an ensemble: the order of a Hadamard matrix.
const MEMBERS: usize = 8;
/// Directions in which variances are exact.
const EXACT: usize = MEMBERS - 1;
/// The direction whose signs the tunnel's stream shares, the least important: what hangs on the stream (all of the lift at an angle) was
/// measured in the tunnel and knows next to nothing of it.
const STREAM: usize = EXACT - 1;
/// Seed of the random part.
const SEED: u64 = 1;

/// The wings that `known` leaves as likely, about its means, or the corrections of `schedule` where it has none; none where one set serves all airspeeds or
/// nothing is known.
pub fn ensemble(
    wing: &ElasticWing,
    prior: &CorrectionPrior,
    schedule: &Schedule,
    known: &[AirspeedPosterior],
) -> Option<Ensemble> {
    let last = known.last().filter(|_| known.len() == schedule.sets.len())?;
    let unknowns = Unknowns::new(wing, prior);
    let theory = unknowns.wing(&vec![0.0; unknowns.count()]).corrections;
    let directions = directions(known, unknowns.count());
    let gaussians = gaussians(&directions);
    let member = |(number, gaussians): (usize, &Vec<f64>)| {
        let off = |spread: &Spread| {
            let z: Vec<f64> = (0..unknowns.count())
                .map(|i| (0..gaussians.len()).map(|k| spread.root[(i, k)] * gaussians[k]).sum())
                .collect();
            unknowns.wing(&z)
        };
        // about the mean where there is one: corrections of the schedule are for the structure as given, which the mean's is not
        let set = |(known, centre): (&AirspeedPosterior, &CorrectionSet)| CorrectionSet {
            v_m_s: centre.v_m_s,
            corrections: moved(
                known.mean.as_ref().map_or(&centre.corrections, |mean| &mean.corrections),
                &off(&known.spread).corrections,
                &theory,
            ),
        };
        // what the structure and its surfaces are does not depend on the airspeed: dynamic pressure tells most at the highest
        let at_last = off(&last.spread);
        let mean = last.mean.as_ref();
        let softer = mean.map_or([0.0; 2], |mean| mean.log_flexibility);
        let control =
            |(c, factor): (usize, f64)| short(factor + mean.map_or(0.0, |mean| mean.controls[c] - 1.0));
        Member {
            log_flexibility: [0, 1].map(|i| short(softer[i] + at_last.log_flexibility[i])),
            controls: at_last.controls.into_iter().enumerate().map(control).collect(),
            stream: 1.0 + prior.stream * sign(number, STREAM),
            sets: known.iter().zip(&schedule.sets).map(set).collect(),
        }
    };
    Some(Ensemble {
        wing: schedule.wing.clone(),
        wing_hash: schedule.wing_hash.clone(),
        corrections: wing_file::fingerprint(&schedule.to_ron()),
        members: gaussians.iter().enumerate().map(member).collect(),
    })
}

/// Orthonormal directions of the Gaussians, `count` by at most [`EXACT`], in which predictions have most of their variance. Each
/// prediction counts by its own standard deviation; strips count as one together.
fn directions(known: &[AirspeedPosterior], count: usize) -> Mat<f64> {
    let mut moments = Mat::<f64>::zeros(count, count);
    for at in known {
        let is_strip = |quantity: &Quantity| matches!(quantity, Quantity::Reading(Reading::StripLift { .. }));
        let strips = at.predictions.iter().filter(|p| is_strip(&p.quantity)).count();
        for (prediction, gradient) in at.predictions.iter().zip(&at.spread.gradients) {
            let seen: Vec<f64> =
                (0..count).map(|k| (0..count).map(|i| gradient[i] * at.spread.root[(i, k)]).sum()).collect();
            let variance: f64 = seen.iter().map(|x| x * x).sum();
            let weight = if is_strip(&prediction.quantity) { 1.0 / strips as f64 } else { 1.0 };
            let scale = weight / variance.max(f64::MIN_POSITIVE);
            for i in 0..count {
                for j in 0..count {
                    moments[(i, j)] += scale * seen[i] * seen[j];
                }
            }
        }
    }
    // ascending; a matrix that is not finite leaves no direction exact
    moments.self_adjoint_eigen(Side::Lower).map_or_else(
        |_| Mat::zeros(count, 0),
        |eigen| Mat::from_fn(count, EXACT.min(count), |i, k| eigen.U()[(i, count - 1 - k)]),
    )
}

/// The matrix of Hadamard (Sylvester's) without its first column.
fn sign(member: usize, column: usize) -> f64 {
    if (member & (column + 1)).count_ones().is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// The Gaussians of every wing.
fn gaussians(directions: &Mat<f64>) -> Vec<Vec<f64>> {
    let (count, exact) = (directions.nrows(), directions.ncols());
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut drawn: Vec<Vec<f64>> =
        (0..MEMBERS / 2).map(|_| (0..count).map(|_| StandardNormal.sample(&mut random)).collect()).collect();
    let opposite: Vec<Vec<f64>> = drawn.iter().map(|z| z.iter().map(|z| -z).collect()).collect();
    drawn.extend(opposite);
    for (member, z) in drawn.iter_mut().enumerate() {
        for k in 0..exact {
            let along: f64 = (0..count).map(|i| directions[(i, k)] * z[i]).sum();
            for (i, z) in z.iter_mut().enumerate() {
                *z += (sign(member, k) - along) * directions[(i, k)];
            }
        }
    }
    drawn
}
