//! The doublet lattice beside published and independently computed wings: one test a case of data/published.

use aero::DlmSettings;
use faer::c64;
use validation::cases::dlm::{QUARTIC, heave_and_pitch, rectangle};
use validation::cases::flutter_decks::NASTRAN as PARABOLIC;

#[test]
fn dlm_aic_rect_ar4_sym() {
    validation::check("dlm__dlm_aic_rect_ar4_sym");
}

#[test]
fn dlm_aic_swept_taper_dihedral_sym() {
    validation::check("dlm__dlm_aic_swept_taper_dihedral_sym");
}

#[test]
fn dlm_gaf_subsonic() {
    validation::check("dlm__dlm_gaf_subsonic");
}

#[test]
fn dlm_vanzyl_ar20_pitch() {
    validation::check("dlm__dlm_vanzyl_AR20_pitch");
}

#[test]
fn with_long_boxes_the_quartic_fit_is_nearer_to_short_ones_than_the_parabolic() {
    // aspect ratio 20, k = 2: boxes three times as wide as long, and four times as many strips
    let lift = |strips: u32, settings: DlmSettings| {
        heave_and_pitch(&rectangle(20.0, 1.0, [6, strips]), 1.0, 0.0, 2.0, settings)[0][0]
    };
    let fine = lift(80, QUARTIC);
    let far = |value: c64| (value - fine).norm() / fine.norm();
    let (parabolic, quartic) = (far(lift(20, PARABOLIC)), far(lift(20, QUARTIC)));
    println!(
        "parabolic {parabolic:.1e}, quartic {quartic:.1e}, parabolic with short boxes {:.1e}",
        far(lift(80, PARABOLIC))
    );
    assert!(far(lift(80, PARABOLIC)) < 0.4 * parabolic);
    assert!(quartic < 0.7 * parabolic);
}
