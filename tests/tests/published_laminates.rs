//! Laminates beside published results, one test a case; sources are in the files of data/published (lamination theory and
//! Navier's solutions computed independently; Reddy, Phan, Chao, Khdeir, Barbero, Kosmatka; NAFEMS R0031).

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
    classical_lamination_theory: "fem_composite__clt_abd",
    navier_deflections: "fem_composite__navier_fsdt_defl",
    navier_frequencies: "fem_composite__navier_fsdt_freq",
    reddy_and_phan_two_plies: "fem_composite__reddy_phan_2ply",
    reddy_1979_angle_plies: "fem_composite__reddy_1979",
    reddy_and_chao_cross_plies: "fem_composite__reddy_chao",
    khdeir_angle_plies: "fem_composite__khdeir_1988",
    barbero_orthotropic_plate: "fem_composite__barbero_3_2",
    kosmatka_cantilever: "fem_composite__kosmatka",
    nafems_r0031_three_point_bending: "fem_composite__r0031_1",
}
