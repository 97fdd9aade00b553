//! Natural frequencies of plates, a membrane, beams and a wing given by its flexibility (data/published, `fem__*`).

use super::plates::plate;
use crate::fem::{Mesh, frequencies_hz, span};
use crate::registry::Case;
use crate::row::Row;
use crate::{list, number, numbers};
use nastran::{
    BeamElement, BeamProperty, BeamStation, BulkData, Conm1, Expansion, Genel, Grid, Mat1, Mpc, Orientation,
    ScalarElement, ScalarKind, ScalarValue, Spc1,
};
use serde_json::Value;
use structure::{Model, System};

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "fem__nafems_fv12", run: free_plate },
    Case { file: "fem__nafems_fv16", run: cantilevered_plate },
    Case { file: "fem__nafems_fv32", run: tapered_membrane },
    Case { file: "fem__beam_modes", run: beam_modes },
    Case { file: "fem__bah_structure", run: bah_wing },
];

fn square(inputs: &Value, n: usize) -> Mesh {
    let a = number(&inputs["a"]);
    Mesh::mapped(n, n, |s, t| [a * s, a * t, 0.0]).of(plate(inputs))
}

fn rows_of(got: &[f64], wanted: &[f64], first: usize, name: &str, rel: f64) -> Vec<Row> {
    let numbered = (first..).zip(got.iter().zip(wanted));
    numbered
        .map(|(mode, (got, wanted))| Row::relative(format!("mode {mode}, {name} (Hz)"), *got, *wanted, rel))
        .collect()
}

fn free_plate(case: &Value) -> Vec<Row> {
    let wanted = numbers(&case["expected"]["freq_hz_modes_4_on"]);
    let mesh = square(&case["inputs"], 24).clamped(&[1, 2, 6], |_, _| true);
    let got = mesh.frequencies_hz(3 + wanted.len());
    let mut rows = rows_of(&got[3..], &wanted, 4, "24 x 24", number(&case["tolerance"]["rel"]));
    // The three rigid motions out of the plane.
    rows.extend(
        (1..4).map(|mode| Row::absolute(format!("mode {mode}, rigid (Hz)"), got[mode - 1], 0.0, 1e-9)),
    );
    rows
}

fn cantilevered_plate(case: &Value) -> Vec<Row> {
    let (n, rel) = (32, number(&case["tolerance"]["rel"]));
    let mesh = square(&case["inputs"], n).clamped(&[1, 2, 6], |_, _| true).clamped(&[3, 4, 5], |i, _| i == 0);
    let leissa = numbers(&case["expected"]["freq_hz_from_leissa_lambda"]);
    let got = mesh.frequencies_hz(leissa.len());
    let mut rows = rows_of(&got, &leissa, 1, "32 x 32, Leissa", rel);
    rows.extend(rows_of(
        &got,
        &numbers(&case["expected"]["freq_hz_nafems_from_memory"]),
        1,
        "32 x 32, NAFEMS",
        rel,
    ));
    rows
}

fn tapered_membrane(case: &Value) -> Vec<Row> {
    let inputs = &case["inputs"];
    let (length, root, tip) = (number(&inputs["L"]), number(&inputs["root"]), number(&inputs["tip"]));
    let at = |s: f64, t: f64| [length * s, (root + (tip - root) * s) * (t - 0.5), 0.0];
    let mesh = Mesh::mapped(32, 16, at).of(plate(inputs));
    let mesh = mesh.clamped(&[3, 4, 5], |_, _| true).clamped(&[1, 2], |i, _| i == 0);
    let wanted = numbers(&case["expected"]["freq_hz"]);
    rows_of(&mesh.frequencies_hz(wanted.len()), &wanted, 1, "32 x 16", number(&case["tolerance"]["rel"]))
}

/// A beam along x of unit length, EI = 1, unit mass per length, free to bend in the x-z plane only.
fn bending_beam(elements: u32, clamped: bool) -> BulkData {
    let mut bulk = BulkData::default();
    let all = (1..=elements + 1).collect::<Vec<u32>>();
    for id in &all {
        let x = f64::from(id - 1) / f64::from(elements);
        bulk.grids.insert(
            *id,
            Grid { id: *id, cp: 0, xyz: [x, 0.0, 0.0].into(), cd: 0, ps: Vec::new(), span: span() },
        );
    }
    for id in 1..=elements {
        let orientation = Orientation::Vector([0.0, 0.0, 1.0].into());
        let (pins, offsets) = ([Vec::new(), Vec::new()], [[0.0; 3].into(); 2]);
        let grids = [id, id + 1];
        let beam = BeamElement {
            id,
            property: 1,
            grids,
            orientation,
            pins,
            offsets,
            offt: nastran::Offt::default(),
            is_beam: false,
            span: span(),
        };
        bulk.beams.insert(id, beam);
    }
    let station = BeamStation { x_over_l: 0.0, area: 1.0, i1: 1.0, i2: 1.0, i12: 0.0, j: 1.0, nsm: 1.0 };
    let property = BeamProperty {
        id: 1,
        material: 1,
        stations: vec![station],
        shear_factors: [0.0; 2],
        nsi: [0.0; 2],
        nsm_offset: [[0.0; 2]; 2],
        neutral_axis: [[0.0; 2]; 2],
        is_beam: false,
        span: span(),
    };
    bulk.beam_properties.insert(1, property);
    bulk.materials.insert(
        1,
        Mat1 { id: 1, e: 1.0, g: 1.0, nu: 0.0, rho: 0.0, expansion: Expansion::default(), span: span() },
    );
    bulk.constraints.push(Spc1 {
        set: 1,
        components: vec![1, 2, 4, 6],
        grids: all,
        enforced: 0.0,
        span: span(),
    });
    if clamped {
        bulk.constraints.push(Spc1 {
            set: 1,
            components: vec![3, 5],
            grids: vec![1],
            enforced: 0.0,
            span: span(),
        });
    }
    bulk
}

fn beam_modes(case: &Value) -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, clamped, rigid) in [("cantilever_betaL", true, 0), ("free_free_betaL", false, 2)] {
        let wanted = numbers(&case["expected"][name]);
        for (form, coupmass, rel) in [("consistent", 1.0, 1e-3), ("lumped", -1.0, 0.01)] {
            // Lumped masses at the ends of the span need more elements for the sixth mode.
            let elements = if coupmass > 0.0 { 20 } else { 60 };
            let mut bulk = bending_beam(elements, clamped);
            bulk.parameters.insert("COUPMASS".into(), coupmass);
            let model = Model::from_bulk(&bulk).expect("a beam");
            let system = System::assemble(&model).expect("a beam");
            let got = frequencies_hz(&system, rigid + wanted.len());
            for (at, wanted) in wanted.iter().enumerate() {
                let beta = (got[rigid + at] * std::f64::consts::TAU).sqrt();
                let what = format!("{name} {}, {elements} CBAR, {form} mass", at + 1);
                rows.push(Row::relative(what, beta, *wanted, rel));
            }
        }
    }
    rows
}

/// The BAH wing: flexibility of ten points (GENEL), masses between pairs of points, the aileron on an MPC.
fn bah_wing(case: &Value) -> Vec<Row> {
    let system = bah_system(&case["inputs"]);
    let wanted = numbers(&case["expected"]["freq_hz"]);
    let got = frequencies_hz(&system, wanted.len());
    let rel = number(&case["tolerance"]["rel"]);
    let mut rows = vec![Row::absolute("mode 1, free plunge (Hz)", got[0], wanted[0], 1e-6)];
    rows.extend(rows_of(&got[1..], &wanted[1..], 2, "GENEL", rel));
    rows
}

/// The wing as printed: the aileron's spring and mass joined to component 5, roll and pitch of the root held, plunge free.
pub(super) fn bah_system(inputs: &Value) -> System {
    let mut bulk = bah_structure(inputs);
    bulk.springs.insert(81, scalar(81, 5_142_671.0, [Some((12, 5)), None]));
    bulk.scalar_masses
        .insert(82, ScalarElement { kind: ScalarKind::Mass, ..scalar(82, 13_967.2, [Some((12, 5)), None]) });
    bulk.constraints.push(Spc1 {
        set: 1,
        components: vec![4, 5],
        grids: vec![11],
        enforced: 0.0,
        span: span(),
    });
    System::assemble(&Model::from_bulk(&bulk).expect("the wing")).expect("the wing")
}

pub(super) fn scalar(id: u32, value: f64, ends: [Option<(u32, u8)>; 2]) -> ScalarElement {
    ScalarElement { id, value: ScalarValue::Given(value), ends, kind: ScalarKind::Spring, span: span() }
}

pub(super) fn bah_structure(inputs: &Value) -> BulkData {
    let mut bulk = BulkData::default();
    for (name, xyz) in inputs["grids"].as_object().into_iter().flatten() {
        let (id, xyz) = (name.parse().expect("a grid's number"), numbers(xyz));
        bulk.grids.insert(
            id,
            Grid { id, cp: 0, xyz: [xyz[0], xyz[1], xyz[2]].into(), cd: 0, ps: Vec::new(), span: span() },
        );
    }
    let matrix = |value: &Value| list(value).iter().map(numbers).collect();
    let genel = Genel {
        id: 1,
        ui: (1..=10).map(|grid| (grid, 3)).collect(),
        ud: [3, 4, 5, 6].map(|component| (11, component)).into(),
        is_flexibility: true,
        matrix: matrix(&inputs["genel"]["Z_flexibility"]),
        s: matrix(&inputs["genel"]["S"]),
        span: span(),
    };
    bulk.general.insert(1, genel);
    // Pairs of points: own weights and the one that couples them (lb), as the case lists them.
    let pairs = [
        [5248.7, 134.9, 790.3],
        [9727.0, 11005.0, 473.0],
        [3253.6, -139.7, 946.3],
        [2617.8, 21.0, 782.3],
        [494.8, -7.3, 185.2],
    ];
    for (pair, [own, coupling, other]) in (0_u32..).zip(pairs) {
        let (a, b) = ((2 * pair + 1, 3), (2 * pair + 2, 3));
        for (at, (value, ends)) in
            (0..).zip([(own, [Some(a), None]), (coupling, [Some(a), Some(b)]), (other, [Some(b), None])])
        {
            let id = 10 + 3 * pair + at;
            bulk.scalar_masses
                .insert(id, ScalarElement { kind: ScalarKind::Mass, ..scalar(id, value, ends) });
        }
    }
    let root = &inputs["conm1_11"];
    let mut mass = [[0.0; 6]; 6];
    for (at, name) in [(2, "m33"), (3, "I44"), (4, "I55")] {
        mass[at][at] = number(&root[name]);
    }
    bulk.mass_matrices.insert(90, Conm1 { id: 90, grid: 11, cid: 0, mass, span: span() });
    let terms = vec![((12, 3), 1.0), ((8, 3), -1.5), ((7, 3), 0.5), ((12, 5), -33.25)];
    bulk.equations.push(Mpc { set: 1, terms, span: span() });
    bulk.constraints.push(Spc1 { set: 1, components: vec![6], grids: vec![11], enforced: 0.0, span: span() });
    bulk.parameters.insert("WTMASS".into(), 0.002_590_7);
    bulk
}
