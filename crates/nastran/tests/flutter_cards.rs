//! Cards of flutter as Nastran's Quick Reference Guide describes them.

use nastran::{FlutterMethod, parse_deck};

#[test]
fn a_list_through_a_middle_value_has_that_value_in_its_middle_and_equal_steps_of_the_reciprocal() {
    // 0.1333 is the harmonic mean of the ends: then the reciprocals are equally far apart.
    let deck =
        parse_deck("deck", "FLFACT,1,.2,THRU,.1,11,.13333333333333333\nFLFACT,2,1.,THRU,3.,3\n").unwrap();
    let values = &deck.flutter_factors[&1].values;
    assert_eq!(values.len(), 11);
    for (i, value) in values.iter().enumerate() {
        assert!((1.0 / value - (5.0 + 0.5 * i as f64)).abs() < 1e-9, "{values:?}");
    }
    assert_eq!(deck.flutter_factors[&2].values, [1.0, 2.0, 3.0]);
    let error = parse_deck("deck", "FLFACT,1,.2,THRU,.1,11,.3\n").unwrap().air_errors.remove(0);
    assert!(error.to_string().contains("FMID"), "{error}");
}

#[test]
fn every_mach_number_goes_with_every_frequency_of_its_card_and_pairs_stay_pairs() {
    let deck = "MKAERO1,0.,.5,,,,,,\n,.1,.2\nMKAERO2,.7,.3,.8,.4\n";
    let cards = parse_deck("deck", deck).unwrap().reduced_frequencies;
    assert_eq!(cards[0].pairs, [(0.0, 0.1), (0.0, 0.2), (0.5, 0.1), (0.5, 0.2)]);
    assert_eq!(cards[1].pairs, [(0.7, 0.3), (0.8, 0.4)]);
}

#[test]
fn damping_is_read_between_points_and_drawn_on_beyond_them_in_all_three_units() {
    let deck = "TABDMP1,1,,,,,,,\n,1.,.01,3.,.03,ENDT\nTABDMP1,2,CRIT,,,,,,\n,0.,.02,ENDT\nTABDMP1,3,Q,,,,,,\n,0.,50.,9.,50.,ENDT\n";
    let tables = parse_deck("deck", deck).unwrap().damping_tables;
    for (hz, g) in [(0.5, 0.005), (1.0, 0.01), (2.0, 0.02), (3.0, 0.03), (9.0, 0.09)] {
        assert!((tables[&1].structural_damping(hz) - g).abs() < 1e-15, "{hz} Hz");
    }
    assert_eq!(tables[&2].structural_damping(7.0), 0.04);
    assert_eq!(tables[&3].structural_damping(7.0), 0.02);
}

#[test]
fn the_case_control_selects_flutter_damping_loads_and_temperatures() {
    let deck = "CEND\nMETHOD = 3\nSUBCASE 1\nFMETHOD = 5\nSDAMPING = 6\nSUBCASE 2\nLOAD = 7\nTEMP(INIT) = 8\nSUBCASE 3\n\
                TEMPERATURE(LOAD) = 9\nBEGIN BULK\n";
    let cases = parse_deck("deck", deck).unwrap().subcases;
    assert_eq!((cases[0].flutter, cases[0].damping, cases[0].load), (Some(5), Some(6), None));
    assert_eq!((cases[1].flutter, cases[1].load, cases[1].temperature), (None, Some(7), None));
    assert_eq!(cases[2].temperature, Some(9));
}

#[test]
fn methods_are_read_by_their_names_and_others_refused_by_theirs() {
    let method = |name: &str| {
        let mut deck = parse_deck("deck", &format!("FLUTTER,1,{name},2,3,4\n")).unwrap();
        deck.flutters.remove(&1).map(|card| card.method).ok_or_else(|| deck.air_errors.remove(0).to_string())
    };
    assert_eq!(method("PK"), Ok(FlutterMethod::Pk));
    assert_eq!(method("PKNL"), Ok(FlutterMethod::Pknl));
    assert_eq!(method("KE"), Ok(FlutterMethod::K { is_efficient: true }));
    assert!(method("PKX").unwrap_err().contains("METHOD"));
}
