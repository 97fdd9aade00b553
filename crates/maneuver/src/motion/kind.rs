//! What every kind of motion says about itself, so that nothing else has to ask which kind it is.

use super::signal::Signal;
use nastran::{InputError, Span};
use std::path::Path;

/// What moves, where the kind itself says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mover {
    /// What the file names in `of`.
    Named,
    /// The angle of attack, unless the file names something else.
    Angle,
    /// The columns of a table: `of` may not be given.
    Columns,
}

/// A kind of motion. Its type has the parameters with their names in files; [`Signal`] is its formula.
pub trait Kind: Signal + std::fmt::Debug {
    /// What tables and labels call it.
    fn words(&self) -> &'static str;

    /// Largest departure, rad.
    fn height(&self) -> f64;

    /// Another height, rad, where there is one.
    fn set_height(&mut self, _height: f64) {}

    /// Beginning, s.
    fn start_s(&self) -> f64;

    /// From beginning to end, s; zero if it stays where it went.
    fn length_s(&self) -> f64;

    /// Whether its value jumps, so that no surface can follow without an actuator.
    fn jumps(&self) -> bool {
        false
    }

    /// Whether both derivatives are known everywhere; what has none is smoothed as a measured angle is.
    fn has_derivatives(&self) -> bool {
        false
    }

    /// The field that must be above zero, and its value.
    fn above_zero(&self) -> Option<(&'static str, f64)> {
        None
    }

    /// Frequencies that the sampling must resolve, Hz, with the fields they come from.
    fn frequencies(&self) -> Vec<(&'static str, f64)> {
        self.above_zero().into_iter().filter(|(field, _)| *field == "frequency_hz").collect()
    }

    /// What moves.
    fn mover(&self) -> Mover {
        Mover::Named
    }

    /// Puts in what the kind counts from the angle at the beginning (rad), not from zero.
    fn count_from(&mut self, _base: f64) {}

    /// Reads what the kind keeps in a file of its own; `maneuver` is the file that names it.
    ///
    /// # Errors
    /// If that file cannot be read or is not what it must be.
    fn read_beside(&mut self, _maneuver: &Path) -> Result<(), InputError> {
        Ok(())
    }

    /// The signals of a table with several columns; empty for a formula.
    fn columns(&self) -> &[Column] {
        &[]
    }

    /// The kind's signs in a record; none if it is not told apart from others.
    fn recognised(_record: &Record<'_>) -> Option<Recognised>
    where
        Self: Sized,
    {
        None
    }
}

/// What all kinds with `height` and `start_s` say alike, and their words.
macro_rules! named {
    ($words:expr) => {
        fn words(&self) -> &'static str {
            $words
        }

        fn height(&self) -> f64 {
            self.height
        }

        fn set_height(&mut self, height: f64) {
            self.height = height;
        }

        fn start_s(&self) -> f64 {
            self.start_s
        }
    };
}
pub(super) use named;

/// A column of a table over time, linear between its samples, kept before and behind them.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// What it moves: `alpha` or a control surface.
    pub of: String,
    /// Where it stands.
    pub span: Span,
    /// Ascending times, s.
    pub t_s: Vec<f64>,
    /// Values, rad.
    pub values: Vec<f64>,
}

impl Signal for Column {
    fn at(&self, t_s: f64) -> f64 {
        let above = self.t_s.partition_point(|t| *t <= t_s);
        if above == 0 {
            return self.values[0];
        }
        if above == self.t_s.len() {
            return self.values[self.values.len() - 1];
        }
        let (t0, t1) = (self.t_s[above - 1], self.t_s[above]);
        self.values[above - 1] + (t_s - t0) / (t1 - t0) * (self.values[above] - self.values[above - 1])
    }
}

/// Samples of what moves alone in a run.
#[derive(Debug, Clone, Copy)]
pub struct Record<'a> {
    /// Angle of attack or deflection, rad.
    pub values: &'a [f64],
    /// Time step, s.
    pub time_step_s: f64,
    /// Whether it is the angle of attack.
    pub is_angle: bool,
}

/// The kind of motion in a record, by what can be read from samples for certain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recognised {
    /// What labels call it.
    pub words: &'static str,
    /// Frequency, Hz, two digits; none where the kind has none or several.
    pub frequency_hz: Option<f64>,
    /// Height, whole degrees; none where it does not matter.
    pub height_deg: Option<f64>,
    /// Whether its frequency runs.
    pub sweeps: bool,
}

/// Values below this share of the height have no sign.
const NEAR_ZERO: f64 = 0.05;
/// So many changes of sign are an oscillation.
const OSCILLATES: usize = 8;

impl Record<'_> {
    /// Largest value without its sign, rad.
    pub fn height(&self) -> f64 {
        self.values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
    }

    /// Whether it changes its sign again and again.
    pub fn oscillates(&self) -> bool {
        let height = self.height();
        let signs: Vec<bool> = self
            .values
            .iter()
            .filter(|value| value.abs() > NEAR_ZERO * height)
            .map(|value| *value > 0.0)
            .collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count() >= OSCILLATES
    }
}
