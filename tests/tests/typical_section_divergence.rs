//! Divergence of a rigid rectangular half wing on a root torsion spring: the rows are in
//! `validation::cases::divergence`.

use validation::check;

#[test]
fn typical_section_divergence_incompressible() {
    check("trim__typical_section_divergence_M0");
}

#[test]
fn typical_section_divergence_at_mach_one_half() {
    check("trim__typical_section_divergence_M0.5");
}
