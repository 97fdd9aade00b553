//! Every picture is a well-formed SVG document with what was put in, and what cannot be drawn is refused.
//!
//! `REPORT_PICTURES=DIR cargo test -p wingroot-report` writes the pictures for a look at them.

use nalgebra::Point3;
use report::deformed::{Quad, View};
use report::{DrawError, Figure, Panel, PlanformView, Series, Style};

/// Parses the document, optionally keeps it, and returns all its text.
fn text_of(name: &str, svg: &str) -> String {
    if let Some(folder) = std::env::var_os("REPORT_PICTURES") {
        std::fs::write(std::path::Path::new(&folder).join(name), svg)
            .expect("REPORT_PICTURES names a writable folder");
    }
    let document = roxmltree::Document::parse(svg).expect("the picture is well-formed XML");
    assert_eq!(document.root_element().tag_name().name(), "svg");
    document
        .descendants()
        .filter(roxmltree::Node::is_text)
        .filter_map(|n| n.text())
        .collect::<Vec<_>>()
        .join("|")
}

fn history(title: &str, y_label: &str, scale: f64) -> Panel {
    let t: Vec<f64> = (0..4000).map(|i| f64::from(i) * 0.001).collect();
    let wave = |gain: f64, lag: f64| {
        t.iter().map(|t| scale * gain * (12.0 * (t - lag)).sin() * (-t * 0.4).exp()).collect::<Vec<_>>()
    };
    let few: Vec<f64> = t.iter().copied().step_by(50).collect();
    let measured = wave(1.1, 0.02).into_iter().step_by(50).collect();
    Panel::new(
        title,
        "time (s)",
        y_label,
        vec![
            Series::new("measured", few, measured, Style::Points),
            Series::new("theory", t.clone(), wave(0.8, 0.0), Style::DashedLine),
            Series::new("corrected & <flown>", t.clone(), wave(1.08, 0.02), Style::Line),
        ],
    )
}

fn planform(title: &str, offset: f64) -> PlanformView {
    let (chordwise, spanwise) = (12_u32, 40_u32);
    let mut corners = Vec::new();
    let mut values = Vec::new();
    for j in 0..spanwise {
        for i in 0..chordwise {
            let point = |i: u32, j: u32| {
                let eta = f64::from(j) / f64::from(spanwise);
                let chord = 0.30 - 0.15 * eta;
                (0.2 * eta + chord * f64::from(i) / f64::from(chordwise), 1.6 * eta)
            };
            corners.push([point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)]);
            values.push(offset + 0.2 * (f64::from(j) * 0.15).sin() * (1.0 - f64::from(i) / 12.0));
        }
    }
    PlanformView { corners, values, label: "force factor (-)".into(), title: title.into(), range: None }
}

/// A swept wing on both sides, bent upwards, and a tail.
fn aircraft(title: &str, bend: f64) -> View {
    let mut quads = Vec::new();
    let mut surface = |group: usize, x0: f64, span: f64, chord: f64, bend: f64| {
        for side in [-1.0, 1.0] {
            for j in 0..20 {
                for i in 0..6 {
                    let point = |i: i32, j: i32| {
                        let eta = f64::from(j) / 20.0;
                        let c = chord * (1.0 - 0.5 * eta);
                        let x = x0 + 0.3 * eta * span + c * f64::from(i) / 6.0;
                        Point3::new(x, side * eta * span, bend * eta * eta)
                    };
                    let corners = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
                    quads.push(Quad { corners, group });
                }
            }
        }
    };
    surface(0, 0.0, 1.6, 0.3, bend);
    surface(1, 1.2, 0.4, 0.18, 0.0);
    View { title: title.into(), groups: vec!["wing".into(), "tail".into()], quads, ..View::default() }
}

#[test]
fn a_figure_has_its_labels_and_one_legend() {
    let panels =
        vec![history("", "Fz (N)", 20.0), history("", "Mx (N m)", 3.5), history("", "My (N m)", 0.004)];
    let stacked = Figure::new("Pitch at 2 Hz, 30 m/s", panels.clone(), 1);
    let text = text_of("stacked.svg", &stacked.svg().unwrap());
    for label in ["Fz (N)", "Mx (N m)", "time (s)", "Pitch at 2 Hz, 30 m/s"] {
        assert!(text.contains(label), "{label} in {text}");
    }
    assert_eq!(text.matches("corrected & <flown>").count(), 1);
    let mut five = panels.clone();
    five.extend(panels.into_iter().take(2));
    let grid = Figure::new("Five panels in two columns", five, 2);
    assert_eq!(text_of("grid.svg", &grid.svg().unwrap()).matches("time (s)").count(), 5);
}

/// Ticks of a narrow range about it would run into the label.
#[test]
fn a_level_line_has_short_ticks() {
    for (level, ticks) in [(0.0, ["-1", "-0.5", "0.5"]), (40.0, ["20", "40", "60"])] {
        let series = Series::new("y", vec![0.0, 1.0], vec![level; 2], Style::Line);
        let panel = Panel::new("", "t (s)", "displacement y (m)", vec![series]);
        let drawn = Figure::new("", vec![panel], 1).svg().expect("a line");
        let text = text_of("level.svg", &drawn);
        let found: Vec<&str> = text.split('|').collect();
        assert!(ticks.iter().all(|tick| found.contains(tick)), "{level}: {text}");
    }
}

#[test]
fn a_single_series_and_a_constant_are_drawn() {
    let line = Series::new("only", vec![0.0, 1.0], vec![2.5, 2.5], Style::Line);
    let panel = Panel::new("constant", "x (m)", "y (m)", vec![line]);
    let figure = Figure::new("One", vec![panel], 3);
    assert!(text_of("single.svg", &figure.svg().unwrap()).contains("constant"));
}

#[test]
fn planforms_stand_side_by_side_with_a_polygon_per_box() {
    let mut views = vec![planform("22 m/s", 0.9), planform("30 m/s", 1.05)];
    views[1].values[7] = f64::NAN;
    let svg = report::heatmap::draw("Force factors", &views).unwrap().svg();
    assert_eq!(svg.matches("<polygon").count(), 2 * 480);
    assert!(text_of("heatmap.svg", &svg).contains("force factor (-)"));
    let mut constant = planform("neutral", 1.0);
    constant.values.fill(1.0);
    text_of("heatmap_constant.svg", &report::heatmap::draw("Neutral", &[constant]).unwrap().svg());
}

#[test]
fn deformed_aircraft_stand_side_by_side() {
    let svg = report::deformed::draw("Pull-up", &[aircraft("initial", 0.3), aircraft("updated", 0.45)])
        .unwrap()
        .svg();
    assert_eq!(svg.matches("<polygon").count(), 2 * 2 * 240);
    assert!(text_of("deformed.svg", &svg).contains("updated"));
}

/// A structure of one line, straight up in the picture: it has no width there.
#[test]
fn one_upright_line_is_drawn() {
    let lines = vec![[nalgebra::Point3::origin(), nalgebra::Point3::new(0.0, 0.0, 10.0)]];
    let view = View {
        title: "mast".into(),
        groups: vec!["structure".into()],
        quads: Vec::new(),
        lines,
        waits: false,
    };
    let svg = report::deformed::draw("Mast", std::slice::from_ref(&view)).unwrap().svg();
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "every place is a number");
    assert!(text_of("mast.svg", &svg).contains("mast"));
}

#[test]
fn what_cannot_be_drawn_is_refused_with_its_name() {
    let empty = Figure::new("nothing", vec![], 1);
    assert_eq!(empty.svg(), Err(DrawError::Empty("nothing".into())));
    let mut uneven = history("", "Fz (N)", 1.0);
    uneven.series[1].y.pop();
    let figure = Figure::new("", vec![uneven], 1);
    let expected = DrawError::Lengths { what: "theory".into(), first: 4000, second: 3999 };
    assert_eq!(figure.svg(), Err(expected.clone()));
    assert_eq!(expected.to_string(), "'theory' cannot be drawn: 4000 places but 3999 values");
    let mut view = planform("short", 1.0);
    view.values.pop();
    assert!(matches!(report::heatmap::draw("", &[view]), Err(DrawError::Lengths { .. })));
    assert!(report::deformed::draw("", &[]).is_err());
}
