//! Pages: names from users stay text, everything is in the one file, pictures are the same as PNG.

use nalgebra::Point3;
use report::deformed::{self, Quad, View};
use report::page::{Block, Content, Input, KeyNumber, Link, Page, PageTable, Plate, Section};
use report::{Figure, Panel, PlanformView, Series, Style, heatmap};

const NASTY: &str = "<script>alert(1)</script> & \"wing\"";

fn figure() -> Figure {
    let t: Vec<f64> = (0..4000).map(|i| f64::from(i) * 0.005).collect();
    let wave = |phase: f64| {
        t.iter().map(|t| 12.0 * (3.0 * t + phase).sin() * (-0.1 * t).exp()).collect::<Vec<f64>>()
    };
    let panel = |label: &str| {
        Panel::new(
            "",
            "time (s)",
            label,
            vec![
                Series::new(NASTY, t.clone(), wave(0.0), Style::Line),
                Series::new("initial", t.clone(), wave(0.4), Style::DashedLine),
                Series::new("updated", t.clone(), wave(0.05), Style::Line),
            ],
        )
    };
    Figure::new(NASTY, ["Fz (N)", "Mx (N m)", "My (N m)"].map(panel).into(), 2)
}

fn views() -> Vec<View> {
    let quad = |i: u32, bend: f64| {
        let corner = |x: f64, y: f64| Point3::new(x, y, bend * y * y);
        let (left, right) = (0.1 * f64::from(i), 0.1 * f64::from(i + 1));
        Quad {
            corners: [corner(0.0, left), corner(0.2, left), corner(0.2, right), corner(0.0, right)],
            group: 0,
        }
    };
    let view = |title: &str, bend: f64| View {
        title: title.into(),
        groups: vec![NASTY.into()],
        quads: (0..15).map(|i| quad(i, bend)).collect(),
        lines: vec![[Point3::new(0.0, 0.0, 0.0), Point3::new(0.0, 1.5, 2.2 * bend)]],
        ..View::default()
    };
    vec![view("initial", 0.3), view("updated", 0.2)]
}

fn planform() -> PlanformView {
    let corner = |i: u32, j: u32| (f64::from(i) * 0.05, f64::from(j) * 0.1);
    let boxes = || (0..12).flat_map(|j| (0..4).map(move |i| (i, j)));
    PlanformView {
        corners: boxes()
            .map(|(i, j)| [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)])
            .collect(),
        values: boxes().map(|(i, j)| 1.0 + 0.02 * f64::from(j) - 0.03 * f64::from(i)).collect(),
        label: NASTY.into(),
        title: NASTY.into(),
        range: Some((0.75, 1.25)),
    }
}

fn page() -> Page {
    let plate = |name: &str, content: Content, folded: bool| {
        Block::Plate(Box::new(Plate {
            name: name.into(),
            title: NASTY.into(),
            caption: NASTY.into(),
            content,
            files: vec![format!("{name}.svg"), "a&b.csv".into()],
            folded,
        }))
    };
    let mut table = PageTable::new(NASTY, &["run", NASTY]);
    table.row([NASTY, "1.5"]);
    let drawing = deformed::draw("shapes", &views()).expect("drawn");
    let map = heatmap::draw(NASTY, &[planform()]).expect("drawn");
    Page {
        command: "calibrate".into(),
        title: NASTY.into(),
        around: vec![Link { text: NASTY.into(), to: "a\"b".into(), note: String::new() }],
        lead: vec![NASTY.into()],
        numbers: vec![KeyNumber::new(NASTY, "1.5 N", NASTY), KeyNumber::new("a", "b", "").judged(true)],
        sections: vec![
            Section::new(NASTY, vec![Block::Text(NASTY.into()), Block::Table(table)]),
            Section::new(
                "Figures",
                vec![
                    plate("curves", Content::Curves(figure()), false),
                    plate("map", Content::Pictures(vec![map]), false),
                    plate("shapes", Content::Shapes(views(), drawing), false),
                    plate("folded", Content::Curves(figure()), true),
                    Block::Links(vec![Link {
                        text: NASTY.into(),
                        to: "x\" onclick=\"y".into(),
                        note: NASTY.into(),
                    }]),
                ],
            ),
        ],
        inputs: vec![Input {
            what: "wing".into(),
            path: NASTY.into(),
            fingerprint: "0123456789abcdef".into(),
        }],
        run: vec![("Line".into(), NASTY.into())],
    }
}

#[test]
fn names_from_users_come_out_as_text_wherever_they_stand() {
    let html = page().html().expect("a page");
    assert!(!html.contains("<script>alert"), "a name became a script");
    assert!(!html.contains("alert(1)</script>"), "a name ended a script");
    assert!(html.contains("&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;wing&quot;"));
    assert!(!html.contains("onclick=\"y"), "an address left its attribute");
    assert!(html.contains("a&amp;b.csv"));
    // one script of plotly's, one of ours, and the data of three figures
    assert_eq!(html.matches("</script>").count(), 2 + 3);
    if let Some(folder) = std::env::var_os("KEEP_PAGES_IN") {
        std::fs::write(std::path::Path::new(&folder).join("sample.html"), &html).expect("kept for looking");
    }
}

#[test]
fn a_page_without_curves_carries_no_script() {
    let html = Page { title: "short".into(), ..Page::default() }.html().expect("a page");
    assert!(html.len() < 20_000 && !html.contains("<script"), "{}", html.len());
}

#[test]
fn pages_load_nothing_from_elsewhere() {
    let html = page().html().expect("a page");
    assert!(html.contains("Content-Security-Policy\" content=\"default-src &#39;none&#39;;"));
    for loading in ["<link rel=\"stylesheet\"", "<script src", "<img src=\"http", "@import", "url(http"] {
        let ours: String = html.split("<script type=\"text/javascript\">").next().unwrap_or_default().into();
        assert!(!ours.contains(loading), "{loading}");
    }
}

#[test]
fn the_same_page_is_written_with_the_same_bytes() {
    assert_eq!(page().html().expect("a page"), page().html().expect("a page"));
}

#[test]
fn every_kind_of_picture_is_also_a_png_of_its_size() {
    let pictures = [
        figure().draw().expect("drawn"),
        heatmap::draw("map", &[planform()]).expect("drawn"),
        deformed::draw("shapes", &views()).expect("drawn"),
    ];
    for (number, picture) in pictures.iter().enumerate() {
        let png = picture.png().expect("painted");
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        let side =
            |at: usize| f64::from(u32::from_be_bytes([png[at], png[at + 1], png[at + 2], png[at + 3]]));
        let svg = picture.svg();
        let document = roxmltree::Document::parse(&svg).expect("well-formed");
        let root = document.root_element();
        let of = |name: &str| root.attribute(name).and_then(|text| text.parse::<f64>().ok()).expect("a size");
        assert!((side(16) - 1.5 * of("width")).abs() <= 2.0, "width {} of {}", side(16), of("width"));
        assert!((side(20) - 1.5 * of("height")).abs() <= 2.0, "height {} of {}", side(20), of("height"));
        assert_eq!(png, picture.png().expect("painted"), "the same picture, the same bytes");
        if let Some(folder) = std::env::var_os("KEEP_PAGES_IN") {
            let path = std::path::Path::new(&folder).join(format!("picture_{number}.png"));
            std::fs::write(path, &png).expect("kept for looking");
        }
    }
}
