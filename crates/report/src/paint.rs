//! The canvas of our own pictures (planforms, views in space): each element is written as SVG, and kept for kuva to paint
//! the pixels of.

use kuva::render::render::{PathData, Primitive, Scene};

use crate::drawing::Drawing;
use crate::escape::for_xml;

/// How text sits on its point.
pub(crate) use kuva::render::render::TextAnchor as Anchor;

/// Fonts every system has something for.
pub(crate) const FONT: &str = "DejaVu Sans, Arial, Helvetica, sans-serif";
/// Colour of letters and axes.
const INK: &str = "#222222";

/// A picture in the making; coordinates in pixels, y down. What comes later is above what came earlier.
#[derive(Debug)]
pub(crate) struct Canvas {
    body: String,
    scene: Scene,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        let mut scene = Scene::new(width, height);
        scene.background_color = Some("#ffffff".into());
        scene.text_color = Some(INK.into());
        Self { body: String::new(), scene }
    }

    fn push(&mut self, svg: &str, primitive: Primitive) {
        self.body.push_str(svg);
        self.scene.elements.push(primitive);
    }

    /// A filled polygon with an outline of the given colour.
    pub(crate) fn polygon(&mut self, points: &[(f64, f64)], fill: &str, stroke: &str, stroke_width: f64) {
        self.noted_polygon(points, fill, stroke, stroke_width, "");
    }

    /// A polygon that tells a pointer which rests on it something.
    pub(crate) fn noted_polygon(
        &mut self,
        points: &[(f64, f64)],
        fill: &str,
        stroke: &str,
        stroke_width: f64,
        note: &str,
    ) {
        let corners: Vec<String> = points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
        let end = match note {
            "" => "/>".to_owned(),
            note => format!("><title>{}</title></polygon>", for_xml(note)),
        };
        let svg = format!(
            "<polygon points=\"{}\" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"{stroke_width}\" \
             stroke-linejoin=\"round\"{end}\n",
            corners.join(" ")
        );
        let path = PathData {
            d: format!("M{} Z", corners.join(" L")),
            fill: Some(fill.into()),
            stroke: stroke.into(),
            stroke_width,
            opacity: None,
            stroke_dasharray: None,
        };
        self.push(&svg, Primitive::Path(Box::new(path)));
    }

    /// A filled rectangle from its left top corner.
    pub(crate) fn rectangle(&mut self, x: f64, y: f64, width: f64, height: f64, fill: &str) {
        let svg = format!(
            "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" fill=\"{fill}\"/>\n"
        );
        let (stroke, stroke_width, opacity) = (None, None, None);
        let fill = fill.into();
        self.push(&svg, Primitive::Rect { x, y, width, height, fill, stroke, stroke_width, opacity });
    }

    /// A straight line.
    pub(crate) fn line(&mut self, (x1, y1): (f64, f64), (x2, y2): (f64, f64), colour: &str, width: f64) {
        let svg = format!(
            "<line x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\" stroke=\"{colour}\" \
             stroke-width=\"{width}\"/>\n"
        );
        let (stroke, stroke_width, stroke_dasharray) = (colour.into(), width, None);
        self.push(&svg, Primitive::Line { x1, y1, x2, y2, stroke, stroke_width, stroke_dasharray });
    }

    /// A line of an axis.
    pub(crate) fn axis(&mut self, from: (f64, f64), to: (f64, f64)) {
        self.line(from, to, INK, 1.0);
    }

    /// Text in the given size (px) with its baseline at the point.
    pub(crate) fn text(&mut self, at: (f64, f64), size: f64, anchor: Anchor, text: &str) {
        self.turned_text(at, size, anchor, 0.0, text);
    }

    /// Text turned by some degrees (clockwise) about its point.
    pub(crate) fn turned_text(
        &mut self,
        (x, y): (f64, f64),
        size: f64,
        anchor: Anchor,
        turn_deg: f64,
        text: &str,
    ) {
        let rotate = (turn_deg != 0.0).then_some(turn_deg);
        let turn = rotate
            .map_or_else(String::new, |turn_deg| format!(" transform=\"rotate({turn_deg} {x:.2} {y:.2})\""));
        let place = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let svg = format!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size}\" text-anchor=\"{place}\"{turn}>{}</text>\n",
            for_xml(text)
        );
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sizes of letters")]
        let size = size.round() as u32;
        let (content, bold, color) = (text.to_owned(), false, None);
        self.push(&svg, Primitive::Text { x, y, content, size, anchor, rotate, bold, color });
    }

    /// The whole.
    pub(crate) fn finish(self) -> Drawing {
        let (w, h) = (self.scene.width, self.scene.height);
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w:.0}\" height=\"{h:.0}\" viewBox=\"0 0 {w:.0} \
             {h:.0}\" font-family=\"{FONT}\" fill=\"{INK}\">\n<rect width=\"100%\" height=\"100%\" \
             fill=\"#ffffff\"/>\n{}</svg>\n",
            self.body
        );
        Drawing::new(svg, self.scene)
    }
}
