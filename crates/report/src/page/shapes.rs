//! Boxes in space as plotly's meshes: one trace a view and group, to turn and to hide.

use serde_json::{Value, json};

use crate::deformed::{Quad, View, finite};
use crate::escape::for_plotly;
use crate::palette;
use crate::thin::rounded;
use crate::ticks::extent;

/// The largest extent in units of plotly's window.
const WIDTH: f64 = 3.4;

/// How far each view lies above and beside the one before it, as a share of the largest extent: surfaces that coincide would
/// otherwise be drawn in patches of one and the other. `page.js` moves them, and reads out the places as they are.
const LIFT: f64 = 0.0015;

/// The views over one another for `page.js`; a view's legend entry hides all its groups.
pub(super) fn data(views: &[View]) -> Value {
    let mut traces = Vec::new();
    let titles: Vec<&str> = views.iter().map(|view| view.title.as_str()).collect();
    let colours = palette::of_names(&titles);
    for (number, view) in views.iter().enumerate() {
        let before = traces.len();
        for group in 0..view.groups.len().max(1) {
            let quads: Vec<&Quad> = view
                .quads
                .iter()
                .filter(|quad| quad.group == group && quad.corners.iter().all(finite))
                .collect();
            if !quads.is_empty() {
                traces.push(mesh(view, number, colours[number], group, &quads));
            }
        }
        if !view.lines.is_empty() {
            let alone = traces.len() == before;
            traces.push(strokes(view, number, colours[number], alone));
        }
    }
    let largest = extents(views).into_iter().fold(0.0, f64::max);
    json!({ "traces": traces, "layout": layout(views), "lift_m": rounded(LIFT * largest) })
}

fn mesh(view: &View, number: usize, colour: &str, group: usize, quads: &[&Quad]) -> Value {
    let coordinate =
        |axis: usize| quads.iter().flat_map(|q| q.corners.map(|p| rounded(p[axis]))).collect::<Vec<f64>>();
    let corner = |offsets: [usize; 2]| {
        (0..quads.len()).flat_map(|quad| offsets.map(|offset| 4 * quad + offset)).collect::<Vec<usize>>()
    };
    let name = for_plotly(&view.title);
    let part = view.groups.get(group).map(|name| for_plotly(name)).unwrap_or_default();
    let shade = if group == 0 { 0.0 } else { 0.35 };
    json!({
        "type": "mesh3d", "name": name, "visible": visible(view), "legendgroup": number.to_string(), "showlegend": group == 0,
        "x": coordinate(0), "y": coordinate(1), "z": coordinate(2),
        "i": corner([0, 0]), "j": corner([1, 2]), "k": corner([2, 3]),
        "color": palette::shaded(colour, shade), "flatshading": true,
        "lighting": { "ambient": 0.95, "diffuse": 0.25, "specular": 0.0 },
        "lightposition": { "x": -1000, "y": -2000, "z": 4000 }, "meta": number,
        "hovertemplate":
            format!("{name}, {part}<br>x %{{x:.3f}} m<br>y %{{customdata[0]:.3f}} m<br>z %{{customdata[1]:.3f}} m<extra></extra>"),
    })
}

/// Lines as one trace, with gaps between them.
fn strokes(view: &View, number: usize, colour: &str, in_legend: bool) -> Value {
    let kept = || view.lines.iter().filter(|ends| ends.iter().all(finite));
    let coordinate = |axis: usize| {
        let of = |[from, to]: &[nalgebra::Point3<f64>; 2]| {
            [json!(rounded(from[axis])), json!(rounded(to[axis])), Value::Null]
        };
        kept().flat_map(of).collect::<Vec<Value>>()
    };
    let name = for_plotly(&view.title);
    json!({
        "type": "scatter3d", "mode": "lines", "name": name, "legendgroup": number.to_string(), "showlegend": in_legend,
        "visible": visible(view), "line": { "color": colour, "width": 4 }, "meta": number,
        "x": coordinate(0), "y": coordinate(1), "z": coordinate(2),
        "hovertemplate": format!("{name}<br>x %{{x:.3f}} m<br>y %{{customdata[0]:.3f}} m<br>z %{{customdata[1]:.3f}} m<extra></extra>"),
    })
}

/// Plotly's word for a curve that only its name shows until it is clicked.
fn visible(view: &View) -> Value {
    if view.waits { json!("legendonly") } else { json!(true) }
}

/// Extents of all boxes, m.
fn extents(views: &[View]) -> [f64; 3] {
    [0, 1, 2].map(|axis| {
        let (low, high) = extent(views.iter().flat_map(View::points).map(|p| p[axis]));
        high - low
    })
}

/// The same, the largest as large as the window is wide.
fn aspects(views: &[View]) -> [f64; 3] {
    let extents = extents(views);
    let largest = extents.iter().copied().fold(0.0, f64::max);
    // a plane has an extent of its own too, as an axis needs some
    extents.map(|e| if largest > 0.0 && e.is_finite() { WIDTH * (e / largest).max(0.02) } else { 1.0 })
}

fn layout(views: &[View]) -> Value {
    let [x, y, z] = aspects(views);
    // plotly turns titles of axes with the axes, the upright one's over its ticks: the last tick says what it is
    let axis = |label: &str| {
        json!({
            "title": { "text": "" }, "tickangle": 0, "nticks": 6, "showbackground": false, "gridcolor": "#dddddd",
            "tickprefix": format!("{label} "), "showtickprefix": "last", "ticksuffix": " m", "showticksuffix": "last",
        })
    };
    json!({
        "scene": {
            "aspectmode": "manual", "aspectratio": { "x": x, "y": y, "z": z }, "xaxis": axis("x aft"),
            "yaxis": axis("y right"), "zaxis": axis("z up"),
            // from behind, the right and above, as the still pictures
            "camera": { "eye": { "x": 1.9, "y": 0.6, "z": 0.9 }, "projection": { "type": "orthographic" } },
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point3;

    #[test]
    fn a_box_becomes_two_triangles_and_points_that_are_not_finite_are_left_out() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]].map(|[x, y]| Point3::new(x, y, 0.5));
        let mut broken = corners;
        broken[2].z = f64::NAN;
        let quads = vec![Quad { corners, group: 1 }, Quad { corners: broken, group: 1 }];
        let view = View {
            title: "a<b".into(),
            groups: vec!["wings".into(), "tail".into()],
            quads,
            ..View::default()
        };
        let data = data(&[view]);
        let traces = data["traces"].as_array().unwrap();
        assert_eq!(traces.len(), 1);
        assert_eq!(traces[0]["i"], json!([0, 0]));
        assert_eq!(traces[0]["k"], json!([2, 3]));
        assert_eq!(traces[0]["y"], json!([0.0, 0.0, 2.0, 2.0]));
        assert_eq!(traces[0]["name"], "a&lt;b");
    }

    #[test]
    fn beams_become_lines_with_gaps_and_a_view_can_wait_for_a_click() {
        let end = |y: f64| Point3::new(0.0, y, 0.1 * y);
        let lines = vec![[end(0.0), end(1.0)], [end(1.0), end(2.0)]];
        let view =
            |title: &str, waits| View { title: title.into(), lines: lines.clone(), waits, ..View::default() };
        let data = data(&[view("mode 1", false), view("mode 2", true)]);
        let traces = data["traces"].as_array().unwrap();
        assert_eq!(traces[0]["y"], json!([0.0, 1.0, null, 1.0, 2.0, null]));
        assert!(traces.iter().all(|trace| trace["type"] == "scatter3d" && trace["showlegend"] == true));
        assert_eq!([&traces[0]["visible"], &traces[1]["visible"]], [&json!(true), &json!("legendonly")]);
    }
}
