//! What makes another null distribution: everything that it depends on, and no measured load.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use calibrate::{Campaign, CorrectionSet, Schedule};
use coupling::ElasticWing;
use discover::data::Dataset;
use discover::null_distribution::NullDistribution;
use discover::null_key::NullKey;
use discover::rules::Rules;
use maneuver::effects::{Effect, Flight, Parameter, Spec, library};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A folder in `data/`.
fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

/// An effect with other bounds.
#[derive(Debug)]
struct Wider(Arc<dyn Effect>);

impl Effect for Wider {
    fn spec(&self) -> &'static Spec {
        self.0.spec()
    }

    fn form(&self) -> &'static str {
        self.0.form()
    }

    fn parameters(&self) -> Vec<Parameter> {
        let wider = |p: Parameter| Parameter { upper: 1.01 * p.upper, ..p };
        self.0.parameters().into_iter().map(wider).collect()
    }

    fn flight(&self) -> Flight {
        self.0.flight()
    }
}

#[test]
fn a_null_distribution_is_another_s_where_anything_but_a_measured_load_differs() {
    let (file, wing) = ElasticWing::read(&folder("tuflex").join("wing_beam.ron")).unwrap();
    let campaign = Campaign::read(&folder("tuflex/measured")).unwrap();
    let data = Dataset::read(&campaign, &wing, &Arc::default()).unwrap();
    let effects = library(&wing.control_names());
    let boxes = wing.correctable.len();
    let schedule = |force: f64| {
        let corrections =
            aero::Corrections { force: vec![force; boxes], ..aero::Corrections::neutral(boxes) };
        let sets = vec![CorrectionSet { v_m_s: 30.0, corrections }];
        Schedule {
            wing: file.name.clone(),
            wing_hash: file.hash.clone(),
            sets,
            found: None,
            unconverged: Vec::new(),
        }
    };
    let key = |data: &Dataset| NullKey::new(&file.hash, &schedule(1.0), 1.0, &effects, data);
    let own = key(&data);
    let differs = |changed: &dyn Fn(&mut Dataset)| {
        let mut other = data.clone();
        changed(&mut other);
        key(&other).differs_in(&own)
    };
    let none: [&str; 0] = [];
    assert_eq!(differs(&|_| ()), none);
    assert_eq!(differs(&|data| data.runs[3].measured[1][7] += 1.0), none, "a measured load");
    assert_eq!(differs(&|data| data.statics[1].measured[0][2] = Some(5.0)), none, "a measured load");
    assert_eq!(
        differs(&|data| data.runs[3].stimulus.inputs.controls_rad[0][7] += 1e-4),
        ["campaign's design"]
    );
    assert_eq!(differs(&|data| data.runs[3].stimulus.inputs.alpha.value[7] += 1e-4), ["campaign's design"]);
    assert_eq!(differs(&|data| data.runs[3].stimulus.clock_h += 0.1), ["campaign's design"]);
    assert_eq!(differs(&|data| data.airspeeds_m_s[1] += 0.1), ["campaign's design"]);
    assert_eq!(differs(&|data| data.runs[3].usage = other_use(data.runs[3].usage)), ["campaign's design"]);
    assert_eq!(differs(&|data| data.statics[1].measured[0][2] = None), ["campaign's design"]);
    assert_eq!(differs(&|data| data.stated.as_mut().unwrap().point.my *= 1.5), ["stated noise"]);
    let rules = |changed: &dyn Fn(&mut Rules)| {
        let mut rules = Rules::default();
        changed(&mut rules);
        differs(&|data| data.rules = Arc::new(rules.clone()))
    };
    assert_eq!(rules(&|rules| rules.nulls.sigmas = 2.9), ["rules"]);
    assert_eq!(rules(&|rules| rules.effects.own.get_mut("tip_mass").unwrap().form = 0.25), ["rules"]);
    let with = |effects: &[Arc<dyn Effect>]| {
        NullKey::new(&file.hash, &schedule(1.0), 1.0, effects, &data).differs_in(&own)
    };
    let mut wider = effects.clone();
    wider[5] = Arc::new(Wider(effects[5].clone()));
    assert_eq!(with(&wider), ["library of effects"], "a bound");
    assert_eq!(with(&effects[1..]), ["library of effects"], "an effect more");
    let other = NullKey::new("another", &schedule(1.01), 1.0, &effects, &data);
    assert_eq!(other.differs_in(&own), ["wing", "corrections"]);
    assert_eq!(
        NullKey::new(&file.hash, &schedule(1.0), 0.02, &effects, &data).differs_in(&own),
        ["corrections"]
    );
}

#[test]
fn campaigns_that_are_flown_alike_have_one_design_whatever_was_measured() {
    let (_, wing) = ElasticWing::read(&folder("tuflex").join("wing_beam.ron")).unwrap();
    let campaign = Campaign::read(&folder("tuflex/measured")).unwrap();
    let data = Dataset::read(&campaign, &wing, &Arc::default()).unwrap();
    let alike = |changed: &dyn Fn(&mut Dataset)| {
        let mut other = data.clone();
        changed(&mut other);
        (data.has_design_of(&other), other.has_design_of(&data))
    };
    let (yes, no) = ((true, true), (false, false));
    let angle = |data: &mut Dataset, by_rad: f64| {
        data.runs[3].stimulus.inputs.alpha.value.iter_mut().for_each(|alpha| *alpha += by_rad);
    };
    assert_eq!(alike(&|data| data.runs[3].measured[1][7] += 1.0), yes, "a measured load");
    assert_eq!(alike(&|data| data.runs[3].stimulus.clock_h += 30.0), yes, "another day");
    assert_eq!(alike(&|data| angle(data, 3e-4)), yes, "an encoder's noise");
    assert_eq!(alike(&|data| angle(data, 2e-3)), no, "another angle");
    assert_eq!(
        alike(&|data| data.runs[3].stimulus.inputs.controls_rad[0].fill(0.2)),
        no,
        "another deflection"
    );
    assert_eq!(alike(&|data| data.airspeeds_m_s[1] *= 1.0005), yes, "how well a tunnel holds its airspeed");
    assert_eq!(alike(&|data| data.airspeeds_m_s[1] *= 1.05), no, "another airspeed");
    assert_eq!(alike(&|data| data.runs[3].usage = other_use(data.runs[3].usage)), no, "another use");
    assert_eq!(alike(&|data| data.runs.truncate(20)), no, "fewer runs");
    assert_eq!(alike(&|data| data.statics[1].measured[0][2] = None), no, "a load less");
}

fn other_use(usage: calibrate::Use) -> calibrate::Use {
    if usage == calibrate::Use::Train { calibrate::Use::Holdout } else { calibrate::Use::Train }
}

#[test]
fn an_effect_that_no_null_campaign_was_searched_for_is_never_named_and_makes_a_new_distribution() {
    let effects = library(&["any".to_owned()]);
    let (first, others) = effects.split_first().unwrap();
    let without = NullDistribution::bare(others, 85.0);
    assert!(without.serves(&NullKey::default(), others) && !without.serves(&NullKey::default(), &effects));
    assert!(without.threshold(first) == f64::INFINITY && without.threshold(&others[0]).is_finite());
}
