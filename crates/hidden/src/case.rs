//! From a plan to a campaign: the true wing of the case is assembled, flown, measured, and spoilt if the plan says so.

use crate::answer::Answer;
use crate::at_speed::AtSpeed;
use crate::bench::Bench;
use crate::campaign::{CampaignFiles, Measured, airspeeds_m_s, records, static_points, texts};
use crate::design::{runs, wind_off_runs};
use crate::effects::{Effect, kind};
use crate::faults::spoil;
use crate::jitter::Jitter;
use crate::physics::Physics;
use crate::plan::{CasePlan, Hidden};
use crate::random::Stream;
use crate::servo::Servo;
use crate::simulate::TrueWing;
use crate::sizes::scaled;
use structure::unsymmetric::eigenvalues;

/// A case as it is handed out.
#[derive(Debug, Clone)]
pub struct Case {
    /// What is measured.
    pub measured: Measured,
    /// The same as files.
    pub files: CampaignFiles,
    /// What is hidden; to be kept elsewhere.
    pub answer: Answer,
}

/// Eigenvalues further right than this are a wing that shakes itself to pieces, 1/s.
const STABLE: f64 = -0.2;
/// How often sizes are halved until the wing is stable.
const MOST_HALVINGS: usize = 8;

/// How often, and how closely, sizes are scaled to a detectability.
const MOST_SCALINGS: usize = 6;
const SCALED_WITHIN: f64 = 0.15;

/// The effects of a plan.
pub(crate) fn effects(hidden: &[Hidden]) -> Vec<Effect> {
    let effect = |hidden: &Hidden| Some(Effect { kind: kind(&hidden.name)?, values: hidden.values.clone() });
    hidden.iter().filter_map(effect).collect()
}

impl Bench {
    /// Makes a case. The same plan gives the same bytes, whatever the number of threads.
    pub fn case(&self, plan: &CasePlan) -> Case {
        let jitter = Jitter::of(plan.seed);
        let physics = |v_m_s: f64| self.jittered(&jitter, v_m_s);
        let mut plan = plan.clone();
        for _ in 0..MOST_HALVINGS {
            let effects = effects(&plan.effects);
            let wing =
                TrueWing { parts: &self.parts, jittered: &physics, effects: &effects, servo: jitter.servo() };
            if airspeeds_m_s().iter().all(|v_m_s| is_stable(&wing.at(*v_m_s))) {
                break;
            }
            plan.effects = scaled(&plan.effects, 0.5);
        }
        let d2 = self.detectability(&mut plan, &jitter);
        let mut measured = match &self.vortices {
            Some(tunnel) => crate::vortices::measured(tunnel, &mut plan),
            None => self.measured(&plan, &physics, &jitter),
        };
        if let Some(defect) = &plan.defect {
            spoil(&mut measured, defect);
        }
        let files = texts(&measured, &self.controls, false);
        let mut answer = Answer::of(&plan);
        answer.d2 = d2;
        for effect in &mut answer.effects {
            // of one alone; with several, each beside the wing without any
            effect.d2 =
                if plan.effects.len() == 1 { d2 } else { Some(self.alone(&plan, &effect.name, &jitter)) };
        }
        Case { measured, files, answer }
    }

    /// How well the plan's effects can be seen together; sizes are scaled to the plan's target first.
    fn detectability(&self, plan: &mut CasePlan, jitter: &Jitter) -> Option<f64> {
        if plan.effects.is_empty() {
            return None;
        }
        let without = self.clean_loads(jitter, &[]);
        let of = |hidden: &[Hidden]| self.metric().d2(&self.clean_loads(jitter, &effects(hidden)), &without);
        let mut d2 = of(&plan.effects);
        let Some(target) = plan.target_d2 else { return Some(d2) };
        for _ in 0..MOST_SCALINGS {
            if (d2 / target - 1.0).abs() < SCALED_WITHIN || d2 <= 0.0 {
                break;
            }
            plan.effects = scaled(&plan.effects, (target / d2).sqrt().clamp(0.02, 3.0));
            d2 = of(&plan.effects);
        }
        Some(d2)
    }

    /// How well one of several effects could be seen alone.
    fn alone(&self, plan: &CasePlan, name: &str, jitter: &Jitter) -> f64 {
        let one: Vec<Hidden> = plan.effects.iter().filter(|hidden| hidden.name == name).cloned().collect();
        let with = self.clean_loads(jitter, &effects(&one));
        self.metric().d2(&with, &self.clean_loads(jitter, &[]))
    }

    fn measured(
        &self,
        plan: &CasePlan,
        physics: &(dyn Fn(f64) -> Physics + Sync),
        jitter: &Jitter,
    ) -> Measured {
        let given =
            plan.servos.given().map(|(frequency_hz, damping_ratio)| Servo { frequency_hz, damping_ratio });
        let servo = given.unwrap_or_else(|| jitter.servo());
        let wing_with = |effects| TrueWing { parts: &self.parts, jittered: physics, effects, servo };
        let none = Vec::new();
        let effects = effects(&plan.effects);
        let (plain, wing) = (wing_with(&none), wing_with(&effects));
        let speeds_of = |wing: &TrueWing<'_>| airspeeds_m_s().map(|v_m_s| wing.at(v_m_s));
        let speeds = speeds_of(&wing);
        let still = wing.at(0.0);
        let mut planned = runs(&self.controls);
        if plan.wind_off {
            planned.extend(wind_off_runs());
        }
        let tested: Vec<&AtSpeed> = speeds.iter().chain([&still]).collect();
        Measured {
            records: records(&wing, &planned, &tested, plan.seed),
            statics: static_points(&wing, &speeds, &still, (plan.seed, Stream::Statics)),
            reference: static_points(
                &plain,
                &speeds_of(&plain),
                &plain.at(0.0),
                (plan.seed, Stream::Reference),
            ),
        }
    }
}

fn is_stable(at: &AtSpeed) -> bool {
    let most = |values: &[faer::c64]| values.iter().map(|value| value.re).fold(f64::MIN, f64::max);
    eigenvalues(at.linear.a.as_ref()).is_some_and(|values| most(&values) < STABLE)
}
