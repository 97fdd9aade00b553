//! What `flightloads` compares: readings of a condition beside loads of both models.

use loads::compare::{Comparison, Point};
use loads::flight::{Channel, Condition, Reading};

use super::flightloads_wing::Calculated;

/// Names of the models in results.
pub(super) const MODELS: [&str; 2] = ["initial", "updated"];

/// A condition with what was measured and calculated.
pub(super) struct Measured {
    /// The condition.
    pub(super) condition: Condition,
    /// What is compared in it.
    pub(super) channels: Vec<Channel>,
    /// Readings.
    pub(super) readings: Vec<Reading>,
    /// Calculated loads of each reading by each model, in the order of the channels.
    pub(super) calculated: [Option<Vec<Calculated>>; 2],
}

/// A channel's points in a condition by a model.
pub(super) fn comparison(one: &Measured, at: usize, model: usize) -> Option<Comparison> {
    let channel = &one.channels[at];
    let calculated = one.calculated[model].as_ref()?;
    let pairs = one.readings.iter().zip(calculated);
    let point = |(reading, calculated): (&Reading, &Calculated)| {
        let measured = reading.measured[at]?;
        let (load, state_sigma) = (calculated.loads[at], calculated.sigma[at]);
        Some(Point { calculated: load, measured, state_sigma, fitted: reading.fitted })
    };
    let points: Vec<Point> = pairs.filter_map(point).collect();
    let name = format!("{} {}", one.condition.name, channel.column());
    (!points.is_empty()).then(|| Comparison { name, unit: channel.load.unit(), gauge: channel.gauge, points })
}
