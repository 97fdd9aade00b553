//! What the wake remembers: circulations that left the trailing edge, as sums over time.

use super::operator::Operator;
use super::wake::{Part, Rows};
use nalgebra::{DMatrix, DVector};

/// The wake's memory in time, of changes from a state at rest.
#[derive(Debug, Clone)]
pub struct Memory<'a> {
    operator: &'a Operator,
    remembered: Vec<Part>,
    /// Circulations by step, in a circle.
    shed: DMatrix<f64>,
    /// Their sums by the trapezoidal rule.
    sums: DMatrix<f64>,
    step: usize,
    /// Wake's part of the rows of [`Operator`] now and one and two steps before.
    parts: [DVector<f64>; 3],
    strengths: DVector<f64>,
}

impl<'a> Memory<'a> {
    /// A wake in which nothing has changed.
    pub fn new(operator: &'a Operator, rows: &'a Rows) -> Self {
        let (count, depth) = (operator.strips, rows.depth() + 2);
        let none = DVector::zeros(3 * count);
        Self {
            operator,
            remembered: rows.parts(),
            shed: DMatrix::zeros(count, depth),
            sums: DMatrix::zeros(count, depth),
            step: 0,
            parts: [none.clone(), none.clone(), none],
            strengths: DVector::zeros(operator.by_wake.ncols()),
        }
    }

    fn place(&self, steps_ago: usize) -> usize {
        let depth = self.shed.ncols();
        (self.step + depth - steps_ago) % depth
    }

    /// Begins a step: what the wake adds to the rows of [`Operator`], and its rate (second-order backward differences).
    pub fn begin(&mut self, time_step_s: f64) -> (&DVector<f64>, DVector<f64>) {
        self.step += 1;
        let (count, depth) = (self.operator.strips, self.shed.ncols());
        let remembered = if self.strengths.is_empty() { &[][..] } else { &self.remembered };
        for (place, part) in remembered.iter().enumerate() {
            let strengths = &mut self.strengths.as_mut_slice()[place * count..(place + 1) * count];
            let column = |steps_ago: usize| (self.step + depth - steps_ago) % depth;
            match part {
                Part::Node(ago) | Part::Endless(ago) => {
                    strengths.copy_from_slice(self.shed.column(column(*ago)).as_slice());
                }
                Part::Mean(from, to) => {
                    let (first, last) = (self.sums.column(column(*from)), self.sums.column(column(*to)));
                    let over = 1.0 / (to - from) as f64;
                    for s in 0..count {
                        strengths[s] = over * (first[s] - last[s]);
                    }
                }
            }
        }
        self.parts.rotate_right(1);
        if !remembered.is_empty() {
            product(&self.operator.by_wake, &self.strengths, &mut self.parts[0]);
        }
        let [now, before, earlier] = &self.parts;
        let rate = (3.0 * now - 4.0 * before + earlier) / (2.0 * time_step_s);
        (&self.parts[0], rate)
    }

    /// Ends a step with the circulations that were found.
    pub fn end(&mut self, circulations: &[f64]) {
        let (now, before) = (self.place(0), self.place(1));
        for (s, strength) in circulations.iter().enumerate() {
            self.sums[(s, now)] = self.sums[(s, before)] + 0.5 * (self.shed[(s, before)] + strength);
            self.shed[(s, now)] = *strength;
        }
    }
}

/// `into = matrix vector`, four columns at a time, by the vector instructions of the machine: without them two thirds of a run's time went into it.
fn product(matrix: &DMatrix<f64>, vector: &DVector<f64>, into: &mut DVector<f64>) {
    let rows = matrix.nrows();
    let sums = into.as_mut_slice();
    sums.fill(0.0);
    pulp::Arch::new().dispatch(|| {
        for (columns, x) in matrix.as_slice().chunks(4 * rows).zip(vector.as_slice().chunks(4)) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| x.get(k).copied().unwrap_or(0.0));
            // where fewer than four columns are left, the first stands for those that are missing, times zero
            let column = |k: usize| columns.get(k * rows..(k + 1) * rows).unwrap_or(&columns[..rows]);
            let four = column(0).iter().zip(column(1)).zip(column(2).iter().zip(column(3)));
            for (sum, ((p, q), (r, s))) in sums.iter_mut().zip(four) {
                *sum += (a * p + b * q) + (c * r + d * s);
            }
        }
    });
}
