//! The beam's table: stiffness and mass over the span, from CSV.

use nastran::{InputError, Table};
use std::path::Path;

const COLUMNS: [&str; 8] = [
    "y_m",
    "EI_flap_Nm2",
    "EI_lag_Nm2",
    "GJ_Nm2",
    "mass_per_span_kg_m",
    "Itheta_kgm",
    "xcg_over_c",
    "xea_over_c",
];

/// The table, looked up linearly between its rows.
pub(super) struct Distribution {
    columns: [Vec<f64>; 8],
}

/// What the table says at one span station.
pub(super) struct Section {
    /// Flap bending stiffness, about the in-plane normal of the elastic axis.
    pub(super) ei_flap_nm2: f64,
    /// Lag bending stiffness, about the vertical.
    pub(super) ei_lag_nm2: f64,
    /// Torsional stiffness.
    pub(super) gj_nm2: f64,
    /// Mass per unit of y.
    pub(super) mass_kg_m: f64,
    /// Pitch inertia per unit of y, about the section's centre of gravity and the y axis.
    pub(super) inertia_kg_m: f64,
    /// Place on the chord.
    pub(super) centre_of_gravity: f64,
    /// Place on the chord.
    pub(super) elastic_axis: f64,
}

impl Distribution {
    pub(super) fn read(path: &Path, semispan_m: f64) -> Result<Self, InputError> {
        let table = Table::read(path)?;
        table.require(&COLUMNS)?;
        table.allow_only(|name| COLUMNS.contains(&name), &format!("expected {}", COLUMNS.join(", ")))?;
        let mut columns: [Vec<f64>; 8] = Default::default();
        for (values, name) in columns.iter_mut().zip(COLUMNS) {
            *values = table.numbers(name)?;
        }
        // Rotary inertia and mass may vanish on a stretch of the wing; stiffness may not.
        for (values, name) in columns.iter().zip(COLUMNS).skip(1).take(5) {
            let is_stiffness = name.ends_with("Nm2");
            if let Some(row) = values.iter().position(|&value| value < 0.0 || (is_stiffness && value == 0.0))
            {
                let message = format!("{name} is {}, expected a number above zero", values[row]);
                return Err(InputError::at(&table.span(row, name), message));
            }
        }
        let y_m = &columns[0];
        if let Some(row) = (1..y_m.len()).find(|&row| y_m[row] <= y_m[row - 1]) {
            let message = format!("y_m is {} after {}, expected ascending stations", y_m[row], y_m[row - 1]);
            return Err(InputError::at(&table.span(row, "y_m"), message));
        }
        let (first, last) =
            (y_m.first().copied().unwrap_or(f64::NAN), y_m.last().copied().unwrap_or(f64::NAN));
        let reaches = first <= 0.0 && last >= semispan_m * (1.0 - 1e-9);
        if !reaches {
            let message =
                format!("the table covers y = {first} to {last} m, expected 0 to the half span {semispan_m}");
            return Err(InputError::in_file(path, message).with_help("add rows for root and tip"));
        }
        Ok(Self { columns })
    }

    pub(super) fn at(&self, y_m: f64) -> Section {
        let stations = &self.columns[0];
        // `read` made sure of two rows.
        let upper = stations.partition_point(|&station| station < y_m).clamp(1, stations.len() - 1);
        let share = ((y_m - stations[upper - 1]) / (stations[upper] - stations[upper - 1])).clamp(0.0, 1.0);
        let value = |column: usize| {
            let values = &self.columns[column];
            values[upper - 1] + share * (values[upper] - values[upper - 1])
        };
        Section {
            ei_flap_nm2: value(1),
            ei_lag_nm2: value(2),
            gj_nm2: value(3),
            mass_kg_m: value(4),
            inertia_kg_m: value(5),
            centre_of_gravity: value(6),
            elastic_axis: value(7),
        }
    }
}
