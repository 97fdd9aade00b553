//! The figures of `fullaircraft`: deformed shapes and time histories, initial beside updated model.

use fullaircraft::{Aircraft, Comparison, Envelope, FlightHistory, Trimmed};
use report::deformed::{Quad, View};
use report::vtu::{CellType, Field, Mesh};
use report::{Figure, Panel, Series, Style};

use crate::failure::Failure;
use crate::output::ResultFolder;

/// Writes them.
pub(crate) fn write(
    folder: &ResultFolder,
    aircraft: &Aircraft,
    comparison: &Comparison,
) -> Result<(), Failure> {
    let (initial, updated) = (&comparison.initial, &comparison.updated);
    for (name, title, before, after) in [
        ("pull_up", "Pull-up", &initial.pull_up, &updated.pull_up),
        ("push_down", "Push-down", &initial.push_down, &updated.push_down),
    ] {
        let point = before.point;
        let title = format!("{title}: {} m/s, load factor {}", point.v_m_s, point.load_factor);
        let views =
            [("initial", before), ("updated", after)].map(|(name, trimmed)| view(aircraft, name, trimmed));
        let files = ["initial", "updated"].map(|model| format!("{name}_{model}.vtu"));
        let caption = "Figure 21 of the paper. Drag to turn, scroll to come nearer; a click on a name hides a model. The VTU files open in ParaView.";
        folder.write_shapes(name, &title, caption, views.into(), &files)?;
    }
    let mut all = vec![
        ("doublet", "Aileron doublet in free flight", &initial.doublet, &updated.doublet, &ROLLING),
        ("chirp", "Aileron chirp in free flight", &initial.chirp, &updated.chirp, &ROLLING),
    ];
    if let (Some(before), Some(after)) = (&initial.gust, &updated.gust) {
        all.push(("gust", "Vertical gust in free flight", before, after, &PITCHING));
    }
    for (name, title, before, after, quantities) in all {
        let full = ["initial", "updated"].map(|model| format!("{name}_{model}.csv"));
        let paper = if name == "gust" { "" } else { "A maneuver of Figures 22 and 23 of the paper. " };
        let caption = format!("{paper}All quantities: {} and {}.", full[0], full[1]);
        folder.write_figure(name, &caption, histories(title, before, after, quantities))?;
    }
    Ok(())
}

/// The deformed boxes with their lift per area, and how far each corner moved along the box normal.
pub(super) fn vtu(aircraft: &Aircraft, trimmed: &Trimmed) -> String {
    let (quads, boxes) = (aircraft.deformed(trimmed), &aircraft.flow.lattice.boxes);
    let moved = quads.iter().zip(boxes).flat_map(|(quad, panel)| {
        quad.iter().zip(&panel.corners).map(|(corner, before)| (corner - before).dot(&panel.normal()))
    });
    let lift = boxes.iter().enumerate().map(|(j, panel)| trimmed.box_loads[2 * j] / panel.area_m2());
    let field = |name: &str, values: Vec<f64>| vec![Field { name: name.into(), components: 1, values }];
    let mesh = Mesh {
        points: quads.iter().flatten().map(|corner| [corner.x, corner.y, corner.z]).collect(),
        cells: (0..quads.len()).map(|j| (CellType::Quadrilateral, (4 * j..4 * j + 4).collect())).collect(),
        point_fields: field("deflection_m", moved.collect()),
        cell_fields: field("lift_per_area_Pa", lift.collect()),
    };
    mesh.vtu()
}

/// A panel's label and its history.
type Quantity = (&'static str, fn(&FlightHistory) -> &Vec<f64>);

/// What an antisymmetric maneuver shows.
const ROLLING: [Quantity; 8] = [
    ("aileron (deg)", |h| &h.aileron_deg),
    ("angle of attack (deg)", |h| &h.alpha_deg),
    ("tip deflection (m)", |h| &h.tip_deflection_m),
    ("tip acceleration (m/s2)", |h| &h.tip_acceleration_m_s2),
    ("tip roll rate (deg/s)", |h| &h.tip_rates_deg_s[0]),
    ("tip pitch rate (deg/s)", |h| &h.tip_rates_deg_s[1]),
    ("tip yaw rate (deg/s)", |h| &h.tip_rates_deg_s[2]),
    ("right root Mx (N m)", |h| &h.root_right[1]),
];

/// What a symmetric one shows.
const PITCHING: [Quantity; 8] = [
    ("gust at the centre of gravity (m/s)", |h| &h.gust_m_s),
    ("angle of attack (deg)", |h| &h.alpha_deg),
    ("load factor", |h| &h.load_factor),
    ("tip deflection (m)", |h| &h.tip_deflection_m),
    ("tip acceleration (m/s2)", |h| &h.tip_acceleration_m_s2),
    ("pitch rate (deg/s)", |h| &h.rates_deg_s[1]),
    ("right root Mx (N m)", |h| &h.root_right[1]),
    ("left root Mx (N m)", |h| &h.root_left[1]),
];

/// The V-n envelope with the lift at the ends of the section's polars and the two limit points.
pub(crate) fn envelope(aircraft: &Aircraft, envelope: &Envelope) -> Figure {
    let line = |name: &str, n: &Vec<f64>, style| Series::new(name, envelope.v_m_s.clone(), n.clone(), style);
    let (up, down) = (&aircraft.file.pull_up, &aircraft.file.push_down);
    let points = Series::new(
        "pull-up and push-down",
        vec![up.v_m_s, down.v_m_s],
        vec![up.load_factor, down.load_factor],
        Style::Points,
    );
    let [stall_low, stall_high] = &envelope.stall;
    let [low, high] = &envelope.limit;
    let series = vec![
        line("end of the polars, upper", stall_high, Style::DashedLine),
        line("end of the polars, lower", stall_low, Style::DashedLine),
        line("limit, upper", high, Style::Line),
        line("limit, lower", low, Style::Line),
        points,
    ];
    let panel = Panel::new("", "airspeed (m/s)", "load factor", series);
    Figure::new("V-n envelope, section's lift limits", vec![panel], 1)
}

fn view(aircraft: &Aircraft, name: &str, trimmed: &Trimmed) -> View {
    let wings = aircraft.right.boxes.len() + aircraft.left.boxes.len();
    let quad = |(j, corners)| Quad { corners, group: usize::from(j >= wings) };
    View {
        title: format!("{name}: tip {:.3} m", trimmed.tip_deflection_m[0]),
        groups: vec!["wings".into(), "tail and fuselage".into()],
        quads: aircraft.deformed(trimmed).into_iter().enumerate().map(quad).collect(),
        ..View::default()
    }
}

fn histories(
    title: &str,
    initial: &FlightHistory,
    updated: &FlightHistory,
    quantities: &[Quantity],
) -> Figure {
    let panel = |&(label, pick): &Quantity| {
        Panel::new(
            "",
            "time (s)",
            label,
            vec![
                Series::new("initial", initial.t_s.clone(), pick(initial).clone(), Style::DashedLine),
                Series::new("updated", updated.t_s.clone(), pick(updated).clone(), Style::Line),
            ],
        )
    };
    Figure::new(title, quantities.iter().map(panel).collect(), 2)
}
