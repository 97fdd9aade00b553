//! Matrices by motions (DMIG) and their selection by K2GG and M2GG.

use nastran::{Added, DmigHead, parse_deck};

const CARDS: &str = "GRID,1\nGRID,2\nSPOINT,9\nDMIG,STIFF,0,6,1,0\nDMIG,STIFF,1,3,,1,3,5.,,+\n+,2,3,-5.,,9,0,2.\nDMIG,STIFF,2,3,,2,3,5.\n";

#[test]
fn a_column_has_its_motion_and_those_of_its_terms() {
    let deck = parse_deck("t.bdf", CARDS).expect("cards");
    assert!(deck.air_errors.is_empty(), "{:?}", deck.air_errors);
    let [head, first, second] = &deck.direct_matrices[..] else { panic!("{:?}", deck.direct_matrices) };
    assert_eq!(head.head, Some(DmigHead { is_symmetric: true, is_complex: false }));
    assert!(head.points().next().is_none() && first.head.is_none());
    assert_eq!((&first.column, &first.rows), (&vec![(1, 3)], &vec![(1, 3), (2, 3), (9, 0)]));
    assert_eq!(
        (&first.values, first.points().collect::<Vec<_>>()),
        (&vec![5.0, -5.0, 2.0], vec![1, 1, 2, 9])
    );
    assert_eq!((&second.column, &second.values), (&vec![(2, 3)], &vec![5.0]));
    for (head, is_symmetric, is_complex) in
        [("1,2", false, false), ("6,3", true, true), ("2,1", false, false)]
    {
        let deck = parse_deck("t.bdf", &format!("DMIG,A,0,{head},0\n")).expect("a head");
        assert_eq!(deck.direct_matrices[0].head, Some(DmigHead { is_symmetric, is_complex }));
    }
}

#[test]
fn selected_matrices_go_with_the_subcase_and_the_others_do_not() {
    let deck = |case: &str| {
        parse_deck("t.bdf", &format!("CEND\n{case}BEGIN BULK\n{CARDS}")).map_err(|error| error.to_string())
    };
    let whole = deck("K2GG = stiff\nM2GG=MASS\nSUBCASE 1\nSUBCASE 2\n").expect("a deck");
    let bounded = whole.bounded(None).expect("one structure").into_owned();
    let added: Vec<(Added, &str)> =
        bounded.added.iter().map(|matrix| (matrix.to, matrix.name.as_str())).collect();
    assert_eq!(added, [(Added::Stiffness, "STIFF"), (Added::Mass, "MASS")]);
    assert!(deck("").expect("a deck").bounded(None).expect("no selection").added.is_empty());
    let unlike = deck("SUBCASE 1\nK2GG = STIFF\nSUBCASE 2\n").expect_err("one structure serves all");
    assert!(
        unlike.starts_with("t.bdf:3:1: the matrix STIFF is not selected for all subcases alike"),
        "{unlike}"
    );
    for several in ["K2GG = STIFF, OTHER\n", "M2GG = 2.*STIFF\n", "M2GG = (2.)STIFF\n"] {
        let error = deck(several).expect("read").bounded(None).expect_err("not read").to_string();
        assert!(error.contains("changes the structure, its loads or its modes"), "{error}");
    }
    let mirrored = bounded.mirrored(&std::collections::BTreeMap::new()).expect_err("no image").to_string();
    assert!(mirrored.contains("STIFF (DMIG) cannot be mirrored"), "{mirrored}");
    let joined = nastran::BulkData::default().join(bounded).expect_err("left behind").to_string();
    assert!(joined.contains("cannot be joined"), "{joined}");
}

#[test]
fn a_wrong_card_of_a_selected_matrix_is_no_missing_term() {
    let text = format!("CEND\nM2GG = STIFF\nBEGIN BULK\n{CARDS}DMIG,STIFF,2,3,,2,8,5.\n");
    let error = parse_deck("t.bdf", &text).expect("read").bounded(None).expect_err("component 8").to_string();
    assert!(error.starts_with("t.bdf:11:"), "{error}");
}
