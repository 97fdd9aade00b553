//! A [`Figure`] as plotly's data: the same panels and colours as the still picture, to zoom, hover over and hide.
//!
//! Abscissae are written once for all curves of a panel that share them; `page.js` puts them back. Names and labels are
//! escaped once more, as plotly reads some HTML in texts.

use serde_json::{Value, json};

use crate::error::DrawError;
use crate::escape::for_plotly;
use crate::figure::{BAND, Figure, MARKERS, Panel, Series, Style};
use crate::palette;
use crate::thin::{kept_together, rounded};

/// The figure for `page.js`, which knows how wide the window is and so lays the panels out: abscissae, traces, labels; at
/// most about `limit` points a curve.
pub(super) fn data(figure: &Figure, limit: usize) -> Result<Value, DrawError> {
    let names = figure.names();
    let colours = palette::of_names(&names);
    let mut shared: Vec<Value> = Vec::new();
    let mut traces = Vec::new();
    let mut shown: Vec<&str> = Vec::new();
    for (place, panel) in figure.panels.iter().enumerate() {
        let mut lower = false;
        for group in groups(panel)? {
            let ys: Vec<&[f64]> = group.iter().map(|series| series.y.as_slice()).collect();
            let kept = kept_together(&group[0].x, &ys, limit);
            let pick = |values: &[f64]| kept.iter().map(|&i| number(values[i])).collect::<Vec<Value>>();
            for series in &group {
                lower = series.style == Style::Edge && !lower;
                let first = !lower && !shown.contains(&series.name.as_str());
                if first {
                    shown.push(&series.name);
                }
                let number = names.iter().position(|name| *name == series.name).unwrap_or(0);
                let mut trace = look(series.style, colours[number], number);
                if lower {
                    trace["fill"] = json!("none");
                }
                trace["showlegend"] = json!(first);
                trace["x"] = json!(shared.len());
                trace["y"] = json!(pick(&series.y));
                describe(&mut trace, series, panel, place);
                traces.push(trace);
            }
            shared.push(json!(pick(&group[0].x)));
        }
    }
    let panels: Vec<Value> = figure.panels.iter().map(labels).collect();
    Ok(json!({ "x": shared, "traces": traces, "panels": panels, "columns": columns(figure) }))
}

/// Series of a panel that share their abscissae, in order.
fn groups(panel: &Panel) -> Result<Vec<Vec<&Series>>, DrawError> {
    let mut groups: Vec<Vec<&Series>> = Vec::new();
    for series in &panel.series {
        DrawError::check_lengths(&series.name, series.x.len(), series.y.len())?;
        match groups.last_mut() {
            Some(group) if group[0].x == series.x => group.push(series),
            _ => groups.push(vec![series]),
        }
    }
    Ok(groups)
}

/// Name, axes and what the pointer reads.
fn describe(trace: &mut Value, series: &Series, panel: &Panel, place: usize) {
    let name = for_plotly(&series.name);
    trace["legendgroup"] = json!(name);
    trace["name"] = json!(name);
    trace["xaxis"] = json!(axis_name("x", place));
    trace["yaxis"] = json!(axis_name("y", place));
    trace["hovertemplate"] = json!(hover(panel));
}

/// Line, markers and fill of a curve.
fn look(style: Style, colour: &str, number: usize) -> Value {
    let line = |dash: &str, width: f64| json!({ "color": colour, "width": width, "dash": dash });
    let mut look = match style {
        Style::Line => json!({ "mode": "lines", "line": line("solid", 1.7) }),
        Style::DashedLine => json!({ "mode": "lines", "line": line("6px,4px", 1.7) }),
        Style::Points => json!({ "mode": "markers", "marker": { "color": colour, "size": 6 } }),
        Style::Marked => json!({
            "mode": "lines+markers", "line": line("solid", 1.4),
            "marker": { "color": colour, "size": 8, "symbol": MARKERS[number % MARKERS.len()].1 },
        }),
        // down to the edge below it
        Style::Edge => json!({
            "mode": "lines", "line": line("solid", 0.0), "fill": "tonexty",
            "fillcolor": format!("{colour}{BAND:02x}"),
        }),
    };
    look["type"] = json!("scatter");
    look
}

/// `12.3 N` beside the curve's name, and the abscissa with its unit.
fn hover(panel: &Panel) -> String {
    let with_unit = |label: &str, letter: &str| {
        let (quantity, unit) = split_unit(label);
        let text = |text: &str| for_plotly(text).replace("%{", "% {");
        (text(quantity), format!("%{{{letter}:.5~g}} {}", text(unit)).trim_end().to_owned())
    };
    let (x_name, x) = with_unit(&panel.x_label, "x");
    let (y_name, y) = with_unit(&panel.y_label, "y");
    format!("{y_name} = {y}<br>{x_name} = {x}")
}

/// `Fz (N)` as `Fz` and `N`.
fn split_unit(label: &str) -> (&str, &str) {
    label
        .strip_suffix(')')
        .and_then(|label| label.rsplit_once(" ("))
        .map_or((label, ""), |(quantity, unit)| (quantity, if unit == "-" { "" } else { unit }))
}

/// `x`, `x2`, `x3` and `xaxis`, `xaxis2`: plotly's names.
fn axis_name(letter: &str, place: usize) -> String {
    if place == 0 { letter.to_owned() } else { format!("{letter}{}", place + 1) }
}

/// Title and labels of a panel.
fn labels(panel: &Panel) -> Value {
    json!({ "title": for_plotly(&panel.title), "x": for_plotly(&panel.x_label), "y": for_plotly(&panel.y_label) })
}

/// Panels in a row where there is room for them.
pub(super) fn columns(figure: &Figure) -> usize {
    figure.columns.clamp(1, figure.panels.len().max(1))
}

/// Six digits are more than a screen shows; what is not finite breaks the curve.
fn number(value: f64) -> Value {
    if value.is_finite() { json!(rounded(value)) } else { Value::Null }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figure() -> Figure {
        let t: Vec<f64> = (0..5000).map(|i| f64::from(i) * 0.005).collect();
        let wave: Vec<f64> = t.iter().map(|t| (7.0 * t).sin()).collect();
        let series = |name: &str| Series::new(name, t.clone(), wave.clone(), Style::Line);
        let panel = |y_label: &str| Panel {
            title: "a & b".into(),
            x_label: "time (s)".into(),
            y_label: y_label.into(),
            series: vec![series("<b>measured</b>"), series("updated")],
        };
        Figure { title: String::new(), panels: (0..11).map(|_| panel("Fz (N)")).collect(), columns: 2 }
    }

    #[test]
    fn curves_of_a_panel_share_their_abscissae_and_have_one_entry_in_the_legend() {
        let data = data(&figure(), 400).unwrap();
        assert_eq!(data["x"].as_array().unwrap().len(), 11);
        let traces = data["traces"].as_array().unwrap();
        assert_eq!(traces.len(), 22);
        assert_eq!(traces.iter().filter(|trace| trace["showlegend"] == true).count(), 2);
        assert_eq!(traces[21]["xaxis"], "x11");
        assert_eq!(data["columns"], 2);
        let points = data["x"][0].as_array().unwrap().len();
        assert!((150..=420).contains(&points), "{points}");
        assert!(traces.iter().all(|trace| trace["y"].as_array().unwrap().len() == points));
    }

    #[test]
    fn names_come_out_as_text_and_values_carry_units() {
        let data = data(&figure(), 400).unwrap();
        assert_eq!(data["traces"][0]["name"], "&lt;b&gt;measured&lt;/b&gt;");
        assert_eq!(data["panels"][0]["title"], "a &amp; b");
        assert_eq!(data["traces"][0]["hovertemplate"], "Fz = %{y:.5~g} N<br>time = %{x:.5~g} s");
    }

    #[test]
    fn a_band_is_filled_between_its_edges_and_named_once() {
        let edge = |y: f64| Series::new("noise", vec![0.0, 1.0], vec![y; 2], Style::Edge);
        let panel = |name: &str| Panel::new(name, "x", "y", vec![edge(-1.0), edge(1.0)]);
        let figure = Figure::new("", vec![panel("a"), panel("b")], 2);
        let data = data(&figure, 400).unwrap();
        let of =
            |key: &str| data["traces"].as_array().unwrap().iter().map(|t| t[key].clone()).collect::<Vec<_>>();
        assert_eq!(of("fill"), ["none", "tonexty", "none", "tonexty"]);
        assert_eq!(of("showlegend"), [false, true, false, false]);
        let svg = figure.svg().unwrap();
        assert!(svg.contains("#6e7781"), "the picture has the band, too");
    }
}
