//! Incidence columns: what each box sees per unit of something, at its three-quarter point.
//!
//! An incidence is the stream's velocity along the box normal over V, an angle, positive if it gives a positive
//! pressure jump along the normal.

use crate::lattice::Lattice;
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, InputError, Span};

/// Incidence per rad of angle of attack: `n_z`.
pub fn angle_of_attack(lattice: &Lattice) -> Vec<f64> {
    lattice.boxes.iter().map(|panel| panel.normal().z).collect()
}

/// Incidence per rad of sideslip: `-n_y`. Sideslip is positive with the wind from the right (+y), as in flight
/// mechanics, so the air moves towards -y.
pub fn sideslip(lattice: &Lattice) -> Vec<f64> {
    lattice.boxes.iter().map(|panel| -panel.normal().y).collect()
}

/// Incidence per rad/s of a rotation about `axis` (a unit vector, right-hand rule in x aft, y right, z up) through
/// `about`: `-(axis x (r - about)).n / V`. The box's own motion, seen from the box, is the opposite wind.
///
/// Flight mechanics' roll rate (right wing down) is a rotation about -x, its yaw rate (nose right) about -z.
pub fn rotation_rate(lattice: &Lattice, axis: &Vector3<f64>, about: &Point3<f64>, v_m_s: f64) -> Vec<f64> {
    let one = |panel: &crate::AeroBox| {
        let velocity = axis.cross(&(panel.three_quarter_point() - about));
        -velocity.dot(&panel.normal()) / v_m_s
    };
    lattice.boxes.iter().map(one).collect()
}

/// Incidence per rad/s of nose-up rotation about the line x = `x_p_m`, z = 0 parallel to y:
/// `((x_j - x_p) n_z - z_j n_x) / V`.
pub fn pitch_rate(lattice: &Lattice, x_p_m: f64, v_m_s: f64) -> Vec<f64> {
    rotation_rate(lattice, &Vector3::y(), &Point3::new(x_p_m, 0.0, 0.0), v_m_s)
}

/// Incidence of camber and twist, rad, one per box: the deck's DMI `W2GJ`, rows in the order of ascending box
/// numbers; zeros if there is none. `W2GJ` is -dz/dx of the camber line plus nose-up twist.
///
/// # Errors
/// If `W2GJ` has not one column with one row per box, or a value is not finite.
pub fn camber_and_twist(bulk: &BulkData, lattice: &Lattice) -> Result<Vec<f64>, InputError> {
    let Some(matrix) = bulk.matrices.get("W2GJ") else { return Ok(vec![0.0; lattice.len()]) };
    let place =
        bulk.panels.values().next().map_or_else(|| Span::generated("W2GJ"), |panel| panel.span.clone());
    let in_file = |message: String| InputError::in_file(&place.file, message);
    let [column] = matrix.columns.as_slice() else {
        return Err(in_file(format!("DMI W2GJ has {} columns, expected one", matrix.columns.len())));
    };
    if column.len() != lattice.len() {
        return Err(in_file(format!("DMI W2GJ has {} rows for {} boxes", column.len(), lattice.len()))
            .with_help("one row per box, in the order of ascending box numbers"));
    }
    if let Some(row) = column.iter().position(|value| !value.is_finite()) {
        return Err(in_file(format!("DMI W2GJ is not finite in row {}", row + 1)));
    }
    Ok(column.clone())
}
