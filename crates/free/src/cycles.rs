//! The cycle that a rig settles on, integrated in time, and over airspeed the lowest at which it has one.

use crate::balance::Model;
use crate::motion::Motion;
use crate::section::{State, Stream};
use crate::window::{Oscillation, oscillation, strongest};

/// Step, s: 60 in a period of the third harmonic.
const STEP_S: f64 = 0.002;
/// Every so many steps a sample is kept: 250 Hz.
const KEPT: usize = 2;
/// Samples of a piece by which a motion is judged: two seconds.
const PIECE: usize = 500;
/// Pieces at most.
const PIECES: usize = 60;
/// A motion is steady if its amplitude changes by less than this from piece to piece.
const STEADY: f64 = 5e-4;
/// Below this amplitude a motion is none, rad: the friction's rounding and turbulence are there.
const NONE_RAD: f64 = 3e-3;
/// Beyond this angle nothing that a rig's file says holds, rad.
const LARGEST_RAD: f64 = 1.0;
/// From where a motion begins, rad.
pub const FROM_RAD: f64 = 0.15;

/// A settled motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// The oscillation; none if the motion dies.
    pub cycle: Option<Oscillation>,
    /// Pitch and heave of the last two seconds, rad and m.
    pub trace: [Vec<f64>; 2],
    /// Where it ended.
    pub end: State,
}

/// The state at rest with the pitch held aside, rad.
pub fn aside(pitch_rad: f64) -> State {
    let mut state = State::zeros();
    state[1] = pitch_rad;
    state
}

/// Follows a motion until it is steady, dies, or goes where no model holds.
pub fn settle(model: &Model, stream: Stream, start: State, omega_rad_s: f64) -> Settled {
    let section = model.section();
    let motion = Motion::new(&section, &model.effects, stream, omega_rad_s);
    let mut state = start;
    let mut last: Option<Oscillation> = None;
    let mut trace = [Vec::new(), Vec::new()];
    for _ in 0..PIECES {
        trace = [Vec::with_capacity(PIECE), Vec::with_capacity(PIECE)];
        for _ in 0..PIECE {
            trace[0].push(state[1]);
            trace[1].push(state[0] * model.rig.heave_gain);
            for _ in 0..KEPT {
                state = motion.step(&state, STEP_S);
            }
        }
        let largest = trace[0].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if !(NONE_RAD..LARGEST_RAD).contains(&largest) {
            return Settled { cycle: None, trace, end: state };
        }
        let dt_s = STEP_S * KEPT as f64;
        let here = oscillation(&trace[0], &trace[1], dt_s, strongest(&trace[0], dt_s, [1.0, 8.0]), true);
        let before = last.replace(here);
        let now = last.as_ref().map_or(0.0, |o| o.amplitude_rad);
        if before.is_some_and(|o| (o.amplitude_rad / now - 1.0).abs() < STEADY) {
            break;
        }
    }
    Settled { cycle: last.filter(|o| o.amplitude_rad > NONE_RAD), trace, end: state }
}

/// Follows the large cycle down in airspeed, each from the end of the one above; the lowest airspeed (m/s) that has one.
pub fn fold_m_s(model: &Model, rho_kg_m3: f64, range_m_s: [f64; 2], step_m_s: f64) -> Option<f64> {
    let mut lowest = None;
    let mut state = aside(FROM_RAD);
    let mut omega = 18.0;
    let mut v_m_s = range_m_s[1];
    while v_m_s >= range_m_s[0] {
        let settled = settle(model, Stream { rho_kg_m3, v_m_s }, state, omega);
        let Some(cycle) = settled.cycle else { return lowest };
        (lowest, state, omega) = (Some(v_m_s), settled.end, cycle.p.im);
        v_m_s -= step_m_s;
    }
    lowest
}
