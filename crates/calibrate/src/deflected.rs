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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_controls_are_read_in_degrees_where_they_are_not_zero() {
        assert_eq!(control_of("delta_flap_in_deg"), Some("flap_in"));
        assert_eq!(control_of("delta_flap"), None);
        assert_eq!(control_of("flap_deg"), None);
        let table = Table::parse("t.csv", "V_m_s,delta_a_deg,delta_b_deg\n1,0,-90\n1,180,0\n1,0,0\n")
            .expect("a table");
        let read = |row| deflections(&table, row).expect("numbers");
        assert_eq!(read(0), [("b".to_owned(), -std::f64::consts::FRAC_PI_2)]);
        assert_eq!(read(1), [("a".to_owned(), std::f64::consts::PI)]);
        assert_eq!(read(2), []);
    }
}
