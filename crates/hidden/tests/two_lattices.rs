//! The doublet lattice of the model beside the vortex lattice of the truth: one wing without effects, two programs that share no
//! line. Steady slopes, and amplitude and phase of the root loads over reduced frequency. Printed with `--nocapture`.

use aero::{Corrections, Flow};
use coupling::ElasticWing;
use maneuver::{Actuator, Rig, RigSettings};
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use truth::rig::Coupled;
use truth::setting::Setting;

const FREQUENCIES_HZ: [f64; 9] = [0.02, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0];
const CHANNELS: [&str; 3] = ["Fz", "Mx", "My"];
/// Slow enough for a steady slope, Hz.
const SLOW_HZ: f64 = 0.002;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// Amplitude ratio less one, and phase in degrees, of `v` over `d`.
fn apart(v: [f64; 2], d: [f64; 2]) -> (f64, f64) {
    let ahead = (v[1].atan2(v[0]) - d[1].atan2(d[0]) + 3.0 * PI).rem_euclid(TAU) - PI;
    (v[0].hypot(v[1]) / d[0].hypot(d[1]) - 1.0, ahead.to_degrees())
}

/// Root loads by unit swings of pitch and ailerons, by channel and motion, from the model with a wing's file.
fn by_doublets(path: &Path, v_m_s: f64, frequencies_hz: &[f64]) -> Vec<[[[f64; 2]; 4]; 3]> {
    let (file, wing) = ElasticWing::read(path).expect("a wing");
    let at_once = Actuator { frequency_hz: 1e5, damping_ratio: 0.8 };
    let settings =
        RigSettings { actuator: at_once, ..RigSettings::new(file.damping_ratio, file.pitch_axis_x()) };
    let rig = Rig::new(&wing, settings).expect("a rig");
    let flow = Flow { v_m_s, rho_kg_m3: 1.225 };
    let neutral = Corrections::neutral(wing.correctable.len());
    let of = |f_hz: &f64| {
        let model = rig.at_frequency(flow, &neutral, TAU * f_hz).expect("a flow");
        let response = model.frequency_response(TAU * f_hz);
        let one =
            |channel: usize, motion: usize| [response[(channel, motion)].re, response[(channel, motion)].im];
        [0, 1, 2].map(|channel| [0, 1, 2, 3].map(|motion| one(channel, motion)))
    };
    frequencies_hz.iter().map(of).collect()
}

fn by_vortices(v_m_s: f64, frequencies_hz: &[f64]) -> Vec<[[[f64; 2]; 4]; 3]> {
    let drawn = truth::wing::Wing::read(&data("wing_beam.ron")).expect("the shipped wing");
    let rig = truth::rig::Rig::new(drawn, None);
    let coupled = Coupled::new(&rig, Setting::drawn(0.02, 3), v_m_s, 1.225);
    let of = |f_hz: &f64| {
        let response = coupled.swing(TAU * f_hz);
        let one =
            |channel: usize, motion: usize| [response[(channel, motion)].re, response[(channel, motion)].im];
        [0, 1, 2].map(|channel| [0, 1, 2, 3].map(|motion| one(channel, motion)))
    };
    frequencies_hz.iter().map(of).collect()
}

#[test]
fn a_swinging_wing_loads_its_root_alike_in_both_lattices() {
    for v_m_s in [18.0, 30.0] {
        let doublets = by_doublets(&data("wing_beam.ron"), v_m_s, &FREQUENCIES_HZ);
        let vortices = by_vortices(v_m_s, &FREQUENCIES_HZ);
        for (motion, name) in ["pitch", "inner", "middle", "outer"].iter().enumerate() {
            println!("\n{v_m_s} m/s, {name}: vortices beside doublets, % and degrees");
            println!("   f Hz       k   Fz              Mx              My");
            for (place, f_hz) in FREQUENCIES_HZ.iter().enumerate() {
                let mut line = format!("{f_hz:7.2} {:7.3}", PI * f_hz * 0.225 / v_m_s);
                for (channel, load) in CHANNELS.iter().enumerate() {
                    let (d, v) = (doublets[place][channel][motion], vortices[place][channel][motion]);
                    let (share, degrees) = apart(v, d);
                    let _ = write!(line, "  {:+6.2} % {degrees:+5.2}", 100.0 * share);
                    // ailerons: the model's boxes hinge a quarter of a box too far aft, see below
                    let (most, turned) = if motion == 0 { (0.02, 1.0) } else { (0.12, 3.0) };
                    assert!(share.abs() < most, "{v_m_s} m/s, {name}, {f_hz} Hz, {load}: {share}");
                    assert!(degrees.abs() < turned, "{v_m_s} m/s, {name}, {f_hz} Hz, {load}: {degrees}");
                }
                println!("{line}");
            }
        }
    }
}

/// Ailerons of boxes grow with the number of boxes along the chord, towards those of the vortex lattice, whose hinge is
/// in its place (thin sections are its test).
#[test]
fn ailerons_of_finer_boxes_go_to_those_of_vortices() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("finer_boxes");
    std::fs::create_dir_all(&folder).expect("a folder");
    for name in ["beam_distribution.csv", "e214.dat"] {
        std::fs::copy(data(name), folder.join(name)).expect("a copy");
    }
    let text = std::fs::read_to_string(data("wing_beam.ron")).expect("the wing");
    let vortices = by_vortices(18.0, &[SLOW_HZ]);
    let mut off = Vec::new();
    for boxes in [12, 24] {
        let finer = text
            .replace("chordwise: 12", &format!("chordwise: {boxes}"))
            .replace("chord_boxes: 3", &format!("chord_boxes: {}", boxes / 4));
        let path = folder.join(format!("wing_{boxes}.ron"));
        std::fs::write(&path, finer).expect("a file");
        let doublets = by_doublets(&path, 18.0, &[SLOW_HZ]);
        let shares = [1, 2, 3].map(|motion| apart(vortices[0][0][motion], doublets[0][0][motion]).0);
        println!("{boxes} boxes along the chord: lift of ailerons by vortices {shares:+.4?}");
        off.push(shares);
    }
    for (aileron, (coarse, fine)) in off[0].iter().zip(off[1]).enumerate() {
        // the error goes with the boxes' length; what is left in the limit is that of the strips, most at the outer end
        let limit = 2.0 * fine - coarse;
        println!("aileron {aileron}: {limit:+.4} left in the limit");
        assert!(fine.abs() < 0.75 * coarse.abs(), "aileron {aileron}: {coarse} {fine}");
        assert!(limit.abs() < 0.025, "aileron {aileron}: {limit}");
    }
}
