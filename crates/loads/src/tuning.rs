//! The gradient that a discrete gust loads worst with: the largest of those that were flown, a step between them, and a warning where the
//! worst is at an end of the range.

use schemars::JsonSchema;
use serde::Serialize;

/// Where the worst gradient is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub enum Tuned {
    /// Within the range.
    #[serde(rename = "yes")]
    Inside,
    /// At its short end: shorter gusts may load more.
    #[serde(rename = "at the shortest")]
    AtShortest,
    /// At its long end: longer gusts may load more.
    #[serde(rename = "at the longest")]
    AtLongest,
}

impl Tuned {
    /// What to say about a load whose worst gradient is at an end.
    pub fn warning(self, load: &str, gradient_m: f64) -> Option<String> {
        let end = match self {
            Self::Inside => return None,
            Self::AtShortest => "shorter",
            Self::AtLongest => "longer",
        };
        Some(format!(
            "{load} is largest at H {gradient_m:.1} m, the range's end: not tuned, {end} gusts may load more"
        ))
    }
}

/// The worst of some gradients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// Its place among them.
    pub place: usize,
    /// Where it is.
    pub tuned: Tuned,
    /// A gradient to fly next, m, if the worst is inside: the top of the parabola through it and its neighbours, over the logarithm.
    pub next_m: Option<f64>,
}

/// The worst of gradients, m, in rising order, by the sizes of a load (what is to be largest); none of none.
pub fn worst(gradients_m: &[f64], sizes: &[f64]) -> Option<Worst> {
    let count = gradients_m.len().min(sizes.len());
    let place = (0..count).reduce(|best, at| if sizes[at] > sizes[best] { at } else { best })?;
    let tuned = match place {
        0 => Tuned::AtShortest,
        _ if place + 1 == count => Tuned::AtLongest,
        _ => Tuned::Inside,
    };
    let next_m = (tuned == Tuned::Inside).then(|| {
        let x = [place - 1, place, place + 1].map(|at| gradients_m[at].ln());
        let y = [place - 1, place, place + 1].map(|at| sizes[at]);
        top(x, y).exp()
    });
    Some(Worst { place, tuned, next_m })
}

/// Where the parabola through three points is largest; the middle one is not below the others.
fn top(x: [f64; 3], y: [f64; 3]) -> f64 {
    let (left, right) = (x[1] - x[0], x[2] - x[1]);
    let (down, up) = ((y[1] - y[0]) * right, (y[1] - y[2]) * left);
    if down + up <= 0.0 {
        return x[1];
    }
    // (y1 - y0) and (y1 - y2) by the spacings: the slope vanishes between the middles of both sides.
    x[1] + (down * right - up * left) / (2.0 * (down + up))
}
