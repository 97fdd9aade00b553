//! Formats of mass matrices, and what is refused.

use super::*;
use nastran::parse_deck;

fn read(name: &str, text: &str) -> Result<MassTerms, String> {
    let path = std::env::temp_dir().join(format!("wingroot_{}_{name}", std::process::id()));
    std::fs::write(&path, text).expect("a file");
    let found = read_terms(&path).map_err(|error| error.to_string());
    std::fs::remove_file(&path).expect("our own file");
    found
}

const HEAD: &str = "%%MatrixMarket matrix coordinate real symmetric\n% two lumps\n\n";

#[test]
fn a_matrix_in_coordinates_is_counted_from_one_in_its_file() {
    let found = read("a.mtx", &format!("{HEAD}7 7 3\n1 1 2.5\n3 2 -1e-1\n7 7 4\n")).expect("a matrix");
    let terms = vec![(0, 0, 2.5), (2, 1, -0.1), (6, 6, 4.0)];
    assert_eq!(found, MassTerms::Rows { count: 7, terms });
    let general = HEAD.replace("symmetric", "General").replace("real", "integer");
    assert!(read("b.mtx", &format!("{general}2 2 0\n")).is_ok());
}

#[test]
fn what_is_no_such_matrix_is_refused_at_its_line() {
    for (text, line, said) in [
        ("%%MatrixMarket matrix array real general\n1 1\n2.\n".to_owned(), 1, "no real symmetric matrix"),
        (
            "%%MatrixMarket matrix coordinate complex symmetric\n1 1 0\n".to_owned(),
            1,
            "no real symmetric matrix",
        ),
        (HEAD.to_owned(), 1, "line of sizes"),
        (format!("{HEAD}7 7\n"), 4, "rows, columns and number"),
        (format!("{HEAD}7 6 0\n"), 4, "no mass matrix"),
        (format!("{HEAD}7 7 1\n0 1 2.\n"), 5, "no term"),
        (format!("{HEAD}7 7 1\n8 1 2.\n"), 5, "no term"),
        (format!("{HEAD}7 7 1\n1 8 2.\n"), 5, "no term"),
        (format!("{HEAD}7 7 1\n1 1 nan\n"), 5, "no term"),
        (format!("{HEAD}7 7 1\n1 1\n"), 5, "no term"),
        (format!("{HEAD}7 7 2\n1 1 2.\n"), 4, "2 terms are announced, 1 are there"),
    ] {
        let error = read("c.mtx", &text).expect_err("no matrix");
        assert!(error.contains(&format!(".mtx:{line}:1")) && error.contains(said), "{error}");
    }
    assert!(read("d.txt", "").expect_err("no ending").contains("expected .h5"));
}

#[test]
fn a_table_names_motions() {
    let head = "row_grid,row_component,column_grid,column_component,value\n";
    let found = read("a.csv", &format!("{head}3,1,3,6,.5\n9,0,9,0,2\n")).expect("a table");
    assert_eq!(found, MassTerms::Motions(vec![((3, 1), (3, 6), 0.5), ((9, 0), (9, 0), 2.0)]));
    for row in ["3.5,1,3,1,1", "3,7,3,1,1", "3,1,-3,1,1"] {
        let error = read("b.csv", &format!("{head}{row}\n")).expect_err("no motion");
        assert!(error.contains("no whole number"), "{error}");
    }
}

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
