//! Cards of gusts and dynamic loads as Nastran's Quick Reference Guide describes them.

use nastran::{Asked, LoadFunction, SpectrumShape, TableOr, parse_deck};
use std::collections::BTreeSet;

#[test]
fn frequencies_of_a_set_are_lists_equal_steps_and_equal_ratios() {
    let deck = "FREQ,1,2.,.5\nFREQ1,1,3.,.25,2\nFREQ2,1,1.,16.,4\nFREQ1,2,0.,.5\n";
    let cards = parse_deck("deck", deck).unwrap().frequencies;
    let lists: Vec<&[f64]> = cards.iter().map(|card| card.hz.as_slice()).collect();
    assert_eq!(lists[0], [2.0, 0.5]);
    assert_eq!(lists[1], [3.0, 3.25, 3.5]);
    for (hz, expected) in lists[2].iter().zip([1.0, 2.0, 4.0, 8.0, 16.0]) {
        assert!((hz - expected).abs() < 1e-12, "{hz} {expected}");
    }
    assert_eq!((cards[3].set, lists[3]), (2, [0.0, 0.5].as_slice()), "one step without a number of them");
}

#[test]
fn time_steps_follow_each_other_and_every_so_many_are_written() {
    let deck = "TSTEP,1,4,.5,2\n,,3,.1,1\nTSTEP,2,5,.1,2\n";
    let cards = parse_deck("deck", deck).unwrap();
    assert!(cards.air_errors.is_empty(), "{:?}", cards.air_errors);
    let near = |id: u32, expected: &[f64]| {
        let times = cards.time_steps[&id].times();
        assert_eq!(times.len(), expected.len(), "{times:?}");
        assert!(times.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{times:?}");
    };
    near(1, &[0.0, 1.0, 2.0, 2.1, 2.2, 2.3]);
    near(2, &[0.0, 0.2, 0.4, 0.5]);
}

#[test]
fn tables_are_straight_lines_on_their_axes_drawn_on_beyond_the_ends_with_means_at_jumps() {
    let deck = "TABLED1,1,,,,,,,\n,0.,1.,2.,3.,2.,5.,3.,5.\n,ENDT\nTABLED1,2,LOG,LOG,,,,,\n,1.,2.,100.,200.,ENDT\n\
                TABLED2,3,1.,,,,,,\n,0.,1.,2.,3.,ENDT\nTABLED3,4,1.,2.,,,,,\n,0.,1.,2.,3.,SKIP,SKIP,ENDT\n";
    let deck = parse_deck("deck", deck).unwrap();
    assert!(deck.air_errors.is_empty(), "{:?}", deck.air_errors);
    let cases = [
        (1, 1.0, 2.0),
        (1, 2.0, 4.0),
        (1, 2.5, 5.0),
        (1, -1.0, 0.0),
        (2, 10.0, 20.0),
        (3, 2.0, 2.0),
        (4, 3.0, 2.0),
        (4, 9.0, 5.0),
    ];
    for (id, x, expected) in cases {
        let y = deck.function_tables[&id].at(x);
        assert!((y - expected).abs() < 1e-12, "table {id} at {x}: {y}");
    }
    let points = [(1.0, 2.0), (3.0, 4.0)];
    let density = |hz: f64| SpectrumShape::of_points(&points, [false; 2], hz);
    assert_eq!(
        (density(0.9), density(2.0), density(3.1)),
        (0.0, 3.0, 0.0),
        "nothing beyond a spectrum's points"
    );
    for wrong in ["TABLED1,1,,,,,,,\n,1.,1.,0.,3.,ENDT\n", "TABLED1,1,LOG,,,,,,\n,0.,1.,2.,3.,ENDT\n"] {
        assert_eq!(parse_deck("deck", wrong).unwrap().air_errors.len(), 1, "{wrong}");
    }
}

#[test]
fn loads_name_tables_by_whole_numbers_and_give_values_by_reals() {
    let deck = "TLOAD2,1,9,.5,,1.,2.,3.,90.\n,-1.,2.\nTLOAD1,2,9,,,7\nRLOAD1,3,9,4,30.,7\nRLOAD2,4,9,,5,1.,7\n\
                TLOAD1,5,9,,ACCE,7\nTLOAD2,6,9,,,2.,1.\nDAREA,9,1,3,2.,4,,3.\n";
    let deck = parse_deck("deck", deck).unwrap();
    let load = |id: u32| &deck.dynamic_loads[&id];
    let wave = LoadFunction::Wave { times: [1.0, 2.0], hz: 3.0, phase_deg: 90.0, growth: -1.0, power: 2.0 };
    assert_eq!((load(1).delay, &load(1).function, load(1).is_in_time()), (0.5, &wave, true));
    assert_eq!(load(2).function, LoadFunction::Table(TableOr::Table(7)));
    assert_eq!((load(3).delay_set, load(3).phase_deg, load(3).is_in_time()), (4, 30.0, false));
    let polar = LoadFunction::Polar { amplitude: TableOr::Constant(1.0), phase_deg: TableOr::Table(7) };
    assert_eq!((load(4).phase_set, &load(4).function), (5, &polar));
    assert_eq!((load(2).kind.as_str(), load(5).kind.as_str()), ("LOAD", "ACCE"));
    assert!(!deck.dynamic_loads.contains_key(&6) && deck.air_errors[0].to_string().contains("after T1"));
    let areas: Vec<(u32, u8, f64)> =
        deck.load_areas.iter().map(|card| (card.point, card.component, card.value)).collect();
    assert_eq!(areas, [(1, 3, 2.0), (4, 0, 3.0)]);
}

#[test]
fn the_case_control_selects_gusts_and_points_by_sets_over_several_lines() {
    let deck = "CEND\nset 100 = 101,116 ,117,\n   5 THRU 7\nDISP=100\nSDAMP = 3\nK2PP = stiff\nSUBCASE 10\nANALYSIS=MODES\n\
                SUBCASE 20\nGUST = 1000\nDLOAD   = 1100\nFREQ = 40\nTSTEP = 50\nACCE(PLOT) = ALL\nSUBCASE 30\nFREQUENCY=41\n\
                SET 4 = 9\nVELO = 4\nRANDOM = 6\nBEGIN BULK\nDMIG,STIFF,0,6,1,0\nDMIG,STIFF,1000,0,,1001,2,1.\n,1002,0,1.\n";
    let deck = parse_deck("deck", deck).unwrap();
    let [modes, gust, random] = deck.subcases.as_slice() else { panic!("{:?}", deck.subcases) };
    let set = BTreeSet::from([101, 116, 117, 5, 6, 7]);
    assert_eq!((modes.gust, &modes.responses), (None, &Asked::Of(set.clone())));
    assert_eq!((gust.gust, gust.dynamic_load), (Some(1000), Some(1100)));
    assert_eq!((gust.frequencies, gust.time_steps, gust.random), (Some(40), Some(50), None));
    assert_eq!(
        (&gust.responses, gust.direct.as_slice()),
        (&Asked::All, ["K2PP STIFF".to_owned()].as_slice())
    );
    let more = Asked::Of(set.into_iter().chain([9]).collect());
    assert_eq!((random.frequencies, random.random, &random.responses), (Some(41), Some(6), &more));
    let points: Vec<u32> = deck.direct_matrices.iter().flat_map(nastran::Dmig::points).collect();
    assert_eq!(points, [1000, 1001, 1002]);
}

#[test]
fn spectra_of_turbulence_have_type_scale_and_rms_and_pairs_of_subcases_rise() {
    let deck = "TABRNDG,1,1,2.,3.\nTABRNDG,2,3,2.,3.\nRANDPS,5,1,2,.5,.25,1\nRANDPS,5,2,1,1.\n";
    let deck = parse_deck("deck", deck).unwrap();
    let shape = SpectrumShape::Turbulence { is_karman: true, scale_s: 2.0, rms: 3.0 };
    assert_eq!(deck.spectrum_tables[&1].shape, shape);
    let card = &deck.spectra[0];
    assert_eq!((card.set, card.subcases, card.factor, card.table), (5, [1, 2], [0.5, 0.25], 1));
    let why: Vec<String> = deck.air_errors.iter().map(ToString::to_string).collect();
    assert!(why[0].contains("von Karman") && why[1].contains("J or more"), "{why:?}");
}
