//! Values per box of a planform as coloured panels, seen from above: flight direction up, right tip to the right.
//!
//! ```text
//!        y (span) ->
//!   x    +----+----+----+----+
//!  aft   |  1 |  4 |  7 | 10 |
//!   |    |  2 |  5 |  8 | 11 |
//!   v    |  3 |  6 |  9 | 12 |
//!        +----+----+----+----+
//! ```

use crate::drawing::Drawing;
use crate::error::DrawError;
use crate::paint::{Anchor, Canvas};
use crate::palette;
use crate::ticks::{extent, tick_labels, ticks};

/// One planform with a value per box.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanformView {
    /// Corners of each box in order around it, as (x aft, y span) in metres.
    pub corners: Vec<[(f64, f64); 4]>,
    /// One value per box; what is not finite is drawn grey.
    pub values: Vec<f64>,
    /// Name and unit of the value, beside the colour bar.
    pub label: String,
    /// Title above the planform.
    pub title: String,
    /// Values at the two ends of the colours; `None` spans the values (a constant gets a small range around it).
    /// The middle is white: give a range that is symmetric about the neutral value, such as (0.5, 1.5) for factors.
    pub range: Option<(f64, f64)>,
}

/// Largest extent of a planform, px: three with their bars stand side by side on a page, one is as wide as a phone.
const WIDTH: f64 = 218.0;
const HEIGHT: f64 = 300.0;
/// Room around a planform for title and colour bar, px.
const LEFT: f64 = 14.0;
const RIGHT: f64 = 108.0;
/// Room above it, and above its title for the title of all, px.
const TOP: f64 = 30.0;
const TITLE: f64 = 46.0;
/// Room for the spanwise axis below a planform, px.
const SPAN_AXIS: f64 = 62.0;

/// The planforms side by side, each with its own colour bar, below a title unless that is empty.
///
/// # Errors
/// If there is no view, a view has no box, or corners and values differ in number.
pub fn draw(title: &str, views: &[PlanformView]) -> Result<Drawing, DrawError> {
    if views.is_empty() {
        return Err(DrawError::Empty(title.into()));
    }
    let top = if title.is_empty() { TOP } else { TITLE + TOP };
    let frames = views.iter().map(|view| Frame::new(view, top)).collect::<Result<Vec<_>, _>>()?;
    let height = frames.iter().map(|f| f.height + SPAN_AXIS).fold(170.0, f64::max) + top;
    let width: f64 = frames.iter().map(|f| f.width + LEFT + RIGHT).sum();
    let mut canvas = Canvas::new(width, height);
    if !title.is_empty() {
        canvas.text((width / 2.0, 28.0), 18.0, Anchor::Middle, title);
    }
    let mut left = 0.0;
    for (view, frame) in views.iter().zip(&frames) {
        paint_view(&mut canvas, view, frame, left + LEFT);
        left += frame.width + LEFT + RIGHT;
    }
    Ok(canvas.finish())
}

/// Where a planform lies in metres and how large it becomes on paper.
struct Frame {
    top: f64,
    x_min: f64,
    y_min: f64,
    scale: f64,
    span_m: f64,
    width: f64,
    height: f64,
    range: (f64, f64),
}

impl Frame {
    fn new(view: &PlanformView, top: f64) -> Result<Self, DrawError> {
        DrawError::check_lengths(&view.title, view.corners.len(), view.values.len())?;
        let finite: Vec<f64> = view.values.iter().copied().filter(|v| v.is_finite()).collect();
        let points = || view.corners.iter().flatten().filter(|(x, y)| x.is_finite() && y.is_finite());
        let (x_min, x_max) = extent(points().map(|p| p.0));
        let (y_min, y_max) = extent(points().map(|p| p.1));
        if finite.is_empty() || !(x_max > x_min && y_max > y_min) {
            return Err(DrawError::Empty(view.title.clone()));
        }
        let scale = (WIDTH / (y_max - y_min)).min(HEIGHT / (x_max - x_min));
        let (low, high) = view.range.unwrap_or_else(|| extent(finite.iter().copied()));
        let margin = if high > low { 0.0 } else { 0.01 * low.abs().max(1.0) };
        let range = (low - margin, high + margin);
        let (width, height) = ((y_max - y_min) * scale, (x_max - x_min) * scale);
        Ok(Self { top, x_min, y_min, scale, span_m: y_max - y_min, width: width.max(180.0), height, range })
    }

    fn place(&self, value: f64) -> f64 {
        (value - self.range.0) / (self.range.1 - self.range.0)
    }
}

fn paint_view(canvas: &mut Canvas, view: &PlanformView, frame: &Frame, left: f64) {
    canvas.text((left, frame.top - 14.0), 14.0, Anchor::Start, &view.title);
    for (corners, value) in view.corners.iter().zip(&view.values) {
        let points = corners.map(|(x, y)| {
            (left + (y - frame.y_min) * frame.scale, frame.top + (x - frame.x_min) * frame.scale)
        });
        // The outline in the fill's colour closes the hairlines that renderers leave between neighbours.
        let fill = palette::diverging(frame.place(*value));
        let note = format!("{value:.4}  {} at y {:.3} m", view.label, middle(corners));
        canvas.noted_polygon(&points, &fill, &palette::shaded(&fill, -0.12), 0.4, &note);
    }
    paint_span_axis(canvas, frame, left);
    paint_bar(canvas, view, frame, left + frame.width + 22.0);
}

/// Span of a box's middle, m.
fn middle(corners: &[(f64, f64); 4]) -> f64 {
    corners.iter().map(|corner| corner.1).sum::<f64>() / 4.0
}

/// The spanwise coordinate below the planform.
fn paint_span_axis(canvas: &mut Canvas, frame: &Frame, left: f64) {
    let y = frame.top + frame.height + 12.0;
    canvas.axis((left, y), (left + frame.span_m * frame.scale, y));
    let values = ticks(frame.y_min, frame.y_min + frame.span_m, 5);
    for (value, label) in values.iter().zip(tick_labels(&values)) {
        let x = left + (value - frame.y_min) * frame.scale;
        canvas.axis((x, y), (x, y + 5.0));
        canvas.text((x, y + 19.0), 12.0, Anchor::Middle, &label);
    }
    canvas.text((left + frame.span_m * frame.scale / 2.0, y + 38.0), 13.0, Anchor::Middle, "y (m)");
}

fn paint_bar(canvas: &mut Canvas, view: &PlanformView, frame: &Frame, left: f64) {
    const STEPS: u32 = 64;
    let (width, height) = (16.0, frame.height.max(160.0));
    for i in 0..STEPS {
        let place = (f64::from(i) + 0.5) / f64::from(STEPS);
        let step = height / f64::from(STEPS);
        let top = frame.top + height - f64::from(i + 1) * step;
        canvas.rectangle(left, top, width, step + 0.5, &palette::diverging(place));
    }
    let values = ticks(frame.range.0, frame.range.1, 5);
    for (value, label) in values.iter().zip(tick_labels(&values)) {
        let y = frame.top + height * (1.0 - frame.place(*value));
        canvas.axis((left + width, y), (left + width + 5.0, y));
        canvas.text((left + width + 9.0, y + 4.0), 12.0, Anchor::Start, &label);
    }
    canvas.turned_text(
        (left + width + 62.0, frame.top + height / 2.0),
        13.0,
        Anchor::Middle,
        -90.0,
        &view.label,
    );
}
