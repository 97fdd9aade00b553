//! What is known of a wing at an airspeed: where its unknowns are and how far they may be off.

use super::data::{Data, Datum};
use super::joint::{Joint, OfAirspeed, product};
use super::off::WingOff;
use super::predictions::{MX, Quantity};
use super::prior::Unknowns;
use super::read::{CaseRead, read_case};
use crate::calibration::{AirspeedCalibration, Calibration};
use crate::campaign::{CHANNELS, TIP};
use crate::sensors::{Reading, Sensor};
use aero::{Corrections, Flow};
use coupling::wing_file::CorrectionPrior;
use coupling::{CouplingError, ElasticWing, SteadyCase, SteadyOperator};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};

/// Most steps to the mean, and most halvings of a step.
const STEPS: usize = 12;
const HALVINGS: usize = 5;
/// The mean is found when no unknown moves by more than this share of its standard deviation before the data.
const STILL: f64 = 1e-3;

/// Steps to the root loads with the structure as given, from next to them.
const GIVEN_STEPS: usize = 3;
/// Chance below which what misses the wing is more than noise, shared among an airspeed's columns.
const SIGNIFICANCE: f64 = 0.01;
/// Most times that levels of noise are raised.
const LEVELS: usize = 4;

/// See the module.
pub(super) struct Known<'a> {
    pub(super) flow: Flow,
    pub(super) alphas_rad: Vec<f64>,
    /// The wing that is known: the mean, or with root loads alone the calibration's.
    pub(super) off: WingOff,
    /// Whether it is the mean.
    pub(super) is_mean: bool,
    /// Corrections for the structure as given.
    pub(super) given: Corrections,
    /// It with its corrections.
    pub(super) corrected: SteadyOperator<'a>,
    pub(super) unknowns: Unknowns,
    /// Standard deviation of one row of the static cases, by channel.
    pub(super) sigma: [f64; 4],
    /// How many times its stated noise a column is off where no correction explains it; root loads alone are told by their lines.
    pub(super) beyond: Vec<(String, f64)>,
    /// Data by unknowns of the wing, then of the sensors, over their noise.
    pub(super) rows: Vec<Vec<f64>>,
    /// The unknowns, and what the data are off by there, over the noise.
    z: Vec<f64>,
    misses: Vec<f64>,
    data: Data,
}

/// The data linearised at unknowns.
struct Linearised<'a> {
    z: Vec<f64>,
    off: WingOff,
    operator: SteadyOperator<'a>,
    rows: Vec<Vec<f64>>,
    /// Measured less read, over the noise.
    misses: Vec<f64>,
    /// Half of the squares of misses and unknowns: least at the mean.
    objective: f64,
}

impl<'a> Known<'a> {
    pub(super) fn new(
        wing: &'a ElasticWing,
        calibration: &Calibration,
        at: &AirspeedCalibration,
        prior: &CorrectionPrior,
    ) -> Result<Self, CouplingError> {
        let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
        let unknowns = Unknowns::new(wing, prior);
        let mut data = Data::of(wing, calibration, at, prior.reading)?;
        let more = calibration.data.is_more_than_root_loads();
        // root loads alone: the least change of pressures that reaches them, as paper 1 has it
        let least_change = WingOff { corrections: at.corrections.clone(), ..WingOff::theory(wing) };
        let centre = |data: &Data| {
            if more {
                mean(wing, flow, &unknowns, data)
            } else {
                linearise(
                    wing,
                    flow,
                    &unknowns,
                    data,
                    least_change.clone(),
                    &vec![0.0; unknowns.count() + data.nuisances],
                )
            }
        };
        // What no correction explains is noise of its own level. The least change stops at straight lines' objective, a sum over the loads,
        // so that one load may be missed by more than noise: there lines say what is beyond it.
        if !more {
            let levels = data.levels_of_lines(calibration, &at.line);
            data.raise(&levels);
        }
        let mut at_centre = centre(&data)?;
        for _ in 0..if more { LEVELS } else { 0 } {
            let noise_dof = calibration.data.noise_dof;
            let Some(levels) = data.levels(&at_centre.misses, noise_dof, SIGNIFICANCE) else { break };
            data.raise(&levels);
            at_centre = centre(&data)?;
        }
        Ok(Self {
            given: at.corrections.clone(),
            flow,
            alphas_rad: at.data.angles.iter().map(|angle| angle.alpha_rad).collect(),
            off: at_centre.off,
            is_mean: more,
            corrected: at_centre.operator,
            unknowns,
            sigma: calibration.data.point_sigma.unwrap_or(at.line.rmse),
            rows: at_centre.rows,
            beyond: if more { data.beyond() } else { Vec::new() },
            z: at_centre.z,
            misses: at_centre.misses,
            data,
        })
    }

    /// All airspeeds, and how they hang together: where more than root loads was measured each tells of the others.
    pub(super) fn all(
        wing: &'a ElasticWing,
        calibration: &Calibration,
        prior: &CorrectionPrior,
    ) -> Result<(Vec<Self>, Joint), CouplingError> {
        let of = |at: &AirspeedCalibration| Self::new(wing, calibration, at, prior);
        let mut known = calibration.airspeeds.iter().map(of).collect::<Result<Vec<_>, _>>()?;
        let alike = if known.iter().all(|at| at.is_mean) { prior.airspeeds_alike } else { 0.0 };
        let mut joint = Self::joint(&known, alike);
        for _ in 0..if alike > 0.0 && known.len() > 1 { STEPS } else { 0 } {
            let asked = |k: usize, i: usize| known[k].misses[i] + product(&known[k].rows[i], &known[k].z);
            let Some(means) = joint.means(&asked) else { break };
            let moves = known.iter().zip(&means).flat_map(|(at, mean)| at.z.iter().zip(mean));
            let moved = moves.map(|(from, to)| (from - to).abs()).fold(0.0, f64::max);
            let there = known
                .iter()
                .zip(&means)
                .map(|(at, z)| linearise(wing, at.flow, &at.unknowns, &at.data, at.unknowns.wing(z), z));
            match there.collect::<Result<Vec<_>, _>>() {
                Ok(there) => known.iter_mut().zip(there).for_each(|(at, there)| at.move_to(there)),
                Err(CouplingError::Diverged { .. }) => break,
                Err(error) => return Err(error),
            }
            joint = Self::joint(&known, alike);
            if moved < STILL {
                break;
            }
        }
        for at in known.iter_mut().filter(|at| at.is_mean) {
            at.given = on_given_structure(wing, at.flow, &at.unknowns, &at.data, &at.z)?;
        }
        Ok((known, joint))
    }

    fn move_to(&mut self, there: Linearised<'a>) {
        self.off = there.off;
        self.corrected = there.operator;
        self.rows = there.rows;
        self.z = there.z;
        self.misses = there.misses;
    }

    fn joint(known: &[Self], alike: f64) -> Joint {
        let counts = known.first().map_or([0; 3], |at| {
            let count = at.unknowns.count();
            [at.unknowns.of_corrections(), count, count + at.data.names.len()]
        });
        let of = known.iter().map(|at| OfAirspeed {
            v_m_s: at.flow.v_m_s,
            rows: &at.rows,
            hung: at.data.measured.iter().map(|datum| datum.hung.is_some()).collect(),
        });
        Joint::new(&of.collect::<Vec<_>>(), counts, alike)
    }

    pub(super) fn case(&self, alpha_rad: f64) -> SteadyCase {
        SteadyCase::new(self.flow, alpha_rad)
    }

    /// The unknown of what a quantity's reading is off by: the data's, if they have that reading, else the first that they know nothing of.
    pub(super) fn reading_of(&self, quantity: &Quantity, sensors: &[Sensor]) -> usize {
        let sensor = |reading: &Reading| {
            let found = sensors.iter().position(|sensor| sensor.reads == *reading);
            found.map(|sensor| CHANNELS.len() + sensor)
        };
        let column = match quantity {
            Quantity::TipHeight => Some(TIP),
            Quantity::ControlMx { .. } => Some(MX),
            Quantity::Reading(reading) => sensor(reading),
        };
        column.map_or(self.z.len(), |column| self.reading_of_channel(column))
    }

    /// The same of a column: of the balance's channels, the tip, or a sensor.
    pub(super) fn reading_of_channel(&self, column: usize) -> usize {
        self.unknowns.count() + self.data.together.places[column]
    }

    /// A gradient by the unknowns of the wing and by that of the reading of a value.
    pub(super) fn with_reading(&self, mut gradient: Vec<f64>, unknown: usize, value: f64) -> Vec<f64> {
        gradient.resize(unknown + 1, 0.0);
        gradient[unknown] = self.unknowns.reading * value;
        gradient
    }

    /// The case with the largest angle that was measured.
    pub(super) fn largest(&self) -> SteadyCase {
        self.case(self.alphas_rad.iter().copied().fold(f64::NEG_INFINITY, f64::max))
    }

    /// The case with the least angle that was measured.
    pub(super) fn least(&self) -> SteadyCase {
        self.case(self.alphas_rad.iter().copied().fold(f64::INFINITY, f64::min))
    }
}

/// Corrections next to the mean with which the wing of the file, its structure as given, has the measured root loads.
fn on_given_structure(
    wing: &ElasticWing,
    flow: Flow,
    unknowns: &Unknowns,
    data: &Data,
    mean: &[f64],
) -> Result<Corrections, CouplingError> {
    let count = unknowns.of_corrections();
    let mut z: Vec<f64> = mean[..count].to_vec();
    let mut off = unknowns.wing(mean);
    off.log_flexibility = [0.0; 2];
    for _ in 0..GIVEN_STEPS {
        z.resize(count, 0.0);
        let mut at: Vec<f64> = z.clone();
        at.extend(&mean[count..]);
        off.corrections = unknowns.wing(&at).corrections;
        let here = linearise(wing, flow, unknowns, data, off.clone(), &at)?;
        let on_balance = |datum: &Datum| datum.row < 3 && datum.hung.is_none();
        let balance = || (0..data.measured.len()).filter(|&i| on_balance(&data.measured[i]));
        let rows: Vec<Vec<f64>> = balance().map(|i| here.rows[i][..count].to_vec()).collect();
        let rows: Vec<&Vec<f64>> = rows.iter().collect();
        let moved = |row: &[f64]| {
            row.iter().zip(z.iter().zip(mean)).map(|(by, (z, mean))| by * (z - mean)).sum::<f64>()
        };
        let asked: Vec<f64> = balance().zip(&rows).map(|(i, row)| here.misses[i] + moved(row)).collect();
        let Some(weights) = weights(&rows, &asked) else { break };
        z = mean[..count].to_vec();
        for (row, weight) in rows.iter().zip(weights) {
            row.iter().zip(&mut z).for_each(|(value, z)| *z += value * weight);
        }
    }
    let mut at = z;
    at.extend(&mean[count..]);
    Ok(unknowns.wing(&at).corrections)
}

/// The unknowns that the data and the prior leave most likely: Gauss and Newton's steps from theory.
fn mean<'a>(
    wing: &'a ElasticWing,
    flow: Flow,
    unknowns: &Unknowns,
    data: &Data,
) -> Result<Linearised<'a>, CouplingError> {
    let mut z = vec![0.0; unknowns.count() + data.nuisances];
    let at = |z: &[f64]| linearise(wing, flow, unknowns, data, unknowns.wing(z), z);
    let mut here = at(&z)?;
    for _ in 0..STEPS {
        let rows: Vec<&Vec<f64>> = here.rows.iter().collect();
        let asked: Vec<f64> =
            here.rows.iter().zip(&here.misses).map(|(row, miss)| miss + product(row, &z)).collect();
        let Some(weights) = weights(&rows, &asked) else { break };
        let mut goal = vec![0.0; z.len()];
        for (row, weight) in rows.iter().zip(weights) {
            row.iter().zip(&mut goal).for_each(|(value, goal)| *goal += value * weight);
        }
        let mut step = 1.0;
        let mut moved = 0.0;
        for _ in 0..=HALVINGS {
            let next: Vec<f64> = z.iter().zip(&goal).map(|(from, to)| from + step * (to - from)).collect();
            match at(&next) {
                Ok(there) if there.objective <= here.objective => {
                    moved = next.iter().zip(&z).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                    (z, here) = (next, there);
                    break;
                }
                Ok(_) | Err(CouplingError::Diverged { .. }) => step *= 0.5,
                Err(error) => return Err(error),
            }
        }
        if moved < STILL {
            break;
        }
    }
    Ok(here)
}

/// Linearises at a wing that unknowns stand for, or another with unknowns of the sensors alone.
fn linearise<'a>(
    wing: &'a ElasticWing,
    flow: Flow,
    unknowns: &Unknowns,
    data: &Data,
    off: WingOff,
    z: &[f64],
) -> Result<Linearised<'a>, CouplingError> {
    let operator = wing.at(flow, &off.corrections)?;
    let reads: Vec<CaseRead> =
        data.cases.iter().map(|case| read_case(&operator, &off, case, &data.together)).collect();
    let mut rows = Vec::with_capacity(data.measured.len());
    let mut misses = Vec::with_capacity(data.measured.len());
    for datum in &data.measured {
        let (mut value, mut row) = if let Some(hung) = &datum.hung {
            unknowns.under_weight(hung, &off)
        } else {
            let read = &reads[datum.case];
            (read.values[datum.row], unknowns.gradient(read, datum.row))
        };
        row.resize(z.len(), 0.0);
        for &(unknown, by) in &datum.nuisances {
            row[unknowns.count() + unknown] = by;
            value += by * z[unknowns.count() + unknown];
        }
        let sigma = datum.sigma.max(f64::MIN_POSITIVE);
        rows.push(over(row, sigma));
        misses.push((datum.value - value) / sigma);
    }
    let objective = 0.5 * (product(&misses, &misses) + product(z, z));
    Ok(Linearised { z: z.to_vec(), off, operator, rows, misses, objective })
}

/// `(J J' + I)⁻¹ b`; none only if rows are not finite.
fn weights(rows: &[&Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let covariance =
        Mat::from_fn(rows.len(), rows.len(), |i, j| product(rows[i], rows[j]) + f64::from(u8::from(i == j)));
    let factor = covariance.llt(Side::Lower).ok()?;
    let solved = factor.solve(&Mat::from_fn(right.len(), 1, |i, _| right[i]));
    Some((0..right.len()).map(|i| solved[(i, 0)]).collect())
}

/// A row over the standard deviation of its reading.
pub(super) fn over(row: Vec<f64>, sigma: f64) -> Vec<f64> {
    row.into_iter().map(|value| value / sigma.max(f64::MIN_POSITIVE)).collect()
}
