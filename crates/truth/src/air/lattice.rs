//! Rings on a flat half wing beside a wall, and what they and the rows of the wake blow through its points.

use super::vortex::{Point, ring};
use super::wake::{Part, Rows};
use crate::wing::Planform;
use nalgebra::DMatrix;
use rayon::prelude::*;

/// How a wing is divided.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// Rings along the chord.
    pub chordwise: usize,
    /// Edges of the strips along the span, m; the wall first.
    pub edges_m: Vec<f64>,
    /// What the stream travels in a step, m.
    pub step_m: f64,
    /// Length of the wake before its endless last row, m.
    pub wake_m: f64,
}

/// A strip along the chord.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Its middle, m.
    pub y_m: f64,
    /// Its width, m.
    pub width_m: f64,
    /// Chord in the middle, m.
    pub chord_m: f64,
    /// Leading edge in the middle, m.
    pub leading_x_m: f64,
    /// Whether the balance carries it (the fairing is not carried).
    pub metric: bool,
}

impl Strip {
    /// Quarter point, m.
    pub fn quarter_x_m(&self) -> f64 {
        self.leading_x_m + 0.25 * self.chord_m
    }
}

/// See the module. Rings count from the leading edge, strip after strip.
#[derive(Debug, Clone)]
pub struct Lattice {
    /// Strips, from the wall to the tip.
    pub strips: Vec<Strip>,
    /// Rings along the chord.
    pub chordwise: usize,
    /// What the stream travels in a step, m.
    pub step_m: f64,
    /// Rows of the wake.
    pub rows: Rows,
    /// Points at which the flow must not cross, m, by ring.
    pub(crate) points_x_m: Vec<f64>,
    /// What readers read, by downwash at the points, where nothing is shed.
    read: DMatrix<f64>,
    /// Downwash at the points by what is just leaving the strips.
    pub(crate) present: DMatrix<f64>,
    /// Downwash at the points by the strips of every part of the wake's memory.
    pub(crate) wake: Vec<DMatrix<f64>>,
}

/// Where the wake begins behind the trailing edge, in lengths of a ring. Rings at rest are exact for a flat plate, yet their
/// points do not see how a vortex that is just leaving the edge draws circulation (as the inverse root of its distance). A
/// wake that begins an eighth of a ring early makes up for it: chosen once so that the lift of a slowly oscillating section
/// has Theodorsen's phase whatever the number of rings and the step; `tests/unsteady_air.rs` has what is left.
const SHED: f64 = -0.125;
/// Where the endless row ends, m.
const FAR_M: f64 = 1e6;

/// Corners and points of a mesh on an outline.
struct Drawn<'a> {
    planform: &'a Planform,
    mesh: &'a Mesh,
}

impl Drawn<'_> {
    /// A point of a ring's front line, or behind the trailing edge.
    fn corner(&self, y_m: f64, ring: usize, aft_m: f64) -> Point {
        let n = self.mesh.chordwise;
        let share = (ring as f64 + if ring == n { SHED } else { 0.25 }) / n as f64;
        [self.planform.x_m(y_m, share) + aft_m, y_m]
    }

    /// One quadrilateral a strip between two lines of rings, each so far aft.
    fn between(&self, (front, front_m): (usize, f64), (rear, rear_m): (usize, f64)) -> Vec<[Point; 4]> {
        let corners = |pair: &[f64]| {
            [
                self.corner(pair[0], front, front_m),
                self.corner(pair[1], front, front_m),
                self.corner(pair[1], rear, rear_m),
                self.corner(pair[0], rear, rear_m),
            ]
        };
        self.mesh.edges_m.windows(2).map(corners).collect()
    }

    /// Rings, strip after strip.
    fn rings(&self) -> Vec<[Point; 4]> {
        let n = self.mesh.chordwise;
        let rows: Vec<Vec<[Point; 4]>> = (0..n).map(|i| self.between((i, 0.0), (i + 1, 0.0))).collect();
        (0..rows[0].len() * n).map(|place| rows[place % n][place / n]).collect()
    }

    /// A stretch of the wake, in steps.
    fn behind(&self, from: f64, to: f64) -> Vec<[Point; 4]> {
        let n = self.mesh.chordwise;
        let to_m = if to.is_finite() { self.mesh.step_m * to } else { FAR_M };
        self.between((n, self.mesh.step_m * from), (n, to_m))
    }

    fn strips(&self) -> Vec<Strip> {
        let strip = |pair: &[f64]| {
            let y_m = 0.5 * (pair[0] + pair[1]);
            Strip {
                y_m,
                width_m: pair[1] - pair[0],
                chord_m: self.planform.chord_m(y_m),
                leading_x_m: self.planform.x_m(y_m, 0.0),
                metric: y_m > 0.0,
            }
        };
        self.mesh.edges_m.windows(2).map(strip).collect()
    }
}

impl Lattice {
    /// Divides a wing; the wall, at the first edge, is a plane of symmetry.
    pub fn new(planform: &Planform, mesh: &Mesh) -> Self {
        let (n, drawn) = (mesh.chordwise, Drawn { planform, mesh });
        let strips = drawn.strips();
        let point = |place: usize| {
            let y_m = strips[place / n].y_m;
            [planform.x_m(y_m, ((place % n) as f64 + 0.75) / n as f64), y_m]
        };
        let points: Vec<Point> = (0..strips.len() * n).map(point).collect();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousands")]
        let rows = Rows::until((mesh.wake_m / mesh.step_m).ceil() as usize);
        let blown = |rings: &[[Point; 4]]| downwash(&points, rings, mesh.edges_m[0]);
        let pieces: Vec<(usize, f64, DMatrix<f64>)> = Rows::pieces()
            .into_par_iter()
            .map(|(node, from, to, share)| (node, share, blown(&drawn.behind(from, to))))
            .collect();
        let node = |number: usize| {
            let mut sum = DMatrix::zeros(points.len(), strips.len());
            for (before, share, piece) in &pieces {
                match number.checked_sub(*before) {
                    Some(0) => sum += piece * (1.0 - share),
                    Some(1) => sum += piece * *share,
                    _ => {}
                }
            }
            sum
        };
        let part = |part: &Part| match part {
            Part::Node(number) => node(*number),
            Part::Mean(from, to) => blown(&drawn.behind(*from as f64, *to as f64)),
            Part::Endless(from) => blown(&drawn.behind(*from as f64, f64::INFINITY)),
        };
        let bound = blown(&drawn.rings());
        Self {
            read: solved_from_left(&bound, &readers(&strips, n)),
            present: node(0),
            wake: rows.parts().par_iter().map(part).collect(),
            points_x_m: points.iter().map(|point| point[0]).collect(),
            chordwise: n,
            step_m: mesh.step_m,
            strips,
            rows,
        }
    }

    /// Share of the chord of a ring's point.
    pub(crate) fn share(&self, ring: usize) -> f64 {
        ((ring % self.chordwise) as f64 + 0.75) / self.chordwise as f64
    }

    /// What readers read, by downwash at the points, if the downwash by the strips' last rings is another by `more`: columns
    /// of a matrix that are changed (Woodbury 1950). The readers' first rows are those last rings.
    pub(crate) fn read_with(&self, more: &DMatrix<f64>) -> DMatrix<f64> {
        let count = self.strips.len();
        let last = self.read.rows(0, count);
        let own = DMatrix::identity(count, count) + last * more;
        let changed = own.lu().solve(&last.into_owned());
        let changed = changed.unwrap_or_else(|| DMatrix::from_element(count, self.read.ncols(), f64::NAN));
        &self.read - (&self.read * more) * changed
    }
}

/// Rows that read the strips' circulation from the rings, which is the strength of their last ones, then the integrals over
/// the chord of the strength, and of the strength times the distance from the leading edge. The strength jumps at the quarter
/// of every ring's panel.
fn readers(strips: &[Strip], n: usize) -> DMatrix<f64> {
    let count = strips.len();
    let mut rows = DMatrix::zeros(3 * count, count * n);
    for (s, strip) in strips.iter().enumerate() {
        let panel_m = strip.chord_m / n as f64;
        rows[(s, s * n + n - 1)] = 1.0;
        for i in 0..n {
            let ring = s * n + i;
            // behind its own quarter point, and ahead of the next one's
            let own = (0.75 * panel_m, (i as f64 + 0.625) * panel_m);
            rows[(count + s, ring)] += own.0;
            rows[(2 * count + s, ring)] += own.0 * own.1;
            if i + 1 < n {
                let next = (0.25 * panel_m, (i as f64 + 1.125) * panel_m);
                rows[(count + s, ring)] += next.0;
                rows[(2 * count + s, ring)] += next.0 * next.1;
            }
        }
    }
    rows
}

/// `R A⁻¹`
fn solved_from_left(a: &DMatrix<f64>, r: &DMatrix<f64>) -> DMatrix<f64> {
    let solved = a.transpose().lu().solve(&r.transpose());
    solved.map_or_else(|| DMatrix::from_element(r.nrows(), a.nrows(), f64::NAN), |x| x.transpose())
}

/// Downwash at points by rings and by their images behind the wall.
fn downwash(points: &[Point], rings: &[[Point; 4]], wall_m: f64) -> DMatrix<f64> {
    DMatrix::from_fn(points.len(), rings.len(), |i, j| {
        let [x, y] = points[i];
        ring([x, y], &rings[j]) + ring([x, 2.0 * wall_m - y], &rings[j])
    })
}
