//! Static cases: every airspeed and angle in every block, and wind-off weight tares.

use crate::file::TunnelFile;
use crate::noise::{NoiseSource, Stream};
use crate::truth::{TrueState, Truth, TunnelError};
use coupling::RootLoads;
use std::fmt::Write as _;

/// One measured row of `static.csv`.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticRow {
    /// Airspeed, m/s; zero for a weight tare.
    pub v_m_s: f64,
    /// Angle of attack, degrees.
    pub alpha_deg: f64,
    /// What the balance shows.
    pub loads: RootLoads,
    /// Block.
    pub block: String,
    /// Height of the tip above its wind-off place at alpha = 0, m.
    pub tip_z_m: f64,
}

/// Measures all static cases, block by block.
pub(crate) fn measure(tunnel: &TunnelFile, truth: &Truth, seed: u64) -> Result<Vec<StaticRow>, TunnelError> {
    let statics = &tunnel.statics;
    let mut rows = Vec::new();
    let mut tares = NoiseSource::new(seed, Stream::WeightTares);
    let mut points = NoiseSource::new(seed, Stream::StaticRows);
    let mut offsets = block_offsets(tunnel, seed).into_iter().map(|(_, offset)| offset);
    let states = |v_m_s: f64, angles_deg: &[f64]| {
        let alphas: Vec<f64> = angles_deg.iter().map(|angle| angle.to_radians()).collect();
        truth.states(v_m_s, &alphas)
    };
    let tilted = states(0.0, &statics.tilt_deg)?;
    let mut tested = Vec::new();
    for &v_m_s in &statics.airspeeds_m_s {
        tested.push((v_m_s, states(v_m_s, &statics.angles_deg)?));
    }
    for (block, replicates) in &statics.blocks.replicates {
        let mut row =
            |v_m_s: f64, alpha_deg: f64, state: &TrueState, offset: RootLoads, noise: &mut NoiseSource| {
                let loads = state.loads + offset + noise.loads(tunnel.noise.static_point);
                let tip_z_m = state.tip_z_m + noise.normal(statics.tip_z_sigma_m);
                rows.push(StaticRow { v_m_s, alpha_deg, loads, block: block.clone(), tip_z_m });
            };
        for (alpha_deg, state) in statics.tilt_deg.iter().zip(&tilted) {
            row(0.0, *alpha_deg, state, RootLoads::default(), &mut tares);
        }
        let offset = offsets.next().unwrap_or_default();
        for _ in 0..*replicates {
            for (v_m_s, states) in &tested {
                for (alpha_deg, state) in statics.angles_deg.iter().zip(states) {
                    row(*v_m_s, *alpha_deg, state, offset, &mut points);
                }
            }
        }
    }
    Ok(rows)
}

/// What each day adds to all wind-on readings.
pub(crate) fn block_offsets(tunnel: &TunnelFile, seed: u64) -> Vec<(&str, RootLoads)> {
    let mut source = NoiseSource::new(seed, Stream::BlockOffsets);
    let blocks = &tunnel.statics.blocks;
    blocks.replicates.iter().map(|(block, _)| (block.as_str(), source.loads(blocks.offset_sigma))).collect()
}

/// The rows as `static.csv`.
pub(crate) fn csv(rows: &[StaticRow]) -> String {
    let mut text = String::from("V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm,block,tip_z_m\n");
    for row in rows {
        let [fz, mx, my] = row.loads.to_array().map(tidy_zero);
        let (v, alpha, tip) = (row.v_m_s, row.alpha_deg, tidy_zero(row.tip_z_m));
        let _ = writeln!(text, "{v:.2},{alpha:.2},{fz:.4},{mx:.4},{my:.4},{},{tip:.5}", row.block);
    }
    text
}

/// Numbers that print as "-0.0000" print as "0.0000".
pub(crate) fn tidy_zero(value: f64) -> f64 {
    if value.abs() < 5e-6 { 0.0 } else { value }
}
