//! What is refused does not hang on units: elements and materials at the edge of what is possible, at any size.

use nalgebra::{Matrix2, Matrix3};
use nastran::{BulkData, Mat1, Mat2, Mat8, Span, parse_deck};
use structure::{Model, PlaneMaterial, System};

fn message(deck: &str) -> String {
    let read = parse_deck("wing.bdf", deck).and_then(|bulk| Model::from_bulk(&bulk));
    read.map_or_else(|error| error.to_string(), |_| "accepted".to_owned())
}

/// What is said of a deck after a change to what its cards say, that no card may say.
fn changed(deck: &str, change: impl FnOnce(&mut BulkData)) -> String {
    let mut bulk = parse_deck("wing.bdf", deck).expect("a deck");
    change(&mut bulk);
    Model::from_bulk(&bulk).map_or_else(|error| error.to_string(), |_| "accepted".to_owned())
}

const SIZES: [f64; 3] = [1e-4, 1.0, 1e5];

/// Four grids of a panel or plate times a size.
fn grids(corners: &[[f64; 2]], size: f64) -> String {
    let one = |(at, [x, y]): (usize, &[f64; 2])| {
        format!("GRID*,{},,{:.12E},{:.12E}\n*,{:.12E}\n", at + 1, size * x, size * y, 0.0)
    };
    corners.iter().enumerate().map(one).collect()
}

#[test]
fn panels_are_flat_by_the_sine_of_their_diagonals_at_any_size() {
    let panel = |corners: &[[f64; 2]; 4], size: f64| {
        message(
            &(grids(corners, size) + "CSHEAR,1,1,1,2,3,4\nPSHEAR,1,1,.002\nMAT1,1,7.+10,2.7+10,.3,2700.\n"),
        )
    };
    for size in SIZES {
        assert_eq!(panel(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [0.0, 1.0]], size), "accepted", "size {size}");
        // A needle: its corners stand off its sides by a ten-thousandth of both diagonals, 6e-4, at least.
        for (h, fine) in [(8e-4, true), (4e-4, false)] {
            let own = panel(&[[0.0, 0.0], [3.0, 0.0], [3.0, h], [0.0, h]], size);
            assert_eq!(own == "accepted", fine, "size {size}, {h}: {own}");
        }
        // A corner on the line between its neighbours, or a little beyond.
        for (beyond, fine) in [(0.02, true), (0.0, false), (-0.02, false)] {
            let own = panel(&[[0.0, 0.0], [1.0, 0.0], [0.5 + beyond, 0.5 + beyond], [0.0, 1.0]], size);
            assert_eq!(own == "accepted", fine, "size {size}, {beyond}: {own}");
        }
    }
}

#[test]
fn shells_are_degenerate_by_the_sines_of_their_angles_at_any_size() {
    let shell = |corners: &[[f64; 2]], size: f64| {
        let name = if corners.len() == 4 { "CQUAD4,1,1,1,2,3,4" } else { "CTRIA3,1,1,1,2,3" };
        message(&format!("{}{name}\nPSHELL,1,1,.01,1,,1\nMAT1,1,7.+10,,.3\n", grids(corners, size)))
    };
    for size in SIZES {
        for (h, fine) in [(2e-4, true), (0.5e-4, false)] {
            let own = shell(&[[0.0, 0.0], [1.0, 0.0], [0.0, h]], size);
            let right_angled = shell(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.5 * h]], size);
            // The angle at the first corner is right, but those at the others are small.
            assert_eq!(own == "accepted", fine, "size {size}, {h}: {own}");
            assert_eq!(right_angled == "accepted", 1.5 * h > 1e-4, "size {size}, {h}: {right_angled}");
        }
        for (beyond, fine) in [(0.02, true), (0.0, false), (-0.02, false)] {
            let own = shell(&[[0.0, 0.0], [1.0, 0.0], [0.5 + beyond, 0.5 + beyond], [0.0, 1.0]], size);
            assert_eq!(own == "accepted", fine, "size {size}, {beyond}: {own}");
        }
        assert_ne!(shell(&[[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]], size), "accepted", "crossed");
    }
}

#[test]
fn a_beam_needs_length_and_an_orientation_beside_it() {
    let beam = |far: f64, vector: &str| {
        message(&format!(
            "GRID*,1,,1000.,0.\n*,0.\nGRID*,2,,1000.,{far:.12E}\n*,0.\nCBAR,1,1,1,2,{vector}\nPBAR,1,1,1.,1.,1.,1.\n\
            MAT1,1,1.,.4\n"
        ))
    };
    assert_eq!(beam(1.0, "0.,1.-3,1."), "accepted");
    assert!(beam(0.5e-9, "0.,0.,1.").contains("beam 1 has no length"));
    assert_eq!(beam(2e-9, "0.,0.,1."), "accepted");
    for vector in ["0.,1.,0.", "0.,-3.,0.", "0.,1.,1.-9"] {
        assert!(beam(1.0, vector).contains("is zero or along the beam"), "{vector}: {}", beam(1.0, vector));
    }
    assert_eq!(beam(1.0, "0.,1.,1.-7"), "accepted");
}

fn span() -> Span {
    Span::generated("test")
}

fn isotropic(e: f64, g: f64, nu: f64) -> Result<PlaneMaterial, String> {
    let expansion = nastran::Expansion::default();
    PlaneMaterial::isotropic(&Mat1 { id: 1, e, g, nu, rho: 3.0, expansion, span: span() })
        .map_err(|e| e.to_string())
}

fn ply(e1: f64, e2: f64, nu12: f64, [g12, g1z, g2z]: [f64; 3]) -> Result<PlaneMaterial, String> {
    let expansion = nastran::Expansion::default();
    let card = Mat8 { id: 1, e1, e2, nu12, g12, g1z, g2z, rho: 3.0, expansion, span: span() };
    PlaneMaterial::ply(&card).map_err(|error| error.to_string())
}

#[test]
fn plane_materials_have_the_stiffness_of_plane_stress() {
    let own = isotropic(80.0, 25.0, 0.6).expect("sound");
    let expected = Matrix3::new(125.0, 75.0, 0.0, 75.0, 125.0, 0.0, 0.0, 0.0, 25.0);
    assert!((own.stiffness - expected).amax() < 1e-12, "{}", own.stiffness);
    assert_eq!((own.shear, own.density), ([25.0; 2], 3.0));
    // Strains of uniaxial stresses: 1/E1, -NU12/E1, 1/E2.
    let own = ply(200.0, 50.0, 0.4, [7.0, 6.0, 0.0]).expect("sound");
    let flexible = Matrix3::new(1.0 / 200.0, -0.002, 0.0, -0.002, 0.02, 0.0, 0.0, 0.0, 1.0 / 7.0);
    assert!((own.stiffness * flexible - Matrix3::identity()).amax() < 1e-12, "{}", own.stiffness);
    assert_eq!((own.shear, own.density), ([6.0, f64::INFINITY], 3.0));
    let g = [9.0, 1.0, 2.0, 8.0, 3.0, 7.0];
    let expansion = nastran::Expansion::default();
    let card = |g: [f64; 6]| Mat2 { id: 1, g, rho: 3.0, expansion, span: span() };
    let own = PlaneMaterial::anisotropic(&card(g)).expect("sound");
    assert_eq!(own.stiffness, Matrix3::new(9.0, 1.0, 2.0, 1.0, 8.0, 3.0, 2.0, 3.0, 7.0));
    assert_eq!((own.shear, own.density), ([f64::INFINITY; 2], 3.0));
    assert!(PlaneMaterial::anisotropic(&card([1.0, 2.0, 0.0, 1.0, 0.0, 1.0])).is_err());
}

#[test]
fn plane_materials_that_store_no_energy_are_refused() {
    for (e, g, nu) in [
        (0.0, 25.0, 0.3),
        (-1.0, 25.0, 0.3),
        (80.0, 0.0, 0.3),
        (80.0, -1.0, 0.3),
        (80.0, 25.0, 1.0),
        (80.0, 25.0, -1.0),
        (80.0, 25.0, 1.5),
        (f64::INFINITY, 25.0, 0.3),
        (80.0, f64::INFINITY, 0.3),
        (80.0, 25.0, f64::NAN),
    ] {
        let error = isotropic(e, g, nu).expect_err("refused");
        assert!(error.contains("cannot be a shell's material"), "{error}");
    }
    assert!(isotropic(80.0, 25.0, -0.99).is_ok() && isotropic(80.0, 1e-9, 0.99).is_ok());
    let sound = [7.0, 6.0, 5.0];
    for (e1, e2, nu12, g) in [
        (0.0, 50.0, 0.0, sound),
        (-1.0, 50.0, 0.0, sound),
        (200.0, 0.0, 0.4, sound),
        (200.0, -1.0, 0.4, sound),
        (200.0, 50.0, 0.4, [0.0, 6.0, 5.0]),
        (200.0, 50.0, 0.4, [7.0, -6.0, 5.0]),
        (200.0, 50.0, 0.4, [7.0, 6.0, -5.0]),
        (200.0, 50.0, 0.4, [7.0, 6.0, f64::NAN]),
        // NU12^2 is E1 / E2, or more.
        (200.0, 50.0, 2.0, sound),
        (200.0, 50.0, -2.1, sound),
        (f64::INFINITY, 50.0, 0.3, sound),
    ] {
        let error = ply(e1, e2, nu12, g).expect_err("refused");
        assert!(error.contains("is not a material that stores energy"), "{error}");
    }
    assert!(ply(200.0, 50.0, 1.99, sound).is_ok() && ply(200.0, 50.0, -1.99, sound).is_ok());
}

#[test]
fn transverse_moduli_turn_as_tensors_and_an_infinite_one_is_a_thousand_times_the_other() {
    let shear = |g1z: f64, g2z: f64, degrees: f64| {
        ply(200.0, 50.0, 0.3, [7.0, g1z, g2z]).expect("sound").turned_shear(f64::to_radians(degrees))
    };
    let near = |own: Matrix2<f64>, expected: Matrix2<f64>| {
        assert!((own - expected).amax() < 1e-12 * expected.amax(), "{own} for {expected}");
    };
    near(shear(6.0, 2.0, 90.0), Matrix2::new(2.0, 0.0, 0.0, 6.0));
    near(shear(6.0, 2.0, 45.0), Matrix2::new(4.0, 2.0, 2.0, 4.0));
    near(shear(4.0, 4.0, 33.0), Matrix2::new(4.0, 0.0, 0.0, 4.0));
    near(shear(6.0, 0.0, 0.0), Matrix2::new(6.0, 0.0, 0.0, 6000.0));
    near(shear(0.0, 2.0, 90.0), Matrix2::new(2.0, 0.0, 0.0, 2000.0));
    assert_eq!(shear(0.0, 0.0, 20.0)[(0, 0)], f64::INFINITY);
}

#[test]
fn sections_of_shells_that_cannot_be_are_refused() {
    let shell = |property: &str| {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        message(&format!(
            "{}CQUAD4,1,1,1,2,3,4\n{property}MAT1,1,7.+10,,.3\nMAT2,3,1.,2.,,1.\nMAT2,4,4.,1.,,2.\n",
            grids(&corners, 1.0)
        ))
    };
    for property in [
        "PSHELL,1,1,.01,1,1.,1\n",
        "PSHELL,1,1,.01,1,0.,1\n",
        "PSHELL,1,1,.01,1,1.,1,0.\n",
        "PSHELL,1,1,.01,1,1.,4\n",
        "PCOMP,1\n,1,.01,0.\n",
    ] {
        assert_eq!(shell(property), "accepted", "{property}");
    }
    for (property, said) in [
        ("PSHELL,1,1,.01,1,1.,3\n", "MAT2 3: G11, G12 and G22 are the transverse shear moduli of PSHELL 1"),
        ("PSHELL,1,7,.01,1,1.,1\n", "refers to MAT1, MAT2 or MAT8 7"),
        ("PCOMP,1\n,7,.01,0.\n", "refers to MAT1, MAT2 or MAT8 7"),
        ("PSHELL,2,1,.01\n", "refers to PSHELL or PCOMP 1"),
    ] {
        let own = shell(property);
        assert!(own.contains(said), "{property}: {own}");
    }
    let corners = grids(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], 1.0);
    let cards = format!("{corners}CQUAD4,1,1,1,2,3,4\nMAT1,1,7.+10,,.3\n");
    let plate = format!("{cards}PSHELL,1,1,.01,1,1.,1\n");
    for value in [0.0, -0.01, f64::INFINITY, f64::NAN] {
        let of = |bulk: &mut BulkData| bulk.shell_properties.get_mut(&1).expect("a plate").thickness = value;
        let own = changed(&plate, of);
        assert!(own.contains(&format!("PSHELL 1 has the thickness {value}")), "{own}");
        let own = changed(&format!("{cards}PCOMP,1\n,1,.01,0.,,1,.02,0.\n"), |bulk| {
            bulk.laminates.get_mut(&1).expect("a laminate").plies[1].thickness = value;
        });
        assert!(own.contains(&format!("PCOMP 1 has a ply of thickness {value}")), "{own}");
    }
    for (bending, shear) in [(-1e-9, 1.0), (1.0, -1e-9), (f64::NAN, 1.0), (1.0, f64::NAN)] {
        let own = changed(&plate, |bulk| {
            let property = bulk.shell_properties.get_mut(&1).expect("a plate");
            (property.bending_ratio, property.shear_ratio) = (bending, shear);
        });
        assert!(own.contains("PSHELL 1 has the thickness 0.01 and ratios"), "{own}");
    }
    let own = changed(&format!("{cards}PCOMP,1\n,1,.01,0.\n"), |bulk| {
        bulk.laminates.get_mut(&1).expect("a laminate").plies.clear();
    });
    assert!(own.contains("PCOMP 1 has no plies"), "{own}");
}

#[test]
fn a_material_axis_normal_to_its_shell_is_refused_however_little_it_misses_it() {
    let shell = |x: &str| {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        message(&format!(
            "{}CQUAD4,1,1,1,2,3,4,5\nPSHELL,1,1,.01,1,,1\nMAT1,1,7.+10,,.3\nCORD2R,5,,0.,0.,0.,0.,1.,0.,\n,{x}\n",
            grids(&corners, 1.0)
        ))
    };
    assert!(shell("0.,0.,1.").contains("CQUAD4 1: the x axis of system 5 (MCID) is normal to the element"));
    assert!(shell("1.-13,0.,1.").contains("is normal to the element"));
    assert_eq!(shell("1.-10,0.,1."), "accepted");
    assert_eq!(shell("1.,0.,0."), "accepted");
}

#[test]
fn masses_are_multiplied_by_a_positive_number_alone() {
    let deck = |value: &str| format!("PARAM,WTMASS,{value}\nGRID,1\nCONM2,1,1,,3.\nCELAS2,1,5.,1,3\n");
    let mass = |value: &str| {
        let model =
            Model::from_bulk(&parse_deck("wing.bdf", &deck(value)).expect("a deck")).expect("a model");
        System::assemble(&model).expect("a structure").mass_properties().mass_kg
    };
    assert!((mass(".5") - 1.5).abs() < 1e-15 && (mass("2.") - 6.0).abs() < 1e-15);
    for value in ["0.", "-1.", "1.+999"] {
        let own = message(&deck(value));
        assert_ne!(own, "accepted", "{value}");
    }
    for value in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let own = changed(&deck("1."), |bulk| _ = bulk.parameters.insert("WTMASS".into(), value));
        assert!(own.contains("is not a positive number"), "{value}: {own}");
    }
}

#[test]
fn bushes_without_axes_or_with_negative_stiffness_are_refused() {
    let bush = |card: &str, stiffness: &str| {
        message(&format!(
            "GRID,1\nGRID,2,,1.,2.,3.\nGRID,3\nGRID,4,,0.,1.,0.\nCBUSH,1,1,{card}\nPBUSH,1,K,{stiffness}\n"
        ))
    };
    for (card, stiffness) in [
        ("1,2", "5.,,,2."),
        ("1,2,4", "5.,4.,3.,2.,1.,1."),
        ("1,2,0.,1.,0.", "5.,4.,3.,2.,1.,1."),
        ("1,3,,,,0", "5.,4.,3.,2.,1.,1."),
        ("1,,,,,0", "0.,4.,3.,2.,1.,1."),
    ] {
        assert_eq!(bush(card, stiffness), "accepted", "{card}");
    }
    for stiffness in ["5.,1.", "5.,,1.", "5.,,,,1.", "5.,,,,,1."] {
        let own = bush("1,2", stiffness);
        assert!(
            own.contains("CBUSH 1: the axes of its stiffnesses are not determined"),
            "{stiffness}: {own}"
        );
    }
    for (card, stiffness) in [("1,3", "5."), ("1,2,2.,4.,6.", "5.,4.,3.,2.,1.,1.")] {
        assert!(bush(card, stiffness).contains("the axes of its stiffnesses are not determined"), "{card}");
    }
    let deck = "GRID,1\nGRID,2,,1.,2.,3.\nCBUSH,1,1,1,2,,,,0\nPBUSH,1,K,5.,4.\n";
    for (value, said) in [(-4.0, "-4"), (f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let own =
            changed(deck, |bulk| bulk.bush_properties.get_mut(&1).expect("a bush").stiffness[1] = value);
        assert!(own.contains(&format!("PBUSH 1 has the stiffness or damping {said}")), "{own}");
    }
}

#[test]
fn motions_of_grids_have_a_digit_and_scalar_points_none() {
    let spring = |motion: &str| message(&format!("GRID,1\nSPOINT,7\nCELAS2,1,5.,{motion}\n"));
    for motion in ["1,1", "1,6", "7", "7,1", "7,0", "1,3,7,0"] {
        assert_eq!(spring(motion), "accepted", "{motion}");
    }
    let at = |motion: (u32, u8)| {
        let end = Some(motion);
        changed("GRID,1\nSPOINT,7\nCELAS2,1,5.,1,1\n", |bulk| {
            bulk.springs.get_mut(&1).expect("a spring").ends[0] = end;
        })
    };
    for (motion, said) in [
        ((1, 0), "CELAS 1 has no component for GRID 1"),
        ((1, 7), "CELAS 1 has no component for GRID 1"),
        ((7, 2), "CELAS 1 names component 2 of scalar point 7"),
    ] {
        assert!(at(motion).contains(said), "{}", at(motion));
    }
    assert_eq!([at((1, 6)), at((7, 0)), at((7, 1))], ["accepted"; 3]);
    assert!(spring("9,1").contains("CELAS 1 refers to GRID 9"), "{}", spring("9,1"));
    let property = |id: u32| format!("PELAS,{},1.\n", 10 * id);
    let many: String = (1..=9).map(property).collect();
    let own = message(&format!("GRID,1\n{many}CELAS1,1,7,1,1\n"));
    assert!(own.contains("there are PELAS 10, 20, 30, 40, 50, 60, 70, 80 and more"), "{own}");
    let own = message(&format!("GRID,1\n{}CELAS1,1,7,1,1\n", many.replace("PELAS,90,1.\n", "")));
    assert!(own.contains("70, 80)"), "{own}");
    assert!(
        message("GRID,1\nCELAS2,1,5.,1,1\nSPC1,1,,1\n")
            .contains("SPC1 of set 1 names GRID 1 without a component")
    );
}
