//! Formats of mass matrices, and what is refused.

use super::*;

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
