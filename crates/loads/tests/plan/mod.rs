//! A plan to change.

use loads::design::{Design, DesignSpeeds, Gust, GustSpeeds, Lift, LimitLoadFactors, MassCase, Rules, Speed};
use std::path::PathBuf;

/// A mass that only has a name and a size.
pub(crate) fn mass(name: &str, mass_kg: f64) -> MassCase {
    MassCase {
        name: name.into(),
        mass_kg,
        x_cg_m: None,
        z_cg_m: None,
        ixx_kg_m2: None,
        iyy_kg_m2: None,
        izz_kg_m2: None,
        ixz_kg_m2: None,
    }
}

/// The plan of an aircraft of 20 kg.
pub(crate) fn design() -> Design {
    Design {
        path: PathBuf::from("loads.ron"),
        rules: Rules::Vla,
        speeds: DesignSpeeds { va: None, vb: None, vc: 37.0, vd: 46.0, vf: None },
        factors: Some(LimitLoadFactors { n1: 3.8, n2: -1.5, n2_at_vd: 0.0 }),
        lift: Some(Lift { cl_max: 1.3, cl_min: -0.9 }),
        altitudes_m: vec![0.0],
        masses: vec![mass("full", 20.0)],
        gusts: vec![Gust::Pratt { at: vec![Speed::VC, Speed::VD] }],
        gust_speeds: GustSpeeds::default(),
    }
}
