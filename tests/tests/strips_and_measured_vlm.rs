//! The vortex lattice beside strip slopes of a panel program and beside measured wings (data/published); the rows and
//! what is known about deviations are in `validation::cases::wings`.

use validation::check;

#[test]
fn lamar_measured_rectangular_wing() {
    check("vlm__lamar_AR3");
}

#[test]
fn pazy_wing_strip_slopes() {
    check("vlm__pazy_strip_slopes");
}

#[test]
fn weber_and_brebner_measured_lift_its_centre_and_strips() {
    check("vlm_measured__weber_brebner_45");
}
