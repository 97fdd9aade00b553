//! Nothing that stands in a file ends the program: every text gives a deck, a table or an error with a place.

use nastran::{Frames, Table, parse_deck, write_deck};
use proptest::prelude::*;

fn try_everything(text: &str) {
    match parse_deck("t.bdf", text) {
        Ok(deck) => {
            let _ = Frames::resolve(&deck);
            let _ = write_deck(&deck);
        }
        Err(error) => assert!(error.span.is_some(), "{error}"),
    }
}

/// Names of cards that are read, and what else starts a line.
const NAMES: &str = "\
    GRID CORD1R CORD2R CBAR CBEAM PBAR PBEAM MAT1 CONM2 RBE2 SPC1 SPC MPC CQUAD4 CTRIA3 CHEXA \
    CTETRA CROD CBUSH CELAS1 CMASS2 GENEL CONM1 RBAR RBE3 PSHELL PCOMP PCOMPG PSOLID PROD PBUSH \
    PELAS PMASS PBARL PBEAML MAT2 MAT8 MAT9 SPLINE1 SPLINE2 PARAM CORD1C CORD2S CAERO1 PAERO1 \
    AEROS AESTAT TRIM SUPORT AELINK AECOMP AEFACT AESURF AELIST SET1 MONPNT1 MONPNT3 DMI \
    PBCOMP CBUSH1D PBUSH1D CVISC PVISC CDAMP1 CDAMP4 PDAMP RBAR1 RBE1 RTRPLT RTRPLT1 RROD RSPLINE + * GRID* DMI* INCLUDE ENDDATA";

/// Lines that look like cards: a known name and fields of all kinds.
fn card() -> impl Strategy<Value = String> {
    let names = NAMES.split_whitespace().chain(["", "BEGIN BULK"]).collect::<Vec<_>>();
    let field = prop_oneof![
        Just(String::new()),
        Just("THRU".to_owned()),
        Just("YES".to_owned()),
        prop::sample::select(vec!["K", "Z", "S", "UD", "UM", "ALPHA", "SYM", "BOX", "I", "L", "M"])
            .prop_map(str::to_owned),
        Just("A".to_owned()),
        (0_u32..9).prop_map(|number| number.to_string()),
        (-9_i64..9_999_999_999).prop_map(|number| number.to_string()),
        (-9.0..9.0_f64).prop_map(|number| nastran::real::format(number, 8)),
        "\\PC{0,10}",
    ];
    (prop::sample::select(names), prop::collection::vec(field, 0..10), any::<bool>()).prop_map(
        |(name, fields, free)| {
            if free {
                return format!("{name},{}\n", fields.join(","));
            }
            let cells = fields.iter().map(|field| format!("{field:8}")).collect::<Vec<_>>();
            format!("{name:8}{}\n", cells.concat())
        },
    )
}

proptest! {
    #[test]
    fn any_text_is_a_deck_or_an_error_with_a_place(text in any::<String>(), lines in "(\\PC{0,90}\n){0,8}") {
        try_everything(&text);
        try_everything(&lines);
    }

    #[test]
    fn any_cards_are_a_deck_or_an_error_with_a_place(cards in prop::collection::vec(card(), 0..12)) {
        try_everything(&cards.concat());
        for card in &cards {
            try_everything(card);
        }
    }

    #[test]
    fn any_text_is_a_table_or_an_error_with_a_place(text in any::<String>(), lines in "([a-c\",# \t]{0,12}\n){0,6}") {
        for text in [text, lines] {
            match Table::parse("t.csv", &text) {
                Ok(table) => {
                    for column in table.columns() {
                        let _ = table.numbers(column);
                    }
                }
                Err(error) => prop_assert!(error.span.is_some(), "{}", error),
            }
        }
    }
}
