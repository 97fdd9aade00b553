//! The deflection correction of paper 1, Eq. 10, `delta = K(delta_inp, V) delta_inp`: what of a commanded deflection acts, from
//! the tables of a wing's file. It stands before the actuator.
//!
//! K is linear between listed deflections, then linear between listed airspeeds. Below the smallest listed deflection
//! and above the largest, K is kept; the latter is reported. Beyond the listed airspeeds is refused (but for the 2 %
//! that tunnels stray) unless the table says to take the nearest. Without wind nothing acts, and K is one.

use crate::history::TimeHistory;
use crate::rig_model::{Motion, RigModel};
use crate::run::Run;
use crate::simulate::{Simulated, simulate};
use aero::flow::STRAY_AIRSPEED;
use coupling::WingFile;
use coupling::wing_file::{DeflectionTable, OutsideAirspeeds};
use nastran::InputError;
use std::path::Path;

/// A deflection may be this share beyond the largest listed one without a remark.
const ROUNDING: f64 = 1e-6;

/// The corrections of all control surfaces that have one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DeflectionCorrection {
    tables: Vec<DeflectionTable>,
}

/// Corrections at one airspeed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DeflectionAt {
    curves: Vec<Curve>,
}

/// K of one control surface at one airspeed: two airspeeds mixed.
#[derive(Debug, Clone, PartialEq)]
struct Curve {
    control: String,
    odd: bool,
    /// Share and (deflection in rad, K) pairs of each airspeed.
    parts: [(f64, Vec<(f64, f64)>); 2],
}

/// A commanded deflection beyond the largest one that was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct BeyondMeasured {
    /// The control surface.
    pub control: String,
    /// Commanded, rad.
    pub commanded_rad: f64,
    /// Largest measured of that sign, rad.
    pub largest_rad: f64,
}

impl std::fmt::Display for BeyondMeasured {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "the deflection correction of {} is known up to {:.1} degrees; its factor there is kept for the {:.1} \
             degrees that are commanded",
            self.control,
            self.largest_rad.to_degrees(),
            self.commanded_rad.to_degrees()
        )
    }
}

impl DeflectionCorrection {
    /// The corrections of a wing's file; none if it has no table.
    pub fn of_wing(wing: &WingFile) -> Self {
        Self::new(wing.deflection.clone())
    }

    /// Corrections from tables that were checked as those of a wing's file are.
    pub fn new(tables: Vec<DeflectionTable>) -> Self {
        Self { tables }
    }

    /// Whether every deflection acts as commanded.
    pub fn is_none(&self) -> bool {
        self.tables.is_empty()
    }

    /// The corrections at an airspeed.
    ///
    /// # Errors
    /// An airspeed more than 2 % beyond the listed ones, unless the table takes the nearest.
    pub fn at(&self, v_m_s: f64) -> Result<DeflectionAt, InputError> {
        if v_m_s == 0.0 {
            return Ok(DeflectionAt::default());
        }
        let curves = self.tables.iter().map(|table| Curve::new(table, v_m_s)).collect::<Result<_, _>>()?;
        Ok(DeflectionAt { curves })
    }
}

impl Curve {
    fn new(table: &DeflectionTable, v_m_s: f64) -> Result<Self, InputError> {
        let rows = &table.rows;
        let ends = rows.first().zip(rows.last());
        let (first, last) = ends.map_or((v_m_s, v_m_s), |(first, last)| (first.v_m_s, last.v_m_s));
        let inside = (first * (1.0 - STRAY_AIRSPEED)..=last * (1.0 + STRAY_AIRSPEED)).contains(&v_m_s);
        if !inside && table.outside == OutsideAirspeeds::Refuse {
            let range =
                if rows.len() > 1 { format!("from {first} to {last}") } else { format!("at {first}") };
            let message = format!(
                "the deflection correction of {} was measured {range} m/s, not at {v_m_s:.2} m/s",
                table.control
            );
            return Err(InputError::general(message).with_help(
                "choose an airspeed inside, or write `outside: Nearest` in that table of the wing's file",
            ));
        }
        let above = rows.partition_point(|row| row.v_m_s <= v_m_s).clamp(1, rows.len().max(2) - 1);
        let points = |index: usize| -> Vec<(f64, f64)> {
            rows.get(index).map_or_else(Vec::new, |row| {
                row.commanded_deg.iter().map(|d| d.to_radians()).zip(row.factors()).collect()
            })
        };
        let share = match (rows.get(above - 1), rows.get(above)) {
            (Some(low), Some(high)) => ((v_m_s - low.v_m_s) / (high.v_m_s - low.v_m_s)).clamp(0.0, 1.0),
            _ => 0.0,
        };
        let parts = [(1.0 - share, points(above - 1)), (share, points(above))];
        Ok(Self { control: table.control.clone(), odd: table.odd, parts })
    }

    fn factor(&self, commanded_rad: f64) -> f64 {
        let place = if self.odd { commanded_rad.abs() } else { commanded_rad };
        self.parts
            .iter()
            .filter(|(share, _)| *share > 0.0)
            .map(|(share, points)| share * linear(points, place))
            .sum()
    }

    /// Largest listed deflection with the sign of the commanded one: the smaller of the two airspeeds'.
    fn largest(&self, commanded_rad: f64) -> f64 {
        let negative = !self.odd && commanded_rad < 0.0;
        let of = |points: &Vec<(f64, f64)>| {
            let end = if negative { points.first() } else { points.last() };
            end.map_or(f64::INFINITY, |(deflection, _)| deflection.abs())
        };
        self.parts
            .iter()
            .filter(|(share, _)| *share > 0.0)
            .map(|(_, points)| of(points))
            .fold(f64::INFINITY, f64::min)
    }
}

/// Linear between ascending points, constant outside; one if there is no point.
fn linear(points: &[(f64, f64)], at: f64) -> f64 {
    let above = points.partition_point(|(x, _)| *x <= at);
    match (above.checked_sub(1).and_then(|i| points.get(i)), points.get(above)) {
        (Some((x0, y0)), Some((x1, y1))) => y0 + (at - x0) / (x1 - x0) * (y1 - y0),
        (Some((_, y)), None) | (None, Some((_, y))) => *y,
        (None, None) => 1.0,
    }
}

impl DeflectionAt {
    fn curve(&self, control: &str) -> Option<&Curve> {
        self.curves.iter().find(|curve| curve.control == control)
    }

    /// K of a control surface; one without a table.
    pub fn factor(&self, control: &str, commanded_rad: f64) -> f64 {
        self.curve(control).map_or(1.0, |curve| curve.factor(commanded_rad))
    }

    /// The deflections that act.
    pub fn acting(&self, control: &str, commanded_rad: &[f64]) -> Vec<f64> {
        self.curve(control).map_or_else(
            || commanded_rad.to_vec(),
            |curve| commanded_rad.iter().map(|&delta| curve.factor(delta) * delta).collect(),
        )
    }

    /// The farthest command of a control surface beyond what was measured.
    pub fn beyond(&self, control: &str, commanded_rad: &[f64]) -> Option<BeyondMeasured> {
        let curve = self.curve(control)?;
        let over = |delta: &f64| delta.abs() - curve.largest(*delta);
        let farthest = commanded_rad.iter().copied().max_by(|a, b| over(a).total_cmp(&over(b)))?;
        let largest_rad = curve.largest(farthest);
        (farthest.abs() > largest_rad * (1.0 + ROUNDING)).then(|| BeyondMeasured {
            control: control.to_owned(),
            commanded_rad: farthest,
            largest_rad,
        })
    }
}

/// Flies commanded deflections: commanded, K, actuator, surface. The history has the commanded ones, as a run's file.
pub fn fly_commanded(model: &RigModel, motion: &Motion, correction: &DeflectionAt) -> TimeHistory {
    let acting = model.controls.iter().zip(&motion.controls_rad);
    let controls_rad = acting.map(|(name, commanded)| correction.acting(name, commanded)).collect();
    let mut history = model.fly(&Motion { controls_rad, ..motion.clone() });
    for (name, commanded) in model.controls.iter().zip(&motion.controls_rad) {
        restore(&mut history, name, commanded);
    }
    history
}

/// Flies a measured run, as [`simulate`] does, with corrected deflections.
///
/// # Errors
/// As [`simulate`].
pub fn simulate_commanded(
    run: &Run,
    model: &RigModel,
    correction: &DeflectionAt,
    file: &Path,
) -> Result<Simulated, InputError> {
    let acting = |(name, commanded): &(String, Vec<f64>)| (name.clone(), correction.acting(name, commanded));
    let flown = Run { controls_rad: run.controls_rad.iter().map(acting).collect(), ..run.clone() };
    let mut simulated = simulate(&flown, model, file)?;
    for (name, commanded) in &run.controls_rad {
        restore(&mut simulated.history, name, commanded);
    }
    Ok(simulated)
}

/// The column of a control's commands.
fn restore(history: &mut TimeHistory, control: &str, commanded_rad: &[f64]) {
    let name = format!("delta_{control}_deg");
    if let Some(channel) = history.channels.iter_mut().find(|channel| channel.name == name) {
        channel.values = commanded_rad.iter().map(|delta| delta.to_degrees()).collect();
    }
}
