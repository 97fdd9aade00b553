//! A finished picture, as SVG or PNG. Line charts come from kuva, planforms and views in space from our own canvas; kuva
//! paints the pixels of both.

use std::sync::Arc;

use kuva::PngBackend;
use kuva::backend::svg::SvgBackend;
use kuva::render::render::Scene;

use crate::error::DrawError;

/// Pixels of a PNG for each of the picture's.
const SCALE: f32 = 1.5;

/// A picture: its SVG document, and the same for kuva to paint.
#[derive(Debug, Clone)]
pub struct Drawing {
    svg: String,
    scene: Arc<Scene>,
}

impl Drawing {
    pub(crate) fn of_chart(scene: Scene) -> Self {
        Self::new(SvgBackend::new().with_embedded_font(false).render_scene(&scene), scene)
    }

    pub(crate) fn new(svg: String, scene: Scene) -> Self {
        Self { svg, scene: Arc::new(scene) }
    }

    /// The picture as an SVG document.
    pub fn svg(&self) -> String {
        self.svg.clone()
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    /// If it is too large to paint.
    pub fn png(&self) -> Result<Vec<u8>, DrawError> {
        PngBackend::new().with_scale(SCALE).render_scene(&self.scene).map_err(DrawError::Pixels)
    }
}
