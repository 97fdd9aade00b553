//! What calibration needs of a wing: root loads and tip deflection of a steady case and their sensitivities.

use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use aero::{Corrections, Flow};
use faer::Mat;

/// A steady test point.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyCase {
    /// Airspeed and density.
    pub flow: Flow,
    /// Angle of attack of the balance, rad.
    pub alpha_rad: f64,
    /// Deflection of each control surface in the wing's order, trailing edge down, rad; missing ones are zero.
    pub controls_rad: Vec<f64>,
}

impl SteadyCase {
    /// A point with neutral controls.
    pub fn new(flow: Flow, alpha_rad: f64) -> Self {
        Self { flow, alpha_rad, controls_rad: Vec::new() }
    }
}

/// Root loads and tip deflection of one case and their derivatives by the corrections of each correctable box.
#[derive(Debug, Clone)]
pub struct RootSensitivity {
    /// The loads themselves.
    pub loads: RootLoads,
    /// Height of the tip above its wind-off place at alpha = 0, m; zero for a rigid wing.
    pub tip_z_m: f64,
    /// 4 by boxes: d(Fz, Mx, My, tip height)/d(force factor).
    pub by_force: Mat<f64>,
    /// 4 by boxes: d(Fz, Mx, My, tip height)/d(moment factor).
    pub by_moment: Mat<f64>,
    /// 4 by boxes: d(Fz, Mx, My, tip height)/d(pressure offset f_e/q).
    pub by_offset: Mat<f64>,
}

impl RootSensitivity {
    /// Fz, Mx, My (N, N m, N m) and the tip's height (m).
    pub fn readings(&self) -> [f64; 4] {
        let [fz, mx, my] = self.loads.to_array();
        [fz, mx, my, self.tip_z_m]
    }
}

/// The boxes corrections are found for, as a planform: where each stands chordwise and spanwise.
#[derive(Debug, Clone, PartialEq)]
pub struct CorrectableBoxes {
    /// Index of each correctable box in the lattice, chordwise first, then spanwise.
    pub places: Vec<usize>,
    /// Row of the box counted from the leading edge.
    pub chord_row: Vec<usize>,
    /// Number of rows of the box's panel.
    pub chord_rows: Vec<usize>,
    /// Strip of the box counted over all panels, from the first.
    pub strip: Vec<usize>,
    /// y_norm of paper 1, Eq. 9: distance from the root over the span, of the box midpoint, from 0 to 1.
    pub y_norm: Vec<f64>,
    /// Area of the box over the area of all correctable boxes.
    pub area_share: Vec<f64>,
    /// Area of all of them, m².
    pub area_m2: f64,
    /// Where they begin and end along y, m.
    pub ends_m: [f64; 2],
}

impl CorrectableBoxes {
    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// The first boxes of the two strips whose middles are on both sides of a place along the span, and their shares in what
    /// is between them; beyond the last middles the nearest strip alone.
    pub fn strips_at(&self, y_norm: f64) -> [(usize, f64); 2] {
        let mut strips: Vec<(f64, usize)> =
            (0..self.len()).filter(|&b| self.chord_row[b] == 0).map(|b| (self.y_norm[b], b)).collect();
        strips.sort_by(|a, b| a.0.total_cmp(&b.0));
        let next = strips.partition_point(|strip| strip.0 < y_norm).min(strips.len() - 1);
        let (before, after) = (strips[next.saturating_sub(1)], strips[next]);
        let apart = after.0 - before.0;
        let share = if apart > 0.0 { ((y_norm - before.0) / apart).clamp(0.0, 1.0) } else { 1.0 };
        [(before.1, 1.0 - share), (after.1, share)]
    }

    /// Extent along y, m.
    pub fn span_m(&self) -> f64 {
        self.ends_m[1] - self.ends_m[0]
    }

    /// Area over the span, m.
    pub fn mean_chord_m(&self) -> f64 {
        self.area_m2 / self.span_m()
    }

    /// True if there is nothing to correct.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }
}

/// Anything that gives root loads and their sensitivities in steady cases: the bare elastic wing, or a rig that
/// is the wing with effects. Corrections have one entry for each correctable box.
pub trait SteadyModel: Sync {
    /// The boxes corrections are found for.
    fn correctable(&self) -> &CorrectableBoxes;

    /// Root loads of cases that share a flow, in their order; by default taken from [`SteadyModel::sensitivities`], for models that have
    /// no cheaper way.
    ///
    /// # Errors
    /// If the flow is beyond divergence.
    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError> {
        Ok(self.sensitivities(cases, corrections)?.iter().map(|case| case.loads).collect())
    }

    /// Height of the tip above its wind-off place at alpha = 0 in cases that share a flow, m, in their order.
    ///
    /// # Errors
    /// If the flow is beyond divergence.
    fn tip_deflections(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<f64>, CouplingError> {
        Ok(self.sensitivities(cases, corrections)?.iter().map(|case| case.tip_z_m).collect())
    }

    /// Whether the model has a tip that can deflect: a rigid wing has none.
    fn has_tip(&self) -> bool {
        true
    }

    /// Whether deflections are large in the model.
    fn bends_far(&self) -> bool {
        false
    }

    /// A cheaper model that answers corrections nearly as this one does, if there is one: fits search on it, about readings and
    /// derivatives of this one.
    fn nearby(&self) -> Option<&dyn SteadyModel> {
        None
    }

    /// Root loads, tip deflection and derivatives of cases that share a flow, in their order.
    ///
    /// # Errors
    /// If the flow is beyond divergence.
    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError>;

    /// Theoretical pressure coefficients of the correctable boxes in a case, before any correction: the measure
    /// of "no change" (Giesing's minimum change).
    ///
    /// # Errors
    /// If the flow is beyond divergence.
    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError>;
}
