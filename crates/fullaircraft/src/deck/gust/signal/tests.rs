//! Functions of dynamic loads: their transforms in closed form, and their values where they begin and end.

use super::{Signal, by_rule, grown, of_lines, unit};
use faer::c64;
use nastran::{BulkData, parse_deck};
use std::f64::consts::{PI, TAU};

fn near(what: &str, ours: c64, law: c64, share: f64) {
    assert!((ours - law).norm() <= share * law.norm().max(1e-9), "{what}: {ours}, the law says {law}");
}

fn deck(cards: &str) -> BulkData {
    let bulk = parse_deck("t.bdf", cards).expect("a deck");
    assert!(bulk.air_errors.is_empty(), "{:?}", bulk.air_errors);
    bulk
}

#[test]
fn a_growing_wave_s_integral_is_its_closed_form_and_its_series() {
    let s = c64::new(0.5, 3.0);
    // (e^1 e^{6 i} - 1)/s
    let law = (c64::new(6.0_f64.cos(), 6.0_f64.sin()) * 1.0_f64.exp() - 1.0) / s;
    near("two seconds", grown(s, 2.0), law, 1e-14);
    // length + s length²/2 + s² length³/6 + s³ length⁴/24, wherever the way changes
    for size in [0.3e-3, 0.999e-3, 1.001e-3, 3e-3] {
        let (s, length) = (c64::new(0.6, 0.8) * (size / 4.0), 4.0);
        let z = s * length;
        let law =
            (c64::from(1.0) + z / 2.0 + z * z / 6.0 + z * z * z / 24.0 + z * z * z * z / 120.0) * length;
        near("a short one", grown(s, length), law, 2e-12);
    }
    near("no change", grown(c64::from(0.0), 4.0), c64::from(4.0), 1e-15);
}

#[test]
fn a_straight_line_s_transform_is_that_of_its_level_and_its_ramp() {
    // int (2 + 3 t) exp(-i w t) dt from 1 to 3 by parts
    let law = |w: f64| {
        let (f, slope) = (|t: f64| c64::from(2.0 + 3.0 * t), c64::from(3.0));
        let i = c64::new(0.0, w);
        let primitive = |t: f64| -(f(t) / i + slope / (i * i)) * unit(-w * t);
        primitive(3.0) - primitive(1.0)
    };
    for w in [0.4, 2.0, 37.0] {
        near("one line", of_lines(&[(1.0, 5.0), (3.0, 11.0)], w), law(w), 1e-12);
        // a third point on the line changes nothing, and a step has no area
        let three = [(1.0, 5.0), (1.5, 6.5), (3.0, 11.0), (3.0, 4.0)];
        near("two lines", of_lines(&three, w), law(w), 1e-12);
    }
    // moments of the line: area 16, first moment int t (2 + 3 t) = 34, second int t² (2 + 3 t) = 232/3
    for w in [0.0, 1e-5, 4e-4, 4.99e-4, 5.01e-4, 1e-3] {
        let law = c64::new(16.0 - w * w * (52.0 / 3.0 + 60.0) / 2.0, -34.0 * w);
        near("slow", of_lines(&[(1.0, 5.0), (3.0, 11.0)], w), law, 2e-8);
    }
    assert_eq!(of_lines(&[(1.0, 5.0)], 1.0), c64::from(0.0));
}

#[test]
fn the_rule_integrates_polynomials_and_waves_over_the_whole_length() {
    near("a cube", by_rule(&|t| t * t * t, 2.0, 1.0, 0.0), c64::from(4.0), 1e-13);
    // int t exp(-i w t) dt from 0 to L = (exp(-i w L)(1 + i w L) - 1)/w²
    for (w, length) in [(1.0, 2.0), (40.0, 9.0), (900.0, 1.5)] {
        let turn = w * length;
        let law = (unit(-turn) * c64::new(1.0, turn) - 1.0) / (w * w);
        near("a ramp", by_rule(&|t| t, length, w, w), law, 1e-9);
    }
}

#[test]
fn a_wave_with_a_power_of_time_has_the_transform_of_laplace() {
    // int t exp((c + i turn - i w) t) dt: two seconds of a wave at 0.7 Hz that decays by 0.4/s, a second late, with a
    // phase of 30 degrees
    let bulk = deck("TLOAD2,1,9,.25,,1.,3.,.7,30.\n,-.4,1.\nTLOAD2,2,9,.25,,1.,3.,.7,30.\n,-.4,0.\n");
    for w in [0.0, 1.0, TAU * 0.7, 12.0] {
        let half = |sign: f64, power: i32| {
            let s = c64::new(-0.4, sign * TAU * 0.7 - w);
            let end = unit(s.im * 2.0) * (2.0 * s.re).exp();
            let own = if power == 1 { (end * (s * 2.0 - 1.0) + 1.0) / (s * s) } else { (end - 1.0) / s };
            own * unit(sign * PI / 6.0) * 0.5
        };
        for (set, power) in [(1, 1), (2, 0)] {
            let law = (half(1.0, power) + half(-1.0, power)) * unit(-w * 1.25);
            let signal = Signal::of(&bulk, set).expect("a load");
            near(&format!("power {power} at {w} rad/s"), signal.transform(&bulk, w), law, 1e-9);
        }
    }
}

#[test]
fn waves_and_tables_are_nothing_before_they_begin_and_after_they_end() {
    let bulk = deck(
        "TLOAD2,1,9,.5,,1.,3.,.25,90.\n,.2,2.\nTLOAD1,2,9,.5,,7\nTABLED1,7\n,1.,4.,3.,-2.,ENDT\n\
         TLOAD1,3,9,,,8\nTABLED2,8,10.\n,1.,4.,3.,-2.,ENDT\nDLOAD,4,2.,1.,1,-3.,2\n",
    );
    let at = |set: u32, t: f64| Signal::of(&bulk, set).expect("a load").at(&bulk, t);
    // since² exp(.2 since) cos(2 pi .25 since + 90 degrees), 1.5 s late
    let wave = |since: f64| -since * since * (0.2 * since).exp() * (0.5 * PI * since).sin();
    assert_eq!([at(1, 1.4), at(1, 3.6), at(2, 1.4), at(2, 3.6), at(3, 10.9), at(3, 13.1)], [0.0; 6]);
    for since in [0.3, 1.0, 1.9] {
        assert!((at(1, 1.5 + since) - wave(since)).abs() < 1e-13, "{since} s after its begin");
        assert!((at(2, 1.5 + since) - (4.0 - 3.0 * since)).abs() < 1e-13);
        assert!((at(3, 11.0 + since) - (4.0 - 3.0 * since)).abs() < 1e-12, "X1 is added to a table's times");
        let law = 2.0 * wave(since) - 6.0 * (4.0 - 3.0 * since);
        assert!((at(4, 1.5 + since) - law).abs() < 1e-12, "a sum with its factors");
    }
    assert_eq!([at(2, 1.5), at(2, 3.5)], [4.0, -2.0]);
    assert_eq!(Signal::of(&bulk, 4).expect("a sum").is_in_time(), Some(true));
}

#[test]
fn loads_over_frequency_lead_by_their_phase_and_lag_by_their_delay() {
    let bulk = deck(
        "RLOAD1,1,9,.1,30.,7,8\nRLOAD2,2,9,.1,30.,7,8\nTABLED1,7\n,0.,1.,10.,3.,ENDT\nTABLED1,8\n,0.,0.,10.,20.,ENDT\n\
         TLOAD1,3,9,,,7\nDLOAD,4,1.,1.,1,1.,3\n",
    );
    let of = |set: u32| Signal::of(&bulk, set).expect("a load");
    for hz in [0.0, 2.5, 9.0] {
        let later = unit(PI / 6.0 - TAU * hz * 0.1);
        let (first, second) = (1.0 + 0.2 * hz, 2.0 * hz);
        near("parts", of(1).transform(&bulk, TAU * hz), c64::new(first, second) * later, 1e-12);
        let polar = unit(second.to_radians()) * first * later;
        near("polar", of(2).transform(&bulk, TAU * hz), polar, 1e-12);
    }
    assert_eq!(of(1).at(&bulk, 1.0), 0.0);
    assert_eq!([of(1).is_in_time(), of(4).is_in_time()], [Some(false), None]);
    assert_eq!(Signal { parts: Vec::new() }.is_in_time(), None);
    assert!(Signal::of(&bulk, 6).expect_err("not there").to_string().contains("no TLOAD or RLOAD 6"));
}
