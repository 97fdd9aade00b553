//! A wing that is worked out by hand, for the tests of this crate's parts: each box carries a lift of its own in
//! proportion to its
//! incidence, and the tip rises in proportion to the bending moment.

use crate::campaign::{Campaign, ChannelNoise, Noise, Sets, StaticPoint, TipReading};
use crate::settings::Settings;
use aero::{Corrections, Flow};
use coupling::{CorrectableBoxes, CouplingError, RootLoads, RootSensitivity, SteadyCase, SteadyModel};
use faer::Mat;
use nastran::Span;

/// Air density, kg/m3.
pub(crate) const RHO: f64 = 1.2;
/// Lift slope of every box, per rad.
pub(crate) const SLOPE: f64 = 5.0;
/// Area, m2, and span, m.
pub(crate) const AREA_M2: f64 = 0.5;
pub(crate) const SPAN_M: f64 = 2.0;
/// Moment coefficient of every box about its own quarter point, per rad.
const OWN_MOMENT: f64 = -0.4;
/// Rise of the tip by the bending moment, m/(N m).
pub(crate) const SOFT_M_NM: f64 = 2e-3;

/// See the file.
pub(crate) struct Toy {
    pub(crate) boxes: CorrectableBoxes,
    /// Weight, N, a metre outboard and 0.1 m ahead of the balance.
    pub(crate) weight_n: f64,
    /// Angle at which it does not lift, rad, upside down.
    pub(crate) camber_rad: f64,
}

impl Toy {
    /// So many strips along the span, and boxes along the chord.
    pub(crate) fn new(strips: usize, rows: usize) -> Self {
        let all = || (0..strips).flat_map(|strip| (0..rows).map(move |row| (strip, row)));
        let count = strips * rows;
        let boxes = CorrectableBoxes {
            places: (0..count).collect(),
            chord_row: all().map(|(_, row)| row).collect(),
            chord_rows: vec![rows; count],
            strip: all().map(|(strip, _)| strip).collect(),
            y_norm: all().map(|(strip, _)| (strip as f64 + 0.5) / strips as f64).collect(),
            area_share: vec![1.0 / count as f64; count],
            area_m2: AREA_M2,
            ends_m: [0.3, 0.3 + SPAN_M],
        };
        Self { boxes, weight_n: 0.0, camber_rad: 0.0 }
    }

    /// Fz, Mx, My and tip by a newton of lift on a box.
    fn arms(&self, b: usize) -> [f64; 4] {
        let y_m = SPAN_M * self.boxes.y_norm[b];
        let share = (self.boxes.chord_row[b] as f64 + 0.25) / self.boxes.chord_rows[b] as f64;
        [1.0, y_m, -(share - 0.3) * self.boxes.mean_chord_m(), SOFT_M_NM * y_m]
    }

    fn sensitivity(&self, case: &SteadyCase, corrections: &Corrections) -> RootSensitivity {
        let count = self.boxes.len();
        let incidence = case.alpha_rad + self.camber_rad;
        let force_n = |b: usize| case.flow.dynamic_pressure_pa() * AREA_M2 * self.boxes.area_share[b];
        let by_offset = Mat::from_fn(4, count, |c, b| force_n(b) * self.arms(b)[c]);
        let by_force = Mat::from_fn(4, count, |c, b| SLOPE * incidence * by_offset[(c, b)]);
        let by_moment = Mat::from_fn(4, count, |c, b| {
            if c == 2 { OWN_MOMENT * incidence * self.boxes.mean_chord_m() * force_n(b) } else { 0.0 }
        });
        let lighter = self.weight_n * (1.0 - case.alpha_rad.cos());
        let weight = [lighter, lighter, 0.1 * lighter, 0.0];
        let read: [f64; 4] = std::array::from_fn(|c| {
            let of = |b: usize| {
                corrections.force[b] * by_force[(c, b)]
                    + corrections.moment[b] * by_moment[(c, b)]
                    + corrections.pressure_offset[b] * by_offset[(c, b)]
            };
            weight[c] + (0..count).map(of).sum::<f64>()
        });
        let loads = RootLoads::from_array([read[0], read[1], read[2]]);
        RootSensitivity { loads, tip_z_m: read[3], by_force, by_moment, by_offset }
    }

    /// Fz, Mx, My and tip at an airspeed and angle.
    pub(crate) fn reads(&self, v_m_s: f64, alpha_rad: f64, corrections: &Corrections) -> [f64; 4] {
        let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: RHO }, alpha_rad);
        self.sensitivity(&case, corrections).readings()
    }

    /// One factor at every box.
    pub(crate) fn uniform(&self, factor: f64) -> Corrections {
        let count = self.boxes.len();
        Corrections {
            force: vec![factor; count],
            moment: vec![factor; count],
            pressure_offset: vec![0.0; count],
        }
    }

    /// A campaign of its readings with these corrections, lines numbered from 2.
    pub(crate) fn measured(
        &self,
        airspeeds_m_s: &[f64],
        alphas_rad: &[f64],
        corrections: &Corrections,
    ) -> Campaign {
        let all = airspeeds_m_s.iter().flat_map(|&v| alphas_rad.iter().map(move |&alpha| (v, alpha)));
        let point = |(i, (v_m_s, alpha_rad)): (usize, (f64, f64))| {
            point(i + 2, v_m_s, alpha_rad, self.reads(v_m_s, alpha_rad, corrections))
        };
        campaign(all.enumerate().map(point).collect(), None)
    }
}

impl SteadyModel for Toy {
    fn correctable(&self) -> &CorrectableBoxes {
        &self.boxes
    }

    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError> {
        Ok(cases.iter().map(|case| self.sensitivity(case, corrections).loads).collect())
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        Ok(cases.iter().map(|case| self.sensitivity(case, corrections)).collect())
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        Ok(vec![SLOPE * (case.alpha_rad + self.camber_rad); self.boxes.len()])
    }
}

/// One row with Fz, Mx, My and the tip.
pub(crate) fn point(line: usize, v_m_s: f64, alpha_rad: f64, read: [f64; 4]) -> StaticPoint {
    let mut span = Span::generated("test");
    span.line = line;
    StaticPoint {
        v_m_s,
        alpha_rad,
        loads: [Some(read[0]), Some(read[1]), Some(read[2])],
        block: None,
        controls_rad: Vec::new(),
        tip_z_m: Some(read[3]),
        sensors: Vec::new(),
        span,
    }
}

/// Declared noise of rows.
pub(crate) fn noise(sigma: [f64; 4]) -> Noise {
    let noise = ChannelNoise::from_array(sigma);
    Noise { sample: noise, static_point: noise }
}

/// A campaign of root loads.
pub(crate) fn campaign(points: Vec<StaticPoint>, sigma: Option<[f64; 4]>) -> Campaign {
    Campaign {
        name: "test".into(),
        folder: "test".into(),
        path: "test".into(),
        rho_kg_m3: RHO,
        noise: sigma.map(noise),
        channels: [true; 3],
        tip: TipReading::Unused,
        sets: Sets::EachAirspeed,
        sensors: Vec::new(),
        points,
        columns: nastran::table::ColumnNames::new(),
        runs: Vec::new(),
    }
}

/// Settings for so many boxes along the chord.
pub(crate) fn settings(rows: usize) -> Settings {
    Settings { chord_strips: rows, span_order: 1, ..Settings::default() }
}

#[track_caller]
pub(crate) fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs().max(1e-300) + 1e-300, "{a} is not {b}");
}
