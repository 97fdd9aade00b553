//! `response --at POINTS.csv`: the surfaces at points of the user's, with intervals that know how far these are from the
//! data.

use std::fmt::Write as _;
use std::path::Path;

use nastran::{InputError, Table};
use response::{Fault, Prediction, TableAnalysis, TableStudy};
use serde_json::{Value, json};

use super::response_text::number;

/// A point with what a surface says of it.
struct At {
    factors: Vec<f64>,
    prediction: Prediction,
    mean: (f64, f64),
    reading: (f64, f64),
}

/// The points of a file.
pub(super) struct Points {
    table: Table,
}

/// What is said of all points by the surface of one response.
pub(super) struct Predictions {
    response: String,
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
                let mean = prediction.mean_interval(study.level)?;
                let reading = prediction.reading_interval(study.level)?;
                points.push(At { factors, prediction, mean, reading });
            }
            let (response, factors) = (fitted.response.clone(), study.factors.clone());
            all.push(Predictions { response, factors, level: study.level, points });
        }
        Ok(all)
    }
}

impl Predictions {
    /// Name of the response.
    pub(super) fn response(&self) -> &str {
        &self.response
    }

    /// For the terminal.
    pub(super) fn text(&self) -> String {
        let percent = 100.0 * self.level;
        let mean = format!("surface, {percent} %");
        let reading = format!("next reading, {percent} %");
        let mut head: Vec<&str> = self.factors.iter().map(String::as_str).collect();
        head.extend([self.response.as_str(), mean.as_str(), reading.as_str(), "leverage", "place"]);
        let mut table = report::Table::new(&head);
        for at in &self.points {
            let mut row: Vec<String> = at.factors.iter().map(ToString::to_string).collect();
            row.push(number(at.prediction.value));
            row.push(format!("{} to {}", number(at.mean.0), number(at.mean.1)));
            row.push(format!("{} to {}", number(at.reading.0), number(at.reading.1)));
            row.push(number(at.prediction.leverage));
            row.push(if at.prediction.extrapolated {
                "beyond the data".into()
            } else {
                "within".to_string()
            });
            table.row(row);
        }
        table.to_string()
    }

    /// As CSV.
    pub(super) fn csv(&self) -> String {
        let mut text = format!(
            "{},{},standard_error,mean_low,mean_high,reading_low,reading_high,leverage,beyond_data\n",
            self.factors.join(","),
            self.response
        );
        for at in &self.points {
            at.factors.iter().for_each(|factor| {
                let _ = write!(text, "{factor},");
            });
            let p = &at.prediction;
            let (mean, reading, beyond) = (at.mean, at.reading, u8::from(p.extrapolated));
            let _ = writeln!(
                text,
                "{:e},{:e},{:e},{:e},{:e},{:e},{:e},{beyond}",
                p.value, p.standard_error, mean.0, mean.1, reading.0, reading.1, p.leverage
            );
        }
        text
    }

    /// In result.json.
    pub(super) fn json(&self, data: &str) -> Value {
        let of_point = |at: &At| {
            let p = &at.prediction;
            json!({
                "factors": at.factors, "value": p.value, "standard_error": p.standard_error,
                "mean_interval": at.mean, "reading_interval": at.reading, "leverage": p.leverage,
                "beyond_data": p.extrapolated,
            })
        };
        let points: Vec<Value> = self.points.iter().map(of_point).collect();
        json!({ "name": self.response, "data": data, "factors": self.factors, "points": points })
    }
}
