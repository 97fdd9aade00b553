//! Model-form variants of the same wing: how far apart they are is a measure of how right either can be (verification without
//! a measurement).

use crate::directions::{DIRECTIONS, Directions};
use crate::rules::{Rules, VariantRules};
use aero::Corrections;
use aero::dlm::{DlmSettings, KernelIntegral, SpanFit};
use coupling::wing_file::Source;
use coupling::{ElasticWing, WingFile};
use faer::Mat;
use faer::linalg::solvers::Solve;
use maneuver::effects::{Active, Effect, Inputs, Model, Stimulus, fly};
use maneuver::rom::ReducedOrderModel;
use maneuver::{AirModel, Smooth};
use std::sync::Arc;

/// The air with another rational function.
pub(crate) fn lag_variant(rules: &VariantRules) -> AirModel {
    match AirModel::default() {
        AirModel::Unsteady { dlm, .. } => AirModel::Unsteady { lags: rules.lags, dlm },
        AirModel::QuasiSteady => AirModel::QuasiSteady,
    }
}

/// The air with doublets integrated otherwise.
pub(crate) fn kernel_variant() -> AirModel {
    match AirModel::default() {
        AirModel::Unsteady { lags, .. } => AirModel::Unsteady {
            lags,
            dlm: DlmSettings { integral: KernelIntegral::Fine, fit: SpanFit::Parabolic },
        },
        AirModel::QuasiSteady => AirModel::QuasiSteady,
    }
}

/// A wing on another lattice.
#[derive(Debug)]
pub struct LatticeVariant {
    /// The file with the other lattice.
    pub file: WingFile,
    /// The wing.
    pub wing: ElasticWing,
    /// For each of its correctable boxes the one of the given wing whose corrections it takes.
    pub(crate) boxes: Vec<usize>,
}

impl LatticeVariant {
    /// A coarser lattice on a parametric wing; none where the lattice is given by a deck, or the planform takes no other.
    pub fn of(file: &WingFile, wing: &ElasticWing, rules: &VariantRules) -> Option<Self> {
        let mut file = file.clone();
        let Source::Parametric(planform) = &mut file.source else { return None };
        let mesh = planform.mesh(rules.chord_boxes, rules.span_boxes);
        planform.remesh(&mesh).ok()?;
        let bulk = file.bulk(coupling::Mount::Tunnel).ok()?;
        let other = ElasticWing::from_bulk(&file, &bulk).ok()?;
        let boxes = nearest(&other, wing);
        Some(Self { file, wing: other, boxes })
    }
}

/// For each box of one wing the nearest of another by places along span and chord.
fn nearest(of: &ElasticWing, among: &ElasticWing) -> Vec<usize> {
    let place = |wing: &ElasticWing, j: usize| {
        let boxes = &wing.correctable;
        (boxes.y_norm[j], (boxes.chord_row[j] as f64 + 0.5) / boxes.chord_rows[j] as f64)
    };
    let far = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() + 1e-3 * (a.1 - b.1).abs();
    let one = |j: usize| {
        let here = place(of, j);
        let all = 0..among.correctable.len();
        all.min_by(|a, b| far(here, place(among, *a)).total_cmp(&far(here, place(among, *b)))).unwrap_or(0)
    };
    (0..of.correctable.len()).map(one).collect()
}

/// Corrections picked box by box.
pub(crate) fn picked(corrections: &Corrections, boxes: &[usize]) -> Corrections {
    let of = |values: &[f64]| boxes.iter().map(|j| values[*j]).collect();
    Corrections {
        force: of(&corrections.force),
        moment: of(&corrections.moment),
        pressure_offset: of(&corrections.pressure_offset),
    }
}

/// The six directions of corrections with which a rig has another's static loads: offset and slope of three channels.
/// None if they are the same, or no such directions are found.
pub(crate) fn matched(rules: &Rules, rig: &ReducedOrderModel, own: &ReducedOrderModel) -> Option<Active> {
    let angles_rad = rules.variants.angles_rad;
    let wanted = static_loads(own, &angles_rad, &[]);
    let directions: Arc<dyn Effect> = Arc::new(Directions::new(rig.flow.v_m_s, &rules.shared));
    let with =
        |values: &[f64]| static_loads(rig, &angles_rad, &[Active::new(Arc::clone(&directions), values)]);
    let mut values = vec![0.0; DIRECTIONS];
    for _ in 0..rules.variants.steps {
        let at = with(&values);
        let column = |k: usize| {
            let mut more = values.clone();
            more[k] += 1e-3;
            with(&more)
        };
        let columns: Vec<Vec<f64>> = (0..DIRECTIONS).map(column).collect();
        let slopes = Mat::from_fn(DIRECTIONS, DIRECTIONS, |i, k| (columns[k][i] - at[i]) / 1e-3);
        let missing = Mat::from_fn(DIRECTIONS, 1, |i, _| wanted[i] - at[i]);
        let step = slopes.partial_piv_lu().solve(&missing);
        values.iter_mut().enumerate().for_each(|(k, value)| *value += step[(k, 0)]);
    }
    let found = values.iter().all(|value| value.is_finite()) && values.iter().any(|value| *value != 0.0);
    found.then(|| Active::new(directions, &values))
}

/// Three channels at some angles.
fn static_loads(rig: &ReducedOrderModel, angles_rad: &[f64], effects: &[Active]) -> Vec<f64> {
    let still = vec![0.0; angles_rad.len()];
    let stimulus = Stimulus {
        inputs: Inputs {
            alpha: Smooth { value: angles_rad.to_vec(), rate: still.clone(), second: still.clone() },
            controls_rad: vec![still.clone(); rig.controls.len()],
            incidence_rad: still,
        },
        time_step_s: 1.0,
        steady: true,
        clock_h: 0.0,
    };
    fly(rig, &Model::new(rig, effects, None), effects, &stimulus).loads.concat()
}
