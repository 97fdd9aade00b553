//! Air forces of a wing whose corrections depend on the airspeed.

use super::{FlutterError, GafTable, GeneralisedForces};
use faer::{Mat, Scale, c64};

/// Tables at rising airspeeds. Between two the forces are mixed in proportion to the dynamic pressure, which is what
/// corrections mixed like that do, as they multiply forces. Outside, the nearest table is held.
#[derive(Debug, Clone)]
pub struct ScheduledForces {
    sets: Vec<(f64, GafTable)>,
}

impl ScheduledForces {
    /// From tables of one size over one range of frequencies, each with its airspeed in m/s.
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
}

impl GeneralisedForces for ScheduledForces {
    fn size(&self) -> usize {
        self.sets[0].1.size()
    }

    fn range(&self) -> (f64, f64) {
        self.sets[0].1.range()
    }

    fn at(&self, omega_over_v: f64, v_m_s: f64) -> Result<Mat<c64>, FlutterError> {
        let above = self.sets.partition_point(|(v, _)| *v <= v_m_s);
        if above == 0 || above == self.sets.len() {
            let nearest = above.min(self.sets.len() - 1);
            return self.sets[nearest].1.at(omega_over_v, v_m_s);
        }
        let ((low, first), (high, second)) = (&self.sets[above - 1], &self.sets[above]);
        let share = (v_m_s * v_m_s - low * low) / (high * high - low * low);
        let mix = |table: &GafTable, share: f64| -> Result<Mat<c64>, FlutterError> {
            Ok(table.at(omega_over_v, v_m_s)? * Scale(c64::from(share)))
        };
        Ok(mix(first, 1.0 - share)? + mix(second, share)?)
    }
}
