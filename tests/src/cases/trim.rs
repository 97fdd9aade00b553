//! Trim and stability derivatives of the forward-swept aircraft HA144A (data/published/trim__ha144a.json, decks/ha144a_fsw.bdf).
//!
//! Goal: angles of trim, control and stability derivatives (rigid, restrained, unrestrained) and box loads at two dynamic pressures,
//! Mach 0.9; kind: the print of two commercial programs and an independent solution of the same equations.

use crate::number;
use crate::registry::Case;
use crate::row::{Row, worst};
use fullaircraft::{Elastic, TrimDeck};
use serde_json::Value;

/// The cases of this file.
pub const CASES: &[Case] = &[Case { file: "trim__ha144a", run: rows }];

/// The case's tolerance: 2e-6 of every printed number with SPLINE2, as the file says.
const REL: f64 = 2e-6;

fn rows(case: &Value) -> Vec<Row> {
    let path = crate::data("published").join("decks/ha144a_fsw.bdf");
    let bulk = nastran::read_deck(&path).expect("the deck of the case");
    let deck = TrimDeck::new(&bulk, 0.9).expect("an aircraft with one SUPORT grid");
    let mut rows = Vec::new();
    for (id, name) in [(1, "q40"), (2, "q1200")] {
        let card = &bulk.trims[&id];
        let (expected, own) = (&case["expected"][name], &case["expected"]["own_solution"][name]);
        let trimmed = deck.trim_card(card).expect("a balance");
        for label in ["ANGLEA", "ELEV"] {
            let value = trimmed.values[label];
            rows.push(Row::relative(
                format!("{name} {label} (rad)"),
                value,
                number(&expected["trim"][label]),
                REL,
            ));
        }
        for (at, elastic) in
            [Elastic::Rigid, Elastic::Restrained, Elastic::Unrestrained].into_iter().enumerate()
        {
            let ours = deck.derivatives(card.q, elastic);
            for label in ["INTERCEPT", "ANGLEA", "PITCH", "ELEV", "URDD3", "URDD5"] {
                if label.starts_with("URDD") && elastic != Elastic::Restrained {
                    continue;
                }
                for (part, row) in [("CZ", 2), ("CM", 4)] {
                    let what = format!("{name} {part} by {label}, {elastic:?}");
                    let reference = number(&expected["derivs"][label][part][at]);
                    rows.push(Row::relative(what, ours[label][row], reference, REL));
                }
            }
        }
        let lifts = own["Fz_box"].as_array().expect("40 boxes");
        assert_eq!(lifts.len(), trimmed.lift.len());
        let boxes = lifts.iter().zip(&trimmed.lift).enumerate();
        let boxes = boxes.map(|(j, (reference, lift))| {
            Row::relative(format!("{name} box {j} (lbf)"), *lift, number(reference), REL)
        });
        rows.push(worst("lift of a box", boxes.collect()));
        let total = trimmed.lift.iter().sum();
        rows.push(Row::relative(format!("{name} lift of the half aircraft (lbf)"), total, 8000.0, REL));
    }
    rows
}
