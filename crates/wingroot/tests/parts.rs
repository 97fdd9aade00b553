//! A sweep in parts: any order, twice, at once, killed, dealt out anew: the bytes of one process; and what is refused.

mod segments;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use segments::finished;

const CASES: &str = r#"Cases(
    name: "a small grid",
    airspeeds_V_m_s: [25.7, 30.0, 37.0],
    load_factors: [-1.0, 2.0, 4.0],
    maneuvers: [
        Level, Pull, Roll(control: "outer", rates_deg_s: [30.0, 60.0, 90.0]), Turn(control: "outer"),
        Doublet(control: "middle", amplitude_deg: 5.0, frequency_hz: 5.0, duration_s: 0.5),
    ],
    stations: [(name: "half", y_m: 0.9)],
)
"#;
/// Variables by which schedulers say which share a process has.
const TOLD: [&str; 6] = [
    "WINGROOT_PARTS",
    "JOB_COMPLETION_INDEX",
    "SLURM_ARRAY_TASK_ID",
    "SLURM_ARRAY_TASK_COUNT",
    "SLURM_ARRAY_TASK_MIN",
    "SLURM_ARRAY_TASK_MAX",
];

/// A folder with the cases and the results.
struct Sweep(PathBuf);

impl Sweep {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-parts-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder of our own");
        std::fs::write(folder.join("cases.ron"), CASES).expect("a file of our own");
        Self(folder)
    }

    fn store(&self, out: &str) -> PathBuf {
        self.0.join(format!(".{out}.finished"))
    }

    /// A command on the sweep with results in `out`; the beam wing, whose aircraft is quickly assembled.
    fn command(&self, before: &[&str], out: &str, after: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(before).args([
            "fullaircraft",
            "--wing",
            "data/tuflex/wing_beam.ron",
            "--quiet",
            "--cases",
        ]);
        command.arg(self.0.join("cases.ron")).arg("--out").arg(self.0.join(out)).args(after);
        for name in TOLD {
            command.env_remove(name);
        }
        command.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."));
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    fn run(&self, before: &[&str], out: &str, after: &[&str]) -> Output {
        self.command(before, out, after).output().expect("the command starts")
    }

    fn finishes(&self, before: &[&str], out: &str, after: &[&str]) {
        let output = self.run(before, out, after);
        assert!(output.status.success(), "{after:?}: {}", String::from_utf8_lossy(&output.stderr));
    }

    /// A refusal's words.
    fn refused(&self, before: &[&str], out: &str, after: &[&str]) -> String {
        let output = self.run(before, out, after);
        assert_eq!(output.status.code(), Some(2), "{before:?} {after:?}");
        String::from_utf8_lossy(&output.stderr).into_owned()
    }

    fn files(&self, out: &str) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(self.0.join(out)).expect("a result folder").flatten();
        entries
            .map(|e| (e.file_name().to_string_lossy().into_owned(), std::fs::read(e.path()).expect("a file")))
            .collect()
    }
}

impl Drop for Sweep {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn ends(child: Child) {
    let output = child.wait_with_output().expect("a child");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn parts_in_any_order_twice_at_once_and_dealt_out_anew_merge_to_the_bytes_of_one_process() {
    let sweep = Sweep::new("order");
    sweep.finishes(&[], "whole", &[]);
    // the third of three twice at once, the first by an array's variables, and all of two after a change of mind
    let twice = [0, 1].map(|_| sweep.command(&[], "parts", &["--part", "3/3"]).spawn().expect("it starts"));
    twice.into_iter().for_each(ends);
    let array = [("ID", "10"), ("COUNT", "3"), ("MIN", "10"), ("MAX", "12")];
    let mut first = sweep.command(&[], "parts", &[]);
    first.envs(array.map(|(name, value)| (format!("SLURM_ARRAY_TASK_{name}"), value)));
    ends(first.spawn().expect("it starts"));
    let before = finished(&sweep.store("parts"));
    let mut pod = sweep.command(&[], "parts", &[]);
    pod.env("JOB_COMPLETION_INDEX", "1").env("WINGROOT_PARTS", "2");
    ends(pod.spawn().expect("it starts"));
    sweep.finishes(&[], "parts", &["--part=1/2"]);
    let after = finished(&sweep.store("parts"));
    assert!(before.iter().all(|(hash, result)| after.get(hash) == Some(result)), "nothing is lost");
    assert_eq!(after.len(), 2 * 3 * 18, "two models, three airspeeds, eighteen actions");

    sweep.finishes(&["merge"], "parts", &[]);
    assert_eq!(sweep.files("parts"), sweep.files("whole"));
    assert!(sweep.store("parts").exists() && !sweep.store("whole").exists());
}

#[test]
fn parts_killed_at_random_moments_lose_what_was_in_the_air_only() {
    let kills = if std::env::var_os("RUN_SLOW_TESTS").is_some() { 100 } else { 5 };
    let sweep = Sweep::new("kills");
    sweep.finishes(&[], "whole", &[]);
    let expected = sweep.files("whole");
    let mut kept = BTreeMap::new();
    for kill in 0..kills {
        // moments spread over the two seconds by steps of the golden section, and over all parts
        let moment = (f64::from(kill) * 0.618_034).fract() * 2.5;
        let part = format!("{}/4", kill % 4 + 1);
        let mut child = sweep
            .command(&[], "killed", &["--part", &part, "--threads", "1"])
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts");
        std::thread::sleep(Duration::from_secs_f64(moment));
        child.kill().expect("it can be killed");
        child.wait().expect("it is gone");
        let now = finished(&sweep.store("killed"));
        assert!(kept.iter().all(|(hash, result)| now.get(hash) == Some(result)), "kill {kill} lost a case");
        kept = now;
    }
    for part in ["2/4", "4/4", "1/4", "3/4"] {
        sweep.finishes(&[], "killed", &["--part", part]);
    }
    sweep.finishes(&["merge"], "killed", &[]);
    assert_eq!(sweep.files("killed"), expected);
}

#[test]
fn a_merge_names_what_is_missing_and_what_was_computed_with_other_inputs() {
    let sweep = Sweep::new("refused");
    sweep.finishes(&["prepare"], "out", &[]);
    sweep.finishes(&[], "out", &["--part", "2/3"]);
    let said = sweep.refused(&["merge"], "out", &[]);
    assert!(said.contains("cases are not finished") && said.contains("--part 1/3 "), "{said}");
    assert!(said.contains("--part 3/3 ") && !said.contains("--part 2/3 "), "{said}");

    // a case repeated alone, and one that nobody has
    let hash = finished(&sweep.store("out")).into_keys().next().expect("a case");
    let output = sweep.run(&[], "out", &["--case", &hash, "--json"]);
    assert!(String::from_utf8_lossy(&output.stdout).contains("\"maneuver\""));
    assert!(sweep.refused(&[], "out", &["--case", "0123456789abcdef"]).contains("no case of these"));
    assert!(sweep.refused(&[], "out", &["--part", "4/3"]).contains("K from 1 to N"));

    let status = sweep.run(&["status"], "out", &["--json"]);
    let status: serde_json::Value = serde_json::from_slice(&status.stdout).expect("JSON");
    assert_eq!((&status["cases"], &status["failures"]), (&108.into(), &serde_json::json!({})), "{status}");
    // 102 trims, then six motions of cost 70: the second third holds the middles of three
    assert_eq!(status["slowest"].as_array().map(Vec::len), Some(3), "{status}");

    let moved = CASES.replace("y_m: 0.9", "y_m: 0.8");
    std::fs::write(sweep.0.join("cases.ron"), moved).expect("our own file");
    let said = sweep.refused(&["merge"], "out", &[]);
    assert!(said.contains("another state of: stations") && said.contains(".segment"), "{said}");
}
