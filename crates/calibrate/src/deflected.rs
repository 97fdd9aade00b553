//! Deflections of control surfaces in a table of static points: its columns `delta_NAME_deg`.

use nastran::InputError;
use nastran::table::Table;

/// The control that a column has the deflections of.
pub(crate) fn control_of(column: &str) -> Option<&str> {
    column.strip_prefix("delta_")?.strip_suffix("_deg")
}

/// Controls that are deflected in a row, and by how much, rad.
///
/// # Errors
/// If a cell is no number.
pub(crate) fn deflections(table: &Table, row: usize) -> Result<Vec<(String, f64)>, InputError> {
    let mut controls_rad = Vec::new();
    for column in table.columns() {
        let Some(name) = control_of(column) else { continue };
        let delta_deg = table.number(row, column)?;
        if delta_deg != 0.0 {
            controls_rad.push((name.to_owned(), delta_deg.to_radians()));
        }
    }
    Ok(controls_rad)
}
