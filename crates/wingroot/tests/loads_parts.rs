//! A plan of design loads in parts: any order, twice, killed, dealt out anew: the bytes of one process, cards and pages too.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use crate::draws::QUANTILE_95;
use crate::own_wing::OwnWing;
use crate::parts::peak_bytes;
use crate::result_files::files;
use crate::segments::{finished, told};

/// Balanced flight alone, which needs no unsteady air, in two states of loading.
const TRIMS: &str = r#"Cases(
    name: "corners and rolls",
    rules: Vla,
    design_speeds_EAS_m_s: (VA: 20.0, VC: 22.0, VD: 28.0),
    limit_load_factors: (n1: 3.8, n2: -1.5),
    altitudes_m: [0.0],
    masses: [(name: "all", mass_kg: 5.0), (name: "more", mass_kg: 6.0)],
    maneuvers: [Roll(control: "aileron", rates_deg_s: [20.0, 40.0])],
    gusts: [Pratt(at: [VC, VD])],
    gust_speeds: Some((U_de_VC_m_s: 4.0, U_de_VD_m_s: 2.0)),
)
"#;
/// All that moves beside them: a doublet, gusts that are searched between and gusts that are not, turbulence.
const MOVING: &str = r#"Cases(
    name: "all kinds",
    rules: Vla,
    design_speeds_EAS_m_s: (VA: 20.0, VC: 22.0, VD: 28.0),
    limit_load_factors: (n1: 3.8, n2: -1.5),
    altitudes_m: [0.0, 1000.0],
    masses: [(name: "all", mass_kg: 5.0), (name: "more", mass_kg: 6.0)],
    maneuvers: [
        Roll(control: "aileron", rates_deg_s: [20.0, 40.0]),
        Doublet(control: "aileron", amplitude_deg: 5.0, frequency_hz: 5.0, duration_s: 0.5),
    ],
    gusts: [
        Discrete(at: [VC], gradients_m: Of([2.0, 5.0, 12.0]), directions: [Up, Lateral], refine: true),
        Discrete(at: [VD], gradients_m: Of([2.0, 5.0, 12.0]), directions: [Up, Down]),
        Turbulence(at: [VC, VD], cut_off_hz: 20.0, directions: [Up, Lateral]),
    ],
    gust_speeds: Some((U_ref_m_s: 4.0, F_g: 1.0, U_sigma_ref_m_s: 3.0)),
)
"#;

/// A folder with a wing of one's own, its corrections and a plan.
struct Sweep(OwnWing);

impl Sweep {
    fn new(name: &str, plan: &str) -> Self {
        Self(OwnWing::calibrated_with(&format!("loads-parts-{name}"), "loads.ron", plan))
    }

    fn command(&self, before: &[&str], out: &str, after: &[&str]) -> Command {
        let mut command = self.0.command(&[before, &["loads", "--out", out], after].concat());
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

    fn store(&self, out: &str) -> PathBuf {
        self.0.path(&format!(".{out}.finished"))
    }

    /// Asserts that intervals of bending at the right root are those of envelopes of the ensemble's wings, by hand from the store.
    fn has_intervals_taken_draw_by_draw(&self, out: &str) {
        let read = |name: &str| self.0.read(&format!("{out}/{name}"));
        let table = read("station_loads.csv");
        let mut stations: Vec<&str> =
            table.lines().skip(1).filter_map(|line| line.split(',').nth(4)).collect();
        stations.dedup();
        let root = stations.iter().position(|name| *name == "right root").expect("a station");
        let stored = told(&self.store(out));
        // net is the last of five components, Mx the fourth of six loads
        let end = |flown: &str, sign: f64| {
            let own = stored.iter().filter(|(part, _)| part.starts_with(flown));
            let instants = own.flat_map(|(_, case)| case["instants"].as_array().expect("instants"));
            let all = instants.map(|one| sign * one["loads"][root][4][3].as_f64().expect("a load"));
            sign * all.fold(f64::NEG_INFINITY, f64::max)
        };
        let result: serde_json::Value = serde_json::from_str(&read("result.json")).expect("JSON");
        let envelope = result["envelope"].as_array().expect("an envelope");
        for (word, sign) in [("largest", 1.0), ("smallest", -1.0)] {
            let is_it = |e: &&serde_json::Value| {
                let is = |key: &str, word: &str| e[key] == word;
                is("model", "updated")
                    && is("station", "right root")
                    && is("load", "Mx_Nm")
                    && is("end", word)
            };
            let found = envelope.iter().find(is_it).expect("an end");
            let value = end("updated ", sign);
            let squares =
                (1..=8).map(|draw| (end(&format!("draw {draw} "), sign) - value).powi(2)).sum::<f64>();
            let half = QUANTILE_95 * (squares / 8.0).sqrt();
            let [low, high] = [0, 1].map(|end| found["interval_90"][end].as_f64().expect("an interval"));
            assert!(half > 1e-4 * value.abs(), "the wings differ: {half} of {value}");
            let off = (low - value + half).abs().max((high - value - half).abs());
            assert!(off < 1e-8 * (value.abs() + half), "{found} beside {value} and {half}");
        }
    }

    /// Results that differ from those of one process, by name.
    fn differing(&self, out: &str) -> Vec<String> {
        let [merged, whole] = [out, "whole"].map(|out| files(&self.0.path(out)));
        assert!(whole.keys().any(|name| name.ends_with("index.bdf")), "cards are compared, too");
        let names = whole.keys().chain(merged.keys().filter(|name| !whole.contains_key(*name)));
        names.filter(|name| whole.get(*name) != merged.get(*name)).cloned().collect()
    }
}

#[test]
fn parts_of_a_plan_have_each_case_once_and_a_merge_names_those_that_are_missing() {
    let sweep = Sweep::new("trims", TRIMS);
    let part = |part: &str| sweep.finishes(&[], "parts", &["--no-intervals", "--part", part]);
    part("3/3");
    let mut pod = sweep.command(&[], "parts", &["--no-intervals"]);
    let output = pod.env("JOB_COMPLETION_INDEX", "0").env("WINGROOT_PARTS", "3").output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = sweep.run(&["merge"], "parts", &["--no-intervals"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    let line = "loads --out parts --no-intervals --quiet --part 2/3 ";
    assert!(said.contains(line) && !said.contains("--part 1/3"), "{said}");
    let first = finished(&sweep.store("parts"));
    let output = sweep.run(&["status"], "parts", &["--no-intervals", "--json"]);
    let status: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(status["finished"], first.len(), "{status}");

    // after a change of mind: all of two parts, which find what the others did
    part("2/2");
    part("1/2");
    assert_eq!(status["cases"], told(&sweep.store("parts")).len(), "each case once: {status}");
}

#[test]
fn parts_of_a_plan_with_all_wings_of_the_ensemble_merge_to_the_bytes_of_one_process() {
    if !crate::slow::runs("flies a plan with nine wings, in one process and in parts") {
        return;
    }
    let sweep = Sweep::new("wings", TRIMS);
    sweep.finishes(&[], "whole", &[]);
    assert!(!sweep.store("whole").exists(), "what is finished is in the results");
    sweep.finishes(&["prepare"], "parts", &[]);
    sweep.finishes(&[], "parts", &["--part", "2/2"]);
    sweep.finishes(&[], "parts", &["--part", "1/2"]);
    let hash = finished(&sweep.store("parts")).into_keys().next().expect("a case");
    let output = sweep.run(&[], "parts", &["--case", &hash, "--json"]);
    let case: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert!(case["instants"].as_array().is_some_and(|all| !all.is_empty()), "{case}");
    sweep.finishes(&["merge"], "parts", &[]);
    assert_eq!(sweep.differing("parts"), Vec::<String>::new());
    assert!(sweep.store("parts").exists());
    sweep.has_intervals_taken_draw_by_draw("parts");
}

#[test]
fn parts_with_gusts_and_turbulence_that_are_killed_merge_to_the_bytes_of_one_process() {
    if !crate::slow::runs("flies a plan with gusts and turbulence in five parts, killed twenty times") {
        return;
    }
    let sweep = Sweep::new("moving", MOVING);
    let alone = ["--no-intervals"];
    sweep.finishes(&[], "whole", &alone);
    sweep.finishes(&["prepare"], "killed", &alone);
    let (mut kept, mut went_on) = (BTreeMap::new(), 0);
    for kill in 0..20 {
        let moment_s = (f64::from(kill) * 0.618_034).fract() * 5.0;
        let part = format!("{}/5", kill * 3 % 5 + 1);
        let mut killed = sweep.command(&[], "killed", &["--no-intervals", "--part", &part, "--threads", "1"]);
        let mut child = killed.stderr(Stdio::null()).spawn().expect("it starts");
        std::thread::sleep(Duration::from_secs_f64(moment_s));
        child.kill().expect("it can be killed");
        child.wait().expect("it is gone");
        let now = finished(&sweep.store("killed"));
        assert!(kept.iter().all(|(hash, result)| now.get(hash) == Some(result)), "kill {kill} lost a case");
        went_on += usize::from(now.len() > kept.len());
        kept = now;
    }
    eprintln!("{} cases were finished before the last kill, in {went_on} parts", kept.len());
    for number in [5, 2, 1, 3, 4] {
        let part = format!("{number}/5");
        let child =
            sweep.command(&[], "killed", &["--no-intervals", "--part", &part]).spawn().expect("it starts");
        let peak = peak_bytes(child);
        eprintln!("part {part}: {:.0} MB", peak / 1e6);
        assert!(peak < 1e9, "part {part} had {peak} bytes");
    }
    sweep.finishes(&["merge"], "killed", &alone);
    assert_eq!(sweep.differing("killed"), Vec::<String>::new());
}
