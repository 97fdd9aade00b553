//! Deflections against closed forms of beam theory.

use crate::common::{AREA, E, G, I, at, beam, close, displaced, section, system};

fn cantilever() -> structure::System {
    system(&(beam(1, 5, 2.0, 0.0) + &section() + "SPC1,1,123456,1\n"))
}

#[test]
fn a_tip_force_bends_a_cantilever_by_pl3_over_3ei_in_its_own_plane() {
    let system = cantilever();
    let u = displaced(&system, &[(6, 3, 5.0)]);
    // Plane 1 is y-z: a force along z meets I1.
    close(at(&system, &u, 6, 3), 5.0 * 8.0 / (3.0 * E * I[0]), 1e-10, "deflection");
    close(at(&system, &u, 6, 4), 5.0 * 4.0 / (2.0 * E * I[0]), 1e-10, "slope");
    let u = displaced(&system, &[(6, 1, 5.0)]);
    close(at(&system, &u, 6, 1), 5.0 * 8.0 / (3.0 * E * I[1]), 1e-10, "deflection in plane 2");
    close(at(&system, &u, 6, 6), -5.0 * 4.0 / (2.0 * E * I[1]), 1e-10, "slope in plane 2");
}

#[test]
fn torque_and_tension_meet_gj_and_ea() {
    let system = cantilever();
    let u = displaced(&system, &[(6, 5, 3.0), (6, 2, 7.0)]);
    close(at(&system, &u, 6, 5), 3.0 * 2.0 / (G * I[2]), 1e-10, "twist");
    close(at(&system, &u, 6, 2), 7.0 * 2.0 / (E * AREA), 1e-10, "extension");
}

#[test]
fn shear_factors_add_pl_over_kag() {
    let deck = "MAT1,1,7.+10,2.7+10,,2700.\nPBEAM,1,1,1.-4,4.-9,1.-9,,2.-9\n,,,,,,,,\n,0.5,0.4\n";
    let cards = beam(1, 3, 0.2, 0.0).replace("CBAR", "CBEAM") + deck + "SPC1,1,123456,1\n";
    let system = system(&cards);
    let (p, l) = (5.0, 0.2f64);
    let u = displaced(&system, &[(4, 3, p)]);
    let expected = p * l.powi(3) / (3.0 * E * I[0]) + p * l / (0.5 * AREA * G);
    close(at(&system, &u, 4, 3), expected, 1e-10, "plane 1");
    let u = displaced(&system, &[(4, 1, p)]);
    close(
        at(&system, &u, 4, 1),
        p * l.powi(3) / (3.0 * E * I[1]) + p * l / (0.4 * AREA * G),
        1e-10,
        "plane 2",
    );
}

#[test]
fn a_load_beside_the_beam_bends_and_twists_it() {
    // A rigid arm of 0.3 m along x from the tip: the force at its end twists by P r and moves the end along.
    let deck =
        beam(1, 4, 2.0, 0.0) + &section() + "GRID,10,,0.3,2.0,0.\nRBE2,1,5,123456,10\nSPC1,1,123456,1\n";
    let system = system(&deck);
    let p = 4.0;
    let u = displaced(&system, &[(10, 3, p)]);
    let twist = -p * 0.3 * 2.0 / (G * I[2]);
    let bending = p * 8.0 / (3.0 * E * I[0]);
    close(at(&system, &u, 5, 5), twist, 1e-10, "twist");
    close(at(&system, &u, 5, 3), bending, 1e-10, "the beam's tip");
    close(at(&system, &u, 10, 3), bending - 0.3 * twist, 1e-10, "the arm's end");
    close(at(&system, &u, 10, 5), twist, 1e-10, "the arm turns with the tip");
}

#[test]
fn an_offset_element_is_a_beam_on_rigid_arms() {
    let offset = "CBAR,1,1,1,2,0.,0.,1.\n,,,0.3,0.,0.,0.3,0.,0.\n";
    let grids = "GRID,1,,0.,0.,0.\nGRID,2,,0.,2.,0.\nSPC1,1,123456,1\n";
    let system = system(&(grids.to_owned() + offset + &section()));
    let p = 4.0;
    let u = displaced(&system, &[(2, 3, p)]);
    // The element stands at x = 0.3, the force at x = 0: torque P 0.3 about +y at the element.
    let twist = p * 0.3 * 2.0 / (G * I[2]);
    close(at(&system, &u, 2, 5), twist, 1e-10, "twist");
    close(at(&system, &u, 2, 3), p * 8.0 / (3.0 * E * I[0]) + 0.3 * twist, 1e-10, "deflection at the grid");
}

#[test]
fn a_chain_of_rigid_links_acts_as_one() {
    let grids = "GRID,10,,0.3,2.0,0.\nGRID,11,,0.3,2.5,0.2\n";
    let ends = "SPC1,1,123456,1\n";
    let chain = "RBE2,1,10,123456,11\nRBE2,2,5,123456,10\n";
    let direct = "RBE2,1,5,123456,10,11\n";
    let deck = |links: &str| beam(1, 4, 2.0, 0.0) + &section() + grids + ends + links;
    let (one, other) = (system(&deck(chain)), system(&deck(direct)));
    let loads = [(11, 1, 2.0), (11, 3, 4.0), (10, 4, 1.0)];
    let (a, b) = (displaced(&one, &loads), displaced(&other, &loads));
    for i in 0..a.nrows() {
        assert!((a[(i, 0)] - b[(i, 0)]).abs() < 1e-12, "row {i}: {} {}", a[(i, 0)], b[(i, 0)]);
    }
}

#[test]
fn one_tapered_element_has_the_deflection_of_the_integral() {
    // EI falls linearly to a quarter, by c = 3/4: w = P L^3/EI0 int_0^1 (1-t)^2 / (1 - c t) dt with t = x/L.
    let property =
        "PBEAM,1,1,4.-4,4.-9,4.-9,,8.-9\n,,,,,,,,\n,YES,1.0,1.-4,1.-9,1.-9,,2.-9\n,,,,,,,,\n,0.,0.\n";
    let (c, l, p) = (0.75f64, 2.0f64, 4.0);
    // Substituting s = 1 - c t: (1-t) = (s - (1-c))/c, dt = -ds/c.
    let d = 1.0 - c;
    let primitive = |s: f64| (s * s / 2.0 - 2.0 * d * s + d * d * s.ln()) / c.powi(3);
    let exact = p * l.powi(3) / (E * 4e-9) * (primitive(1.0) - primitive(d));
    let error = |n: usize| {
        // n elements of one taper each: stations follow the straight line.
        let mut deck = beam(1, n, l, 0.0).replace("CBAR", "CBEAM");
        for element in 0..n {
            let size = |x: f64| 1.0 - c * x / n as f64;
            let (a, b) = (size(element as f64), size(element as f64 + 1.0));
            let id = element + 1;
            deck = deck.replace(&format!("CBEAM,{id},1,"), &format!("CBEAM,{id},{id},"));
            let (ia, ib) = (4e-9 * a, 4e-9 * b);
            let card = format!(
                "PBEAM,{id},1,1.-4,{ia:.8E},{ia:.8E},,2.-9\n,,,,,,,,\n,YES,1.0,1.-4,{ib:.8E},{ib:.8E},,2.-9\n,,,,,,,,\n,0.,0.\n"
            );
            deck.push_str(&card);
        }
        let system = system(&(deck + "MAT1,1,7.+10,2.7+10,,2700.\nSPC1,1,123456,1\n"));
        let u = displaced(&system, &[(u32::try_from(n).unwrap() + 1, 3, p)]);
        (at(&system, &u, u32::try_from(n).unwrap() + 1, 3) / exact - 1.0).abs()
    };
    let single = system(
        &(beam(1, 1, l, 0.0).replace("CBAR", "CBEAM")
            + property
            + "MAT1,1,7.+10,2.7+10,,2700.\nSPC1,1,123456,1\n"),
    );
    let u = displaced(&single, &[(2, 3, p)]);
    close(at(&single, &u, 2, 3), exact, 2e-6, "one element");
    let errors = [1, 2, 4].map(error);
    assert!(errors[0] < 2e-6 && errors[1] < errors[0] / 20.0 && errors[2] < 1e-9, "{errors:?}");
}

/// Force P along x through the shear centre, neutral axis at (y, z) from it: the moments P y and P z bend the beam towards
/// the neutral axis, v = P y L²/(2 E I1), w = P z L²/(2 E I2), and the force moves along by P L (1/EA + y²/EI1 + z²/EI2).
/// Where the ends' offsets differ, the mean of both acts (the approximation that is documented).
#[test]
fn a_force_beside_the_neutral_axis_bends_the_beam_towards_it() {
    let (l, p) = (2.0, 100.0);
    for ends in [[0.02, -0.01, 0.02, -0.01], [0.05, 0.03, -0.01, -0.01]] {
        let [ya, za, yb, zb] = ends;
        let property = format!(
            "PBEAM,1,1,1.-4,4.-9,1.-9,,2.-9\n,,,,,,,,\n,0.,0.\n,,,,,{ya:?},{za:?},{yb:?},{zb:?}\n\
             MAT1,1,7.+10,2.7+10,,2700.\n"
        );
        // along x, plane 1 is x-y
        let deck = "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nCBEAM,1,1,1,2,0.,1.,0.\nSPC1,1,123456,1\n";
        let system = system(&(deck.to_owned() + &property));
        let (y, z) = (0.5 * (ya + yb), 0.5 * (za + zb));
        let u = displaced(&system, &[(2, 1, p)]);
        close(at(&system, &u, 2, 2), p * y * l * l / (2.0 * E * I[0]), 1e-10, "along y");
        close(at(&system, &u, 2, 3), p * z * l * l / (2.0 * E * I[1]), 1e-10, "along z");
        close(at(&system, &u, 2, 6), p * y * l / (E * I[0]), 1e-10, "slope about z");
        close(at(&system, &u, 2, 5), -p * z * l / (E * I[1]), 1e-10, "slope about y");
        let along = p * l * (1.0 / (E * AREA) + y * y / (E * I[0]) + z * z / (E * I[1]));
        close(at(&system, &u, 2, 1), along, 1e-10, "along the beam");
        // the material stands on the neutral axis, linear from end to end
        let mass = system.mass_properties();
        close(mass.centre.y, y, 1e-12, "centre along y");
        close(mass.centre.z, z, 1e-12, "centre along z");
    }
}
