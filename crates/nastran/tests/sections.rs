//! PBARL and PBEAML against closed forms of their sections.

use nastran::{BeamProperty, parse_deck};
use std::f64::consts::PI;

fn bar(name: &str, dimensions: &str) -> BeamProperty {
    let deck = parse_deck("t.bdf", &format!("PBARL,1,2,,{name}\n,{dimensions}\n"));
    deck.unwrap_or_else(|error| panic!("{error}")).beam_properties[&1].clone()
}

fn beam(name: &str, dimensions: &str) -> BeamProperty {
    let deck = parse_deck("t.bdf", &format!("PBEAML,1,2,MSCBML0,{name}\n,{dimensions}\n"));
    deck.unwrap_or_else(|error| panic!("{error}")).beam_properties[&1].clone()
}

fn near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance * expected.abs(), "{value} is not {expected}");
}

#[test]
fn circles() {
    let rod = bar("ROD", ".2,5.");
    let s = rod.stations[0];
    near(s.area, PI * 0.04, 1e-15);
    near(s.i1, PI / 4.0 * 0.0016, 1e-15);
    near(s.j, PI / 2.0 * 0.0016, 1e-15);
    assert_eq!((s.i2, s.i12, s.nsm, rod.shear_factors), (s.i1, 0.0, 5.0, [0.9, 0.9]));
    // A thin tube: A = 2 pi r t, I = pi r^3 t, J = 2 pi r^3 t.
    for (name, dimensions) in [("TUBE", "1.0005,.9995"), ("TUBE2", "1.0005,.001")] {
        let s = bar(name, dimensions).stations[0];
        near(s.area, 2.0 * PI * 1e-3, 1e-12);
        near(s.i1, PI * 1e-3, 1e-6);
        near(s.j, 2.0 * PI * 1e-3, 1e-6);
    }
}

#[test]
fn rectangles_and_boxes() {
    let s = bar("BAR", ".1,.3").stations[0];
    near(s.i1, 0.1 * 0.027 / 12.0, 1e-14);
    near(s.i2, 0.3 * 0.001 / 12.0, 1e-14);
    // Timoshenko and Goodier, Theory of Elasticity, torsion of rectangular bars: J = k a^3 b.
    for (height, factor) in [(".1", 0.1406), (".2", 0.229), (".3", 0.263), (".4", 0.281), ("1.", 0.312)] {
        let j = bar("BAR", &format!(".1,{height}")).stations[0].j;
        near(j, factor * 1e-3 * height.parse::<f64>().expect("a number"), 5e-3);
    }
    let s = bar("BOX", ".4,.2,.01,.02").stations[0];
    near(s.area, 0.4 * 0.2 - 0.36 * 0.18, 1e-14);
    near(s.i1, (0.4 * 0.008 - 0.36 * 0.18_f64.powi(3)) / 12.0, 1e-13);
    near(s.i2, (0.2 * 0.064 - 0.18 * 0.36_f64.powi(3)) / 12.0, 1e-13);
    // A square box of one thickness, Bredt: J = t b^3 with b between mid-lines.
    near(bar("BOX", ".11,.11,.01,.01").stations[0].j, 0.01 * 1e-3, 1e-12);
}

#[test]
fn flanged_sections() {
    // Symmetric I: a rectangle less two others.
    let i_beam = bar("I", ".2,.1,.1,.006,.01,.01");
    let s = i_beam.stations[0];
    near(s.i1, (0.1 * 0.008 - 0.094 * 0.18_f64.powi(3)) / 12.0, 1e-13);
    near(s.i2, (0.02 * 0.001 + 0.18 * 0.006_f64.powi(3)) / 12.0, 1e-13);
    near(s.j, (0.2 * 1e-6 + 0.19 * 0.006_f64.powi(3)) / 3.0, 1e-13);
    near(i_beam.shear_factors[0], 0.18 * 0.006 / s.area, 1e-13);
    near(i_beam.shear_factors[1], 0.2 * 0.01 / (1.2 * s.area), 1e-13);
    // T is an I without its lower flange: about the upper edge, y^2 A by hand.
    let tee = beam("T", ".1,.2,.01,.006");
    let s = tee.stations[0];
    let (flange, stem) = (0.1 * 0.01, 0.19 * 0.006);
    let centre = (flange * 0.005 + stem * 0.105) / (flange + stem);
    let about_edge = 0.1 * 1e-6 / 3.0 + 0.006 * (0.008 - 1e-6) / 3.0;
    near(s.i1, about_edge - s.area * centre * centre, 1e-12);
    near(tee.neutral_axis[0][0], 0.005 - centre, 1e-12);
    assert_eq!(tee.neutral_axis[1], tee.neutral_axis[0]);
    assert_eq!(bar("T", ".1,.2,.01,.006").neutral_axis, [[0.0; 2]; 2], "a bar has no such offset");
}

#[test]
fn channels_and_angles() {
    // A rectangle less the one inside its open side.
    let channel = beam("CHAN", ".05,.1,.004,.006");
    let s = channel.stations[0];
    near(s.area, 0.05 * 0.1 - 0.046 * 0.088, 1e-13);
    near(s.i1, (0.05 * 1e-3 - 0.046 * 0.088_f64.powi(3)) / 12.0, 1e-12);
    let from_web_face = (0.005 * 0.025 - 0.046 * 0.088 * 0.027) / s.area;
    let about_face = 0.1 * 0.05_f64.powi(3) / 3.0 - 0.088 * (0.05_f64.powi(3) - 0.004_f64.powi(3)) / 3.0;
    near(s.i2, about_face - s.area * from_web_face.powi(2), 1e-12);
    // Thin channel, Timoshenko: the shear centre lies e = b^2 h^2 t / (4 I) behind the web.
    let thin = beam("CHAN", ".0505,.101,.001,.001");
    let (b, h, t) = (0.05_f64, 0.1_f64, 0.001);
    let inertia = t * h.powi(3) / 12.0 + 2.0 * b * t * (h / 2.0).powi(2);
    let expected = b * b * h * h * t / (4.0 * inertia) + b * b / (2.0 * b + h);
    near(thin.neutral_axis[0][1], expected, 1e-2);
    // An angle of equal legs: its principal axes stand at 45 degrees, I1 = I2, and the product is negative.
    let angle = beam("L", ".1,.1,.01,.01");
    let s = angle.stations[0];
    near(s.area, 0.1 * 0.1 - 0.09 * 0.09, 1e-13);
    near(s.i1, s.i2, 1e-13);
    let centre = (0.01 * 0.05 - 0.0081 * 0.055) / s.area;
    let about_edge = (0.1 * 1e-3 - 0.09 * (1e-3 - 1e-6)) / 3.0;
    near(s.i1, about_edge - s.area * centre * centre, 1e-12);
    let product = 0.01 * 0.05_f64.powi(2) - 0.0081 * 0.055_f64.powi(2);
    near(s.i12, product - s.area * centre * centre, 1e-10);
    assert!(s.i12 < 0.0);
    near(angle.neutral_axis[0][0], centre - 0.005, 1e-10);
}

#[test]
fn tapered_beams() {
    let tapered = beam("BAR", ".1,.3,1.,NO,.5,.1,.2,2.\n,YES,1.,.1,.1,3.");
    let heights: Vec<f64> = tapered.stations.iter().map(|s| s.area / 0.1).collect();
    for (height, expected) in heights.iter().zip([0.3, 0.2, 0.1]) {
        near(*height, expected, 1e-14);
    }
    assert_eq!(tapered.stations.iter().map(|s| s.nsm).collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
    let uniform = beam("ROD", ".1");
    assert_eq!((uniform.stations.len(), uniform.stations[0].area), (2, uniform.stations[1].area));
    assert!(uniform.is_beam);
}

#[test]
fn sections_that_are_not_read_are_named() {
    let error = parse_deck("t.bdf", "PBARL,1,2,,HAT\n,1.,.1,1.,1.\n").expect_err("not read");
    assert_eq!(error.message, "section HAT of PBARL is not read");
    let error = parse_deck("t.bdf", "PBARL,1,2,,BOX\n,1.,1.,.5,.1\n").expect_err("no room inside");
    assert_eq!(error.message, "the dimensions of section BOX in PBARL do not fit together");
}
