//! Records of runs: what balance and data acquisition make of a flight in every block, with noise.

use crate::air::Strip;
use crate::campaign::{Planned, Record};
use crate::campaign::{design, noise, sampling};
use crate::drive::Maneuver;
use crate::effects;
use crate::order::Order;
use crate::random::{Purpose, Random};
use crate::rig::Flight;

/// Blocks, in each of which every run is flown once.
pub(crate) const BLOCKS: usize = 2;

/// A run as it was flown, without noise.
pub(crate) struct Flown {
    pub(crate) flight: Flight,
    pub(crate) alpha: [Vec<f64>; 3],
    pub(crate) command: Option<(usize, Vec<f64>)>,
    pub(crate) time_step_s: f64,
}

/// What effects may know of a maneuver's record.
pub(crate) fn seen<'a>(
    maneuver: &Maneuver,
    time_step_s: f64,
    (start_s, number): (f64, Option<u64>),
    alpha: &'a [Vec<f64>; 3],
) -> effects::Record<'a> {
    let v_m_s = maneuver.v_m_s;
    effects::Record {
        v_m_s,
        q_pa: 0.5 * maneuver.rho_kg_m3 * v_m_s * v_m_s,
        start_s,
        time_step_s,
        number,
        alpha,
    }
}

/// Offsets of the blocks.
pub(crate) fn block_offsets(seed: u64) -> [[f64; 3]; BLOCKS] {
    let random = &mut Random::new(seed, Purpose::Blocks);
    std::array::from_fn(|_| noise::channels(random, noise::BLOCK))
}

/// All records of the runs, block after block of each, with noise.
pub(crate) fn records(order: &Order, planned: &[Planned], flown: &[Flown], strips: &[Strip]) -> Vec<Record> {
    let random = &mut Random::new(order.seed, Purpose::Order);
    let offsets = block_offsets(order.seed);
    let mut starts = vec![vec![0.0; planned.len()]; BLOCKS];
    for (block, starts) in starts.iter_mut().enumerate() {
        for (place, run) in random.order(planned.len()).into_iter().enumerate() {
            starts[run] = design::CYCLE_S * (block * planned.len() + place) as f64;
        }
    }
    let name = |run: usize, block: usize| {
        let again = if block > 0 { "_again" } else { "" };
        format!("{}{again}.csv", planned[run].name)
    };
    let mut all = Vec::new();
    for (run, flown) in flown.iter().enumerate() {
        let maneuver = &planned[run].maneuver;
        let (samples, rate_hz, dt) = (maneuver.samples(), maneuver.sample_rate_hz, flown.time_step_s);
        for block in 0..BLOCKS {
            let number = (block * planned.len() + run) as u64;
            let start_s = starts[block][run];
            let of_record = order.seed.wrapping_mul(1009).wrapping_add(number);
            let here = seen(maneuver, dt, (start_s, Some(of_record)), &flown.alpha);
            let mut flight = flown.flight.clone();
            effects::measured(&order.effects, &here, strips, &mut flight);
            let random = &mut Random::new(order.seed, Purpose::Record(number));
            let errors = noise::of_record(random, maneuver.v_m_s, samples, rate_hz);
            let own = noise::channels(random, noise::RECORD);
            let sampled = |values: &[f64]| sampling::sampled(values, dt, rate_hz, samples);
            let loads = std::array::from_fn(|channel| {
                // zeros are taken without wind
                let day = if maneuver.v_m_s > 0.0 { offsets[block][channel] } else { 0.0 };
                let clean = sampled(&flight.loads[channel]);
                let noisy = clean.iter().zip(&errors[channel]);
                noisy.map(|(load, error)| load + day + own[channel] + error).collect()
            });
            let read = |angle: &f64| {
                let said = order.effects.iter().fold(*angle, |angle, effect| effect.on_reading(angle));
                said.to_degrees()
            };
            let reading: Vec<f64> = flown.alpha[0].iter().map(read).collect();
            let mut noisy = |values: &[f64], sigma: f64| -> Vec<f64> {
                sampled(values).iter().map(|value| value + random.normal(sigma)).collect()
            };
            let command = flown.command.as_ref().map(|(control, values)| {
                (*control, sampled(&values.iter().map(|d| d.to_degrees()).collect::<Vec<f64>>()))
            });
            all.push(Record {
                file: name(run, block),
                block,
                start_s,
                v_m_s: maneuver.v_m_s,
                train: planned[run].train,
                repeat_of: (block > 0).then(|| name(run, 0)),
                rate_hz,
                alpha_deg: noisy(&reading, noise::ALPHA_DEG),
                tip_z_m: noisy(&flight.tip_z_m, noise::TIP_M),
                loads,
                command,
            });
        }
    }
    all
}
