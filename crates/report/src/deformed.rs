//! Oblique views of boxes in space: the wing or aircraft as it is deformed, one model beside another.
//!
//! Parallel projection, seen from behind, the right and above; the boxes are painted from far to near, with a
//! shade that follows their slope so that bending can be seen. All views share one scale.

use nalgebra::{Point3, Vector3};

use crate::drawing::Drawing;
use crate::error::DrawError;
use crate::paint::{Anchor, Canvas};
use crate::palette;
use crate::ticks::extent;

/// A box and the group it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct Quad {
    /// Corners in order around the box, m (x aft, y right, z up).
    pub corners: [Point3<f64>; 4],
    /// Group, an index into [`View::groups`]; gives the colour.
    pub group: usize,
}

/// One picture of several groups of boxes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct View {
    /// Title above the picture.
    pub title: String,
    /// Names of the groups for the legend.
    pub groups: Vec<String>,
    /// The boxes.
    pub quads: Vec<Quad>,
    /// Ends of lines: beams and rods, m.
    pub lines: Vec<[Point3<f64>; 2]>,
    /// Whether a page shows it only after a click on its name; the picture always shows it.
    pub waits: bool,
}

impl View {
    /// All points that are finite.
    pub(crate) fn points(&self) -> impl Iterator<Item = &Point3<f64>> {
        let corners = self.quads.iter().flat_map(|quad| &quad.corners);
        corners.chain(self.lines.iter().flatten()).filter(|point| finite(point))
    }
}

/// Angle by which the aircraft is turned about z before it is looked at, rad.
const TURN_RAD: f64 = 0.30;
/// Height of the eye above the horizon, rad.
const EYE_RAD: f64 = 0.42;
/// Room for each picture, px.
const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 400.0;
const MARGIN: f64 = 30.0;
const TOP: f64 = 76.0;
const LEGEND: f64 = 44.0;
/// Pictures in a row.
const ROW: usize = 2;

/// Axes of the picture: to the right, up, and towards the eye.
fn picture_axes() -> [Vector3<f64>; 3] {
    let (s, c) = TURN_RAD.sin_cos();
    let (se, ce) = EYE_RAD.sin_cos();
    // The eye is aft, right and above; "right" in the picture is the right wing turned by TURN_RAD.
    let right = Vector3::new(-s, c, 0.0);
    let eye = Vector3::new(c * ce, s * ce, se);
    [right, eye.cross(&right), eye]
}

/// The views side by side in one scale, two in a row.
///
/// # Errors
/// If there is no view or nothing with finite corners.
pub fn draw(title: &str, views: &[View]) -> Result<Drawing, DrawError> {
    let axes = picture_axes();
    let flat = |p: &Point3<f64>| (axes[0].dot(&p.coords), axes[1].dot(&p.coords));
    let points = || views.iter().flat_map(View::points).map(flat);
    let (across, up) = (extent(points().map(|(u, _)| u)), extent(points().map(|(_, v)| v)));
    let size = (across.1 - across.0).max(up.1 - up.0);
    if !(size > 0.0 && size.is_finite()) {
        return Err(DrawError::Empty(title.into()));
    }
    // A straight line up or across has no other extent of its own.
    let widened = |(low, high): (f64, f64)| {
        let missing = if high - low > 1e-6 * size { 0.0 } else { 0.05 * size };
        (low - missing, high + missing)
    };
    let ((low, right), (bottom, high)) = (widened(across), widened(up));
    let scale = ((WIDTH - 2.0 * MARGIN) / (right - low)).min(HEIGHT / (high - bottom));
    let drawn_height = (high - bottom) * scale;
    let width = WIDTH * views.len().clamp(1, ROW) as f64;
    let named = views.iter().any(|view| view.groups.len() > 1);
    let each = drawn_height + MARGIN + if named { LEGEND } else { 0.0 };
    let mut canvas = Canvas::new(width, TOP + each * views.len().div_ceil(ROW) as f64);
    canvas.text((width / 2.0, 28.0), 18.0, Anchor::Middle, title);
    for (i, view) in views.iter().enumerate() {
        let (left, top) = (WIDTH * (i % ROW) as f64, TOP + each * (i / ROW) as f64);
        canvas.text((left + WIDTH / 2.0, top - 22.0), 14.0, Anchor::Middle, &view.title);
        let inset = (WIDTH - (right - low) * scale) / 2.0;
        let to_paper = |p: &Point3<f64>| {
            let (u, v) = flat(p);
            (left + inset + (u - low) * scale, top + (high - v) * scale)
        };
        paint(&mut canvas, view, &axes, to_paper);
        if view.groups.len() > 1 {
            paint_legend(&mut canvas, view, left + MARGIN, top + drawn_height + LEGEND);
        }
    }
    Ok(canvas.finish())
}

fn paint(
    canvas: &mut Canvas,
    view: &View,
    axes: &[Vector3<f64>; 3],
    to_paper: impl Fn(&Point3<f64>) -> (f64, f64),
) {
    let depth = |quad: &Quad| quad.corners.iter().map(|p| axes[2].dot(&p.coords)).sum::<f64>();
    let mut order: Vec<&Quad> = view.quads.iter().filter(|q| q.corners.iter().all(finite)).collect();
    order.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
    for quad in order {
        let [a, b, c, d] = quad.corners;
        let normal = (c - a).cross(&(d - b)).try_normalize(0.0).unwrap_or_else(Vector3::z);
        // Light from above and the left: horizontal boxes come out light, steep ones darker.
        let light = Vector3::new(0.2, -0.45, 0.87).dot(&normal).abs();
        let fill = palette::shaded(palette::line(quad.group), 0.75 * light - 0.15);
        let points = quad.corners.map(|p| to_paper(&p));
        canvas.polygon(&points, &fill, &palette::shaded(palette::line(quad.group), -0.1), 0.25);
    }
    for [from, to] in view.lines.iter().filter(|ends| ends.iter().all(finite)) {
        canvas.line(to_paper(from), to_paper(to), palette::line(0), 1.2);
    }
}

pub(crate) fn finite(point: &Point3<f64>) -> bool {
    point.coords.iter().all(|v| v.is_finite())
}

fn paint_legend(canvas: &mut Canvas, view: &View, left: f64, y: f64) {
    let mut x = left;
    for (i, name) in view.groups.iter().enumerate() {
        canvas.rectangle(x, y - 11.0, 14.0, 12.0, &palette::shaded(palette::line(i), 0.3));
        canvas.text((x + 20.0, y), 13.0, Anchor::Start, name);
        x += 44.0 + 8.0 * name.chars().count() as f64;
    }
}
