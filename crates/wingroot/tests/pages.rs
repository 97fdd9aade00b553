//! Pages of small runs, made here and used in a browser.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::browser::{Browser, looks, use_page};
use wingroot::report::page::{Block, Content, KeyNumber, Plate, Section};
use wingroot::report::{Figure, Page, Panel, Series, Style};

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
        looks::on_screens(&browser, page, &looks::SCREENS[1..]);
        looks::prints_whole(&browser, page);
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
fn figures_that_are_folded_up_are_printed_and_every_style_is_seen_in_the_dark() {
    let scratch = scratch("folded");
    let x: Vec<f64> = (0..50).map(f64::from).collect();
    let curve = |name: &str, shift: f64, style| {
        Series::new(name, x.clone(), x.iter().map(|x| (0.2 * x).sin() + shift).collect(), style)
    };
    let panel = |title: &str| {
        let series = vec![
            curve("noise", -0.5, Style::Edge),
            curve("noise", 0.5, Style::Edge),
            curve("measured", 0.0, Style::Line),
            curve("initial, with a name so long that it takes a row of the legend", 0.2, Style::DashedLine),
            curve("updated", 0.1, Style::Marked),
            curve("others", 0.3, Style::Points),
        ];
        Panel::new(title, "time (s)", "Fz (N)", series)
    };
    let plate = |name: &str, columns: usize, folded: bool| {
        let figure = Figure::new(name, (0..2 * columns).map(|i| panel(&format!("{i}"))).collect(), columns);
        let [name, title, caption] = [name; 3].map(str::to_owned);
        let content = Content::Curves(figure);
        Block::Plate(Box::new(Plate { name, title, caption, content, files: Vec::new(), folded }))
    };
    let blocks = vec![plate("open", 3, false), plate("folded", 2, true), plate("four", 4, true)];
    let page = Page {
        title: "Figures".into(),
        numbers: vec![KeyNumber::new("figures", "3", "")],
        sections: vec![Section::new("Figures", blocks)],
        ..Page::default()
    };
    let path = scratch.0.join("report.html");
    std::fs::write(&path, page.html().expect("a page")).expect("the temporary folder is writable");
    use_all(&[(path, true)]);
}

/// Those that no other test makes: the steps of the pipeline are opened where they are made (`pipeline.rs`).
#[test]
fn pages_of_every_other_command_do_so_too() {
    if !crate::slow::runs("makes and opens the pages of every command") {
        return;
    }
    let scratch = scratch("all-pages");
    let corrections = crate::pipeline::out().join("calibrate/corrections.ron");
    let corrections = corrections.to_str().expect("a path of ours is text");
    let common = ["calibrate", "--wing", "data/pazy/wing.ron", "--campaign", "data/pazy/tip_5deg"];
    let flutter = ["flutter", "--wing", "data/tuflex/wing.ron", "--corrections", corrections];
    use_all(&[
        (page_of(&scratch, "common", &common), true),
        (crate::hidden_killed::whole().join("report.html"), false),
        (page_of(&scratch, "response", &["response", "--data", "data/mav"]), true),
        (page_of(&scratch, "tunnel", &["tunnel", "--runs", "data/own_wing/made_with/tunnel.ron"]), false),
        (page_of(&scratch, "flutter", &flutter), true),
    ]);
}

#[test]
fn documents_link_to_each_other_and_show_their_pictures() {
    let scratch = scratch("docs");
    let list = page_of(&scratch, "docs", &["docs"]);
    let folder = list.parent().expect("a folder");
    let written = std::fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path());
    let pages: Vec<PathBuf> = written.filter(|path| path.extension().is_some_and(|e| e == "html")).collect();
    assert!(pages.len() > 5 && pages.contains(&folder.join("guide.html")), "{pages:?}");
    for page in &pages {
        let html = std::fs::read_to_string(page).expect("a page");
        let ends = |attribute: &str| {
            let starts: Vec<String> = html.split(attribute).skip(1).map(str::to_owned).collect();
            starts
                .into_iter()
                .map(|rest| rest.split('"').next().unwrap_or_default().to_owned())
                .collect::<Vec<_>>()
        };
        for to in ends(" href=\"").into_iter().chain(ends(" src=\"")) {
            let file = to.split('#').next().unwrap_or_default();
            let elsewhere = file.is_empty() || file.starts_with("https:") || file.starts_with("data:");
            assert!(elsewhere || folder.join(file).is_file(), "{}: {to} is not there", page.display());
        }
    }
    let Some(browser) = Browser::start() else { return };
    for page in &pages {
        looks::on_screens(&browser, page, &looks::SCREENS);
        let seen = "return Array.from(document.images).every(picture => picture.complete && picture.naturalWidth > 0)";
        assert_eq!(browser.script(seen), true, "{}: a picture is not shown", page.display());
        assert_eq!(browser.console_errors(), Vec::<String>::new(), "{}", page.display());
    }
}

#[test]
fn a_document_that_is_not_there_is_answered_with_the_list() {
    let run = |name: &str, out: &Path| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(["docs", name, "--out"]).arg(out).output().expect("the command starts")
    };
    let scratch = scratch("no-such-document");
    let refused = run("guidance", &scratch.0.join("docs"));
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("guide"), "the list of documents");
    assert!(!scratch.0.join("docs").exists(), "nothing is written");
    let found = run("guide", &scratch.0.join("docs"));
    assert!(String::from_utf8_lossy(&found.stdout).trim_end().ends_with("guide.html"));
}
