//! `fullaircraft --cases`, killed in the middle and started again: the same files, byte for byte, as of a run left alone.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use crate::result_files::files;
use crate::segments::finished;

const CASES: &str = r#"Cases(
    name: "a small grid",
    airspeeds_V_m_s: [25.7, 30.0, 37.0],
    load_factors: [-1.0, 2.0, 4.0],
    maneuvers: [
        Level, Pull, Roll(control: "outer", rates_deg_s: [30.0]), Turn(control: "outer"),
        Chirp(control: "outer", amplitude_deg: 5.0, from_hz: 2.0, to_hz: 13.0, duration_s: 8.0),
        Chirp(control: "inner", amplitude_deg: 5.0, from_hz: 2.0, to_hz: 13.0, duration_s: 8.0),
        Doublet(control: "middle", amplitude_deg: 5.0, frequency_hz: 5.0, duration_s: 2.0),
    ],
    stations: [(name: "half", y_m: 0.9)],
)
"#;

/// The command on the beam wing with one thread, so that there is time to stop it.
fn command(cases: &Path, out: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command
        .args(["fullaircraft", "--wing", "data/tuflex/wing_beam.ron", "--threads", "1", "--cases"])
        .arg(cases)
        .arg("--out")
        .arg(out)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."));
    command
}

#[test]
fn a_killed_run_goes_on_and_ends_with_the_same_bytes() {
    let folder = std::env::temp_dir().join(format!("wingroot-cases-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    let (cases, whole, stopped) = (folder.join("cases.ron"), folder.join("whole"), folder.join("stopped"));
    std::fs::write(&cases, CASES).expect("a file of our own");

    let output = command(&cases, &whole).output().expect("the command starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let expected = files(&whole);
    let total = String::from_utf8_lossy(&expected["cases.csv"]).lines().count() - 1;
    assert!(expected.contains_key("envelope.csv") && expected.contains_key("envelope.svg"));
    let rolls = expected.keys().filter(|name| name.starts_with("station_loads/kind=roll/mass_kg="));
    assert_eq!(rolls.count(), 1, "one table of all rolls: {:?}", expected.keys());
    assert!(!folder.join(".whole.finished").exists(), "what is finished is in the results");

    let store = folder.join(".stopped.finished");
    let mut child = command(&cases, &stopped)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the command starts");
    let start = Instant::now();
    while finished(&store).len() < 3 {
        assert!(start.elapsed() < Duration::from_secs(300), "no case was finished");
        assert!(child.try_wait().expect("a child").is_none(), "it was done before it could be stopped");
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().expect("it was running");
    child.wait().expect("a child");
    let before = finished(&store).len();
    assert!((3..total).contains(&before), "{before} of {total} cases were finished");
    assert!(!stopped.join("result.json").exists(), "results are whole or not there");

    let output = command(&cases, &stopped).output().expect("the command starts");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.contains(&format!("{before} finished before")), "{text}");
    assert_eq!(files(&stopped), expected);
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
