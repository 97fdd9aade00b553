//! The wings of an ensemble, few and chosen well.
//!
//! Unknowns of the posterior are a square root of its covariance times independent Gaussians. Along the directions that most of
//! the predictions' variance lies in, the wings take the signs of a Hadamard matrix: the variance of what depends on these alone is
//! exact with eight wings. The tunnel's stream, which no load in it tells, has the signs of the last of them. What is left is random, in
//! pairs of opposite sign, and then stretched along every prediction until its variance is the posterior's: four pairs drawn
//! at random know a variance to 70 %. The same Gaussians serve all airspeeds, as one wing is off alike at all of them.

use super::file::Ensemble;
use crate::member::{CorrectionSet, Member, moved, short};
use crate::posterior::predictions::Quantity;
use crate::posterior::{AirspeedPosterior, Prediction, Spread, Unknowns};
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
/// How often the wings are stretched along each prediction; from one to the next all others change a little.
const SWEEPS: usize = 30;

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
    let seen = seen(known);
    let gaussians = gaussians(&directions(&seen, unknowns.count()), &seen);
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

/// What a prediction sees of the Gaussians.
struct Seen {
    /// Share of the importance of one prediction; strips count as one together.
    weight: f64,
    /// Its derivatives by the Gaussians, over its standard deviation.
    unit: Vec<f64>,
}

/// What the predictions of all airspeeds see, the most important last; what has no variance is left out.
fn seen(known: &[AirspeedPosterior]) -> Vec<Seen> {
    let mut seen = Vec::new();
    for AirspeedPosterior { predictions, spread, .. } in known {
        let is_strip = |p: &&Prediction| matches!(p.quantity, Quantity::Reading(Reading::StripLift { .. }));
        let strips = predictions.iter().filter(is_strip).count();
        let weights = predictions.iter().map(|p| if is_strip(&p) { 1.0 / strips as f64 } else { 1.0 });
        let at_least = spread.at_least.iter().map(|gradient| (1.0, gradient));
        for (weight, gradient) in weights.zip(&spread.gradients).chain(at_least) {
            let by = |k: usize| gradient.iter().enumerate().map(|(i, by)| by * spread.root[(i, k)]).sum();
            let unit: Vec<f64> = (0..spread.root.ncols()).map(by).collect();
            let sigma = unit.iter().map(|x| x * x).sum::<f64>().sqrt();
            if sigma > 0.0 {
                seen.push(Seen { weight, unit: unit.into_iter().map(|x| x / sigma).collect() });
            }
        }
    }
    seen.sort_by(|a, b| a.weight.total_cmp(&b.weight));
    seen
}

/// Orthonormal directions of the Gaussians, `count` by at most [`EXACT`], in which predictions have most of their variance.
fn directions(seen: &[Seen], count: usize) -> Mat<f64> {
    let mut moments = Mat::<f64>::zeros(count, count);
    for Seen { weight, unit } in seen {
        for i in 0..count {
            for j in 0..count {
                moments[(i, j)] += weight * unit[i] * unit[j];
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
fn gaussians(directions: &Mat<f64>, seen: &[Seen]) -> Vec<Vec<f64>> {
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
    for Seen { unit, .. } in (0..SWEEPS).flat_map(|_| seen) {
        stretch(&mut drawn, unit);
    }
    drawn
}

/// Stretches the wings along a direction until they have a variance of one there.
fn stretch(drawn: &mut [Vec<f64>], unit: &[f64]) {
    let along: Vec<f64> = drawn.iter().map(|z| z.iter().zip(unit).map(|(z, by)| z * by).sum()).collect();
    let variance = along.iter().map(|x| x * x).sum::<f64>() / drawn.len() as f64;
    let more = if variance > 0.0 { variance.sqrt().recip() - 1.0 } else { 0.0 };
    for (z, along) in drawn.iter_mut().zip(along) {
        z.iter_mut().zip(unit).for_each(|(z, by)| *z += more * along * by);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let drawn = gaussians(&directions, &[]);
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
        assert_eq!(gaussians(&directions, &[]), drawn, "the same at every run");
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
            spread: Spread { root, gradients, at_least: vec![] },
        }
    }

    /// Each prediction counts alike whatever its size, strips as one together: the first direction is the one that
    /// more of them lie in.
    #[test]
    fn directions_are_those_of_most_of_the_predictions_variance() {
        let unit =
            |i: usize, size: f64| -> Vec<f64> { (0..3).map(|k| if k == i { size } else { 0.0 }).collect() };
        let first = |gradients: Vec<Vec<f64>>, is_strip: &[bool]| {
            let found = directions(&seen(&[known(gradients, is_strip, Mat::identity(3, 3))]), 3);
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
        let found = directions(&seen(&[known(vec![unit(0, 2.0)], &[false], swap)]), 3);
        assert!(found[(1, 0)].abs() > 0.999);
    }
    /// Of twelve predictions in forty unknowns eight wings have the variance of each to a percent, and keep their mean.
    #[test]
    fn wings_have_the_variance_of_every_prediction_that_is_listed() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        let mut drawn =
            |count: usize| -> Vec<f64> { (0..count).map(|_| StandardNormal.sample(&mut random)).collect() };
        let gradients: Vec<Vec<f64>> = (0..12).map(|_| drawn(40)).collect();
        let values = drawn(1600);
        let root = Mat::from_fn(40, 40, |i, k| values[40 * i.min(k) + i.max(k)]);
        let mut known = known(
            gradients[..9].to_vec(),
            &[true, true, true, true, false, true, false, false, true],
            root.clone(),
        );
        known.spread.at_least = gradients[9..].to_vec();
        let seen = seen(&[known]);
        let wings = gaussians(&directions(&seen, 40), &seen);
        for gradient in &gradients {
            let by: Vec<f64> = (0..40).map(|k| (0..40).map(|i| gradient[i] * root[(i, k)]).sum()).collect();
            let of = |z: &Vec<f64>| -> f64 { z.iter().zip(&by).map(|(z, by)| z * by).sum() };
            let exact: f64 = by.iter().map(|by| by * by).sum();
            let found = wings.iter().map(|z| of(z).powi(2)).sum::<f64>() / 8.0;
            assert!((found / exact - 1.0).abs() < 0.01, "{found} {exact}");
            assert!(wings.iter().map(of).sum::<f64>().abs() < 1e-9 * exact.sqrt());
        }
    }
}
