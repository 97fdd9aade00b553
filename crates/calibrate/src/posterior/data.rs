//! What was measured at an airspeed, row by row, and what stands between a reading and the wing: offsets, zeros, scales.

use crate::calibration::{AirspeedCalibration, Calibration};
use crate::campaign::{CHANNELS, StaticPoint, TIP, TipReading};
use crate::objective::{LineFit, probability_of_noise};
use crate::sensors::{Row, Sensor, Together, Zero};
use aero::Flow;
use aero::flow::same_airspeed;
use coupling::{ElasticWing, SteadyCase};
use faer::Mat;
use nastran::InputError;

/// A zero that is not known is as uncertain as this many times the largest reading.
const LOOSE: f64 = 10.0;

/// Unknowns that each reading's rows fit about (a line).
const FITTED: usize = 2;

/// A number that was measured.
pub(super) struct Datum {
    /// Index of its case.
    pub(super) case: usize,
    /// Index of the reading: of the balance's channels, the tip, or a sensor.
    pub(super) row: usize,
    pub(super) value: f64,
    /// Standard deviation of its noise.
    pub(super) sigma: f64,
    /// Unknowns of its reading and sensor that it hangs on as well, standard Gaussians, and its derivative by each.
    pub(super) nuisances: Vec<(usize, f64)>,
    /// What the structure as given reads, if it was read under a dead weight with wind off and not in the case.
    pub(super) hung: Option<Hung>,
}

/// A reading under a dead weight.
pub(super) struct Hung {
    pub(super) value: f64,
    /// By the logarithms of the flexibility in bending and in torsion.
    pub(super) by_flexibility: [f64; 2],
}

/// What is known of a channel's rows.
struct ChannelKnown {
    /// Standard deviation of one row.
    sigma: f64,
    /// What moves all of them together.
    offsets: Vec<(usize, f64)>,
}

/// All of an airspeed.
pub(super) struct Data {
    pub(super) cases: Vec<SteadyCase>,
    pub(super) together: Together,
    pub(super) measured: Vec<Datum>,
    /// Number of unknowns beside the wing's: first one of each reading, then of channels and sensors.
    pub(super) nuisances: usize,
    /// What any reading is off by, as a share of it: one unknown for all rows of a reading, as the same lattice reads them.
    reading: f64,
    /// Names of the readings' columns.
    pub(super) names: Vec<String>,
    /// How many times the stated noise is taken, by reading.
    raised: Vec<f64>,
}

impl Data {
    pub(super) fn of(
        wing: &ElasticWing,
        calibration: &Calibration,
        at: &AirspeedCalibration,
        reading: f64,
    ) -> Result<Self, InputError> {
        let statics = &calibration.data;
        let sensors = statics.sensors.iter().map(|sensor| sensor.reads.row(wing));
        let tip = Row::OnStructure(wing.tip_row());
        let together = Together::new(wing, (0..3).map(Row::Balance).chain([tip]).chain(sensors).collect());
        let mut names = vec![String::new(); together.places.len()];
        let columns = CHANNELS.into_iter().chain(statics.sensors.iter().map(|sensor| sensor.column.as_str()));
        for (&place, column) in together.places.iter().zip(columns) {
            names[place].push_str(column);
        }
        let raised = vec![1.0; names.len()];
        let (cases, measured) = (Vec::new(), Vec::new());
        let nuisances = names.len() + CHANNELS.len();
        let mut found = Self { cases, together, measured, nuisances, reading, names, raised };
        let flow = Flow { v_m_s: at.data.v_m_s, rho_kg_m3: calibration.rho_kg_m3 };
        let channels = found.channels(calibration, at);
        for angle in &at.data.angles {
            let case = found.case(SteadyCase::new(flow, angle.alpha_rad));
            for (channel, known) in channels.iter().enumerate().filter(|&(c, _)| statics.channels[c]) {
                let sigma = known.sigma / (angle.replicates as f64).sqrt();
                found.add(case, channel, angle.readings()[channel], sigma, known.offsets.clone());
            }
        }
        let further: Vec<&StaticPoint> =
            statics.further.iter().filter(|point| same_airspeed(point.v_m_s, flow.v_m_s)).collect();
        let hung: Vec<&StaticPoint> =
            statics.further.iter().filter(|p| p.is_hung(&statics.sensors)).collect();
        let read: Vec<&StaticPoint> = further.iter().chain(&hung).copied().collect();
        let of_sensors = found.of_sensors(&statics.sensors, &read);
        found.hang(wing, &statics.sensors, &hung, &of_sensors);
        for point in further {
            let case = found.case(case_of(wing, flow, point)?);
            // neutral rows are in the means of their angles
            let deflected = !point.controls_rad.is_empty();
            for (channel, known) in
                channels.iter().enumerate().filter(|&(c, _)| statics.channels[c] && deflected)
            {
                let value = point.reading(channel) - statics.offset_of(point, channel);
                found.add(case, channel, value, known.sigma, known.offsets.clone());
            }
            for (s, sensor) in statics.sensors.iter().enumerate() {
                let Some(value) = point.sensors[s] else { continue };
                let nuisances = nuisances_of(&of_sensors[s], sensor, value);
                found.add(case, CHANNELS.len() + s, value, sensor.sigma, nuisances);
            }
        }
        Ok(found)
    }

    /// Adds what is read under dead weights.
    fn hang(
        &mut self,
        wing: &ElasticWing,
        sensors: &[Sensor],
        points: &[&StaticPoint],
        of_sensors: &[Vec<(usize, Option<f64>)>],
    ) {
        for point in points {
            for (s, sensor) in sensors.iter().enumerate() {
                let (Some(value), Some(weight)) = (point.sensors[s], sensor.under) else { continue };
                let Row::OnStructure(row) = sensor.reads.row(wing) else { continue };
                let rows = Mat::from_fn(1, row.len(), |_, i| row[i]);
                let weight_n = weight.mass_kg * wing.gravity_m_s2 * point.alpha_rad.cos();
                let place = [weight.y_over_span, weight.x_over_c];
                let (read, by_flexibility) = wing.under_weight(weight_n, place, &rows);
                self.measured.push(Datum {
                    case: 0,
                    row: self.together.places[CHANNELS.len() + s],
                    value,
                    sigma: sensor.sigma,
                    nuisances: nuisances_of(&of_sensors[s], sensor, value),
                    hung: Some(Hung { value: read[0], by_flexibility: by_flexibility.map(|by| by[0]) }),
                });
            }
        }
    }

    /// Adds a number of a column: of the channels, then of the sensors.
    fn add(&mut self, case: usize, column: usize, value: f64, sigma: f64, mut nuisances: Vec<(usize, f64)>) {
        let row = self.together.places[column];
        nuisances.push((row, self.reading * value));
        self.measured.push(Datum { case, row, value, sigma, nuisances, hung: None });
    }

    /// Noise of the channels and what moves all rows of one together: the offset common to all blocks, a tip's zero.
    fn channels(&mut self, calibration: &Calibration, at: &AirspeedCalibration) -> [ChannelKnown; 4] {
        let statics = &calibration.data;
        let (sigma, common) = (statics.point_sigma.unwrap_or(at.line.rmse), statics.common_sigma());
        let tip_zero = (statics.tip == TipReading::FreeZero).then(|| self.further_nuisance());
        let farthest_m = at.data.angles.iter().map(|angle| angle.tip_z_m.abs()).fold(0.0, f64::max);
        std::array::from_fn(|channel| {
            let zero = tip_zero.filter(|_| channel == TIP).map(|zero| (zero, LOOSE * farthest_m));
            ChannelKnown {
                sigma: sigma[channel],
                offsets: std::iter::once((self.names.len() + channel, common[channel])).chain(zero).collect(),
            }
        })
    }

    /// Unknowns of sensors: zeros of their sizes, and scales, whose size is a share of what is read.
    fn of_sensors(&mut self, sensors: &[Sensor], points: &[&StaticPoint]) -> Vec<Vec<(usize, Option<f64>)>> {
        let one = |(s, sensor): (usize, &Sensor)| {
            let largest =
                points.iter().filter_map(|point| point.sensors[s]).map(f64::abs).fold(0.0, f64::max);
            let zero = (sensor.zero == Zero::Free).then(|| (self.further_nuisance(), Some(LOOSE * largest)));
            let scale = (sensor.scale > 0.0).then(|| (self.further_nuisance(), None));
            zero.into_iter().chain(scale).collect()
        };
        sensors.iter().enumerate().map(one).collect()
    }

    /// By reading, how many times the noise its rows miss the wing at the mean, where noise does not explain that (a chance below
    /// `significance` among all of them); none where it does for all.
    pub(super) fn levels(
        &self,
        misses: &[f64],
        noise_dof: Option<usize>,
        significance: f64,
    ) -> Option<Vec<f64>> {
        let balance_and_tip = &self.together.places[..CHANNELS.len()];
        let level = |row: usize| {
            let of = || self.measured.iter().zip(misses).filter(|(datum, _)| datum.row == row);
            let freedom = of().count().saturating_sub(FITTED).max(1) as f64;
            let f = of().map(|(_, miss)| miss * miss).sum::<f64>() / freedom;
            let dof = noise_dof.filter(|_| balance_and_tip.contains(&row));
            let chance = probability_of_noise(f, freedom, dof).unwrap_or(1.0);
            if f > 1.0 && chance < significance / self.raised.len() as f64 { f.sqrt() } else { 1.0 }
        };
        let levels: Vec<f64> = (0..self.raised.len()).map(level).collect();
        levels.iter().any(|level| *level > 1.0).then_some(levels)
    }

    /// By reading, how many times the noise straight lines miss the loads, where that is significant.
    pub(super) fn levels_of_lines(&self, calibration: &Calibration, line: &LineFit) -> Vec<f64> {
        let mut levels = vec![1.0; self.raised.len()];
        for (&place, test) in self.together.places.iter().zip(&line.nonlinearity) {
            if let Some(test) = test.filter(|test| test.p_value < calibration.nonlinearity_level) {
                levels[place] = test.f.sqrt().max(1.0);
            }
        }
        levels
    }

    /// Raises the noise of readings by their levels.
    pub(super) fn raise(&mut self, levels: &[f64]) {
        for datum in &mut self.measured {
            datum.sigma *= levels[datum.row];
        }
        self.raised.iter_mut().zip(levels).for_each(|(raised, level)| *raised *= level);
    }

    /// Columns whose noise was raised, and how many times.
    pub(super) fn beyond(&self) -> Vec<(String, f64)> {
        let all = self.names.iter().cloned().zip(self.raised.iter().copied());
        all.filter(|(_, raised)| *raised > 1.0).collect()
    }

    fn further_nuisance(&mut self) -> usize {
        self.nuisances += 1;
        self.nuisances - 1
    }

    /// The index of a case, among those there are or behind them.
    fn case(&mut self, case: SteadyCase) -> usize {
        self.cases.iter().position(|other| *other == case).unwrap_or_else(|| {
            self.cases.push(case);
            self.cases.len() - 1
        })
    }
}

/// Unknowns of a sensor that read `value`, and the derivatives of the reading by them.
fn nuisances_of(unknowns: &[(usize, Option<f64>)], sensor: &Sensor, value: f64) -> Vec<(usize, f64)> {
    unknowns.iter().map(|&(unknown, size)| (unknown, size.unwrap_or(sensor.scale * value))).collect()
}

/// The case of a row.
fn case_of(wing: &ElasticWing, flow: Flow, point: &StaticPoint) -> Result<SteadyCase, InputError> {
    let names = wing.control_names();
    let mut case = SteadyCase::new(flow, point.alpha_rad);
    if !point.controls_rad.is_empty() {
        case.controls_rad = vec![0.0; names.len()];
    }
    for (name, delta_rad) in &point.controls_rad {
        let Some(c) = names.iter().position(|control| control == name) else {
            return Err(InputError::at(&point.span, format!("the wing has no control surface {name}"))
                .with_help(format!("its control surfaces are {}", names.join(", "))));
        };
        case.controls_rad[c] = *delta_rad;
    }
    Ok(case)
}
