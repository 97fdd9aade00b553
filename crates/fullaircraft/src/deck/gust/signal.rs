//! The functions of dynamic loads: over time, and their Fourier transforms over frequency.
//!
//! ```text
//! F(omega) = int f(t) exp(-i omega t) dt
//! ```
//! In closed form for straight lines between a table's points (TLOAD1, nothing before the first and after the last) and for waves
//! without a power of time (TLOAD2), else by Gauss and Legendre's rule. RLOAD gives F itself.

use faer::c64;
use nastran::{BulkData, DynamicLoad, InputError, LoadFunction, LoadSum, Span, TableOr};
use std::f64::consts::TAU;

/// Points and weights of Gauss and Legendre's rule of four points between -1 and 1 (Abramowitz and Stegun, table 25.4).
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
    (-0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_3, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_9),
];

/// Panels of the rule at most.
const MOST_PANELS: u32 = 1 << 20;

/// A sum of dynamic loads with their factors.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Signal {
    /// Factor and load.
    pub(crate) parts: Vec<(f64, DynamicLoad)>,
}

impl Signal {
    /// The signal of a set: a DLOAD, or a TLOAD or RLOAD itself.
    ///
    /// # Errors
    /// If it or a part is not there, or a part asks for what is not read.
    pub(crate) fn of(bulk: &BulkData, set: u32) -> Result<Self, InputError> {
        let alone =
            LoadSum { set, scale: 1.0, parts: vec![(1.0, set)], span: Span::generated("the case control") };
        let sum = bulk.dynamic_sums.get(&set).unwrap_or(&alone);
        let mut parts = Vec::new();
        for (factor, id) in &sum.parts {
            let missing = || {
                let message = format!("there is no TLOAD or RLOAD {id}");
                if sum.set == *id { InputError::general(message) } else { InputError::at(&sum.span, message) }
            };
            let load = bulk.dynamic_loads.get(id).ok_or_else(missing)?;
            check(bulk, load)?;
            parts.push((sum.scale * factor, load.clone()));
        }
        Ok(Self { parts })
    }

    /// Whether all of it is given in time, none, or some.
    pub(crate) fn is_in_time(&self) -> Option<bool> {
        let first = self.parts.first().map(|part| part.1.is_in_time());
        first.filter(|first| self.parts.iter().all(|part| part.1.is_in_time() == *first))
    }

    /// The Fourier transform at omega, rad/s; of loads over frequency their amplitude.
    pub(crate) fn transform(&self, bulk: &BulkData, omega: f64) -> c64 {
        self.parts.iter().map(|(factor, load)| transform(bulk, load, omega) * *factor).sum()
    }

    /// The value at a time, s; of loads over frequency nothing.
    pub(crate) fn at(&self, bulk: &BulkData, t: f64) -> f64 {
        self.parts.iter().map(|(factor, load)| factor * value(bulk, load, t - load.delay)).sum()
    }
}

/// Refuses what is not read of a load, and tables that are not there.
fn check(bulk: &BulkData, load: &DynamicLoad) -> Result<(), InputError> {
    let blame = |message: String, help: &str| Err(InputError::at(&load.span, message).with_help(help));
    if load.kind != "LOAD" {
        return blame(
            format!("load {} enforces a motion (TYPE {}), which is not read", load.id, load.kind),
            "give a force: TYPE LOAD, or an empty field",
        );
    }
    if load.delay_set != 0 || load.phase_set != 0 {
        return blame(
            format!("load {} names a DELAY or DPHASE card, which are not read", load.id),
            "give the delay or phase itself, as a real number",
        );
    }
    let given: Vec<TableOr> = match &load.function {
        LoadFunction::Table(table) => vec![*table],
        LoadFunction::Wave { .. } => Vec::new(),
        LoadFunction::Parts { real, imaginary } => vec![*real, *imaginary],
        LoadFunction::Polar { amplitude, phase_deg } => vec![*amplitude, *phase_deg],
    };
    for table in given {
        match table {
            TableOr::Table(id) if !bulk.function_tables.contains_key(&id) => {
                return blame(
                    format!("table {id} of load {} is not there, or of a kind that is not read", load.id),
                    "give a TABLED1, TABLED2 or TABLED3",
                );
            }
            TableOr::Table(id) if load.is_in_time() && bulk.function_tables[&id].is_log != [false; 2] => {
                return blame(
                    format!("table {id} of load {} has a LOG axis, which is not read over time", load.id),
                    "give its points on LINEAR axes",
                );
            }
            TableOr::Constant(_) if load.is_in_time() => {
                return blame(
                    format!("TLOAD1 {} has no table: what never ends has no transform", load.id),
                    "name a TABLED1 with the function",
                );
            }
            _ => {}
        }
    }
    Ok(())
}

fn of_table(bulk: &BulkData, table: TableOr, x: f64) -> f64 {
    match table {
        TableOr::Constant(value) => value,
        TableOr::Table(id) => bulk.function_tables.get(&id).map_or(0.0, |table| table.at(x)),
    }
}

/// A table's points in time, or nothing.
fn points(bulk: &BulkData, table: TableOr) -> Vec<(f64, f64)> {
    let TableOr::Table(id) = table else { return Vec::new() };
    let Some(table) = bulk.function_tables.get(&id) else { return Vec::new() };
    table.points.iter().map(|(x, y)| (table.shift + table.scale * x, *y)).collect()
}

/// A load's value, its delay taken off the time.
fn value(bulk: &BulkData, load: &DynamicLoad, t: f64) -> f64 {
    match &load.function {
        LoadFunction::Table(table) => {
            let points = points(bulk, *table);
            let (first, last) = (points.first().map_or(0.0, |p| p.0), points.last().map_or(0.0, |p| p.0));
            if t >= first.min(last) && t <= first.max(last) { of_table(bulk, *table, t) } else { 0.0 }
        }
        LoadFunction::Wave { times, hz, phase_deg, growth, power } => {
            let since = t - times[0];
            if since < 0.0 || t > times[1] {
                return 0.0;
            }
            since.powf(*power) * (growth * since).exp() * (TAU * hz * since + phase_deg.to_radians()).cos()
        }
        _ => 0.0,
    }
}

fn transform(bulk: &BulkData, load: &DynamicLoad, omega: f64) -> c64 {
    let hz = omega / TAU;
    let later = unit(-omega * load.delay + load.phase_deg.to_radians());
    let own = match &load.function {
        LoadFunction::Table(table) => of_lines(&points(bulk, *table), omega),
        LoadFunction::Wave { times, hz, phase_deg, growth, power } => {
            let length = times[1] - times[0];
            let begun = unit(-omega * times[0]);
            let (turn, phase) = (TAU * hz, phase_deg.to_radians());
            if *power == 0.0 {
                let half = |sign: f64| {
                    grown(c64::new(*growth, sign * turn - omega), length) * unit(sign * phase) * 0.5
                };
                begun * (half(1.0) + half(-1.0))
            } else {
                let f = |t: f64| t.powf(*power) * (growth * t).exp() * (turn * t + phase).cos();
                begun * by_rule(&f, length, omega.abs() + turn.abs() + growth.abs(), omega)
            }
        }
        LoadFunction::Parts { real, imaginary } => {
            c64::new(of_table(bulk, *real, hz), of_table(bulk, *imaginary, hz))
        }
        LoadFunction::Polar { amplitude, phase_deg } => {
            unit(of_table(bulk, *phase_deg, hz).to_radians()) * of_table(bulk, *amplitude, hz)
        }
    };
    own * later
}

fn unit(angle: f64) -> c64 {
    c64::new(angle.cos(), angle.sin())
}

/// int exp(s t) dt from 0 to `length`: (exp(s length) - 1)/s, by its series where that loses digits.
fn grown(s: c64, length: f64) -> c64 {
    let z = s * length;
    if z.norm() < 1e-3 {
        return (c64::from(1.0) + z * 0.5 + z * z / 6.0 + z * z * z / 24.0) * length;
    }
    (unit(z.im) * z.re.exp() - 1.0) / s
}

/// The transform of straight lines between points.
fn of_lines(points: &[(f64, f64)], omega: f64) -> c64 {
    let mut total = c64::from(0.0);
    for pair in points.windows(2) {
        let ((t1, y1), (t2, y2)) = (pair[0], pair[1]);
        let (length, turn) = (t2 - t1, omega * (t2 - t1));
        // int exp(-i turn s) ds and int s exp(-i turn s) ds from 0 to 1
        let [even, ramp] = if turn.abs() < 1e-3 {
            let i = c64::new(0.0, turn);
            [c64::from(1.0) - i * 0.5 + i * i / 6.0, c64::from(0.5) - i / 3.0 + i * i / 8.0]
        } else {
            let (end, i) = (unit(-turn), c64::new(0.0, turn));
            let even = (c64::from(1.0) - end) / i;
            [even, (even - end) / i]
        };
        total += unit(-omega * t1) * (even * y1 + ramp * (y2 - y1)) * length;
    }
    total
}

/// The transform of a function from 0 to `length` whose fastest rate is given, 1/s.
fn by_rule(f: &dyn Fn(f64) -> f64, length: f64, rate: f64, omega: f64) -> c64 {
    // A quarter of a radian a panel; a root at the start (powers between 0 and 1) wants more than a few.
    let mut panels = 64_u32;
    while f64::from(panels) < 4.0 * rate * length && panels < MOST_PANELS {
        panels *= 2;
    }
    let half = 0.5 * length / f64::from(panels);
    let panel = |at: u32| {
        let middle = half * f64::from(2 * at + 1);
        GAUSS
            .iter()
            .map(|(place, weight)| {
                let t = middle + half * place;
                unit(-omega * t) * (f(t) * weight * half)
            })
            .sum::<c64>()
    };
    (0..panels).map(panel).sum()
}

#[cfg(test)]
mod tests;
