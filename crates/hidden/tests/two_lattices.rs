//! The doublet lattice of the model beside the vortex lattice of the truth: one wing without effects, two programs that share no
//! line. Steady slopes, and amplitude and phase of the root loads over reduced frequency. Printed with `--nocapture`.

use aero::{Corrections, Flow};
use coupling::ElasticWing;
use maneuver::{Actuator, Rig, RigSettings};
use std::f64::consts::{PI, TAU};
use std::path::{Path, PathBuf};
use truth::rig::Coupled;
use truth::setting::Setting;

fn wing_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron")
}

const FREQUENCIES_HZ: [f64; 9] = [0.02, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0];
const CHANNELS: [&str; 3] = ["Fz", "Mx", "My"];

/// Frequencies at which a load is large enough beside its static value that a phase says something.
const SEEN: f64 = 0.3;

#[test]
fn a_swinging_wing_loads_its_root_alike_in_both_lattices() {
    let (file, wing) = ElasticWing::read(&wing_file()).expect("the shipped wing");
    let at_once = Actuator { frequency_hz: 1e5, damping_ratio: 0.8 };
    let settings =
        RigSettings { actuator: at_once, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
    let model = Rig::new(&wing, settings).expect("a rig");
    let neutral = Corrections::neutral(wing.correctable.len());
    let drawn = truth::wing::Wing::read(&wing_file()).expect("the shipped wing");
    let rig = truth::rig::Rig::new(drawn, None);
    let chord_m = rig.wing.planform.mean_chord_m();
    for v_m_s in [18.0, 30.0] {
        let flow = Flow { v_m_s, rho_kg_m3: 1.225 };
        let setting = Setting::drawn(file.damping_ratio, wing.controls.len());
        let coupled = Coupled::new(&rig, setting, v_m_s, 1.225);
        for (motion, name) in ["pitch", "inner", "middle", "outer"].iter().enumerate() {
            println!("\n{v_m_s} m/s, {name}: vortices beside doublets");
            println!("   f Hz       k      Fz              Mx              My");
            let mut at_rest = [0.0; 3];
            for f_hz in FREQUENCIES_HZ {
                let omega = TAU * f_hz;
                let doublets = model.at_frequency(flow, &neutral, omega).expect("a flow");
                let doublets = doublets.frequency_response(omega);
                let vortices = coupled.swing(omega);
                let mut line = format!("{f_hz:7.2} {:7.3}", PI * f_hz * chord_m / v_m_s);
                for (channel, load) in CHANNELS.iter().enumerate() {
                    let d = doublets[(channel, motion)];
                    let v = vortices[(channel, motion)];
                    let norm = d.re.hypot(d.im);
                    if at_rest[channel] == 0.0 {
                        at_rest[channel] = norm;
                    }
                    let share = v.re.hypot(v.im) / norm - 1.0;
                    let ahead = (v.im.atan2(v.re) - d.im.atan2(d.re) + 3.0 * PI).rem_euclid(TAU) - PI;
                    let degrees = ahead.to_degrees();
                    line += &format!("  {:+6.2} % {degrees:+6.2}", 100.0 * share);
                    let apart = (v.re - d.re).hypot(v.im - d.im) / at_rest[channel].max(norm);
                    assert!(motion > 0 || apart < 0.05, "{v_m_s} m/s, {name}, {f_hz} Hz, {load}: {apart}");
                }
                println!("{line}");
            }
        }
    }
    assert!(SEEN < 1.0);
}
