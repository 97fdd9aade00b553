//! Structure and air at an airspeed: the matrices of a step, and states at rest.

use super::{GRAVITY_M_S2, Rig, Structure};
use crate::air::{Motions, Operator};
use crate::setting::Setting;
use crate::wing::Section;
use nalgebra::{DMatrix, DVector};

/// Below this airspeed the air stands still, m/s.
const STILL_M_S: f64 = 1.0;
/// Time step without wind, s.
const STILL_STEP_S: f64 = 1.0 / 1500.0;
/// Moment that takes up most of the root's play, N m.
const SLACK_N_M: f64 = 2.0;
/// Steps of the fixed point at rest.
const REST_STEPS: usize = 60;

/// See the module. Motions of the air are modes, pitch, controls.
#[derive(Debug, Clone)]
pub struct Coupled<'a> {
    pub(crate) rig: &'a Rig,
    pub(crate) setting: Setting,
    pub(crate) structure: Structure,
    pub(crate) operator: Operator,
    /// Airspeed that acts, m/s; zero in still air.
    pub v_m_s: f64,
    /// Density, kg/m³.
    pub rho_kg_m3: f64,
    /// Time step, s.
    pub time_step_s: f64,
    /// Strip loads (lifts, then moments) by circulations and integrals.
    pub(crate) by_state: DMatrix<f64>,
    /// Strip loads by the rates of the integrals.
    pub(crate) by_rate: DMatrix<f64>,
    /// Generalised forces by strip loads.
    pub(crate) generalised: DMatrix<f64>,
    /// Balance loads by strip loads.
    pub(crate) balance: DMatrix<f64>,
    /// Incidence of strips that does not move, rad: of sections and stream.
    pub(crate) incidence: DVector<f64>,
    /// Strip loads that do not move: moments of sections.
    pub(crate) constant: DVector<f64>,
}

/// A state at rest.
#[derive(Debug, Clone)]
pub struct Rest {
    /// Modal coordinates.
    pub(crate) modal: DVector<f64>,
    /// Incidence that strips lack, rad.
    pub(crate) lost: DVector<f64>,
    /// Fz, Mx, My, from the wing level in still air.
    pub loads: [f64; 3],
    /// Height of the tip from the wing level in still air, m.
    pub tip_z_m: f64,
    /// Lift of strips, N.
    pub lift_n: DVector<f64>,
}

impl<'a> Coupled<'a> {
    /// The rig in a setting at an airspeed as the campaign says it.
    pub fn new(rig: &'a Rig, setting: Setting, v_said_m_s: f64, rho_kg_m3: f64) -> Self {
        let structure = Structure::new(rig, &setting);
        let (lattice, strips) = (&rig.lattice, &rig.lattice.strips);
        let wind = v_said_m_s * setting.airspeed > STILL_M_S;
        let v_m_s = if wind { v_said_m_s * setting.airspeed } else { 0.0 };
        let eta = |s: usize| strips[s].y_m / rig.wing.planform.semispan_m;
        let section = |s: usize| {
            let (Some(polars), true) = (&rig.polars, wind) else { return Section::FLAT };
            let polar = polars.section(v_said_m_s, strips[s].chord_m);
            Section {
                slope_per_rad: polar.slope_per_rad * setting.slope.at(eta(s)),
                zero_rad: polar.zero_rad + setting.zero_rad.at(eta(s)),
                ..polar
            }
        };
        let sections: Vec<Section> = (0..strips.len()).map(section).collect();
        let mut operator = Operator::new(lattice, &sections, &motions(rig, &structure), wind);
        for (control, factor) in setting.flap.iter().enumerate() {
            let motion = structure.omega_rad_s.len() + 1 + control;
            operator.scale_motion(motion, *factor);
        }
        let count = strips.len();
        let (mut by_state, mut by_rate) =
            (DMatrix::zeros(2 * count, 3 * count), DMatrix::zeros(2 * count, 3 * count));
        let (mut incidence, mut constant) = (DVector::zeros(count), DVector::zeros(2 * count));
        let q_pa = 0.5 * rho_kg_m3 * v_m_s * v_m_s;
        for (s, strip) in strips.iter().enumerate() {
            let (chord, scale) = (strip.chord_m, rho_kg_m3 * strip.width_m);
            let (lift, aft_m) = (setting.lift.at(eta(s)), setting.aft_over_c.at(eta(s)) * chord);
            by_state[(s, s)] = scale * v_m_s * lift;
            by_rate[(s, count + s)] = scale * lift;
            // about the quarter point, then where the lift really acts, then the polar's moment
            let moment = sections[s].cm_by_cl * chord - aft_m;
            by_state[(count + s, s)] = scale * v_m_s * lift * (-0.75 * chord + moment);
            by_state[(count + s, count + s)] = scale * v_m_s * lift;
            by_rate[(count + s, count + s)] = scale * lift * 0.25 * chord;
            by_rate[(count + s, 2 * count + s)] = -scale * lift;
            incidence[s] = setting.incidence_rad.at(eta(s)) - sections[s].zero_rad;
            let coefficient = sections[s].cm_zero + setting.moment.at(eta(s));
            constant[count + s] = if wind { q_pa * strip.width_m * chord * chord * coefficient } else { 0.0 };
        }
        let generalised = generalised(&structure);
        let time_step_s =
            if wind { lattice.step_m * (1.0 + setting.wake_slower) / v_m_s } else { STILL_STEP_S };
        Self {
            balance: balance(rig),
            rig,
            setting,
            structure,
            operator,
            v_m_s,
            rho_kg_m3,
            time_step_s,
            by_state,
            by_rate,
            generalised,
            incidence,
            constant,
        }
    }

    /// Geometric incidence of the strips: pitch, twist, fall.
    pub(crate) fn angles(&self, alpha_rad: f64, modal: &DVector<f64>, rates: &DVector<f64>) -> DVector<f64> {
        let turned = &self.structure.pitch * modal;
        let risen = &self.structure.height * rates / self.v_m_s.max(STILL_M_S);
        turned.map(|angle| angle + alpha_rad) - risen
    }

    /// What strips lack at rest at an incidence.
    pub(crate) fn lost(&self, angle_rad: f64) -> f64 {
        self.setting.stall.map_or(0.0, |stall| {
            let beyond = (angle_rad.abs() - stall.angle_rad) / stall.knee_rad;
            // log(1 + e^x) without overflow
            let soft = beyond.max(0.0) + (-beyond.abs()).exp().ln_1p();
            -angle_rad.signum()
                * stall.share
                * stall.knee_rad
                * soft
                * (angle_rad / stall.angle_rad).abs().min(1.0)
        })
    }

    /// How far the root's play is taken up by a moment, rad.
    pub(crate) fn play(&self, moment_n_m: f64) -> f64 {
        self.setting.slack_rad * (moment_n_m / SLACK_N_M).tanh()
    }

    /// Incidence at the strips by walls, from the lift, rad.
    pub(crate) fn wall(&self, lift_n: f64, strip: usize) -> f64 {
        let q_pa = 0.5 * self.rho_kg_m3 * self.v_m_s * self.v_m_s;
        if self.setting.wall_rad == 0.0 || q_pa == 0.0 {
            return 0.0;
        }
        let planform = &self.rig.wing.planform;
        let eta = self.rig.lattice.strips[strip].y_m / planform.semispan_m;
        // upwash of images grows towards the far wall
        self.setting.wall_rad * lift_n / (q_pa * planform.area_m2()) * (0.8 + 0.4 * eta)
    }

    /// Whether strips have an incidence of their own, beside motions: by stall, play or walls.
    pub(crate) fn strips_turn(&self) -> bool {
        let setting = &self.setting;
        self.v_m_s > 0.0 && (setting.stall.is_some() || setting.slack_rad != 0.0 || setting.wall_rad != 0.0)
    }

    /// The state at an angle of attack and deflections that stay.
    pub fn at_rest(&self, alpha_rad: f64, controls_rad: &[f64]) -> Rest {
        self.pulled(alpha_rad, controls_rad, GRAVITY_M_S2 * alpha_rad.cos())
    }

    /// The same where masses are pulled down by an acceleration, m/s².
    pub(crate) fn pulled(&self, alpha_rad: f64, controls_rad: &[f64], pull: f64) -> Rest {
        let modes = self.structure.omega_rad_s.len();
        let steady = &self.operator.steady * self.v_m_s;
        let loads_by_state = &self.generalised * &self.by_state;
        let softening = &loads_by_state * steady.columns(0, modes);
        let stiffness = DMatrix::from_fn(modes, modes, |i, j| {
            let own = if i == j { self.structure.omega_rad_s[i].powi(2) } else { 0.0 };
            own - softening[(i, j)]
        });
        let solver = stiffness.lu();
        let mut extra: DVector<f64> = DVector::zeros(self.operator.strips);
        let mut lost = extra.clone();
        let mut rest = None;
        for _ in 0..if self.strips_turn() { REST_STEPS } else { 1 } {
            let mut state = steady.column(modes) * alpha_rad
                + &self.operator.steady_by_strip * (&self.incidence + &extra) * self.v_m_s;
            for (control, delta) in controls_rad.iter().enumerate() {
                state += steady.column(modes + 1 + control) * *delta;
            }
            let force = &loads_by_state * &state
                + &self.generalised * &self.constant
                + self.structure.fields.column(0) * pull;
            let modal = solver.solve(&force).unwrap_or_else(|| DVector::from_element(modes, f64::NAN));
            state += steady.columns(0, modes) * &modal;
            let strip = &self.by_state * &state + &self.constant;
            let mut loads = [0.0; 3];
            for (channel, load) in loads.iter_mut().enumerate() {
                let air: f64 = self.balance.row(channel).transpose().dot(&strip);
                *load = air + self.structure.rigid[0][channel] * (pull - GRAVITY_M_S2);
            }
            let none = DVector::zeros(modes);
            for (s, angle) in self.angles(alpha_rad, &modal, &none).iter().enumerate() {
                lost[s] += 0.5 * (self.lost(*angle) - lost[s]);
                let more = lost[s] + self.play(loads[2]) + self.wall(loads[0], s);
                extra[s] += 0.7 * (more - extra[s]);
            }
            rest = Some(Rest {
                tip_z_m: self.structure.tip.dot(&(&modal - &self.structure.sag)),
                lift_n: strip.rows(0, self.operator.strips).into_owned(),
                lost: lost.clone(),
                modal,
                loads,
            });
        }
        rest.unwrap_or_else(|| unreachable!("at least one step is done"))
    }
}

fn motions(rig: &Rig, structure: &Structure) -> Motions {
    let mut motions = Motions::default();
    for mode in 0..structure.omega_rad_s.len() {
        let column = |matrix: &DMatrix<f64>| matrix.column(mode).iter().copied().collect::<Vec<f64>>();
        motions.push_strips(&rig.lattice, &column(&structure.height), &column(&structure.pitch));
    }
    motions.push_pitch(&rig.lattice, rig.wing.pitch_x_m);
    for control in &rig.wing.controls {
        let hinge_m = |y_m: f64| rig.wing.planform.x_m(y_m, 1.0 - control.chord_share);
        let (inner, outer) = control.y_m;
        let hinge_cos = (outer - inner) / (outer - inner).hypot(hinge_m(outer) - hinge_m(inner));
        motions.push_flap(&rig.lattice, control.y_m, control.chord_share, hinge_cos);
    }
    motions
}

fn generalised(structure: &Structure) -> DMatrix<f64> {
    let (count, modes) = structure.height.shape();
    DMatrix::from_fn(modes, 2 * count, |mode, column| {
        if column < count {
            structure.height[(column, mode)]
        } else {
            structure.pitch[(column - count, mode)]
        }
    })
}

fn balance(rig: &Rig) -> DMatrix<f64> {
    let strips = &rig.lattice.strips;
    let count = strips.len();
    DMatrix::from_fn(3, 2 * count, |row, column| {
        let strip = &strips[column % count];
        match (row, column < count) {
            _ if !strip.metric => 0.0,
            (0, true) | (2, false) => 1.0,
            (1, true) => strip.y_m,
            (2, true) => rig.wing.balance_x_m - strip.quarter_x_m(),
            _ => 0.0,
        }
    })
}
