//! The gap between simulation and measurements, and problems with a simulation in place of the measurements.

use crate::problem::{Kind, Problem, Segment};
use coupling::{ByLoad, Load};
use maneuver::effects::Flown;

/// Root mean square of measured minus simulated loads over the noise, by channel and together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gap {
    /// Fz, Mx, My.
    pub by_channel: ByLoad<f64>,
    /// Over all channels.
    pub all: f64,
    /// Root mean square of the residual over that of the variation of the load, per cent, by channel.
    pub raw_percent: ByLoad<f64>,
}

impl Problem<'_> {
    /// The gap of a simulation (one entry a segment), nothing taken out.
    pub fn gap(&self, simulated: &[Flown]) -> Gap {
        self.gap_of(simulated, |_| true)
    }

    /// The same of some segments, by their places.
    pub fn gap_of(&self, simulated: &[Flown], wanted: impl Fn(usize) -> bool) -> Gap {
        let (mut squares, mut counts) = ([0.0; 3], [0_usize; 3]);
        let (mut raw, mut variation) = ([0.0; 3], [0.0; 3]);
        let all = self.segments.iter().zip(simulated).enumerate();
        for (_, (segment, flown)) in all.filter(|(place, _)| wanted(*place)) {
            let measured = &self.measured[segment.rows.clone()];
            let simulated = segment.kind.whitened(&flown.loads);
            for (i, (m, s)) in measured.iter().zip(&simulated).enumerate() {
                let (c, sigma, first) = segment.kind.row(i);
                squares[c] += (m - s).powi(2);
                counts[c] += 1;
                raw[c] += (sigma * (m - s)).powi(2);
                // the mean of a run is no variation
                variation[c] += if first { 0.0 } else { (sigma * m).powi(2) };
            }
        }
        let root = |sum: f64, count: usize| (sum / count.max(1) as f64).sqrt();
        Gap {
            by_channel: ByLoad::from_fn(|load| root(squares[load as usize], counts[load as usize])),
            all: root(squares.iter().sum(), counts.iter().sum()),
            raw_percent: ByLoad::from_fn(|load| {
                let variation = variation[load as usize].max(f64::MIN_POSITIVE);
                100.0 * (raw[load as usize] / variation).sqrt()
            }),
        }
    }

    /// Sum of squares of how measured loads vary within a run or a group of static points, in standard deviations of their noise.
    pub fn variation(&self) -> f64 {
        let of_segment = |segment: &Segment| {
            let measured = &self.measured[segment.rows.clone()];
            let (mut sums, mut squares, mut counts) = ([0.0; 3], [0.0; 3], [0.0; 3]);
            for (i, m) in measured.iter().enumerate() {
                let (c, _, first) = segment.kind.row(i);
                if !first {
                    sums[c] += m;
                    squares[c] += m * m;
                    counts[c] += 1.0;
                }
            }
            // the first coefficient of a run is its mean, which static points have in every row
            let mean = |c: usize| match segment.kind {
                Kind::Run { .. } => 0.0,
                Kind::Static { .. } => sums[c] * sums[c] / f64::max(counts[c], 1.0),
            };
            (0..3).map(|c| squares[c] - mean(c)).sum::<f64>()
        };
        self.segments.iter().map(of_segment).sum()
    }

    /// The same problem with loads of a simulation and noise in place of the measurements.
    #[must_use]
    pub fn pretending(&self, simulated: &[Flown], mut normal: impl FnMut() -> f64) -> Self {
        let mut measured = Vec::with_capacity(self.measured.len());
        for (segment, flown) in self.segments.iter().zip(simulated) {
            measured.extend(segment.kind.whitened(&flown.loads).into_iter().map(|value| value + normal()));
        }
        Self { data: self.data, segments: self.segments.clone(), measured, offset: self.offset }
    }
}

impl Kind {
    /// Channel of a row, its noise, and whether it is the mean of a record.
    fn row(&self, i: usize) -> (usize, f64, bool) {
        match self {
            Self::Run { coefficients, channels, sigma, .. } => {
                let (c, k) = (channels[i / coefficients], i % coefficients);
                (c, sigma[c][k], k == 0)
            }
            Self::Static { rows, sigma } => (rows[i].0, sigma[Load::ALL[rows[i].0]], false),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::by_hand::ByHand;

    #[test]
    fn loads_vary_about_the_mean_of_their_group() {
        let known = ByHand::new(&[&[1.0, 2.0, 3.0], &[4.0, 4.0], &[1.0, -1.0]]);
        assert!((known.problem().variation() - (2.0 + 0.0 + 2.0)).abs() < 1e-12);
    }
}
