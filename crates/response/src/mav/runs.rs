//! Runs as a table: block, airspeed, factors and responses, in the units of the paper, and its CSV text.

use super::factor::Factor;
use super::points::{Series, TestPoint};

/// A table of runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Runs {
    /// Which series.
    pub series: Series,
    /// Names of the responses.
    pub responses: Vec<String>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// One measured point.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Number of the block, from 0.
    pub block: usize,
    /// Where.
    pub point: TestPoint,
    /// The responses, in their order.
    pub values: Vec<f64>,
}

impl Runs {
    /// No rows yet.
    pub(super) fn new(series: Series, responses: Vec<String>) -> Self {
        Self { series, responses, rows: Vec::new() }
    }

    pub(super) fn push(&mut self, block: usize, point: &TestPoint, values: Vec<f64>) {
        self.rows.push(Row { block, point: *point, values });
    }

    /// Factors that vary, with the names of their columns.
    pub fn factors(&self) -> Vec<(Factor, &'static str)> {
        let varies = |factor: Factor| {
            let mut values = self.rows.iter().map(|row| row.point.condition.get(factor));
            let first = values.next().flatten();
            first.is_some() && values.any(|value| value != first)
        };
        let varying = Factor::ALL.into_iter().filter(|factor| varies(*factor));
        varying.map(|factor| (factor, factor.column())).collect()
    }

    /// The values of a factor.
    pub fn factor(&self, factor: Factor) -> Vec<f64> {
        self.rows.iter().filter_map(|row| row.point.condition.get(factor)).collect()
    }

    /// The values of a response; `None` if there is none of this name.
    pub fn response(&self, name: &str) -> Option<Vec<f64>> {
        let index = self.responses.iter().position(|response| response == name)?;
        Some(self.rows.iter().map(|row| row.values[index]).collect())
    }

    /// The name of each row's block: `run_1`, `run_2`, ...
    pub fn blocks(&self) -> Vec<String> {
        self.rows.iter().map(|row| format!("run_{}", row.block + 1)).collect()
    }

    /// As a CSV file: `block,V_m_s`, the factors that vary, the responses with five decimals.
    pub fn csv(&self) -> String {
        let factors = self.factors();
        let columns = factors.iter().map(|(_, column)| *column);
        let head: Vec<&str> = columns.chain(self.responses.iter().map(String::as_str)).collect();
        let mut text = format!("block,V_m_s,{}\n", head.join(","));
        for (row, block) in self.rows.iter().zip(self.blocks()) {
            let of = |factor| row.point.condition.get(factor).unwrap_or(f64::NAN).to_string();
            let cells = factors.iter().map(|(factor, _)| of(*factor));
            let cells = cells.chain(row.values.iter().map(|value| format!("{value:.5}")));
            let cells: Vec<String> = [block, row.point.v_m_s.to_string()].into_iter().chain(cells).collect();
            text += &(cells.join(",") + "\n");
        }
        text
    }
}
