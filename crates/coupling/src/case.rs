//! What calibration needs of a wing: root loads of a steady case and their sensitivities.

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

/// Root loads of one case and their derivatives by the corrections of each correctable box.
#[derive(Debug, Clone)]
pub struct RootSensitivity {
    /// The loads themselves.
    pub loads: RootLoads,
    /// 3 by boxes: d(Fz, Mx, My)/d(force factor).
    pub by_force: Mat<f64>,
    /// 3 by boxes: d(Fz, Mx, My)/d(moment factor).
    pub by_moment: Mat<f64>,
    /// 3 by boxes: d(Fz, Mx, My)/d(pressure offset f_e/q).
    pub by_offset: Mat<f64>,
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
    /// y_norm of Eq. 9: distance from the root over the span, of the box midpoint, from 0 to 1.
    pub y_norm: Vec<f64>,
    /// Area of the box over the area of all correctable boxes.
    pub area_share: Vec<f64>,
}

impl CorrectableBoxes {
    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.places.len()
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

    /// Root loads of cases that share a flow, in their order.
    ///
    /// # Errors
    /// If the flow is beyond divergence.
    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError>;

    /// Root loads and derivatives of cases that share a flow, in their order.
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
