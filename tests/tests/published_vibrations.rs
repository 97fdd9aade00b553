//! Natural frequencies beside published results, one test a case; sources are in the files of data/published (NAFEMS
//! Standard Benchmarks, Leissa SP-160, closed forms, NASA's print of the BAH wing).

use validation::check;

#[test]
fn nafems_fv12_free_plate() {
    check("fem__nafems_fv12");
}

#[test]
fn nafems_fv16_cantilevered_plate() {
    check("fem__nafems_fv16");
}

#[test]
fn nafems_fv32_tapered_membrane() {
    check("fem__nafems_fv32");
}

#[test]
fn euler_beams() {
    check("fem__beam_modes");
}

#[test]
fn bah_wing_on_its_flexibility() {
    check("fem__bah_structure");
}
