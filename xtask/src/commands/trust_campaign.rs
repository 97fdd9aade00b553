//! Campaigns at rest of the other program's wings, and what they carry in truth.

use std::path::{Path, PathBuf};

use super::trust_flight::{Asked, Point};
use crate::repository;
use calibrate::campaign::ChannelNoise;
use calibrate::{Campaign, Noise, Reading, Sensor, Sets, StaticPoint, TipReading, Zero};
use nastran::Span;
use nastran::table::ColumnNames;
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use truth::lift::{Kind, off_drawing};
use truth::rig::{Coupled, Rest, Rig};
use truth::setting::Setting;
use truth::wing::{Polars, Wing};

pub(super) const V_M_S: f64 = 26.0;
const RHO_KG_M3: f64 = 1.225;
const ALPHAS_DEG: [f64; 6] = [-4.0, -2.0, 0.0, 2.0, 4.0, 6.0];
/// Rows at each angle.
const REPEATS: usize = 2;
/// One standard deviation of a row: Fz (N), Mx, My (N m), tip (m).
const SIGMA: [f64; 4] = [0.05, 0.03, 0.02, 0.001];
/// Places of strain bridges, their noise (N m) and how well their scale is known.
const BRIDGES: [f64; 4] = [0.2, 0.4, 0.6, 0.8];
const BRIDGE_SIGMA_NM: f64 = 0.05;
const BRIDGE_SCALE: f64 = 0.01;
/// Deflected points: angle, and deflections of each control, degrees.
const DEFLECTED_AT_DEG: f64 = 2.0;
const DEFLECTIONS_DEG: [f64; 2] = [-10.0, 10.0];

/// What a campaign measures beside root loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sensors {
    Nothing,
    Tip,
    Strain,
    Deflected,
    All,
}

impl Sensors {
    pub(super) const ALL: [Self; 5] = [Self::Nothing, Self::Tip, Self::Strain, Self::Deflected, Self::All];

    pub(super) const fn name(self) -> &'static str {
        match self {
            Self::Nothing => "root loads",
            Self::Tip => "and tip",
            Self::Strain => "and strain",
            Self::Deflected => "and deflected",
            Self::All => "all of it",
        }
    }
}

/// The other program's wind tunnel.
pub(super) struct Stand {
    rig: Rig,
    /// The wing as it flies.
    flying: Rig,
    points: [Point; 3],
}

/// A true wing at the airspeed and with wind off.
pub(super) struct Flown<'a> {
    stand: &'a Stand,
    number: u64,
    wind: Coupled<'a>,
    still: Coupled<'a>,
    /// With its image, in a stream without walls whose speed is that which is said.
    flying: Coupled<'a>,
}

/// What it carries in a case.
pub(super) struct Carried<'a> {
    rig: &'a Rig,
    rest: Rest,
}

impl Stand {
    pub(super) const POLARS: &'static str = "data/tuflex/e214_neuralfoil_polars.csv";

    pub(super) fn new(data: &Path, points: [Point; 3]) -> Result<Self, truth::Fault> {
        let wing = Wing::read(&data.join("wing_beam.ron"))?;
        let polars = Polars::read(&repository::path(Self::POLARS))?;
        let rig = Rig::new(wing, Some(polars));
        Ok(Self { flying: rig.on_aircraft(), rig, points })
    }

    pub(super) fn fly(&self, kind: Kind, number: u64) -> Flown<'_> {
        let setting = off_drawing(&self.rig.wing, kind, number);
        let free = Setting { wall_rad: 0.0, airspeed: 1.0, ..setting.clone() };
        Flown {
            flying: Coupled::new(&self.flying, free, V_M_S, RHO_KG_M3),
            stand: self,
            number,
            wind: Coupled::new(&self.rig, setting.clone(), V_M_S, RHO_KG_M3),
            still: Coupled::new(&self.rig, setting, 0.0, RHO_KG_M3),
        }
    }

    /// What is measured of a wing.
    pub(super) fn campaign(&self, flown: &Flown<'_>, sensors: Sensors) -> Campaign {
        let mut recorder = Recorder::new(flown, sensors);
        for v_m_s in [0.0, V_M_S] {
            for alpha_deg in ALPHAS_DEG {
                (0..REPEATS).for_each(|_| recorder.record(v_m_s, alpha_deg, None));
            }
        }
        if matches!(sensors, Sensors::Deflected | Sensors::All) {
            for control in 0..self.rig.wing.controls.len() {
                for delta_deg in DEFLECTIONS_DEG {
                    recorder.record(V_M_S, DEFLECTED_AT_DEG, Some((control, delta_deg)));
                }
            }
        }
        let [fz_n, mx_nm, my_nm, tip_z_m] = SIGMA.map(Some);
        let noise = ChannelNoise { fz_n, mx_nm, my_nm, tip_z_m };
        let tip = matches!(sensors, Sensors::Tip | Sensors::All);
        Campaign {
            name: format!("true wing {}", flown.number),
            folder: PathBuf::from(format!("wing {}", flown.number)),
            path: PathBuf::new(),
            rho_kg_m3: RHO_KG_M3,
            noise: Some(Noise { sample: noise, static_point: noise }),
            channels: [true; 3],
            tip: if tip { TipReading::Zeroed } else { TipReading::Unused },
            sets: Sets::EachAirspeed,
            sensors: recorder.bridges,
            points: recorder.points,
            columns: ColumnNames::new(),
            runs: Vec::new(),
        }
    }
}

/// Rows as they are measured.
struct Recorder<'a> {
    flown: &'a Flown<'a>,
    random: Normal,
    bridges: Vec<Sensor>,
    /// What each bridge reads for one newton metre.
    gains: Vec<f64>,
    points: Vec<StaticPoint>,
}

impl<'a> Recorder<'a> {
    fn new(flown: &'a Flown<'a>, sensors: Sensors) -> Self {
        let mut random = Normal(ChaCha12Rng::seed_from_u64(flown.number));
        let bridge = |&y_over_span: &f64| Sensor {
            column: format!("bending_{y_over_span}_Nm"),
            reads: Reading::Bending { y_over_span },
            sigma: BRIDGE_SIGMA_NM,
            zero: Zero::WindOff,
            scale: BRIDGE_SCALE,
            under: None,
        };
        let strain = matches!(sensors, Sensors::Strain | Sensors::All);
        let bridges: Vec<Sensor> = if strain { BRIDGES.iter().map(bridge).collect() } else { Vec::new() };
        let gains = bridges.iter().map(|bridge| 1.0 + random.of(bridge.scale)).collect();
        Self { flown, random, bridges, gains, points: Vec::new() }
    }

    fn record(&mut self, v_m_s: f64, alpha_deg: f64, deflection: Option<(usize, f64)>) {
        let (flown, random) = (self.flown, &mut self.random);
        let rig = &flown.stand.rig;
        let at = if v_m_s > 0.0 { &flown.wind } else { &flown.still };
        let mut controls_rad = vec![0.0; rig.wing.controls.len()];
        if let Some((control, delta_deg)) = deflection {
            controls_rad[control] = delta_deg.to_radians();
        }
        let rest = at.at_rest(alpha_deg.to_radians(), &controls_rad);
        let loads = std::array::from_fn(|c| Some(rest.loads[c] + random.of(SIGMA[c])));
        let tip_z_m = Some(rest.tip_z_m + random.of(SIGMA[3]));
        let carried = Carried { rig, rest };
        let read = |(bridge, gain): (&Sensor, &f64)| {
            let value = gain * carried.bending(bridge.reads.y_over_span()) + random.of(bridge.sigma);
            (v_m_s > 0.0 && deflection.is_none()).then_some(value)
        };
        let named = |(control, delta_deg): (usize, f64)| {
            (rig.wing.controls[control].name.clone(), delta_deg.to_radians())
        };
        let mut span = Span::generated("measured");
        span.line = self.points.len() + 2;
        self.points.push(StaticPoint {
            v_m_s,
            alpha_rad: alpha_deg.to_radians(),
            loads,
            block: None,
            controls_rad: deflection.map(named).into_iter().collect(),
            tip_z_m,
            sensors: self.bridges.iter().zip(&self.gains).map(read).collect(),
            span,
        });
    }
}

impl<'a> Flown<'a> {
    /// With neutral controls.
    pub(super) fn at(&self, alpha_rad: f64) -> Carried<'a> {
        self.with(alpha_rad, None)
    }

    fn with(&self, alpha_rad: f64, control: Option<usize>) -> Carried<'a> {
        let mut controls_rad = vec![0.0; self.stand.rig.wing.controls.len()];
        if let Some(control) = control {
            controls_rad[control] = 1.0_f64.to_radians();
        }
        Carried { rig: &self.stand.rig, rest: self.wind.at_rest(alpha_rad, &controls_rad) }
    }

    /// What is asked of each of the steady maneuvers (rad or m), and its size: of an incidence, that which carries the weight; none where
    /// the wing cannot fly it.
    pub(super) fn in_flight(&self) -> Vec<Option<(&'static str, [f64; 2])>> {
        let one = |point: &Point| {
            let at = |load_factor: f64| self.flying.steady(point.half_mass_kg, load_factor);
            let flown = at(point.load_factor)?;
            Some(match point.asked {
                Asked::Incidence(name) => (name, [flown.alpha_rad, flown.alpha_rad - at(0.0)?.alpha_rad]),
                Asked::Tip(name) => (name, [flown.tip_z_m, flown.tip_z_m.abs()]),
            })
        };
        self.stand.points.iter().map(one).collect()
    }

    /// Bending moment at the root by a degree of a control, N m.
    pub(super) fn power(&self, alpha_rad: f64, name: &str) -> f64 {
        let control = self.stand.rig.wing.controls.iter().position(|control| control.name == name);
        self.with(alpha_rad, control).rest.loads[1] - self.at(alpha_rad).rest.loads[1]
    }
}

impl Carried<'_> {
    pub(super) fn tip_m(&self) -> f64 {
        self.rest.tip_z_m
    }

    /// Lift (N) between two places (m), and its moment (N m) about a third; strips carry evenly over their width.
    fn between(&self, from_m: f64, to_m: f64, about_m: f64) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for (strip, lift_n) in self.rig.lattice.strips.iter().zip(self.rest.lift_n.iter()) {
            let low = (strip.y_m - 0.5 * strip.width_m).max(from_m);
            let high = (strip.y_m + 0.5 * strip.width_m).min(to_m);
            if strip.metric && high > low {
                let lift_n = lift_n / strip.width_m * (high - low);
                sums[0] += lift_n;
                sums[1] += lift_n * (0.5 * (low + high) - about_m);
            }
        }
        sums
    }

    /// Lift per span about a place, over the width of a strip of the model, N/m.
    pub(super) fn strip_lift(&self, y_over_span: f64) -> f64 {
        let (span_m, half_m) =
            (self.rig.wing.planform.semispan_m, 0.5 * self.rig.wing.planform.semispan_m / STRIPS);
        let middle_m = y_over_span * span_m;
        self.between(middle_m - half_m, middle_m + half_m, middle_m)[0] / (2.0 * half_m)
    }

    /// Bending moment of the lift outboard of a place, N m.
    pub(super) fn bending(&self, y_over_span: f64) -> f64 {
        let span_m = self.rig.wing.planform.semispan_m;
        self.between(y_over_span * span_m, span_m, y_over_span * span_m)[1]
    }
}

/// Strips of the model's wing.
const STRIPS: f64 = 56.0;

struct Normal(ChaCha12Rng);

impl Normal {
    fn of(&mut self, sigma: f64) -> f64 {
        let unit: f64 = StandardNormal.sample(&mut self.0);
        sigma * unit
    }
}
