//! Line charts: a grid of panels with one legend below, drawn by kuva.

use kuva::plot::legend::{LegendEntry, LegendShape};
use kuva::plot::{BandPlot, LinePlot, MarkerShape, ScatterPlot};
use kuva::render::figure::Figure as Grid;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;

use crate::drawing::Drawing;
use crate::error::DrawError;
use crate::palette;
use crate::thin::{kept_together, thinned};

/// Width of a panel, px.
const PANEL_WIDTH: f64 = 480.0;
/// Height of a panel, px.
const PANEL_HEIGHT: f64 = 300.0;
/// Points of a curve that are drawn at most.
const POINTS: usize = 2000;

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// Points joined by a line.
    Line,
    /// Separate points: measurements.
    Points,
    /// Points joined by a dashed line: the state before, a reference, a bound.
    DashedLine,
    /// Points joined by a line, with a marker on each: few points, of which each counts. The markers of two names differ.
    Marked,
    /// An edge of a shaded band: two in a row of one name and the same abscissae, the lower first.
    Edge,
}

/// The markers of [`Style::Marked`] in the order of names, for kuva and for plotly.
pub(crate) const MARKERS: [(MarkerShape, &str); 5] = [
    (MarkerShape::Circle, "circle"),
    (MarkerShape::Square, "square"),
    (MarkerShape::Triangle, "triangle-up"),
    (MarkerShape::Diamond, "diamond"),
    (MarkerShape::Cross, "x"),
];
/// How much a band covers, of 255.
pub(crate) const BAND: u8 = 56;

/// One curve or cloud. Series of the same name have the same colour in every panel and one entry in the legend.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Abscissae in the unit of the panel's label.
    pub x: Vec<f64>,
    /// Ordinates, as many as abscissae. Points that are not finite are left out.
    pub y: Vec<f64>,
    /// Line, points or dashes.
    pub style: Style,
}

impl Series {
    /// A series from its parts.
    pub fn new(name: impl Into<String>, x: Vec<f64>, y: Vec<f64>, style: Style) -> Self {
        Self { name: name.into(), x, y, style }
    }
}

/// One pair of axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Title above the panel; may be empty.
    pub title: String,
    /// Quantity and unit, `time (s)`.
    pub x_label: String,
    /// Quantity and unit, `Fz (N)`.
    pub y_label: String,
    /// What is drawn, later series above earlier ones.
    pub series: Vec<Series>,
}

/// A grid of panels, filled row by row.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title of the whole.
    pub title: String,
    /// The panels.
    pub panels: Vec<Panel>,
    /// Panels in a row; zero counts as one.
    pub columns: usize,
}

impl Figure {
    /// A figure from its parts.
    pub fn new(title: impl Into<String>, panels: Vec<Panel>, columns: usize) -> Self {
        Self { title: title.into(), panels, columns }
    }

    /// The figure as an SVG document.
    ///
    /// # Errors
    /// As [`Figure::draw`].
    pub fn svg(&self) -> Result<String, DrawError> {
        Ok(self.draw()?.svg())
    }

    /// The figure as a picture.
    ///
    /// # Errors
    /// If there is no panel, a panel has no finite point, or x and y of a series have different lengths.
    pub fn draw(&self) -> Result<Drawing, DrawError> {
        if self.panels.is_empty() {
            return Err(DrawError::Empty(self.title.clone()));
        }
        let names = self.names();
        let mut plots = Vec::new();
        let mut layouts = Vec::new();
        for panel in &self.panels {
            let drawn = panel.plots(&names)?;
            layouts.push(panel.layout(&drawn));
            plots.push(drawn);
        }
        let columns = self.columns.clamp(1, self.panels.len());
        let rows = self.panels.len().div_ceil(columns);
        let mut grid = Grid::new(rows, columns)
            .with_structure((0..self.panels.len()).map(|i| vec![i]).collect())
            .with_plots(plots)
            .with_layouts(layouts)
            .with_cell_size(PANEL_WIDTH, PANEL_HEIGHT)
            .with_spacing(14.0)
            .with_title(plain(&self.title))
            .with_title_size(18);
        if names.len() > 1 {
            grid = grid.with_shared_legend_entries(self.legend(&names)).with_shared_legend_bottom();
        }
        Ok(Drawing::of_chart(grid.render()))
    }

    /// The first series of each name.
    fn named(&self) -> Vec<&Series> {
        let mut first: Vec<&Series> = Vec::new();
        for series in self.panels.iter().flat_map(|panel| &panel.series) {
            if first.iter().all(|known| known.name != series.name) {
                first.push(series);
            }
        }
        first
    }

    /// Names of the series in the order of their first appearance.
    pub(crate) fn names(&self) -> Vec<&str> {
        self.named().into_iter().map(|series| series.name.as_str()).collect()
    }

    fn legend(&self, names: &[&str]) -> Vec<LegendEntry> {
        let entry = |(place, (series, colour)): (usize, (&Series, &str))| LegendEntry {
            // kuva measures text a little too narrow; the blanks keep long names inside the box.
            label: format!("{}\u{a0}\u{a0}", plain(&series.name)),
            color: if series.style == Style::Edge {
                palette::shaded(colour, 1.0 - f64::from(BAND) / 255.0)
            } else {
                colour.into()
            },
            shape: match series.style {
                Style::Points => LegendShape::Circle,
                Style::Marked => LegendShape::Marker(MARKERS[place % MARKERS.len()].0),
                Style::Edge => LegendShape::Rect,
                Style::Line | Style::DashedLine => LegendShape::Line,
            },
            dasharray: (series.style == Style::DashedLine).then(|| "6 4".into()),
        };
        self.named().into_iter().zip(palette::of_names(names)).enumerate().map(entry).collect()
    }
}

impl Panel {
    /// A panel from its parts.
    pub fn new(
        title: impl Into<String>,
        x_label: impl Into<String>,
        y_label: impl Into<String>,
        series: Vec<Series>,
    ) -> Self {
        Self { title: title.into(), x_label: x_label.into(), y_label: y_label.into(), series }
    }

    fn plots(&self, names: &[&str]) -> Result<Vec<Plot>, DrawError> {
        let mut plots = Vec::new();
        let colours = palette::of_names(names);
        let mut lower: Option<&Series> = None;
        for series in &self.series {
            DrawError::check_lengths(&series.name, series.x.len(), series.y.len())?;
            let place = names.iter().position(|n| *n == series.name).unwrap_or(0);
            let colour = colours[place];
            if series.style == Style::Edge {
                match lower.take() {
                    Some(below) => plots.extend(band(below, series, colour)),
                    None => lower = Some(series),
                }
                continue;
            }
            let points = thinned(&series.x, &series.y, POINTS);
            if points.is_empty() {
                continue;
            }
            let dots = |points, size| ScatterPlot::new().with_data(points).with_color(colour).with_size(size);
            match series.style {
                Style::Line => plots.push(line(points, colour, 1.8).into()),
                Style::DashedLine => plots.push(line(points, colour, 1.6).with_dashed().into()),
                Style::Marked => {
                    plots.push(line(points.clone(), colour, 1.4).into());
                    plots.push(dots(points, 4.0).with_marker(MARKERS[place % MARKERS.len()].0).into());
                }
                Style::Points | Style::Edge => plots.push(dots(points, 3.5).into()),
            }
        }
        if plots.is_empty() {
            return Err(DrawError::Empty(format!("panel '{} {}'", self.title, self.y_label)));
        }
        Ok(plots)
    }

    fn layout(&self, plots: &[Plot]) -> Layout {
        let layout = Layout::auto_from_plots(plots)
            .with_x_label(plain(&self.x_label))
            .with_y_label(plain(&self.y_label))
            .with_font_family(crate::paint::FONT)
            .with_ticks(6)
            .with_tick_size(12)
            .with_label_size(13)
            .with_title_size(14)
            .with_body_size(12);
        let layout = match self.level() {
            // Alone, a level line gets ticks of its neighbourhood that run into the label beside them.
            Some(level) => {
                let reach = if level == 0.0 { 1.0 } else { level.abs() };
                layout.with_y_axis_min(level - reach).with_y_axis_max(level + reach)
            }
            None => layout,
        };
        if self.title.is_empty() { layout } else { layout.with_title(plain(&self.title)) }
    }

    /// The one value of all series, if they have but one.
    fn level(&self) -> Option<f64> {
        let mut values = self.series.iter().flat_map(|series| &series.y).filter(|y| y.is_finite());
        let first = *values.next()?;
        values.all(|y| *y == first).then_some(first)
    }
}

fn line(points: Vec<(f64, f64)>, colour: &str, width: f64) -> LinePlot {
    LinePlot::new().with_data(points).with_color(colour).with_stroke_width(width)
}

/// What lies between two edges, where both are finite.
fn band(below: &Series, above: &Series, colour: &str) -> Option<Plot> {
    let kept = kept_together(&below.x, &[&below.y, &above.y], POINTS);
    let kept: Vec<usize> = kept
        .into_iter()
        .filter(|&i| below.y[i].is_finite() && above.y.get(i).is_some_and(|y| y.is_finite()))
        .collect();
    let of = |values: &[f64]| kept.iter().map(|&i| values[i]).collect::<Vec<f64>>();
    let drawn = || {
        BandPlot::new(of(&below.x), of(&below.y), of(&above.y))
            .with_color(colour)
            .with_opacity(f64::from(BAND) / 255.0)
    };
    (!kept.is_empty()).then(|| drawn().into())
}

/// Text in which kuva finds no mathematics to typeset.
fn plain(text: &str) -> String {
    text.replace('$', "\\$")
}
