//! What a model may be off by without any effect missing.

use super::rule::Origin::{Formula, Measured, Physical, Unknown};
use super::rule::rules;

rules! {
    /// What a single run or static group may be off by.
    ToleranceRules {
        /// Gain of a run's mean.
        run_mean_gain: f64 = 0.01, "", Physical("balances and airspeeds of a day; kept from the method's prototype, where null campaigns have a chi square a row of 1.4 with it and 1.9 without");
        /// Gain of a run's motion.
        run_motion_gain: f64 = 0.03, "", Physical("as `run_mean_gain`");
        /// Time shift of a run.
        run_shift_s: f64 = 0.004, "s", Physical("as `run_mean_gain`");
        /// A record's energy within a band counts as one run if it lasts so long: a chirp of 30 s is a dozen runs, one after the other through the frequencies.
        one_run_s: f64 = 3.0, "s", Physical("length of a pitch or doublet run");
        /// Gain of a group of static points.
        static_gain: f64 = 0.01, "", Physical("as `run_mean_gain`");
        /// Gain of the contribution of an effect that was found, as its form is never exact.
        found_gain: f64 = 0.15, "", Measured("the method's prototype: names beside the right one fall from .42 to .09 a case");
        /// Time shift of the contribution of an effect that was found.
        found_shift_s: f64 = 0.005, "s", Measured("as `found_gain`");
    }
}

rules! {
    /// What all runs share: parameters that calibration leaves open, and model-form variants.
    SharedRules {
        /// Standard deviation of each wave of the lift along the span, as a share.
        lift_wave: f64 = 0.015, "", Unknown;
        /// Half waves of the lift along the span that the corrections' directions do not hold.
        half_waves: [u8; 3] = [2, 3, 4], "", Formula("the corrections' directions hold the longer ones");
        /// Standard deviation of a single control surface's effectiveness, as a share.
        surface: f64 = 0.015, "", Unknown;
        /// So many standard deviations of its calibration a value must have before it is an effect and not a matter of calibration.
        prior_widths: f64 = 2.5, "standard deviations", Formula("one in eighty normal values is larger");
        /// A value that calibration does not know is within its prior below this share of its plausible size.
        negligible: f64 = 0.02, "", Unknown;
        /// Standard deviations of the corrections' six directions before any data: factor on the lift, its growth to the tip, shift of the aerodynamic centre over the chord, incidence, its gradient along the span, zero-lift moment.
        directions: [f64; 6] = [0.1, 0.2, 0.02, 0.01, 0.01, 0.01], "-, -, -, rad, rad/m, -", Physical("what a panel model may be off by");
        /// How open these directions stay, as a share, where the corrections were found with other static points.
        calibrated: f64 = 0.02, "", Physical("what a day's readings leave of them");
        /// What the difference of a model-form variant is multiplied by.
        variant_factor: f64 = 1.5, "", Measured("the method's prototype: the largest log Bayes factor of a null campaign falls from 216 to 128");
        /// How far values of effects that were found may be off while another is looked for, as a share of them.
        found_value_off: f64 = 0.2, "", Measured("development cases of the blind benchmark: a servo's lag beside its rate limit has a log Bayes factor of 8300 instead of 450");
        /// Step by which these values are changed, as a share of them.
        found_value_step: f64 = 0.1, "", Formula("half of `found_value_off`");
        /// Most values of an effect that are freed so; those of one with more are its form.
        found_values_freed: usize = 3, "", Unknown;
    }
}

rules! {
    /// Model-form variants of the wing, and the reduced-order model that flies it.
    VariantRules {
        /// Modes of the search's model: those below 100 Hz or so; the others answer statically.
        modes: usize = 10, "", Physical("eight times `highest_hz` and more");
        /// Lags of the variant with another rational function of the air.
        lags: usize = 4, "", Unknown;
        /// Share of boxes along the chord that the variant of the lattice has.
        chord_boxes: f64 = 0.67, "", Unknown;
        /// Share of boxes along the span that it has.
        span_boxes: f64 = 0.7, "", Unknown;
        /// Angles at which a variant is brought to the static loads of the own model.
        angles_rad: [f64; 2] = [-0.035, 0.105], "rad", Formula("two angles determine offset and slope");
        /// Newton's steps to these loads.
        steps: usize = 3, "", Formula("the loads are linear in the directions but for products");
    }
}
