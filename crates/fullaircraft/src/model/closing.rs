//! The closing mass: one body that brings the aircraft's mass properties to the totals of its file.
//!
//! With m, c and I of the rest: `m1 = M - m`, `c1 = (M C - m c)/m1`, and by Steiner's theorem
//! `I1 = I_total - (I + m S(c - C)) - m1 S(c1 - C)`, `S(r) = |r|^2 E - r r^T`, of which the diagonal is used. The
//! body must be possible: mass and moments of inertia above zero, none larger than the sum of the other two.

use crate::aircraft::file::AircraftFile;
use nalgebra::{DMatrix, Matrix3, Point3, Vector3};
use nastran::{Conm2, InputError};
use std::borrow::Cow;
use structure::{Element as _, MassProperties, PointMass};

/// The closing mass on grid `grid` at `at`, given the mass properties of everything else.
///
/// # Errors
/// If the rest is heavier than the whole, or no body has the moments of inertia that are missing.
pub(crate) fn mass(
    file: &AircraftFile,
    rest: &MassProperties,
    id: u32,
    grid: u32,
    at: &Point3<f64>,
) -> Result<Conm2, InputError> {
    let total = &file.total;
    let centre = Point3::new(total.x_cg_m, 0.0, 0.0);
    let mass = total.mass_kg - rest.mass_kg;
    if mass <= 0.0 {
        let message = format!(
            "total.mass_kg is {}, but wings, tail and fuselage beam weigh {:.3} kg already",
            total.mass_kg, rest.mass_kg
        );
        return Err(InputError::in_field(&file.path, "total.mass_kg", message)
            .with_help("the totals are those of the whole aircraft, wings and tail included"));
    }
    let mut place = Point3::from((centre.coords * total.mass_kg - rest.centre.coords * rest.mass_kg) / mass);
    // The rest is symmetric; its centre is off the plane by round-off only.
    place.y = 0.0;
    let whole = Matrix3::from_diagonal(&Vector3::new(total.ixx_kg_m2, total.iyy_kg_m2, total.izz_kg_m2));
    let missing = whole
        - (rest.inertia_kg_m2 + steiner(&(rest.centre - centre)) * rest.mass_kg)
        - steiner(&(place - centre)) * mass;
    let [x, y, z] = [missing[(0, 0)], missing[(1, 1)], missing[(2, 2)]];
    if [x, y, z].iter().any(|i| *i <= 0.0) || x > y + z || y > z + x || z > x + y {
        let message = format!(
            "the moments of inertia in `total` leave {x:.3}, {y:.3}, {z:.3} kg m2 for the body at the wing's root \
             ({mass:.3} kg at x = {:.3} m), which no body has",
            place.x
        );
        let help = "each must be above zero and less than the sum of the other two";
        return Err(InputError::in_field(&file.path, "total.ixx_kg_m2", message).with_help(help));
    }
    let offset = place - at;
    Ok(Conm2 { id, grid, cid: 0, mass, offset, inertia: [x, 0.0, y, 0.0, 0.0, z], span: file.span() })
}

/// Mass matrix of a closing body over the six motions of its grid, kg and kg m²; none where one of them has no inertia.
pub(crate) fn inertia(body: &Conm2) -> Option<DMatrix<f64>> {
    let [x, _, y, _, _, z] = body.inertia;
    let own = Matrix3::from_diagonal(&Vector3::new(x, y, z));
    let point = PointMass::new(body.id, 0, body.mass, &body.offset, &own);
    point.mass().filter(|mass| mass.nrows() == 6).map(Cow::into_owned)
}

fn steiner(r: &Vector3<f64>) -> Matrix3<f64> {
    Matrix3::identity() * r.norm_squared() - r * r.transpose()
}
