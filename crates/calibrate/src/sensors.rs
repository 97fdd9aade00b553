//! Sensors beside the balance: what they read of the wing, how well, and where a campaign says it.

use coupling::{ElasticWing, Rows, station_rows, strip_rows};
use faer::Mat;
use nastran::{InputError, Span};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A place along the span that a wing is read at: loads of the air, and the shape from its place with wind off at alpha = 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub enum Reading {
    /// Lift per span, N/m (a row of pressure taps).
    StripLift {
        /// Place, from 0 at the root to 1 at the tip.
        y_over_span: f64,
    },
    /// Lift outboard, N.
    Shear {
        /// Place, from 0 at the root to 1 at the tip.
        y_over_span: f64,
    },
    /// Bending moment of the lift outboard, tip up positive, N m (a strain bridge, zeroed with wind off).
    Bending {
        /// Place, from 0 at the root to 1 at the tip.
        y_over_span: f64,
    },
    /// Height, m (an optical marker).
    Height {
        /// Place, from 0 at the root to 1 at the tip.
        y_over_span: f64,
        /// Place along the chord, from 0 at the leading edge to 1.
        x_over_c: f64,
    },
    /// Incidence by the wing's deformation, nose up positive, degrees.
    Twist {
        /// Place, from 0 at the root to 1 at the tip.
        y_over_span: f64,
    },
}

impl Reading {
    /// Where along the span.
    pub const fn y_over_span(self) -> f64 {
        match self {
            Self::StripLift { y_over_span }
            | Self::Shear { y_over_span }
            | Self::Bending { y_over_span }
            | Self::Height { y_over_span, .. }
            | Self::Twist { y_over_span } => y_over_span,
        }
    }

    /// Whether it is of the wing's shape, not of its loads.
    pub const fn is_shape(self) -> bool {
        matches!(self, Self::Height { .. } | Self::Twist { .. })
    }

    /// The row that reads it: on the box loads, or on the structure's displacement.
    pub(crate) fn row(self, wing: &ElasticWing) -> Row {
        let section = |y_over_span: f64| {
            let mut point = wing.balance.point;
            point.y = wing.correctable.ends_m[0] + y_over_span * wing.correctable.span_m();
            station_rows(&wing.lattice, &wing.balance, &point)
        };
        let of = |rows: &Mat<f64>, row: usize| (0..rows.ncols()).map(|k| rows[(row, k)]).collect();
        match self {
            Self::StripLift { y_over_span } => {
                let rows = strip_rows(&wing.lattice, &wing.correctable);
                let mut mean = vec![0.0; rows.ncols()];
                for (first, share) in wing.correctable.strips_at(y_over_span) {
                    let strip = wing.correctable.strip[first];
                    mean.iter_mut().enumerate().for_each(|(k, value)| *value += share * rows[(strip, k)]);
                }
                Row::OnLoads(mean)
            }
            Self::Shear { y_over_span } => Row::OnLoads(of(&section(y_over_span), 0)),
            Self::Bending { y_over_span } => Row::OnLoads(of(&section(y_over_span), 1)),
            Self::Height { y_over_span, x_over_c } => {
                let [height, _] = wing.point_rows(y_over_span, x_over_c);
                Row::OnStructure(height)
            }
            Self::Twist { y_over_span } => {
                let [_, incidence] = wing.point_rows(y_over_span, 0.5);
                Row::OnStructure(incidence.into_iter().map(f64::to_degrees).collect())
            }
        }
    }
}

/// A row by which a wing is read.
pub(crate) enum Row {
    /// A channel of the balance: Fz, Mx, My.
    Balance(usize),
    /// On the box loads, two columns a box.
    OnLoads(Vec<f64>),
    /// On the displacement of the structure.
    OnStructure(Vec<f64>),
}

/// Rows that are read together.
pub(crate) struct Together {
    pub(crate) rows: Rows,
    /// Where each is among the readings.
    pub(crate) places: Vec<usize>,
    /// Channel of the balance, by reading.
    pub(crate) channels: Vec<Option<usize>>,
}

impl Together {
    pub(crate) fn new(wing: &ElasticWing, asked: Vec<Row>) -> Self {
        let on_loads = asked.iter().filter(|row| !matches!(row, Row::OnStructure(_))).count();
        let mut channels = vec![None; asked.len()];
        let mut places = Vec::with_capacity(asked.len());
        let (mut loads, mut structure) = (Vec::new(), Vec::new());
        for row in asked {
            match row {
                Row::Balance(channel) => {
                    places.push(loads.len());
                    channels[loads.len()] = Some(channel);
                    loads.push((0..wing.root_rows.ncols()).map(|k| wing.root_rows[(channel, k)]).collect());
                }
                Row::OnLoads(row) => {
                    places.push(loads.len());
                    loads.push(row);
                }
                Row::OnStructure(row) => {
                    places.push(on_loads + structure.len());
                    structure.push(row);
                }
            }
        }
        let matrix = |rows: &[Vec<f64>], columns: usize| Mat::from_fn(rows.len(), columns, |r, k| rows[r][k]);
        let rows = Rows {
            on_loads: matrix(&loads, wing.root_rows.ncols()),
            on_structure: matrix(&structure, wing.tip_row().len()),
        };
        Self { rows, places, channels }
    }
}

/// What a sensor's zero is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum Zero {
    /// It was set with wind off at alpha = 0.
    #[default]
    WindOff,
    /// It is not known: one offset for all rows of an airspeed.
    Free,
}

/// A weight that hangs on the wing with wind off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeadWeight {
    /// Its mass, kg.
    pub mass_kg: f64,
    /// Place along the span, from 0 at the root to 1 at the tip.
    pub y_over_span: f64,
    /// Place along the chord, from 0 at the leading edge to 1.
    pub x_over_c: f64,
}

/// A sensor of a campaign, with a column of the static cases.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// Its column in the static cases; a cell may be empty where it was not read.
    pub column: String,
    /// What it reads, and where.
    pub reads: Reading,
    /// Standard deviation of one row, in the unit of what is read.
    pub sigma: f64,
    /// What its zero is.
    #[serde(default)]
    pub zero: Zero,
    /// Standard deviation of its scale, as a share: 0.01 where its calibration is good to 1 %.
    #[serde(default)]
    pub scale: f64,
    /// A weight under which it is read, against the wing without it: its cells are in rows with V_m_s = 0, which are no tares. Shapes only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub under: Option<DeadWeight>,
}

/// Names differ and mean nothing else, places are on the wing, noise is positive.
pub(crate) fn check(sensors: &[Sensor], taken: impl Fn(&str) -> bool, path: &Path) -> Result<(), InputError> {
    for (i, sensor) in sensors.iter().enumerate() {
        let fault = |message: String, help: &str| {
            let text = nastran::read_text(path).unwrap_or_default();
            let place = nastran::place_of(&["sensors:", &format!("\"{}\"", sensor.column)], &text, path);
            Err(InputError::at(&place, message).with_help(help))
        };
        let name = &sensor.column;
        if name.is_empty() || taken(name) || sensors[..i].iter().any(|other| other.column == *name) {
            return fault(
                format!("a sensor's column cannot be called `{name}`"),
                "give every sensor a column of its own in the static cases, for instance \"strain_1_Nm\"",
            );
        }
        let mut places = vec![sensor.reads.y_over_span()];
        if let Reading::Height { x_over_c, .. } = sensor.reads {
            places.push(x_over_c);
        }
        if let Some(weight) = &sensor.under {
            places.extend([weight.y_over_span, weight.x_over_c]);
            if !(sensor.reads.is_shape() && weight.mass_kg.is_finite() && weight.mass_kg > 0.0) {
                return fault(
                    format!("sensor `{name}` is read under a weight of {:?} kg", weight.mass_kg),
                    "a dead weight has a positive mass, and Height or Twist are read under it",
                );
            }
        }
        if places.iter().any(|place| !(0.0..=1.0).contains(place)) {
            return fault(
                format!("sensor `{name}` is beside the wing"),
                "y_over_span is 0 at the root and 1 at the tip, x_over_c 0 at the leading edge and 1 at the trailing edge",
            );
        }
        if !(sensor.sigma.is_finite() && sensor.sigma > 0.0) {
            return fault(
                format!("sigma of sensor `{name}` must be a positive standard deviation"),
                "repeat a row a few times and take their standard deviation",
            );
        }
        if !(0.0..1.0).contains(&sensor.scale) {
            return fault(
                format!("scale of sensor `{name}` must be from 0 to less than 1"),
                "write 0.01 where its calibration is good to 1 %",
            );
        }
    }
    Ok(())
}

/// The weight that hangs on the wing in a row whose sensors read `cells`.
pub(crate) fn weight_in(sensors: &[Sensor], cells: &[Option<f64>]) -> Option<DeadWeight> {
    sensors.iter().zip(cells).filter(|(_, cell)| cell.is_some()).find_map(|(sensor, _)| sensor.under)
}

/// Sensors under a weight are read with wind off, and one weight hangs in a row.
pub(crate) fn check_weights(
    sensors: &[Sensor],
    v_m_s: f64,
    cells: &[Option<f64>],
    place: impl Fn(&str) -> Span,
) -> Result<(), InputError> {
    let hung = weight_in(sensors, cells);
    for (sensor, _) in sensors.iter().zip(cells).filter(|(_, cell)| cell.is_some()) {
        let name = &sensor.column;
        let why = match sensor.under {
            Some(_) if v_m_s > 0.0 => "it is read with wind off, in rows with V_m_s = 0",
            under if hung.is_some() && under != hung => {
                "another sensor of this row is read under another weight"
            }
            _ => continue,
        };
        return Err(InputError::at(&place(name), format!("`{name}` cannot be read here: {why}"))
            .with_help("leave the cell empty, and give every dead weight rows of its own with V_m_s = 0"));
    }
    Ok(())
}

#[cfg(test)]
mod tests;
