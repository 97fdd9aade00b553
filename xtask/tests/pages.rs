//! Pages of small runs, made here and used in a browser.

mod browser;

use std::path::{Path, PathBuf};
use std::process::Command;

use browser::{Browser, use_page};

/// A new folder for the test, removed at its end.
struct Scratch(PathBuf);

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Runs a command and returns its page.
fn page_of(scratch: &Scratch, name: &str, arguments: &[&str]) -> PathBuf {
    let out = scratch.0.join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(arguments)
        .args(["--quiet", "--out"])
        .arg(&out)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(".."))
        .output()
        .expect("the command starts");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let page = out.join("report.html");
    assert!(page.is_file(), "{name} writes no report.html");
    page
}

#[test]
fn pages_open_without_errors_and_curves_can_be_hidden_and_read() {
    let scratch = Scratch(std::env::temp_dir().join(format!("wingroot-pages-{}", std::process::id())));
    std::fs::create_dir_all(&scratch.0).expect("the temporary folder is writable");
    let calibrated = page_of(&scratch, "calibrate", &["calibrate"]);
    let corrections = calibrated.with_file_name("corrections.ron");
    let corrections = corrections.to_str().expect("a temporary path is text");
    let measured = "data/tuflex/measured";
    let runs = [format!("{measured}/aoa_2hz_30.csv"), format!("{measured}/doublet_inner_15_30.csv")];
    let flown = ["simulate", "--corrections", corrections, "--run", &runs[0], &runs[1]];
    let mut pages = vec![
        (calibrated.clone(), true),
        (
            page_of(
                &scratch,
                "common",
                &["calibrate", "--wing", "data/pazy/wing.ron", "--campaign", "data/pazy/tip_5deg"],
            ),
            true,
        ),
        (page_of(&scratch, "simulate", &flown), true),
        (page_of(&scratch, "modes", &["modes", "--wing", "data/tuflex/wing_beam.ron"]), true),
        (page_of(&scratch, "response", &["response"]), true),
        (page_of(&scratch, "validate", &["validate", "--only", "vlm"]), false),
    ];
    if std::env::var_os("RUN_SLOW_TESTS").is_some() {
        let of = |name: &'static str| page_of(&scratch, name, &[name, "--corrections", corrections]);
        pages.push((of("deflection"), true));
        pages.push((of("flutter"), true));
        pages.push((of("fullaircraft"), true));
    }
    for (page, _) in &pages {
        // every figure is there as SVG and PNG, and its curves as CSV; all that a page links to exists
        let html = std::fs::read_to_string(page).expect("a page");
        let ours = html.split("<script type=\"text/javascript\">").next().unwrap_or_default();
        let folder = page.parent().expect("a folder");
        let linked: Vec<&str> = ours
            .split("<a href=\"")
            .skip(1)
            .filter_map(|rest| rest.split('"').next())
            .filter(|to| !to.starts_with('#'))
            .collect();
        for file in &linked {
            assert!(folder.join(file).is_file(), "{}: {file} is not there", page.display());
        }
        let count = |ending: &str| linked.iter().filter(|file| file.ends_with(ending)).count();
        assert_eq!(count(".svg"), count(".png"), "{}", page.display());
    }
    let Some(browser) = Browser::start() else { return };
    for (page, with_curves) in &pages {
        use_page(&browser, page, *with_curves);
    }
}
