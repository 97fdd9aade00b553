//! Divergence of a rigid rectangular half wing on a root torsion spring (data/published/trim__typical_section_*.json).
//!
//! Goal: the identity q_D = K / (S c CM_alpha), with the moment about the spring's axis; kind: an independent
//! program's numbers for the same lattice. Chord 1, half span 4, 8 by 4 boxes, axis at mid chord, symmetric.

use crate::registry::Case;
use crate::row::Row;
use crate::{number, numbers};
use aero::{Corrections, Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, Spline, SupportedStructure, WingParts};
use faer::Mat;
use fullaircraft::TrimDeck;
use nalgebra::Point3;
use nastran::BulkData;
use serde_json::Value;
use std::fmt::Write as _;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "trim__typical_section_divergence_M0", run: rows },
    Case { file: "trim__typical_section_divergence_M0.5", run: rows },
    Case { file: "trim__ha144b_divergence_sym", run: bah },
];

fn rows(case: &Value) -> Vec<Row> {
    let (inputs, expected) = (&case["inputs"], &case["expected"]);
    let rel = number(&case["tolerance"]["rel"]);
    let (chord, semispan) = (number(&inputs["c"]), number(&inputs["semispan"]));
    let axis = Point3::new(number(&inputs["axis_x"]), 0.0, 0.0);
    let deck =
        format!("CAERO1,1,1,,8,4,,,1,+\n+,0.,0.,0.,{chord:?},0.,{semispan:?},0.,{chord:?}\nPAERO1,1\n");
    let lattice = nastran::parse_deck("typical section", &deck)
        .and_then(|bulk| Lattice::from_bulk(&bulk))
        .expect("the deck above");
    let spline = Spline::nearest_node(&lattice, &[axis], &[0]);
    // one node that turns about y on the spring and does nothing else
    let s_dofs: Vec<usize> = (0..6).collect();
    let spring = number(&inputs["K"]);
    let flexibility = Mat::from_fn(6, 6, |i, j| if i == 4 && j == 4 { 1.0 / spring } else { 0.0 });
    let supported =
        SupportedStructure::from_parts(s_dofs, flexibility, Mat::zeros(6, 3), Mat::zeros(3, 3), &spline, 0)
            .expect("the node's six degrees of freedom");
    let boxes = lattice.len();
    let wing = ElasticWing::new(WingParts {
        camber: vec![0.0; boxes],
        controls: Vec::new(),
        balance: Balance { point: axis, metric: vec![true; boxes] },
        plane: MirrorPlane::Symmetric { y_m: 0.0 },
        mach: number(&inputs["mach"]),
        fairing_surfaces: Vec::new(),
        supported: Some(supported),
        structure: None,
        lattice,
    })
    .expect("a flat wing beside its plane of symmetry");
    let area = number(&inputs["sref_half"]);
    let (mut lift, mut moment) = (0.0, 0.0);
    for (j, cp) in wing.pressures_by_alpha().iter().enumerate() {
        lift += cp * wing.integration.area(j);
        moment -= cp * wing.integration.area(j) * (wing.lattice.boxes[j].quarter_point().x - axis.x);
    }
    // with a density of 2 the dynamic pressure is the square of the airspeed
    let v_d =
        wing.divergence_speed(2.0, &Corrections::neutral(boxes)).expect("neutral").expect("it diverges");
    vec![
        Row::relative("CL alpha", lift / area, number(&expected["CLalpha"]), rel),
        Row::relative("CM alpha", moment / area / chord, number(&expected["CMalpha_about_axis"]), rel),
        Row::relative("divergence pressure", v_d * v_d, number(&expected["q_div"]), rel),
    ]
}

/// The BAH wing's deck for the air, x aft: the case has x forward and z down, so both change their signs.
fn bah_deck(inputs: &Value) -> BulkData {
    let mut bulk = super::vibrations::bah_structure(inputs);
    for grid in bulk.grids.values_mut() {
        grid.xyz = [-grid.xyz[0], grid.xyz[1], -grid.xyz[2]].into();
    }
    // u3(12) = 1.5 u3(8) - 0.5 u3(7) - 33.25 R2(12) with z up
    bulk.equations[0].terms[3].1 = 33.25;
    let spring = number(&inputs["aileron"]["celas2_12_R2"]);
    bulk.springs.insert(81, super::vibrations::scalar(81, spring, [Some((12, 5)), None]));
    let mut text = String::from(
        "AEROS,,,162.5,1000.,81250.,1\nSPC1,1,345,11\nPAERO1,1\nSET1,14,1,THRU,11\nSET1,15,8,10,12\n\
         SPLINE1,107,2001,2005,2018,15\n",
    );
    for (id, (panel, from, to)) in (101..).zip([
        (1001, 1001, 1035),
        (2001, 2001, 2004),
        (2001, 2007, 2010),
        (2001, 2013, 2016),
        (3001, 3001, 3005),
    ]) {
        writeln!(text, "SPLINE2,{id},{panel},{from},{to},14,,1.,0,+\n+,-1.,-1.").expect("a String");
    }
    for panel in inputs["caero1"].as_array().expect("three panels") {
        let (id, span, chord) =
            (number(&panel["eid"]), numbers(&panel["span_divs"]), numbers(&panel["chord_divs"]));
        let (root, tip) = (span[0], span[span.len() - 1]);
        let corner = |eta: f64| (-78.75 + 43.75 * eta, 500.0 * eta, 225.0 - 125.0 * eta);
        let ((x1, y1, c1), (x4, y4, c4)) = (corner(root), corner(tip));
        let share: Vec<f64> = span.iter().map(|eta| (eta - root) / (tip - root)).collect();
        for (list, values) in [(id + 1.0, &share), (id + 2.0, &chord)] {
            write!(text, "AEFACT,{list}").expect("a String");
            for (at, value) in values.iter().enumerate() {
                let line = if at > 0 && (at + 1) % 8 == 0 { ",+\n+" } else { "" };
                write!(text, "{line},{value:?}").expect("a String");
            }
            text.push('\n');
        }
        writeln!(
            text,
            "CAERO1,{id},1,,,,{},{},1,+\n+,{x1:?},{y1:?},0.,{c1:?},{x4:?},{y4:?},0.,{c4:?}",
            id + 1.0,
            id + 2.0
        )
        .expect("a String");
    }
    let air = nastran::parse_deck("BAH wing", &text).expect("the cards above");
    bulk.constraints.extend(air.constraints);
    (bulk.panels, bulk.panel_properties, bulk.factors) = (air.panels, air.panel_properties, air.factors);
    (bulk.splines, bulk.sets, bulk.aero_reference) = (air.splines, air.sets, air.aero_reference);
    bulk
}

/// Five divergence pressures of the BAH wing (HA144B): beam spline, plate spline of the aileron, flexibility as numbers.
fn bah(case: &Value) -> Vec<Row> {
    let deck = TrimDeck::new(&bah_deck(&case["inputs"]), 0.0).expect("a wing held at its root");
    let wanted = numbers(&case["expected"]["q_div"]);
    let rel = number(&case["tolerance"]["rel"]);
    let got = deck.divergence_pressures();
    let rows = wanted.iter().enumerate().map(|(at, wanted)| {
        let value = got.get(at).copied().unwrap_or(f64::NAN);
        Row::relative(format!("divergence pressure {} (psi)", at + 1), value, *wanted, rel)
    });
    rows.collect()
}
