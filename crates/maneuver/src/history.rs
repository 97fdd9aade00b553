//! Time histories: named channels over a uniform time, with their units in the names.

use std::fmt::Write as _;

/// One channel.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Name with unit, as in a run's file: `Fz_N`, `alpha_deg`, `delta_inner_deg`.
    pub name: String,
    /// One value a sample.
    pub values: Vec<f64>,
}

/// Channels over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TimeHistory {
    /// Time of every sample, s.
    pub t_s: Vec<f64>,
    /// Channels, all as long as the time.
    pub channels: Vec<Channel>,
}

impl TimeHistory {
    /// The values of a channel.
    pub fn get(&self, name: &str) -> Option<&[f64]> {
        self.channels.iter().find(|channel| channel.name == name).map(|channel| channel.values.as_slice())
    }

    /// Adds a channel.
    pub fn push(&mut self, name: impl Into<String>, values: Vec<f64>) {
        self.channels.push(Channel { name: name.into(), values });
    }

    /// As CSV: `t_s`, then the channels; nine significant digits.
    pub fn to_csv(&self) -> String {
        let mut text = String::from("t_s");
        for channel in &self.channels {
            let _ = write!(text, ",{}", channel.name);
        }
        text.push('\n');
        for (i, t_s) in self.t_s.iter().enumerate() {
            let _ = write!(text, "{}", digits(*t_s));
            for channel in &self.channels {
                let _ = write!(text, ",{}", digits(channel.values[i]));
            }
            text.push('\n');
        }
        text
    }
}

/// Nine significant digits, without needless zeros.
fn digits(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}
