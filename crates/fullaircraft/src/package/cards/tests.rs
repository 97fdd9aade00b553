//! Cards of cases and what holds a structure in the index, read back as a user's are.

use super::{CardCase, CardPart, Hold, comments, index_of};
use nastran::parse_deck;

fn hold(count: u32, equations: Option<u32>, support: Option<(u32, Vec<u8>)>) -> Hold {
    Hold { constraints: (11..11 + count).collect(), equations, set: 11 + count, support }
}

#[test]
fn the_index_unites_all_constraint_sets_with_the_hold_however_many_there_are() {
    for count in [0, 1, 5, 6, 7, 13, 14, 15, 22, 40] {
        for support in [None, Some((7, vec![1, 3, 5]))] {
            let text = index_of("wing.bdf", Some(&hold(count, Some(4), support.clone())), "t", &[], &[]);
            let cards = text.replace("INCLUDE 'wing.bdf'\n", "GRID,7,,0.,0.,0.\n");
            let read = parse_deck("index.bdf", &cards).unwrap_or_else(|error| panic!("{error}\n{text}"));
            let united: Vec<u32> = (11..11 + count).chain(support.iter().map(|_| 11 + count)).collect();
            let own: Vec<&Vec<u32>> = read.constraint_unions.values().map(|union| &union.sets).collect();
            let (set, law) = if count == 0 { (11, vec![]) } else { (12 + count, vec![&united]) };
            assert_eq!(own, law, "{text}");
            assert!(text.contains(&format!("\nSPC = {set}\nMPC = 4\n")), "{text}");
            let held: Vec<(u32, Vec<u8>, Vec<u32>)> = read
                .constraints
                .iter()
                .map(|card| (card.set, card.components.clone(), card.grids.clone()))
                .collect();
            assert_eq!(
                held,
                support.map(|(grid, c)| (11 + count, c, vec![grid])).into_iter().collect::<Vec<_>>()
            );
        }
    }
}

#[test]
fn a_hold_s_set_is_above_all_that_the_deck_uses() {
    let deck = "GRID,7,,0.,0.,0.\nSPC1,5,12,7\nSPC1,3,3,7\nSPC1,5,4,7\nMPC,6,7,1,1.,7,2,1.\n";
    let of = |more: &str, equations: Option<u32>| {
        let bulk = parse_deck("t.bdf", &format!("{deck}{more}")).expect("a deck");
        Hold::of(&bulk, equations, None)
    };
    let plain = of("", None);
    assert_eq!((plain.constraints, plain.set, plain.equations), (vec![3, 5], 6, Some(6)));
    let united = of("SPCADD,9,3,5\n", Some(2));
    assert_eq!((united.set, united.equations), (10, Some(2)));
    let free = Hold::of(&parse_deck("t.bdf", "GRID,7,,0.,0.,0.\n").expect("a deck"), None, None);
    assert_eq!((free.constraints.len(), free.set, free.equations), (0, 1, None));
}

fn case(parts: Vec<CardPart>) -> CardCase {
    let net = (1..=12).map(|load| f64::from(load) * 0.5).collect();
    CardCase { sid: 42, words: "pull-up\nat 30 m/s".to_owned(), net, parts }
}

#[test]
fn loads_written_at_grids_are_read_back_at_their_places() {
    let alone = case(Vec::new());
    assert_eq!(alone.file(), "case_00042.bdf");
    let text = alone.text(&[7, 9], &["made by hand".to_owned()]);
    assert!(text.starts_with("$ made by hand\n$ pull-up at 30 m/s\n$ net applied loads"), "{text}");
    let place = |grid: u32| [9, 7].iter().position(|known| *known == grid);
    let read = |case: &CardCase, text: &str| {
        let deck = parse_deck("case.bdf", text).expect("cards");
        case.read_back(&deck, 2, place).map_err(|error| error.to_string())
    };
    let turned: Vec<f64> = alone.net[6..].iter().chain(&alone.net[..6]).copied().collect();
    assert_eq!(read(&alone, &text).expect("loads"), turned, "the other way round, as the places are");
    // the air's and the rest's add up to the net loads
    let share = |by: f64| alone.net.iter().map(|load| load * by).collect::<Vec<f64>>();
    let parts = vec![
        CardPart { sid: 43, words: "air", loads: share(0.25) },
        CardPart { sid: 44, words: "the rest", loads: share(0.75) },
    ];
    let both = case(parts);
    let text = both.text(&[7, 9], &[]);
    assert!(
        text.contains("LOAD,42,1.,1.,43,1.,44\n") && text.contains("$ load set 44: the rest\n"),
        "{text}"
    );
    assert_eq!(read(&both, &text).expect("loads"), turned);
    let doubled = text.replace("LOAD,42,1.,1.,43,1.,44", "LOAD,42,2.,3.,43,1.,44");
    let law: Vec<f64> = turned.iter().map(|load| load * (6.0 * 0.25 + 2.0 * 0.75)).collect();
    assert_eq!(read(&both, &doubled).expect("loads"), law, "factors of a sum and of its parts");
    let other = text.replace("1.,44\n", "1.,45\n");
    assert!(read(&both, &other).expect_err("no such set").contains("of set 44 at grid 7 is not of case 42"));
    let elsewhere = alone.text(&[7, 8], &[]);
    assert!(read(&alone, &elsewhere).expect_err("no such grid").contains("at grid 8"));
}

#[test]
fn titles_are_cut_and_comments_stay_on_their_line() {
    let mut long = case(Vec::new());
    long.words = "x".repeat(70);
    let text = index_of("a.bdf", None, &"y".repeat(70), &[long], &["one\rtwo\nthree".to_owned()]);
    assert!(text.starts_with("$ one two three\nSOL 101\n"), "{text}");
    assert!(text.contains(&format!("TITLE = {}\nDISP", "y".repeat(64))), "{text}");
    assert!(text.contains(&format!("SUBCASE 42\n  SUBTITLE = {}\n  LOAD = 42\n", "x".repeat(64))), "{text}");
    assert!(text.ends_with("INCLUDE 'a.bdf'\nINCLUDE 'case_00042.bdf'\nENDDATA\n"), "{text}");
    assert_eq!(comments(&[]), "");
}
