//! Which points a FLUTTER card asks for, of short lists.

use super::{FlutterPoints, flutter_cases, points};
use aero::Flow;
use nastran::{BulkData, parse_deck};

/// A deck of a method with densities 1 and 2, two Mach numbers and four speeds.
fn deck(method: &str, lists: &str) -> BulkData {
    let deck = format!("AERO,,1.,2.,1.25\nFLUTTER,1,{method},11,12,13,L\n{lists}\n");
    let bulk = parse_deck("t.bdf", &deck).expect("a deck");
    assert!(bulk.air_errors.is_empty(), "{:?}", bulk.air_errors);
    bulk
}

fn asked(bulk: &BulkData) -> Result<Vec<FlutterPoints>, String> {
    let aero = bulk.unsteady_reference.as_ref().expect("AERO");
    points(bulk, &bulk.flutters[&1], aero).map_err(|error| error.to_string())
}

fn flows(of: &[(f64, f64)]) -> Vec<Flow> {
    of.iter().map(|&(v_m_s, rho_kg_m3)| Flow { v_m_s, rho_kg_m3 }).collect()
}

#[test]
fn pk_takes_each_mach_number_with_each_density_and_airspeeds_rising_once_each() {
    let lists = "FLFACT,11,1.,2.\nFLFACT,12,.3,.5\nFLFACT,13,30.,-10.,20.,10.";
    let found = asked(&deck("PK", lists)).expect("points");
    let of = |mach: f64, rho: f64| FlutterPoints::Speeds {
        mach,
        flows: flows(&[(10.0, rho), (20.0, rho), (30.0, rho)]),
    };
    assert_eq!(found, vec![of(0.3, 1.25), of(0.3, 2.5), of(0.5, 1.25), of(0.5, 2.5)]);
    let machs: Vec<f64> = found.iter().flat_map(FlutterPoints::machs).collect();
    assert_eq!(machs, vec![0.3, 0.3, 0.5, 0.5]);
}

#[test]
fn k_takes_reduced_frequencies_in_their_order_and_ke_leaves_damping_out() {
    let lists = "FLFACT,11,2.\nFLFACT,12,.3\nFLFACT,13,.4,.2,.3";
    for (method, is_damped) in [("K", true), ("KE", false)] {
        let found = asked(&deck(method, lists)).expect("points");
        let law = FlutterPoints::Frequencies { mach: 0.3, density: 2.5, ks: vec![0.4, 0.2, 0.3], is_damped };
        assert_eq!(found, vec![law]);
        assert_eq!(found[0].machs(), vec![0.3]);
    }
}

#[test]
fn matched_points_are_one_group_if_airspeeds_rise_else_one_for_each_run_of_a_mach_number() {
    let of = |machs: &str, speeds: &str| {
        asked(&deck("PKNL", &format!("FLFACT,11,1.,2.,1.\nFLFACT,12,{machs}\nFLFACT,13,{speeds}")))
    };
    let rising = flows(&[(10.0, 1.25), (20.0, 2.5), (30.0, 1.25)]);
    let machs = vec![0.3, 0.5, 0.5];
    let matched = FlutterPoints::Matched { machs: machs.clone(), flows: rising.clone() };
    assert_eq!(matched.machs(), machs);
    assert_eq!(of(".3,.5,.5", "10.,20.,30.").expect("points"), vec![matched]);
    let one = FlutterPoints::Speeds { mach: 0.3, flows: rising };
    assert_eq!(of(".3,.3,.3", "10.,20.,30.").expect("points"), vec![one]);
    let falling = of(".3,.5,.5", "10.,30.,20.").expect("points");
    let groups = vec![
        FlutterPoints::Speeds { mach: 0.3, flows: flows(&[(10.0, 1.25)]) },
        FlutterPoints::Speeds { mach: 0.5, flows: flows(&[(30.0, 2.5), (20.0, 1.25)]) },
    ];
    assert_eq!(falling, groups);
    // the same airspeed twice does not rise; the same point twice is one
    assert_eq!(of(".3,.5,.5", "10.,20.,20.").expect("points").len(), 2);
    let twice = asked(&deck("PKNL", "FLFACT,11,1.,1.\nFLFACT,12,.3,.3\nFLFACT,13,10.,-10.")).expect("points");
    assert_eq!(twice, vec![FlutterPoints::Speeds { mach: 0.3, flows: flows(&[(10.0, 1.25)]) }]);
    for (machs, speeds) in [(".3,.5", "10.,20.,30."), (".3,.3,.3", "10.,20.")] {
        assert!(of(machs, speeds).expect_err("lengths").contains("one by one"));
    }
}

#[test]
fn lists_that_are_not_there_and_numbers_that_are_not_above_zero_are_refused() {
    let of = |lists: &str| asked(&deck("PK", lists)).expect_err("it is wrong");
    assert!(of("FLFACT,11,1.\nFLFACT,12,.3").contains("FLFACT 13, the airspeeds"));
    assert!(of("FLFACT,11,1.\nFLFACT,13,10.").contains("FLFACT 12, the Mach numbers"));
    assert!(of("FLFACT,11,0.\nFLFACT,12,.3\nFLFACT,13,10.").contains("density ratios"));
    assert!(of("FLFACT,11,1.\nFLFACT,12,.3\nFLFACT,13,0.").contains("airspeeds or reduced"));
}

#[test]
fn subcases_select_flutter_and_without_case_control_the_only_card_counts() {
    let lists = "FLFACT,11,1.\nFLFACT,12,.3\nFLFACT,13,10.";
    let bulk = deck("PK", lists);
    assert_eq!(flutter_cases(&bulk).expect("one").len(), 1);
    let two = parse_deck("t.bdf", "FLUTTER,1,PK,1,1,1\nFLUTTER,2,PK,1,1,1\n").expect("a deck");
    assert!(flutter_cases(&two).expect_err("which?").to_string().contains("no flutter"));
    let control = "SOL 145\nCEND\nSUBCASE 1\nFMETHOD = 2\nSUBCASE 2\nFMETHOD = 1\nSUBCASE 3\nBEGIN BULK\n";
    let cards = "FLUTTER,1,PK,1,1,1\nFLUTTER,2,KE,1,1,1\n";
    let bulk = parse_deck("t.bdf", &format!("{control}{cards}")).expect("a deck");
    let found = flutter_cases(&bulk).expect("two");
    assert_eq!(found.iter().map(|(case, card)| (case.id, card.id)).collect::<Vec<_>>(), vec![(1, 2), (2, 1)]);
    let wrong = format!("{}{cards}", control.replace("FMETHOD = 2", "FMETHOD = 3"));
    let bulk = parse_deck("t.bdf", &wrong).expect("a deck");
    assert!(flutter_cases(&bulk).expect_err("not there").to_string().contains("FMETHOD 3"));
    // a subcase that selects none does not stop the only card; two of them do
    for (subcases, count) in [(1, Some(1)), (2, None)] {
        let control: String = ["SUBCASE 1\n", "SUBCASE 2\n"][..subcases].concat();
        let deck = format!("SOL 145\nCEND\n{control}BEGIN BULK\nFLUTTER,1,PK,1,1,1\n");
        let found = flutter_cases(&parse_deck("t.bdf", &deck).expect("a deck"));
        assert_eq!(found.ok().map(|cases| cases.len()), count);
    }
}
