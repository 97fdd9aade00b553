//! Beams whose section is a number of areas (PBCOMP): what they amount to, in closed form.

use nastran::{BeamProperty, parse_deck};

fn section(cards: &str) -> BeamProperty {
    let deck = format!("MAT1,1,70.+9,26.+9,,2700.\nMAT1,2,210.+9,78.+9,,8100.\n{cards}");
    let bulk = parse_deck("t.bdf", &deck).unwrap_or_else(|error| panic!("{error}"));
    bulk.beam_properties[&9].clone()
}

#[track_caller]
fn close(own: f64, expected: f64, what: &str) {
    assert!((own - expected).abs() <= 1e-12 * expected.abs().max(1e-3), "{what}: {own} for {expected}");
}

/// A thin tube by eight points, as pyNastran's `cc188b` has it: A r²/2 about any axis.
#[test]
fn a_tube_by_eight_points_has_the_moments_of_a_ring() {
    let tube = section(
        "PBCOMP,9,1,36.,,,,500.,.5\n,,,,,,,1\n,0.,2.,.0625\n,1.414213562373,1.414213562373,.125\n,2.,0.,.0625\n",
    );
    for at in &tube.stations {
        for (own, expected, what) in [
            (at.area, 36.0, "A"),
            (at.i1, 72.0, "I1"),
            (at.i2, 72.0, "I2"),
            (at.j, 500.0, "J"),
            (at.nsm, 0.5, "NSM"),
        ] {
            assert!((own / expected - 1.0).abs() < 1e-10, "{what}: {own} for {expected}");
        }
        assert!(at.i12.abs() < 1e-12);
    }
    assert_eq!((tube.neutral_axis, tube.shear_factors), ([[0.0; 2]; 2], [1.0; 2]));
}

/// Aluminium at y = 0 and three times as stiff steel at y = 1, z = 2, each half of the area: by hand.
#[test]
fn areas_of_two_materials_count_with_their_stiffness() {
    let mixed = section("PBCOMP,9,1,.02,,,,.006,4.\n,,,.1,.2,,,\n,0.,0.,.5\n,1.,2.,.5,2\n");
    let at = mixed.stations[0];
    // Shares .5 and 1.5 of the stiffness: the neutral axis is three quarters of the way.
    close(at.area, 0.02 * 2.0, "A");
    close(mixed.neutral_axis[0][0], 0.75, "y");
    close(mixed.neutral_axis[1][1], 1.5, "z");
    close(at.i1, 0.02 * (0.5 * 0.75 * 0.75 + 1.5 * 0.25 * 0.25), "I1");
    close(at.i2, 4.0 * at.i1, "I2");
    close(at.i12, 2.0 * at.i1, "I12");
    close(at.j, 0.006 * (0.5 + 1.5), "J");
    // The mass and its centre: 27 kg/m at the origin, 81 kg/m at (1, 2) and NSM of 4 kg/m at (.1, .2); of these the beam has 2700 A' on its neutral axis.
    close(2700.0 * at.area + at.nsm, 27.0 + 81.0 + 4.0, "mass per length");
    for (axis, place) in [0.1, 0.2].into_iter().enumerate() {
        let moment = 2700.0 * at.area * mixed.neutral_axis[0][axis] + at.nsm * mixed.nsm_offset[0][axis];
        close(moment, 81.0 * [1.0, 2.0][axis] + 4.0 * place, "first moment of the mass");
    }
}

#[test]
fn symmetric_areas_stand_where_their_option_puts_them() {
    for (option, i12, neutral) in [
        (0, 0.0, [0.3, 0.2]),
        (2, 0.0, [0.3, 0.0]),
        (3, 0.0, [0.0, 0.2]),
        (4, 0.06, [0.0, 0.0]),
        (1, 0.0, [0.0, 0.0]),
    ] {
        let share = match option {
            0 => 1.0,
            1 => 0.25,
            _ => 0.5,
        };
        let own = section(&format!("PBCOMP,9,1,1.\n,,,,,,,{option}\n,.3,.2,{share:?}\n"));
        close(own.stations[0].i12, i12, "I12");
        close(own.neutral_axis[0][0], neutral[0], "y");
        close(own.neutral_axis[0][1], neutral[1], "z");
    }
}

#[test]
fn moments_are_those_given_where_no_area_has_a_share() {
    let own = section("PBCOMP,9,1,2.,3.,4.,.5,6.\n,,,,,.1,.2\n,1.,1.\n");
    let at = own.stations[1];
    assert_eq!((at.area, at.i1, at.i2, at.i12, at.j), (2.0, 3.0, 4.0, 0.5, 6.0));
    assert_eq!(own.neutral_axis, [[0.1, 0.2]; 2]);
}

#[test]
fn shares_that_are_not_one_and_materials_that_are_not_there_are_refused() {
    let refused = |cards: &str| {
        parse_deck("t.bdf", &format!("MAT1,1,7.+10,,.3\n{cards}")).expect_err("refused").to_string()
    };
    let error = refused("PBCOMP,9,1,1.\n,,,,,,,1\n,.3,.2,.5\n");
    assert!(
        error.contains(
            "the areas of PBCOMP 9, with those that SYMOPT 1 adds, are 2 of the section's in all, not one"
        ),
        "{error}"
    );
    let error = refused("PBCOMP,9,1,1.\n\n,.3,.2,1.,5\n".replace("\n\n", "\n,,,,,,,0\n").as_str());
    assert!(error.contains("PBCOMP 9 refers to MAT1 5, which is not there or has no E"), "{error}");
}
