//! A rig of the tests' own: the section's equations written out, the lift's lag by a recurrence of deficiencies (Leishman),
//! Heun's method. It shares no line with the crate's model.

use std::f64::consts::PI;

use free::campaign::{Kind, Run};

/// What a spring, a stall or a damper adds to the nose-down moment: pitch (rad), rate (rad/s), dynamic pressure (Pa).
pub(crate) type Moment<'m> = &'m dyn Fn(f64, f64, f64) -> f64;

const B: f64 = 0.15;
const A: f64 = -0.48;
const SPAN: f64 = 0.7;
const LAG: f64 = 0.3;
const RHO: f64 = 1.186;
/// Mass, unbalance, inertia; dampers and springs of heave and pitch.
const M: f64 = 24.0;
const S: f64 = 0.14;
const I: f64 = 0.125;
const CH: f64 = 134.0;
const CA: f64 = 0.005;
const KH: f64 = 6000.0;
const KA: f64 = 24.0;
const STEP_S: f64 = 2.5e-4;

/// Rates of `[h, a, h', a']` with the downwash of the past that is not yet felt.
fn rates(x: [f64; 4], v: f64, missing: f64, stiffness: f64, moment: Moment<'_>) -> [f64; 4] {
    let [h, a, hd, ad] = x;
    let downwash = hd + v * a + B * (0.5 - A) * ad;
    let circulatory = 2.0 * PI * RHO * v * B * SPAN * (downwash - missing);
    let air = PI * RHO * B * B * SPAN;
    let force = -CH * hd - KH * h - circulatory - air * v * ad;
    let own = moment(a, ad, 0.5 * RHO * v * v);
    let turning =
        -CA * ad - KA * stiffness * a - own + B * (0.5 + A) * circulatory - air * v * B * (0.5 - A) * ad;
    let [m, s, i] = [M + air, S - air * B * A, I + air * B * B * (0.125 + A * A)];
    let determinant = m * i - s * s;
    [hd, ad, (i * force - s * turning) / determinant, (m * turning - s * force) / determinant]
}

/// A run: let go from an angle (rad), `settled_s` thrown away, then samples at 250 Hz.
pub(crate) fn run(day: u32, kind: Kind, v: f64, from: (f64, f64), length_s: f64, moment: Moment<'_>) -> Run {
    let (from_rad, settled_s) = from;
    let stiffness = 1.0 + 0.004 * (f64::from(day) - 2.0);
    let (mut x, mut deficiency) = ([0.0, from_rad, 0.0, 0.0], [0.0; 2]);
    let (mut heave_m, mut pitch_rad) = (Vec::new(), Vec::new());
    let downwash = |x: [f64; 4]| x[2] + v * x[1] + B * (0.5 - A) * x[3];
    let steps = |seconds: f64| (0..).take_while(move |k| f64::from(*k) * STEP_S < seconds);
    let settled = steps(settled_s).count();
    let mut noise = 0.1 + 0.8 * (37.7 * v + f64::from(day) * 0.3).fract();
    for k in 0..settled + steps(length_s).count() {
        if k >= settled && (k - settled).is_multiple_of(16) {
            // a logistic map: scatter without a library
            noise = 3.99 * noise * (1.0 - noise);
            heave_m.push(x[0] + 2e-5 * (noise - 0.5));
            pitch_rad.push(x[1] + 2e-4 * (noise - 0.5));
        }
        let missing = deficiency[0] + deficiency[1];
        let first = rates(x, v, missing, stiffness, moment);
        let ahead = std::array::from_fn(|i| x[i] + STEP_S * first[i]);
        let second = rates(ahead, v, missing, stiffness, moment);
        let next: [f64; 4] = std::array::from_fn(|i| x[i] + 0.5 * STEP_S * (first[i] + second[i]));
        let travelled = v * STEP_S / B;
        for (one, (a, b)) in deficiency.iter_mut().zip([(0.165, 0.0455), (0.335, 0.3)]) {
            let fade = f64::exp(-b * travelled);
            *one = *one * fade + LAG * a * (downwash(next) - downwash(x)) * fade.sqrt();
        }
        x = next;
    }
    let name = format!("{day}_{v}_{kind:?}");
    let (rho_kg_m3, step_s) = (RHO, 0.004);
    Run { name, day, kind, airspeed_m_s: v, rho_kg_m3, step_s, heave_m, pitch_rad, pitch_offset_rad: 0.0 }
}

/// Cycles at these airspeeds and what follows a blow at those, on two days.
pub(crate) fn campaign(cycles_m_s: &[f64], taps_m_s: &[f64], moment: Moment<'_>) -> Vec<Run> {
    let day = |day: u32| {
        let cycles = cycles_m_s.iter().map(move |v| run(day, Kind::Cycle, *v, (0.15, 40.0), 2.0, moment));
        let taps = taps_m_s.iter().map(move |v| run(day, Kind::Tap, *v, (0.012, 0.5), 7.0, moment));
        cycles.chain(taps)
    };
    (1..=2).flat_map(day).collect()
}
