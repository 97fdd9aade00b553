//! The blind benchmark, killed in the middle and started again: the verdicts of a run left alone, and no half-written file.
//! Minutes: with RUN_SLOW_TESTS=1 only.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use crate::segments::finished;
use serde_json::Value;

const CASES: usize = 4;

fn command(out: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command
        .args(["hidden", "--quiet", "--seed", "77", "--cases", &CASES.to_string(), "--out"])
        .arg(out)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."));
    command
}

/// All verdicts, or answers, that a folder keeps, but for the seconds.
fn verdicts(folder: &Path) -> BTreeMap<String, Value> {
    let timeless = |(hash, text): (String, String)| {
        let mut value: Value = serde_json::from_str(&text).expect("JSON");
        value["seconds"] = Value::Null;
        (hash, value)
    };
    finished(folder).into_iter().map(timeless).collect()
}

/// Where this file's results stand.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("hidden-killed")
}

/// The results of a run that is left alone, once for all tests.
pub(crate) fn whole() -> &'static Path {
    static WHOLE: OnceLock<PathBuf> = OnceLock::new();
    WHOLE.get_or_init(|| {
        let _ = std::fs::remove_dir_all(folder());
        std::fs::create_dir_all(folder()).expect("a folder of our own");
        let whole = folder().join("whole");
        let output = command(&whole).output().expect("the command starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        whole
    })
}

#[test]
fn a_killed_benchmark_goes_on_and_ends_with_the_same_verdicts() {
    if !crate::slow::runs("runs the blind benchmark twice, once killed") {
        return;
    }
    let (whole, stopped) = (whole(), folder().join("stopped"));
    let of = |out: &Path, ending: &str| out.with_extension(ending);
    let expected = verdicts(&of(whole, "cases").join("verdicts"));
    assert_eq!(expected.len(), CASES);

    // the bank's minute is not what is tested here
    let store: PathBuf = of(&stopped, "cases");
    std::fs::create_dir_all(&store).expect("a folder of our own");
    std::fs::copy(of(whole, "cases").join("null_distribution.ron"), store.join("null_distribution.ron"))
        .expect("a bank");
    let kept = store.join("verdicts");
    let mut child =
        command(&stopped).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("the command starts");
    let start = Instant::now();
    while verdicts(&kept).is_empty() && start.elapsed() < Duration::from_secs(600) {
        assert!(child.try_wait().expect("a child").is_none(), "it ended before its first verdict");
        std::thread::sleep(Duration::from_millis(50));
    }
    child.kill().expect("it can be killed");
    child.wait().expect("it is gone");
    let before = verdicts(&kept);
    assert!(!before.is_empty() && before.len() < CASES, "killed with {} verdicts", before.len());
    assert!(!stopped.exists(), "no results before the end");
    // what is there is whole, and as in the run left alone
    assert!(before.iter().all(|(name, verdict)| expected[name] == *verdict));

    let output = command(&stopped).output().expect("the command starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(verdicts(&kept), expected);
    assert_eq!(verdicts(&of(&stopped, "sealed")), verdicts(&of(whole, "sealed")));
    let metrics = |out: &Path| {
        let text = std::fs::read_to_string(out.join("result.json")).expect("a result");
        serde_json::from_str::<Value>(&text).expect("JSON")["confusion"].clone()
    };
    assert_eq!(metrics(&stopped), metrics(whole));
}
