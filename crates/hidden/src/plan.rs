//! What is hidden in which case: a list that follows from a seed and a mix alone.

use crate::class::{Class, Mix};
use crate::effects::{KINDS, Kind, Parameter, Role, Sign, kind};
use crate::random::{Random, Stream};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A fault of the data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Defect {
    /// A channel (0 Fz, 1 Mx, 2 My) with the wrong sign in all runs.
    SignFlipped {
        /// Channel.
        channel: usize,
    },
    /// Two channels with each other's name in all runs.
    Swapped {
        /// One.
        first: usize,
        /// The other.
        second: usize,
    },
    /// A record whose airspeed is said wrong.
    WrongAirspeed {
        /// Number of the record.
        record: usize,
        /// What is said, m/s.
        said_m_s: f64,
    },
    /// A channel that does not go beyond a share of its largest value.
    Clipped {
        /// Channel.
        channel: usize,
        /// Share.
        share: f64,
    },
    /// No replicates, and no noise stated.
    NoReplicates,
}

/// An effect with the values of its parameters, in the order of its kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hidden {
    /// Name.
    pub name: String,
    /// Values.
    pub values: Vec<f64>,
}

/// One case before it is simulated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CasePlan {
    /// Seed of the list.
    pub list_seed: u64,
    /// Place in the list, from 0.
    pub index: usize,
    /// Seed of all random numbers of this case.
    pub seed: u64,
    /// What kind of case.
    pub class: Class,
    /// What is hidden.
    pub effects: Vec<Hidden>,
    /// Detectability to which sizes are scaled.
    pub target_d2: Option<f64>,
    /// What is at fault with the data.
    pub defect: Option<Defect>,
    /// Effect to be removed from the library before the case is judged.
    pub leave_out: Option<String>,
    /// Whether pitch without wind is flown too; not in lists of cases.
    #[serde(default)]
    pub wind_off: bool,
    /// The true servos; lists of cases draw them.
    #[serde(default)]
    pub servos: TrueServos,
}

/// The true servos of a case.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub enum TrueServos {
    /// Drawn with the wing, near those of the model.
    #[default]
    Drawn,
    /// Surfaces follow at once.
    None,
    /// Of second order.
    SecondOrder {
        /// Natural frequency.
        frequency_hz: f64,
        /// Damping ratio.
        damping_ratio: f64,
    },
}

impl TrueServos {
    /// Natural frequency (infinite: they follow at once) and damping ratio, unless they are drawn.
    pub(crate) fn given(self) -> Option<(f64, f64)> {
        match self {
            Self::Drawn => None,
            Self::None => Some((f64::INFINITY, 1.0)),
            Self::SecondOrder { frequency_hz, damping_ratio } => Some((frequency_hz, damping_ratio)),
        }
    }
}

/// What a seed may be used for; the ranges are kept apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeedRange {
    /// Below one million: to develop rules.
    Development,
    /// Below two millions: to set thresholds.
    Calibration,
    /// Below three millions: to judge, once.
    Test,
}

impl SeedRange {
    /// The range of a seed; none beyond three millions.
    pub fn of(seed: u64) -> Option<Self> {
        [Self::Development, Self::Calibration, Self::Test]
            .into_iter()
            .find(|range| range.seeds().contains(&seed))
    }

    /// Its seeds.
    pub fn seeds(self) -> std::ops::Range<u64> {
        const WIDTH: u64 = 1_000_000;
        let first = match self {
            Self::Development => 0,
            Self::Calibration => WIDTH,
            Self::Test => 2 * WIDTH,
        };
        first..first + WIDTH
    }
}

/// Detectabilities of weak cases.
const WEAK_D2: [f64; 4] = [10.0, 30.0, 100.0, 300.0];
/// Effects that are easily taken for each other; the last are two that together look like a wrong dynamic pressure.
const LOOK_ALIKES: [&[&str]; 13] = [
    &["joiner_inertia"],
    &["added_mass"],
    &["tip_mass"],
    &["bend_stiff"],
    &["delay"],
    &["daq_filter"],
    &["act_lag"],
    &["alpha_offset"],
    &["camber"],
    &["gain"],
    &["crosstalk"],
    &["q_error"],
    &["lift_slope", "ctl_scale"],
];
/// Effects of the library that this list hides as singles; drawn in turn.
const SINGLES: [&str; 29] = [
    "joiner_inertia",
    "tip_mass",
    "crosstalk",
    "gain",
    "drift",
    "alpha_offset",
    "q_error",
    "camber",
    "lift_slope",
    "tip_loss",
    "ac_shift",
    "stall",
    "re_dependence",
    "ctl_saturation",
    "ctl_scale",
    "ctl_compliance",
    "act_lag",
    "act_rate",
    "backlash",
    "bend_stiff",
    "tors_stiff",
    "damping",
    "added_mass",
    "aero_lag",
    "delay",
    "daq_filter",
    "friction",
    "inplane_force",
    "large_deflection",
];
/// The paper's effects.
const PAPER: [&[&str]; 3] = [&["joiner_inertia"], &["ctl_saturation"], &["joiner_inertia", "ctl_saturation"]];
/// What no library has; the second is removed from it.
const OUTSIDE: [&str; 4] = ["mx_alpha_squared", "ctl_asym", "shedding_tone", "balance_creep"];

/// The first `count` cases of a seed. A shorter list is the beginning of a longer one.
pub fn cases(seed: u64, count: usize, mix: &Mix) -> Vec<CasePlan> {
    let plan = |(index, (class, number)): (usize, (Class, usize))| draw(seed, index, class, number);
    mix.classes(count).into_iter().enumerate().map(plan).collect()
}

/// Mixes seed and index (splitmix64).
fn case_seed(seed: u64, index: usize) -> u64 {
    let mut z = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(index as u64 + 1);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

fn draw(list_seed: u64, index: usize, class: Class, number: usize) -> CasePlan {
    let seed = case_seed(list_seed, index);
    let mut random = Random::new(seed, Stream::Plan);
    let in_turn = |names: &[&'static str]| names[number % names.len()];
    let names: Vec<&str> = match class {
        Class::Null | Class::Defect => Vec::new(),
        Class::Single | Class::Weak | Class::LeftOut => vec![in_turn(&SINGLES)],
        Class::Pair => {
            let order = random.order(SINGLES.len());
            vec![SINGLES[order[0]], SINGLES[order[1]]]
        }
        Class::OutOfLibrary => vec![in_turn(&OUTSIDE)],
        Class::LookAlike => LOOK_ALIKES[number % LOOK_ALIKES.len()].to_vec(),
        Class::Paper => PAPER[number % 3].to_vec(),
        Class::PaperPair => PAPER[2].to_vec(),
    };
    let effects = names.iter().filter_map(|name| kind(name)).map(|kind| hide(kind, class, &mut random));
    CasePlan {
        list_seed,
        index,
        seed,
        class,
        effects: effects.collect(),
        target_d2: (class == Class::Weak).then(|| WEAK_D2[(number / SINGLES.len() + number) % 4]),
        defect: (class == Class::Defect).then(|| defect(number, &mut random)),
        leave_out: match class {
            Class::LeftOut => Some(in_turn(&SINGLES).to_owned()),
            Class::OutOfLibrary if in_turn(&OUTSIDE) == "ctl_asym" => Some("ctl_asym".to_owned()),
            _ => None,
        },
        wind_off: false,
        servos: TrueServos::Drawn,
    }
}

fn hide(kind: &Kind, class: Class, random: &mut Random) -> Hidden {
    let value = |(place, parameter): (usize, &Parameter)| match (class.is_of_paper(), kind.name, place) {
        // a joiner of .15 kg m2, a little ahead of the axis and above it; ailerons that lose a quarter at 25 degrees
        (true, "joiner_inertia", 0) => 0.15 * random.log_uniform(0.9, 1.1),
        (true, "joiner_inertia", 1) => -0.115 * random.log_uniform(0.8, 1.25),
        (true, "joiner_inertia", _) => 0.1 * random.log_uniform(0.8, 1.25),
        (true, "ctl_saturation", 0) => 2.5 * random.log_uniform(0.8, 1.25),
        _ => draw_value(parameter, class, random),
    };
    Hidden { name: kind.name.to_owned(), values: kind.parameters.iter().enumerate().map(value).collect() }
}

fn draw_value(parameter: &Parameter, class: Class, random: &mut Random) -> f64 {
    if let Role::Choice(count) = parameter.role {
        return random.below(count) as f64;
    }
    // what is to be recognised outside a library, or as one of two, must be large enough to be seen
    let clear = matches!(class, Class::Pair | Class::OutOfLibrary | Class::LeftOut | Class::LookAlike);
    let low = if clear && parameter.role == Role::Size {
        (parameter.low * parameter.high).sqrt()
    } else {
        parameter.low
    };
    let size = random.log_uniform(low, parameter.high);
    match parameter.sign {
        Sign::Plus => size,
        Sign::Minus => -size,
        Sign::Either => {
            if random.unit() < 0.5 {
                -size
            } else {
                size
            }
        }
    }
}

fn defect(number: usize, random: &mut Random) -> Defect {
    let channel = random.below(3);
    match number % 5 {
        0 => Defect::SignFlipped { channel },
        1 => Defect::Swapped { first: channel, second: (channel + 1 + random.below(2)) % 3 },
        2 => {
            // one of the first records of the design, where airspeeds are said as others of the campaign
            let record = 2 * random.below(12);
            Defect::WrongAirspeed { record, said_m_s: [18.0, 22.0, 30.0, 34.0][random.below(4)] }
        }
        3 => Defect::Clipped { channel, share: 0.6 + 0.25 * random.unit() },
        _ => Defect::NoReplicates,
    }
}

/// Names of everything that can be hidden.
pub fn names() -> impl Iterator<Item = &'static str> {
    KINDS.iter().map(|kind| kind.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shorter_list_is_the_beginning_of_a_longer_one() {
        let mix = Mix::default();
        assert_eq!(cases(5, 20, &mix), cases(5, 90, &mix)[..20]);
        assert_ne!(cases(5, 20, &mix)[3].seed, cases(6, 20, &mix)[3].seed);
    }

    #[test]
    fn six_hundred_cases_have_two_hundred_nulls_and_every_effect_of_the_list() {
        let all = cases(2_000_000, 600, &Mix::default());
        assert!(all.iter().filter(|case| case.class == Class::Null).count() >= 200);
        for name in SINGLES {
            assert!(kind(name).is_some(), "{name}");
            let singles = all.iter().filter(|case| case.class == Class::Single);
            assert!(singles.filter(|case| case.effects[0].name == name).count() >= 5, "{name}");
        }
        assert!(OUTSIDE.iter().chain(LOOK_ALIKES.iter().copied().flatten()).all(|name| kind(name).is_some()));
    }

    #[test]
    fn a_list_of_one_class_has_that_class_alone_and_is_named_as_in_results() {
        let class: Class = "paper_pair".parse().unwrap_or_else(|error: String| panic!("{error}"));
        let pairs = cases(3, 4, &Mix::only(class));
        for pair in &pairs {
            assert_eq!(pair.class, Class::PaperPair);
            let names: Vec<&str> = pair.effects.iter().map(|hidden| hidden.name.as_str()).collect();
            assert_eq!(names, ["joiner_inertia", "ctl_saturation"]);
        }
        assert_ne!(pairs[0].effects, pairs[1].effects);
        let refused = "pairs".parse::<Class>().map_err(|error| error.contains("`pair`"));
        assert_eq!(refused, Err(true));
    }

    #[test]
    fn seeds_belong_to_one_range() {
        assert_eq!(SeedRange::of(7), Some(SeedRange::Development));
        assert_eq!(SeedRange::of(1_000_000), Some(SeedRange::Calibration));
        assert_eq!(SeedRange::of(2_999_999), Some(SeedRange::Test));
        assert_eq!(SeedRange::of(3_000_000), None);
    }
}
