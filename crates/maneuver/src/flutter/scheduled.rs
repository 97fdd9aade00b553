//! Air forces of a wing whose corrections depend on the airspeed.

use super::{FlutterError, GafTable, GeneralisedForces, SplitForces};
use faer::{Mat, Scale, c64};

/// Tables at rising airspeeds. Between two the forces are mixed in proportion to the dynamic pressure, which is what
/// corrections mixed like that do, as they multiply forces. Outside, the nearest table is held. Each table has a range of
/// frequencies of its own, beyond which its end is held whatever the other has.
#[derive(Debug, Clone)]
pub struct ScheduledForces {
    sets: Vec<(f64, GafTable)>,
}

impl ScheduledForces {
    /// From tables of one size, each with its airspeed in m/s.
    ///
    /// # Errors
    /// If there is no table, airspeeds do not rise, or sizes differ.
    pub fn new(sets: Vec<(f64, GafTable)>) -> Result<Self, FlutterError> {
        let Some((_, first)) = sets.first() else { return Err(FlutterError::Empty("the list of tables")) };
        if let Some(pair) = sets.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
            let (what, expected) = ("the airspeed of a table", "above that of the table before");
            return Err(FlutterError::Number { what, value: pair[1].0, expected });
        }
        let expected = first.size();
        if let Some((_, table)) = sets.iter().find(|(_, table)| table.size() != expected) {
            let (rows, columns) = (table.size(), table.size());
            return Err(FlutterError::Size { what: "a table of forces", rows, columns, expected });
        }
        Ok(Self { sets })
    }

    /// The tables that are mixed at an airspeed, each with its share.
    fn mixed(&self, v_m_s: f64) -> Vec<(f64, &GafTable)> {
        let above = self.sets.partition_point(|(v, _)| *v <= v_m_s);
        if above == 0 || above == self.sets.len() {
            return vec![(1.0, &self.sets[above.min(self.sets.len() - 1)].1)];
        }
        let ((low, first), (high, second)) = (&self.sets[above - 1], &self.sets[above]);
        let share = (v_m_s * v_m_s - low * low) / (high * high - low * low);
        // at a table's own airspeed the next has no part in what lies beyond the range
        [(1.0 - share, first), (share, second)].into_iter().filter(|(share, _)| *share > 0.0).collect()
    }
}

impl GeneralisedForces for ScheduledForces {
    fn size(&self) -> usize {
        self.sets[0].1.size()
    }

    fn range(&self) -> (f64, f64) {
        let ranges = || self.sets.iter().map(|(_, table)| table.range());
        let low = ranges().map(|range| range.0).fold(f64::NEG_INFINITY, f64::max);
        (low, ranges().map(|range| range.1).fold(f64::INFINITY, f64::min))
    }

    fn at(&self, omega_over_v: f64, v_m_s: f64) -> Result<Mat<c64>, FlutterError> {
        let n = self.size();
        self.mixed(v_m_s).into_iter().try_fold(Mat::zeros(n, n), |sum, (share, table)| {
            Ok(sum + table.at(omega_over_v, v_m_s)? * Scale(c64::from(share)))
        })
    }

    fn split(&self, omega_over_v: f64, v_m_s: f64) -> Result<SplitForces, FlutterError> {
        let n = self.size();
        let none = SplitForces { real: Mat::zeros(n, n), damping: Mat::zeros(n, n), beyond: false };
        self.mixed(v_m_s).into_iter().try_fold(none, |sum, (share, table)| {
            let part = table.split(omega_over_v, v_m_s)?;
            Ok(SplitForces {
                real: sum.real + part.real * Scale(share),
                damping: sum.damping + part.damping * Scale(share),
                beyond: sum.beyond || part.beyond,
            })
        })
    }
}
