//! The few elements that our own pictures (planforms, views in space) are made of, and how they read as SVG.

/// Fonts every system has something for.
pub(crate) const FONT: &str = "DejaVu Sans, Arial, Helvetica, sans-serif";

/// How text sits on its point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Anchor {
    Start,
    Middle,
}

/// An element of a picture, coordinates in pixels.
#[derive(Debug, Clone)]
pub(crate) enum Element {
    /// A filled polygon with an outline; a pointer that rests on it is told the note.
    Polygon { points: Vec<(f64, f64)>, fill: String, stroke: String, stroke_width: f64, note: String },
    /// A filled rectangle: left, top, width, height.
    Rectangle { at: [f64; 4], fill: String },
    /// A straight line.
    Line { from: (f64, f64), to: (f64, f64), stroke: String, width: f64 },
    /// Text with its baseline at the point, turned clockwise by some degrees.
    Text { at: (f64, f64), size: f64, anchor: Anchor, turn_deg: f64, text: String },
}

/// A picture in the making; coordinates in pixels, y down.
#[derive(Debug, Clone)]
pub(crate) struct Canvas {
    /// Width, px.
    pub(crate) width: f64,
    /// Height, px.
    pub(crate) height: f64,
    /// What is on it, later above earlier.
    pub(crate) elements: Vec<Element>,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self { width, height, elements: Vec::new() }
    }

    /// A filled polygon with an outline of the given colour.
    pub(crate) fn polygon(&mut self, points: &[(f64, f64)], fill: &str, stroke: &str, stroke_width: f64) {
        self.noted_polygon(points, fill, stroke, stroke_width, String::new());
    }

    /// A polygon (fill, outline and its width) that tells a pointer something.
    pub(crate) fn noted_polygon(
        &mut self,
        points: &[(f64, f64)],
        fill: &str,
        stroke: &str,
        stroke_width: f64,
        note: String,
    ) {
        let (fill, stroke) = (fill.to_owned(), stroke.to_owned());
        self.elements.push(Element::Polygon { points: points.to_vec(), fill, stroke, stroke_width, note });
    }

    pub(crate) fn rectangle(&mut self, x: f64, y: f64, width: f64, height: f64, fill: &str) {
        self.elements.push(Element::Rectangle { at: [x, y, width, height], fill: fill.to_owned() });
    }

    pub(crate) fn line(&mut self, from: (f64, f64), to: (f64, f64), stroke: &str, width: f64) {
        self.elements.push(Element::Line { from, to, stroke: stroke.to_owned(), width });
    }

    /// Text in the given size (px) with its baseline at the point.
    pub(crate) fn text(&mut self, at: (f64, f64), size: f64, anchor: Anchor, text: &str) {
        self.turned_text(at, size, anchor, 0.0, text);
    }

    /// Text turned by some degrees (clockwise) about its point.
    pub(crate) fn turned_text(
        &mut self,
        at: (f64, f64),
        size: f64,
        anchor: Anchor,
        turn_deg: f64,
        text: &str,
    ) {
        self.elements.push(Element::Text { at, size, anchor, turn_deg, text: text.to_owned() });
    }

    /// The whole as an SVG document.
    pub(crate) fn svg(&self) -> String {
        let (w, h) = (self.width, self.height);
        let body: String = self.elements.iter().map(Element::svg).collect();
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w:.0}\" height=\"{h:.0}\" viewBox=\"0 0 {w:.0} \
             {h:.0}\" font-family=\"{FONT}\" fill=\"#222222\">\n<rect width=\"100%\" height=\"100%\" \
             fill=\"#ffffff\"/>\n{body}</svg>\n"
        )
    }
}

impl Element {
    fn svg(&self) -> String {
        match self {
            Self::Polygon { points, fill, stroke, stroke_width, note } => {
                let list: Vec<String> = points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
                let list = list.join(" ");
                let end = if note.is_empty() {
                    "/>".to_owned()
                } else {
                    format!("><title>{}</title></polygon>", escaped(note))
                };
                format!(
                    "<polygon points=\"{list}\" fill=\"{fill}\" stroke=\"{stroke}\" \
                     stroke-width=\"{stroke_width}\" stroke-linejoin=\"round\"{end}\n"
                )
            }
            Self::Rectangle { at: [x, y, width, height], fill } => format!(
                "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" fill=\"{fill}\"/>\n"
            ),
            Self::Line { from, to, stroke, width } => format!(
                "<line x1=\"{:.2}\" y1=\"{:.2}\" x2=\"{:.2}\" y2=\"{:.2}\" stroke=\"{stroke}\" \
                 stroke-width=\"{width}\"/>\n",
                from.0, from.1, to.0, to.1
            ),
            Self::Text { at: (x, y), size, anchor, turn_deg, text } => {
                let anchor = match anchor {
                    Anchor::Start => "start",
                    Anchor::Middle => "middle",
                };
                let turn = if *turn_deg == 0.0 {
                    String::new()
                } else {
                    format!(" transform=\"rotate({turn_deg} {x:.2} {y:.2})\"")
                };
                let text = escaped(text);
                format!(
                    "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size}\" text-anchor=\"{anchor}\"{turn}>{text}</text>\n"
                )
            }
        }
    }
}

/// Text without the characters that mean something in XML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Round numbers that cover a range: about `count` ticks at steps of 1, 2 or 5 times a power of ten, inside it.
pub(crate) fn ticks(low: f64, high: f64, count: usize) -> Vec<f64> {
    let span = high - low;
    if !(span > 0.0 && span.is_finite()) {
        return vec![low];
    }
    let rough = span / count.max(1) as f64;
    let power = 10.0_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough).unwrap_or(rough);
    let first = (low / step - 1e-9).ceil();
    let mut values = Vec::new();
    let mut i = first;
    while i * step <= high + 1e-9 * span {
        values.push(i * step);
        i += 1.0;
    }
    values
}

/// Tick labels with just the decimals their step needs.
pub(crate) fn tick_labels(values: &[f64]) -> Vec<String> {
    let step = values.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
    let largest = values.iter().fold(0.0_f64, |a, v| a.max(v.abs()));
    if largest >= 1e5 || (largest > 0.0 && largest < 1e-3) {
        return values.iter().map(|v| format!("{v:.1e}")).collect();
    }
    let step = if step.is_finite() { step } else { largest.max(1.0) / 100.0 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0..9")]
    let decimals = (-(step * 1.0001).log10().floor()).clamp(0.0, 9.0) as usize;
    values.iter().map(|v| format!("{:.decimals$}", if *v == 0.0 { 0.0 } else { *v })).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(tick_labels(&ticks(0.83, 1.21, 4)), ["0.9", "1.0", "1.1", "1.2"]);
        assert_eq!(tick_labels(&ticks(-3.0, 3.0, 3)), ["-2", "0", "2"]);
        assert_eq!(tick_labels(&ticks(0.0, 0.004, 4)), ["0.000", "0.001", "0.002", "0.003", "0.004"]);
        assert_eq!(ticks(2.0, 2.0, 4), [2.0]);
    }

    #[test]
    fn text_cannot_break_the_document() {
        assert_eq!(escaped("a<b & \"c\""), "a&lt;b &amp; &quot;c&quot;");
    }
}
