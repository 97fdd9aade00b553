//! What the fineness of campaigns leaves: root loads by pitch and ailerons beside those of a wing divided more finely.

use std::f64::consts::TAU;
use std::path::Path;
use truth::rig::{Coupled, Fineness, Rig};
use truth::setting::Setting;
use truth::wing::Wing;

fn loads(fineness: Fineness, f_hz: f64) -> nalgebra::DMatrix<nalgebra::Complex<f64>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
    let rig = Rig::divided(Wing::read(&path).expect("the shipped wing"), None, fineness);
    Coupled::new(&rig, Setting::drawn(0.02, 3), 22.0, 1.225).swing(TAU * f_hz)
}

#[test]
fn twice_as_fine_changes_the_root_loads_by_less_than_one_and_a_half_percent() {
    let c = Fineness::CAMPAIGN;
    for (name, finer) in [
        ("strips", Fineness { strips_per_m: 2.0 * c.strips_per_m, ..c }),
        ("rings", Fineness { chordwise: 24, ..c }),
        ("steps", Fineness { step_over_chord: 0.5 * c.step_over_chord, ..c }),
        ("slices and modes", Fineness { slices: 80, modes: 30, ..c }),
    ] {
        let pairs = [0.01, 4.0, 8.0].map(|f_hz| (f_hz, loads(c, f_hz), loads(finer, f_hz)));
        for motion in 0..4 {
            for channel in 0..3 {
                let place = (channel, motion);
                // near a minimum a small difference is a large share of nothing
                let most = pairs.iter().map(|(_, _, fine)| fine[place].norm()).fold(0.0, f64::max);
                for (f_hz, campaign, fine) in &pairs {
                    let off = (campaign[place] - fine[place]).norm() / most;
                    println!("{name}, {f_hz} Hz, motion {motion}, load {channel}: {:.2} %", 100.0 * off);
                    assert!(off < 0.015, "{name}, {f_hz} Hz, motion {motion}, load {channel}: {off}");
                }
            }
        }
    }
}
