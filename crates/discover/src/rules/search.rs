//! How candidates are fitted, ranked, named and judged.

use super::rule::Origin::{Formula, Measured, Physical, Unknown};
use super::rule::rules;

rules! {
    /// Candidates flown at a few sizes, and the fit of the promising ones.
    FitRules {
        /// Sizes, in units of the plausible, at which an effect of one parameter is flown for screening. What a run may be off by hides the part that is linear in its size (a time shift's, say): what is left looks alike on both sides of zero, so each is tried.
        tried: Vec<f64> = vec![1.0, -1.0, 4.0, -4.0], "plausible sizes", Measured("development cases of the blind benchmark: delays that come early took the name of their twin");
        /// The same of what has one side only: limits and gaps act from zero on, and not in proportion.
        tried_one_sided: Vec<f64> = vec![0.2, 1.0, 4.0], "plausible sizes", Measured("development cases of the blind benchmark: small servo rates were flown too large");
        /// Above this chi square a row beside what was found already, sizes beyond the plausible are tried.
        much_missing: f64 = 1.5, "", Unknown;
        /// Where a fit is started beside the best of these sizes, as shares of it: a little on the other side, too, where what is small was flown too large.
        starts: Vec<f64> = vec![0.5, 1.5, -0.5], "", Unknown;
        /// Steps of a fit; more while they gain `worth` of what was gained so far.
        steps: usize = 6, "", Unknown;
        /// Most steps of a fit.
        most_steps: usize = 14, "", Unknown;
        /// More than `steps` are taken while they gain this share of what was gained so far.
        worth: f64 = 0.02, "", Unknown;
        /// A step that gains less of chi square is the last.
        least_gain: f64 = 0.5, "chi square", Formula("half a log Bayes factor of a quarter: nothing is decided by it");
        /// Secants of a parameter are taken over this size from a size that is not zero.
        secant_step: f64 = 0.2, "plausible sizes", Unknown;
        /// At the end of a fit they are taken over this share of a size, towards zero.
        last_secant_share: f64 = 0.1, "", Formula("half of what values that were found may be off by: `found_value_off`");
        /// Most steps with such secants.
        last_steps: usize = 8, "", Formula("each squares what a size is off by: three or four are enough");
        /// A parameter that does nothing alone is tried beside others of this size.
        beside_size: f64 = 0.5, "plausible sizes", Unknown;
    }
}

rules! {
    /// Which candidates are fitted after screening.
    RankRules {
        /// So many candidates are fitted...
        fitted: usize = 8, "candidates", Unknown;
        /// ... and all within this share of the best in screening...
        fitted_share: f64 = 0.35, "", Unknown;
        /// ... of those that chi square would fall by at least so much with, far below any threshold...
        least_gain: f64 = 20.0, "chi square", Formula("a log Bayes factor of ten");
        /// ... and so many all the same, to be shown.
        shown: usize = 3, "candidates", Unknown;
    }
}

rules! {
    /// Which candidates the data do not tell apart.
    RivalRules {
        /// Draws of the bootstrap over runs.
        draws: usize = 400, "", Formula("a share of draws has a standard deviation of at most 2.5 %");
        /// Effects that win at least this share of draws belong to the set.
        in_set: f64 = 0.05, "", Measured("the method's prototype");
        /// A log Bayes factor within this of the best is no distinction...
        close: f64 = 5.0, "log Bayes factor", Formula("odds of 150 to one");
        /// ... nor one within this share of it.
        close_share: f64 = 0.15, "", Measured("the method's prototype");
        /// One effect of fewer parameters goes before another that is better by less than this share of what model form may account for.
        form_share: f64 = 0.25, "", Formula("what model form may account for is the largest of about a dozen directions in 139 campaigns, 3.4 standard deviations; in the one direction in which two effects differ nine campaigns of ten have less than 1.6, and the square of 1.6 is a quarter of that of 3.4");
        /// No rival has less than this share of the best log Bayes factor.
        rival_share: f64 = 0.6, "", Unknown;
    }
}

rules! {
    /// When an effect is named.
    NamingRules {
        /// Most effects that one campaign may lack.
        most_effects: usize = 4, "effects", Unknown;
        /// Real wings differ in form from the model, which flies the null campaigns: by this share of how the training loads vary, in directions that look like an effect, alone or beside others. The log Bayes factor that this may account for is added to what null campaigns show.
        model_form: f64 = 0.00104, "", Measured("139 nulls of the blind benchmark with vortices, which share nothing with the model (seed 8730000), where it accounts for 86: the largest log Bayes factor of each is 84 once, between 50 and 74 in 16 of them, less in the others");
        /// No effect needs less than this...
        least: f64 = 25.0, "log Bayes factor", Measured("539 nulls of the blind benchmark flown by the model's own library on another mesh: most effects never had more than 18");
        /// ... and a rival of one of those that were found this share of that one's.
        repair_share_of_rival: f64 = 0.2, "", Measured("development cases of the blind benchmark");
        /// What had less than this share of an effect's log Bayes factor is not ranked in its place again when more was found.
        considered: f64 = 0.2, "", Unknown;
        /// An effect named with so many times the log Bayes factor of a later one is not replaced because of it.
        firm: f64 = 10.0, "", Unknown;
        /// Where no candidate wins this share of draws together with its rivals in the library, none is named.
        wins: f64 = 0.35, "", Unknown;
        /// Share of draws that an effect wins, and how often it was the right one: straight between. Where nothing is close to it.
        right_alone: [(f64, f64); 5] = [(0.0, 0.4), (0.45, 0.85), (0.7, 0.95), (0.9, 0.97), (1.0, 0.985)], "", Measured("development cases of the blind benchmark, corrections from other static points");
        /// The same where rivals are close.
        right_with_rivals: [(f64, f64); 5] = [(0.0, 0.3), (0.5, 0.73), (0.7, 0.75), (0.85, 0.85), (1.0, 0.97)], "", Measured("first names of both truths of the blind benchmark, seeds 8950000, 8970000, 8980000, 8990000, 8991000: of 71 with a third to .7 of the draws 53 are right (27 of 42 with vortices, 26 of 29 with doublets)");
        /// Log Bayes factor of an effect beside others over what it needed, and how much of that confidence holds of it: straight in the logarithm between. With little it may be what the form of the others lacks.
        right_beside: [(f64, f64); 2] = [(1.0, 0.5), (6.0, 1.0)], "times what is needed, share", Measured("development cases of both truths of the blind benchmark, seeds 430000 and 440000");
        /// The best effect is not named if it explains less than this share of the misfit that is too much.
        explained: f64 = 0.1, "", Unknown;
        /// None is named if all that were found explain less than this share of it.
        explained_by_all: f64 = 0.5, "", Unknown;
        /// How far values are off because no form is exact, as a share of them.
        value_form: f64 = 0.1, "", Measured("development cases of the blind benchmark: a nominal 90 % interval holds .80 of the true values with it");
        /// In the end values are taken to where the gap is least, within so many of the standard deviations that the search and the form left.
        settled_within: f64 = 2.5, "standard deviations", Formula("one in eighty normal values is further");
    }
}

impl NamingRules {
    /// How often a name with this share of draws was right.
    pub fn confidence(&self, share: f64, has_rivals: bool) -> f64 {
        let table = if has_rivals { &self.right_with_rivals } else { &self.right_alone };
        let above = table.partition_point(|(x, _)| *x < share).clamp(1, table.len() - 1);
        let ((x0, y0), (x1, y1)) = (table[above - 1], table[above]);
        y0 + (y1 - y0) * (share - x0) / (x1 - x0)
    }

    /// How much of that holds of an effect that is named beside others with so many times the log Bayes factor that it needed.
    pub fn share_beside(&self, times: f64) -> f64 {
        let [(least, low), (sure, high)] = self.right_beside;
        let part = (times.max(least) / least).ln() / (sure / least).ln();
        low + (high - low) * part.min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_beside_others_is_believed_by_its_evidence() {
        let rules = NamingRules::default();
        let [(least, low), (sure, high)] = rules.right_beside;
        assert_eq!([least, low, high], [1.0, 0.5, 1.0]);
        let shares = [0.1, least, (least * sure).sqrt(), sure, 1e6].map(|e| rules.share_beside(e));
        for (share, expected) in shares.into_iter().zip([low, low, 0.75, high, high]) {
            assert!((share - expected).abs() < 1e-12, "{shares:?}");
        }
    }
}

rules! {
    /// One size of an effect in all parts of the data.
    ConsistencyRules {
        /// Angles that span more than this pitch; others are held.
        pitching_span_rad: f64 = 0.0035, "rad", Physical("a fifth of a degree, above an encoder's noise");
        /// A part that knows its size worse than this share is left out.
        known_share: f64 = 0.25, "", Unknown;
        /// So is one that knows it so many times worse than the best: it looks at another parameter of the effect.
        times_worse: f64 = 10.0, "", Measured("development cases of the blind benchmark: what a joiner weighs in a tilt, beside its inertia");
        /// Above this chi square a degree of freedom of its size from part to part an effect is not the one named.
        scatter: f64 = 3.0, "", Measured("development cases of the blind benchmark");
        /// The same where something is left that nothing explains.
        scatter_unexplained: f64 = 1.4, "", Measured("development cases of the blind benchmark: an angle's encoder in the place of a joiner");
        /// Most that the model's form may be off by, as a share of an effect.
        form_most: f64 = 0.2, "", Unknown;
    }
}

rules! {
    /// What is found where nothing is missing.
    NullRules {
        /// Campaigns without effect that are made.
        campaigns: u64 = 20, "", Unknown;
        /// So many standard deviations above the mean of what they find lies a threshold, model form not counted.
        sigmas: f64 = 3.0, "standard deviations", Formula("one in 700 normal values is larger");
        /// Chi square a row on top of that of null campaigns before something is called missing.
        misfit_margin: f64 = 0.15, "", Unknown;
    }
}

rules! {
    /// What is said in the end.
    VerdictRules {
        /// A gap is closed that is at most so many times what is left where nothing is missing; the same on training data, above which something is missing.
        closed: f64 = 2.0, "", Physical("models are never perfect: the definition of success");
        /// An experiment that separates rivals by a smaller expected log Bayes factor is no advice.
        separated: f64 = 5.0, "log Bayes factor", Formula("odds of 150 to one");
        /// Most times that a size is doubled or halved in search of a detection limit.
        doublings: usize = 12, "", Formula("a factor of 4096");
        /// So many standard deviations wide to either side are the bands about a simulated run.
        band_sigmas: f64 = 2.0, "standard deviations", Formula("95 of 100 samples");
        /// Where the noise of a band's sample is taken from.
        band_noise_hz: f64 = 6.0, "Hz", Formula("half of `highest_hz`");
        /// Calibrations at most beside the effects.
        calibrations: usize = 8, "", Unknown;
        /// The loads of effects stay if they change by less than this share of a static point's noise.
        calibrated_same: f64 = 0.1, "standard deviations", Formula("a hundredth of the noise's variance");
    }
}

rules! {
    /// Experiments of the menu.
    ExperimentRules {
        /// Angle of attack at which runs begin.
        base_rad: f64 = 0.02, "rad", Unknown;
        /// Rest before a motion.
        rest_s: f64 = 0.5, "s", Unknown;
        /// Rest after a motion.
        after_s: f64 = 1.0, "s", Unknown;
        /// Static points of a sweep.
        points: u32 = 9, "points", Unknown;
    }
}

rules! {
    /// Where the residual sits.
    LocateRules {
        /// A surface that moves less than this rests.
        still_rad: f64 = 2e-3, "rad", Physical("an encoder's noise, many times");
        /// Ends of the map's bands.
        bands_hz: [(f64, f64); 5] = [(0.0, 1.0), (1.0, 2.0), (2.0, 4.0), (4.0, 8.0), (8.0, 12.0)], "Hz", Formula("octaves up to `highest_hz`");
        /// A cell of the map without a gap is below its limit with this probability.
        level: f64 = 0.99, "", Formula("one in a hundred");
        /// Length of a window of a chirp.
        window_s: f64 = 2.0, "s", Unknown;
        /// A window needs so many samples.
        window_samples: usize = 40, "samples", Unknown;
        /// Columns of a family of which a smaller share is left without those before are the same for this campaign.
        same_column: f64 = 0.02, "", Unknown;
        /// A family moves in units that hold more than this share of its largest unit's columns.
        moves: f64 = 1e-3, "", Unknown;
        /// A residual is beyond noise if its square is so many standard deviations of chi squared above it.
        visible: f64 = 5.0, "standard deviations", Unknown;
        /// So many kinds of maneuvers are named...
        named: usize = 2, "", Unknown;
        /// ... of those with this share of what a family gains.
        named_share: f64 = 0.1, "", Unknown;
        /// Airspeed that dynamic pressure and airspeed are referred to.
        reference_v_m_s: f64 = 30.0, "m/s", Formula("a scale alone");
        /// Rate above which its sign counts fully: far above the rate of a noisy angle.
        full_rate_rad_s: f64 = 0.2, "rad/s", Physical("rates of an encoder's noise");
        /// So many regressors are listed.
        listed: usize = 12, "", Unknown;
        /// Less than this share of a channel's residual is not listed...
        least_share: f64 = 0.01, "", Unknown;
        /// ... nor is what chance does more often.
        chance: f64 = 0.05, "", Formula("one in twenty");
    }
}
