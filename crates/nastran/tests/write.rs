//! Decks and loads at grids out and in again.

use nastran::{load_cards, parse_deck, write_deck};
use proptest::prelude::*;

/// Every card that is read, with values that need more than 8 characters.
const EVERYTHING: &str = concat!(
    "CORD2R,5,,1.,2.,3.,1.,2.,4.\n,2.123456789,2.,3.\nCORD1R,6,1,2,3\n",
    "GRID,1,5,1.23456789012-7,-2.,.25,6,246\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\nGRID,4000000000,,1.,1.,9.\n",
    "CBAR,10,1,1,2,0.,0.123456789,1.\nCBEAM,11,2,1,2,3\n,45,,0.,.1,0.,.2\n",
    "PBAR,1,2,.1,.2,.3,.4,.5\n,1.,1.,1.,1.\n,.8,.9,.05\n",
    "PBEAM,2,2,1.,2.,3.,.5,4.,.25\n,,,,,,,,\n+,YESA,1.,3.,4.,,,8.\n+,NO,.5,,2.5\n+,,,,,.1,,,\n+,.01,.02,,,.03,.04,.05,.06\n",
    "PBEAM,3,2,1.,2.,3.123456789\nMAT1,2,7.+10,,.333333333,2700.\n",
    "CONM2,1,2,-1,3.,.1,.2,.3\n,1.,2.,3.,4.,5.,6.123456789\nRBE2,5,1,123,2,3\nSPC1,1,246,4,THRU,17\n",
    "CAERO1,1001,1,,8,,,3,1\n,0.,0.,0.,.3,.1,1.812345678,0.,.15\nPAERO1,1\nAEFACT,3,0.,.3333333333,1.\n",
    "AESURF,9,aileron,5,8\nAELIST,8,1001,THRU,1003,1010\nSET1,4,1,THRU,3,9\n",
    "MONPNT1 WING    Right wing, root: bending and torsion\n        246     WINGCOMP        .0751234.1      0.\n",
    "MONPNT3,ROOT,Root\n,123456,6,,5,.5123456789,0.,0.\n,6\n",
    "DMI,WKK,0,3,1,0,,4,1\nDMI,WKK,1,1,1.2,THRU,3\nCSEAM,1,2\n"
);

/// A deck without the places, which differ between a file and its copy.
fn without_places(text: &str) -> String {
    let deck = parse_deck("t.bdf", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let debug = format!("{deck:?}");
    let mut parts = debug.split("Span {");
    let mut kept = parts.next().unwrap_or("").to_owned();
    for part in parts {
        kept.push_str(part.split_once('}').expect("spans end").1);
    }
    kept
}

#[test]
fn a_written_deck_says_the_same() {
    let deck = parse_deck("t.bdf", EVERYTHING).unwrap_or_else(|error| panic!("{error}"));
    let written = write_deck(&deck);
    assert!(written.starts_with("$ not written because not read: 1 CSEAM\nBEGIN BULK\n"));
    let mat1 = parse_deck("t.bdf", &written).expect("our own deck").materials[&2].clone();
    // G = E / 2 (1 + nu) is the only number here that 16 characters do not hold.
    let g = deck.materials[&2].g;
    assert!((mat1.g - g).abs() < 1e-11 * g);
    // the last field is what was not read
    let read =
        |text: &str| without_places(text).rsplit_once("unknown: ").expect("the last field").0.to_owned();
    let original = read(EVERYTHING).replace(&format!("g: {g:?}"), &format!("g: {:?}", mat1.g));
    assert_eq!(read(&written), original);
    assert!(written.lines().all(|line| line.len() <= 72));
}

#[test]
fn a_written_deck_is_written_again_in_the_same_way() {
    let once = write_deck(&parse_deck("t.bdf", EVERYTHING).expect("a good deck"));
    let twice = write_deck(&parse_deck("t.bdf", &once).expect("our own deck"));
    assert_eq!(once.split_once('\n').expect("lines").1, twice);
}

#[test]
fn eight_characters_are_used_where_they_are_enough() {
    let written = write_deck(
        &parse_deck("t.bdf", "GRID,1,,1.,2.,3.\nGRID,2,,1.23456789,2.,3.\n").expect("a good deck"),
    );
    let expected = concat!(
        "BEGIN BULK\n",
        "GRID           1       0     1.0     2.0     3.0       0\n",
        "GRID*                  2               0      1.23456789             2.0\n",
        "*                    3.0               0\n",
        "ENDDATA\n"
    );
    assert_eq!(written, expected);
}

#[test]
fn numbers_of_any_size_keep_ten_digits_and_nothing_is_nothing() {
    // near powers of ten, very large, very small beside others of their kind
    let forces = [-1.5e10, 999.999_999_949_9, 0.1, 1.000_000_000_1, -0.099_999_999_99, 123.456_789_012_3];
    for (place, &force) in forces.iter().enumerate() {
        for scale in [1.0, 1e-12, 1e-5, 1e7] {
            let mut loads = vec![0.0; 12];
            (loads[place % 3], loads[6 + 3 + place % 3]) = (force * scale, -force * scale);
            let deck = parse_deck("cards", &load_cards(7, &[11, 12], &loads)).unwrap();
            assert_eq!(deck.point_loads.len(), 2, "one force, one moment");
            for card in &deck.point_loads {
                assert_eq!((card.set, card.grid, card.cid), (7, if card.is_moment { 12 } else { 11 }, 0));
                let sign = if card.is_moment { -1.0 } else { 1.0 };
                let (read, written) = (card.vector[place % 3], sign * force * scale);
                assert!((read - written).abs() <= 5e-11 * written.abs(), "{read} for {written}");
            }
        }
    }
    let text = load_cards(1, &[1, 2], &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-13, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(text.matches("FORCE*").count(), 1, "beside 1 N, 1e-13 N is nothing: {text}");
}

#[test]
fn cards_are_in_fields_of_sixteen_characters() {
    let text =
        load_cards(99_999_999, &[12_345_678], &[-1.0 / 3.0, 2.0e-4 / 3.0, 0.0, 0.0, 0.0, 1.0e11 / 3.0]);
    for line in text.lines() {
        assert!(line.len() <= 72 && line.is_char_boundary(8), "{line}");
        assert_eq!((line.len() - 8) % 16, 0, "{line}");
    }
    assert!(text.starts_with("FORCE*          99999999        12345678"), "{text}");
}

proptest! {
    #[test]
    fn grids_come_back_as_they_were_within_sixteen_characters(points in prop::collection::vec(prop::array::uniform3(-1e4..1e4), 1..20)) {
        let mut deck = nastran::BulkData::default();
        for (id, xyz) in (1..).zip(&points) {
            let span = nastran::Span::generated("test");
            deck.grids.insert(id, nastran::Grid { id, cp: 0, xyz: (*xyz).into(), cd: 0, ps: vec![], span });
        }
        let once = parse_deck("t.bdf", &write_deck(&deck)).expect("our own deck");
        let twice = parse_deck("t.bdf", &write_deck(&once)).expect("our own deck");
        prop_assert_eq!(&once, &twice);
        for (id, xyz) in (1..).zip(&points) {
            let difference = (0..3).map(|i| (once.grids[&id].xyz[i] - xyz[i]).abs() / xyz[i].abs()).fold(0.0, f64::max);
            prop_assert!(difference < 1e-11);
        }
    }
}
