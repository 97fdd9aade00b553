//! What is held out judges and does nothing else: with every number of it changed, what training data are flown as, the noise,
//! what is found and the thresholds stay the same to the last bit.

use crate::known::{Known, exact, nulls};
use aero::Corrections;
use calibrate::{Campaign, CorrectionSet, Schedule, Use};
use coupling::ElasticWing;
use discover::data::Dataset;
use discover::held_out_runs::sentence;
use discover::load_model::LoadModel;
use discover::noise::Noise;
use discover::null_campaigns::from_null_campaigns;
use discover::problem::Problem;
use discover::result::{BeforeAfter, HeldOutRun};
use discover::rules::VariantRules;
use discover::search::search;
use discover::simulator::{Simulator, SplitRig};
use discover::spectral_lines::spectral_lines;
use maneuver::AirModel;
use maneuver::effects::Flown;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Runs of the shipped campaign, and which are held out here: a repeat of a training run, all runs without wind and at two airspeeds.
const RUNS: [(&str, Use); 8] = [
    ("aoa_2hz_30_day_1.csv", Use::Train),
    ("aoa_2hz_30.csv", Use::Train),
    ("doublet_inner_15_30_day_1.csv", Use::Train),
    ("doublet_inner_15_18.csv", Use::Train),
    ("doublet_inner_15_30.csv", Use::Holdout),
    ("doublet_inner_15_26.csv", Use::Holdout),
    ("doublet_inner_15_34.csv", Use::Holdout),
    ("wind_off_4hz.csv", Use::Holdout),
];

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

fn campaign() -> Campaign {
    let mut campaign = Campaign::read(&folder("measured")).expect("the shipped campaign");
    let of = |file: &str| RUNS.iter().find(|(name, _)| *name == file).map(|(_, usage)| *usage);
    campaign.runs.retain_mut(|entry| {
        entry.usage = of(&entry.file);
        entry.usage.is_some()
    });
    campaign
}

/// The same with every number of held-out runs and of static points at their airspeeds changed: loads, angles, commands, airspeeds,
/// sample rates.
fn changed(campaign: &Campaign, folder: &Path) -> Campaign {
    let mut changed = campaign.clone();
    let column = |name: &str, value: f64| match name {
        "t_s" => 0.5 * value,
        "V_m_s" => 0.9985 * value,
        name if name.ends_with("_deg") => 0.4 + 0.7 * value,
        _ => 7.0 - 2.0 * value,
    };
    for entry in changed.runs.iter_mut().filter(|entry| entry.usage == Some(Use::Holdout)) {
        let text = std::fs::read_to_string(campaign.folder.join(&entry.file)).expect("a shipped run");
        let (head, rows) = text.split_once('\n').expect("rows");
        let names: Vec<&str> = head.split(',').collect();
        let row = |row: &str| {
            let values = row.split(',').zip(&names);
            values
                .map(|(value, name)| format!("{:.6}", column(name, value.parse().expect("a number"))))
                .collect::<Vec<String>>()
                .join(",")
        };
        let rows: Vec<String> = rows.lines().map(row).collect();
        let file = folder.join(&entry.file);
        std::fs::write(&file, format!("{head}\n{}\n", rows.join("\n"))).expect("the file can be written");
        file.to_str().expect("an ordinary name").clone_into(&mut entry.file);
    }
    for point in changed.points.iter_mut().filter(|point| point.v_m_s == 0.0 || point.v_m_s == 34.0) {
        point.loads = point.loads.map(|load| load.map(|load| 7.0 - 2.0 * load));
        point.alpha_rad = 0.01 + 0.7 * point.alpha_rad;
    }
    changed
}

/// All that training data are and are flown as.
struct Seen {
    data: Dataset,
    flown: Vec<Flown>,
    noise: Noise,
}

impl Seen {
    fn of(campaign: &Campaign, rig: &SplitRig<'_>, schedule: &Schedule) -> Self {
        let data = Dataset::read(campaign, rig.wing(), &Arc::default()).expect("its runs");
        let simulator = Simulator::new(rig, schedule, &data).expect("a simulator");
        let all: Vec<usize> = (0..data.stimuli().count()).collect();
        let flown = simulator.flown(&[], None, &all);
        let runs = &flown[data.statics.len()..data.statics.len() + data.runs.len()];
        let noise = Noise::new(&data, runs).expect("it is stated");
        Self { data, flown, noise }
    }

    fn runs(&self) -> &[Flown] {
        &self.flown[self.data.statics.len()..self.data.statics.len() + self.data.runs.len()]
    }

    fn residual(&self, problem: &Problem<'_>) -> Vec<f64> {
        let flown: Vec<Flown> = problem.places().into_iter().map(|place| self.flown[place].clone()).collect();
        problem.residual(&flown)
    }
}

#[test]
fn changing_every_held_out_number_moves_no_bit_of_training_data_their_simulation_and_the_noise() {
    let (file, wing) = ElasticWing::read(&folder("wing_beam.ron")).expect("the shipped wing");
    let rig = SplitRig::new(&file, &wing, AirModel::default(), &VariantRules::default()).expect("a rig");
    let corrections = || Corrections::neutral(wing.correctable.len());
    let sets = [17.0, 41.0].map(|v_m_s| CorrectionSet { v_m_s, corrections: corrections() }).to_vec();
    let schedule = Schedule {
        wing: file.name.clone(),
        wing_hash: file.hash.clone(),
        sets,
        found: None,
        unconverged: Vec::new(),
    };
    let scratch = Path::new(env!("CARGO_TARGET_TMPDIR")).join("held_out");
    std::fs::create_dir_all(&scratch).expect("a folder for the changed runs");
    let campaign = campaign();
    let [before, after] =
        [&campaign, &changed(&campaign, &scratch)].map(|campaign| Seen::of(campaign, &rig, &schedule));
    let (one, other) = (&before.data, &after.data);
    assert_eq!((one.runs.len(), other.runs.len()), (8, 8));
    let speed = |data: &Dataset, airspeed: usize| data.airspeeds_m_s[airspeed];
    for (i, (run, same)) in one.runs.iter().zip(&other.runs).enumerate() {
        assert_eq!(run.usage, same.usage);
        if run.usage == Use::Holdout {
            assert!(
                run.stimulus != same.stimulus && run.measured != same.measured,
                "{} is changed",
                run.name
            );
            continue;
        }
        assert_eq!((&run.stimulus, &run.measured), (&same.stimulus, &same.measured), "{}", run.name);
        assert_eq!(speed(one, run.airspeed), speed(other, same.airspeed), "airspeed of {}", run.name);
        assert_eq!(before.runs()[i], after.runs()[i], "{} as flown", run.name);
        for channel in 0..3 {
            for hz in [0.5, 2.0, 5.0, 11.0] {
                let sigma = |seen: &Seen, airspeed: usize| seen.noise.sigma(airspeed, channel, hz);
                assert_eq!(sigma(&before, run.airspeed), sigma(&after, same.airspeed), "noise at {hz} Hz");
            }
        }
    }
    let training = |data: &Dataset| {
        let groups = data.statics.iter().filter(|group| group.usage == Use::Train);
        groups.map(|group| (speed(data, group.airspeed), group.measured.clone())).collect::<Vec<_>>()
    };
    assert_eq!(training(one), training(other), "static points");
    assert_eq!(
        training(one).len(),
        4,
        "18, 22, 30 and 40 m/s; those without wind and at 34 m/s are held out"
    );
    assert_eq!(before.noise.offset, after.noise.offset);
    assert_eq!((before.noise.point, before.noise.pairs), (after.noise.point, after.noise.pairs));
    assert_eq!(after.noise.pairs, 1, "the held-out repeat makes no pair");
    assert_eq!(spectral_lines(one, before.runs()), spectral_lines(other, after.runs()));
    let searched = |seen: &Seen| seen.residual(&Problem::of_conditions(&seen.data, &seen.noise, Use::Train));
    assert_eq!(searched(&before), searched(&after), "what is searched");
    let judged = |seen: &Seen| seen.residual(&Problem::of_runs(&seen.data, &seen.noise, Use::Holdout));
    assert_ne!(judged(&before), judged(&after), "what judges is another");
}

#[test]
fn a_search_and_its_thresholds_do_not_follow_what_is_held_out() {
    let planted = [("pitch", [2.0, 2.0]), ("slope", [0.2, 0.2])];
    let known = |change: &dyn Fn(f64) -> f64| {
        Known::new(exact(), &["pitch", "twin", "slope"], &planted).holding_out(0, change)
    };
    let [as_measured, otherwise] = [known(&|load| load), known(&|load| 40.0 - 3.0 * load)];
    let thresholds =
        |known: &Known| from_null_campaigns(&known.setting(), known.problem(), &known.judged(), 1, &());
    assert_eq!(thresholds(&as_measured), thresholds(&otherwise));
    let found = |known: &Known| {
        let (outcome, current) = search(&known.setting(), known.problem(), &nulls(25.0), 1);
        let of = |found: &discover::found::Found| {
            (found.name(), found.active.values.clone(), found.sigma.clone(), found.evidence)
        };
        let gaps = known.judged().map(|problem| {
            problem.gap(&known.setting().model.fly(&current.models, &current.effects, &problem.places())).all
        });
        let next = outcome.next_best.as_ref().map(|next| (next.name(), next.evidence));
        let all = outcome.found.iter().map(of).collect::<Vec<_>>();
        (format!("{all:?} {next:?} {:?} {} {:?}", outcome.misfit, outcome.unexplained, outcome.trace), gaps)
    };
    let ((one, [training, held_out]), (other, [same, moved])) = (found(&as_measured), found(&otherwise));
    assert_eq!(one, other);
    assert_eq!(training, same);
    assert!(one.contains("pitch") && moved > 3.0 * held_out, "the judgement does: {held_out} and {moved}");
}

#[test]
fn a_held_out_run_that_moves_as_a_training_run_did_is_told_from_those_that_move_otherwise() {
    let (_, wing) = ElasticWing::read(&folder("wing_beam.ron")).expect("the shipped wing");
    let mut campaign = campaign();
    for says in [true, false] {
        if !says {
            // by its movement alone: the angles and deflections of another day
            campaign.runs.iter_mut().for_each(|run| run.repeat_of = None);
        }
        let data = Dataset::read(&campaign, &wing, &Arc::default()).expect("its runs");
        let repeated = |name: &str| {
            let run = data.runs.iter().position(|run| run.name == name).expect("a run");
            data.repeated_training_run(run).map(|first| data.runs[first].name.as_str())
        };
        assert_eq!(repeated("doublet_inner_15_30"), Some("doublet_inner_15_30_day_1"), "says so: {says}");
        for other in ["doublet_inner_15_26", "doublet_inner_15_34", "wind_off_4hz"] {
            assert_eq!(repeated(other), None, "{other}, another airspeed or another movement");
        }
    }
}

#[test]
fn gaps_of_repeats_and_of_new_maneuvers_are_said_apart() {
    let run = |repeats: Option<&str>, before: f64, after: f64, rows: usize| HeldOutRun {
        run: "run".into(),
        repeats: repeats.map(str::to_owned),
        gap: BeforeAfter { before, after },
        rows,
    };
    let runs = [run(Some("first"), 6.0, 1.0, 100), run(None, 3.0, 0.0, 100), run(None, 4.0, 5.0, 300)];
    // (9 + 3 * 16) / 4 = 14.25 and 3 * 25 / 4 = 18.75
    assert_eq!(
        sentence(&runs).expect("one repeats"),
        "1 of 3 held-out runs repeats a training maneuver (their gap 6.0 -> 1.0); gap of the 2 that move in a way or at an airspeed of \
         their own 3.8 -> 4.3"
    );
    assert!(sentence(&runs[..1]).expect("it repeats").ends_with("so they do not judge what is new"));
    assert_eq!(sentence(&runs[1..]), None);
}
