//! The model with given factors beside the measurements: predictions, which mode is which, and derivatives.

use super::forms::forms;
use super::mac::{modal_assurance, pair};
use super::measurements::{AtMotion, MeasuredMode, Measurements, Parameter, Quantity, Settings, UpdateError};
use crate::flexibility::Flexibility;
use crate::model::Model;
use crate::modes::{Modes, ModesError, normal_modes};
use crate::system::System;
use faer::Mat;
use std::f64::consts::TAU;

/// Motions of a mode below this share of its largest are rounding, whatever their shape: modes are computed to a residual of
/// 1e-9, those of large structures to 1e-7.
const STILL: f64 = 1e-6;

/// A measured number and what the model says.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// What it is.
    pub name: String,
    /// Unit of all numbers.
    pub unit: &'static str,
    /// Measured.
    pub measured: f64,
    /// One standard deviation of it.
    pub sigma: f64,
    /// The model's; none for a mode that no mode of the model is paired with.
    pub model: Option<f64>,
}

impl Prediction {
    /// (measured - model) / sigma.
    pub fn residual(&self) -> Option<f64> {
        self.model.map(|model| (self.measured - model) / self.sigma)
    }
}

/// The model beside the measurements.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// The factors, in the order of the parameters.
    pub factors: Vec<f64>,
    /// Natural frequencies of the model, Hz.
    pub frequencies_hz: Vec<f64>,
    /// Modal assurance of each measured mode with each of the model, zero where that one does not move what was measured by a
    /// millionth of its largest motion; empty for one without a measured shape.
    pub assurance: Vec<Vec<f64>>,
    /// The model's mode for each measured one.
    pub pairs: Vec<Option<usize>>,
    /// Modes, deflections, mass, in this order.
    pub predictions: Vec<Prediction>,
    /// d(prediction)/d(factor) over sigma, one row a prediction; zero where there is no prediction.
    pub sensitivities: Vec<Vec<f64>>,
}

impl State {
    /// Sum of the squared residuals.
    pub fn chi_square(&self) -> f64 {
        self.predictions.iter().filter_map(Prediction::residual).map(|r| r * r).sum()
    }

    /// Number of predictions that there are.
    pub fn compared(&self) -> usize {
        self.predictions.iter().filter(|prediction| prediction.model.is_some()).count()
    }
}

/// The model with factors beside the measurements.
///
/// # Errors
/// If the structure with them has no modes or no flexibility.
pub fn evaluate(
    model: &Model,
    parameters: &[Parameter],
    factors: &[f64],
    measurements: &Measurements,
    settings: &Settings,
) -> Result<State, UpdateError> {
    let mut of_element = vec![[1.0; 2]; model.elements.len()];
    for (parameter, factor) in parameters.iter().zip(factors) {
        for place in &parameter.elements {
            of_element[*place][parameter.quantity as usize] += factor - 1.0;
        }
    }
    let system = System::assemble_scaled(model, |place| of_element[place])?;
    let mut state = State {
        factors: factors.to_vec(),
        frequencies_hz: Vec::new(),
        assurance: Vec::new(),
        pairs: Vec::new(),
        predictions: Vec::new(),
        sensitivities: Vec::new(),
    };
    let step = Step { model, parameters, system: &system, measurements };
    step.add_modes(&mut state, settings)?;
    step.add_deflections(&mut state)?;
    step.add_mass(&mut state);
    Ok(state)
}

struct Step<'a> {
    model: &'a Model,
    parameters: &'a [Parameter],
    system: &'a System,
    measurements: &'a Measurements,
}

impl Step<'_> {
    fn add_modes(&self, state: &mut State, settings: &Settings) -> Result<(), UpdateError> {
        let measured = &self.measurements.modes;
        if measured.is_empty() {
            return Ok(());
        }
        let named = measured.iter().filter_map(|mode| mode.mode).max().map_or(0, |last| last + 1);
        let modes = some_modes(self.system, (2 * measured.len() + 4).max(named))?;
        let shapes = self.system.expand(modes.shapes.as_ref());
        state.frequencies_hz = modes.omega_rad_s.iter().map(|omega| omega / TAU).collect();
        let count = state.frequencies_hz.len();
        state.assurance = self.assurances(&shapes);
        let fixed: Vec<Option<usize>> =
            measured.iter().map(|mode| mode.mode.filter(|at| *at < count && mode.shape.is_empty())).collect();
        state.pairs = pair(&state.assurance, &fixed, settings.least_assurance);
        let paired: Vec<usize> = state.pairs.iter().flatten().copied().collect();
        let columns = Mat::from_fn(shapes.nrows(), paired.len(), |i, j| shapes[(i, paired[j])]);
        let forms: Vec<Vec<f64>> = self
            .parameters
            .iter()
            .map(|p| forms(self.model, p, columns.as_ref(), columns.as_ref()))
            .collect();
        let mut at = 0;
        for (mode, pair) in measured.iter().zip(&state.pairs) {
            let model = pair.map(|pair| state.frequencies_hz[pair]);
            let mut row = vec![0.0; self.parameters.len()];
            if let Some(hz) = model.filter(|hz| *hz > 0.0) {
                for (slope, (parameter, forms)) in row.iter_mut().zip(self.parameters.iter().zip(&forms)) {
                    let by_square = match parameter.quantity {
                        Quantity::Stiffness => forms[at],
                        Quantity::Mass => -(TAU * hz).powi(2) * forms[at],
                    };
                    // lambda = (2 pi f)^2
                    *slope = by_square / (2.0 * TAU * TAU * hz) / mode.sigma_hz;
                }
            }
            at += usize::from(pair.is_some());
            let (name, measured, sigma) = (mode.name.clone(), mode.frequency_hz, mode.sigma_hz);
            state.predictions.push(Prediction { name, unit: "Hz", measured, sigma, model });
            state.sensitivities.push(row);
        }
        Ok(())
    }

    /// Modal assurance of each measured mode with each of the model (`shapes`, g-set); zero where the model's mode leaves the measured
    /// places still. Rotations count with the structure's size, which makes displacements of them.
    fn assurances(&self, shapes: &Mat<f64>) -> Vec<Vec<f64>> {
        let points = self.system.points();
        let size_m = points.iter().map(|point| (point - points[0]).norm()).fold(0.0, f64::max);
        let arm_m = if size_m > 0.0 { size_m } else { 1.0 };
        let motion_m =
            |dof: usize, column: usize| shapes[(dof, column)].abs() * if dof % 6 < 3 { 1.0 } else { arm_m };
        let most = |dofs: &mut dyn Iterator<Item = usize>, column: usize| {
            dofs.map(|dof| motion_m(dof, column)).fold(0.0, f64::max)
        };
        let largest: Vec<f64> =
            (0..shapes.ncols()).map(|column| most(&mut (0..shapes.nrows()), column)).collect();
        let of = |measured: &MeasuredMode, column: usize| {
            let (places, values): (Vec<usize>, Vec<f64>) = measured.shape.iter().copied().unzip();
            if most(&mut places.iter().copied(), column) <= STILL * largest[column] {
                return 0.0;
            }
            let model: Vec<f64> = places.iter().map(|dof| shapes[(*dof, column)]).collect();
            modal_assurance(&values, &model)
        };
        let row = |measured: &MeasuredMode| {
            let columns = if measured.shape.is_empty() { 0 } else { shapes.ncols() };
            (0..columns).map(|column| of(measured, column)).collect()
        };
        self.measurements.modes.iter().map(row).collect()
    }

    fn add_deflections(&self, state: &mut State) -> Result<(), UpdateError> {
        let measured = &self.measurements.deflections;
        if measured.is_empty() {
            return Ok(());
        }
        let flexibility = Flexibility::new(self.system)?;
        let displaced = |of: &dyn Fn(usize) -> Vec<AtMotion>| {
            let mut loads = Mat::zeros(6 * self.system.node_count(), measured.len());
            for j in 0..measured.len() {
                for (dof, value) in of(j) {
                    loads[(dof, j)] += value;
                }
            }
            let free = flexibility.displacements(self.system.reduce(loads.as_ref()).as_ref());
            self.system.expand(free.as_ref())
        };
        let under_loads = displaced(&|j| measured[j].loads.clone());
        let under_units = displaced(&|j| vec![(measured[j].motion, 1.0)]);
        let of_parameter = |parameter: &Parameter| match parameter.quantity {
            Quantity::Stiffness => forms(self.model, parameter, under_units.as_ref(), under_loads.as_ref()),
            Quantity::Mass => vec![0.0; measured.len()],
        };
        let forms: Vec<Vec<f64>> = self.parameters.iter().map(of_parameter).collect();
        for (j, deflection) in measured.iter().enumerate() {
            state.sensitivities.push(forms.iter().map(|forms| -forms[j] / deflection.sigma).collect());
            state.predictions.push(Prediction {
                name: deflection.name.clone(),
                unit: if deflection.motion % 6 < 3 { "m" } else { "rad" },
                measured: deflection.value,
                sigma: deflection.sigma,
                model: Some(under_loads[(deflection.motion, j)]),
            });
        }
        Ok(())
    }

    fn add_mass(&self, state: &mut State) {
        let Some((measured, sigma)) = self.measurements.mass_kg else { return };
        let properties = self.system.mass_properties();
        let rigid = self.system.rigid_body(&properties.centre);
        let along = rigid.subcols(0, 1);
        let of_parameter = |parameter: &Parameter| match parameter.quantity {
            Quantity::Stiffness => 0.0,
            Quantity::Mass => forms(self.model, parameter, along, along)[0] / sigma,
        };
        state.sensitivities.push(self.parameters.iter().map(of_parameter).collect());
        let (name, model) = ("mass".to_owned(), Some(properties.mass_kg));
        state.predictions.push(Prediction { name, unit: "kg", measured, sigma, model });
    }
}

/// As many of the lowest modes as there are, at most `wanted`.
fn some_modes(system: &System, wanted: usize) -> Result<Modes, ModesError> {
    match normal_modes(system, wanted.min(system.free_count())) {
        Err(ModesError::TooMany { available, .. }) => normal_modes(system, available),
        other => other,
    }
}
