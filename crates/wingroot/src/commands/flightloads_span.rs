//! Lift along the span of a wing in the tunnel, strip by strip.

use coupling::ElasticWing;

/// Lift along the half wing.
pub(super) struct SpanLift {
    /// Middles of the strips, 0 at the root, 1 at the tip.
    pub(super) places: Vec<f64>,
    /// Lift of a metre of span, N/m.
    pub(super) lift_n_m: Vec<f64>,
    /// Chords, m.
    pub(super) chord_m: Vec<f64>,
    /// The half span, m.
    pub(super) half_span_m: f64,
}

impl SpanLift {
    /// Of loads of all boxes, two a box.
    pub(super) fn of(wing: &ElasticWing, loads: &[f64]) -> Self {
        let boxes = &wing.correctable;
        let strips = boxes.strip.iter().max().map_or(0, |last| last + 1);
        let (mut lift, mut area) = (vec![0.0; strips], vec![0.0; strips]);
        let (mut places, mut width) = (vec![0.0; strips], vec![0.0; strips]);
        for (b, &at) in boxes.places.iter().enumerate() {
            let (strip, panel) = (boxes.strip[b], &wing.lattice.boxes[at]);
            lift[strip] += loads[2 * at] * panel.normal().z;
            area[strip] += panel.area_m2();
            places[strip] = boxes.y_norm[b];
            width[strip] = panel.width_m();
        }
        let each = |of: &[f64]| of.iter().zip(&width).map(|(value, width)| value / width).collect();
        Self { lift_n_m: each(&lift), chord_m: each(&area), half_span_m: width.iter().sum(), places }
    }

    /// Between the middles of strips, constant beyond them.
    pub(super) fn at(&self, values: &[f64], place: f64) -> f64 {
        let above = self.places.partition_point(|known| *known < place);
        if above == 0 || above == values.len() {
            return values[above.min(values.len() - 1)];
        }
        let share = (place - self.places[above - 1]) / (self.places[above] - self.places[above - 1]);
        values[above - 1] + share * (values[above] - values[above - 1])
    }
}
