//! Zones of strips along the span, in which the air is changed as one.

use coupling::ElasticWing;
use faer::{Mat, MatRef};

/// Zones a wing is divided into (fewer if it has fewer strips): what varies smoothly along the span needs no more.
const ZONES: usize = 8;

/// See the module. One entry a zone, from the root outwards.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Zones {
    /// Boxes of the lattice.
    pub boxes: Vec<Vec<usize>>,
    /// Mean distance from the root over the span, from 0 to 1.
    pub y_norm: Vec<f64>,
    /// Mean y, m.
    pub y_m: Vec<f64>,
    /// Mean x of the quarter chord points of its boxes' strips, m.
    pub x_m: Vec<f64>,
    /// Mean chord, m.
    pub chord_m: Vec<f64>,
    /// Area, m².
    pub area_m2: Vec<f64>,
    /// Distance from the inner to the outer edge, m.
    pub width_m: Vec<f64>,
}

impl Zones {
    /// Divides the correctable strips of a wing.
    pub(crate) fn new(wing: &ElasticWing) -> Self {
        let correctable = &wing.correctable;
        let strips = correctable.strip.iter().max().map_or(0, |last| last + 1);
        let count = ZONES.min(strips);
        let mut zones = Self {
            boxes: vec![Vec::new(); count],
            y_norm: vec![0.0; count],
            y_m: vec![0.0; count],
            x_m: vec![0.0; count],
            chord_m: vec![0.0; count],
            area_m2: vec![0.0; count],
            width_m: vec![0.0; count],
        };
        let mut strips_of: Vec<Vec<usize>> = vec![Vec::new(); count];
        for (k, &j) in correctable.places.iter().enumerate() {
            let zone = correctable.strip[k] * count / strips;
            let panel = &wing.lattice.boxes[j];
            let area = panel.area_m2();
            zones.boxes[zone].push(j);
            zones.area_m2[zone] += area;
            zones.y_norm[zone] += area * correctable.y_norm[k];
            zones.y_m[zone] += area * panel.mid_point().y;
            zones.x_m[zone] += area * panel.mid_point().x;
            if !strips_of[zone].contains(&correctable.strip[k]) {
                strips_of[zone].push(correctable.strip[k]);
                zones.width_m[zone] += panel.width_m();
            }
        }
        for zone in 0..count {
            let area = zones.area_m2[zone].max(f64::MIN_POSITIVE);
            zones.y_norm[zone] /= area;
            zones.y_m[zone] /= area;
            zones.chord_m[zone] = area / zones.width_m[zone].max(f64::MIN_POSITIVE);
            // the boxes' middle is the strip's half chord; its quarter is a quarter further forward
            zones.x_m[zone] = zones.x_m[zone] / area - 0.25 * zones.chord_m[zone];
        }
        zones
    }

    /// Number of zones.
    pub fn len(&self) -> usize {
        self.boxes.len()
    }

    /// Whether there are none: no strip is correctable.
    pub fn is_empty(&self) -> bool {
        self.boxes.is_empty()
    }

    /// Weights of the two zones about a place along the span, 0 at the root to 1, straight beyond the outermost middles.
    pub(crate) fn about(&self, y_norm: f64) -> [(usize, f64); 2] {
        let right = self.y_norm.partition_point(|y| *y < y_norm).clamp(1, self.len().max(2) - 1);
        let left = right - 1;
        let Some((a, b)) = self.y_norm.get(left).zip(self.y_norm.get(right)) else {
            return [(0, 1.0), (0, 0.0)];
        };
        let share = (y_norm - a) / (b - a);
        [(left, 1.0 - share), (right, share)]
    }

    pub(crate) fn each(&self, of: impl Fn(&[usize]) -> Mat<f64>) -> Vec<Mat<f64>> {
        self.boxes.iter().map(|boxes| of(boxes)).collect()
    }

    /// The same with the zone's chord for every box.
    pub(crate) fn each_with_chord(
        &self,
        wing: &ElasticWing,
        of: impl Fn(&[usize], &[f64]) -> Mat<f64>,
    ) -> Vec<Mat<f64>> {
        let with = |zone: usize| {
            // of its own strip: boxes of one strip share their number of chord rows
            let rows = wing.correctable.chord_rows.first().copied().unwrap_or(1) as f64;
            let chords: Vec<f64> =
                self.boxes[zone].iter().map(|&j| rows * wing.lattice.boxes[j].chord_m()).collect();
            of(&self.boxes[zone], &chords)
        };
        (0..self.len()).map(with).collect()
    }

    /// Lift of each zone, N: rows by the columns of the box loads.
    pub(crate) fn lift(&self, wing: &ElasticWing, box_loads: MatRef<'_, f64>) -> Mat<f64> {
        let normal = |j: usize| wing.lattice.boxes[j].normal().z;
        Mat::from_fn(self.len(), box_loads.ncols(), |zone, column| {
            self.boxes[zone].iter().map(|&j| normal(j) * box_loads[(2 * j, column)]).sum()
        })
    }

    /// Height of each zone by modes: mean of its boxes, weighted with their area.
    pub(crate) fn heights(&self, wing: &ElasticWing, motion: MatRef<'_, f64>) -> Mat<f64> {
        self.mean(wing, motion, 0)
    }

    /// Twist of each zone by modes, nose up, rad: mean of its boxes.
    pub(crate) fn twists(&self, wing: &ElasticWing, motion: MatRef<'_, f64>) -> Mat<f64> {
        self.mean(wing, motion, 1)
    }

    /// Mean of one of the two motions of a box.
    fn mean(&self, wing: &ElasticWing, motion: MatRef<'_, f64>, of: usize) -> Mat<f64> {
        Mat::from_fn(self.len(), motion.ncols(), |zone, mode| {
            let boxes = self.boxes[zone].iter();
            let sum: f64 = boxes.map(|&j| wing.lattice.boxes[j].area_m2() * motion[(2 * j + of, mode)]).sum();
            sum / self.area_m2[zone]
        })
    }
}
