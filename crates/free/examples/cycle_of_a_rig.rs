//! The cycle of a section on a cubic pitch spring, by integration in time.

use std::io::Write as _;

use free::air::Strip;
use free::balance::Model;
use free::cycles::{FROM_RAD, aside, settle};
use free::effect::{Active, Effect};
use free::rig::LinearRig;
use free::section::{Section, Stream};

fn main() -> std::io::Result<()> {
    let section = Section {
        mass_kg: 28.0,
        unbalance_kgm: 0.115,
        inertia_kg_m2: 0.103,
        heave_stiffness_n_per_m: 7200.0,
        heave_damping_n_s_per_m: 166.0,
        pitch_stiffness_nm: 24.0,
        pitch_damping_nm_s: 0.001,
        strip: Strip { semichord_m: 0.15, axis: -0.46, lifting_span_m: 0.745, lag: 0.0 },
    };
    let rig = LinearRig { section, heave_gain: 1.0, heave_delay_s: 0.0 };
    let effects = vec![Active { effect: Effect::CubicPitch, values: vec![2900.0] }];
    let model = Model { rig, effects, centre_rad: 0.0, stiffness: 1.0, damping: 1.0 };
    let stream = Stream { rho_kg_m3: 1.186, v_m_s: 24.0 };
    let settled = settle(&model, stream, aside(FROM_RAD), 18.0);
    let mut out = std::io::stdout().lock();
    match settled.cycle {
        Some(cycle) => {
            writeln!(out, "{:.4} rad, {:.3} Hz", cycle.amplitude_rad, cycle.p.im / std::f64::consts::TAU)
        }
        None => writeln!(out, "no cycle"),
    }
}
