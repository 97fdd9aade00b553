//! Files of a rig: what is shipped is read whole, and what is wrong is said with its place.

use std::path::{Path, PathBuf};

use free::campaign::{self, Kind};
use free::rig::Rig;
use nastran::InputError;

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/bristol")
}

/// A folder with one run, of which a line of `runs.csv` and the samples are given.
fn folder(name: &str, line: &str, samples: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-free-{}-{name}", std::process::id()));
    std::fs::create_dir_all(folder.join("free")).expect("a folder");
    let header = "run,day,kind,airspeed_m_s,density_kg_m3,rate_Hz,pitch_offset_rad";
    std::fs::write(folder.join("runs.csv"), format!("{header}\n{line}\n")).expect("written");
    std::fs::write(folder.join("free/a.csv"), format!("heave_m,pitch_rad\n{samples}")).expect("written");
    folder
}

fn fault(name: &str, line: &str, samples: &str) -> InputError {
    let folder = folder(name, line, samples);
    let fault = campaign::read(&folder).expect_err("a fault");
    std::fs::remove_dir_all(folder).expect("removed");
    fault
}

#[test]
fn the_shipped_campaign_is_what_its_readme_says() {
    let runs = campaign::read(&data()).expect("the shipped runs");
    let of = |kind: Kind| runs.iter().filter(|run| run.kind == kind).count();
    assert_eq!((runs.len(), of(Kind::Cycle), of(Kind::Tap)), (178, 158, 20));
    let rig = Rig::read(&data().join("rig.ron")).expect("the shipped rig");
    let held = rig.held_out.of(&runs);
    assert!(runs.iter().zip(&held).all(|(run, held)| *held || run.day != 21), "21 September is held out");
}

#[test]
fn a_wrong_cell_is_named_with_its_line() {
    let samples = "0.0,0.0\n".repeat(200);
    let cases = [
        ("kind", "a,1,flight,20,1.2,250,0", "`flight` is no kind of run"),
        ("day", "a,x,tap,20,1.2,250,0", "`x` is no day"),
        ("airspeed", "a,1,tap,-20,1.2,250,0", "airspeed_m_s is -20"),
    ];
    for (name, line, message) in cases {
        let fault = fault(name, line, &samples);
        assert!(fault.message.contains(message), "{}", fault.message);
        assert_eq!(fault.span.expect("a place").line, 2);
    }
    assert!(fault("short", "a,1,tap,20,1.2,250,0", "0,0\n").message.contains("1 samples are too few"));
}

#[test]
fn a_rig_that_no_body_can_be_is_refused() {
    let text = std::fs::read_to_string(data().join("rig.ron")).expect("the shipped rig");
    let path = std::env::temp_dir().join(format!("wingroot-rig-{}.ron", std::process::id()));
    let refused = |from: &str, to: &str, message: &str| {
        assert!(text.contains(from), "{from}");
        std::fs::write(&path, text.replace(from, to)).expect("written");
        let fault = Rig::read(&path).expect_err("a fault");
        assert!(fault.message.contains(message), "{}", fault.message);
    };
    refused("unbalance_kgm: (value: 0.19", "unbalance_kgm: (value: 9.0", "no body has this mass");
    refused("mass_kg: (value: 16.9", "mass_kg: (value: 0.0", "mass_kg is 0");
    refused("heave_scales: [1.0, 0.1]", "heave_scales: []", "heave_scales needs one factor");
    std::fs::remove_file(path).expect("removed");
}
