//! Frequencies at which a response to turbulence is computed: Gauss's points in panels that are graded in the logarithm of the
//! frequency and refined around modes.
//!
//! Turbulence has its energy below V/(1.339 L), some hundredths of a hertz, and aircraft respond up to tens: no uniform grid serves both.

use std::f64::consts::PI;

/// Points of a panel.
const POINTS: usize = 8;
/// The first panel ends at this share of V/L.
const FIRST: f64 = 0.01;
/// Panels around a mode begin at these half-widths beside it.
const BESIDE: [f64; 6] = [0.5, 1.0, 2.0, 4.0, 8.0, 16.0];
/// Modes are taken as at least this wide, share of their frequency.
const NARROWEST: f64 = 1e-4;

/// A mode of the response, to refine the grid around.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mode {
    /// Imaginary part of its pole, rad/s.
    pub omega_rad_s: f64,
    /// Real part of its pole without its sign, rad/s.
    pub decay_rad_s: f64,
}

/// Frequencies with their weights.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    /// Frequencies in rising order, rad/s.
    pub omega_rad_s: Vec<f64>,
    /// Weights of an integral over them, rad/s.
    pub weight_rad_s: Vec<f64>,
    /// Where it ends, rad/s.
    pub cut_off_rad_s: f64,
    /// Whether a mode that was given lies beyond its end: what it adds is unknown.
    pub mode_beyond: bool,
}

impl Grid {
    /// A grid for an airspeed, m/s, and a scale of turbulence, m, up to a cut-off, Hz, with so many panels a decade (six are plenty).
    pub fn new(v_m_s: f64, scale_m: f64, cut_off_hz: f64, modes: &[Mode], panels_a_decade: f64) -> Self {
        let cut_off_rad_s = 2.0 * PI * cut_off_hz;
        let first = (FIRST * v_m_s / scale_m).min(cut_off_rad_s);
        let panels = (panels_a_decade * (cut_off_rad_s / first).log10()).ceil().max(1.0);
        let mut ends = vec![0.0, first];
        let ratio = (cut_off_rad_s / first).powf(1.0 / panels);
        let mut end = first;
        while end * ratio < cut_off_rad_s * (1.0 - 1e-9) {
            end *= ratio;
            ends.push(end);
        }
        ends.push(cut_off_rad_s);
        for mode in modes {
            let width = mode.decay_rad_s.max(NARROWEST * mode.omega_rad_s);
            ends.push(mode.omega_rad_s);
            ends.extend(
                BESIDE.iter().flat_map(|beside| [-beside, *beside]).map(|at| mode.omega_rad_s + at * width),
            );
        }
        ends.retain(|end| (0.0..=cut_off_rad_s).contains(end));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let mode_beyond = modes.iter().any(|mode| mode.omega_rad_s > cut_off_rad_s);
        let mut grid = Self { omega_rad_s: Vec::new(), weight_rad_s: Vec::new(), cut_off_rad_s, mode_beyond };
        for panel in ends.windows(2) {
            let (half, middle) = ((panel[1] - panel[0]) / 2.0, f64::midpoint(panel[0], panel[1]));
            for (place, weight) in gauss() {
                grid.omega_rad_s.push(middle + half * place);
                grid.weight_rad_s.push(half * weight);
            }
        }
        grid
    }
}

/// Gauss and Legendre's points and weights between -1 and 1, by Newton's steps on the polynomial (Abramowitz and Stegun, 25.4.29).
fn gauss() -> [(f64, f64); POINTS] {
    std::array::from_fn(|at| {
        let n = POINTS as f64;
        let mut x = -((at as f64 + 0.75) / (n + 0.5) * PI).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut before, mut value) = (1.0, x);
            for k in 2..=POINTS {
                let k = k as f64;
                (before, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k);
            }
            slope = n * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_integrates_powers_exactly_and_its_panels_leave_no_gap() {
        let mode = Mode { omega_rad_s: 3.0, decay_rad_s: 0.01 };
        let grid = Grid::new(30.0, 762.0, 2.0, &[mode], 6.0);
        let end = 2.0 * PI * 2.0;
        for power in [0, 1, 2, 7, 15] {
            let pairs = grid.omega_rad_s.iter().zip(&grid.weight_rad_s);
            let ours: f64 = pairs.map(|(omega, weight)| omega.powi(power) * weight).sum();
            let exact = end.powi(power + 1) / f64::from(power + 1);
            assert!((ours - exact).abs() < 1e-12 * exact, "power {power}: {ours} beside {exact}");
        }
        assert!(grid.omega_rad_s.is_sorted());
    }
}
