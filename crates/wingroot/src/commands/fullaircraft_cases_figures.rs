//! The figures of `fullaircraft --cases`: the load envelope along the span, and all cases at the right root.

use fullaircraft::Station;
use fullaircraft::cases::envelope::{Extreme, LOADS, ranges};
use fullaircraft::cases::grid::CaseResult;
use fullaircraft::cases::list::MODELS;
use report::{Figure, Panel, Series, Style};

use crate::pages::values::with_unit;

/// The station of which all cases are drawn.
pub(crate) const DRAWN_STATION: &str = "right root";

/// The intervals of the updated model in the legend.
const BAND: &str = "updated, 90 % interval";

/// The envelope of the right wing's stations over y, initial dashed beside updated with its intervals.
pub(crate) fn envelope(stations: &[Station], envelope: &[Extreme]) -> Figure {
    let mut places: Vec<&Station> = stations.iter().filter(|s| s.name.starts_with("right")).collect();
    places.sort_by(|a, b| a.point.y.total_cmp(&b.point.y));
    let curve = |name: &str, at: [&str; 3], style: Style, of: &dyn Fn(&Extreme) -> Option<f64>| {
        let found = places.iter().filter_map(|place| {
            let is_it = |e: &&Extreme| e.station == place.name && [e.model.as_str(), e.load, e.end] == at;
            Some((place.point.y, of(envelope.iter().find(is_it)?)?))
        });
        let (x, y) = found.unzip();
        Series::new(name, x, y, style)
    };
    let panel = |load: &'static str| {
        let mut series = Vec::new();
        for end in ["smallest", "largest"] {
            let at = [MODELS[1], load, end];
            series.extend(
                [0, 1].map(|side| curve(BAND, at, Style::Edge, &|extreme| Some(extreme.interval_90?[side]))),
            );
        }
        series.retain(|edge| !edge.x.is_empty());
        for model in MODELS {
            // a line through one point is none
            let style = match model {
                _ if places.len() < 2 => Style::Marked,
                "initial" => Style::DashedLine,
                _ => Style::Line,
            };
            series.extend(
                ["smallest", "largest"]
                    .map(|end| curve(model, [model, load, end], style, &|extreme| Some(extreme.value))),
            );
        }
        Panel::new("", "y of the station (m)", with_unit(load), series)
    };
    let panels = LOADS.into_iter().map(panel).collect();
    Figure::new("Load envelope of the right wing", panels, 3)
}

/// All cases at the right root: bending and torsion over lift; both ends of what moves.
pub(crate) fn cloud(results: &[CaseResult]) -> Figure {
    let points = |model: &str, across: usize, up: usize| {
        let of_model = results.iter().filter(|result| result.model == model);
        let loads = of_model.filter_map(|result| result.loads.iter().find(|s| s.station == DRAWN_STATION));
        let pairs: Vec<(f64, f64)> = loads
            .flat_map(|place| [0, 1].map(|end| (ranges(place)[across][end], ranges(place)[up][end])))
            .collect();
        let (x, y) = pairs.into_iter().unzip();
        Series::new(model, x, y, Style::Points)
    };
    let panel = |(across, up): (usize, usize)| {
        Panel::new(
            "",
            with_unit(LOADS[across]),
            with_unit(LOADS[up]),
            MODELS.iter().map(|model| points(model, across, up)).collect(),
        )
    };
    let panels = [(0, 1), (1, 2)].into_iter().map(panel).collect();
    Figure::new("All cases at the right wing's root", panels, 2)
}
