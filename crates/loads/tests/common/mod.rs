//! Reference numbers, and a plan to change.

use loads::design::{Design, DesignSpeeds, Gust, GustSpeeds, Lift, LimitLoadFactors, MassCase, Rules, Speed};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A file of `tests/data`.
pub(crate) fn reference(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_str(&text).unwrap()
}

/// A number of a reference.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Compares with a reference, relative to it.
pub(crate) fn close(ours: f64, reference: &Value, rel: f64, what: &str) {
    let reference = number(reference);
    let most = rel * reference.abs().max(1e-12);
    assert!((ours - reference).abs() <= most, "{what}: {ours} beside {reference}");
}

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
