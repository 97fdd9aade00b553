//! Links and components of controls, and what subcases select.

use nastran::{ComponentOf, parse_deck};

#[test]
fn subcases_select_and_inherit() {
    let deck = "SOL 144\nCEND\nSPC = 7\nAESYMXZ = SYMMETRIC\nSUBCASE 1\n  LABEL = level, 1 g\n  TRIM = 3 $ slow\nSUBCASE 2\n\
                  trim=4\n  SPC=8\n  AESYMXZ = antisymm\nBEGIN BULK\nENDDATA\n";
    let cases = parse_deck("deck", deck).unwrap().subcases;
    assert_eq!(cases.len(), 2);
    let selected = |at: usize| (cases[at].id, cases[at].trim, cases[at].spc, cases[at].symmetry);
    assert_eq!(selected(0), (1, Some(3), Some(7), Some(1)));
    assert_eq!(selected(1), (2, Some(4), Some(8), Some(-1)));
    assert_eq!(cases[0].label, "level, 1 g");
    let alone = parse_deck("deck", "CEND\nTRIM = 5\nBEGIN BULK\n").unwrap().subcases;
    assert_eq!((alone.len(), alone[0].id, alone[0].trim), (1, 1, Some(5)));
    assert!(parse_deck("deck", "TRIM,1,0.5,100.,ANGLEA,0.1\n").unwrap().subcases.is_empty());
}

#[test]
fn a_selection_that_is_no_number_is_refused_by_its_line() {
    let error = parse_deck("deck", "CEND\nTRIM = fast\nBEGIN BULK\n").unwrap_err();
    assert!(error.to_string().contains("deck:2"), "{error}");
    let error = parse_deck("deck", "CEND\nAESYMXZ = 1\nBEGIN BULK\n").unwrap_err();
    assert!(error.to_string().contains("AESYMXZ"), "{error}");
}

#[test]
fn links_and_components_are_read() {
    let deck = "AELINK,ALWAYS,ELEV_L,ELEV_R,1.0\nAELINK,10,INBD,OTBD,0.2,TAB,-0.5\n\
                AECOMP,WING,AELIST,1001,1002\nAECOMP,BODY,SET1,5\n";
    let bulk = parse_deck("deck", deck).unwrap();
    assert_eq!(bulk.aero_links[0].trim, None);
    assert_eq!(bulk.aero_links[1].trim, Some(10));
    assert_eq!(bulk.aero_links[1].terms, [("OTBD".to_owned(), 0.2), ("TAB".to_owned(), -0.5)]);
    let wing = &bulk.aero_components["WING"];
    assert_eq!((wing.of, wing.lists.as_slice()), (ComponentOf::Boxes, &[1001, 1002][..]));
    let is_wrong = |text: &str| parse_deck("deck", text).and_then(|deck| deck.refuse_unread_air()).is_err();
    assert!(is_wrong("AELINK,1,ELEV\n"));
    assert!(is_wrong("AECOMP,A,GRID,1\n"));
    assert!(is_wrong("AECOMP,A,SET1,1\nAECOMP,A,SET1,2\n"));
}
