//! What the policies of a selection ask for.

use super::file::{Load, Model, Policy, SelectFile, Weight};
use super::hull::corners;
use super::instant::Instant;
use super::places::{Place, Places};
use nastran::InputError;

/// Loads that are nowhere more than this share of the largest of their kind are rounding.
const NOTHING: f64 = 1e-9;

/// The order in which a cap takes drivers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rank {
    /// Asked for by number.
    Always,
    /// An end of the envelope.
    End,
    /// A corner of a hull.
    Corner,
    /// Anything else.
    Other,
}

impl Rank {
    /// Whether it counts as driven.
    pub(super) fn is_driven(self) -> bool {
        matches!(self, Self::End | Self::Corner)
    }
}

/// Something asked for, and the place of the instant that gives it.
#[derive(Debug, Clone)]
pub(super) struct Driver {
    pub(super) place: usize,
    pub(super) rank: Rank,
    pub(super) policy: &'static str,
    pub(super) what: String,
    pub(super) values: Vec<f64>,
}

/// A load at a place, with the instant and whether it is the image of the other side's.
struct Value {
    place: usize,
    loads: [f64; 6],
    image: bool,
}

/// All drivers, of each model by itself; `order` is sorted by model, case and instant.
pub(super) fn drivers(
    file: &SelectFile,
    places: &Places<'_>,
    order: &[&Instant],
) -> Result<Vec<Driver>, InputError> {
    let mut finder = Finder { file, order, nothing: nothing(order), model: Model::Initial, all: Vec::new() };
    for &model in &file.models {
        finder.model = model;
        for policy in &file.policies {
            match policy {
                Policy::Envelope { loads, stations } => finder.ends(&places.named(stations)?, loads),
                Policy::Hull { pairs, stations } => finder.hulls(&places.named(stations)?, pairs),
                Policy::Within { percent, loads, stations } => {
                    finder.within(&places.named(stations)?, loads, *percent);
                }
                Policy::Top { n, loads, stations } => finder.top(&places.named(stations)?, loads, *n),
                Policy::Score { n, weights } => finder.score(places, *n, weights)?,
                Policy::Always { cases, because } => finder.always(places, cases, because)?,
                Policy::Never { .. } => {}
            }
        }
    }
    Ok(finder.all)
}

/// Forces and moments that are nothing beside the largest of all instants.
fn nothing(order: &[&Instant]) -> [f64; 2] {
    [0, 3].map(|from| {
        let kind = order.iter().flat_map(|instant| &instant.loads).flat_map(move |six| &six[from..from + 3]);
        NOTHING * kind.fold(0.0_f64, |most, load| most.max(load.abs()))
    })
}

struct Finder<'a> {
    file: &'a SelectFile,
    order: &'a [&'a Instant],
    /// A force and a moment that are rounding.
    nothing: [f64; 2],
    model: Model,
    all: Vec<Driver>,
}

impl Finder<'_> {
    /// The instants of this model's cases that are wanted.
    fn values(&self, place: &Place, is_wanted: &dyn Fn(&Instant) -> bool) -> Vec<Value> {
        let own = self.order.iter().enumerate();
        own.filter(|(_, instant)| instant.model == self.model && is_wanted(instant))
            .flat_map(|(at, instant)| {
                place.loads(&instant.loads).map(move |(loads, image)| Value { place: at, loads, image })
            })
            .collect()
    }

    fn push(&mut self, rank: Rank, policy: &'static str, what: String, value: &Value, loads: &[Load]) {
        let what = if value.image { format!("{what} (image of the left)") } else { what };
        let values = loads.iter().map(|load| value.loads[load.place()]).collect();
        self.all.push(Driver { place: value.place, rank, policy, what, values });
    }

    /// Whether a load is rounding in all instants, as the whole of a free aircraft's is: it has neither ends nor corners.
    fn is_nothing(&self, values: &[Value], load: Load) -> bool {
        let at = load.place();
        let most = self.nothing[at / 3];
        most > 0.0 && values.iter().all(|value| value.loads[at].abs() <= most)
    }

    fn ends(&mut self, places: &[&Place], loads: &[Load]) {
        for place in places {
            let values = self.values(place, &|_| true);
            for &load in loads.iter().filter(|load| !self.is_nothing(&values, **load)).collect::<Vec<_>>() {
                for (end, value) in ends(&values, load) {
                    let what = format!("{} {} {end}", place.name, load.name());
                    self.push(Rank::End, "envelope", what, value, &[load]);
                }
            }
        }
    }

    fn hulls(&mut self, places: &[&Place], pairs: &[(Load, Load)]) {
        for place in places {
            let values = self.values(place, &|_| true);
            for &(a, b) in pairs {
                if self.is_nothing(&values, a) && self.is_nothing(&values, b) {
                    continue;
                }
                let points: Vec<(f64, f64)> =
                    values.iter().map(|v| (v.loads[a.place()], v.loads[b.place()])).collect();
                for corner in corners(&points) {
                    let what = format!("{} {} and {}", place.name, a.name(), b.name());
                    self.push(Rank::Corner, "hull", what, &values[corner], &[a, b]);
                }
            }
        }
    }

    fn within(&mut self, places: &[&Place], loads: &[Load], percent: f64) {
        for place in places {
            let values = self.values(place, &|_| true);
            for &load in loads {
                for (end, extreme) in ends(&values, load) {
                    let extreme = extreme.loads[load.place()];
                    let most = percent / 100.0 * extreme.abs();
                    for value in &values {
                        if (value.loads[load.place()] - extreme).abs() <= most {
                            let what = format!("{} {} {end}, within {percent} %", place.name, load.name());
                            self.push(Rank::Other, "within", what, value, &[load]);
                        }
                    }
                }
            }
        }
    }

    fn top(&mut self, places: &[&Place], loads: &[Load], n: usize) {
        for place in places {
            let values = self.values(place, &|_| true);
            for &load in loads {
                for (end, sign) in [("smallest", 1.0), ("largest", -1.0)] {
                    let best = best_cases(self.order, &values, n, &|v| -sign * v.loads[load.place()]);
                    for (at, value) in best.into_iter().enumerate() {
                        let what = format!("{} {} {end}, number {}", place.name, load.name(), at + 1);
                        self.push(Rank::Other, "top", what, value, &[load]);
                    }
                }
            }
        }
    }

    fn score(&mut self, places: &Places<'_>, n: usize, weights: &[Weight]) -> Result<(), InputError> {
        let mut scores: Vec<f64> = vec![0.0; self.order.len()];
        for weight in weights {
            for place in places.named(std::slice::from_ref(&weight.station))? {
                for value in self.values(place, &|_| true) {
                    let own = weight.weight * value.loads[weight.load.place()].abs() / weight.allowable;
                    scores[value.place] = scores[value.place].max(own);
                }
            }
        }
        let own = self.order.iter().enumerate().filter(|(_, instant)| instant.model == self.model);
        let values: Vec<Value> =
            own.map(|(place, _)| Value { place, loads: [0.0; 6], image: false }).collect();
        for value in best_cases(self.order, &values, n, &|value| scores[value.place]) {
            let what = format!("score {:.4}", scores[value.place]);
            self.push(Rank::Other, "score", what, value, &[]);
        }
        Ok(())
    }

    /// A case asked for by number: with the instants of its own ends.
    fn always(&mut self, places: &Places<'_>, cases: &[usize], because: &str) -> Result<(), InputError> {
        for &case in cases {
            if !self.order.iter().any(|instant| instant.case == case) {
                return Err(self.file.no_case(case));
            }
            for place in places.named(&[])? {
                let values = self.values(place, &|instant| instant.case == case);
                for load in [Load::Fz, Load::Mx, Load::My] {
                    for (end, value) in ends(&values, load) {
                        let what = format!("{because}: its {} {} {end}", place.name, load.name());
                        self.push(Rank::Always, "always", what, value, &[load]);
                    }
                }
            }
        }
        Ok(())
    }
}

/// The smallest and the largest value, of equal ones the first.
fn ends(values: &[Value], load: Load) -> Vec<(&'static str, &Value)> {
    let first = |sign: f64| {
        values.iter().reduce(|best, value| {
            let at = load.place();
            if sign * value.loads[at] < sign * best.loads[at] { value } else { best }
        })
    };
    [("smallest", first(1.0)), ("largest", first(-1.0))]
        .into_iter()
        .filter_map(|(end, value)| value.map(|value| (end, value)))
        .collect()
}

/// The best instant of each case, of the `n` best cases; of equal ones the first.
fn best_cases<'v>(
    order: &[&Instant],
    values: &'v [Value],
    n: usize,
    score: &dyn Fn(&Value) -> f64,
) -> Vec<&'v Value> {
    let mut sorted: Vec<&Value> = values.iter().collect();
    sorted.sort_by(|a, b| score(b).total_cmp(&score(a)));
    let mut taken: Vec<&Value> = Vec::new();
    for value in sorted {
        let is_new = taken.iter().all(|other| order[other.place].case != order[value.place].case);
        if is_new && taken.len() < n {
            taken.push(value);
        }
    }
    taken
}
