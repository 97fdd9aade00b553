//! Derivatives of the bent wing's readings by the corrections, beside differences of its equilibria.

#![expect(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::large::without_skin;
use aero::{Corrections, Flow, MirrorPlane};
use coupling::{LargeWing, Mount, RootSensitivity, SteadyCase, SteadyModel, WingFile};
use std::path::Path;

/// A wing file of the repository with few boxes.
fn shipped(name: &str, [chordwise, spanwise]: [usize; 2]) -> LargeWing {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
    let mut file = WingFile::read(&path).unwrap();
    let coupling::wing_file::Source::Parametric(planform) = &mut file.source else { panic!("parametric") };
    (planform.boxes.chordwise, planform.boxes.spanwise) = (chordwise, spanwise);
    planform.controls.clear();
    LargeWing::from_bulk(&file, &file.bulk(Mount::Tunnel).unwrap()).unwrap()
}

fn wavy(count: usize, shift: f64) -> Corrections {
    let wave = |b: usize, phase: f64| (b as f64 * 0.73 + phase).sin();
    Corrections {
        force: (0..count).map(|b| 1.0 + 0.2 * wave(b, shift)).collect(),
        moment: (0..count).map(|b| 1.0 + 0.3 * wave(b, 1.0 + shift)).collect(),
        pressure_offset: (0..count).map(|b| 0.05 * wave(b, 2.0 + shift)).collect(),
    }
}

/// A family of corrections and its derivatives.
type Family = (&'static str, fn(&mut Corrections) -> &mut Vec<f64>, fn(&RootSensitivity) -> &faer::Mat<f64>);

const FAMILIES: [Family; 3] = [
    ("force", |c| &mut c.force, |s| &s.by_force),
    ("moment", |c| &mut c.moment, |s| &s.by_moment),
    ("offset", |c| &mut c.pressure_offset, |s| &s.by_offset),
];

/// Largest difference of any derivative along a direction from differences, over the largest derivative of its reading.
fn off(wing: &LargeWing, case: &SteadyCase) -> f64 {
    let (model, count) = (wing.model(), wing.elastic.correctable.len());
    let about = wavy(count, 0.0);
    let own = model.sensitivities(std::slice::from_ref(case), &about).unwrap().remove(0);
    let readings = |corrections: &Corrections| {
        let case = std::slice::from_ref(case);
        let [fz, mx, my] = model.root_loads(case, corrections).unwrap()[0].to_array();
        [fz, mx, my, model.tip_deflections(case, corrections).unwrap()[0]]
    };
    let mut worst: f64 = 0.0;
    for (name, family, derivative) in FAMILIES {
        // All boxes in a wave, the outer half, one box.
        for direction in 0..3 {
            let along = |b: usize| match direction {
                0 => (b as f64 * 0.31).cos(),
                1 => f64::from(u8::from(2 * b > count)),
                _ => f64::from(u8::from(b == count - 2)),
            };
            // Newton's method stops at 1e-7 rad: steps must be much more than that.
            let step = match name {
                "force" => 0.05,
                "moment" => 0.15,
                _ => 0.015,
            } * if direction == 2 { 8.0 } else { 1.0 };
            let at = |step: f64| {
                let mut moved = about.clone();
                family(&mut moved).iter_mut().enumerate().for_each(|(b, value)| *value += step * along(b));
                readings(&moved)
            };
            let [up, down, up_2, down_2] = [step, -step, 2.0 * step, -2.0 * step].map(at);
            for reading in 0..4 {
                // Fourth order.
                let near = (up[reading] - down[reading]) / (2.0 * step);
                let far = (up_2[reading] - down_2[reading]) / (4.0 * step);
                let difference = (4.0 * near - far) / 3.0;
                let gradient = derivative(&own);
                let sum: f64 = (0..count).map(|b| gradient[(reading, b)] * along(b)).sum();
                let size: f64 = (0..count).map(|b| (gradient[(reading, b)] * along(b)).abs()).sum();
                let share = (sum - difference).abs() / size;
                assert!(share.is_finite(), "{name} {reading}: {sum}, {difference} by differences");
                worst = worst.max(share);
            }
        }
    }
    worst
}

#[test]
fn the_adjoint_of_the_bent_wing_is_that_of_differences() {
    let case = |v_m_s: f64, alpha_deg: f64| {
        SteadyCase::new(Flow { v_m_s, rho_kg_m3: 1.225 }, alpha_deg.to_radians())
    };
    for (name, wing, case) in [
        ("without skin", without_skin([3, 8], MirrorPlane::Symmetric { y_m: 0.0 }), case(50.0, 5.0)),
        ("with weight", shipped("pazy/wing.ron", [3, 8]), case(45.0, 6.0)),
        ("swept, cambered", shipped("tuflex/wing_beam.ron", [3, 10]), case(30.0, 5.0)),
    ] {
        let tip = wing
            .model()
            .tip_deflections(std::slice::from_ref(&case), &wavy(wing.elastic.correctable.len(), 0.0));
        println!("{name}: the tip rises by {:.3} m", tip.unwrap()[0]);
        let off = off(&wing, &case);
        assert!(off < 1e-6, "{name}: off by {off:e}");
    }
}
