//! A run in which the flow separates: the linear system stepped sample by sample, with the zones' lost incidence as input.

use crate::at_speed::{AtSpeed, STEP_S};
use crate::separation::Separation;
use crate::strips::ZONES;
use crate::system::{Inputs, Parts};
use faer::Mat;

/// Steps of the fixed point at rest, each half of what it asks for.
const STEADY_STEPS: usize = 60;

/// Angles of the zones: root pitch, twist and plunge.
fn angles(at: &AtSpeed, state: &[f64], alpha_rad: f64) -> [f64; ZONES] {
    let c = &at.linear.c;
    let row = |row: usize| (0..state.len()).map(|k| c[(row, k)] * state[k]).sum::<f64>();
    std::array::from_fn(|zone| {
        alpha_rad + row(4 + 2 * ZONES + zone) - row(4 + 3 * ZONES + zone) / at.v_m_s.max(1.0)
    })
}

/// As without separation, with it.
pub(crate) fn fly_separated(
    parts: &Parts,
    at: &AtSpeed,
    mut inputs: Mat<f64>,
    flow: &Separation,
) -> Mat<f64> {
    let places = at.linear.inputs;
    let chord_m = parts.strips.chord_m.iter().sum::<f64>() / parts.strips.len().max(1) as f64;
    let share = 1.0 - (-STEP_S * at.v_m_s / (flow.chords * chord_m)).exp();
    let plain = at.linear.equilibrium(inputs.col_as_slice(0));
    let by_zone = at.linear.equilibrium_by_zone();
    let mut state = plain.clone();
    let mut points = [1.0; ZONES];
    let mut lost = [0.0; ZONES];
    for _ in 0..STEADY_STEPS {
        for (zone, angle) in angles(at, &state, inputs[(Inputs::ALPHA, 0)]).into_iter().enumerate() {
            points[zone] = flow.point(zone, angle);
            lost[zone] += 0.5 * (flow.lost(points[zone], angle) - lost[zone]);
        }
        for (i, value) in state.iter_mut().enumerate() {
            *value = plain[i] + (0..ZONES).map(|zone| by_zone[(i, zone)] * lost[zone]).sum::<f64>();
        }
    }
    for (zone, incidence) in lost.iter().enumerate() {
        inputs[(places.zone(0, zone), 0)] = *incidence;
    }
    let mut outputs = Mat::zeros(at.linear.c.nrows(), inputs.ncols());
    let mut x = Mat::from_fn(state.len(), 1, |i, _| state[i]);
    for i in 0..inputs.ncols() {
        if i > 0 {
            let alpha_rad = inputs[(Inputs::ALPHA, i)];
            for (zone, angle) in angles(at, x.col_as_slice(0), alpha_rad).into_iter().enumerate() {
                points[zone] += share * (flow.point(zone, angle) - points[zone]);
                let now = flow.lost(points[zone], angle);
                inputs[(places.zone(0, zone), i)] = now;
                inputs[(places.zone(1, zone), i)] = (now - lost[zone]) / STEP_S;
                lost[zone] = now;
            }
            x = &at.step.transition * &x
                + &at.step.from_first * inputs.as_ref().subcols(i - 1, 1)
                + &at.step.from_last * inputs.as_ref().subcols(i, 1);
        }
        let y = &at.linear.c * &x + &at.linear.d * inputs.as_ref().subcols(i, 1);
        for row in 0..outputs.nrows() {
            outputs[(row, i)] = y[(row, 0)];
        }
    }
    outputs
}
