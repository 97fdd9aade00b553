//! A case: a true wing with what is hidden, tested as the benchmark's campaign plans it.

use crate::campaign::{Measured, Planned, StaticPoint, benchmark, wind_off};
use crate::campaign::{design, noise};
use crate::draw;
use crate::drive::Maneuver;
use crate::effects::{self, Effect};
use crate::fault::Fault;
use crate::order::Order;
use crate::random::{Purpose, Random};
use crate::recording::{Flown, block_offsets, records, seen};
use crate::rig::{Coupled, Fineness, Inputs, Rig};
use crate::setting::Setting;
use crate::wing::{Polars, Wing};
use rayon::prelude::*;
use std::path::Path;

/// Changes of the loads beyond which a wing counts as one that shakes itself to pieces, N.
const TORN_N: f64 = 1e4;

/// The tunnel of this program.
#[derive(Debug, Clone)]
pub struct Tunnel {
    rig: Rig,
    /// Names of the control surfaces.
    pub controls: Vec<String>,
}

impl Tunnel {
    /// A tunnel for a wing's file; polars are beside it.
    ///
    /// # Errors
    /// Files that cannot be read, or a wing that is no flat parametric one with a beam.
    pub fn new(wing: &Path, polars: &Path) -> Result<Self, Fault> {
        Self::divided(wing, polars, Fineness::CAMPAIGN)
    }

    /// A tunnel whose wing is divided in another way.
    ///
    /// # Errors
    /// As [`Tunnel::new`].
    pub fn divided(wing: &Path, polars: &Path, fineness: Fineness) -> Result<Self, Fault> {
        let (wing, polars) = (Wing::read(wing)?, Polars::read(polars)?);
        let controls = wing.controls.iter().map(|control| control.name.clone()).collect();
        Ok(Self { rig: Rig::divided(wing, Some(polars), fineness), controls })
    }

    /// The runs of an order.
    pub fn planned(&self, order: &Order) -> Vec<Planned> {
        let mut planned = benchmark(&self.controls);
        if order.wind_off {
            planned.extend(wind_off());
        }
        planned
    }

    /// Tests a wing. The same order gives the same numbers, whatever the number of threads.
    pub fn measure(&self, order: &Order) -> Measured {
        let planned = self.planned(order);
        let at = |effects: &[Effect], v_m_s: f64| {
            let mut setting = self.setting(order);
            for effect in effects {
                effect.on_setting(&self.rig.wing, v_m_s, &mut setting);
            }
            Coupled::new(&self.rig, setting, v_m_s, design::RHO_KG_M3)
        };
        let speeds: Vec<f64> = design::AIRSPEEDS_M_S.into_iter().chain([0.0]).collect();
        let tested = |effects: &[Effect]| -> Vec<(f64, Coupled<'_>)> {
            speeds.par_iter().map(|v_m_s| (*v_m_s, at(effects, *v_m_s))).collect()
        };
        let wings = tested(&order.effects);
        let plain = (!order.effects.is_empty()).then(|| tested(&[]));
        let flown: Vec<Flown> = planned.par_iter().map(|run| self.fly(order, &wings, run)).collect();
        Measured {
            records: records(order, &planned, &flown, &self.rig.lattice.strips),
            statics: self.statics(order, &wings, &order.effects, Purpose::Statics),
            reference: self.statics(order, plain.as_ref().unwrap_or(&wings), &[], Purpose::Reference),
        }
    }

    fn setting(&self, order: &Order) -> Setting {
        match order.wing {
            Some(number) => draw::true_wing(&self.rig.wing, number),
            None => Setting::drawn(self.rig.wing.damping_ratio, self.controls.len()),
        }
    }

    fn fly(&self, order: &Order, wings: &[(f64, Coupled<'_>)], run: &Planned) -> Flown {
        let v_m_s = run.maneuver.v_m_s;
        let coupled = wings.iter().find(|(speed, _)| *speed == v_m_s).map_or(&wings[0].1, |(_, wing)| wing);
        let dt = coupled.time_step_s;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few seconds")]
        let steps = (run.maneuver.length_s / dt).ceil() as usize + 1;
        let signal = |of: &str| -> [Vec<f64>; 3] {
            let all: Vec<[f64; 3]> = (0..steps).map(|i| run.maneuver.at(of, i as f64 * dt)).collect();
            [0, 1, 2].map(|derivative| all.iter().map(|values| values[derivative]).collect())
        };
        let alpha = signal("alpha");
        let servo = order.servo.unwrap_or_else(|| draw::servo(order.seed));
        let commands: Vec<Vec<f64>> = self
            .controls
            .iter()
            .map(|name| {
                let [value, ..] = signal(name);
                value
            })
            .collect();
        let here = seen(&run.maneuver, dt, (0.0, None), &alpha);
        let controls = commands.iter().enumerate().map(|(control, command)| {
            let mut delta = command.clone();
            order.effects.iter().for_each(|effect| effect.on_command(&here, &mut delta));
            let mut delta =
                if delta.iter().any(|d| *d != delta[0]) { servo.follow(&delta, dt) } else { delta };
            order.effects.iter().for_each(|effect| effect.on_deflection(&here, control, &mut delta));
            let rate = slopes(&delta, dt);
            let second = slopes(&rate, dt);
            [delta, rate, second]
        });
        let inputs = Inputs { controls: controls.collect(), alpha };
        let strips_too = order.effects.iter().any(Effect::needs_strips);
        let flight = coupled.fly(&inputs, strips_too);
        let command = commands.into_iter().enumerate().find(|(_, c)| c.iter().any(|d| *d != 0.0));
        Flown { flight, alpha: inputs.alpha, command, time_step_s: dt }
    }

    fn statics(
        &self,
        order: &Order,
        wings: &[(f64, Coupled<'_>)],
        hidden: &[Effect],
        purpose: Purpose,
    ) -> Vec<StaticPoint> {
        let random = &mut Random::new(order.seed, purpose);
        let mut all = Vec::new();
        let tares = design::TILT_DEG.iter().map(|alpha| (0.0, *alpha));
        let blown = design::AIRSPEEDS_M_S.iter().flat_map(|v| design::ANGLES_DEG.iter().map(|a| (*v, *a)));
        let points: Vec<(f64, f64)> = tares.chain(blown).collect();
        for (block, day) in block_offsets(order.seed).into_iter().enumerate() {
            for (v_m_s, alpha_deg) in &points {
                let Some((_, coupled)) = wings.iter().find(|(speed, _)| speed == v_m_s) else { continue };
                let alpha = [vec![alpha_deg.to_radians()], vec![0.0], vec![0.0]];
                let maneuver = Maneuver {
                    v_m_s: *v_m_s,
                    rho_kg_m3: design::RHO_KG_M3,
                    alpha_deg: *alpha_deg,
                    sample_rate_hz: 1.0,
                    length_s: 0.0,
                    motions: Vec::new(),
                };
                let here = seen(&maneuver, coupled.time_step_s, (0.0, None), &alpha);
                let rigged: Vec<[Vec<f64>; 3]> = (0..self.controls.len())
                    .map(|control| {
                        let mut delta = vec![0.0];
                        for effect in hidden {
                            effect.on_deflection(&here, control, &mut delta);
                        }
                        [delta, vec![0.0], vec![0.0]]
                    })
                    .collect();
                let inputs = Inputs { alpha: alpha.clone(), controls: rigged };
                let mut flight = coupled.fly(&inputs, hidden.iter().any(Effect::needs_strips));
                effects::measured(hidden, &here, &self.rig.lattice.strips, &mut flight);
                let error = noise::channels(random, noise::STATIC_POINT);
                let offset = if *v_m_s > 0.0 { day } else { [0.0; 3] };
                let loads = [0, 1, 2].map(|c| flight.loads[c][0] + offset[c] + error[c]);
                let tip_z_m = flight.tip_z_m[0] + random.normal(noise::TIP_M);
                let reading = hidden.iter().fold(alpha[0][0], |angle, effect| effect.on_reading(angle));
                all.push(StaticPoint {
                    v_m_s: *v_m_s,
                    alpha_deg: reading.to_degrees(),
                    loads,
                    tip_z_m,
                    block,
                });
            }
        }
        all
    }
}

impl Measured {
    /// Whether loads are those of a wing that holds together.
    pub fn is_bounded(&self) -> bool {
        self.records.iter().flat_map(|record| &record.loads).flatten().all(|load| load.abs() < TORN_N)
    }
}

/// Central differences; zero at the ends, where all rests.
fn slopes(values: &[f64], time_step_s: f64) -> Vec<f64> {
    let mut slopes = vec![0.0; values.len()];
    for i in 1..values.len().saturating_sub(1) {
        slopes[i] = (values[i + 1] - values[i - 1]) / (2.0 * time_step_s);
    }
    slopes
}
