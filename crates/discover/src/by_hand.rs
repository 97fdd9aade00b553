//! Problems small enough to be worked out by hand: points measured with a noise of one, and effects whose loads are
//! written down.

use crate::candidate::Refit;
use crate::current_model::CurrentModel;
use crate::data::{Dataset, StaticGroup};
use crate::found::Found;
use crate::load_model::{LoadModel, Models};
use crate::noise::Noise;
use crate::null_distribution::{NullDistribution, label};
use crate::problem::Problem;
use crate::rank::Ranked;
use crate::rules::Rules;
use crate::setting::Setting;
use calibrate::Use;
use coupling::ByLoad;
use maneuver::Smooth;
use maneuver::effects::{Active, Effect, Flown, Inputs, Parameter, Side, Spec, Stimulus};
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// An effect by its declaration alone: its loads are in [`ByHand`].
#[derive(Debug, Clone)]
pub(crate) struct Made {
    spec: &'static Spec,
    parameters: Vec<Parameter>,
    pub(crate) form: &'static str,
    pub(crate) itself: bool,
    pub(crate) at_rest_only: bool,
}

impl Effect for Made {
    fn spec(&self) -> &'static Spec {
        self.spec
    }

    fn parameters(&self) -> Vec<Parameter> {
        self.parameters.clone()
    }

    fn form(&self) -> &'static str {
        self.form
    }

    fn is_itself(&self, _p: &[f64]) -> bool {
        self.itself
    }

    fn holds_at_rest_only(&self) -> bool {
        self.at_rest_only
    }
}

impl Made {
    /// In another form.
    pub(crate) fn formed(self, form: &'static str) -> Self {
        Self { form, ..self }
    }

    pub(crate) fn active(&self, values: &[f64]) -> Active {
        Active::new(Arc::new(self.clone()), values)
    }
}

/// An effect with some rivals and parameters.
pub(crate) fn made(name: &'static str, rivals: &'static [&'static str], parameters: Vec<Parameter>) -> Made {
    let spec = Spec { name, title: "", side: Side::Aerodynamics, rivals, experiment: "" };
    Made { spec: Box::leak(Box::new(spec)), parameters, form: "", itself: true, at_rest_only: false }
}

/// One parameter of either sign, plausibly of one.
pub(crate) fn size() -> Vec<Parameter> {
    vec![Parameter::new("size", -100.0..=100.0, 1.0)]
}

/// What an effect adds to all points, group after group.
type Law = Box<dyn Fn(&[f64]) -> Vec<f64> + Send + Sync>;

/// Loads by effect and form.
struct Loads {
    laws: Vec<(String, Law)>,
    points: Vec<usize>,
    flights: AtomicUsize,
}

impl std::fmt::Debug for Loads {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Loads")
    }
}

impl LoadModel for Loads {
    fn models(&self, _effects: &[Active], _before: Option<&Models>) -> Models {
        Models::default()
    }

    fn fly(&self, _models: &Models, effects: &[Active], wanted: &[usize]) -> Vec<Flown> {
        self.flights.fetch_add(1, Ordering::Relaxed);
        let mut sum = vec![0.0; self.points.iter().sum()];
        for active in effects {
            let own = label(&active.effect);
            for (_, law) in self.laws.iter().filter(|(name, _)| *name == own) {
                sum.iter_mut().zip(law(&active.values)).for_each(|(sum, load)| *sum += load);
            }
        }
        let one = |&place: &usize| {
            let (from, count) = (self.points[..place].iter().sum::<usize>(), self.points[place]);
            let still = vec![0.0; count];
            Flown { loads: [sum[from..from + count].to_vec(), still.clone(), still.clone()], tip_m: still }
        };
        wanted.iter().map(one).collect()
    }
}

/// See the module.
#[derive(Debug)]
pub(crate) struct ByHand {
    data: Dataset,
    noise: Noise,
    library: Vec<Arc<dyn Effect>>,
    uncertain: Vec<Active>,
    model: Loads,
}

impl ByHand {
    /// Groups of static points, each at an airspeed of its own, where nothing is allowed to a group.
    pub(crate) fn new(measured: &[&[f64]]) -> Self {
        let group = |(airspeed, loads): (usize, &&[f64])| {
            let still = vec![0.0; loads.len()];
            let alpha = Smooth { value: still.clone(), rate: still.clone(), second: still.clone() };
            StaticGroup {
                airspeed,
                stimulus: Stimulus {
                    inputs: Inputs { alpha, incidence_rad: still, controls_rad: Vec::new() },
                    time_step_s: 0.01,
                    steady: true,
                    clock_h: 0.0,
                },
                measured: loads.iter().map(|load| [Some(*load), None, None]).collect(),
                points: (0..loads.len()).collect(),
                blocks: vec![None; loads.len()],
                usage: Use::Train,
            }
        };
        let data = Dataset {
            rules: Arc::new(exact()),
            airspeeds_m_s: (1..=measured.len()).map(|v| 10.0 * v as f64).collect(),
            rho_kg_m3: 1.2,
            blocks: Vec::new(),
            runs: Vec::new(),
            conditions: Vec::new(),
            statics: measured.iter().enumerate().map(group).collect(),
            run_loads: [false; 3],
            stated: None,
            split: None,
            not_used: Vec::new(),
        };
        let noise = Noise {
            bands_hz: data.rules.noise.bands_hz,
            run: vec![[[1.0; 5]; 3]; measured.len()],
            offset: ByLoad::default(),
            point: ByLoad::from_fn(|_| 1.0),
            pairs: 0,
        };
        let points = measured.iter().map(|loads| loads.len()).collect();
        let model = Loads { laws: Vec::new(), points, flights: AtomicUsize::new(0) };
        Self { data, noise, library: Vec::new(), uncertain: Vec::new(), model }
    }

    /// With other rules.
    pub(crate) fn ruled(mut self, change: impl FnOnce(&mut Rules)) -> Self {
        change(Arc::make_mut(&mut self.data.rules));
        self
    }

    /// With another effect in the library.
    pub(crate) fn with(
        mut self,
        made: Made,
        law: impl Fn(&[f64]) -> Vec<f64> + Send + Sync + 'static,
    ) -> Self {
        let effect: Arc<dyn Effect> = Arc::new(made);
        self.model.laws.push((label(&effect), Box::new(law)));
        self.library.push(effect);
        self
    }

    /// With an effect that multiplies a column.
    pub(crate) fn column(self, made: Made, column: &[f64]) -> Self {
        let column = column.to_vec();
        self.with(made, move |values| column.iter().map(|value| value * values[0]).collect())
    }

    /// With an effect that no library lists, uncertain by a column.
    pub(crate) fn uncertain(self, column: &[f64]) -> Self {
        let mut known = self.column(made("uncertain", &[], size()), column);
        let effect = known.library.pop().expect("the one that was added");
        known.uncertain.push(Active::new(effect, &[1.0]));
        known
    }

    /// With a group that moves through some angles, at the airspeed of another group.
    pub(crate) fn moving(mut self, group: usize, airspeed: usize, alpha_rad: &[f64]) -> Self {
        let group = &mut self.data.statics[group];
        group.airspeed = airspeed;
        group.stimulus.steady = false;
        group.stimulus.inputs.alpha.value = alpha_rad.to_vec();
        self
    }

    pub(crate) fn setting(&self) -> Setting<'_> {
        Setting {
            data: &self.data,
            model: &self.model,
            variants: Vec::new(),
            library: &self.library,
            uncertain: &self.uncertain,
            open_corrections: 1.0,
        }
    }

    pub(crate) fn problem(&self) -> Problem<'_> {
        Problem::of_conditions(&self.data, &self.noise, Use::Train)
    }

    pub(crate) fn bare(&self) -> CurrentModel<'_> {
        CurrentModel::bare(&self.setting(), self.problem())
    }

    /// The model with effects.
    pub(crate) fn model(&self, effects: &[Active]) -> CurrentModel<'_> {
        CurrentModel::new(&self.setting(), self.problem(), effects)
    }

    /// The effect of a name in its first form, with values.
    pub(crate) fn active(&self, name: &str, values: &[f64]) -> Active {
        Active::new(Arc::clone(self.effect(name)), values)
    }

    pub(crate) fn effect(&self, name: &str) -> &Arc<dyn Effect> {
        self.library.iter().find(|effect| effect.spec().name == name).expect("an effect of the library")
    }

    /// How often all was flown.
    pub(crate) fn flights(&self) -> usize {
        self.model.flights.load(Ordering::Relaxed)
    }

    /// Null campaigns with one threshold and a misfit of nothing.
    pub(crate) fn nulls(&self, threshold: f64, misfit_limit: f64) -> NullDistribution {
        let evidence = self.library.iter().map(|effect| (label(effect), threshold)).collect();
        NullDistribution { evidence, misfit: 0.0, misfit_limit, ..NullDistribution::default() }
    }
}

/// Rules by which nothing is allowed to groups, forms and values.
fn exact() -> Rules {
    let mut rules = Rules::default();
    rules.tolerance.static_gain = 0.0;
    rules.tolerance.found_gain = 0.0;
    rules.shared.found_values_freed = 0;
    rules.naming.value_form = 0.0;
    rules
}

/// A fit that is said to have been made, and what speaks for it.
pub(crate) fn ranked(active: &Active, evidence: f64, residual: &[f64]) -> Ranked {
    let refit = Refit {
        active: active.clone(),
        sigma: vec![0.1; active.values.len()],
        residual: residual.to_vec(),
        chi2: residual.iter().map(|r| r * r).sum(),
        prior: 0.0,
        eigenvalues: vec![0.0; active.values.len()],
    };
    Ranked { refit, evidence, threshold: 0.0 }
}

/// An effect that is said to have been found with some evidence, among those considered.
pub(crate) fn found(active: &Active, named_at: f64, considered: &[&'static str]) -> Found {
    Found {
        active: active.clone(),
        sigma: vec![0.1; active.values.len()],
        evidence: named_at,
        named_at,
        confidence: 0.5,
        confused_with: Vec::new(),
        rivals: Vec::new(),
        considered: considered.to_vec(),
        shares: Vec::new(),
    }
}

/// 32 points with a value on some of them.
pub(crate) fn steps(parts: &[(Range<usize>, f64)]) -> Vec<f64> {
    let mut all = vec![0.0; 32];
    for (points, value) in parts {
        all[points.clone()].fill(*value);
    }
    all
}
