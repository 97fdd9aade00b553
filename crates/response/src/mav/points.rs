//! The test points of the paper: the levels of its Sec. II.D, combined as its sections IV.B to IV.D say. Where it gives a
//! range and no levels (alpha, delta) the steps are assumed: 2 degrees of alpha, which makes the eight levels of Sec.
//! IV.C between 4 and 18 degrees, and 10 degrees of elevator.

use super::factor::Condition;

/// Airspeeds, m/s.
pub const AIRSPEEDS_M_S: [f64; 4] = [8.0, 10.0, 11.5, 13.0];
/// Airspeeds at which negative elevator was run, m/s.
pub const NEGATIVE_ELEVATOR_AIRSPEEDS_M_S: [f64; 2] = [10.0, 13.0];
/// Motor voltages with power, V.
pub const VOLTAGES_V: [f64; 3] = [6.6, 7.0, 7.4];
/// Air density assumed, kg/m^3; the paper gives none.
pub const RHO_KG_M3: f64 = 1.225;
/// Wing area, m^2.
pub const WING_AREA_M2: f64 = 0.0178;
/// Root chord, m.
pub const ROOT_CHORD_M: f64 = 0.130;
/// Wing span, m.
pub const SPAN_M: f64 = 0.150;
/// Resolution of the balance, N.
pub const BALANCE_RESOLUTION_N: f64 = 0.03;
/// Full negative elevator, degrees.
pub const FULL_NEGATIVE_DEG: f64 = -30.0;

/// Dynamic pressure at an airspeed, Pa.
pub fn dynamic_pressure_pa(v_m_s: f64) -> f64 {
    0.5 * RHO_KG_M3 * v_m_s * v_m_s
}

/// A series of runs that the paper describes, with the equations fitted to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Series {
    /// Propeller speed of the rigid wing with the motor on: Eq. 4 of paper 2.
    PropellerSpeed,
    /// PR wing without propeller, elevator zero and positive: Eqs. 5 to 7 of paper 2.
    PropellerOff,
    /// BR wing without propeller, two airspeeds, elevator zero and fully negative: Eqs. 8 to 10 of paper 2.
    NegativeElevator,
    /// With propeller, elevator zero and positive, voltage as a factor: Eq. 11 of paper 2.
    VoltageInput,
    /// With propeller, all elevator angles, propeller speed as a factor: Eqs. 12 to 14 of paper 2.
    PropellerOn,
    /// The same at high angles of attack: Eqs. 15 and 16 of paper 2. From 22 degrees, as the published cubics give nonsense below.
    HighAlpha,
}

/// A state at which a run measures, with its airspeed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TestPoint {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// The state; its propeller speed is left open.
    pub condition: Condition,
}

impl Series {
    /// All series.
    pub const ALL: [Self; 6] = [
        Self::PropellerSpeed,
        Self::PropellerOff,
        Self::NegativeElevator,
        Self::VoltageInput,
        Self::PropellerOn,
        Self::HighAlpha,
    ];

    /// Its name, as that of the file without ending.
    pub fn name(self) -> &'static str {
        match self {
            Self::PropellerSpeed => "propeller_speed",
            Self::PropellerOff => "propeller_off",
            Self::NegativeElevator => "negative_elevator",
            Self::VoltageInput => "voltage_input",
            Self::PropellerOn => "propeller_on",
            Self::HighAlpha => "high_alpha",
        }
    }

    /// Equations of its responses, and the wing they are given for.
    pub fn equations(self) -> (&'static [u8], &'static str) {
        match self {
            Self::PropellerSpeed => (&[4], "R"),
            Self::PropellerOff => (&[5, 6, 7], "PR"),
            Self::NegativeElevator => (&[8, 9, 10], "BR"),
            Self::VoltageInput => (&[11], ""),
            Self::PropellerOn => (&[12, 13, 14], ""),
            Self::HighAlpha => (&[15, 16], ""),
        }
    }

    /// How often it is run as a whole; each time is a block.
    pub fn blocks(self) -> usize {
        match self {
            Self::PropellerSpeed | Self::PropellerOff => 3,
            _ => 2,
        }
    }

    /// Its points in the order of one-factor-at-a-time testing: a sweep of alpha at constant voltage, elevator and
    /// airspeed.
    pub fn points(self) -> Vec<TestPoint> {
        let alphas: Vec<f64> = match self {
            Self::PropellerSpeed => levels(4, 36, 2),
            Self::HighAlpha => levels(22, 36, 2),
            _ => levels(4, 18, 2),
        };
        let mut points = Vec::new();
        for v_m_s in AIRSPEEDS_M_S {
            for delta_deg in self.elevators(v_m_s) {
                for &voltage_v in self.voltages() {
                    for &alpha_deg in &alphas {
                        let state = Condition::unpowered(dynamic_pressure_pa(v_m_s), alpha_deg, delta_deg);
                        points.push(TestPoint { v_m_s, condition: Condition { voltage_v, ..state } });
                    }
                }
            }
        }
        points
    }

    fn voltages(self) -> &'static [Option<f64>] {
        match self {
            Self::PropellerOff | Self::NegativeElevator => &[None],
            _ => &[Some(VOLTAGES_V[0]), Some(VOLTAGES_V[1]), Some(VOLTAGES_V[2])],
        }
    }

    fn elevators(self, v_m_s: f64) -> Vec<f64> {
        let negative = NEGATIVE_ELEVATOR_AIRSPEEDS_M_S.contains(&v_m_s).then_some(FULL_NEGATIVE_DEG);
        match self {
            Self::PropellerSpeed => vec![0.0],
            Self::NegativeElevator => negative.map_or_else(Vec::new, |negative| vec![negative, 0.0]),
            Self::PropellerOff | Self::VoltageInput => levels(0, 30, 10),
            Self::PropellerOn | Self::HighAlpha => negative.into_iter().chain(levels(0, 30, 10)).collect(),
        }
    }
}

fn levels(from: i32, to: i32, step: usize) -> Vec<f64> {
    (from..=to).step_by(step).map(f64::from).collect()
}
