//! Parameters that a calibrated model knows only so well, as effects of a size within their standard deviation.

/// Effect, which of its parameters, standard deviation. The first of an effect's forms counts.
pub const UNCERTAIN: [(&str, usize, f64); 11] = [
    ("bend_stiff", 0, 0.02),
    ("tors_stiff", 0, 0.03),
    ("wing_mass_error", 0, 0.02),
    ("damping", 0, 0.15),
    ("added_mass", 0, 0.05),
    ("aero_lag", 0, 0.10),
    ("ctl_scale", 0, 0.02),
    ("ctl_compliance", 0, 0.02),
    ("act_lag", 0, 0.002),
    ("alpha_offset", 0, 0.02),
    ("delay", 0, 0.001),
];

/// How many of these standard deviations an effect must have before it is more than a matter of calibration.
pub const NUDGES: f64 = 2.5;

/// Standard deviation of a parameter that calibration knows.
pub fn known(effect: &str, parameter: usize) -> Option<f64> {
    UNCERTAIN.iter().find(|(name, which, _)| *name == effect && *which == parameter).map(|u| u.2)
}
