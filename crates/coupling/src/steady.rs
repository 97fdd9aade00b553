//! The steady elastic wing (design equations of ARCHITECTURE.md; paper 1, Eqs. 4 to 7).
//!
//! ```text
//! u = F Gᵀ P + sag(alpha),   P = q W S (Q D G u + cp_0(alpha)) + q S f_e
//! (I - q F Gᵀ W S Q D G) u = F Gᵀ P_0 + sag(alpha)
//! root loads = R P + weight(alpha) - weight(0)
//! ```
//! `P_0` are the loads of the undeformed wing. The tare takes the weight out at alpha = 0, but not the sag.

use crate::case::{CorrectableBoxes, RootSensitivity, SteadyCase, SteadyModel};
use crate::error::CouplingError;
use crate::root_loads::RootLoads;
use crate::supported::SupportedStructure;
use crate::wing::ElasticWing;
use aero::{BoxLoads, Corrections, Flow, LoadOperator};
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatRef};
use nalgebra::Vector3;

/// A wing in one steady case.
#[derive(Debug, Clone)]
pub struct SteadyState {
    /// Displacement of the s-set (empty for a rigid wing), m and rad.
    pub displacement: Vec<f64>,
    /// Uncorrected pressure coefficients on the deformed wing, one a box.
    pub cp: Vec<f64>,
    /// Corrected box loads, two a box.
    pub box_loads: BoxLoads,
    /// What the balance feels.
    pub root: RootLoads,
    /// Height of the tip above its wind-off place at alpha = 0, m.
    pub tip_z_m: f64,
}

/// A wing with corrections at one flow: factorised once, solved for many cases.
#[derive(Debug)]
pub struct SteadyOperator<'a> {
    pub(crate) wing: &'a ElasticWing,
    pub(crate) flow: Flow,
    corrections: Corrections,
    pub(crate) factor: Option<PartialPivLu<f64>>,
}

impl ElasticWing {
    /// The wing at a flow with corrections (one entry for each correctable box).
    ///
    /// # Errors
    /// If the dynamic pressure is at or beyond divergence, or the corrections have the wrong length.
    pub fn at(&self, flow: Flow, corrections: &Corrections) -> Result<SteadyOperator<'_>, CouplingError> {
        let corrections = self.padded(corrections)?;
        let factor = match &self.supported {
            None => None,
            Some(structure) => Some(self.factorise(structure, flow, &corrections)?),
        };
        Ok(SteadyOperator { wing: self, flow, corrections, factor })
    }

    /// Gravity in balance axes, m/s^2: g sin(alpha) aft, g cos(alpha) down.
    pub(crate) fn gravity_at(&self, alpha_rad: f64) -> Vector3<f64> {
        let g = self.gravity_m_s2;
        Vector3::new(g * alpha_rad.sin(), 0.0, -g * alpha_rad.cos())
    }

    /// H = Gᵀ W S Q D G: loads on the s-set per unit displacement and dynamic pressure.
    pub(crate) fn aerodynamic_stiffness(
        &self,
        structure: &SupportedStructure,
        corrections: &Corrections,
    ) -> Mat<f64> {
        let loads = self.integration.corrected(corrections).of_pressures(1.0, self.cp_displacement.as_ref());
        structure.gather(loads.as_ref())
    }

    /// `I - q F H` factorised (s by s) for corrections of the whole lattice: what turns the displacement of the
    /// undeformed loads into that of the deformed wing.
    ///
    /// # Errors
    /// If the dynamic pressure is at or beyond divergence.
    pub fn factorise(
        &self,
        structure: &SupportedStructure,
        flow: Flow,
        corrections: &Corrections,
    ) -> Result<PartialPivLu<f64>, CouplingError> {
        let q_pa = flow.dynamic_pressure_pa();
        let loop_gain = &structure.flexibility * &self.aerodynamic_stiffness(structure, corrections);
        let size = structure.size();
        let matrix = Mat::from_fn(size, size, |i, j| f64::from(u8::from(i == j)) - q_pa * loop_gain[(i, j)]);
        let factor = matrix.partial_piv_lu();
        // det(I - q F H) starts at one and changes its sign at the first divergence pressure.
        let negative = (0..size).filter(|&i| factor.U()[(i, i)] <= 0.0).count();
        let odd = factor.P().arrays().0.to_vec();
        if (negative + usize::from(permutation_is_odd(&odd))) % 2 == 1 {
            return Err(CouplingError::Diverged {
                q_pa,
                divergence_pa: self.divergence_pressure(corrections)?,
            });
        }
        Ok(factor)
    }
}

impl SteadyOperator<'_> {
    /// Solves cases; their flow is this operator's.
    pub fn solve(&self, cases: &[SteadyCase]) -> Vec<SteadyState> {
        let (wing, q_pa) = (self.wing, self.flow.dynamic_pressure_pa());
        let mut cp = self.rigid_pressures(cases);
        let displacement = match (&wing.supported, &self.factor) {
            (Some(structure), Some(factor)) => {
                let mut loads = self.loads().of_pressures(q_pa, cp.as_ref());
                (0..cases.len()).for_each(|column| self.loads().add_offset(q_pa, &mut loads, column));
                let mut u = &structure.flexibility * &structure.gather(loads.as_ref());
                for (column, case) in cases.iter().enumerate() {
                    let field = self.gravity_field(case.alpha_rad);
                    for row in 0..u.nrows() {
                        u[(row, column)] +=
                            (0..3).map(|axis| structure.sag[(row, axis)] * field[axis]).sum::<f64>();
                    }
                }
                let u = factor.solve(&u);
                cp += &wing.cp_displacement * &u;
                u
            }
            _ => Mat::zeros(0, cases.len()),
        };
        let columns = cases.iter().enumerate();
        columns
            .map(|(column, case)| {
                self.state(case, cp.col_as_slice(column), displacement.col_as_slice(column).to_vec())
            })
            .collect()
    }

    /// Root loads, tip deflection and derivatives: with Lambda of [`Self::adjoint`] (4 rows, the same for all
    /// angles), `dr/dW_m = Lambda_m (q S cp)_m` and `dr/df_e = q Lambda S`.
    pub fn sensitivities(&self, cases: &[SteadyCase]) -> Vec<RootSensitivity> {
        let (wing, q_pa) = (self.wing, self.flow.dynamic_pressure_pa());
        let lambda = self.adjoint();
        self.solve(cases)
            .into_iter()
            .map(|state| {
                let places = &wing.correctable.places;
                let by = self.loads().derivatives(q_pa, lambda.as_ref(), &state.cp, places);
                RootSensitivity {
                    loads: state.root,
                    tip_z_m: state.tip_z_m,
                    by_force: by.by_force,
                    by_moment: by.by_moment,
                    by_offset: by.by_offset,
                }
            })
            .collect()
    }

    /// Lambda, 4 by 2 a box: root loads (Fz, Mx, My) and height of the tip per unit box load, the wing's answer to
    /// that load included.
    ///
    /// ```text
    /// root:  R + R q W S Q D G (I - q F H)⁻¹ F Gᵀ     tip:  e_tipᵀ (I - q F H)⁻¹ F Gᵀ
    /// ```
    /// A rigid wing's tip has a row of zeros.
    pub fn adjoint(&self) -> Mat<f64> {
        match &self.wing.supported {
            Some(structure) => {
                let tip = Mat::from_fn(1, structure.size(), |_, i| f64::from(u8::from(i == structure.tip_z)));
                self.adjoint_of(self.wing.root_rows.as_ref(), tip.as_ref())
            }
            None => self.adjoint_of(self.wing.root_rows.as_ref(), Mat::zeros(1, 0).as_ref()),
        }
    }

    /// The same for any rows on the box loads in the place of R, and any on the displacement of the structure in the place
    /// of the tip's, behind them.
    pub(crate) fn adjoint_of(&self, on_loads: MatRef<'_, f64>, on_structure: MatRef<'_, f64>) -> Mat<f64> {
        let (wing, count) = (self.wing, on_loads.nrows());
        let direct = |row: usize, column: usize| if row < count { on_loads[(row, column)] } else { 0.0 };
        let (Some(structure), Some(factor)) = (&wing.supported, &self.factor) else {
            return Mat::from_fn(count + on_structure.nrows(), on_loads.ncols(), direct);
        };
        let q_pa = self.flow.dynamic_pressure_pa();
        let loads = self.loads().of_pressures(q_pa, wing.cp_displacement.as_ref());
        let of = |by_displacement: MatRef<'_, f64>| {
            structure.flexibility.transpose()
                * &factor.solve_transpose(by_displacement.transpose().to_owned())
        };
        let (by_loads, by_structure) = (of((on_loads * &loads).as_ref()), of(on_structure));
        Mat::from_fn(count + on_structure.nrows(), on_loads.ncols(), |row, column| {
            let by_load = |dof: usize| {
                if row < count { by_loads[(dof, row)] } else { by_structure[(dof, row - count)] }
            };
            let elastic: f64 =
                structure.spline_rows[column].iter().map(|&(dof, value)| value * by_load(dof)).sum();
            direct(row, column) + elastic
        })
    }

    /// Pressures of the undeformed wing: angle of attack, camber and controls.
    fn rigid_pressures(&self, cases: &[SteadyCase]) -> Mat<f64> {
        let wing = self.wing;
        Mat::from_fn(wing.lattice.len(), cases.len(), |j, column| {
            let case = &cases[column];
            let controls = case.controls_rad.iter().enumerate().take(wing.controls.len());
            wing.cp_alpha[(j, 0)] * case.alpha_rad
                + wing.cp_camber[(j, 0)]
                + controls.map(|(i, delta)| wing.cp_controls[(j, i)] * delta).sum::<f64>()
        })
    }

    /// Eq. 7 of paper 1, with this operator's corrections.
    pub(crate) fn loads(&self) -> LoadOperator<'_> {
        self.wing.integration.corrected(&self.corrections)
    }

    /// [`ElasticWing::gravity_at`].
    pub(crate) fn gravity_field(&self, alpha_rad: f64) -> Vector3<f64> {
        self.wing.gravity_at(alpha_rad)
    }

    fn state(&self, case: &SteadyCase, cp: &[f64], displacement: Vec<f64>) -> SteadyState {
        let wing = self.wing;
        let box_loads = self.loads().box_loads(self.flow.dynamic_pressure_pa(), cp);
        let mut root: [f64; 3] = std::array::from_fn(|row| {
            box_loads.values.iter().enumerate().map(|(k, load)| wing.root_rows[(row, k)] * load).sum()
        });
        let mut tip_z_m = 0.0;
        if let Some(structure) = &wing.supported {
            let (field, tare) = (self.gravity_field(case.alpha_rad), self.gravity_field(0.0));
            for (row, load) in root.iter_mut().enumerate() {
                *load += (0..3)
                    .map(|axis| structure.weight[(row, axis)] * (field[axis] - tare[axis]))
                    .sum::<f64>();
            }
            let wind_off: f64 = (0..3).map(|axis| structure.sag[(structure.tip_z, axis)] * tare[axis]).sum();
            tip_z_m = displacement[structure.tip_z] - wind_off;
        }
        SteadyState { cp: cp.to_vec(), box_loads, root: RootLoads::from_array(root), displacement, tip_z_m }
    }
}

impl SteadyModel for ElasticWing {
    fn correctable(&self) -> &CorrectableBoxes {
        &self.correctable
    }

    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError> {
        let Some(first) = cases.first() else { return Ok(Vec::new()) };
        Ok(self.at(first.flow, corrections)?.solve(cases).into_iter().map(|state| state.root).collect())
    }

    fn tip_deflections(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<f64>, CouplingError> {
        let Some(first) = cases.first() else { return Ok(Vec::new()) };
        Ok(self.at(first.flow, corrections)?.solve(cases).into_iter().map(|state| state.tip_z_m).collect())
    }

    fn has_tip(&self) -> bool {
        self.supported.is_some()
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        let Some(first) = cases.first() else { return Ok(Vec::new()) };
        Ok(self.at(first.flow, corrections)?.sensitivities(cases))
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        let neutral = Corrections::neutral(self.correctable.len());
        let state = self.at(case.flow, &neutral)?.solve(std::slice::from_ref(case));
        Ok(self.correctable.places.iter().map(|&place| state[0].cp[place]).collect())
    }
}

/// Parity of a permutation given as an array.
fn permutation_is_odd(permutation: &[usize]) -> bool {
    let mut seen = vec![false; permutation.len()];
    let mut odd = false;
    for start in 0..permutation.len() {
        let mut length = 0;
        let mut at = start;
        while !seen[at] {
            seen[at] = true;
            at = permutation[at];
            length += 1;
        }
        odd ^= length > 0 && length % 2 == 0;
    }
    odd
}

#[cfg(test)]
mod tests;
