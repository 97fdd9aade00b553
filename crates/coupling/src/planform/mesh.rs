//! Other lattices on the same planform.

use super::Planform;
use schemars::JsonSchema;
use serde::Deserialize;

/// A lattice on a planform.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// Boxes along the chord; the hinges must fall on box edges.
    pub chordwise: usize,
    /// Strips in each stretch of the span between edges of control surfaces, root to tip.
    pub strips: Vec<usize>,
    /// Strips of the fairing.
    pub fairing_strips: usize,
}

impl Planform {
    /// A mesh with a share of the boxes along the chord (or the next number with which hinges stay on edges) and of the strips.
    #[must_use]
    pub fn mesh(&self, chord_share: f64, span_share: f64) -> Mesh {
        let mut marks = vec![0, self.boxes.spanwise];
        for control in &self.controls {
            marks.extend([control.strips.0 - 1, control.strips.1]);
        }
        marks.sort_unstable();
        marks.dedup();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small positive numbers")]
        let times = |count: usize, share: f64| ((count as f64 * share).round() as usize).max(1);
        let strips = marks.windows(2).map(|ends| times(ends[1] - ends[0], span_share)).collect();
        let fits = |chordwise: &usize| {
            let whole = |boxes: usize| (boxes * chordwise).is_multiple_of(self.boxes.chordwise);
            self.controls.iter().all(|control| whole(control.chord_boxes))
        };
        let first = times(self.boxes.chordwise, chord_share);
        let chordwise = (first..=4 * first).find(fits).unwrap_or(self.boxes.chordwise);
        let fairing_strips = self.fairing.as_ref().map_or(1, |fairing| times(fairing.strips, span_share));
        Mesh { chordwise, strips, fairing_strips }
    }

    /// Puts another lattice on the planform; control surfaces keep their place.
    ///
    /// # Errors
    /// A sentence if the stretches do not match, a stretch has no strip, or a hinge would fall on no edge.
    pub fn remesh(&mut self, mesh: &Mesh) -> Result<(), String> {
        let edges_m = self.strip_edges_m();
        let of_controls = |first: usize, last: usize| [edges_m[first - 1], edges_m[last]];
        let mut marks_m = vec![0.0, self.semispan_m];
        marks_m
            .extend(self.controls.iter().flat_map(|control| of_controls(control.strips.0, control.strips.1)));
        marks_m.sort_by(f64::total_cmp);
        marks_m.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * self.semispan_m);
        if mesh.strips.len() + 1 != marks_m.len() || mesh.strips.contains(&0) {
            return Err(format!(
                "strips has {} numbers, expected {} above zero",
                mesh.strips.len(),
                marks_m.len() - 1
            ));
        }
        let mut fractions = vec![0.0];
        for (ends, &count) in marks_m.windows(2).zip(&mesh.strips) {
            let at = |i: usize| (ends[0] + (ends[1] - ends[0]) * i as f64 / count as f64) / self.semispan_m;
            fractions.extend((1..=count).map(at));
        }
        if let Some(last) = fractions.last_mut() {
            *last = 1.0;
        }
        let strip_at = |y_m: f64| fractions.iter().filter(|f| **f * self.semispan_m < y_m - 1e-9).count();
        for control in &mut self.controls {
            let [from_m, to_m] = of_controls(control.strips.0, control.strips.1);
            control.strips = (strip_at(from_m) + 1, strip_at(to_m));
            let boxes = control.chord_boxes * mesh.chordwise;
            if !boxes.is_multiple_of(self.boxes.chordwise) {
                return Err(format!(
                    "with {} boxes along the chord the hinge of {} is on no edge",
                    mesh.chordwise, control.name
                ));
            }
            control.chord_boxes = boxes / self.boxes.chordwise;
        }
        self.boxes.chordwise = mesh.chordwise;
        self.boxes.spanwise = fractions.len() - 1;
        self.boxes.strip_edges = Some(fractions);
        if let Some(fairing) = &mut self.fairing {
            fairing.strips = mesh.fairing_strips;
        }
        Ok(())
    }
}
