//! Scripts and manifests for clusters: a sweep on a Slurm of one node (RUN_SLOW_TESTS, where Debian's slurm-wlm and munge are
//! installed), and the manifest against the published schemas of Kubernetes (where Python has kubernetes-validate).

use std::path::{Path, PathBuf};
use std::process::Command;

fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-cluster-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    folder
}

/// What `cluster` writes for a sweep of the beam wing.
fn written(folder: &Path, kind: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
    command.arg("cluster").args(kind);
    command.args(["fullaircraft", "--wing", "data/tuflex/wing_beam.ron", "--cases", "data/tuflex/cases.ron"]);
    let output = command.arg("--out").arg(folder.join("out")).current_dir(top()).output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn a_manifest_fits_the_published_schema_of_jobs_and_its_line_computes_a_part() {
    let folder = folder("kubernetes");
    let manifest = written(&folder, &["kubernetes", "--parts", "60", "--cpus", "2"]);
    // required in any Indexed Job, and what retries by index need
    for field in [
        "apiVersion: batch/v1",
        "kind: Job",
        "completionMode: Indexed",
        "completions: 60",
        "parallelism: 60",
        "backoffLimitPerIndex: 3",
        "restartPolicy: Never",
        "{name: WINGROOT_PARTS, value: \"60\"}",
    ] {
        assert!(manifest.contains(field), "no {field} in\n{manifest}");
    }
    let path = folder.join("sweep.yaml");
    std::fs::write(&path, &manifest).expect("our own file");
    let has = Command::new("python3").args(["-c", "import kubernetes_validate"]).output();
    if has.is_ok_and(|output| output.status.success()) {
        let output = Command::new("python3")
            .args(["-m", "kubernetes_validate", "--strict", "--kubernetes-version", "1.31"])
            .arg(&path)
            .output()
            .expect("it starts");
        let said =
            String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.matches("passed").count() == 3, "{said}\n{manifest}");
    } else {
        eprintln!("skipped: the schema of batch/v1 is not here (pip install kubernetes-validate)");
    }

    // the command line of the parts, as a pod runs it
    let command = manifest.lines().find(|line| line.contains("--threads")).expect("the line of the parts");
    let line = command.split('"').nth(1).expect("in quotes").replace("exec wingroot", "exec \"$0\"");
    let pod = |index: &str| {
        let mut shell = Command::new("sh");
        shell.arg("-c").arg(&line).arg(env!("CARGO_BIN_EXE_wingroot")).current_dir(top());
        let told = [("JOB_COMPLETION_INDEX", index), ("WINGROOT_PARTS", "60")];
        shell.envs(told).output().expect("the shell starts")
    };
    let output = pod("2");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && said.contains("part 3/60: "), "{line}: {said}");
    assert_eq!(pod("60").status.code(), Some(2), "there is no 61st of 60 parts");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}

#[test]
fn a_containerfile_builds_the_program() {
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot")).args(["cluster", "containerfile"]).output();
    let text = String::from_utf8(output.expect("it starts").stdout).expect("text");
    assert!(text.contains("cargo install --locked --path crates/wingroot"), "{text}");
}

#[test]
fn a_sweep_on_slurm_with_a_part_killed_and_queued_again_gives_the_bytes_of_one_process() {
    if !crate::slow::runs("runs a sweep on a Slurm of one node") {
        return;
    }
    let daemons = ["munged", "slurmctld", "slurmd"];
    if let Some(absent) = daemons.iter().find(|name| !Path::new("/usr/sbin").join(name).exists()) {
        eprintln!("skipped: no {absent} on this machine (apt-get install slurm-wlm munge)");
        return;
    }
    let folder = folder("slurm");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cluster/sweep_on_slurm.sh");
    let mut command = Command::new(script);
    command.arg(env!("CARGO_BIN_EXE_wingroot")).arg(&folder).current_dir(top());
    let output = command.output().expect("the script starts");
    let said =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    eprintln!("{said}");
    assert!(output.status.success() && said.contains("byte for byte"), "{said}");
    std::fs::remove_dir_all(&folder).expect("our own folder");
}
