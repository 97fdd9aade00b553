//! Sections between stations, their flexibility, and what no section can be.

use super::*;
use nastran::Span;

fn span() -> Span {
    Span::generated("test")
}

fn material(e: f64, g: f64, rho: f64) -> Mat1 {
    Mat1 { id: 4, e, g, nu: 0.3, rho, expansion: nastran::Expansion::default(), span: span() }
}

fn station(x_over_l: f64, [area, i1, i2, i12, j, nsm]: [f64; 6]) -> BeamStation {
    BeamStation { x_over_l, area, i1, i2, i12, j, nsm }
}

const SOUND: [f64; 6] = [1.0, 4.0, 9.0, 2.0, 5.0, 0.5];

fn property(stations: Vec<BeamStation>) -> BeamProperty {
    BeamProperty {
        id: 3,
        material: 4,
        stations,
        shear_factors: [0.8, 0.5],
        nsi: [1.0, 3.0],
        nsm_offset: [[0.1, 0.2], [0.5, -0.2]],
        neutral_axis: [[0.0, 1.0], [2.0, -1.0]],
        is_beam: true,
        span: span(),
    }
}

fn same(own: f64, expected: f64, what: &str) {
    assert!((own - expected).abs() < 1e-13 * (1.0 + expected.abs()), "{what}: {own} for {expected}");
}

#[test]
fn everything_is_linear_between_stations_and_constant_beyond() {
    let doubled = SOUND.map(|value| 3.0 * value);
    let of = |stations: Vec<BeamStation>, x: f64| {
        let (property, material) = (property(stations), material(7.0, 3.0, 2.0));
        let s = Section { property: &property, material: &material }.at(x);
        [s.area, s.i1, s.i2, s.i12, s.j, s.nsm]
    };
    let three = || vec![station(0.2, SOUND), station(0.6, doubled), station(0.9, SOUND)];
    // Half of the way up, three quarters of it, and half of the way down.
    for (x, factor) in
        [(0.0, 1.0), (0.2, 1.0), (0.4, 2.0), (0.5, 2.5), (0.6, 3.0), (0.75, 2.0), (0.9, 1.0), (1.0, 1.0)]
    {
        for (own, expected) in of(three(), x).iter().zip(SOUND) {
            same(*own, factor * expected, &format!("at {x}"));
        }
    }
    assert_eq!(of(vec![station(0.5, SOUND)], 0.1), SOUND);
    let (property, material) = (property(three()), material(7.0, 3.0, 2.0));
    let section = Section { property: &property, material: &material };
    assert_eq!((section.nsi(0.0), section.nsi(0.25), section.nsi(1.0)), (1.0, 1.5, 3.0));
    let (axis, line) = (section.neutral_axis(0.25), section.nsm_offset(0.75));
    for (own, expected) in [(axis.x, 0.5), (axis.y, 0.5), (line.x, 0.4), (line.y, -0.1)] {
        same(own, expected, "linear from end to end");
    }
}

/// Six points integrate powers up to the eleventh between any two kinks.
#[test]
fn points_of_integration_stand_between_stations_and_kinks() {
    let property = property(vec![station(0.0, SOUND), station(0.4, SOUND), station(1.0, SOUND)]);
    let material = material(7.0, 3.0, 2.0);
    let section = Section { property: &property, material: &material };
    let points = section.quadrature();
    assert_eq!(points.len(), 12);
    for power in 0..12 {
        let own: f64 = points.iter().map(|(x, weight)| weight * x.powi(power)).sum();
        same(own, 1.0 / f64::from(power + 1), &format!("power {power}"));
    }
    let points = section.quadrature_between(&[0.7, 0.4, 1.0, -0.3, 1.2]);
    assert_eq!(points.len(), 18, "places that are there already and places beyond count for nothing");
    let below: f64 = points.iter().filter(|(x, _)| *x < 0.7).map(|(x, weight)| weight * x).sum();
    same(below, 0.245, "up to the kink");
    let part: f64 = gauss([2.0, 5.0]).iter().map(|(x, weight)| weight * x * x).sum();
    same(part, 39.0, "of a stretch");
}

#[test]
fn strains_follow_from_forces_by_the_inverse_of_the_sections_stiffness() {
    let of = |values: [f64; 6], shear: [f64; 2]| {
        let mut property = property(vec![station(0.0, values)]);
        property.shear_factors = shear;
        let material = material(7.0, 3.0, 2.0);
        Section { property: &property, material: &material }.flexibility(0.3)
    };
    let f = of(SOUND, [0.8, 0.5]);
    same(f[(0, 0)], 1.0 / 7.0, "stretch by E A");
    same(f[(1, 1)], 1.0 / (0.8 * 3.0), "shear along y by K1 A G");
    same(f[(2, 2)], 1.0 / (0.5 * 3.0), "shear along z by K2 A G");
    same(f[(3, 3)], 1.0 / 15.0, "twist by G J");
    // Bending: E [I2 -I12; -I12 I1] on the curvatures about y and z.
    let stiff = nalgebra::Matrix2::new(9.0, -2.0, -2.0, 4.0) * 7.0;
    let unit = stiff * f.fixed_view::<2, 2>(4, 4);
    assert!((unit - nalgebra::Matrix2::identity()).amax() < 1e-14, "{unit}");
    let mut plain = SOUND;
    plain[3] = 0.0;
    let f = of(plain, [0.0, 0.0]);
    same(f[(4, 4)], 1.0 / 63.0, "about y by E I2");
    same(f[(5, 5)], 1.0 / 28.0, "about z by E I1");
    assert_eq!((f[(1, 1)], f[(2, 2)], f[(4, 5)]), (0.0, 0.0, 0.0), "rigid in shear");
    assert_eq!(of([0.0; 6], [0.8, 0.5]), Matrix6::zeros(), "nothing of what is not carried");
}

#[test]
fn a_zero_area_or_inertia_carries_none() {
    let of = |values: [f64; 6]| {
        let (property, material) = (property(vec![station(0.0, values)]), material(7.0, 3.0, 2.0));
        Section { property: &property, material: &material }.carried()
    };
    assert_eq!(of([1.0, 4.0, 9.0, 0.0, 5.0, 0.0]), [true; 6]);
    assert_eq!(of([0.0, 4.0, 9.0, 0.0, 5.0, 0.0]), [false, true, true, true, true, true]);
    assert_eq!(of([1.0, 0.0, 9.0, 0.0, 5.0, 0.0]), [true, false, true, true, true, false]);
    assert_eq!(of([1.0, 4.0, 0.0, 0.0, 5.0, 0.0]), [true, true, false, true, false, true]);
    assert_eq!(of([1.0, 4.0, 9.0, 0.0, 0.0, 0.0]), [true, true, true, false, true, true]);
}

fn check(stations: Vec<BeamStation>, shear: [f64; 2], material: &Mat1) -> Result<(), String> {
    let mut property = property(stations);
    property.shear_factors = shear;
    Section { property: &property, material }.check().map_err(|error| error.to_string())
}

fn one(values: [f64; 6]) -> Vec<BeamStation> {
    vec![station(0.0, values)]
}

#[test]
fn what_no_section_can_be_is_refused_by_what_is_wrong() {
    let with = |at: usize, value: f64| {
        let mut values = SOUND;
        values[at] = value;
        if at < 3 {
            values[3] = 0.0;
        }
        values
    };
    let (sound, none) = (material(7.0, 3.0, 2.0), [0.0; 2]);
    assert_eq!(check(one(SOUND), [0.8, 0.5], &sound), Ok(()));
    assert_eq!(check(one([0.0; 6]), none, &material(0.0, 0.0, 0.0)), Ok(()), "nothing needs no modulus");
    let two = |a: [f64; 6], b: [f64; 6]| vec![station(0.0, a), station(1.0, b)];
    let refused = [
        (Vec::new(), none, "it has no station"),
        (vec![station(0.0, SOUND), station(0.0, SOUND)], none, "not in ascending x/L"),
        (vec![station(0.5, SOUND), station(0.2, SOUND)], none, "not in ascending x/L"),
        (one(with(0, -1.0)), none, "A is negative"),
        (one(with(1, -1.0)), none, "I1 is negative"),
        (one(with(2, f64::INFINITY)), none, "I2 is negative"),
        (one(with(4, f64::NAN)), none, "J is negative"),
        (two(SOUND, with(0, 0.0)), none, "A is zero at one station and positive at another"),
        (two(with(4, 0.0), SOUND), none, "J is zero at one station and positive at another"),
        // Two times 3 is the root of 36.
        (one(with(3, 6.0)), none, "I1 I2 is not greater than I12 squared"),
        (one(with(3, -6.5)), none, "I1 I2 is not greater than I12 squared"),
        (one(SOUND), [0.8, -0.1], "a shear factor is negative"),
        (one(SOUND), [-0.1, 0.5], "a shear factor is negative"),
    ];
    for (stations, shear, said) in refused {
        let error = check(stations, shear, &sound).expect_err(said);
        assert!(error.contains("beam property 3") && error.contains(said), "{error}");
    }
    assert_eq!(check(one(with(3, 5.9)), none, &sound), Ok(()));
    assert_eq!(check(two(SOUND, with(1, 1e-3)), none, &sound), Ok(()));
}

/// E by area or inertias, G by torsion or shear.
#[test]
fn moduli_are_needed_for_what_a_section_carries() {
    let none = [0.0; 2];
    let only = |at: usize| {
        let mut values = [0.0; 6];
        values[at] = 1.0;
        one(values)
    };
    for (stations, shear, [e, g, rho]) in [
        (only(0), none, [0.0, 3.0, 2.0]),
        (only(1), none, [0.0, 3.0, 2.0]),
        (only(2), none, [-1.0, 3.0, 2.0]),
        (only(0), [0.0, 0.8], [7.0, -3.0, 2.0]),
        (only(0), none, [7.0, 3.0, -1e-9]),
    ] {
        let error = check(stations, shear, &material(e, g, rho)).expect_err("a modulus is missing");
        assert!(error.contains("material 4 has E"), "{error}");
    }
    for stations in [only(0), only(1), only(2)] {
        assert_eq!(
            check(stations, none, &material(7.0, 0.0, 0.0)),
            Ok(()),
            "no G for what it does not carry"
        );
    }
    assert_eq!(check(only(4), none, &material(0.0, 3.0, 0.0)), Ok(()), "no E for torsion alone");
    // A deck's beams do without G, which a wing's are refused for.
    for (stations, shear) in [(only(4), none), (only(0), [0.8, 0.0]), (only(0), [0.0, 0.8])] {
        let mut property = property(stations.clone());
        property.shear_factors = shear;
        let bare = material(7.0, 0.0, 2.0);
        let section = Section { property: &property, material: &bare };
        assert_eq!((check(stations, shear, &bare), section.carried()[3]), (Ok(()), false));
        assert!(section.check_shear().is_err());
    }
}
