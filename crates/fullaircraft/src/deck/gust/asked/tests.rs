//! What a deck asks of a gust: flow, frequencies, times, and what is refused.

use super::{GustCase, gust_cases};
use nastran::parse_deck;

const CONTROL: &str = "GUST = 7\nFREQ = 10\nTSTEP = 11\n";
const CARDS: &str = "AERO,,20.,2.,1.25\nGUST,7,8,1.,0.,16.\nTLOAD2,8,9,,,0.,1.,0.\nTSTEP,11,4,.5\n\
                     FREQ1,10,.5,.25,3\nFREQ,10,.75,.1\nPARAM,Q,200.\n";

fn asked(control: &str, cards: &str) -> Result<GustCase, String> {
    let deck = format!("SOL 146\nCEND\nSUBCASE 1\n{control}BEGIN BULK\n{cards}");
    let bulk = parse_deck("t.bdf", &deck).expect("a deck");
    assert!(bulk.air_errors.is_empty(), "{:?}", bulk.air_errors);
    gust_cases(&bulk).map(|mut cases| cases.remove(0)).map_err(|error| error.to_string())
}

fn said(case: &GustCase, words: &str) -> bool {
    case.remarks.iter().any(|remark| remark.contains(words))
}

#[test]
fn the_gust_s_airspeed_and_the_dynamic_pressure_of_the_deck_make_the_flow() {
    let case = asked(CONTROL, CARDS).expect("a case");
    // q = rho V²/2: 200 = rho 256/2
    assert_eq!((case.flow.v_m_s, case.mach), (16.0, 0.0));
    assert!(
        (case.flow.rho_kg_m3 - 1.5625).abs() < 1e-14
            && (case.flow.dynamic_pressure_pa() - 200.0).abs() < 1e-12
    );
    assert_eq!(case.remarks.len(), 1, "{:?}", case.remarks);
    assert!(said(&case, "VELOCITY of AERO is 20 and V of GUST 16"));
    assert_eq!(case.hz, vec![0.1, 0.5, 0.75, 1.0, 1.25]);
    assert_eq!(case.times_s.expect("times").last(), Some(&2.0));
    // an airspeed that is the gust's to a thousandth is no other
    for (aero, other) in [("16.01", false), ("16.02", true), ("15.99", false), ("15.98", true)] {
        let cards = CARDS.replace("AERO,,20.", &format!("AERO,,{aero}"));
        let case = asked(CONTROL, &cards).expect("a case");
        assert_eq!(said(&case, "the gust's is taken"), other, "{aero}");
    }
}

#[test]
fn without_a_dynamic_pressure_density_of_aero_makes_it_and_without_a_gust_its_velocity() {
    let case = asked(CONTROL, &CARDS.replace("PARAM,Q,200.", "PARAM,MACH,.4")).expect("a case");
    assert_eq!((case.flow.rho_kg_m3, case.mach), (1.25, 0.4));
    // 1.25 256/2
    assert!(said(&case, "RHOREF of AERO gives 160"), "{:?}", case.remarks);
    let case = asked("DLOAD = 8\nFREQ = 10\n", CARDS).expect("a case");
    assert_eq!(case.flow.v_m_s, 20.0);
    assert!((case.flow.rho_kg_m3 - 1.0).abs() < 1e-14 && case.gust.is_none());
    assert!(said(&case, "no TSTEP is selected") && case.times_s.is_none());
    let case = asked(
        "DLOAD = 8\nFREQ = 10\nTSTEP = 11\n",
        &CARDS.replace("TLOAD2,8,9,,,0.,1.,0.", "RLOAD1,8,9,,,1."),
    );
    let case = case.expect("a case");
    assert!(case.times_s.is_none() && !said(&case, "TSTEP"), "over frequency no times are asked for");
}

#[test]
fn numbers_that_no_gust_can_have_are_refused() {
    let refused = |from: &str, to: &str| asked(CONTROL, &CARDS.replace(from, to)).expect_err("it is wrong");
    assert!(refused("PARAM,Q,200.", "PARAM,Q,0.").contains("PARAM Q is 0"));
    assert!(refused("PARAM,Q,200.", "PARAM,MACH,1.").contains("subsonic"));
    assert!(refused("PARAM,Q,200.", "PARAM,MACH,-.1").contains("subsonic"));
    assert!(refused("AERO,,20.,2.,1.25\n", "").contains("has no AERO"));
    assert!(refused("FREQ1,10,.5,.25,3\nFREQ,10,.75,.1\n", "FREQ,12,1.\n").contains("FREQUENCY 10"));
    assert!(refused("TSTEP,11", "TSTEP,12").contains("TSTEP 11"));
    assert!(refused("GUST,7", "GUST,6").contains("GUST 7"));
    assert!(refused("FREQ1,10,.5,.25,3", "FREQ4,10,1.,9.").contains("FREQ4 gives frequencies by the modes"));
    assert!(asked("GUST = 7\n", CARDS).expect_err("none").contains("selects no FREQUENCY"));
    assert!(asked("FREQ = 10\n", CARDS).expect_err("none").contains("asks for no gust"));
    let still = asked("DLOAD = 8\nFREQ = 10\n", &CARDS.replace("AERO,,20.", "AERO,,0."));
    assert!(still.expect_err("no airspeed").contains("no VELOCITY above zero"));
    let mixed = format!("{CARDS}RLOAD1,18,9,,,1.\n");
    let mixed = asked(&format!("{CONTROL}DLOAD = 18\n"), &mixed).expect_err("both");
    assert!(mixed.contains("mixes loads in time"), "{mixed}");
    assert!(asked(&format!("{CONTROL}DLOAD = 8\n"), CARDS).is_ok(), "both in time");
}

#[test]
fn frequencies_that_are_the_same_to_nine_digits_count_once() {
    let cards = CARDS.replace("FREQ,10,.75,.1", "FREQ,10,.7500000005,.75000001");
    let hz = asked(CONTROL, &cards).expect("a case").hz;
    assert_eq!(hz.len(), 5, "{hz:?}");
}
