//! The truth beside the uncorrected model, and in flight: what a campaign is like, in the paper's terms.

use crate::truth::{Truth, TunnelError};
use aero::{Corrections, Flow};
use coupling::wing_file::Source;
use coupling::{CouplingError, ElasticWing, GRAVITY_M_S2, Mount, RootPlane, SteadyCase, WingFile};

/// Slope and offset against the angle of attack of one channel, true and modelled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChannelComparison {
    /// Load of the straight line at alpha = 0: true, modelled (N or N m).
    pub offset: [f64; 2],
    /// Slope of the straight line: true, modelled (N or N m per degree).
    pub slope_per_deg: [f64; 2],
    /// Root mean square difference over the measured angles, as a share of the root mean square true load.
    pub relative_error: f64,
}

/// The uncorrected model against the truth at one airspeed: Fz, Mx, My.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AirspeedComparison {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Fz, Mx, My.
    pub channels: [ChannelComparison; 3],
}

/// Compares noise-free loads of truth and uncorrected model.
///
/// # Errors
/// Beyond divergence, or if sections with curvature do not settle.
pub fn compare(
    truth: &Truth,
    model: &ElasticWing,
    airspeeds_m_s: &[f64],
    angles_deg: &[f64],
) -> Result<Vec<AirspeedComparison>, TunnelError> {
    let alphas: Vec<f64> = angles_deg.iter().map(|angle| angle.to_radians()).collect();
    let neutral = Corrections::neutral(model.correctable.len());
    let mut all = Vec::with_capacity(airspeeds_m_s.len());
    for &v_m_s in airspeeds_m_s {
        let flow = Flow { v_m_s, rho_kg_m3: truth.rho_kg_m3 };
        let cases: Vec<SteadyCase> = alphas.iter().map(|&alpha| SteadyCase::new(flow, alpha)).collect();
        let modelled = model.at(flow, &neutral)?.solve(&cases);
        let real = truth.states(v_m_s, &alphas)?;
        let channel = |c: usize| {
            let measured: Vec<f64> = real.iter().map(|state| state.loads.to_array()[c]).collect();
            let simulated: Vec<f64> = modelled.iter().map(|state| state.root.to_array()[c]).collect();
            let (a, b) = (line(angles_deg, &measured), line(angles_deg, &simulated));
            let squares: f64 = measured.iter().zip(&simulated).map(|(m, s)| (m - s).powi(2)).sum();
            let size: f64 = measured.iter().map(|m| m * m).sum();
            ChannelComparison {
                offset: [a.0, b.0],
                slope_per_deg: [a.1, b.1],
                relative_error: (squares / size.max(f64::MIN_POSITIVE)).sqrt(),
            }
        };
        all.push(AirspeedComparison { v_m_s, channels: [channel(0), channel(1), channel(2)] });
    }
    Ok(all)
}

/// Value at zero and slope of the least-squares line.
fn line(x: &[f64], y: &[f64]) -> (f64, f64) {
    let count = x.len().max(1) as f64;
    let (mean_x, mean_y) = (x.iter().sum::<f64>() / count, y.iter().sum::<f64>() / count);
    let product: f64 = x.iter().zip(y).map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let square: f64 = x.iter().map(|x| (x - mean_x).powi(2)).sum();
    let slope = if square > 0.0 { product / square } else { 0.0 };
    (mean_y - slope * mean_x, slope)
}

/// The half wing in flight without fairing, its root clamped to the aircraft's plane of symmetry: it carries half
/// of the aircraft alone (no tail, no rotation). A check of what corrections do, not an aircraft.
#[derive(Debug)]
pub struct HalfWingFlight {
    wing: ElasticWing,
    half_mass_kg: f64,
    rho_kg_m3: f64,
}

/// One trimmed flight state of the half wing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlightState {
    /// Angle of attack, degrees.
    pub alpha_deg: f64,
    /// Height of the tip above the unloaded wing's, m.
    pub tip_z_m: f64,
}

impl HalfWingFlight {
    /// The wing of a file as half of an aircraft.
    ///
    /// # Errors
    /// As for assembling a wing.
    pub fn new(file: &WingFile, half_mass_kg: f64, rho_kg_m3: f64) -> Result<Self, CouplingError> {
        let mut file = file.clone();
        if let Source::Parametric(planform) = &mut file.source {
            planform.fairing = None;
        }
        file.root_plane = Some(RootPlane::Symmetric(0.0));
        let wing = ElasticWing::from_bulk(&file, &file.bulk(Mount::Tunnel)?)?;
        Ok(Self { wing, half_mass_kg, rho_kg_m3 })
    }

    /// Trims the lift to a load factor; the wing's own weight acts with that load factor too.
    ///
    /// # Errors
    /// Beyond divergence.
    pub fn trimmed(
        &mut self,
        v_m_s: f64,
        load_factor: f64,
        corrections: &Corrections,
    ) -> Result<FlightState, CouplingError> {
        let flow = Flow { v_m_s, rho_kg_m3: self.rho_kg_m3 };
        self.wing.gravity_m_s2 = load_factor * GRAVITY_M_S2;
        let wanted_n = load_factor * self.half_mass_kg * GRAVITY_M_S2;
        let operator = self.wing.at(flow, corrections)?;
        let tip = self.wing.supported.as_ref().map(|structure| structure.tip_z);
        let fly = |alpha_rad: f64| {
            let states = operator.solve(&[SteadyCase::new(flow, alpha_rad)]);
            let lift: f64 = states[0].box_loads.values.iter().step_by(2).sum();
            (lift - wanted_n, tip.map_or(0.0, |tip| states[0].displacement[tip]))
        };
        // Lift is linear in alpha up to the weight's cosine, so a few secants are exact.
        let (mut before, mut alpha) = (0.0, 0.1);
        for _ in 0..8 {
            let (f0, f1) = (fly(before).0, fly(alpha).0);
            if (f1 - f0).abs() < 1e-12 * wanted_n.abs() {
                break;
            }
            (before, alpha) = (alpha, alpha - f1 * (alpha - before) / (f1 - f0));
        }
        Ok(FlightState { alpha_deg: alpha.to_degrees(), tip_z_m: fly(alpha).1 })
    }
}
