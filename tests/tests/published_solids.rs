//! Solid elements beside published and exact results, one test a case; sources are in the files of data/published (MacNeal
//! and Harder 1985, Lame, Pagano 1970). Straight and curved beams and plates of solids are rows of the tests in
//! `published_shells.rs`.

use validation::check;

#[test]
fn macneal_and_harder_solid_patch() {
    check("fem__patch_solid");
}

#[test]
fn thick_cylinder_hardly_compressible() {
    check("fem__thick_cylinder");
}

#[test]
fn cross_plies_by_pagano() {
    check("fem_composite__pagano_0_90_0");
}
