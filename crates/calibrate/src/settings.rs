//! Settings of a calibration.

use coupling::ByLoad;
use coupling::wing_file::CorrectionSettings;

/// What the user may choose; [`Settings::default`] is what the paper does, with our numbers where it gives none.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Weights of Fz, Mx and My in paper 1, Eq. 8 (1, 1, 1: newtons and newton metres are added).
    pub weights: ByLoad<f64>,
    /// Weight of the tip's height in paper 1, Eq. 8, on top of the rule that makes metres commensurable: a metre counts as
    /// the bending moment Mx (N m) that belongs to it by theory, the ratio of the uncorrected wing's derivatives by
    /// the angle of attack (summed over the airspeeds of a common set). A tip that is wrong by one per cent then
    /// counts as much as an Mx that is.
    pub tip_weight: f64,
    /// Chordwise strips of the polynomials.
    pub chord_strips: usize,
    /// Order of the polynomials in span.
    pub span_order: usize,
    /// Largest difference of chordwise neighbours (the paper does not print its own).
    pub neighbour_bound: f64,
    /// Least force and moment factor at any box.
    pub least_factor: f64,
    /// Weight of the change from theory, as a share of the objective for a change as large as the theoretical
    /// pressures themselves. On the shipped campaign the corrections are the same to three digits from 0.1 to 1, and
    /// the floor is reached all the same; below 0.01 the cone programs are too ill-conditioned to settle.
    pub change_weight: f64,
    /// Expected size of corrections, one standard deviation, relative to the theoretical pressures: the prior of the
    /// posterior spread.
    pub prior_spread: f64,
    /// Most cone programs an airspeed.
    pub most_cone_programs: usize,
    /// Most halvings of a step.
    pub most_halvings: usize,
    /// Probability below which nonlinearity is called significant, shared among all channels and airspeeds tested.
    pub significance: f64,
    /// Whether angles and airspeeds are left out in turn and predicted, which takes as many more fits: who asks for corrections alone
    /// does without.
    pub left_out: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            weights: ByLoad { fz: 1.0, mx: 1.0, my: 1.0 },
            tip_weight: 1.0,
            chord_strips: 12,
            span_order: 4,
            neighbour_bound: 0.05,
            least_factor: 0.05,
            change_weight: 1e-1,
            prior_spread: 0.3,
            most_cone_programs: 6,
            most_halvings: 8,
            significance: 0.01,
            left_out: true,
        }
    }
}

impl Settings {
    /// The settings a wing's file asks for, defaults elsewhere.
    pub fn of_wing(correction: &CorrectionSettings) -> Self {
        Self {
            chord_strips: correction.chord_strips,
            span_order: correction.span_order,
            neighbour_bound: correction.neighbour_bound,
            ..Self::default()
        }
    }

    /// The same for corrections alone: nothing is left out and predicted.
    pub fn for_corrections(correction: &CorrectionSettings) -> Self {
        Self { left_out: false, ..Self::of_wing(correction) }
    }
}
