//! At rest, and with loads that turn the wing in the stream.

use super::*;

#[test]
fn places_along_the_span_lie_between_two_zones_or_straight_beyond() {
    let zones = small(25.0).zones;
    for (y, left, share) in
        [(0.6, 1, 0.25), (0.2, 0, 0.0), (0.35, 0, 0.5), (0.0, 0, -2.0 / 3.0), (1.0, 1, 1.25)]
    {
        let [(a, first), (b, second)] = zones.about(y);
        assert_eq!((a, b), (left, left + 1), "{y}");
        assert!((second - share).abs() < 1e-12 && (first + second - 1.0).abs() < 1e-12, "{y}: {second}");
    }
    let alone = Zones { y_norm: vec![0.5], boxes: vec![vec![0]], ..Zones::default() };
    assert_eq!(alone.about(0.7), [(0, 1.0), (0, 0.0)]);
    assert!(!alone.is_empty() && alone.len() == 1 && Zones::default().is_empty());
}

#[test]
fn at_rest_constants_load_the_wing_and_its_loads_turn_it() {
    let (_, _, mut change) = body();
    (change.pressure, change.mass, change.zone_force) = (0.1, 0.2, vec![0.0, 0.3, -0.1]);
    let constants = Constants { moment_coefficient: 0.05, upwash_rad_m: 0.3 };
    let rom = small(25.0);
    let g = [1.3e-3, 0.0, -2.1e-3];
    let total = &rom.air + &rom.zone_air[1] * faer::Scale(0.3) + &rom.zone_air[2] * faer::Scale(-0.1);
    let z = at(&total, c64::from(0.0), 25.0);
    let constant = |row: usize| {
        let moments: f64 = (0..3).map(|zone| rom.unit_moment[(row, zone)]).sum();
        1.1 * (total[(row, ONE)] + 0.05 * moments + 0.3 * rom.unit_upwash[row])
    };
    let stiffness = Mat::from_fn(3, 3, |i, j| {
        c64::from(if i == j { rom.omega_rad_s[i].powi(2) } else { 0.0 }) - z[(i, j)] * 1.1
    });
    let xi = stiffness.partial_piv_lu().solve(Mat::from_fn(3, 1, |i, _| c64::from(constant(i))));
    let by = |of: &dyn Fn(usize) -> f64| (0..3).map(|k| of(k) * xi[(k, 0)].re).sum::<f64>();
    let tare = Structural::new(&rom, &change);
    let mut open: Vec<f64> = (0..3)
        .map(|row| {
            let masses = 1.2 * rom.inertia[(row, ONE)] + tare.points_tare(row, 9.81);
            constant(3 + row) + by(&|k| 1.1 * z[(3 + row, k)].re) + masses
        })
        .collect();
    open.push(rom.tip[(0, ONE)] + by(&|k| rom.tip[(0, k)]));
    open.extend((0..3).map(|zone| {
        let factor = 1.1 * (1.0 + change.zone_force[zone]);
        factor * (rom.lift[(zone, ONE)] + by(&|k| rom.lift[(zone, k)]))
    }));
    open.extend((0..3).map(|zone| by(&|k| rom.heights[(zone, k)])));
    open.extend((0..3).map(|zone| by(&|k| rom.twists[(zone, k)])));
    let response = rom.responses(&change, &[0.0], true)[0].clone();
    let near = |ours: &[f64], wanted: &[f64]| ours.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-10);
    let (all, few) = (rom.at_rest(&change, &constants, true), rom.at_rest(&change, &constants, false));
    assert!(all.len() == 13 && near(&all, &open), "{all:?} {open:?}");
    assert!(few.len() == 4 && near(&few, &open), "{few:?} {open:?}");
    // y = open + H (g y)
    (change.incidence_by_fz, change.incidence_by_my) = (g[0], g[2]);
    for everything in [true, false] {
        let closed = rom.at_rest(&change, &constants, everything);
        let incidence: f64 = g.iter().zip(&closed).map(|(gain, load)| gain * load).sum();
        let wanted: Vec<f64> =
            (0..13).map(|row| open[row] + response[(row, Drive::INCIDENCE)].re * incidence).collect();
        assert!(near(&closed, &wanted), "{closed:?} {wanted:?}");
    }
}

#[test]
fn loads_that_turn_the_wing_close_a_loop_around_its_responses() {
    let rom = small(25.0);
    for (fz, my) in [(2e-2, 0.0), (0.0, -3e-2), (1e-2, 2e-2)] {
        let change = Change { incidence_by_fz: fz, incidence_by_my: my, ..none() };
        let (open, closed) = (rom.responses(&none(), &OMEGAS, true), rom.responses(&change, &OMEGAS, true));
        for (open, closed) in open.iter().zip(&closed) {
            let turned = |drive: usize| closed[(0, drive)] * fz + closed[(2, drive)] * my;
            let wanted = Mat::from_fn(13, 11, |row, drive| {
                open[(row, drive)] + open[(row, Drive::INCIDENCE)] * turned(drive)
            });
            assert_near(closed, &wanted, "loop");
        }
    }
}
