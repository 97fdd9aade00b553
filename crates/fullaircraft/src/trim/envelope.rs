//! The V-n envelope: stall lines of the wing's section, the two limit points, and warnings about trimmed flight that leaves
//! what the model is good for.
//!
//! Stall line: `n = cl_limit rho V^2 S/(2 m g)`, every strip at the section's limit at once. That is an upper bound of
//! what a wing can do (the most loaded strip stalls first), so the envelope is never too narrow. Limits are the largest
//! and smallest lift coefficient of the polars at hand, linear in airspeed and constant beyond the ends.

use crate::aircraft::assembly::{Aircraft, WingPlaces};
use crate::aircraft::lift_limits::{LiftLimits, limits_at};
use crate::trim::model::Trimmed;
use coupling::GRAVITY_M_S2;
use std::fmt::Write as _;

/// Tip deflections beyond this share of the semispan are warned about: linear structure, undeformed air.
const LARGE_DEFLECTION: f64 = 0.15;
/// Airspeeds of the envelope's lines.
const STEPS: usize = 84;

/// The envelope: columns of the same length.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Envelope {
    /// Airspeed, m/s.
    pub v_m_s: Vec<f64>,
    /// Load factor of the lower and the upper stall line.
    pub stall: [Vec<f64>; 2],
    /// The same, cut off at the load factors of push-down and pull-up.
    pub limit: [Vec<f64>; 2],
}

impl Aircraft {
    /// Area of both wings, m2.
    pub fn wing_area_m2(&self) -> f64 {
        let boxes = self.right.boxes.iter().chain(&self.left.boxes);
        boxes.map(|&at| self.flow.integration.area(at)).sum()
    }

    /// The V-n envelope up to the faster of push-down and pull-up.
    pub fn envelope(&self, limits: &[LiftLimits]) -> Envelope {
        let file = &self.file;
        let last_m_s = file.pull_up.v_m_s.max(file.push_down.v_m_s);
        let weight_n = self.mass.mass_kg * GRAVITY_M_S2;
        let corners = [file.push_down.load_factor, file.pull_up.load_factor];
        let mut envelope = Envelope::default();
        for step in 0..=STEPS {
            let v_m_s = last_m_s * step as f64 / STEPS as f64;
            let lift_n = 0.5 * file.rho_kg_m3 * v_m_s * v_m_s * self.wing_area_m2();
            let cl = limits_at(limits, v_m_s);
            envelope.v_m_s.push(v_m_s);
            for (side, cl) in cl.into_iter().enumerate() {
                let stall = cl * lift_n / weight_n;
                let cut = if side == 0 { stall.max(corners[0]) } else { stall.min(corners[1]) };
                envelope.stall[side].push(stall);
                envelope.limit[side].push(cut);
            }
        }
        envelope
    }

    /// Lift coefficients of a wing's strips from root to tip: corrected loads over dynamic pressure and strip area.
    pub fn strip_lift(&self, wing: &WingPlaces, trimmed: &Trimmed) -> Vec<f64> {
        let q_pa = 0.5 * self.file.rho_kg_m3 * trimmed.point.v_m_s * trimmed.point.v_m_s;
        let mut strips: Vec<(f64, f64, f64)> = Vec::new();
        for &at in &wing.boxes {
            let y_m = self.flow.lattice.boxes[at].mid_point().y;
            let (lift_n, area_m2) = (trimmed.box_loads[2 * at], self.flow.integration.area(at));
            match strips.last_mut().filter(|strip| (strip.0 - y_m).abs() < 1e-9) {
                Some(strip) => (strip.1, strip.2) = (strip.1 + lift_n, strip.2 + area_m2),
                None => strips.push((y_m, lift_n, area_m2)),
            }
        }
        strips.into_iter().map(|(_, lift_n, area_m2)| lift_n / (q_pa * area_m2)).collect()
    }

    /// Sentences if a tip moves beyond 15 % of the semispan, or a strip's lift coefficient leaves the polars.
    pub fn validity(&self, name: &str, trimmed: &Trimmed, limits: Option<&[LiftLimits]>) -> Vec<String> {
        let mut warnings = Vec::new();
        let semispan_m = self.free.points()[self.right.tip].y.abs();
        let tip_m = trimmed.tip_deflection_m[0];
        if tip_m.abs() > LARGE_DEFLECTION * semispan_m {
            let percent = 100.0 * tip_m / semispan_m;
            warnings.push(format!(
                "{name}: the tip moves by {percent:.0} % of the semispan; beyond 15 % linear theory is an estimate"
            ));
        }
        let Some(limits) = limits else { return warnings };
        let [least, most] = limits_at(limits, trimmed.point.v_m_s);
        let strips = self.strip_lift(&self.right, trimmed);
        let outside = strips.iter().filter(|cl| !(least..=most).contains(cl)).count();
        if outside > 0 {
            let furthest = strips.iter().copied().max_by(|a, b| {
                let off = |cl: f64| (cl - most).max(least - cl);
                off(*a).total_cmp(&off(*b))
            });
            warnings.push(format!(
                "{name}: {outside} of {} strips leave the section's polar (lift coefficient {least:.2} to {most:.2}), \
                 the furthest with {:.2}: linear lift is not known to hold there",
                strips.len(),
                furthest.unwrap_or(f64::NAN)
            ));
        }
        warnings
    }
}

impl Envelope {
    /// The envelope as CSV.
    pub fn csv(&self) -> String {
        let mut text = String::from("V_m_s,n_stall_lower,n_stall_upper,n_lower,n_upper\n");
        for (row, v_m_s) in self.v_m_s.iter().enumerate() {
            let ([low, high], [cut_low, cut_high]) = (&self.stall, &self.limit);
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{v_m_s:.4},{:.6},{:.6},{:.6},{:.6}",
                low[row], high[row], cut_low[row], cut_high[row]
            );
        }
        text
    }
}
