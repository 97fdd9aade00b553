//! Shell elements beside published results, one test a case; sources are in the files of data/published (MacNeal and
//! Harder 1985; NAFEMS Standard Benchmarks; Bathe, Iosilevich and Chapelle 2000; analytic solutions).

use validation::check;

macro_rules! cases {
    ($($name:ident: $file:literal),* $(,)?) => {
        $(#[test]
        fn $name() {
            check($file);
        })*
    };
}

cases! {
    macneal_harder_membrane_patch: "fem__patch_membrane",
    macneal_harder_bending_patch: "fem__patch_bending",
    macneal_harder_rectangular_plate: "fem__mh_rect_plate_1",
    navier_thin_plate: "fem__iso_plate_ss_udl",
    razzaque_skew_plate: "fem__razzaque_skew",
    scordelis_lo_roof: "fem__scordelis_lo",
    pinched_cylinder: "fem__pinched_cylinder",
    pinched_hemisphere: "fem__hemisphere_18deg",
    hyperbolic_paraboloid: "fem__hypar_0.01",
    twisted_beam: "fem__mh_twisted_beam_thick",
    straight_beam: "fem__mh_straight_beam",
    curved_beam: "fem__mh_curved_beam",
    nafems_le1_elliptic_membrane: "fem__nafems_le1",
    nafems_le5_z_section: "fem__nafems_le5",
}
