//! A cantilever under loads that went through FORCE* and MOMENT* cards: tip, shear and bending at the root by closed form.

use nastran::{load_cards, parse_deck};
use serde_json::Value;
use std::fmt::Write as _;
use structure::{Flexibility, Model, System};

/// A cantilever along y: a moment about x lifts its tip.
fn cantilever(nodes: usize, length: f64) -> String {
    let mut deck = String::new();
    for node in 0..=nodes {
        let y = length * node as f64 / nodes as f64;
        let _ = writeln!(
            deck,
            "GRID*   {:>16}                {:>16}{:>16}\n*       {:>16}",
            node + 1,
            "0.",
            nastran::real::format(y, 16),
            "0."
        );
    }
    for node in 1..=nodes {
        let _ = writeln!(
            deck,
            "CBAR    {node:>8}{:>8}{node:>8}{:>8}{:>8}{:>8}{:>8}",
            1,
            node + 1,
            "0.",
            "0.",
            "1."
        );
    }
    deck += "PBAR,1,1,1.-4,1.-8,1.-8,1.-8\nMAT1,1,2.5+10,,.3,0.\nSPC1,1,123456,1\n";
    deck
}

#[test]
fn loads_that_went_through_cards_bend_a_cantilever_as_its_closed_form_says() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/loads/cards.json");
    let data: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let tolerance = data["tolerance"]["rel"].as_f64().unwrap();
    for (name, set) in data["sets"].as_object().unwrap() {
        let number = |value: &Value| value.as_f64().unwrap();
        let list = |key: &str| set[key].as_array().unwrap().iter().map(number).collect::<Vec<f64>>();
        let (forces, moments, length) = (list("force_N"), list("moment_Nm"), number(&set["L_m"]));
        // E 2.5E10, I 1E-8: EI 250
        assert_eq!(number(&set["EI_N_m2"]), 250.0);
        let nodes = forces.len();
        let mut deck = cantilever(nodes, length);
        let grids: Vec<u32> = (1..).take(nodes + 1).collect();
        let mut loads = vec![0.0; 6 * (nodes + 1)];
        for (node, (force, moment)) in forces.iter().zip(&moments).enumerate() {
            (loads[6 * (node + 1) + 2], loads[6 * (node + 1) + 3]) = (*force, *moment);
        }
        deck += &load_cards(1, &grids, &loads);
        let bulk = parse_deck("cantilever", &deck).unwrap();
        let system = System::assemble(&Model::from_bulk(&bulk).unwrap()).unwrap();
        let mut read = faer::Mat::zeros(6 * system.node_count(), 1);
        for card in &bulk.point_loads {
            let first = 6 * system.node_index(card.grid).unwrap() + if card.is_moment { 3 } else { 0 };
            (0..3).for_each(|axis| read[(first + axis, 0)] += card.vector[axis]);
        }
        let flexibility = Flexibility::new(&system).unwrap();
        let u = system.expand(flexibility.displacements(system.reduce(read.as_ref()).as_ref()).as_ref());
        let reaction = system.elastic_loads(u.as_ref());
        let expected = &set["expected"];
        for (what, found) in [
            ("tip_deflection_m", u[(6 * nodes + 2, 0)]),
            ("root_shear_N", -reaction[(2, 0)]),
            ("root_bending_Nm", -reaction[(3, 0)]),
        ] {
            let known = number(&expected[what]);
            assert!((found - known).abs() < tolerance * known.abs(), "{name}, {what}: {found} for {known}");
        }
    }
}
