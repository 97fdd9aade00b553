//! `response --at POINTS.csv`: the surfaces at points of the user's, with intervals that know how far these are from the
//! data.

use std::path::Path;

use nastran::{InputError, Table};
use response::{Fault, TableAnalysis, TableStudy};

use super::response_files::csv;
use super::response_result::{At, PredictionsResult};
use super::response_text::{interval, number};

/// The points of a file.
pub(super) struct Points {
    table: Table,
}

/// What is said of all points by the surface of one response.
pub(super) struct Predictions {
    /// Name of the response.
    pub(super) name: String,
    factors: Vec<String>,
    level: f64,
    points: Vec<At>,
}

impl Points {
    /// Reads the file.
    ///
    /// # Errors
    /// If it cannot be read or has no row.
    pub(super) fn read(path: &Path) -> Result<Self, InputError> {
        let table = Table::read(path)?;
        if table.is_empty() {
            return Err(InputError::in_file(path, "there is no point"));
        }
        Ok(Self { table })
    }

    /// Complains if a factor of the table is no column.
    ///
    /// # Errors
    /// At the header.
    pub(super) fn require(&self, study: &TableStudy) -> Result<(), InputError> {
        let factors: Vec<&str> = study.factors.iter().map(String::as_str).collect();
        self.table.require(&factors)
    }

    /// Of each response of a table its predictions.
    ///
    /// # Errors
    /// At the cell that is no number, or where a term has no finite value.
    pub(super) fn predictions(
        &self,
        study: &TableStudy,
        analysis: &TableAnalysis,
    ) -> Result<Vec<Predictions>, InputError> {
        let mut all = Vec::new();
        for of_response in &analysis.responses {
            let fitted = &of_response.choice.fitted;
            let mut points = Vec::new();
            for row in 0..self.table.len() {
                let numbers = study.factors.iter().map(|name| self.table.number(row, name));
                let factors: Vec<f64> = numbers.collect::<Result<_, _>>()?;
                let names = study.factors.iter().map(String::as_str);
                let state: Vec<(&str, f64)> = names.zip(factors.iter().copied()).collect();
                let prediction = fitted.predict(&state).map_err(|fault| match fault {
                    Fault::NotFinite { name, value, .. } => {
                        Fault::NotFinite { name, value, point: row + 1 }.in_table(&self.table)
                    }
                    other => other.in_table(&self.table),
                })?;
                let mean_interval = prediction.mean_interval(study.level)?;
                let reading_interval = prediction.reading_interval(study.level)?;
                points.push(At { factors, prediction, mean_interval, reading_interval });
            }
            let (name, factors) = (fitted.response.clone(), study.factors.clone());
            all.push(Predictions { name, factors, level: study.level, points });
        }
        Ok(all)
    }
}

impl Predictions {
    /// For the terminal.
    pub(super) fn text(&self) -> String {
        let percent = 100.0 * self.level;
        let mean = format!("surface, {percent} %");
        let reading = format!("next reading, {percent} %");
        let mut head: Vec<&str> = self.factors.iter().map(String::as_str).collect();
        head.extend([self.name.as_str(), mean.as_str(), reading.as_str(), "leverage", "place"]);
        let mut table = report::Table::new(&head);
        for at in &self.points {
            let p = &at.prediction;
            let place = if p.extrapolated { "beyond the data" } else { "within" };
            let of_surface = [number(p.value), interval(at.mean_interval), interval(at.reading_interval)];
            let factors = at.factors.iter().map(ToString::to_string);
            table.row(factors.chain(of_surface).chain([number(p.leverage), place.into()]));
        }
        table.to_string()
    }

    /// As CSV.
    pub(super) fn csv(&self) -> String {
        let rows = self.points.iter().map(|at| {
            let factors: Vec<String> = at.factors.iter().map(ToString::to_string).collect();
            let (p, (low, high)) = (&at.prediction, at.mean_interval);
            let ((least, most), beyond) = (at.reading_interval, u8::from(p.extrapolated));
            format!(
                "{},{:e},{:e},{low:e},{high:e},{least:e},{most:e},{:e},{beyond}",
                factors.join(","),
                p.value,
                p.standard_error,
                p.leverage
            )
        });
        let head = "standard_error,mean_low,mean_high,reading_low,reading_high,leverage,beyond_data";
        csv(&format!("{},{},{head}", self.factors.join(","), self.name), rows)
    }

    /// In result.json.
    pub(super) fn result(&self, data: &str) -> PredictionsResult {
        let (name, factors) = (self.name.clone(), self.factors.clone());
        PredictionsResult { name, data: data.to_owned(), factors, points: self.points.clone() }
    }
}
