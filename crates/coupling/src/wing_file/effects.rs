//! Effects beyond the model, as a wing's file lists them: plain data. Which names and parameters there are is known to
//! `maneuver::effects`, which checks them when a wing with effects flies.

use nastran::suggest::nearest;
use nastran::{InputError, place_of};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// A covariance is symmetric to this share of its diagonal.
const SYMMETRIC: f64 = 1e-9;

/// An effect with the values of its parameters, and what is known of them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Effect")]
pub struct WingEffect {
    /// Its name, as in `maneuver::effects`.
    pub name: String,
    /// Its form where it has several; left out: the usual one.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub form: String,
    /// Values by parameter, in the units of their names; those left out are zero.
    #[serde(with = "in_order")]
    #[schemars(with = "BTreeMap<String, f64>")]
    pub parameters: Vec<(String, f64)>,
    /// Standard deviations of some or all parameters.
    #[serde(default, skip_serializing_if = "Vec::is_empty", with = "in_order")]
    #[schemars(with = "BTreeMap<String, f64>")]
    pub sigma: Vec<(String, f64)>,
    /// Covariance of the parameters, in the order they are listed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub covariance: Vec<Vec<f64>>,
    /// Where the data were that it comes from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub validity: Option<EffectValidity>,
    /// Natural logarithm of the Bayes factor against the model without it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub evidence: Option<f64>,
    /// Effects that the data cannot tell it from.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub rivals: Vec<String>,
    /// Fingerprint of the data it comes from.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub data_hash: String,
}

/// Smallest and largest value of what the data covered.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EffectValidity {
    /// Angle of attack, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub alpha_deg: Option<(f64, f64)>,
    /// Airspeed, m/s.
    #[serde(default, rename = "V_m_s", skip_serializing_if = "Option::is_none")]
    pub v_m_s: Option<(f64, f64)>,
    /// Frequency, Hz.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency_hz: Option<(f64, f64)>,
    /// Deflection of the control surfaces, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub delta_deg: Option<(f64, f64)>,
}

/// What is wrong: anchors of the place behind the effect's name, message, what to do.
type Fault = (Vec<String>, String, String);

impl WingEffect {
    /// An error about this effect of a wing's file, at the effect or, behind it, at the last of `anchors`.
    pub fn refused(&self, path: &Path, anchors: &[&str], message: String, help: &str) -> InputError {
        let text = nastran::read_text(path).unwrap_or_default();
        self.refused_in(&text, path, anchors, message, help)
    }

    fn refused_in(
        &self,
        text: &str,
        path: &Path,
        anchors: &[&str],
        message: String,
        help: &str,
    ) -> InputError {
        let name = format!("\"{}\"", self.name);
        let all: Vec<&str> = ["effects:", &name].into_iter().chain(anchors.iter().copied()).collect();
        InputError::at(&place_of(&all, text, path), message).with_help(help)
    }

    fn fault(&self) -> Option<Fault> {
        let name = &self.name;
        for (field, listed) in [("parameters", &self.parameters), ("sigma", &self.sigma)] {
            for (index, (parameter, value)) in listed.iter().enumerate() {
                let at = vec![format!("{field}:"), format!("\"{parameter}\"")];
                if !value.is_finite() || (field == "sigma" && *value < 0.0) {
                    let message = format!("{parameter} of {name} is {value} under {field}");
                    return Some((at, message, "write a number, in sigma none below zero".into()));
                }
                if listed[..index].iter().any(|(other, _)| other == parameter) {
                    let message = format!("{parameter} of {name} is listed twice under {field}");
                    return Some((at, message, "list it once".into()));
                }
            }
        }
        let known = || self.parameters.iter().map(|(parameter, _)| parameter.as_str());
        for (parameter, _) in &self.sigma {
            if !known().any(|other| other == parameter) {
                let help = nearest(parameter, known())
                    .map_or("list it under parameters too".into(), |meant| {
                        format!("did you mean \"{meant}\"?")
                    });
                let at = vec!["sigma:".into(), format!("\"{parameter}\"")];
                return Some((
                    at,
                    format!("sigma of {name} has {parameter}, which is no parameter listed"),
                    help,
                ));
            }
        }
        self.covariance_fault().or_else(|| self.validity_fault())
    }

    fn covariance_fault(&self) -> Option<Fault> {
        let (n, c) = (self.parameters.len(), &self.covariance);
        let square = c.is_empty() || (c.len() == n && c.iter().all(|row| row.len() == n));
        let symmetric = |i: usize, j: usize| {
            let off = (c[i][j] - c[j][i]).abs();
            c[i][j].is_finite() && c[i][i] >= 0.0 && off <= SYMMETRIC * (c[i][i] * c[j][j]).sqrt()
        };
        let sound = square && (0..c.len()).all(|i| (0..c.len()).all(|j| symmetric(i, j)));
        (!sound).then(|| {
            let message = format!("covariance of {} is no symmetric matrix of {n} by {n} numbers", self.name);
            let help = "rows in the order of the parameters, variances on the diagonal, or leave it out";
            (vec!["covariance:".into()], message, help.into())
        })
    }

    fn validity_fault(&self) -> Option<Fault> {
        let v = self.validity?;
        let ranges = [
            ("alpha_deg", v.alpha_deg),
            ("V_m_s", v.v_m_s),
            ("frequency_hz", v.frequency_hz),
            ("delta_deg", v.delta_deg),
        ];
        let wrong = |(_, range): &(&str, Option<(f64, f64)>)| {
            range.is_some_and(|(low, high)| !(low.is_finite() && high.is_finite() && low <= high))
        };
        ranges.into_iter().find(wrong).map(|(field, _)| {
            let at = vec!["validity:".to_owned(), format!("{field}:")];
            (at, format!("{field} of {} does not ascend", self.name), "write (smallest, largest)".to_owned())
        })
    }
}

/// Checks what can be checked without knowing the effects.
pub(super) fn check(effects: &[WingEffect], text: &str, path: &Path) -> Result<(), InputError> {
    for (index, effect) in effects.iter().enumerate() {
        let refuse = |anchors: &[&str], message: String, help: &str| {
            Err(effect.refused_in(text, path, anchors, message, help))
        };
        if effects[..index].iter().any(|other| other.name == effect.name) {
            // the second of them stands behind the first
            let again = format!("\"{}\"", effect.name);
            return refuse(&[&again], format!("{} is listed twice", effect.name), "list each effect once");
        }
        if let Some((anchors, message, help)) = effect.fault() {
            let anchors: Vec<&str> = anchors.iter().map(String::as_str).collect();
            return refuse(&anchors, message, &help);
        }
    }
    Ok(())
}

/// A map of numbers that keeps its order.
mod in_order {
    use serde::de::{MapAccess, Visitor};
    use serde::ser::SerializeMap;
    use serde::{Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(map: &[(String, f64)], serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_map(Some(map.len()))?;
        for (name, value) in map {
            out.serialize_entry(name, value)?;
        }
        out.end()
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(source: D) -> Result<Vec<(String, f64)>, D::Error> {
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = Vec<(String, f64)>;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("a map of numbers: {\"name\": 1.0}")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut all = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    all.push(pair);
                }
                Ok(all)
            }
        }
        source.deserialize_map(Pairs)
    }
}
