//! Divergence of a rigid rectangular half wing on a root torsion spring (data/published/trim__typical_section_*.json).
//!
//! Goal: the identity q_D = K / (S c CM_alpha), with the moment about the spring's axis; kind: an independent
//! program's numbers for the same lattice. Chord 1, half span 4, 8 by 4 boxes, axis at mid chord, symmetric.

use crate::number;
use crate::registry::Case;
use crate::row::Row;
use aero::{Corrections, Lattice, MirrorPlane};
use coupling::{Balance, ElasticWing, Spline, SupportedStructure, WingParts};
use faer::Mat;
use nalgebra::Point3;
use serde_json::Value;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "trim__typical_section_divergence_M0", run: rows },
    Case { file: "trim__typical_section_divergence_M0.5", run: rows },
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
