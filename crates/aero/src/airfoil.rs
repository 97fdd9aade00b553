//! Airfoil coordinates (Selig's and Lednicer's `.dat`) and the camber line they imply.
//!
//! The contour is one cubic spline z(t) from the upper trailing edge through the nose to the lower one, over
//! t = -sqrt(x) on the upper and +sqrt(x) on the lower surface: a rounded nose is smooth in t, not in x. The camber
//! line is the mean of both surfaces at equal x.

use nastran::{InputError, Span, read_text};
use std::path::Path;
use std::sync::Arc;

/// An airfoil's contour, chord 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Airfoil {
    /// First line of the file.
    pub name: String,
    t: Vec<f64>,
    z: Vec<f64>,
    curvature: Vec<f64>,
}

/// One coordinate pair with its line.
type Pair = (f64, f64, usize);

impl Airfoil {
    /// Reads a `.dat` file.
    ///
    /// # Errors
    /// If the file cannot be read, or as [`Airfoil::parse`].
    pub fn read(path: &Path) -> Result<Self, InputError> {
        Self::parse(&path.display().to_string(), &read_text(path)?)
    }

    /// The airfoil of a `.dat` file's text; `name` is the file as the user named it.
    ///
    /// Selig's order runs from the trailing edge over the upper surface to the nose and back. Lednicer's gives
    /// the numbers of points first, then both surfaces from the nose.
    ///
    /// # Errors
    /// If a line is not two finite numbers, there are too few points, or x does not rise and fall once.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        let file = Arc::new(Path::new(name).to_path_buf());
        let mut lines = text.lines();
        let title = lines.next().unwrap_or_default().trim().to_owned();
        let mut pairs = Vec::new();
        for (index, line) in lines.enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            pairs.push(pair(line, &Span::new(&file, index + 2, 0, 0))?);
        }
        let whole = |message: &str| {
            InputError::in_file(&file, message)
                .with_help("a title line, then x z pairs in Selig's or Lednicer's order, chord 1")
        };
        let contour = match pairs.first() {
            Some(&(upper, lower, _)) if upper > 1.5 && lower > 1.5 => lednicer(&pairs[1..], upper, lower)
                .ok_or_else(|| whole("the numbers of points do not fit the points"))?,
            _ => pairs,
        };
        if contour.len() < 7 {
            return Err(whole("an airfoil needs at least 7 points"));
        }
        Self::from_contour(title, &contour, &file)
    }

    /// Contour points in Selig's order to the spline over t.
    fn from_contour(
        name: String,
        contour: &[Pair],
        file: &Arc<std::path::PathBuf>,
    ) -> Result<Self, InputError> {
        let low = contour.iter().map(|p| p.0).fold(f64::INFINITY, f64::min);
        let high = contour.iter().map(|p| p.0).fold(f64::NEG_INFINITY, f64::max);
        let nose = contour.iter().position(|p| p.0 == low).unwrap_or(0);
        let (mut t, mut z): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for (i, point) in contour.iter().enumerate() {
            let root = ((point.0 - low) / (high - low)).sqrt();
            let here = if i < nose { -root } else { root };
            if !here.is_finite() || t.last().is_some_and(|before| *before >= here) {
                return Err(InputError::at(
                    &Span::new(file, point.2, 0, 0),
                    "x must fall to the nose once and then rise to the trailing edge",
                )
                .with_help(
                    "Selig's order: upper surface from the trailing edge to the nose, then the lower one",
                ));
            }
            t.push(here);
            z.push(point.1 / (high - low));
        }
        if t[0] > -0.99 || t[t.len() - 1] < 0.99 {
            return Err(InputError::in_file(
                file,
                "a surface does not reach from the nose to the trailing edge",
            ));
        }
        let curvature = second_derivatives(&t, &z);
        Ok(Self { name, t, z, curvature })
    }

    /// Height of the camber line over the chord at `x_over_c` (clamped to 0..1).
    pub fn camber(&self, x_over_c: f64) -> f64 {
        let root = x_over_c.clamp(0.0, 1.0).sqrt();
        f64::midpoint(self.at(-root).0, self.at(root).0)
    }

    /// Slope dz/dx of the camber line at `x_over_c` (kept between 1e-6 and 1: at the nose it may be infinite).
    pub fn camber_slope(&self, x_over_c: f64) -> f64 {
        let root = x_over_c.clamp(1e-6, 1.0).sqrt();
        // dz/dx = dz/dt dt/dx with dt/dx = +-1/(2 sqrt(x))
        (self.at(root).1 - self.at(-root).1) / (4.0 * root)
    }

    /// Thickness over the chord at `x_over_c` (clamped to 0..1).
    pub fn thickness(&self, x_over_c: f64) -> f64 {
        let root = x_over_c.clamp(0.0, 1.0).sqrt();
        self.at(-root).0 - self.at(root).0
    }

    /// z and dz/dt of the spline.
    fn at(&self, t: f64) -> (f64, f64) {
        let last = self.t.len() - 2;
        let i = self.t.partition_point(|knot| *knot <= t).saturating_sub(1).min(last);
        let h = self.t[i + 1] - self.t[i];
        let (a, b) = ((self.t[i + 1] - t) / h, (t - self.t[i]) / h);
        let (m0, m1) = (self.curvature[i], self.curvature[i + 1]);
        let z =
            a * self.z[i] + b * self.z[i + 1] + ((a * a * a - a) * m0 + (b * b * b - b) * m1) * h * h / 6.0;
        let slope =
            (self.z[i + 1] - self.z[i]) / h + ((3.0 * b * b - 1.0) * m1 - (3.0 * a * a - 1.0) * m0) * h / 6.0;
        (z, slope)
    }
}

fn pair(line: &str, span: &Span) -> Result<Pair, InputError> {
    let mut numbers = line.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty());
    let mut next =
        || numbers.next().and_then(|word| word.parse::<f64>().ok()).filter(|value| value.is_finite());
    match (next(), next()) {
        (Some(x), Some(z)) => Ok((x, z, span.line)),
        _ => Err(InputError::at(span, format!("\"{}\" is not a pair of numbers x z", line.trim()))
            .with_help("a title line, then x z pairs in Selig's or Lednicer's order, chord 1")),
    }
}

/// Lednicer's two lists as one contour in Selig's order; `None` if the counts do not fit.
fn lednicer(points: &[Pair], upper: f64, lower: f64) -> Option<Vec<Pair>> {
    let count = |value: f64| (1..=points.len()).find(|n| *n as f64 == value);
    let (upper, lower) = (count(upper)?, count(lower)?);
    if upper + lower != points.len() {
        return None;
    }
    let nose_is_shared = points[0].0 == points[upper].0 && points[0].1 == points[upper].1;
    let lower = &points[upper + usize::from(nose_is_shared)..];
    Some(points[..upper].iter().rev().chain(lower).copied().collect())
}

/// Second derivatives of the cubic spline with the third derivative continuous next to the ends ("not a knot").
fn second_derivatives(t: &[f64], z: &[f64]) -> Vec<f64> {
    let n = t.len();
    let h: Vec<f64> = t.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let rise: Vec<f64> = z.windows(2).zip(&h).map(|(pair, h)| (pair[1] - pair[0]) / h).collect();
    // Rows 1..n-1 of the tridiagonal system; the end values are eliminated by the end condition.
    let (mut lower, mut main, mut upper, mut right) =
        (vec![0.0; n], vec![1.0; n], vec![0.0; n], vec![0.0; n]);
    for i in 1..n - 1 {
        (lower[i], main[i], upper[i]) = (h[i - 1], 2.0 * (h[i - 1] + h[i]), h[i]);
        right[i] = 6.0 * (rise[i] - rise[i - 1]);
    }
    let first = h[0] / h[1];
    main[1] += lower[1] * (1.0 + first);
    upper[1] -= lower[1] * first;
    let last = h[n - 2] / h[n - 3];
    main[n - 2] += upper[n - 2] * (1.0 + last);
    lower[n - 2] -= upper[n - 2] * last;
    for i in 2..n - 1 {
        let factor = lower[i] / main[i - 1];
        main[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    let mut m = vec![0.0; n];
    m[n - 2] = right[n - 2] / main[n - 2];
    for i in (1..n - 2).rev() {
        m[i] = (right[i] - upper[i] * m[i + 1]) / main[i];
    }
    m[0] = m[1] + first * (m[1] - m[2]);
    m[n - 1] = m[n - 2] + last * (m[n - 2] - m[n - 3]);
    m
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uneven, from the upper trailing edge through the nose to the lower one.
    const KNOTS: [f64; 8] = [-1.0, -0.83, -0.55, -0.2, 0.0, 0.31, 0.72, 1.0];

    fn through(z: impl Fn(f64) -> f64) -> Airfoil {
        let (t, z): (Vec<f64>, Vec<f64>) = KNOTS.iter().map(|t| (*t, z(*t))).unzip();
        let curvature = second_derivatives(&t, &z);
        Airfoil { name: String::new(), t, z, curvature }
    }

    fn assert_near(got: f64, want: f64, what: &str) {
        assert!((got - want).abs() < 1e-11, "{what}: {got} instead of {want}");
    }

    /// A cubic has one third derivative everywhere, as next to the ends the spline has; of its powers of t
    /// the even ones are camber and the odd ones half the thickness.
    #[test]
    fn a_cubic_comes_back_with_its_slope_camber_and_thickness() {
        let airfoil = through(|t| 0.3 - 0.7 * t + 1.1 * t * t + 0.9 * t * t * t);
        for (t, m) in airfoil.t.iter().zip(&airfoil.curvature) {
            assert_near(*m, 2.2 + 5.4 * t, "second derivative");
        }
        for i in 0..=40 {
            let t = f64::from(i) / 20.0 - 1.0;
            let (z, slope) = airfoil.at(t);
            assert_near(z, 0.3 - 0.7 * t + 1.1 * t * t + 0.9 * t * t * t, "z");
            assert_near(slope, -0.7 + 2.2 * t + 2.7 * t * t, "slope");
            let x = t * t;
            assert_near(airfoil.camber(x), 0.3 + 1.1 * x, "camber");
            assert_near(airfoil.camber_slope(x), 1.1, "slope of the camber line");
            assert_near(airfoil.thickness(x), 1.4 * t.abs() - 1.8 * t.abs().powi(3), "thickness");
        }
        assert_near(airfoil.camber(-0.5), 0.3, "camber ahead of the nose");
        assert_near(airfoil.thickness(1.5), -0.4, "thickness behind the trailing edge");
        assert_near(airfoil.camber(1.5), 1.4, "camber behind the trailing edge");
        assert!(airfoil.thickness(0.0).abs() < 1e-15, "both surfaces meet at the nose");
    }

    /// These conditions have one solution only: values, slopes continuous at all knots, third derivatives
    /// next to the ends.
    #[test]
    fn a_spline_goes_through_its_points_without_a_bend_and_ends_in_one_cubic() {
        let airfoil = through(|t| (5.0 * t + 0.4).sin());
        let (t, m) = (&airfoil.t, &airfoil.curvature);
        for (knot, z) in t.iter().zip(&airfoil.z) {
            assert_near(airfoil.at(*knot).0, *z, "value at a knot");
        }
        for knot in &t[1..t.len() - 1] {
            let (before, here) = (airfoil.at(knot - 1e-10), airfoil.at(*knot));
            assert!((before.1 - here.1).abs() < 1e-7 && (before.0 - here.0).abs() < 1e-8, "a bend at {knot}");
        }
        let third = |i: usize| (m[i + 1] - m[i]) / (t[i + 1] - t[i]);
        let last = t.len() - 2;
        for (a, b) in [(third(0), third(1)), (third(last), third(last - 1))] {
            assert!((a - b).abs() < 1e-9 * b.abs(), "third derivatives {a} and {b}");
        }
        assert!((third(1) - third(2)).abs() > 1.0, "they are those of no single cubic");
    }
}
