//! The figures of `fullaircraft --cases`: the load envelope along the span, and all cases at the right root.

use fullaircraft::Station;
use fullaircraft::cases::envelope::{Extreme, LOADS, ranges};
use fullaircraft::cases::grid::CaseResult;
use fullaircraft::cases::list::MODELS;
use report::{Figure, Panel, Series, Style};

use crate::pages::values::with_unit;

/// The station of which all cases are drawn.
pub(crate) const DRAWN_STATION: &str = "right root";

/// The envelope of the right wing's stations over y, initial dashed beside updated.
pub(crate) fn envelope(stations: &[Station], envelope: &[Extreme]) -> Figure {
    let mut places: Vec<&Station> = stations.iter().filter(|s| s.name.starts_with("right")).collect();
    places.sort_by(|a, b| a.point.y.total_cmp(&b.point.y));
    let line = |model: &str, load: &str, end: &str| {
        let style = if model == "initial" { Style::DashedLine } else { Style::Line };
        let (mut x, mut y) = (Vec::new(), Vec::new());
        for place in &places {
            let found = envelope
                .iter()
                .find(|e| e.model == model && e.station == place.name && e.load == load && e.end == end);
            if let Some(extreme) = found {
                x.push(place.point.y);
                y.push(extreme.value);
            }
        }
        Series::new(model, x, y, style)
    };
    let panel = |load: &'static str| {
        Panel::new(
            "",
            "y of the station (m)",
            with_unit(load),
            MODELS
                .iter()
                .flat_map(|model| ["smallest", "largest"].map(|end| line(model, load, end)))
                .collect(),
        )
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
