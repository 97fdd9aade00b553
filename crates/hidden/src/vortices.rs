//! The second truth: the same plans, flown by a program that shares nothing with the model (`truth`): an unsteady vortex
//! lattice, a beam by influence coefficients, effects in forms of its own, and twenty wings that were built a little off
//! their drawing.
//!
//! What is hidden, and how large, is the plan's, and how well it can be seen is measured in the first truth: so the two benchmarks have
//! the same cases.

use crate::campaign::{Measured, Record, StaticPoint};
use crate::plan::{CasePlan, Hidden};
use crate::sizes::scaled;
use nastran::InputError;
use std::path::Path;
use truth::drive::Servo;
use truth::effects::Effect;
use truth::{Order, Tunnel, WINGS};

/// How often sizes are halved until the wing holds together.
const MOST_HALVINGS: usize = 8;

/// The polars that stand beside a wing's file.
const POLARS: &str = "e214_neuralfoil_polars.csv";

/// The tunnel for a wing's file.
pub(crate) fn tunnel(wing: &Path) -> Result<Tunnel, InputError> {
    Tunnel::new(wing, &wing.with_file_name(POLARS)).map_err(|fault| {
        InputError::in_file(wing, format!("the vortex lattice cannot fly this wing: {fault}"))
            .with_help("give a flat parametric wing with a beam, and its polars beside it")
    })
}

/// A plan flown; sizes are halved until the wing holds together.
pub(crate) fn measured(tunnel: &Tunnel, plan: &mut CasePlan) -> Measured {
    for _ in 0..MOST_HALVINGS {
        let measured = tunnel.measure(&order(plan));
        if measured.is_bounded() {
            return as_ours(measured);
        }
        plan.effects = scaled(&plan.effects, 0.5);
    }
    as_ours(tunnel.measure(&order(plan)))
}

fn order(plan: &CasePlan) -> Order {
    let effect = |hidden: &Hidden| Effect { name: hidden.name.clone(), values: hidden.values.clone() };
    Order {
        seed: plan.seed,
        wing: Some(plan.seed % WINGS),
        effects: plan.effects.iter().map(effect).collect(),
        servo: plan.servos.given().map(|(frequency_hz, damping_ratio)| Servo { frequency_hz, damping_ratio }),
        wind_off: plan.wind_off,
    }
}

fn as_ours(measured: truth::campaign::Measured) -> Measured {
    let record = |record: truth::campaign::Record| Record {
        file: record.file,
        block: record.block,
        start_s: record.start_s,
        v_m_s: record.v_m_s,
        train: record.train,
        repeat_of: record.repeat_of,
        alpha_deg: record.alpha_deg,
        loads: record.loads,
        tip_z_m: record.tip_z_m,
        command: record.command,
    };
    let points = |points: Vec<truth::campaign::StaticPoint>| -> Vec<StaticPoint> {
        let point = |point: truth::campaign::StaticPoint| StaticPoint {
            v_m_s: point.v_m_s,
            alpha_deg: point.alpha_deg,
            loads: point.loads,
            tip_z_m: point.tip_z_m,
            block: point.block,
        };
        points.into_iter().map(point).collect()
    };
    Measured {
        records: measured.records.into_iter().map(record).collect(),
        statics: points(measured.statics),
        reference: points(measured.reference),
    }
}
