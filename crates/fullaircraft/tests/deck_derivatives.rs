//! Derivatives of a user's deck where some of the air reaches motions that are held: splined, restrained and by AEQR as MSC Nastran prints them.

use fullaircraft::{Elastic, TrimDeck, deck_cases};
use nastran::parse_deck;
use std::fmt::Write as _;

/// A clamped flat wing of 1.829 by 7 m of 40 by 20 boxes with an aileron, splined to all grids, those of the clamp among them (the wing of Goland in
/// an aeroelastic project whose answers MSC Nastran 2023.1 printed: github.com/Andrea24900/Aeroelasticity-Project, `folandwing/rolltest`).
fn clamped(elastic_share: f64) -> String {
    let mut deck = format!(
        "SOL 144\nCEND\nSPC = 1\nTRIM = 1\nBEGIN BULK\nCORD2R,3,0,0.,6.3,0.,0.,6.3,1.\n,1.,6.3,0.\nAESTAT,1,ANGLEA\n\
         TRIM,1,.029,6125.,ANGLEA,0.,AILERON,.0872222,{elastic_share:?}\nAEROS,0,0,1.829,7.,12.803,0,0\n\
         AESURF,1,AILERON,3,1\nAELIST,1,721,THRU,800\nSPC1,1,123456,1\nMAT1,1,1.,1.\n\
         PBAR,1,1,1.+10,9.77+7,9770000.,988000.\nPAERO1,1\nCAERO1,1,1,0,40,20,,,1\n,-.60357,0.,0.,1.829,-.60357,7.,0.,1.829\n\
         SET1,1,1,THRU,13,101,THRU,113,201,THRU,213\nSPLINE1,1,1,1,800,1,0.,IPS,BOTH\n"
    );
    for at in 0..13_u32 {
        let y = if at < 11 { 0.6096 * f64::from(at) } else { [6.3, 7.0][at as usize - 11] };
        for (first, x) in [(1, 0.0), (101, -0.60357), (201, 1.22543)] {
            let _ = writeln!(deck, "GRID,{},,{x:?},{y:?},0.", first + at);
        }
        let _ = writeln!(deck, "RBE2,{},{},123456,{},{}", 300 + at, 1 + at, 101 + at, 201 + at);
        if (1..13).contains(&at) {
            let _ = writeln!(deck, "CBAR,{at},1,{at},{},1.,0.,0.", at + 1);
        }
    }
    deck
}

#[test]
fn air_on_held_motions_counts_for_the_rigid_aircraft_alone_as_msc_prints() {
    let bulk = parse_deck("clamped.bdf", &clamped(0.0)).expect("a deck");
    let case = &deck_cases(&bulk).expect("a trim")[0];
    let deck = TrimDeck::new(&bulk.in_subcase(&case.subcase).expect("a subcase"), 0.029).expect("a wing");
    let of = |all: std::collections::BTreeMap<String, [f64; 6]>| {
        let [alpha, aileron] = ["ANGLEA", "AILERON"].map(|name| all[name]);
        [alpha[2], alpha[4], aileron[2], aileron[4]]
    };
    // Without a share of the deformations (AEQR 0) restrained is splined.
    let printed = [3.551_520, 0.344_908_7, 0.218_431_0, 0.027_065_8];
    let by_card = |elastic| of(deck.derivatives_of_card(&case.trim, elastic));
    for all in [of(deck.splined_derivatives()), by_card(Elastic::Restrained)] {
        for (own, printed) in all.into_iter().zip(printed) {
            assert!((own / printed - 1.0).abs() < 2e-6, "{own}, printed {printed}");
        }
    }
    let unsplined = by_card(Elastic::Rigid)[0];
    assert!((unsplined / 3.605_892 - 1.0).abs() < 1e-6, "{unsplined}");
    // All of the deformations count by AEQR 1, the default.
    let whole = deck.derivatives(case.trim.q, Elastic::Restrained)["ANGLEA"][2];
    assert!((whole / printed[0] - 1.0).abs() > 0.05, "{whole}");
}

#[test]
fn what_the_halves_of_an_antisymmetric_aircraft_cancel_is_zero() {
    let text = clamped(1.0).replace("12.803,0,0", "12.803,-1,0").replace("ANGLEA", "ROLL");
    let bulk = parse_deck("clamped.bdf", &text).expect("a deck");
    let case = &deck_cases(&bulk).expect("a trim")[0];
    let deck = TrimDeck::new(&bulk.in_subcase(&case.subcase).expect("a subcase"), 0.029).expect("a wing");
    let all = [Elastic::Rigid, Elastic::Restrained].map(|elastic| deck.derivatives(6125.0, elastic));
    for all in all.into_iter().chain([deck.splined_derivatives()]) {
        let aileron = all["AILERON"];
        assert_eq!([aileron[0], aileron[2], aileron[4]], [0.0; 3]);
        assert!(aileron[3].abs() > 0.01, "{aileron:?}");
    }
}
