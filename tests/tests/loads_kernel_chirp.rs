//! The rig in moving air against Loads Kernel 2026.5 (independent tool): an aileron chirp to 1 Hz, flown again with the
//! deflection Loads Kernel reports; and the aileron in the frequency domain, beside numpy on PanelAero 2025.8.
//!
//! Tolerances in time are shares of the largest variation. Where the two differ, by `aileron_response.csv` (computed apart
//! from either program, `tests/peers/aileron_response.py`), in per cent of the response at 1 Hz:
//! - Loads Kernel has no incidence from the rate of a hinge: 0.9, by which it is late;
//! - its rational function (poles at k of 0.25 to 1, no apparent mass, its value at rest replaced by the vortex lattice's):
//!   0.3 to 0.5, by which it is early and too large.
//!
//! Its lag inputs are differences between calls of a solver that begins with them at zero, with an absolute tolerance of
//! 1e-4 for modes and lags: up to 0.9 % in the first 0.1 s, nothing visible later.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::loads_kernel::{GRAVITY_M_S2, LoadsKernelWing, MODES, RHO_KG_M3, data};
use aero::{ControlSurface, Corrections, DlmSettings, Flow, KernelIntegral, Lattice, SpanFit};
use coupling::{ElasticWing, SteadyCase};
use faer::c64;
use maneuver::{Actuator, AirModel, Motion, Rig, RigModel, RigSettings, Smooth};
use nastran::table::Table;
use std::f64::consts::TAU;

const CHANNELS: [&str; 4] = ["Fz_N", "Mx_Nm", "My_Nm", "tip_m"];
const FLOW: Flow = Flow { v_m_s: 30.0, rho_kg_m3: RHO_KG_M3 };
/// Loads Kernel reports the deflection itself: an actuator that does nothing at these frequencies.
const ACTUATOR: Actuator = Actuator { frequency_hz: 1e4, damping_ratio: 0.8 };

/// Below, at and above the first bending (5.1 Hz in vacuo), up to most of the way to the second (32 Hz).
const FREQUENCIES_HZ: [f64; 10] = [0.2, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 20.0];

fn alpha_rad() -> f64 {
    1.3_f64.to_radians()
}

/// Loads Kernel's wing with its aileron; without the rate of the hinge as in Loads Kernel, or with it.
fn wing(hinge_rate: bool, softer: f64) -> ElasticWing {
    let bulk = nastran::read_deck(&data("wing.bdf")).unwrap();
    let lattice = Lattice::from_bulk(&bulk).unwrap();
    let mut controls = ControlSurface::all_from_bulk(&bulk, &lattice).unwrap();
    if !hinge_rate {
        controls[0].lever_m.fill(0.0);
    }
    LoadsKernelWing::read().at(&lattice, 0.088, controls, alpha_rad(), softer)
}

fn rig(wing: &ElasticWing, air: AirModel) -> Rig<'_> {
    let mut settings = RigSettings::new(0.01, 0.1);
    settings.modes = MODES;
    settings.actuator = ACTUATOR;
    settings.air = air;
    Rig::new(wing, settings).unwrap()
}

/// Time and four channels.
struct Curves {
    t_s: Vec<f64>,
    channels: [Vec<f64>; 4],
}

/// The chirp as Loads Kernel and the rig fly it, root loads with weight, the tip from the jig shape along earth's axis.
fn flown(hinge_rate: bool, air: AirModel) -> (Curves, Curves) {
    let table = Table::read(&data("chirp.csv")).unwrap();
    let aileron = table.numbers("aileron_rad").unwrap();
    let samples = aileron.len();
    let wing = wing(hinge_rate, 1.0);
    let model = rig(&wing, air).at(FLOW, &Corrections::neutral(672)).unwrap();
    let still = vec![0.0; samples];
    let history = model.fly(&Motion {
        time_step_s: 0.01,
        alpha: Smooth { value: vec![alpha_rad(); samples], rate: still.clone(), second: still },
        controls_rad: vec![aileron],
    });
    let supported = wing.supported.as_ref().unwrap();
    let load = |channel: usize| -> Vec<f64> {
        let tare = supported.weight[(channel, 2)] * GRAVITY_M_S2;
        history.get(CHANNELS[channel]).unwrap().iter().map(|value| value - tare).collect()
    };
    let sag = supported.sag[(supported.tip_z, 2)] * GRAVITY_M_S2;
    let tip = history.get("tip_z_m").unwrap().iter().map(|z| (z - sag) * alpha_rad().cos()).collect();
    let ours = Curves { t_s: history.t_s.clone(), channels: [load(0), load(1), load(2), tip] };
    let theirs = Curves {
        t_s: table.numbers("t_s").unwrap(),
        channels: ["Fz_N", "Mx_Nm", "My_Nm", "tip_up_m"].map(|name| table.numbers(name).unwrap()),
    };
    (ours, theirs)
}

/// Largest difference of the variations from `from_s` on, as a share of the largest variation, once theirs is brought
/// forward by `lead_s`.
fn apart(ours: &Curves, theirs: &Curves, from_s: f64, lead_s: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|c| {
        let varies = |values: &[f64]| -> Vec<f64> { values.iter().map(|value| value - values[0]).collect() };
        let (a, b) = (varies(&ours.channels[c]), varies(&theirs.channels[c]));
        let peak = b.iter().map(|value| value.abs()).fold(0.0, f64::max);
        let difference = |i: usize| {
            let rate = (b[i + 1] - b[i - 1]) / (theirs.t_s[i + 1] - theirs.t_s[i - 1]);
            (a[i] - b[i] - lead_s[c] * rate).abs() / peak
        };
        (1..a.len() - 1).filter(|&i| theirs.t_s[i] >= from_s).map(difference).fold(0.0, f64::max)
    })
}

#[test]
fn the_chirp_starts_from_loads_kernels_steady_state() {
    let (ours, theirs) = flown(true, AirModel::default());
    // Loads Kernel takes the elastic incidence times cos(alpha), as in its steady cases
    let wing = wing(true, alpha_rad().cos());
    let state =
        &wing.at(FLOW, &Corrections::neutral(672)).unwrap().solve(&[SteadyCase::new(FLOW, alpha_rad())])[0];
    let weight = &wing.supported.as_ref().unwrap().weight;
    for (c, load) in state.root.to_array().into_iter().enumerate() {
        let expected = theirs.channels[c][0];
        let ratio = (load - weight[(c, 2)] * GRAVITY_M_S2) / expected;
        assert!((ratio - 1.0).abs() < 1e-6, "{}: {ratio}", CHANNELS[c]);
        let without = ours.channels[c][0] / expected;
        assert!((without - 1.0).abs() < 1e-4, "{} without cos(alpha): {without}", CHANNELS[c]);
    }
}

#[test]
fn an_aileron_chirp_agrees_with_loads_kernel_within_its_stated_errors() {
    let (ours, theirs) = flown(true, AirModel::default());
    // 0.58, 0.50, 0.84 and 0.44 %, the first and third in the first 0.1 s
    for (c, difference) in apart(&ours, &theirs, 0.0, [0.0; 4]).into_iter().enumerate() {
        assert!(difference < 0.01, "{}: {difference}", CHANNELS[c]);
    }
}

#[test]
fn what_is_left_of_the_chirp_is_loads_kernels_fit_and_its_missing_hinge_rate() {
    for hinge_rate in [true, false] {
        let (ours, theirs) = flown(hinge_rate, AirModel::default());
        // 0.11 to 0.14 %; the amplitude of Loads Kernel's fit is 0.17 to 0.27 % too large at 1 Hz
        for (c, left) in apart(&ours, &theirs, 0.15, lead_s(hinge_rate)).into_iter().enumerate() {
            assert!(left < 0.002, "{} with hinge rate {hinge_rate}: {left}", CHANNELS[c]);
        }
    }
}

#[test]
fn the_chirp_tells_air_with_a_wake_from_air_without() {
    let (ours, theirs) = flown(true, AirModel::QuasiSteady);
    // 3.9 to 5.4 %
    for (c, difference) in apart(&ours, &theirs, 0.0, [0.0; 4]).into_iter().enumerate() {
        assert!(difference > 0.03, "{}: {difference}", CHANNELS[c]);
    }
}

/// The aileron's response at a frequency as in `aileron_response.csv`, per rad.
fn reference(f_hz: f64, air: &str, hinge_rate: bool) -> [c64; 4] {
    let table = Table::read(&data("aileron_response.csv")).unwrap();
    let row = (0..table.len())
        .find(|&row| {
            table.number(row, "f_hz").unwrap() == f_hz
                && table.text(row, "air").unwrap() == air
                && table.text(row, "hinge_rate").unwrap() == if hinge_rate { "yes" } else { "no" }
        })
        .unwrap();
    CHANNELS.map(|name| {
        let part = |part: &str| table.number(row, &format!("{name}_{part}")).unwrap();
        c64::new(part("re"), part("im"))
    })
}

/// By how much the lattice with or without the hinge's rate leads Loads Kernel's fit at 1 Hz.
fn lead_s(hinge_rate: bool) -> [f64; 4] {
    let (ours, theirs) = (reference(1.0, "lattice", hinge_rate), reference(1.0, "fit", false));
    std::array::from_fn(|c| (ours[c] / theirs[c]).arg() / TAU)
}

/// The rig's answer to the aileron's deflection, the actuator taken out.
fn response(model: &RigModel, omega_rad_s: f64) -> [c64; 4] {
    let all = model.frequency_response(omega_rad_s);
    let omega = TAU * ACTUATOR.frequency_hz;
    let share = omega_rad_s / omega;
    let lag = c64::new(1.0 - share * share, 2.0 * ACTUATOR.damping_ratio * share);
    std::array::from_fn(|c| all[(c, 1)] * lag)
}

/// Largest relative difference from numpy and `PanelAero` over channels and frequencies: of the lattice at each frequency,
/// and of the rational function.
fn apart_from_panelaero(hinge_rate: bool) -> (f64, f64) {
    let doublets = DlmSettings { integral: KernelIntegral::Laschka, fit: SpanFit::Parabolic };
    let wing = wing(hinge_rate, 1.0);
    let rig = rig(&wing, AirModel::Unsteady { lags: 7, dlm: doublets });
    let neutral = Corrections::neutral(672);
    let model = rig.at(FLOW, &neutral).unwrap();
    let (mut exact, mut rational): (f64, f64) = (0.0, 0.0);
    for f_hz in FREQUENCIES_HZ {
        let omega = TAU * f_hz;
        let expected = reference(f_hz, "lattice", hinge_rate);
        let frozen = response(&rig.at_frequency(FLOW, &neutral, omega).unwrap(), omega);
        let fitted = response(&model, omega);
        for (c, expected) in expected.into_iter().enumerate() {
            exact = exact.max((frozen[c] / expected - 1.0).norm());
            rational = rational.max((fitted[c] / expected - 1.0).norm());
        }
    }
    (exact, rational)
}

#[test]
fn the_ailerons_response_through_its_first_resonance_is_that_of_numpy_and_panelaero() {
    for hinge_rate in [true, false] {
        let (exact, rational) = apart_from_panelaero(hinge_rate);
        // 2e-9, at the tip at 20 Hz
        assert!(exact < 1e-8, "lattice at each frequency: {exact}");
        // 0.32 %, My at 8 Hz, where it is a tenth of its value at rest
        assert!(rational < 0.005, "rational function: {rational}");
    }
}
