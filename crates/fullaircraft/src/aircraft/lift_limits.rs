//! The largest and smallest lift of a wing's section by airspeed, from polars.

use nastran::InputError;
use std::path::Path;

/// Largest and smallest lift coefficient of a section at one airspeed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LiftLimits {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Smallest and largest lift coefficient of the polar.
    pub cl: [f64; 2],
}

/// Reads polars: CSV whose first column is the airspeed in m/s and fourth the lift coefficient (`V_mps,Re,alpha_deg,cl`).
///
/// # Errors
/// If the file cannot be read, or a row has no such numbers.
pub fn lift_limits(path: &Path) -> Result<Vec<LiftLimits>, InputError> {
    let text = nastran::read_text(path)?;
    let mut limits: Vec<LiftLimits> = Vec::new();
    for (at, line) in text.lines().enumerate().skip(1).filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<Option<f64>> = line.split(',').map(|cell| cell.trim().parse().ok()).collect();
        let number = |column: usize| cells.get(column).copied().flatten().filter(|x: &f64| x.is_finite());
        let (Some(v_m_s), Some(cl)) = (number(0), number(3)) else {
            let message = format!("line {} is not V_mps,Re,alpha_deg,cl in numbers", at + 1);
            return Err(InputError::in_file(path, message).with_help("one polar point a line"));
        };
        match limits.iter_mut().find(|known| known.v_m_s == v_m_s) {
            Some(known) => known.cl = [known.cl[0].min(cl), known.cl[1].max(cl)],
            None => limits.push(LiftLimits { v_m_s, cl: [cl, cl] }),
        }
    }
    if limits.is_empty() {
        return Err(InputError::in_file(path, "the polars have no rows").with_help("one polar point a line"));
    }
    limits.sort_by(|a, b| a.v_m_s.total_cmp(&b.v_m_s));
    Ok(limits)
}

/// Limits at an airspeed.
pub fn limits_at(limits: &[LiftLimits], v_m_s: f64) -> [f64; 2] {
    let Some(after) = limits.iter().position(|known| known.v_m_s >= v_m_s) else {
        return limits.last().map_or([f64::NEG_INFINITY, f64::INFINITY], |last| last.cl);
    };
    if after == 0 {
        return limits[0].cl;
    }
    let (low, high) = (limits[after - 1], limits[after]);
    let share = (v_m_s - low.v_m_s) / (high.v_m_s - low.v_m_s);
    std::array::from_fn(|i| low.cl[i] + share * (high.cl[i] - low.cl[i]))
}
