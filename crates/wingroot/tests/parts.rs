//! A sweep in parts: any order, twice, at once, killed, dealt out anew: the bytes of one process; and what is refused.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use crate::result_files::files;
use crate::segments::finished;

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
        Self::of(name, CASES)
    }

    fn of(name: &str, cases: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-parts-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder of our own");
        std::fs::write(folder.join("cases.ron"), cases).expect("a file of our own");
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

    /// What one of so many parts takes here if nobody kills it, s.
    fn part_s(&self, of: i32) -> f64 {
        self.finishes(&["prepare"], "timed", &[]);
        let start = Instant::now();
        self.finishes(&[], "timed", &["--part", &format!("1/{of}"), "--threads", "1"]);
        start.elapsed().as_secs_f64()
    }

    /// What one process writes; its page names the file of the cases, which is another in each test.
    fn whole(&self) -> BTreeMap<String, Vec<u8>> {
        self.finishes(&[], "whole", &[]);
        assert!(!self.store("whole").exists(), "what is finished is in the results");
        self.files("whole")
    }

    fn files(&self, out: &str) -> BTreeMap<String, Vec<u8>> {
        files(&self.0.join(out))
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
    assert!(sweep.files("parts") == sweep.whole(), "merged parts are not what one process writes");
    assert!(sweep.store("parts").exists());
}

/// Fingerprints of the results in a store by the hashes of their cases.
fn prints(store: &Path) -> BTreeMap<String, u64> {
    let print = |result: String| {
        let mut hasher = DefaultHasher::new();
        result.hash(&mut hasher);
        hasher.finish()
    };
    finished(store).into_iter().map(|(hash, result)| (hash, print(result))).collect()
}

/// Whole records of a store's segments, however often a case is there, and segments whose last record was cut.
fn records(store: &Path) -> [usize; 2] {
    let paths = std::fs::read_dir(store).expect("a store").flatten().map(|entry| entry.path());
    let segments = paths.filter(|path| path.extension().is_some_and(|ending| ending == "segment"));
    segments.fold([0, 0], |[whole, cut], path| {
        let text = std::fs::read_to_string(path).expect("a segment is text");
        let is_cut = !text.is_empty() && !text.ends_with('\n');
        [whole + text.matches('\n').count().saturating_sub(1), cut + usize::from(is_cut)]
    })
}

/// Waits for a part and gives the largest memory it had, bytes; zero where the system does not tell.
pub(crate) fn peak_bytes(mut child: Child) -> f64 {
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0.0;
    while child.try_wait().expect("a child").is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB"));
        peak = line.and_then(|kilobytes| kilobytes.parse::<f64>().ok()).map_or(peak, |now| 1024.0 * now);
        std::thread::sleep(Duration::from_millis(20));
    }
    ends(child);
    peak
}

#[test]
fn parts_killed_at_random_moments_lose_what_was_in_the_air_only() {
    let slow = crate::slow::runs("has a hundred thousand trims and a hundred kills");
    // two models, twenty airspeeds, so many rates of roll
    let (kills, parts, rates) = if slow { (100, 16, 2500) } else { (5, 4, 10) };
    let list = |values: Vec<f64>| values.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let airspeeds = list((0..20).map(|i| 22.0 + 0.9 * f64::from(i)).collect());
    let rates_deg_s = list((1..=rates).map(|i| 90.0 * f64::from(i) / f64::from(rates)).collect());
    let cases = format!(
        "Cases(name: \"rolls\", airspeeds_V_m_s: [{airspeeds}], load_factors: [0.0], \
         maneuvers: [Roll(control: \"outer\", rates_deg_s: [{rates_deg_s}])])"
    );
    let sweep = Sweep::of("kills", &cases);
    let expected = sweep.whole();
    // later ones would mostly find nothing in the air
    let within_s = 0.7 * sweep.part_s(parts);
    sweep.finishes(&["prepare"], "killed", &[]);
    let (mut kept, mut went_on) = (BTreeMap::new(), 0);
    for kill in 0..kills {
        // moments spread by steps of the golden section, parts out of order
        let moment_s = (f64::from(kill) * 0.618_034).fract() * within_s;
        let part = format!("{}/{parts}", kill * 7 % parts + 1);
        let mut child = sweep
            .command(&[], "killed", &["--part", &part, "--threads", "1"])
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts");
        std::thread::sleep(Duration::from_secs_f64(moment_s));
        child.kill().expect("it can be killed");
        child.wait().expect("it is gone");
        let now = prints(&sweep.store("killed"));
        assert!(kept.iter().all(|(hash, result)| now.get(hash) == Some(result)), "kill {kill} lost a case");
        went_on += usize::from(now.len() > kept.len());
        kept = now;
    }
    let [whole, cut] = records(&sweep.store("killed"));
    assert_eq!(whole, kept.len(), "one after the other, no part computes what another has finished");
    eprintln!(
        "{kills} kills: {} cases were finished, in {went_on} of the processes, and {cut} records cut: what was in the air",
        kept.len()
    );
    let mut peaks = Vec::new();
    // the last first, every third twice at once
    for number in (1..=parts).rev() {
        let part = format!("{number}/{parts}");
        let copies = if number % 3 == 0 { 2 } else { 1 };
        let running: Vec<Child> = (0..copies)
            .map(|_| sweep.command(&[], "killed", &["--part", &part]).spawn().expect("it starts"))
            .collect();
        for child in running {
            let peak = peak_bytes(child);
            assert!(peak < 1e9, "part {part} had {peak} bytes");
            peaks.push(peak);
        }
    }
    let most = peaks.into_iter().fold(0.0, f64::max);
    eprintln!("{:.0} MB at most of a part; {} records", most / 1e6, records(&sweep.store("killed"))[0]);
    assert_eq!(prints(&sweep.store("killed")).len(), 40 * usize::try_from(rates).expect("a number"));
    sweep.finishes(&["merge"], "killed", &[]);
    assert!(sweep.files("killed") == expected, "merged parts are not what one process writes");
}

#[test]
fn parts_take_what_prepare_left_and_compute_again_what_is_damaged() {
    let sweep = Sweep::new("shared");
    sweep.finishes(&["prepare"], "out", &[]);
    let shared = |name: &str| -> Vec<PathBuf> {
        let entries = std::fs::read_dir(sweep.store("out")).expect("a store").flatten().map(|e| e.path());
        let is_it = |path: &PathBuf| {
            let file = path.file_name().expect("a name").to_string_lossy();
            file.starts_with(name) && file.ends_with(".shared")
        };
        entries.filter(is_it).collect()
    };
    let names = ["corrections", "flexibility", "air"];
    let left: Vec<(PathBuf, Vec<u8>)> = names
        .iter()
        .map(|name| {
            let [path] = &shared(name)[..] else { panic!("one file of {name}") };
            (path.clone(), std::fs::read(path).expect("a file"))
        })
        .collect();
    // what a part says that it read is what prepare left: it says nothing of a calibration, and leaves the files as they are
    let said = |words: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        let output = command
            .args(["fullaircraft", "--wing", "data/tuflex/wing_beam.ron", "--cases"])
            .arg(sweep.0.join("cases.ron"))
            .arg("--out")
            .arg(sweep.0.join("out"))
            .args(words)
            .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
            .output()
            .expect("it starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let first = said(&["--part", "1/2"]);
    assert!(!first.contains("calibrated now") && !first.contains("damaged"), "{first}");
    for (path, bytes) in &left {
        let mut other = bytes.clone();
        let middle = other.len() / 2;
        other[middle] ^= 1;
        std::fs::write(path, other).expect("our own file");
    }
    let second = said(&["--part", "2/2"]);
    assert_eq!(second.matches("is damaged: what it holds is computed again").count(), 3, "{second}");
    assert!(second.contains("calibrated now"), "{second}");
    for (path, bytes) in &left {
        assert!(std::fs::read(path).is_ok_and(|now| now == *bytes), "{} is whole again", path.display());
    }
    sweep.finishes(&["merge"], "out", &[]);
    assert!(sweep.files("out") == sweep.whole(), "merged parts are not what one process writes");
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
