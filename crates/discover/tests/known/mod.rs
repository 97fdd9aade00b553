//! Problems whose answers are known: loads are sums of columns that effects multiply, measured with a noise of one.
#![allow(dead_code, reason = "each test file uses its own part")]

use calibrate::Use;
use coupling::ByLoad;
use discover::current_model::CurrentModel;
use discover::data::{Dataset, StaticGroup};
use discover::load_model::{LoadModel, Models};
use discover::noise::Noise;
use discover::null_distribution::NullDistribution;
use discover::problem::Problem;
use discover::rules::Rules;
use discover::setting::Setting;
use maneuver::Smooth;
use maneuver::effects::{Active, Effect, Flown, Inputs, Parameter, Side, Spec, Stimulus};
use std::sync::Arc;

/// Points of each airspeed.
pub(crate) const POINTS: usize = 200;
/// Airspeeds, m/s.
const AIRSPEEDS_M_S: [f64; 2] = [20.0, 30.0];

const fn spec(name: &'static str, rivals: &'static [&'static str]) -> Spec {
    Spec { name, title: "a column", side: Side::Aerodynamics, rivals, experiment: "another column" }
}

/// `twin` goes with `pitch` but for a little; `slope` and `pitch` are orthogonal.
static SPECS: [Spec; 3] = [spec("pitch", &["twin"]), spec("twin", &["pitch"]), spec("slope", &[])];

/// An effect that multiplies its column, plausibly by one.
#[derive(Debug)]
struct Column(&'static Spec);

impl Effect for Column {
    fn spec(&self) -> &'static Spec {
        self.0
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![Parameter::new("size", -10.0..=10.0, 1.0)]
    }
}

/// The effect of a name, at a size.
pub(crate) fn effect(name: &str, size: f64) -> Active {
    let spec = SPECS.iter().find(|spec| spec.name == name).expect("a known column");
    Active::new(Arc::new(Column(spec)), &[size])
}

/// The value of a column at a point of an airspeed, in units of the noise.
pub(crate) fn column(name: &str, airspeed: usize, point: usize) -> f64 {
    let turns = (point as f64 + 0.5) / POINTS as f64;
    let wave = |k: f64| (std::f64::consts::TAU * k * turns).sin();
    let grows = (AIRSPEEDS_M_S[airspeed] / 30.0).powi(2);
    match name {
        "pitch" => grows * wave(1.0),
        "twin" => grows * (wave(1.0) + 0.02 * wave(5.0)),
        "slope" => grows * wave(2.0),
        // no effect of the library
        "stranger" => grows * wave(3.0),
        _ => 0.0,
    }
}

/// A noise of known squares: plus and minus by turns, orthogonal to the waves but for a thousandth.
fn noise(point: usize) -> f64 {
    if point.is_multiple_of(2) { 0.9 } else { -0.9 }
}

#[derive(Debug)]
struct Sum;

impl LoadModel for Sum {
    fn models(&self, _effects: &[Active], _before: Option<&Models>) -> Models {
        Models::default()
    }

    fn fly(&self, _models: &Models, effects: &[Active], wanted: &[usize]) -> Vec<Flown> {
        let load = |airspeed: usize, point: usize| {
            let of = |e: &Active| e.values[0] * column(e.effect.spec().name, airspeed, point);
            effects.iter().map(of).sum::<f64>()
        };
        let one = |&airspeed: &usize| Flown {
            loads: [(0..POINTS).map(|i| load(airspeed, i)).collect(), vec![0.0; POINTS], vec![0.0; POINTS]],
            tip_m: vec![0.0; POINTS],
        };
        wanted.iter().map(one).collect()
    }
}

/// Static points in which columns were planted: size by airspeed.
pub(crate) struct Known {
    data: Dataset,
    noise: Noise,
    library: Vec<Arc<dyn Effect>>,
    uncertain: Vec<Active>,
}

impl Known {
    /// A library of some names, `planted` columns, nothing uncertain and nothing that a run may be off by unless `rules` say so.
    pub(crate) fn new(rules: Rules, library: &[&str], planted: &[(&str, [f64; 2])]) -> Self {
        let group = |airspeed: usize| {
            let load = |point: usize| {
                let of = |(name, sizes): &(&str, [f64; 2])| sizes[airspeed] * column(name, airspeed, point);
                noise(point) + planted.iter().map(of).sum::<f64>()
            };
            let still = vec![0.0; POINTS];
            let alpha = Smooth { value: still.clone(), rate: still.clone(), second: still.clone() };
            let inputs = Inputs { alpha, incidence_rad: still, controls_rad: Vec::new() };
            StaticGroup {
                airspeed,
                stimulus: Stimulus { inputs, time_step_s: 0.01, steady: true, clock_h: 0.0 },
                measured: (0..POINTS).map(|i| [Some(load(i)), None, None]).collect(),
                points: (0..POINTS).collect(),
                blocks: vec![None; POINTS],
                usage: Use::Train,
            }
        };
        let data = Dataset {
            rules: Arc::new(rules),
            airspeeds_m_s: AIRSPEEDS_M_S.to_vec(),
            rho_kg_m3: 1.2,
            blocks: Vec::new(),
            runs: Vec::new(),
            conditions: Vec::new(),
            statics: vec![group(0), group(1)],
            run_loads: [false; 3],
            stated: None,
            split: None,
            not_used: Vec::new(),
        };
        let bands_hz = data.rules.noise.bands_hz;
        let noise = Noise {
            bands_hz,
            run: vec![[[1.0; 5]; 3]; 2],
            offset: ByLoad::default(),
            point: ByLoad::from_fn(|_| 1.0),
            pairs: 0,
        };
        let library = library.iter().map(|name| effect(name, 1.0).effect).collect();
        Self { data, noise, library, uncertain: Vec::new() }
    }

    /// The same where a column is known to a standard deviation only.
    pub(crate) fn uncertain_of(mut self, name: &str, sigma: f64) -> Self {
        self.uncertain.push(effect(name, sigma));
        self
    }

    /// The same with everything at an airspeed held out, and measured as `change` makes of it.
    pub(crate) fn holding_out(mut self, airspeed: usize, change: impl Fn(f64) -> f64) -> Self {
        let group = &mut self.data.statics[airspeed];
        group.usage = Use::Holdout;
        group.measured.iter_mut().for_each(|loads| loads[0] = loads[0].map(&change));
        self
    }

    /// Training and held-out data, whose gaps are stated.
    pub(crate) fn judged(&self) -> [Problem<'_>; 2] {
        [Use::Train, Use::Holdout].map(|usage| Problem::of_runs(&self.data, &self.noise, usage))
    }

    pub(crate) fn setting(&self) -> Setting<'_> {
        Setting {
            data: &self.data,
            model: &Sum,
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

    /// Sum over all points of the product of two columns; `measured` is what was measured.
    pub(crate) fn product(&self, a: &str, b: &str) -> f64 {
        let value = |name: &str, airspeed: usize, i: usize| match name {
            "measured" => self.data.statics[airspeed].measured[i][0].unwrap_or(0.0),
            name => column(name, airspeed, i),
        };
        (0..2)
            .flat_map(|v| (0..POINTS).map(move |i| (v, i)))
            .map(|(v, i)| value(a, v, i) * value(b, v, i))
            .sum()
    }
}

/// Rules by which nothing is allowed to a run, and values are what the data leave.
pub(crate) fn exact() -> Rules {
    let mut rules = Rules::default();
    let tolerance = &mut rules.tolerance;
    tolerance.static_gain = 0.0;
    tolerance.found_gain = 0.0;
    rules.shared.found_values_freed = 0;
    rules.naming.value_form = 0.0;
    rules
}

/// What null campaigns would say: every effect needs the same.
pub(crate) fn nulls(threshold: f64) -> NullDistribution {
    NullDistribution {
        evidence: SPECS.iter().map(|spec| (format!("{} ", spec.name), threshold)).collect(),
        misfit: 0.81,
        misfit_limit: 1.2,
        floor: [0.9, 0.9],
        ..NullDistribution::default()
    }
}
