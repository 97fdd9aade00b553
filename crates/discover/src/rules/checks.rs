//! When data are at fault.

use super::rule::Origin::{Formula, Physical, Unknown};
use super::rule::rules;

rules! {
    /// A run beside its simulation.
    RecordRules {
        /// A control jumps if it moves by this share of its height within two samples.
        jump: f64 = 0.2, "", Unknown;
        /// Loads and models of them are rough for so many samples around a jump.
        rough_around: usize = 15, "samples", Unknown;
        /// A channel has a gain if the root mean square of its simulation is so many standard deviations of a sample.
        visible_rms: f64 = 5.0, "standard deviations", Unknown;
    }
}

rules! {
    /// Airspeeds that are not what a label says.
    AirspeedRules {
        /// All loads must change alike, in the logarithm of their ratio.
        alike: f64 = 0.15, "", Unknown;
        /// Least ratio of the loads to those of runs with the same label.
        least_ratio: f64 = 1.12, "", Unknown;
        /// The same against all runs, where the label has too few: slopes differ with the airspeed.
        least_ratio_of_all: f64 = 1.35, "", Unknown;
        /// Least change of the airspeed, as a share.
        least_airspeed: f64 = 0.07, "", Unknown;
        /// So many other runs make a comparison.
        peers: usize = 3, "runs", Unknown;
        /// A mean load counts if it is so many standard deviations of a sample.
        visible_mean: f64 = 10.0, "standard deviations", Unknown;
        /// Runs whose mean angles are closer tell with which power of the airspeed loads grow.
        near_angle_rad: f64 = 0.01, "rad", Unknown;
        /// A run without wind carries at least this share of the mean loads with wind if its label is wrong.
        blown: f64 = 0.2, "", Unknown;
    }
}

rules! {
    /// Exchanged labels and flipped signs.
    LabelRules {
        /// An exchange explains a run if it leaves less than this share of what the labels leave.
        explains: f64 = 0.1, "", Unknown;
        /// The same for all data at once, where only shapes are compared.
        explains_all: f64 = 0.3, "", Unknown;
        /// What the labels leave must be more than this share of the load, or nothing is wrong.
        wrong: f64 = 0.1, "", Unknown;
        /// A channel goes against the simulation if they correlate by less than minus this.
        against: f64 = 0.7, "", Unknown;
    }
}

rules! {
    /// Channels that are many times what they are in other runs.
    ScaleRules {
        /// Least factor between a channel's gain in a run and in the other runs.
        least_factor: f64 = 3.0, "", Physical("the smallest of units that are mistaken for each other: pounds for newtons is 4.4");
        /// A channel has a gain if it correlates so well with the simulation.
        alike: f64 = 0.8, "", Physical("as late and early runs");
        /// So many other runs make a comparison.
        peers: usize = 3, "runs", Formula("the middle of three is not the one that is wrong");
    }
}

rules! {
    /// Samples that were not measured.
    SampleRules {
        /// A stretch is flat if it spans less than this share of the noise.
        flat: f64 = 0.1, "standard deviations", Formula("noise does not rest");
        /// Shortest flat stretch: neighbours are alike behind a filter.
        shortest_flat: usize = 6, "samples", Unknown;
        /// So many samples in flat stretches at an end of the range make a clipped channel.
        clipped: usize = 10, "samples", Unknown;
        /// The simulation must move by so much meanwhile.
        moves: f64 = 3.0, "standard deviations", Unknown;
        /// A channel that stands still for this share of a run is stuck.
        stuck: f64 = 0.2, "", Unknown;
        /// Flat stretches within this share of the range from its end count as clipped: a filter swings past the end.
        near_end: f64 = 0.02, "", Unknown;
        /// Least height of a spike.
        spike: f64 = 25.0, "standard deviations", Unknown;
        /// The usual height is that of all but the highest.
        usual_percent: usize = 97, "% of the samples", Unknown;
        /// And over the usual height, and over that of peers.
        spike_over_others: f64 = 4.0, "", Unknown;
        /// What another run of the kind shows within this time is no defect but the wing's doing...
        same_instant_s: f64 = 0.1, "s", Unknown;
        /// ... if it is at least this share as high.
        common: f64 = 0.3, "", Unknown;
        /// A spike is over within so many samples.
        narrow: usize = 2, "samples", Unknown;
        /// Around it, as far again, nothing is this share as high.
        beside_narrow: f64 = 0.35, "", Unknown;
    }
}

rules! {
    /// Late and early runs.
    TimingRules {
        /// Longest lag that is looked for.
        longest_s: f64 = 0.3, "s", Unknown;
        /// Least lag against runs of the kind.
        least_s: f64 = 0.03, "s", Unknown;
        /// Least phase against them at a pitching frequency, in turns: missing dynamics may do half of it.
        least_turns: f64 = 30.0 / 360.0, "turns", Unknown;
        /// A channel counts if it correlates so well with the simulation, shifted.
        alike: f64 = 0.8, "", Unknown;
        /// Channels must agree within this.
        agree_s: f64 = 0.02, "s", Unknown;
        /// So many other runs make a comparison.
        peers: usize = 3, "runs", Unknown;
        /// So many median distances from the median of its kind a lag must be.
        spreads: f64 = 9.0, "", Unknown;
    }
}

rules! {
    /// Repeats that do not repeat.
    RepeatRules {
        /// The difference of two repeats counts if its root mean square is so much...
        far: f64 = 8.0, "standard deviations", Unknown;
        /// ... this share of the load's variation...
        share: f64 = 0.1, "", Unknown;
        /// ... and so many times the other pairs' difference.
        beyond_others: f64 = 5.0, "", Unknown;
    }
}
