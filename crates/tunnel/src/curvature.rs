//! Sections that follow the curvature of their polars: strip by strip, until consistent.
//!
//! A strip at effective angle `alpha_e` has, beside what its straight line gives, the lift
//! `delta(alpha_e) = cl(alpha_e) - line(alpha_e)`. It is brought about by an incidence (a decamber)
//! `delta / slope` of the strip, to which the whole lattice answers. The effective angle follows from the strip's
//! lift in potential flow without its own decamber, `alpha_e = cl / 2 pi - lead`. This is the decambering idea of
//! Mukherjee and Gopalarathnam (J. Aircraft 43 (3), 2006) with one unknown a strip.

use crate::sections::SectionModel;
use crate::truth::{TrueState, TunnelError};
use aero::Corrections;
use coupling::{ElasticWing, SteadyCase};
use std::f64::consts::TAU;

const MOST_STEPS: usize = 200;
/// Settled: the largest change of a strip's decamber, rad (a few nanonewtons on the balance).
const SETTLED_RAD: f64 = 1e-11;
/// Share of a step that is taken: the strips' mutual induction makes full steps overshoot.
const RELAXATION: f64 = 0.5;

/// One case with curved polars.
pub(crate) fn solve(
    wing: &ElasticWing,
    sections: &SectionModel,
    linear: &Corrections,
    case: &SteadyCase,
) -> Result<TrueState, TunnelError> {
    let v_m_s = case.flow.v_m_s;
    let shifts: Vec<f64> = sections.strips.iter().map(|strip| sections.lead_shift(strip, v_m_s)).collect();
    let shift_cp = sections.pressures(wing, &shifts);
    let lead = thin_airfoil_lead(wing, sections);
    let mut decamber = vec![0.0; sections.strips.len()];
    let mut step = f64::INFINITY;
    for _ in 0..MOST_STEPS {
        let decamber_cp = sections.pressures(wing, &decamber);
        let mut corrections = linear.clone();
        for (entry, &place) in wing.correctable.places.iter().enumerate() {
            corrections.pressure_offset[entry] += linear.force[entry] * decamber_cp[place];
        }
        let states = wing.at(case.flow, &corrections)?.solve(std::slice::from_ref(case));
        let state = &states[0];
        if step < SETTLED_RAD {
            return Ok(TrueState { loads: state.root, tip_z_m: state.tip_z_m });
        }
        step = 0.0;
        for (s, strip) in sections.strips.iter().enumerate() {
            let (mut lift, mut area) = (0.0, 0.0);
            for &entry in &strip.entries {
                let place = wing.correctable.places[entry];
                lift +=
                    wing.integration.area(place) * (state.cp[place] + shift_cp[place] + decamber_cp[place]);
                area += wing.integration.area(place);
            }
            let alpha_e = lift / area / TAU - lead[s] - shifts[s] - decamber[s];
            let re = sections.polars.reynolds(v_m_s, strip.chord_m);
            let line = sections.line(re);
            let beyond = sections.polars.cl(re, alpha_e) - line.slope * (alpha_e + line.lead_rad);
            let change = RELAXATION * (sections.share() * beyond / line.slope - decamber[s]);
            decamber[s] += change;
            step = step.max(change.abs());
        }
    }
    Err(TunnelError::Unsettled { v_m_s, alpha_deg: case.alpha_rad.to_degrees(), step })
}

/// Minus the zero-lift angle of each strip's camber line in thin-airfoil theory with lumped vortices:
/// the solution of one section alone, `sum_k gamma_k / (2 pi (x_i - x_k)) = w_i`.
fn thin_airfoil_lead(wing: &ElasticWing, sections: &SectionModel) -> Vec<f64> {
    use faer::Mat;
    use faer::linalg::solvers::Solve;
    let Some(first) = sections.strips.first() else { return Vec::new() };
    let n = first.entries.len();
    let at = |i: usize, within: f64| (i as f64 + within) / n as f64;
    let kernel = Mat::from_fn(n, n, |i, k| 1.0 / (TAU * (at(i, 0.75) - at(k, 0.25))));
    let camber = Mat::from_fn(n, sections.strips.len(), |i, s| {
        wing.camber[wing.correctable.places[sections.strips[s].entries[i]]]
    });
    let gamma = kernel.partial_piv_lu().solve(&camber);
    // Per chord and airspeed: cl = 2 sum gamma, and cl = 2 pi lead.
    (0..sections.strips.len()).map(|s| 2.0 * gamma.col_as_slice(s).iter().sum::<f64>() / TAU).collect()
}
