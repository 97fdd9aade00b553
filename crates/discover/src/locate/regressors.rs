//! What the residual of a channel goes with: partial F tests of families of regressors.
//!
//! A family is judged by what leaving it out costs when all others stay, so two families that move alike cannot both
//! claim a residual. Runs are the unit, not samples: a family's score is one number a run and column (the correlation of the
//! column, without what the others explain, with the residual that the others leave), and F tells whether the scores'
//! mean over the runs in which the family moves is zero (Hotelling's T²); correlation within a run is no matter, and no
//! run counts more than another.

use super::families::{Column, FAMILIES, columns};
use super::gram::Gram;
use super::residuals::{Residuals, Unit};
use crate::rules::LocateRules;
use rayon::prelude::*;
use response::FTest;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What a part of a residual goes with.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Located {
    /// Channel.
    pub channel: Cow<'static, str>,
    /// Family of regressors.
    pub regressor: Cow<'static, str>,
    /// Share of the channel's residual beyond pure error that only this family explains.
    pub share_of_residual: f64,
    /// Probability of scores as consistent by chance.
    pub p_value: f64,
    /// Where, in words.
    #[serde(rename = "where")]
    pub place: String,
}

/// Families by channel, the largest share first.
pub fn regressors(residuals: &Residuals) -> Vec<Located> {
    let of_unit = |unit: &Unit| columns(&residuals.rules.locate, unit);
    let columns: Vec<Vec<Column>> = residuals.units.par_iter().map(of_unit).collect();
    let mut all: Vec<Located> =
        (0..3).flat_map(|c| Channel::new(residuals, &columns, c).located(residuals)).collect();
    all.sort_by(|a, b| b.share_of_residual.total_cmp(&a.share_of_residual));
    all
}

struct Channel<'a> {
    rules: &'a LocateRules,
    which: usize,
    units: Vec<&'a Unit>,
    /// Of each of these units.
    columns: Vec<&'a [Column]>,
    grams: Vec<Gram>,
    total: Gram,
    rows: usize,
    /// Columns of each family.
    families: Vec<(&'static str, Vec<usize>)>,
}

impl<'a> Channel<'a> {
    fn new(residuals: &'a Residuals, columns: &'a [Vec<Column>], channel: usize) -> Self {
        let rules = &residuals.rules.locate;
        let all = residuals.units.iter().zip(columns.iter().map(Vec::as_slice));
        let (units, columns): (Vec<&Unit>, Vec<&[Column]>) =
            all.filter(|(unit, _)| !unit.rows[channel].is_empty()).unzip();
        let gram = |(unit, columns): (&&Unit, &&[Column])| {
            let weight = &unit.weight[channel];
            let weighted =
                |column: &Column| column.rows.iter().zip(weight).map(|(row, weight)| row * weight).collect();
            Gram::new(&columns.iter().map(weighted).collect::<Vec<_>>(), &unit.rows[channel])
        };
        let grams: Vec<Gram> = units.par_iter().zip(&columns).map(gram).collect();
        let mut total = Gram::new(&[], &[]);
        if let Some((first, others)) = grams.split_first() {
            total = first.clone();
            for other in others {
                total.add(other);
            }
        }
        let names: Vec<&str> =
            columns.first().map_or_else(Vec::new, |own| own.iter().map(|column| column.family).collect());
        let families = FAMILIES.into_iter().filter_map(|family| {
            let own: Vec<usize> = (0..names.len()).filter(|&i| names[i] == family).collect();
            let own = total.independent(&own, rules.same_column);
            (!own.is_empty()).then_some((family, own))
        });
        let families = families.collect();
        let rows = units.iter().map(|unit| unit.rows[channel].len()).sum();
        Self { rules, which: channel, units, columns, grams, total, rows, families }
    }

    fn located(&self, residuals: &Residuals) -> Vec<Located> {
        let rules = self.rules;
        let everything: Vec<usize> = self.families.iter().flat_map(|(_, own)| own.iter().copied()).collect();
        let full = self.total.fit(&everything);
        let left = self.total.left(&full);
        // where there is no more than noise, shares are of all of it
        let noise = self.rows as f64;
        let beyond = self.total.yy - noise;
        let beyond = if beyond > rules.visible * (2.0 * noise).sqrt() { beyond } else { self.total.yy };
        let mut all: Vec<Located> = self
            .families
            .iter()
            .map(|(family, own)| {
                let others: Vec<usize> = everything.iter().copied().filter(|i| !own.contains(i)).collect();
                let without = self.total.fit(&others);
                let cost = (self.total.left(&without) - left).max(0.0);
                let gains: Vec<f64> =
                    self.grams.iter().map(|gram| gram.left(&without) - gram.left(&full)).collect();
                Located {
                    channel: crate::channels::LOADS[self.which].into(),
                    regressor: (*family).into(),
                    share_of_residual: cost / beyond.max(cost).max(f64::MIN_POSITIVE),
                    p_value: self.p_value(own, &others, &without),
                    place: self.place(&gains, residuals),
                }
            })
            .collect();
        all.extend(self.run_id(&full, beyond));
        all
    }

    /// Hotelling's F of the units' scores.
    fn p_value(&self, own: &[usize], others: &[usize], without: &[f64]) -> f64 {
        let on_others: Vec<Vec<f64>> = own.iter().map(|&i| self.total.regress(i, others)).collect();
        let scores = |gram: &Gram| -> (Vec<f64>, f64) {
            // products of the residual left with each column
            let n = gram.xy.len();
            let with: Vec<f64> = (0..n)
                .map(|i| gram.xy[i] - others.iter().map(|&j| gram.xx[i][j] * without[j]).sum::<f64>())
                .collect();
            let residual = gram.left(without);
            let of = |(&i, c): (&usize, &Vec<f64>)| {
                let score = with[i] - others.iter().map(|&j| c[j] * with[j]).sum::<f64>();
                let power = gram.column_left(i, c) * residual;
                // a column that does not move here
                let moves = gram.xx[i][i] > self.rules.moves * self.rules.moves * self.total.xx[i][i];
                if moves && power > 0.0 { score / power.sqrt() } else { 0.0 }
            };
            let size = own.iter().map(|&i| gram.xx[i][i] / self.total.xx[i][i]).sum();
            (own.iter().zip(&on_others).map(of).collect(), size)
        };
        let all: Vec<(Vec<f64>, f64)> = self.grams.iter().map(scores).collect();
        let largest = all.iter().fold(0.0, |largest: f64, (_, size)| largest.max(*size));
        let moved: Vec<Vec<f64>> = all
            .into_iter()
            .filter(|(_, size)| *size > self.rules.moves * largest)
            .map(|(scores, _)| scores)
            .collect();
        // ones regressed on scores: what is explained is T²/(T² + units - 1)
        let turned: Vec<Vec<f64>> = (0..own.len()).map(|k| moved.iter().map(|s| s[k]).collect()).collect();
        let ones = Gram::new(&turned, &vec![1.0; moved.len()]);
        let used = ones.independent(&(0..own.len()).collect::<Vec<_>>(), self.rules.same_column);
        let (units, above) = (moved.len() as f64, used.len() as f64);
        if units - above < 1.0 || used.is_empty() {
            return 1.0;
        }
        let left = ones.left(&ones.fit(&used));
        FTest::new(units - left, above, left.max(f64::MIN_POSITIVE), units - above).p_value
    }

    /// What differs from run to run beyond all families: the means that are left.
    fn run_id(&self, full: &[f64], beyond: f64) -> Option<Located> {
        let mut squares = (0.0, 0.0);
        let mut worst = (0.0, String::new());
        let all = self.units.iter().zip(&self.columns);
        for (unit, columns) in all.filter(|(unit, _)| !unit.stimulus.steady) {
            let weight = unit.weight[self.which][0];
            let fitted: f64 = columns.iter().zip(full).map(|(column, b)| b * column.rows[0] * weight).sum();
            let left = (unit.rows[self.which][0] - fitted).powi(2);
            squares = (squares.0 + left, squares.1 + 1.0);
            if left > worst.0 {
                worst = (left, unit.name.clone());
            }
        }
        let (sum, runs) = squares;
        let below = self.total.left(full) - sum;
        (runs > 1.0 && below > 0.0).then(|| Located {
            channel: crate::channels::LOADS[self.which].into(),
            regressor: "run_id".into(),
            share_of_residual: sum / beyond.max(sum).max(f64::MIN_POSITIVE),
            // as many degrees of freedom below as runs: samples of a run are no independent judges of it
            p_value: FTest::new(sum, runs, below * runs / (self.rows as f64 - runs).max(1.0), runs).p_value,
            place: format!("most in {}", worst.1),
        })
    }

    /// The kinds of maneuvers that gain most from a family.
    fn place(&self, gains: &[f64], residuals: &Residuals) -> String {
        let mut kinds: Vec<(String, f64)> = Vec::new();
        for (unit, gain) in self.units.iter().zip(gains) {
            let label = unit.maneuver.label(&residuals.controls);
            match kinds.iter_mut().find(|(known, _)| *known == label) {
                Some((_, sum)) => *sum += gain,
                None => kinds.push((label, *gain)),
            }
        }
        kinds.sort_by(|a, b| b.1.total_cmp(&a.1));
        let total: f64 = gains.iter().filter(|gain| **gain > 0.0).sum();
        let rules = self.rules;
        let named = kinds.iter().take(rules.named).filter(|(_, gain)| *gain > rules.named_share * total);
        let named: Vec<&str> = named.map(|(label, _)| label.as_str()).collect();
        if named.is_empty() {
            "in all runs alike".to_owned()
        } else {
            format!("most in {}", named.join(", "))
        }
    }
}

/// Squares that the first so many columns leave.
pub(super) fn squares_left<const N: usize>(columns: &[Vec<f64>], y: &[f64], counts: [usize; N]) -> [f64; N] {
    let gram = Gram::new(columns, y);
    counts.map(|count| gram.left(&gram.fit(&(0..count).collect::<Vec<usize>>())))
}
