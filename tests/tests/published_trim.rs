//! Published trim cases.

use validation::registry::check;

/// HA144A: trim angles, derivatives and box loads at 40 and 1200 lbf/ft^2, to 2e-6.
#[test]
fn the_forward_swept_aircraft_trims_as_published() {
    check("trim__ha144a");
}

/// HA144B: five divergence pressures of the BAH wing, on a beam spline and a plate spline.
#[test]
fn the_bah_wing_diverges_as_published() {
    check("trim__ha144b_divergence_sym");
}
