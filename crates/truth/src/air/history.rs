//! What the wake remembers: circulations that left the trailing edge, as sums over time.

use super::operator::Operator;
use super::wake::{NODES, Part, Rows};
use nalgebra::{DMatrix, DVector};

/// The wake's memory in time, of changes from a state at rest.
///
/// Rows behind the nodes hold what left the edge at least as many steps ago as there are nodes: what they do in so many steps is known at
/// the first of them and is one product of matrices.
#[derive(Debug, Clone)]
pub struct Memory<'a> {
    operator: &'a Operator,
    /// Rows behind the nodes; none without a stream.
    rows: Vec<Part>,
    /// Circulations by step, in a circle.
    shed: DMatrix<f64>,
    /// Their sums by the trapezoidal rule.
    sums: DMatrix<f64>,
    step: usize,
    /// Wake's part of the rows of [`Operator`] now and one and two steps before.
    parts: [DVector<f64>; 3],
    /// Strengths of the nodes, node after node.
    nodes: DVector<f64>,
    /// Strengths of the rows in the next steps, row after row, and what they do.
    ahead: [DMatrix<f64>; 2],
}

impl<'a> Memory<'a> {
    /// A wake in which nothing has changed.
    pub fn new(operator: &'a Operator, rows: &'a Rows) -> Self {
        let (count, depth) = (operator.strips, rows.depth() + 2);
        let none = DVector::zeros(3 * count);
        let stream = !operator.by_wake.is_empty();
        let rows = if stream { rows.parts().split_off(NODES) } else { Vec::new() };
        Self {
            operator,
            shed: DMatrix::zeros(count, depth),
            sums: DMatrix::zeros(count, depth),
            step: 0,
            parts: [none.clone(), none.clone(), none],
            nodes: DVector::zeros(if stream { NODES * count } else { 0 }),
            ahead: [rows.len() * count, 3 * count].map(|height| DMatrix::zeros(height, NODES)),
            rows,
        }
    }

    fn column(&self, steps_ago: usize) -> usize {
        let depth = self.shed.ncols();
        (self.step + depth - steps_ago) % depth
    }

    /// What the rows behind the nodes do in this step and the ones that follow.
    fn look_ahead(&mut self) {
        let (count, step, depth) = (self.operator.strips, self.step, self.shed.ncols());
        for ahead in 0..NODES {
            let column = |steps_ago: usize| (step + ahead + depth - steps_ago) % depth;
            for (place, part) in self.rows.iter().enumerate() {
                let mut strengths = self.ahead[0].view_mut((place * count, ahead), (count, 1));
                match *part {
                    Part::Node(from) | Part::Endless(from) => {
                        strengths.copy_from(&self.shed.column(column(from)));
                    }
                    Part::Mean(from, to) => {
                        let over = 1.0 / (to - from) as f64;
                        strengths.zip_zip_apply(
                            &self.sums.column(column(from)),
                            &self.sums.column(column(to)),
                            |strength, first, last| *strength = over * (first - last),
                        );
                    }
                }
            }
        }
        let [strengths, done] = &mut self.ahead;
        let by_rows = self.operator.by_wake.columns_range(NODES * count..);
        done.gemm(1.0, &by_rows, strengths, 0.0);
    }

    /// Begins a step: what the wake adds to the rows of [`Operator`], and its rate (second-order backward differences).
    pub fn begin(&mut self, time_step_s: f64) -> (&DVector<f64>, DVector<f64>) {
        self.step += 1;
        self.parts.rotate_right(1);
        if !self.rows.is_empty() {
            let (count, ahead) = (self.operator.strips, (self.step - 1) % NODES);
            if ahead == 0 {
                self.look_ahead();
            }
            for node in 0..NODES {
                let strengths = self.shed.column(self.column(node + 1));
                self.nodes.rows_mut(node * count, count).copy_from(&strengths);
            }
            self.parts[0].copy_from(&self.ahead[1].column(ahead));
            add_product(&self.operator.by_wake, &self.nodes, &mut self.parts[0]);
        }
        let [now, before, earlier] = &self.parts;
        let rate = (3.0 * now - 4.0 * before + earlier) / (2.0 * time_step_s);
        (&self.parts[0], rate)
    }

    /// Ends a step with the circulations that were found.
    pub fn end(&mut self, circulations: &[f64]) {
        let (now, before) = (self.column(0), self.column(1));
        for (s, strength) in circulations.iter().enumerate() {
            self.sums[(s, now)] = self.sums[(s, before)] + 0.5 * (self.shed[(s, before)] + strength);
            self.shed[(s, now)] = *strength;
        }
    }
}

/// `into += matrix vector` with as many columns as the vector has rows, four at a time, by the vector instructions of the machine.
fn add_product(matrix: &DMatrix<f64>, vector: &DVector<f64>, into: &mut DVector<f64>) {
    let (rows, sums) = (matrix.nrows(), into.as_mut_slice());
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
