//! The answer of a case, kept apart from its campaign and read by the scorer alone.

use crate::class::Class;
use crate::effects::{Role, kind};
use crate::plan::{CasePlan, Defect};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A hidden effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TrueEffect {
    /// Name.
    pub name: String,
    /// Parameters by name with unit, as hidden or as an estimate may be compared with them.
    pub parameters: Vec<TrueParameter>,
    /// Detectability of this effect alone; none if it was not computed.
    pub d2: Option<f64>,
}

/// A parameter as hidden.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TrueParameter {
    /// Name with unit.
    pub name: String,
    /// Value.
    pub value: f64,
    /// Whether it is a size (zero: no effect), which an estimate may be compared with.
    pub size: bool,
}

/// See the module.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Answer {
    /// Seed of the list.
    pub list_seed: u64,
    /// Place in the list.
    pub index: usize,
    /// What kind of case.
    pub class: Class,
    /// What was hidden.
    pub effects: Vec<TrueEffect>,
    /// Fault of the data.
    pub defect: Option<Defect>,
    /// Effect that was removed from the library.
    pub leave_out: Option<String>,
    /// Detectability of all that was hidden together: squared distance between the campaign with and without it, in units of
    /// noise, run tolerance and jitter.
    pub d2: Option<f64>,
}

impl Answer {
    /// The answer to a plan, detectabilities still missing.
    pub(crate) fn of(plan: &CasePlan) -> Self {
        let effect = |hidden: &crate::plan::Hidden| {
            let kind = kind(&hidden.name);
            let parameters = kind.map_or(&[][..], |kind| kind.parameters);
            let compared = kind.and_then(|kind| kind.compared);
            let parameter = |(parameter, value): (&crate::effects::Parameter, &f64)| TrueParameter {
                name: parameter.name.to_owned(),
                value: *value,
                size: parameter.role == Role::Size,
            };
            let size =
                |(name, value): (&str, f64)| TrueParameter { name: name.to_owned(), value, size: true };
            TrueEffect {
                name: hidden.name.clone(),
                parameters: match compared {
                    Some(compared) => compared(&hidden.values).into_iter().map(size).collect(),
                    None => parameters.iter().zip(&hidden.values).map(parameter).collect(),
                },
                d2: None,
            }
        };
        Self {
            list_seed: plan.list_seed,
            index: plan.index,
            class: plan.class,
            effects: plan.effects.iter().map(effect).collect(),
            defect: plan.defect.clone(),
            leave_out: plan.leave_out.clone(),
            d2: None,
        }
    }
}
