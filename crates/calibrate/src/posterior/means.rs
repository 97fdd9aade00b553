//! A calibration with what is known in the place of its own corrections.

use super::{AirspeedPosterior, WingOff};
use crate::calibration::Calibration;
use crate::campaign::{TIP, TipReading};
use crate::checks::Finding;
use crate::fit::Ending;
use crate::member::{CorrectionSet, Member, short};
use crate::objective::{objective, rmse};
use aero::{Corrections, Flow};
use coupling::{CouplingError, ElasticWing, SteadyCase, SteadyModel};

impl Calibration {
    /// The calibration with the means in the place of its corrections, where there are means, with the wing that they are, and with what
    /// was found on the way.
    ///
    /// # Errors
    /// If the wing cannot be solved.
    pub fn with_means(
        mut self,
        wing: &ElasticWing,
        known: &[AirspeedPosterior],
    ) -> Result<Self, CouplingError> {
        self.found = found(known);
        for (at, known) in self.airspeeds.iter_mut().zip(known) {
            for (column, times) in &known.beyond {
                self.findings.push(Finding::suspicion(format!(
                    "{column} at {} m/s is off the calibrated wing by {times:.1} times its noise, which no correction explains (stall, a \
                     sensor's place or scale, noise that is more than stated): it is taken as noise, and intervals are as wide",
                    at.data.v_m_s
                )));
            }
            if known.mean.is_none() {
                continue;
            }
            at.corrections = known.corrections.clone();
            let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: self.rho_kg_m3 };
            let cases: Vec<SteadyCase> =
                at.data.angles.iter().map(|angle| SteadyCase::new(flow, angle.alpha_rad)).collect();
            let loads = wing.root_loads(&cases, &known.corrections)?;
            let tips_m = wing.tip_deflections(&cases, &known.corrections)?;
            let mut misses: Vec<[f64; 4]> = Vec::with_capacity(cases.len());
            for (angle, (load, tip_m)) in at.data.angles.iter().zip(loads.iter().zip(tips_m)) {
                let ([fz, mx, my], measured) = (load.to_array(), angle.readings());
                let read = [fz, mx, my, tip_m];
                misses.push(std::array::from_fn(|c| read[c] - measured[c]));
            }
            if self.data.tip == TipReading::FreeZero {
                let zero = misses.iter().map(|miss| miss[TIP]).sum::<f64>() / misses.len() as f64;
                for miss in &mut misses {
                    miss[TIP] -= zero;
                }
            }
            at.fit.rmse[1] = rmse(&misses, self.data.channels);
            at.fit.objective[1] = objective(at.fit.rmse[1], at.weights);
            at.fit.ending = Ending::PosteriorMean;
        }
        Ok(self)
    }
}

/// Most that logarithms of one structure's flexibility differ by between airspeeds, which round.
const SAME_STRUCTURE: f64 = 1e-3;

/// The wing of the means; none where airspeeds that know nothing of each other found different structures, of which no wing can have more than one.
fn found(known: &[AirspeedPosterior]) -> Option<Member> {
    let means = known.iter().map(|at| at.mean.as_ref()).collect::<Option<Vec<_>>>()?;
    let last = means.last()?;
    let is_last = |log: &[f64; 2]| (0..2).all(|i| (log[i] - last.log_flexibility[i]).abs() < SAME_STRUCTURE);
    if !means.iter().all(|mean| is_last(&mean.log_flexibility)) {
        return None;
    }
    let all = |values: &[f64]| values.iter().map(|value| short(*value)).collect::<Vec<f64>>();
    let set = |(at, mean): (&AirspeedPosterior, &&WingOff)| CorrectionSet {
        v_m_s: at.v_m_s,
        corrections: Corrections {
            force: all(&mean.corrections.force),
            moment: all(&mean.corrections.moment),
            pressure_offset: all(&mean.corrections.pressure_offset),
        },
    };
    Some(Member {
        log_flexibility: last.log_flexibility.map(short),
        controls: all(&last.controls),
        stream: 1.0,
        sets: known.iter().zip(&means).map(set).collect(),
    })
}
