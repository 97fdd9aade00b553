//! `discover` on the shipped campaign with a fault in it. What it says of the campaign as it is: `pipeline.rs`.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Runs the command; exit status, standard error and the folder of results.
fn discover(name: &str, more: &[&str]) -> (Option<i32>, String, PathBuf) {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["discover", "--quiet", "--numbers-only", "--out"])
        .arg(&out)
        .args(["--wing", "data/tuflex/wing.ron"])
        .args(more)
        .current_dir(root())
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned(), out)
}

fn result(folder: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(folder.join("result.json")).unwrap()).unwrap()
}

/// A copy of the shipped campaign with one file changed.
fn changed(name: &str, file: &str, change: impl Fn(&str) -> String) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    for entry in std::fs::read_dir(root().join("data/tuflex/measured")).unwrap().flatten() {
        std::fs::copy(entry.path(), folder.join(entry.file_name())).unwrap();
    }
    let path = folder.join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, change(&text)).unwrap();
    folder
}

#[test]
fn a_channel_with_its_sign_flipped_is_a_defect_that_stops_the_search() {
    let flipped = changed("campaign-flipped", "doublet_inner_15_22.csv", |text| {
        let mut lines = text.lines();
        let header = lines.next().unwrap();
        let column = header.split(',').position(|name| name == "My_Nm").unwrap();
        let flip = |line: &str| {
            let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
            cells[column] = format!("{:.4}", -cells[column].parse::<f64>().unwrap());
            cells.join(",")
        };
        std::iter::once(header.to_owned()).chain(lines.map(flip)).collect::<Vec<_>>().join("\n")
    });
    let (status, said, out) = discover("discover-flipped", &["--campaign", flipped.to_str().unwrap()]);
    assert_eq!(status, Some(3), "{said}");
    assert!(said.contains("doublet_inner_15_22") && said.contains("My"), "{said}");
    // what there is of it stands beside the place of a good result
    assert!(!out.exists());
    let result = result(&out.with_extension("incomplete"));
    assert_eq!(result["verdict"], "data_defect");
    assert_eq!(result["effects"].as_array().unwrap().len(), 0);
}

#[test]
fn without_repeats_and_stated_noise_it_asks_for_the_noise() {
    let silent = changed("campaign-silent", "campaign.ron", |text| {
        let (start, end) = (text.find("    noise: Some((").unwrap(), text.find("    static_cases:").unwrap());
        let silent = format!("{}    noise: None,\n{}", &text[..start], &text[end..]);
        let without: Vec<String> = silent
            .lines()
            .map(|line| match line.find(", repeat_of: ") {
                Some(at) => format!("{}),", &line[..at]),
                None => line.to_owned(),
            })
            .collect();
        without.join("\n")
    });
    let (status, said, _) = discover("discover-silent", &["--campaign", silent.to_str().unwrap()]);
    assert_eq!(status, Some(2), "{said}");
    assert!(said.contains("the noise is not known") && said.contains("repeat_of"), "{said}");
}
