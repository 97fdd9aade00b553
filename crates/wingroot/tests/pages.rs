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
    let output = Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(arguments)
        .args(["--quiet", "--out"])
        .arg(&out)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    let page = out.join("report.html");
    assert!(page.is_file(), "{name} writes no report.html");
    page
}

/// The folder of a test's pages.
fn scratch(name: &str) -> Scratch {
    let scratch = Scratch(std::env::temp_dir().join(format!("wingroot-{name}-{}", std::process::id())));
    std::fs::create_dir_all(&scratch.0).expect("the temporary folder is writable");
    scratch
}

/// Every figure is there as SVG and PNG; all that a page links to exists.
fn look_beside(page: &Path) {
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

/// Looks at pages, with or without curves, and uses them where a browser is there.
fn use_all(pages: &[(PathBuf, bool)]) {
    for (page, _) in pages {
        look_beside(page);
    }
    let Some(browser) = Browser::start() else { return };
    for (page, with_curves) in pages {
        use_page(&browser, page, *with_curves);
    }
}

/// A measured file for `modes --measured`, with a name that a page must escape.
const MEASURED: &str = "Measured(modes: [(name: \"<b>first</b>\", frequency_hz: 4.4, sigma_hz: 0.02), \
    (frequency_hz: 19.6, sigma_hz: 0.1)], mass: (kg: 2.21, sigma_kg: 0.005), \
    regions: [(name: \"<i>all</i>\", y_m: (-1.0, 2.0), fit: [Stiffness])])";

#[test]
fn pages_of_a_beam_wing_open_without_errors_and_curves_can_be_hidden_and_read() {
    let scratch = scratch("pages");
    let beam = ["--wing", "data/tuflex/wing_beam.ron"];
    let measured = scratch.0.join("measured.ron");
    std::fs::write(&measured, MEASURED).expect("the temporary folder is writable");
    let measured = measured.to_str().expect("a temporary path is text");
    let fitted = page_of(&scratch, "fitted", &["modes", beam[0], beam[1], "--measured", measured]);
    let html = std::fs::read_to_string(&fitted).expect("a page");
    let escaped = html.contains("&lt;b&gt;first") && html.contains("&lt;i&gt;all");
    assert!(escaped && !html.contains("<b>first") && !html.contains("<i>all"), "names are texts");
    use_all(&[
        (page_of(&scratch, "modes", &["modes", beam[0], beam[1]]), true),
        (fitted, true),
        (page_of(&scratch, "deck", &["deck", beam[0], beam[1], "--hdf5"]), true),
        (
            page_of(&scratch, "trims", &["fullaircraft", "--deck", "data/published/decks/ha144a_fsw.bdf"]),
            false,
        ),
    ]);
}

#[test]
fn pages_of_every_other_command_do_so_too() {
    if std::env::var_os("RUN_SLOW_TESTS").is_none() {
        eprintln!("skipped: RUN_SLOW_TESTS=1 makes and opens the pages of every command");
        return;
    }
    let scratch = scratch("all-pages");
    let calibrated = page_of(&scratch, "calibrate", &["calibrate"]);
    let corrections = calibrated.with_file_name("corrections.ron");
    let corrections = corrections.to_str().expect("a temporary path is text");
    let measured = "data/tuflex/measured";
    let runs = [format!("{measured}/aoa_2hz_30.csv"), format!("{measured}/doublet_inner_15_30.csv")];
    let flown = ["simulate", "--corrections", corrections, "--run", &runs[0], &runs[1]];
    let common = ["calibrate", "--wing", "data/pazy/wing.ron", "--campaign", "data/pazy/tip_5deg"];
    let mut pages = vec![
        (calibrated.clone(), true),
        (page_of(&scratch, "common", &common), true),
        (page_of(&scratch, "simulate", &flown), true),
        (page_of(&scratch, "response", &["response"]), true),
        (page_of(&scratch, "validate", &["validate", "--only", "vlm"]), false),
        (page_of(&scratch, "tunnel", &["tunnel"]), false),
    ];
    for name in ["deflection", "flutter", "fullaircraft"] {
        pages.push((page_of(&scratch, name, &[name, "--corrections", corrections]), true));
    }
    use_all(&pages);
}
