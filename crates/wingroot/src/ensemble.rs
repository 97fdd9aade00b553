//! Intervals of what is computed with a calibrated wing: the same again with every wing of its ensemble.

use std::path::Path;
use std::sync::Arc;

use calibrate::ensemble::interval_of;
use calibrate::{Member, Schedule};
use coupling::wing_file::{Departure, Mount};
use coupling::{ElasticWing, WingFile};
use maneuver::{AirModel, Rig, RigError, RigSettings, SharedAir};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Map, Value};

use crate::corrections::{CorrectedWing, ENSEMBLE};
use crate::failure::Failure;
use crate::output::ResultFolder;

/// 90 % intervals, as corrections, stiffness and control surfaces are known.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Intervals {
    /// Where the wings are from whose spread they are.
    pub(crate) from: String,
    /// Low and high end in the place of every number of the updated model.
    pub(crate) of_updated: Value,
}

impl CorrectedWing {
    /// Where the wings are from whose spread intervals are, in words; none without them.
    pub(crate) fn intervals_from(&self) -> Option<String> {
        let wings = self.ensemble.as_ref()?.members.len();
        Some(format!("{wings} wings of {}", Path::new(&self.origin).with_file_name(ENSEMBLE).display()))
    }

    /// The wing with the structure and surfaces that were found, which is what flies as the updated model, and says so; none where root loads alone
    /// were measured, so that the structure is as given.
    ///
    /// # Errors
    /// If it cannot be assembled.
    pub(crate) fn found(&self) -> Result<Option<Self>, Failure> {
        let Some(found) = &self.schedule.found else { return Ok(None) };
        let percent = found.log_flexibility.map(|log| 100.0 * log.exp_m1());
        let names = self.wing.control_names();
        let controls =
            names.iter().zip(&found.controls).map(|(name, factor)| format!(", {name} {factor:.3}"));
        crate::show::note(&format!(
            "the updated model has the structure and surfaces that were found: flexibility in bending {:+.1} %, in torsion {:+.1} %{}",
            percent[0],
            percent[1],
            controls.collect::<String>()
        ));
        self.member(found).map(Some)
    }

    /// The doublet lattice that all wings of the ensemble have in common with `wing`, this one or the aircraft's, so that it is solved once for
    /// them; none without an ensemble.
    ///
    /// # Errors
    /// If it cannot be solved.
    pub(crate) fn shared_air(
        &self,
        wing: &ElasticWing,
        model: AirModel,
    ) -> Result<Option<Arc<SharedAir>>, Failure> {
        let settings = model.doublets().filter(|_| self.ensemble.is_some());
        let shared = settings.map(|settings| SharedAir::of(wing, settings)).transpose();
        Ok(shared.map_err(|error| RigError::Coupling(error.into()))?.map(Arc::new))
    }

    /// The wing on its balance, in the air that all wings of the ensemble have in common, if that was solved.
    ///
    /// # Errors
    /// As [`Rig::in_air`].
    pub(crate) fn rig(&self, settings: &RigSettings, shared: Option<&SharedAir>) -> Result<Rig<'_>, Failure> {
        Ok(Rig::in_air(&self.wing, settings.clone(), shared)?)
    }

    /// Computes the same with every wing of the ensemble, in their order; empty without one.
    ///
    /// # Errors
    /// Those of `compute`, and if a wing cannot be assembled.
    pub(crate) fn with_each<T: Send>(
        &self,
        compute: impl Fn(&Self) -> Result<T, Failure> + Sync,
    ) -> Result<Vec<T>, Failure> {
        let Some(ensemble) = &self.ensemble else { return Ok(Vec::new()) };
        let members = ensemble.members.par_iter().map(|member| compute(&self.member(member)?));
        members.collect()
    }

    /// The same with every wing as it flies, in free air.
    ///
    /// # Errors
    /// As [`CorrectedWing::with_each`].
    pub(crate) fn with_each_in_flight<T: Send>(
        &self,
        compute: impl Fn(&Self) -> Result<T, Failure> + Sync,
    ) -> Result<Vec<T>, Failure> {
        let Some(ensemble) = &self.ensemble else { return Ok(Vec::new()) };
        let members = ensemble.members.par_iter().map(|member| compute(&self.member_in_flight(member)?));
        members.collect()
    }

    /// A wing of the ensemble with the structure and surfaces of the tunnel, and corrections of free air.
    ///
    /// # Errors
    /// If it cannot be assembled.
    pub(crate) fn member_in_flight(&self, member: &Member) -> Result<Self, Failure> {
        self.member(&Member { sets: member.sets_in_flight(), ..member.clone() })
    }

    /// A wing of the ensemble as it stands in the tunnel.
    ///
    /// # Errors
    /// If it cannot be assembled.
    pub(crate) fn member(&self, member: &Member) -> Result<Self, Failure> {
        let (file, schedule) = self.of_member(member);
        let wing = ElasticWing::from_bulk(&file, &file.bulk(Mount::Tunnel)?)?;
        Ok(Self { file, wing, schedule, origin: self.origin.clone(), ensemble: None })
    }

    /// File and corrections of a wing of the ensemble.
    pub(crate) fn of_member(&self, member: &Member) -> (WingFile, Schedule) {
        let names = self.wing.control_names();
        let mut file = self.file.clone();
        file.departure = Departure {
            log_flexibility: member.log_flexibility,
            controls: names.into_iter().zip(member.controls.iter().copied()).collect(),
        };
        (file, Schedule { sets: member.sets.clone(), found: None, ..self.schedule.clone() })
    }
}

/// Writes corrections that were made from those of `corrected`, and the ensemble about them; control surfaces that were `known` by a measurement
/// since are as certain as it, in these and in the wing that was found, if `schedule` goes on with one.
pub(crate) fn write_corrections(
    folder: &ResultFolder,
    corrected: &CorrectedWing,
    schedule: Schedule,
    known: &[String],
) -> Result<(), Failure> {
    let names = corrected.wing.control_names();
    let known: Vec<usize> = (0..names.len()).filter(|&i| known.contains(&names[i])).collect();
    let schedule = match schedule.found {
        Some(_) => schedule.with_found_of(&corrected.schedule, &known),
        None => schedule,
    };
    folder.write_text("corrections.ron", &schedule.to_ron())?;
    let about = corrected.ensemble.clone().and_then(|e| e.about(&corrected.schedule, &schedule, &known));
    about.map_or(Ok(()), |ensemble| folder.write_text(ENSEMBLE, &ensemble.to_ron()?))
}

/// The 90 % interval of every number of a result, `[low, high]` in its place; names and what is no number are left out. Where a
/// wing of the ensemble has no such number (no flutter in range, say), there is no interval.
pub(crate) fn intervals(value: &Value, members: &[Value]) -> Value {
    intervals_of(value, &[members.to_vec()])
}

/// The same with several sources of uncertainty that know nothing of each other, each with its own wings.
pub(crate) fn intervals_of(value: &Value, sources: &[Vec<Value>]) -> Value {
    match value {
        Value::Number(number) => {
            let numbers = |members: &Vec<Value>| members.iter().map(Value::as_f64).collect();
            let each: Option<Vec<Vec<f64>>> = sources.iter().map(numbers).collect();
            match (number.as_f64(), each) {
                (Some(here), Some(each)) => interval_of(here, &each).to_vec().into(),
                _ => Value::Null,
            }
        }
        Value::Array(values) => values
            .iter()
            .enumerate()
            .map(|(i, value)| intervals_of(value, &at(sources, |member| member.get(i))))
            .collect(),
        Value::Object(fields) => {
            let inside = fields.iter().filter(|(_, value)| holds_numbers(value));
            let each = inside.map(|(name, value)| {
                (name.clone(), intervals_of(value, &at(sources, |member| member.get(name))))
            });
            Value::Object(each.filter(|(_, value)| !value.is_null()).collect::<Map<_, _>>())
        }
        _ => Value::Null,
    }
}

fn at<'a>(sources: &'a [Vec<Value>], of: impl Fn(&'a Value) -> Option<&'a Value>) -> Vec<Vec<Value>> {
    let inside = |member: &'a Value| of(member).cloned().unwrap_or(Value::Null);
    sources.iter().map(|members| members.iter().map(inside).collect()).collect()
}

fn holds_numbers(value: &Value) -> bool {
    match value {
        Value::Number(_) => true,
        Value::Array(values) => values.iter().any(holds_numbers),
        Value::Object(fields) => fields.values().any(holds_numbers),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::{intervals, intervals_of};
    use serde_json::{Value, json};

    /// Members 1.6448... apart in quadrature: closed form of the interval; words vanish, and a number that one wing lacks has none.
    #[test]
    fn every_number_has_its_interval_in_its_place_and_none_where_a_wing_has_none() {
        let value = json!({"name": "trim", "alpha": 2.0, "each": [1.0, 5.0], "flutter": 40.0, "none": null});
        let members = [
            json!({"name": "trim", "alpha": 3.0, "each": [1.0, 6.0], "flutter": 41.0, "none": null}),
            json!({"name": "trim", "alpha": 1.0, "each": [1.0, 4.0], "flutter": null, "none": 3.0}),
        ];
        let found = intervals(&value, &members);
        let half = 1.644_853_627;
        assert_eq!(found["alpha"], json!([2.0 - half, 2.0 + half]));
        assert_eq!(found["each"], json!([[1.0, 1.0], [5.0 - half, 5.0 + half]]));
        assert!(["flutter", "name", "none"].iter().all(|left_out| found.get(left_out).is_none()), "{found}");
    }

    /// Sources off by 3 and by 4 are off by 5 together.
    #[test]
    fn variances_of_sources_that_know_nothing_of_each_other_add() {
        let of = |values: [f64; 2]| values.map(|value| json!({ "speed": value })).to_vec();
        let found = intervals_of(&json!({"speed": 50.0}), &[of([53.0, 47.0]), of([54.0, 46.0])]);
        let ends: Vec<f64> = found["speed"].as_array().unwrap().iter().filter_map(Value::as_f64).collect();
        let half = 5.0 * 1.644_853_627;
        assert!((ends[0] - (50.0 - half)).abs() < 1e-6 && (ends[1] - (50.0 + half)).abs() < 1e-6, "{ends:?}");
    }
}
