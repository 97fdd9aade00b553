//! The true wing at one airspeed as a linear system.
//!
//! ```text
//! P = q [c0 x + sum_j d_j z_j] + rho V/2 c1 x' + rho/2 c2 x'' + q (camber, offsets),   z_j' = x' - g_j V z_j
//! M xi'' + C xi' + K xi = Gᵀ P + Phiᵀ M r c,   c = (g sin a, -g cos a, -a'')
//! loads = R P + r_bᵀ M (r c - Phi xi'') - weight(0)
//! ```
//! x are modes, root pitch, deflections and the zones' lost incidence; P the strips' loads. All modes move: there is no
//! static residual, but more modes than a model has.

use crate::air::StripAir;
use crate::modal::{Masses, ModalStructure};
use crate::physics::Physics;
use crate::strips::{Strips, ZONES};
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::f64::consts::TAU;

/// Modes faster than this are lag-free, Hz.
const FASTEST_LAGGED_HZ: f64 = 60.0;
/// Below this airspeed there are no lags, m/s.
const STILL_M_S: f64 = 5.0;

/// What of the zones a system has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ZonesOf {
    /// Nothing.
    Nothing,
    /// Their loads and displacements, as outputs.
    Outputs,
    /// These, and the incidence that they lack, as inputs.
    Both,
}

/// Where inputs stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Inputs {
    pub(crate) controls: usize,
    pub(crate) zones: usize,
}

impl Inputs {
    pub(crate) const ONE: usize = 0;
    pub(crate) const ALPHA: usize = 1;
    pub(crate) const G_SIN: usize = 4;
    pub(crate) const G_COS: usize = 5;

    /// Derivative of a control's deflection.
    pub(crate) fn control(self, derivative: usize, control: usize) -> usize {
        6 + derivative * self.controls + control
    }

    /// A zone's incidence (0) and its rate (1).
    pub(crate) fn zone(self, derivative: usize, zone: usize) -> usize {
        6 + 3 * self.controls + derivative * self.zones + zone
    }

    pub(crate) fn len(self) -> usize {
        6 + 3 * self.controls + 2 * self.zones
    }
}

/// `x' = A x + B u`, `y = C x + D u`; outputs Fz, Mx, My, tip height, then (if zones are asked for) lift, height, twist and
/// upward velocity of every zone.
#[derive(Debug, Clone)]
pub(crate) struct LinearWing {
    pub(crate) a: Mat<f64>,
    pub(crate) b: Mat<f64>,
    pub(crate) c: Mat<f64>,
    pub(crate) d: Mat<f64>,
    pub(crate) inputs: Inputs,
}

/// What stands still over cases.
#[derive(Debug, Clone)]
pub(crate) struct Parts {
    pub(crate) structure: ModalStructure,
    pub(crate) strips: Strips,
    pub(crate) air: StripAir,
    /// Modes by strip loads.
    pub(crate) modal_rows: Mat<f64>,
    /// Balance loads by strip loads.
    pub(crate) balance_rows: Mat<f64>,
    pub(crate) gravity_m_s2: f64,
}

/// Sizes and columns while a system is assembled.
pub(crate) struct Layout {
    pub(crate) modes: usize,
    pub(crate) inputs: Inputs,
    /// Motions that have lags, with how many poles.
    lagged: Vec<usize>,
    poles: usize,
}

impl Layout {
    pub(crate) fn states(&self) -> usize {
        2 * self.modes + self.poles * self.lagged.len()
    }

    fn lag(&self, pole: usize, place: usize) -> usize {
        2 * self.modes + pole * self.lagged.len() + place
    }

    /// State (`Ok`) or input (`Err`) of a motion's derivative; none for what has none (accelerations of modes are solved
    /// for, zones have no second derivative).
    fn place(&self, motion: usize, derivative: usize) -> Option<Result<usize, usize>> {
        let (modes, controls) = (self.modes, self.inputs.controls);
        match motion {
            mode if mode < modes => (derivative < 2).then_some(Ok(derivative * modes + mode)),
            pitch if pitch == modes => Some(Err(Inputs::ALPHA + derivative)),
            control if control <= modes + controls => {
                Some(Err(self.inputs.control(derivative, control - modes - 1)))
            }
            zone => (derivative < 2 && self.inputs.zones > 0)
                .then(|| Err(self.inputs.zone(derivative, zone - modes - 1 - controls))),
        }
    }
}

/// Rows by states and inputs.
pub(crate) struct Rows {
    pub(crate) state: Mat<f64>,
    pub(crate) input: Mat<f64>,
}

impl Rows {
    pub(crate) fn zeros(rows: usize, layout: &Layout) -> Self {
        Self { state: Mat::zeros(rows, layout.states()), input: Mat::zeros(rows, layout.inputs.len()) }
    }

    fn add(&mut self, row: usize, place: Result<usize, usize>, value: f64) {
        match place {
            Ok(state) => self.state[(row, state)] += value,
            Err(input) => self.input[(row, input)] += value,
        }
    }

    pub(crate) fn mapped(&self, left: &Mat<f64>) -> Self {
        Self { state: left * &self.state, input: left * &self.input }
    }

    fn plus(mut self, other: &Self) -> Self {
        self.state += &other.state;
        self.input += &other.input;
        self
    }
}

impl Parts {
    /// Assembles the system at an airspeed.
    pub(crate) fn at(
        &self,
        v_said_m_s: f64,
        rho_kg_m3: f64,
        physics: &Physics,
        zones: ZonesOf,
    ) -> LinearWing {
        let v_m_s = v_said_m_s * physics.airspeed;
        let layout = self.layout(v_m_s, zones);
        let (strip_loads, by_acceleration) = self.strip_loads(&layout, v_m_s, rho_kg_m3, physics);
        let masses = self.masses(physics);
        let modes = layout.modes;
        // the modes' accelerations: the air's apparent mass on the left
        let mut forces = strip_loads.mapped(&self.modal_rows);
        self.add_structure(&mut forces, &layout, physics, &masses);
        let mass = &masses.modal - &self.modal_rows * &by_acceleration;
        let lu = mass.partial_piv_lu();
        let acceleration = Rows { state: lu.solve(&forces.state), input: lu.solve(&forces.input) };
        let moved = acceleration.mapped(&by_acceleration);
        let strip_loads = strip_loads.plus(&moved);
        let mut motion = Rows::zeros(layout.states(), &layout);
        for mode in 0..modes {
            motion.state[(mode, modes + mode)] = 1.0;
            for column in 0..layout.states() {
                motion.state[(modes + mode, column)] = acceleration.state[(mode, column)];
            }
            for column in 0..layout.inputs.len() {
                motion.input[(modes + mode, column)] = acceleration.input[(mode, column)];
            }
        }
        for pole in 0..layout.poles {
            let rate = self.air.rational.poles_per_m[pole] * physics.lag_rate[pole] * v_m_s;
            for (place, &of) in layout.lagged.iter().enumerate() {
                let at = layout.lag(pole, place);
                motion.state[(at, at)] -= rate;
                if let Some(rate_of) = layout.place(of, 1) {
                    motion.add(at, rate_of, 1.0);
                }
            }
        }
        let mut output = self.outputs(&layout, &strip_loads, &acceleration, &masses, zones);
        // the tip's height counts from its wind-off place at alpha = 0
        let sag = self.stiffness(physics).partial_piv_lu().solve(&masses.fields);
        output.input[(3, Inputs::ONE)] +=
            (0..modes).map(|mode| self.structure.tip[mode] * sag[(mode, 1)] * self.gravity_m_s2).sum::<f64>();
        LinearWing {
            a: motion.state,
            b: motion.input,
            c: output.state,
            d: output.input,
            inputs: layout.inputs,
        }
    }

    fn layout(&self, v_m_s: f64, zones: ZonesOf) -> Layout {
        let modes = self.structure.omega_rad_s.len();
        let inputs =
            Inputs { controls: self.air.controls, zones: if zones == ZonesOf::Both { ZONES } else { 0 } };
        let fastest = (TAU * FASTEST_LAGGED_HZ).min(self.air.highest_per_m * v_m_s);
        let slow = self.structure.omega_rad_s.iter().take_while(|omega| **omega < fastest).count();
        let others = modes + 1 + inputs.controls + inputs.zones;
        let poles = if v_m_s < STILL_M_S { 0 } else { self.air.rational.lags.len() };
        Layout { modes, inputs, lagged: (0..slow).chain(modes..others).collect(), poles }
    }

    /// Strip loads but for what the modes' accelerations add, and that.
    fn strip_loads(
        &self,
        layout: &Layout,
        v_m_s: f64,
        rho_kg_m3: f64,
        physics: &Physics,
    ) -> (Rows, Mat<f64>) {
        let count = self.strips.len();
        let q_pa = 0.5 * rho_kg_m3 * v_m_s * v_m_s;
        let mut rows = Rows::zeros(2 * count, layout);
        let mut by_acceleration = Mat::zeros(2 * count, layout.modes);
        let motions = layout.modes + 1 + layout.inputs.controls + layout.inputs.zones;
        let factors = [q_pa, 0.5 * rho_kg_m3 * v_m_s, 0.5 * rho_kg_m3];
        for motion in 0..motions {
            let lag_place = layout.lagged.iter().position(|of| *of == motion);
            let slow = lag_place.is_some() && layout.poles > 0;
            let air = if slow { &self.air.rational } else { &self.air.instant };
            let control = (layout.modes + 1..layout.modes + 1 + layout.inputs.controls).contains(&motion);
            let of_control = |values: &[f64], else_: f64| {
                if control { values[motion - layout.modes - 1] } else { else_ }
            };
            let flap = of_control(&physics.flap, 1.0);
            let flap_aft = of_control(&physics.flap_aft_over_c, 0.0);
            for (derivative, matrix) in [&air.steady, &air.rate, &air.second].into_iter().enumerate() {
                for row in 0..2 * count {
                    let strip = row % count;
                    let apparent = if derivative == 2 { apparent_mass(physics, strip) } else { 1.0 };
                    let entry = |row: usize| {
                        let value = matrix[(row, motion)];
                        let unsteady = match derivative {
                            0 => 0.0,
                            1 => value - self.air.quasi_steady_rate[(row, motion)],
                            _ => value,
                        };
                        value + (physics.unsteady - 1.0) * unsteady
                    };
                    let moved = if row < count { 0.0 } else { flap_aft * entry(row - count) };
                    let own = entry(row) - self.strips.chord_m[row % count] * moved;
                    let value = factors[derivative] * flap * apparent * own;
                    match layout.place(motion, derivative) {
                        Some(place) => rows.add(row, place, value),
                        None if motion < layout.modes => by_acceleration[(row, motion)] += value,
                        None => {}
                    }
                }
            }
            if let (true, Some(place)) = (slow, lag_place) {
                for pole in 0..layout.poles {
                    let at = layout.lag(pole, place);
                    for row in 0..2 * count {
                        let amplitude = q_pa * flap * physics.unsteady * physics.lag_amplitude[row % count];
                        let lag = |row: usize| self.air.lag(pole, physics.lag_rate[pole], row, motion);
                        let moved = if row < count { 0.0 } else { flap_aft * lag(row - count) };
                        let aft_m = self.strips.chord_m[row % count];
                        rows.state[(row, at)] += amplitude * (lag(row) - aft_m * moved);
                    }
                }
            }
        }
        self.add_constants(&mut rows, q_pa, physics);
        for matrix in [&mut rows.state, &mut rows.input, &mut by_acceleration] {
            self.bring_to_sections(matrix, physics);
        }
        self.add_section_offsets(&mut rows, q_pa, physics);
        (rows, by_acceleration)
    }

    /// Camber, and incidences of strips.
    fn add_constants(&self, rows: &mut Rows, q_pa: f64, physics: &Physics) {
        for row in 0..2 * self.strips.len() {
            let twisted: f64 =
                physics.incidence_rad.iter().enumerate().map(|(s, w)| self.air.by_strip[(row, s)] * w).sum();
            rows.input[(row, Inputs::ONE)] += q_pa * (self.air.camber[row] + twisted);
        }
    }

    /// The strips' factors, and lifts that act further aft.
    fn bring_to_sections(&self, matrix: &mut Mat<f64>, physics: &Physics) {
        let count = self.strips.len();
        for column in 0..matrix.ncols() {
            for strip in 0..count {
                let lift = physics.lift[strip] * matrix[(strip, column)];
                let moment = physics.lift[strip] * matrix[(count + strip, column)];
                let aft_m = physics.centre_aft_over_c[strip] * self.strips.chord_m[strip];
                matrix[(strip, column)] = lift;
                matrix[(count + strip, column)] = moment - aft_m * lift;
            }
        }
    }

    fn add_section_offsets(&self, rows: &mut Rows, q_pa: f64, physics: &Physics) {
        let count = self.strips.len();
        for strip in 0..count {
            let area = self.strips.area_m2(strip);
            let chord = self.strips.chord_m[strip];
            rows.input[(strip, Inputs::ONE)] += q_pa * area * physics.lift_offset[strip];
            rows.input[(count + strip, Inputs::ONE)] += q_pa * area * chord * physics.moment_offset[strip];
        }
    }

    /// Stiffness, damping and weight, as forces on the modes.
    fn add_structure(&self, forces: &mut Rows, layout: &Layout, physics: &Physics, masses: &Masses) {
        let modes = layout.modes;
        let stiffness = self.stiffness(physics);
        for i in 0..modes {
            let omega = self.structure.omega_rad_s[i];
            for j in 0..modes {
                forces.state[(i, j)] -= stiffness[(i, j)];
            }
            forces.state[(i, modes + i)] -= 2.0 * physics.damping[i] * omega;
            forces.input[(i, Inputs::G_SIN)] += masses.fields[(i, 0)];
            forces.input[(i, Inputs::G_COS)] -= masses.fields[(i, 1)];
            forces.input[(i, Inputs::ALPHA + 2)] -= masses.fields[(i, 2)];
        }
    }
}

/// Factor of a strip's apparent mass before the strip's own factor, which is of its circulation alone.
fn apparent_mass(physics: &Physics, strip: usize) -> f64 {
    physics.apparent_mass[strip] / physics.lift[strip].max(0.05)
}

impl LinearWing {
    /// The state that constant inputs lead to.
    pub(crate) fn equilibrium(&self, inputs: &[f64]) -> Vec<f64> {
        let states = self.a.nrows();
        let forcing = Mat::from_fn(states, 1, |i, _| {
            -(0..inputs.len()).map(|k| self.b[(i, k)] * inputs[k]).sum::<f64>()
        });
        self.a.partial_piv_lu().solve(&forcing).col_as_slice(0).to_vec()
    }

    /// States per unit of constant incidence of every zone, states by zones.
    pub(crate) fn equilibrium_by_zone(&self) -> Mat<f64> {
        let forcing = Mat::from_fn(self.a.nrows(), ZONES, |i, zone| -self.b[(i, self.inputs.zone(0, zone))]);
        self.a.partial_piv_lu().solve(&forcing)
    }
}
