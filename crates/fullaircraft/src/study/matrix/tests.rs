//! Rows of a matrix as motions, and its cards.

use super::*;
use nastran::parse_deck;

#[test]
fn rows_are_six_a_grid_and_one_a_scalar_point_in_rising_number() {
    let bulk = parse_deck("t", "GRID,5\nSPOINT,3\nGRID,1\n").expect("points");
    let terms = vec![(5, 5, 7.0), (6, 6, 2.0), (7, 5, 3.0)];
    let cards = MassTerms::Rows { count: 13, terms }.cards("M", &bulk).expect("13 motions");
    let deck = parse_deck("t", &format!("GRID,5\nSPOINT,3\nGRID,1\n{cards}")).expect("cards");
    assert!(deck.air_errors.is_empty(), "{:?}", deck.air_errors);
    let [head, first, second] = &deck.direct_matrices[..] else { panic!("{cards}") };
    assert!(head.head.is_some_and(|head| head.is_symmetric && !head.is_complex));
    assert_eq!(
        (&first.column, &first.rows, &first.values),
        (&vec![(1, 6)], &vec![(1, 6), (5, 1)], &vec![7.0, 3.0])
    );
    assert_eq!((&second.column, &second.rows, &second.values), (&vec![(3, 0)], &vec![(3, 0)], &vec![2.0]));
    let error = MassTerms::Rows { count: 12, terms: vec![] }.cards("M", &bulk).expect_err("a row is missing");
    assert!(
        error.to_string().contains("12 rows, but the decks' 2 grids and 1 scalar points have 13 motions"),
        "{error}"
    );
}
