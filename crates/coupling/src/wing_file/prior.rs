//! What corrections are expected to be before any data.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One standard deviation of what the panel model is off by before any data: what intervals of predictions rest on.
///
/// Defaults: force factors after the lift slopes of section polars (0.85 to 1.1 of theory's) and the measured spanwise lift of
/// the shipped swept wing (within 5 %, 15 % at the tip); the centre of lift within 0.05 chords; zero-lift angles within a degree
/// or two; stiffness as a bending test leaves it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CorrectionPrior {
    /// Of the force factor: common to the whole span, smooth along it, local. The default along the span is somewhat more than the 4 % of the
    /// one wing whose lift along it was measured (Weber and Brebner).
    pub force: [f64; 3],
    /// Of the force factor's growth from leading to trailing edge, smooth along the span.
    pub force_along_chord: f64,
    /// Of the zero-lift angle, as pressures of so much angle of attack: common, smooth, local.
    pub zero_lift_deg: [f64; 3],
    /// Of a pressure offset with a moment and no lift, as Cp at the leading edge, smooth along the span.
    pub moment_offset_cp: f64,
    /// Of the moment factor of the boxes, smooth along the span.
    pub moment: f64,
    /// Of the factor on what control surfaces do: common to all, of each, and of each in one load of the balance alone (where on the
    /// wing it acts). Gaps and boundary layers take 5 to 15 % of a plain flap's theoretical lift.
    pub control: [f64; 3],
    /// Of the logarithm of the structure's flexibility: in bending, in torsion.
    pub flexibility: [f64; 2],
    /// Of what any reading is off by, as a share of it, whatever the corrections are: lattices of other programs differ by so
    /// much.
    pub reading: f64,
    /// Of the factor on all that air does beyond the steady answer to the momentary incidence, for flutter. No load at rest tells
    /// it; a tenth is assumed.
    pub unsteady: f64,
    /// Of the lift in free air over that in the tunnel's stream, less one: for flight alone, as no load in the tunnel tells it. Default:
    /// a quarter of what walls of a closed section do to a half model (0.003 rad for a lift coefficient of one), and 0.2 % of the airspeed.
    pub stream: f64,
    /// How alike corrections of two airspeeds are where more than root loads was measured: their correlation falls as
    /// `exp(-|ln V1/V2| / airspeeds_alike)`. Default: sections of `data/tuflex` lose 5 % of lift slope and .6 degrees of zero lift for
    /// .85 in the logarithm, .7 of the standard deviations above. 0: every airspeed for itself.
    pub airspeeds_alike: f64,
    /// Length over which smooth parts are alike, as a share of the span.
    pub smooth_over_span: f64,
    /// Length over which local parts are alike, in mean chords; they may have steps.
    pub local_over_chord: f64,
}

impl Default for CorrectionPrior {
    fn default() -> Self {
        Self {
            force: [0.08, 0.035, 0.045],
            force_along_chord: 0.2,
            zero_lift_deg: [0.8, 0.4, 0.35],
            moment_offset_cp: 0.05,
            moment: 0.2,
            control: [0.05, 0.03, 0.03],
            flexibility: [0.03, 0.05],
            reading: 0.0015,
            unsteady: 0.1,
            stream: 0.015,
            airspeeds_alike: 2.5,
            smooth_over_span: 0.3,
            local_over_chord: 1.0,
        }
    }
}

impl CorrectionPrior {
    /// Names, values, and the least they may be.
    pub(super) fn values(&self) -> Vec<(&'static str, f64, f64)> {
        let three = |name, values: [f64; 3]| values.map(|value| (name, value, 0.0));
        let single = [
            ("force_along_chord", self.force_along_chord, 0.0),
            ("moment_offset_cp", self.moment_offset_cp, 0.0),
            ("moment", self.moment, 0.0),
            ("reading", self.reading, 0.0),
            ("unsteady", self.unsteady, 0.0),
            ("stream", self.stream, 0.0),
            ("airspeeds_alike", self.airspeeds_alike, 0.0),
            ("smooth_over_span", self.smooth_over_span, 0.01),
            ("local_over_chord", self.local_over_chord, 0.01),
        ];
        let fields = [
            three("force", self.force),
            three("zero_lift_deg", self.zero_lift_deg),
            three("control", self.control),
        ];
        let flexibility = self.flexibility.map(|value| ("flexibility", value, 0.0));
        fields.into_iter().flatten().chain(flexibility).chain(single).collect()
    }

    /// Whether a file need not say it.
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}
