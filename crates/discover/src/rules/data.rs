//! How a campaign is read, and what its noise is.

use super::rule::Origin::{Formula, Physical, Unknown};
use super::rule::rules;

rules! {
    /// Runs and static points as the search wants them.
    DataRules {
        /// Sample rate that runs are brought to.
        rate_hz: f64 = 100.0, "Hz", Formula("more than eight times `highest_hz`");
        /// Cutoff of the filter before samples are left out.
        anti_alias_hz: f64 = 25.0, "Hz", Formula("half the Nyquist frequency of `rate_hz`");
        /// Highest frequency whose cosine coefficients are looked at.
        highest_hz: f64 = 12.0, "Hz", Unknown;
        /// An angle of a smaller standard deviation is held: its encoder's noise would be flown as motion otherwise.
        held_angle_sd_rad: f64 = 3.5e-4, "rad", Physical("a fiftieth of a degree, four times an encoder's noise");
        /// Airspeeds closer than this share of each other are one.
        same_airspeed: f64 = aero::flow::SAME_AIRSPEED, "", Physical("how well a tunnel holds its airspeed");
        /// Where a campaign does not say which runs are held out, the last of every so many is.
        held_out_every: usize = 3, "runs", Unknown;
    }
}

rules! {
    /// Pure error, from repeats or as stated.
    NoiseRules {
        /// Upper ends of the bands in which the noise of a coefficient is one number.
        bands_hz: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 12.0], "Hz", Formula("octaves up to `highest_hz`");
        /// Where neither is known, noise is what a record holds above this share of `highest_hz`.
        quiet_from: f64 = 0.85, "", Unknown;
        /// So many coefficients are needed for an estimate that may stand alone.
        enough_coefficients: usize = 12, "", Unknown;
        /// Static points at angles closer than this repeat each other.
        same_angle_rad: f64 = aero::flow::SAME_ANGLE_RAD, "rad", Physical("how well a turntable is set");
        /// Offset of a run where nothing tells it.
        least_offset: f64 = 1e-3, "N, N m", Unknown;
    }
}

rules! {
    /// Narrow peaks in what repeats differ by.
    SpectralLineRules {
        /// Width of a bin.
        bin_hz: f64 = 0.25, "Hz", Unknown;
        /// Neighbours to either side whose median a bin is compared with.
        neighbours: usize = 10, "bins", Unknown;
        /// Slower than this is drift.
        slowest_hz: f64 = 1.0, "Hz", Physical("drifts of a day, offsets of runs");
        /// Share of half the sample rate beyond which filters of the record leave little.
        fastest: f64 = 0.9, "", Physical("anti-aliasing filters");
        /// So many times its neighbours a line must be: motions that repeat not quite alike leave broad hills of less.
        times_neighbours: f64 = 6.0, "", Unknown;
        /// Chance of a bin to stand out so far by noise alone.
        chance: f64 = 1e-9, "", Unknown;
        /// Strouhal numbers and frequencies within this share are one.
        same_frequency: f64 = 0.04, "", Unknown;
    }
}
