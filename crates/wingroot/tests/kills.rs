//! Commands killed at random moments and started again: nothing that was finished is lost, nothing of the user's is touched, and
//! the end is that of a run left alone. A hundred kills with RUN_SLOW_TESTS=1, a few of the quick commands otherwise.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::segments::finished;

const THESIS: &str = "years of work";
const CASES: &str = r#"Cases(
    name: "a small grid",
    airspeeds_V_m_s: [16.0, 18.0, 20.0, 22.0, 24.0],
    load_factors: [-1.0, 1.5, 2.5],
    maneuvers: [Level, Pull, Roll(control: "aileron", rates_deg_s: [30.0]), Turn(control: "aileron")],
)
"#;

const LOADS: &str = r#"Cases(
    name: "a small plan",
    rules: Vla,
    design_speeds_EAS_m_s: (VA: 20.0, VC: 22.0, VD: 28.0),
    limit_load_factors: (n1: 3.8, n2: -1.5),
    altitudes_m: [0.0, 1000.0],
    masses: [(name: "all", mass_kg: 5.0), (name: "more", mass_kg: 6.0)],
    maneuvers: [],
    gusts: [
        Discrete(at: [VC, VD], gradients_m: Of([2.0, 5.0, 12.0]), directions: [Up, Down], refine: true),
        Turbulence(at: [VC, VD], cut_off_hz: 20.0),
    ],
    gust_speeds: Some((U_ref_m_s: 4.0, F_g: 1.0, U_sigma_ref_m_s: 3.0)),
)
"#;

/// A command under test.
struct Victim {
    /// Its line.
    arguments: &'static [&'static str],
    /// The folder below which finished parts are kept, if it keeps any.
    store: Option<&'static str>,
    /// It is killed within this time.
    within_s: f64,
    /// So many kills, and so many of a quick test.
    kills: [usize; 2],
    /// The folder of its results.
    out: &'static str,
}

const VICTIMS: [Victim; 4] = [
    Victim { arguments: &["calibrate"], store: None, within_s: 0.8, kills: [35, 8], out: "out/calibrate" },
    Victim {
        arguments: &["fullaircraft", "--cases", "cases.ron", "--threads", "1"],
        store: Some("out/.fullaircraft_cases.finished"),
        within_s: 1.5,
        kills: [30, 8],
        out: "out/fullaircraft_cases",
    },
    Victim {
        arguments: &["discover"],
        store: Some("out/.discover.finished"),
        within_s: 4.0,
        kills: [20, 0],
        out: "out/discover",
    },
    Victim {
        arguments: &["hidden", "--cases", "2", "--seed", "77"],
        store: Some("out/hidden.cases"),
        within_s: 12.0,
        kills: [15, 0],
        out: "out/hidden",
    },
];

/// A plan of design loads.
const PLAN: Victim = Victim {
    arguments: &["loads", "--plan", "loads.ron", "--threads", "1"],
    store: Some("out/.loads.finished"),
    within_s: 6.0,
    kills: [20, 0],
    out: "out/loads",
};

/// A generator of moments; which they are does not matter.
struct Moments(u64);

impl Moments {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }
}

fn wingroot(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.args(arguments).arg("--quiet").current_dir(folder).stdout(Stdio::null()).stderr(Stdio::piped());
    command
}

fn finishes(folder: &Path, arguments: &[&str]) {
    let output = wingroot(folder, arguments).output().expect("the command starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// Finished cases of a store and of those below it, each whole: their results by folder and hash.
fn parts(folder: &Path) -> BTreeMap<PathBuf, String> {
    let of_folder = finished(folder).into_iter().map(|(hash, result)| (folder.join(hash), result));
    let mut found: BTreeMap<PathBuf, String> = of_folder.collect();
    let below = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    below.filter(|path| path.is_dir()).for_each(|path| found.extend(parts(&path)));
    found
}

/// What a result says, but for what the clock says, and for whether the null distribution was left by an earlier run.
fn result(out: &Path) -> serde_json::Value {
    let text = std::fs::read_to_string(out.join("result.json")).expect("a result");
    let mut value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let object = value.as_object_mut().expect("an object");
    for of_the_day in ["seconds", "metrics", "gates", "null_distribution"] {
        object.remove(of_the_day);
    }
    value
}

/// A folder with a wing of one's own, twice: one in which commands are killed, and one in which they are left alone.
fn folders(name: &str) -> (PathBuf, PathBuf, PathBuf) {
    let base = std::env::temp_dir().join(format!("wingroot-kills-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&base).expect("a temporary folder");
    finishes(&base, &["new", "alone"]);
    finishes(&base, &["new", "killed"]);
    let (alone, killed) = (base.join("alone"), base.join("killed"));
    for folder in [&alone, &killed] {
        std::fs::write(folder.join("cases.ron"), CASES).expect("a file");
        std::fs::write(folder.join("loads.ron"), LOADS).expect("a file");
        std::fs::create_dir(folder.join("out")).expect("a folder");
        std::fs::write(folder.join("out/thesis.txt"), THESIS).expect("a file");
    }
    (base, alone, killed)
}

/// Kills commands so often and starts them again.
fn survive(name: &str, victims: &[Victim], kills: impl Fn(&Victim) -> usize) {
    let (base, alone, killed) = folders(name);
    let mut moments = Moments(20_261_122);
    for victim in victims {
        let kills = kills(victim);
        if kills == 0 {
            continue;
        }
        finishes(&alone, victim.arguments);
        let store = victim.store.map(|store| killed.join(store));
        let mut kept = BTreeMap::new();
        for _ in 0..kills {
            let mut child = wingroot(&killed, victim.arguments).spawn().expect("the command starts");
            std::thread::sleep(Duration::from_secs_f64(victim.within_s * moments.next()));
            let ended = child.try_wait().expect("a child").is_some();
            child.kill().expect("it can be killed");
            child.wait().expect("it is gone");
            let now = store.as_deref().map(parts).unwrap_or_default();
            // A store is emptied when its parts are in the results, or in the null distribution that they were for.
            if !ended && !now.is_empty() {
                // null campaigns go one by one when the distribution that they were for is written
                let is_in_it = |path: &PathBuf| {
                    path.ancestors()
                        .nth(2)
                        .is_some_and(|folder| folder.join("null_distribution.ron").is_file())
                };
                let is_lost = |path: &PathBuf, text: &String| now.get(path) != Some(text) && !is_in_it(path);
                let lost = kept.iter().find(|&(path, text)| is_lost(path, text));
                let emptied = kept.keys().all(|path| !now.contains_key(path));
                assert!(lost.is_none() || emptied, "{:?}: {lost:?} is lost", victim.arguments);
            }
            kept = now;
            let thesis = std::fs::read_to_string(killed.join("out/thesis.txt")).expect("it is there");
            assert_eq!(thesis, THESIS);
        }
        finishes(&killed, victim.arguments);
        assert_eq!(
            result(&killed.join(victim.out)),
            result(&alone.join(victim.out)),
            "{:?}",
            victim.arguments
        );
    }
    std::fs::remove_dir_all(&base).expect("a temporary folder");
}

#[test]
fn a_file_in_the_result_folder_stops_every_command_and_stays() {
    let base = std::env::temp_dir().join(format!("wingroot-thesis-{}", std::process::id()));
    std::fs::create_dir_all(&base).expect("a temporary folder");
    finishes(&base, &["new", "w"]);
    let folder = base.join("w");
    std::fs::write(folder.join("cases.ron"), CASES).expect("a file");
    std::fs::write(folder.join("loads.ron"), LOADS).expect("a file");
    for victim in &VICTIMS {
        let out = folder.join(victim.out);
        std::fs::create_dir_all(&out).expect("a folder");
        for (name, text) in [("result.json", "{}"), ("thesis.txt", THESIS)] {
            std::fs::write(out.join(name), text).expect("a file");
        }
        let output = wingroot(&folder, victim.arguments).output().expect("the command starts");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{:?}: {said}", victim.arguments);
        assert!(said.contains("nothing in it is replaced") && said.contains("hint: "), "{said}");
        assert_eq!(std::fs::read_to_string(out.join("thesis.txt")).expect("it is there"), THESIS);
    }
    std::fs::remove_dir_all(&base).expect("a temporary folder");
}

#[test]
fn nothing_is_lost_at_any_moment() {
    let slow = crate::slow::runs("kills a hundred commands, discover and hidden among them");
    survive("all", &VICTIMS, |victim| victim.kills[usize::from(!slow)]);
}

#[test]
fn a_plan_of_design_loads_killed_at_twenty_moments_goes_on_from_its_finished_cases_to_the_same_end() {
    if !crate::slow::runs("kills a plan of design loads twenty times") {
        return;
    }
    survive("plan", &[PLAN], |victim| victim.kills[0]);
}
