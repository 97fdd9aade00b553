//! True wings: what a wing that was built is off its drawing by, drawn from a seed. The README argues the sizes.

use crate::drive::Servo;
use crate::profile::Profile;
use crate::random::{Purpose, Random};
use crate::setting::Setting;
use crate::wing::Wing;
use std::f64::consts::PI;

/// How many true wings there are; a case flies one of them.
pub const WINGS: u64 = 20;

/// Relative standard deviations of a whole wing, and of its places along the span: stiffness, mass, lift slope.
const BENDING: (f64, f64) = (0.02, 0.02);
const TORSION: (f64, f64) = (0.04, 0.03);
const MASS: (f64, f64) = (0.01, 0.02);
const SLOPE: (f64, f64) = (0.015, 0.015);
/// Standard deviations of the angle of zero lift (built twist), degrees.
const ZERO_DEG: (f64, f64) = (0.15, 0.1);
/// Of the place of mass and of lift, share of the chord, and of lumps, m.
const MASS_AFT: (f64, f64) = (0.004, 0.004);
const LIFT_AFT: (f64, f64) = (0.002, 0.002);
const LUMPS_M: (f64, f64) = (0.004, 0.003);
/// Of moment coefficients of sections.
const MOMENT: (f64, f64) = (0.002, 0.001);
/// Effect of a flap with a gap, and its standard deviation.
const FLAP: (f64, f64) = (0.94, 0.02);
/// Damping: standard deviation of its logarithm, of all modes and of each; largest growth by amplitude.
const DAMPING: (f64, f64) = (0.2, 0.15);
const GROWTH: f64 = 0.15;
/// Largest play of the root, degrees.
const SLACK_DEG: f64 = 0.02;
/// What a correction for walls leaves, rad for a lift coefficient of one.
const WALL_RAD: f64 = 0.003;
/// Of the airspeed.
const AIRSPEED: f64 = 0.002;
/// Modes with damping of their own.
const MODES: usize = 8;
/// Waves along the span of which what varies from place to place is made.
const WAVES: u32 = 6;

/// What varies along the span: waves that fade with their number, of standard deviation one altogether.
fn varying(random: &mut Random) -> impl Fn(f64) -> f64 + use<> {
    let waves: Vec<(f64, f64)> =
        (1..=WAVES).map(|n| (PI * f64::from(n), random.normal(1.0 / f64::from(n).sqrt()))).collect();
    let whole: f64 = (1..=WAVES).map(|n| 0.5 / f64::from(n)).sum();
    move |eta| waves.iter().map(|(turns, size)| size * (turns * eta).cos()).sum::<f64>() / whole.sqrt()
}

/// A profile about a middle: off altogether, and from place to place.
pub(crate) fn off(middle: f64, sigma: (f64, f64), random: &mut Random) -> Profile {
    let all = random.bounded(sigma.0);
    let place = varying(random);
    Profile::of(|eta| middle + all + sigma.1 * place(eta).clamp(-3.0, 3.0))
}

/// The true wing of a number.
pub fn true_wing(wing: &Wing, number: u64) -> Setting {
    let random = &mut Random::new(number % WINGS, Purpose::Wing);
    let mut setting = Setting::drawn(wing.damping_ratio, wing.controls.len());
    setting.bending = off(1.0, BENDING, random);
    setting.torsion = off(1.0, TORSION, random);
    setting.mass = off(1.0, MASS, random);
    setting.mass_aft_over_c = off(0.0, MASS_AFT, random);
    setting.lumps_moved_m = (random.bounded(LUMPS_M.0), random.bounded(LUMPS_M.1));
    setting.slope = off(1.0, SLOPE, random);
    setting.zero_rad = off(0.0, (ZERO_DEG.0.to_radians(), ZERO_DEG.1.to_radians()), random);
    setting.aft_over_c = off(0.0, LIFT_AFT, random);
    setting.moment = off(0.0, MOMENT, random);
    setting.flap.iter_mut().for_each(|flap| *flap = FLAP.0 + random.bounded(FLAP.1));
    let all = random.bounded(DAMPING.0);
    setting.damping =
        (0..MODES).map(|_| wing.damping_ratio * (all + random.bounded(DAMPING.1)).exp()).collect();
    setting.damping_growth = GROWTH * random.unit();
    setting.slack_rad = SLACK_DEG.to_radians() * random.unit();
    setting.wall_rad = random.bounded(WALL_RAD);
    setting.airspeed = 1.0 + random.bounded(AIRSPEED);
    setting
}

/// The servo of a case: about as late as the assumed one of 15 Hz and 0.8, stiffer or softer.
pub(crate) fn servo(seed: u64) -> Servo {
    let random = &mut Random::new(seed, Purpose::Case);
    Servo { frequency_hz: 14.0 * (1.0 + random.bounded(0.03)), damping_ratio: 0.73 + 0.08 * random.unit() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;
    use std::path::Path;

    /// The delay of a ramp is 2 zeta / w; that of the servo that is assumed (15 Hz, 0.8) is 17 ms.
    #[test]
    fn servos_are_late_by_what_is_assumed_within_three_milliseconds() {
        let late_s = |seed: u64| {
            let servo = servo(seed);
            2.0 * servo.damping_ratio / (TAU * servo.frequency_hz)
        };
        let all: Vec<f64> = (0..200).map(late_s).collect();
        let mean = all.iter().sum::<f64>() / 200.0;
        assert!((mean - 0.017).abs() < 0.001, "{mean}");
        assert!(all.iter().all(|late| (late - 0.017).abs() < 0.003));
    }

    /// Standard deviations over many draws are those that the README argues.
    #[test]
    fn stiffness_varies_along_the_span_as_said() {
        let mut random = Random::new(5, Purpose::Wing);
        let draws: Vec<f64> = (0..4000).map(|_| off(1.0, (0.0, 0.02), &mut random).at(0.37) - 1.0).collect();
        let sigma = (draws.iter().map(|value| value * value).sum::<f64>() / 4000.0).sqrt();
        assert!((0.012..0.026).contains(&sigma), "{sigma}");
    }

    #[test]
    fn twenty_wings_differ_and_repeat() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex/wing_beam.ron");
        let wing = Wing::read(&path).unwrap();
        assert!(true_wing(&wing, 3) == true_wing(&wing, 3 + WINGS));
        assert!((1..WINGS).all(|number| true_wing(&wing, number) != true_wing(&wing, 0)));
    }
}
