//! The wings of an ensemble, few and chosen well.
//!
//! Unknowns of the posterior are a square root of its covariance times independent Gaussians. Along the directions that most of
//! the predictions' variance lies in, the wings take the signs of a Hadamard matrix: the variance of what depends on these alone is
//! exact with eight wings. The tunnel's stream, which no load in it tells, has the signs of the last of them. What is left is random, in
//! pairs of opposite sign. The same Gaussians serve all airspeeds, as one wing is off alike at all of them.

use super::file::Ensemble;
use crate::member::{CorrectionSet, Member, moved, short};
use crate::posterior::predictions::Quantity;
use crate::posterior::{AirspeedPosterior, Spread, Unknowns};
use crate::schedule::Schedule;
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

/// The wings that `known` leaves as likely, about the wing that `schedule` says was found, or about its corrections where there is none; none where one
/// set serves all airspeeds or nothing is known.
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
        // corrections of the schedule are for the structure as given, which that of a wing that was found is not
        let found = schedule.found.as_ref();
        let set = |(known, centre): (&AirspeedPosterior, &CorrectionSet)| CorrectionSet {
            v_m_s: centre.v_m_s,
            corrections: moved(&centre.corrections, &off(&known.spread).corrections, &theory),
        };
        let centres = found.map_or(&schedule.sets, |found| &found.sets);
        // what the structure and its surfaces are does not depend on the airspeed: dynamic pressure tells most at the highest
        let at_last = off(&last.spread);
        let softer = found.map_or([0.0; 2], |found| found.log_flexibility);
        let control =
            |(c, factor): (usize, f64)| short(factor + found.map_or(0.0, |found| found.controls[c] - 1.0));
        Member {
            log_flexibility: [
                short(softer[0] + at_last.log_flexibility[0]),
                short(softer[1] + at_last.log_flexibility[1]),
            ],
            controls: at_last.controls.into_iter().enumerate().map(control).collect(),
            stream: 1.0 + prior.stream * sign(number, STREAM),
            sets: known.iter().zip(centres).map(set).collect(),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::posterior::Prediction;
    use aero::Corrections;

    /// Columns of a Hadamard matrix are at right angles to each other and to ones.
    #[test]
    fn signs_are_those_of_hadamards_matrix() {
        let column = |k: usize| (0..MEMBERS).map(move |member| sign(member, k));
        for k in 0..EXACT {
            assert_eq!(column(k).sum::<f64>(), 0.0);
            for l in 0..EXACT {
                let product: f64 = column(k).zip(column(l)).map(|(a, b)| a * b).sum();
                assert_eq!(product, if k == l { 8.0 } else { 0.0 }, "{k} {l}");
            }
        }
        assert_eq!([0, 1, 2, 3].map(|member| sign(member, 0)), [1.0, -1.0, 1.0, -1.0]);
    }

    #[test]
    fn along_exact_directions_wings_take_signs_and_elsewhere_they_are_opposite_in_pairs() {
        let (c, s) = (0.6, 0.8);
        let directions = Mat::from_fn(4, 2, |i, k| [[c, -s], [s, c], [0.0, 0.0], [0.0, 0.0]][i][k]);
        let drawn = gaussians(&directions);
        assert_eq!(drawn.len(), MEMBERS);
        for (member, z) in drawn.iter().enumerate() {
            for k in 0..2 {
                let along: f64 = (0..4).map(|i| directions[(i, k)] * z[i]).sum();
                assert!((along - sign(member, k)).abs() < 1e-12, "{member} {k}: {along}");
            }
            let opposite = &drawn[(member + MEMBERS / 2) % MEMBERS];
            assert!((2..4).all(|i| z[i] == -opposite[i] && z[i] != 0.0), "{z:?} {opposite:?}");
        }
        assert!(drawn[0][2] != drawn[1][2]);
        assert_eq!(gaussians(&directions), drawn, "the same at every run");
    }

    fn known(gradients: Vec<Vec<f64>>, is_strip: &[bool], root: Mat<f64>) -> AirspeedPosterior {
        let predictions = is_strip.iter().map(|&is_strip| Prediction {
            quantity: if is_strip {
                Quantity::Reading(Reading::StripLift { y_over_span: 0.5 })
            } else {
                Quantity::TipHeight
            },
            theory: 0.0,
            value: 0.0,
            prior_sigma: 1.0,
            sigma: 1.0,
        });
        AirspeedPosterior {
            v_m_s: 10.0,
            alpha_rad: 0.0,
            mean: None,
            corrections: Corrections::neutral(1),
            beyond: vec![],
            predictions: predictions.collect(),
            spread: Spread { root, gradients },
        }
    }

    /// Each prediction counts alike whatever its size, strips as one together: the first direction is the one that
    /// more of them lie in.
    #[test]
    fn directions_are_those_of_most_of_the_predictions_variance() {
        let unit =
            |i: usize, size: f64| -> Vec<f64> { (0..3).map(|k| if k == i { size } else { 0.0 }).collect() };
        let first = |gradients: Vec<Vec<f64>>, is_strip: &[bool]| {
            let found = directions(&[known(gradients, is_strip, Mat::identity(3, 3))], 3);
            assert_eq!((found.nrows(), found.ncols()), (3, 3));
            [0, 1, 2].map(|k| (0..3).position(|i| found[(i, k)].abs() > 0.999).expect("an axis"))
        };
        let gradients =
            || vec![unit(0, 100.0), unit(1, 0.1), unit(1, 0.1), unit(2, 5.0), unit(2, 1.0), unit(2, 3.0)];
        assert_eq!(first(gradients(), &[false; 6]), [2, 1, 0]);
        // three strips are one prediction, as the first is; of two airspeeds each counts
        assert_eq!(first(gradients(), &[false, false, false, true, true, true])[0], 1);
        let mut more = gradients();
        more.push(unit(0, 1.0));
        more.push(unit(0, 7.0));
        assert_eq!(first(more, &[false, false, false, true, true, true, false, false]), [0, 1, 2]);
        // what is seen through the root of the covariance
        let swap = Mat::from_fn(3, 3, |i, k| if (i + 1) % 3 == k { 1.0 } else { 0.0 });
        let found = directions(&[known(vec![unit(0, 2.0)], &[false], swap)], 3);
        assert!(found[(1, 0)].abs() > 0.999);
    }
}
