//! Stability and control derivatives, rigid and elastic, and the neutral point.
//!
//! Coefficients: `CL = Fz/(q S)`, `CY = Fy/(q S)`, `Cl`, `Cn` over `q S b`, `Cm` over `q S c`, moments about the centre of gravity as
//! flight mechanics counts them (right wing down, nose up, nose right). Angles and deflections count per radian, rates as
//! `p b/(2V)`, `q c/(2V)`, `r b/(2V)`. c is the wings' mean aerodynamic chord.
//! Elastic, restrained: held at the wing's root, no inertia. Elastic, unrestrained: free, with inertia relief, angles counted from mean
//! axes:
//!
//! ```text
//! u = R F Rᵀ Gᵀ P,   R = 1 - r (rᵀ M r)⁻¹ rᵀ M,   R F Rᵀ = F - B C - Cᵀ Bᵀ + B E Bᵀ
//! B = r (rᵀ M r)⁻¹,  C = (M r)ᵀ F,  E = (M r)ᵀ F M r
//! ```
//! Neutral point: `x_np = x_cg - c Cm_alpha/CL_alpha`, the point about which the moment does not follow the angle of attack.
//! Source: MSC.Nastran Aeroelastic Analysis User's Guide, chapter 2 (restrained and unrestrained derivatives).

use crate::aircraft::assembly::Aircraft;
use crate::deck::trim::Elastic;
use crate::error::AircraftError;
use crate::trim::case::TrimTools;
use crate::trim::model::FlightModel;
use crate::trim::variables::{Acts, MOTIONS};
use coupling::{RigidInertia, SupportedStructure};
use faer::Mat;
use faer::linalg::solvers::Solve;
use schemars::JsonSchema;
use serde::Serialize;

/// Force and moment coefficients per unit of something.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Coefficients {
    /// Lift (up).
    #[serde(rename = "CL")]
    pub lift: f64,
    /// Side force (right).
    #[serde(rename = "CY")]
    pub side: f64,
    /// Rolling moment, right wing down.
    #[serde(rename = "Cl")]
    pub roll: f64,
    /// Pitching moment, nose up.
    #[serde(rename = "Cm")]
    pub pitch: f64,
    /// Yawing moment, nose right.
    #[serde(rename = "Cn")]
    pub yaw: f64,
}

/// What one variable does.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Derivative {
    /// `zero` (all variables zero: camber, twist, pressure offsets), `alpha`, `beta`, `roll_rate`, ..., `elevator`, ...
    pub variable: String,
    /// Not elastic.
    pub rigid: Coefficients,
    /// Elastic, held at the wing's root.
    pub restrained: Coefficients,
    /// Elastic, free.
    pub unrestrained: Coefficients,
}

/// All derivatives of a model at an airspeed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Derivatives {
    /// Airspeed.
    #[serde(rename = "V_m_s")]
    pub v_m_s: f64,
    /// S, both wings.
    pub area_m2: f64,
    /// b, from tip to tip.
    pub span_m: f64,
    /// c, mean aerodynamic chord.
    pub chord_m: f64,
    /// Centre of gravity.
    pub x_cg_m: f64,
    /// Neutral point: rigid, restrained, unrestrained.
    pub neutral_point_x_m: [f64; 3],
    /// Per variable.
    pub derivatives: Vec<Derivative>,
}

impl Aircraft {
    /// Span from tip to tip and mean aerodynamic chord of the wings (strips' chords weighed by their areas), m.
    pub fn reference_lengths_m(&self) -> (f64, f64) {
        let boxes = &self.flow.lattice.boxes;
        let tip_m = |place: &usize| {
            let panel = &boxes[*place];
            panel.corners.iter().map(|corner| corner.y.abs()).fold(0.0, f64::max)
        };
        let wings = || self.right.boxes.iter().chain(&self.left.boxes);
        let half_m = wings().map(tip_m).fold(0.0, f64::max);
        let mut moment = 0.0;
        let mut strips: Vec<(f64, f64, f64)> = Vec::new();
        for &at in wings() {
            let (y_m, chord_m) = (boxes[at].mid_point().y, boxes[at].chord_m());
            let area_m2 = self.flow.integration.area(at);
            match strips.last_mut().filter(|strip| (strip.0 - y_m).abs() < 1e-9) {
                Some(strip) => (strip.1, strip.2) = (strip.1 + chord_m, strip.2 + area_m2),
                None => strips.push((y_m, chord_m, area_m2)),
            }
        }
        for (_, chord_m, area_m2) in &strips {
            moment += chord_m * area_m2;
        }
        (2.0 * half_m, moment / self.wing_area_m2())
    }
}

impl FlightModel<'_> {
    /// Derivatives at an airspeed.
    ///
    /// # Errors
    /// If the aircraft diverges there.
    pub fn derivatives(&self, v_m_s: f64) -> Result<Derivatives, AircraftError> {
        let tools = TrimTools::new(self.aircraft, &[])?;
        let [rigid, restrained, unrestrained] = [
            self.sums(&tools, v_m_s, Elastic::Rigid)?,
            self.sums(&tools, v_m_s, Elastic::Restrained)?,
            self.sums(&tools, v_m_s, Elastic::Unrestrained)?,
        ];
        let (span_m, chord_m) = self.aircraft.reference_lengths_m();
        let area_m2 = self.aircraft.wing_area_m2();
        let q_pa = 0.5 * self.rho_kg_m3 * v_m_s * v_m_s;
        let of = |sums: &Mat<f64>, column: usize, per: f64| Coefficients {
            lift: sums[(2, column)] * per / (q_pa * area_m2),
            side: sums[(1, column)] * per / (q_pa * area_m2),
            roll: -sums[(3, column)] * per / (q_pa * area_m2 * span_m),
            pitch: sums[(4, column)] * per / (q_pa * area_m2 * chord_m),
            yaw: -sums[(5, column)] * per / (q_pa * area_m2 * span_m),
        };
        let row = |variable: &str, column: usize, per: f64| Derivative {
            variable: variable.to_owned(),
            rigid: of(&rigid, column, per),
            restrained: of(&restrained, column, per),
            unrestrained: of(&unrestrained, column, per),
        };
        let mut derivatives = vec![row("zero", 0, 1.0)];
        for (at, variable) in tools.variables.all.iter().enumerate() {
            let name = variable.name.trim_end_matches("_s").trim_end_matches("_deg");
            let length_m = if name == "pitch_rate" { chord_m } else { span_m };
            let per = match variable.acts {
                Acts::Flow(_) => 1.0 / variable.unit,
                Acts::Rate(_) => 2.0 * v_m_s / length_m / variable.unit,
                Acts::Force(_) => continue,
            };
            derivatives.push(row(name, 1 + at, per));
        }
        let x_cg_m = self.aircraft.file.total.x_cg_m;
        let alpha = &derivatives[1];
        let neutral = |c: Coefficients| x_cg_m - chord_m * c.pitch / c.lift;
        let neutral_point_x_m = [alpha.rigid, alpha.restrained, alpha.unrestrained].map(neutral);
        Ok(Derivatives { v_m_s, area_m2, span_m, chord_m, x_cg_m, neutral_point_x_m, derivatives })
    }

    /// Forces and moments about the centre of gravity per unit of each column, without inertia.
    fn sums(&self, tools: &TrimTools<'_>, v_m_s: f64, elastic: Elastic) -> Result<Mat<f64>, AircraftError> {
        let held = self.aircraft.held()?;
        let flow = aero::Flow { v_m_s, rho_kg_m3: self.rho_kg_m3 };
        let q_pa = flow.dynamic_pressure_pa();
        let all = tools.pressures(v_m_s);
        let cp = all.as_ref().subcols(0, all.ncols() - MOTIONS.len()).to_owned();
        let loads = self.loads(q_pa, cp.as_ref());
        let free;
        let structure = match elastic {
            Elastic::Rigid => return Ok(&tools.sums * loads),
            Elastic::Restrained => held,
            Elastic::Unrestrained => {
                free = in_mean_axes(held, &self.aircraft.inertia);
                &free
            }
        };
        let factor = self.aircraft.flow.factorise(structure, flow, &self.corrections)?;
        let u = factor.solve(&structure.flexibility * &structure.gather(loads.as_ref()));
        let cp = cp + self.aircraft.flow.pressures_by_displacement() * &u;
        Ok(&tools.sums * self.loads(q_pa, cp.as_ref()))
    }
}

/// The structure free in mean axes: its flexibility with inertia relief, wherever it is held.
fn in_mean_axes(held: &SupportedStructure, inertia: &RigidInertia) -> SupportedStructure {
    let b = inertia.mass.partial_piv_lu().solve(inertia.motions.transpose()).transpose().to_owned();
    let bc = &b * inertia.sag.transpose();
    let flexibility = &held.flexibility - &bc - bc.transpose() + &b * &inertia.work * b.transpose();
    SupportedStructure { flexibility, ..held.clone() }
}

impl Derivatives {
    /// The row of a variable.
    pub fn by(&self, variable: &str) -> Option<&Derivative> {
        self.derivatives.iter().find(|derivative| derivative.variable == variable)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn a_free_aircraft_bends_the_same_wherever_it_was_held_to_find_its_flexibility() {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex");
        let wing = data.join("wing_beam.ron");
        let aircraft =
            Aircraft::read(&data.join("aircraft.ron"), Some(&wing)).expect("shipped files are right");
        let bent = |node: usize| {
            let held = aircraft.free.clamped_at(node);
            let (held, inertia) = SupportedStructure::with_inertia(
                &held,
                &aircraft.spline,
                aircraft.right.tip,
                &aircraft.mass.centre,
            )
            .expect("it is held");
            (in_mean_axes(&held, &inertia).flexibility, held.flexibility)
        };
        let ((free, by_root), (other, by_tip)) = (bent(aircraft.centre), bent(aircraft.left.tip));
        let size = free.norm_max();
        assert!((&by_root - &by_tip).norm_max() > size, "held there or there it bends very differently");
        let apart = (&free - &other).norm_max();
        assert!(apart < 1e-8 * by_tip.norm_max(), "{apart} m/N beside {size} m/N");
    }
}
