//! Runs in time: the true wing in the rig, with what the model does not have (joiner, loss of deflection) and what the
//! balance adds (noise, the day's offset).

use crate::file::TunnelFile;
use crate::noise::{NoiseSource, Stream};
use crate::run_file::{Dynamics, RunPlan};
use crate::statics::{block_offsets, tidy_zero};
use crate::truth::{Truth, TunnelError};
use aero::Flow;
use coupling::{Load, RootLoads};
use maneuver::motion::ANGLE;
use maneuver::{DeflectionCorrection, Motion, Rig, RigSettings, Smooth, TimeHistory, fly_commanded};
use nastran::InputError;
use std::fmt::Write as _;

/// Everything is at rest before.
const START_S: f64 = 0.5;

/// All runs as file names and texts.
pub(crate) fn measure(
    tunnel: &TunnelFile,
    truth: &Truth,
    seed: u64,
) -> Result<Vec<(String, String)>, TunnelError> {
    let Some(dynamics) = tunnel.dynamics.as_ref().filter(|_| !tunnel.runs.is_empty()) else {
        return Ok(Vec::new());
    };
    let plain = RigSettings::of_wing(&truth.file);
    let settings = RigSettings { actuator: dynamics.actuator.unwrap_or(plain.actuator), ..plain };
    let rig = Rig::new(&truth.wing, settings)?;
    let deflection = DeflectionCorrection::new(dynamics.deflection.clone());
    let offsets = block_offsets(tunnel, seed);
    let mut files = Vec::with_capacity(tunnel.runs.len());
    for (number, plan) in (0..).zip(&tunnel.runs) {
        let flow = Flow { v_m_s: plan.v_m_s, rho_kg_m3: truth.rho_kg_m3 };
        let model = rig.at(flow, &truth.corrections(plan.v_m_s))?;
        let (motion, commanded) = motion(plan, dynamics, &model.controls)
            .map_err(|message| InputError::in_file(&tunnel.path, format!("{}: {message}", plan.file)))?;
        let history = fly_commanded(&model, &motion, &deflection.at(plan.v_m_s)?);
        let day = offsets.iter().find(|(block, _)| Some(*block) == plan.block.as_deref() && plan.v_m_s > 0.0);
        let balance = Balance {
            offset: day.map_or(RootLoads::default(), |(_, offset)| *offset),
            noise: NoiseSource::new(seed, Stream::Run(number)),
        };
        files.push((plan.file.clone(), csv(tunnel, dynamics, plan, &history, &motion, &commanded, balance)));
    }
    Ok(files)
}

/// What the balance adds to the loads.
struct Balance {
    offset: RootLoads,
    noise: NoiseSource,
}

/// What moves the rig (deflections as commanded), and the one that moves, rad.
fn motion(plan: &RunPlan, dynamics: &Dynamics, controls: &[String]) -> Result<(Motion, Vec<f64>), String> {
    let time_step_s = 1.0 / dynamics.sample_rate_hz;
    let samples = 1..=steps(plan.length_s * dynamics.sample_rate_hz)?;
    let times: Vec<f64> = std::iter::once(0.0).chain(samples.map(|i| f64::from(i) * time_step_s)).collect();
    let kind = plan.motion.kind();
    let pitches = plan.motion.moves(ANGLE);
    let of = |moves: bool, value: &dyn Fn(f64) -> f64| -> Vec<f64> {
        times.iter().map(|&t_s| if moves { value(t_s - START_S) } else { 0.0 }).collect()
    };
    let commanded = of(!pitches, &|t| kind.at(t));
    let mut controls_rad = vec![vec![0.0; times.len()]; controls.len()];
    if let Some(name) = plan.motion.control() {
        let place = controls.iter().position(|control| control == name);
        let place =
            place.ok_or_else(|| format!("the wing has no control {name}; it has {}", controls.join(", ")))?;
        controls_rad[place].clone_from(&commanded);
    }
    let base = plan.alpha_deg.to_radians();
    let alpha = Smooth {
        value: of(pitches, &|t| kind.at(t)).into_iter().map(|change| base + change).collect(),
        rate: of(pitches, &|t| kind.rate(t)),
        second: of(pitches, &|t| kind.second(t)),
    };
    Ok((Motion { time_step_s, alpha, controls_rad }, commanded))
}

/// A number of time steps that a run can have.
fn steps(count: f64) -> Result<u32, String> {
    if !(3.0..=1e6).contains(&count) {
        return Err(format!("{count} samples, expected 3 to a million"));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked in the lines above")]
    Ok(count.round() as u32)
}

/// The run as the balance and the angle sensor show it.
fn csv(
    tunnel: &TunnelFile,
    dynamics: &Dynamics,
    plan: &RunPlan,
    history: &TimeHistory,
    motion: &Motion,
    commanded: &[f64],
    balance: Balance,
) -> String {
    let Balance { offset, mut noise } = balance;
    let mut text = String::from("t_s,V_m_s,alpha_deg,Fz_N,Mx_Nm,My_Nm,tip_z_m");
    if let Some(control) = plan.motion.control() {
        let _ = write!(text, ",delta_{control}_deg");
    }
    text.push('\n');
    let channel = |name: &str, i: usize| history.get(name).map_or(0.0, |values| values[i]);
    let clean = |load: Load, i: usize| channel(load.column(), i);
    for (i, command) in commanded.iter().enumerate() {
        let error = noise.loads(tunnel.noise.sample);
        let joiner = dynamics.joiner.loads(motion.alpha.second[i]);
        let shown = RootLoads::from_array(Load::ALL.map(|load| clean(load, i))) + joiner + offset + error;
        let [fz, mx, my] = shown.to_array().map(tidy_zero);
        let alpha = motion.alpha.value[i].to_degrees() + noise.normal(dynamics.alpha_sigma_deg);
        let tip = tidy_zero(channel("tip_z_m", i) + noise.normal(tunnel.statics.tip_z_sigma_m));
        let t_s = i as f64 * motion.time_step_s;
        let v_m_s = plan.v_m_s;
        let _ = write!(text, "{t_s:.4},{v_m_s:.2},{alpha:.4},{fz:.4},{mx:.4},{my:.4},{tip:.5}");
        if plan.motion.control().is_some() {
            let _ = write!(text, ",{:.4}", tidy_zero(command.to_degrees()));
        }
        text.push('\n');
    }
    text
}
