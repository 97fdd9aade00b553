//! A [`Figure`] as plotly's data: the same panels and colours as the still picture, to zoom, hover over and hide.
//!
//! Abscissae are written once for all curves of a panel that share them; `page.js` puts them back. Names and labels are
//! escaped once more, as plotly reads some HTML in texts.

use serde_json::{Value, json};

use crate::error::DrawError;
use crate::escape::for_plotly;
use crate::figure::{Figure, Panel, Series, Style};
use crate::palette;
use crate::thin::{kept_together, rounded};

/// Height of a row of panels, px.
const ROW: usize = 270;
/// Room above for the buttons and below for the labels, px.
const HEAD: usize = 84;
/// Height of a row of the legend, px.
const LEGEND: usize = 22;
/// Room for labels between rows, px.
const LABELS: f64 = 66.0;

/// The figure for `page.js`: abscissae, traces and layout; at most about `limit` points a curve.
pub(super) fn data(figure: &Figure, limit: usize) -> Result<Value, DrawError> {
    let names = figure.names();
    let colours = palette::of_names(&names);
    let mut shared: Vec<Value> = Vec::new();
    let mut traces = Vec::new();
    let mut shown: Vec<&str> = Vec::new();
    for (place, panel) in figure.panels.iter().enumerate() {
        for group in groups(panel)? {
            let ys: Vec<&[f64]> = group.iter().map(|series| series.y.as_slice()).collect();
            let kept = kept_together(&group[0].x, &ys, limit);
            let pick = |values: &[f64]| kept.iter().map(|&i| number(values[i])).collect::<Vec<Value>>();
            for series in &group {
                let first = !shown.contains(&series.name.as_str());
                if first {
                    shown.push(&series.name);
                }
                let colour = colours[names.iter().position(|name| *name == series.name).unwrap_or(0)];
                traces.push(trace(series, (place, shared.len()), colour, panel, first, &pick(&series.y)));
            }
            shared.push(json!(pick(&group[0].x)));
        }
    }
    Ok(json!({ "x": shared, "traces": traces, "layout": layout(figure, names.len()) }))
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

fn trace(
    series: &Series,
    (place, x): (usize, usize),
    colour: &str,
    panel: &Panel,
    first: bool,
    y: &[Value],
) -> Value {
    let axis = |letter: &str| axis_name(letter, place);
    let name = for_plotly(&series.name);
    let mut trace = json!({
        "type": "scatter", "name": name, "legendgroup": name, "showlegend": first,
        "x": x, "y": y, "xaxis": axis("x"), "yaxis": axis("y"),
        "hovertemplate": hover(panel),
    });
    match series.style {
        Style::Points => {
            trace["mode"] = json!("markers");
            trace["marker"] = json!({ "color": colour, "size": 6 });
        }
        Style::Line | Style::DashedLine => {
            let dash = if series.style == Style::Line { "solid" } else { "6px,4px" };
            trace["mode"] = json!("lines");
            trace["line"] = json!({ "color": colour, "width": 1.7, "dash": dash });
        }
    }
    trace
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

fn layout(figure: &Figure, names: usize) -> Value {
    let columns = figure.columns.clamp(1, figure.panels.len().max(1));
    let rows = figure.panels.len().div_ceil(columns);
    let legend = LEGEND * legend_rows(&figure.names());
    let height = rows * ROW + HEAD + legend;
    let mut layout = json!({
        "height": height, "showlegend": names > 1, "annotations": [],
        "margin": { "l": 62, "r": 14, "t": 34 + legend, "b": 50 },
        "legend": { "orientation": "h", "x": 0, "y": 1.0 + 26.0 / (rows * ROW) as f64, "yanchor": "bottom" },
    });
    let timed = figure.panels.iter().all(|panel| panel.x_label == "time (s)");
    let mut titles = Vec::new();
    for (place, panel) in figure.panels.iter().enumerate() {
        let (row, column) = (place / columns, place % columns);
        let (x, y) = domains((row, rows), (column, columns));
        let title = |label: &str| json!({ "text": for_plotly(label), "standoff": 6 });
        let mut across =
            json!({ "domain": x, "anchor": axis_name("y", place), "title": title(&panel.x_label) });
        if timed && place > 0 {
            // zooming into the time of one panel zooms all
            across["matches"] = json!("x");
        }
        layout[axis_name("xaxis", place)] = across;
        layout[axis_name("yaxis", place)] =
            json!({ "domain": y, "anchor": axis_name("x", place), "title": title(&panel.y_label) });
        if !panel.title.is_empty() {
            titles.push(json!({
                "text": for_plotly(&panel.title), "xref": "paper", "yref": "paper", "showarrow": false,
                "x": f64::midpoint(x[0], x[1]), "y": y[1], "yanchor": "bottom", "font": { "size": if columns > 2 { 11 } else { 13 } },
            }));
        }
    }
    layout["annotations"] = json!(titles);
    layout
}

/// Rows that the names take, about.
fn legend_rows(names: &[&str]) -> usize {
    let px: usize = names.iter().map(|name| 50 + 7 * name.chars().count()).sum();
    if names.len() > 1 { px.div_ceil(950) } else { 0 }
}

/// Parts of the width and height that a panel takes; rows are counted from above.
fn domains((row, rows): (usize, usize), (column, columns): (usize, usize)) -> ([f64; 2], [f64; 2]) {
    let part = |place: usize, count: usize, gap: f64| {
        let size = (1.0 - gap * (count - 1) as f64) / count as f64;
        let low = place as f64 * (size + gap);
        [low, (low + size).min(1.0)]
    };
    // room for the labels between panels
    let x = part(column, columns, 0.18 / columns as f64);
    let y = part(rows - 1 - row, rows, LABELS / (rows * ROW) as f64);
    (x, y)
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
        assert!(data["layout"]["xaxis11"]["matches"] == "x" && data["layout"]["xaxis"]["matches"].is_null());
        let points = data["x"][0].as_array().unwrap().len();
        assert!((150..=420).contains(&points), "{points}");
        assert!(traces.iter().all(|trace| trace["y"].as_array().unwrap().len() == points));
    }

    #[test]
    fn names_come_out_as_text_and_values_carry_units() {
        let data = data(&figure(), 400).unwrap();
        assert_eq!(data["traces"][0]["name"], "&lt;b&gt;measured&lt;/b&gt;");
        assert_eq!(data["layout"]["annotations"][0]["text"], "a &amp; b");
        assert_eq!(data["traces"][0]["hovertemplate"], "Fz = %{y:.5~g} N<br>time = %{x:.5~g} s");
    }

    #[test]
    fn panels_do_not_overlap() {
        for columns in 1..4_usize {
            for rows in 1..6_usize {
                let of = |row, column| domains((row, rows), (column, columns));
                for row in 0..rows {
                    for column in 0..columns {
                        let (x, y) = of(row, column);
                        assert!(0.0 <= x[0] && x[0] < x[1] && x[1] <= 1.0 + 1e-12, "{x:?}");
                        assert!(0.0 <= y[0] && y[0] < y[1] && y[1] <= 1.0, "{y:?}");
                        assert!(column == 0 || of(row, column - 1).0[1] < x[0]);
                        assert!(row == 0 || of(row - 1, column).1[0] > y[1]);
                    }
                }
            }
        }
    }
}
