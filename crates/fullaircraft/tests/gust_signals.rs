//! Functions of dynamic loads (TLOAD1, TLOAD2, RLOAD1, RLOAD2, DLOAD): in time, and their transforms.

use crate::deck_gust::spring;
use faer::c64;
use fullaircraft::{GustDeck, gust_cases};
use std::f64::consts::TAU;

/// Frequencies at which transforms are taken, Hz; at 3 Hz a wave of the deck is at rest.
const HZ: [f64; 6] = [0.0, 1e-6, 0.1, 2.9, 3.0, 19.0];

fn unit(angle: f64) -> c64 {
    c64::new(angle.cos(), angle.sin())
}

/// Transform at [`HZ`] and values in time, every hundred thousandth of a second to one second, of a set.
fn function(set: u32, cards: &str) -> (Vec<c64>, Vec<f64>) {
    let hz: Vec<String> = HZ.iter().map(|hz| format!("{hz:?}")).collect();
    let control = format!("DLOAD = {set}\nFREQ = 10\nTSTEP = 11\n");
    let bulk = spring(
        &control,
        &format!("{cards}FREQ,10,{}\nTSTEP,11,100000,1.-5\n", hz.join(",").replace("e-", ".-")),
    );
    assert!(bulk.air_errors.is_empty(), "{:?}", bulk.air_errors);
    let case = gust_cases(&bulk).unwrap_or_else(|error| panic!("{error}")).remove(0);
    let deck = GustDeck::new(&bulk, &case.subcase, &[&case]).expect("a deck");
    let answer = deck.answer(&case).expect("an answer");
    let time = deck.in_time(&case, &answer).map(|time| time.excitation).unwrap_or_default();
    (answer.excitation, time)
}

#[test]
fn transforms_are_the_integrals_of_what_the_loads_are_in_time() {
    let cards = "TLOAD2,1,9,,,.1,.5,3.,40.\n,-2.\nTLOAD2,2,9,.2,,0.,.4,1.,10.\n,.5,2.\nTLOAD1,3,9,.05,,7\n\
                 TABLED1,7,,,,,,,\n,.1,1.,.3,-2.,.3,1.,.6,.5\n,ENDT\nDLOAD,4,2.,1.,1,-3.,2,1.,3\n";
    for set in 1..=4 {
        let (transform, values) = function(set, cards);
        for (hz, ours) in HZ.into_iter().zip(transform) {
            let turned = |(i, value): (usize, &f64)| unit(-TAU * hz * 1e-5 * i as f64) * (value * 1e-5);
            let sum: c64 = values.iter().enumerate().map(turned).sum();
            assert!((ours - sum).norm() < 5e-5, "set {set} at {hz} Hz: {ours} {sum}");
        }
    }
    // A wave of sin² has its area: 0.5, at its own frequency a quarter of its length, -0.25.
    let (transform, _) =
        function(5, "DLOAD,5,.5,1.,51,-1.,52\nTLOAD2,51,9,,,0.,1.,0.\nTLOAD2,52,9,,,0.,1.,3.\n");
    assert!((transform[0] - c64::new(0.5, 0.0)).norm() < 1e-12, "{}", transform[0]);
    assert!((transform[4] - c64::new(-0.25, 0.0)).norm() < 1e-12, "{}", transform[4]);
}

#[test]
fn loads_over_frequency_are_their_tables_turned_by_phase_and_delay() {
    let cards = "RLOAD1,1,9,.1,30.,7,8\nRLOAD2,2,9,,,7,8\nTABLED1,7,,,,,,,\n,0.,1.,10.,3.\n,ENDT\nTABLED1,8,,,,,,,\n,0.,0.,10.,20.\n,ENDT\n";
    for (at, hz) in HZ.into_iter().enumerate() {
        let (real, imaginary) = (1.0 + 0.2 * hz, 2.0 * hz);
        let parts = c64::new(real, imaginary) * unit(30.0_f64.to_radians() - TAU * hz * 0.1);
        let (one, two) = (function(1, cards).0[at], function(2, cards).0[at]);
        assert!((one - parts).norm() < 1e-10, "at {hz} Hz: {one} {parts}");
        assert!((two - unit(imaginary.to_radians()) * real).norm() < 1e-10, "at {hz} Hz: {two}");
    }
}

#[test]
fn what_is_not_read_of_a_load_is_refused_by_its_name() {
    let why = |cards: &str| {
        let bulk = spring("DLOAD = 1\nFREQ = 10\n", &format!("{cards}FREQ,10,1.\n"));
        gust_cases(&bulk).expect_err("it is not read").to_string()
    };
    assert!(why("TLOAD1,1,9,,ACCE,7\nTABLED1,7\n,0.,1.,2.,3.,ENDT\n").contains("enforces a motion"));
    assert!(why("RLOAD1,1,9,5,,7\n").contains("DELAY or DPHASE"));
    assert!(why("TLOAD1,1,9,,,7\n").contains("table 7"));
    assert!(why("TLOAD1,1,9,,,7\nTABLED1,7,LOG\n,1.,1.,2.,3.,ENDT\n").contains("LOG axis"));
    assert!(why("DLOAD,1,1.,1.,3\n").contains("no TLOAD or RLOAD 3"));
}
