//! All effects that the simulator carries, one a file.

use super::declaration::{Declaration, Declared};
use super::effect::Effect;
use super::spec::Known;
use std::sync::Arc;

/// Names the files of the effects, once.
macro_rules! effects {
    ($($file:ident),* $(,)?) => {
        $(mod $file;)*

        /// Forms of every effect.
        const ALL: &[&[Declaration]] = &[$($file::FORMS),*];
    };
}

// Add an effect here and in its own file. Verdicts depend on the order. `cargo fmt` does not look into macros: format these
// files with `rustfmt crates/maneuver/src/effects/library/*.rs`.
effects![
    joiner_inertia,
    wing_mass_error,
    tip_mass,
    crosstalk,
    gain,
    balance_nonlin,
    balance_compliance,
    drift,
    alpha_offset,
    flow_upwash_gradient,
    q_error,
    wall_correction,
    camber,
    lift_slope,
    tip_loss,
    ac_shift,
    re_dependence,
    stall,
    act_lag,
    act_rate,
    backlash,
    ctl_scale,
    ctl_compliance,
    ctl_alpha_interaction,
    ctl_asym,
    bend_stiff,
    tors_stiff,
    damping,
    added_mass,
    aero_lag,
    delay,
    daq_filter,
    friction,
    inplane_force,
    large_deflection,
    delta_offset,
    alpha_encoder,
    cable_stiffness,
    cubic_stiffness,
    root_slack,
    static_hysteresis,
    dynamic_stall,
    ctl_saturation,
];

/// The effects for a wing with these controls, known as a file that says nothing of it has them.
pub fn library(controls: &[String]) -> Vec<Arc<dyn Effect>> {
    library_with(controls, &Known::default())
}

/// The effects for a wing with these controls that is known so well; forms of one effect follow each other.
pub fn library_with(controls: &[String], known: &Known) -> Vec<Arc<dyn Effect>> {
    let of = |form| Declared::new(form, controls, known).map(|effect| Arc::new(effect) as Arc<dyn Effect>);
    ALL.iter().copied().flatten().filter_map(of).collect()
}
