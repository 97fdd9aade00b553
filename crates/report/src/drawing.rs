//! A finished picture, as SVG or PNG. Line charts come from kuva, planforms and views in space from our own canvas; kuva
//! paints the pixels of both.

use std::sync::Arc;

use kuva::PngBackend;
use kuva::backend::svg::SvgBackend;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};

use crate::error::DrawError;
use crate::paint::{Anchor, Canvas, Element};

/// Pixels of a PNG for each of the picture's.
const SCALE: f32 = 1.5;

/// A picture.
#[derive(Debug, Clone)]
pub struct Drawing(Source);

#[derive(Debug, Clone)]
enum Source {
    Chart(Arc<Scene>),
    Own(Canvas),
}

impl Drawing {
    pub(crate) fn of_chart(scene: Scene) -> Self {
        Self(Source::Chart(Arc::new(scene)))
    }

    pub(crate) fn of_canvas(canvas: Canvas) -> Self {
        Self(Source::Own(canvas))
    }

    /// The picture as an SVG document.
    pub fn svg(&self) -> String {
        match &self.0 {
            Source::Chart(scene) => SvgBackend::new().with_embedded_font(false).render_scene(scene),
            Source::Own(canvas) => canvas.svg(),
        }
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    /// If it is too large to paint.
    pub fn png(&self) -> Result<Vec<u8>, DrawError> {
        let painter = PngBackend::new().with_scale(SCALE);
        let painted = match &self.0 {
            Source::Chart(scene) => painter.render_scene(scene),
            Source::Own(canvas) => painter.render_scene(&scene(canvas)),
        };
        painted.map_err(DrawError::Pixels)
    }
}

/// Our own picture in kuva's terms.
fn scene(canvas: &Canvas) -> Scene {
    let mut scene = Scene::new(canvas.width, canvas.height);
    scene.background_color = Some("#ffffff".into());
    scene.text_color = Some("#222222".into());
    scene.elements = canvas.elements.iter().map(primitive).collect();
    scene
}

fn primitive(element: &Element) -> Primitive {
    match element {
        Element::Polygon { points, fill, stroke, stroke_width, .. } => {
            let corners: Vec<String> = points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
            Primitive::Path(Box::new(PathData {
                d: format!("M{} Z", corners.join(" L")),
                fill: Some(fill.into()),
                stroke: stroke.into(),
                stroke_width: *stroke_width,
                opacity: None,
                stroke_dasharray: None,
            }))
        }
        Element::Rectangle { at: [x, y, width, height], fill } => Primitive::Rect {
            x: *x,
            y: *y,
            width: *width,
            height: *height,
            fill: fill.into(),
            stroke: None,
            stroke_width: None,
            opacity: None,
        },
        Element::Line { from, to, stroke, width } => Primitive::Line {
            x1: from.0,
            y1: from.1,
            x2: to.0,
            y2: to.1,
            stroke: stroke.into(),
            stroke_width: *width,
            stroke_dasharray: None,
        },
        Element::Text { at, size, anchor, turn_deg, text } => Primitive::Text {
            x: at.0,
            y: at.1,
            content: text.clone(),
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "sizes of letters")]
            size: size.round() as u32,
            anchor: match anchor {
                Anchor::Start => TextAnchor::Start,
                Anchor::Middle => TextAnchor::Middle,
            },
            rotate: (*turn_deg != 0.0).then_some(*turn_deg),
            bold: false,
            color: None,
        },
    }
}
