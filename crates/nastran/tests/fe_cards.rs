//! Cards of general finite elements: fields, Nastran's defaults, and what is refused.

use nastran::{
    BulkData, BushAxes, LaminateOption, MaterialDirection, Orientation, ScalarValue, SolidPoints, SolidShear,
    SplineKind, parse_deck,
};

fn parse(text: &str) -> BulkData {
    parse_deck("t.bdf", text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn shells_take_an_angle_or_a_system() {
    let deck = parse("CQUAD4,1,,1,2,3,4,30.,.01\nCTRIA3,2,9,1,2,3,5,-.01\nCQUAD4,3,9,1,2,3,4\n");
    let [quad, triangle, plain] = [1, 2, 3].map(|id| deck.shells[&id].clone());
    assert_eq!((quad.property, quad.grids, quad.offset), (1, vec![1, 2, 3, 4], 0.01));
    assert_eq!(quad.direction, MaterialDirection::AngleDeg(30.0));
    assert_eq!((triangle.property, triangle.grids, triangle.offset), (9, vec![1, 2, 3], -0.01));
    assert_eq!(triangle.direction, MaterialDirection::System(5));
    assert_eq!((plain.direction, plain.offset), (MaterialDirection::AngleDeg(0.0), 0.0));
}

#[test]
fn corner_thicknesses_are_in_units_of_the_propertys_where_they_differ() {
    let plain = parse("CQUAD4,1,7,1,2,3,4\n,,,.5,.5,.5,.5\nCTRIA3,2,7,1,2,3\n,,1,1.,,1.\nPSHELL,7,1,.5,1\n");
    assert!(plain.shells.values().all(|shell| shell.thickness.ratios(0.5).is_none()));
    let deck = parse(
        "CQUAD4,1,7,1,2,3,4\n,,,.5,.6,.5\nCTRIA3,2,7,1,2,3\n,,1,1.,,2.\nCTRIA6,3,7,1,2,3,4,5,6\n,,,.2,.3,.4,0\nCQUAD8,4,7,1,2,3,4,5,6\n,7,8,.2,.3,.4,.5\n,1\n",
    );
    let ratios = |id: u32| deck.shells[&id].thickness.ratios(0.5);
    assert_eq!(ratios(1), Some(vec![1.0, 1.2, 1.0, 1.0]));
    assert_eq!(ratios(2), Some(vec![1.0, 1.0, 2.0]));
    assert_eq!(ratios(3), Some(vec![0.4, 0.6, 0.8]));
    assert_eq!(ratios(4), Some(vec![0.2, 0.3, 0.4, 0.5]));
    let again = parse(&nastran::write_deck(&deck));
    for (id, shell) in &deck.shells {
        assert_eq!(again.shells[id].thickness, shell.thickness, "written and read again");
    }
}

#[test]
fn pshell_has_nastran_s_defaults() {
    let deck = parse("PSHELL,1,5,.02,5,,5,,.3\n,,,6\nPSHELL,2,5,.02\n");
    let full = &deck.shell_properties[&1];
    assert_eq!(
        (full.membrane, full.bending, full.shear, full.coupling),
        (Some(5), Some(5), Some(5), Some(6))
    );
    assert_eq!((full.thickness, full.bending_ratio, full.shear_ratio, full.nsm), (0.02, 1.0, 5.0 / 6.0, 0.3));
    let membrane = &deck.shell_properties[&2];
    assert_eq!((membrane.membrane, membrane.bending, membrane.shear), (Some(5), None, None));
}

#[test]
fn plies_repeat_material_and_thickness_of_the_ply_before() {
    let deck = parse("PCOMP,1,-.5,.1,,,,,SYM\n,8,.1,45.,YES,,,-45.\n,,,,,9,.2\n");
    let laminate = &deck.laminates[&1];
    let plies: Vec<_> = laminate.plies.iter().map(|p| (p.material, p.thickness, p.angle_deg)).collect();
    assert_eq!(plies, [(8, 0.1, 45.0), (8, 0.1, -45.0), (9, 0.2, 0.0)]);
    assert_eq!(
        (laminate.z0, laminate.nsm, laminate.option == LaminateOption::Symmetric, laminate.is_global),
        (Some(-0.5), 0.1, true, false)
    );
    let deck = parse("PCOMPG,2\n,101,8,.1,45.\n,102,,,-45.,NO\n");
    let laminate = &deck.laminates[&2];
    let plies: Vec<_> = laminate.plies.iter().map(|p| (p.global_id, p.material, p.angle_deg)).collect();
    assert_eq!(plies, [(Some(101), 8, 45.0), (Some(102), 8, -45.0)]);
    assert!(laminate.is_global && laminate.z0.is_none());
}

#[test]
fn solids_and_rods() {
    let deck = parse(concat!(
        "CHEXA,1,2,1,2,3,4,5,6\n,7,8\nCPENTA,3,2,1,2,3,4,5,6\nCTETRA,4,2,1,2,3,4\nPSOLID,2,9,5,2,GAUSS,1,SMECH\n",
        "CROD,5,,1,2\nPROD,5,9,.1,.2,.3,.4\n"
    ));
    assert_eq!(deck.solids[&1].grids, [1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!((deck.solids[&3].grids.len(), deck.solids[&4].grids.len()), (6, 4));
    assert_eq!((deck.solid_properties[&2].material, deck.solid_properties[&2].cordm), (9, 5));
    assert_eq!((deck.rods[&5].property, deck.rods[&5].grids), (5, [1, 2]));
    let rod = &deck.rod_properties[&5];
    assert_eq!((rod.material, rod.area, rod.j, rod.nsm), (9, 0.1, 0.2, 0.4));
}

#[test]
fn integration_of_solids_is_said_by_number_or_by_word() {
    let said = |fields: &str| {
        let deck = parse(&format!("PSOLID,2,9,,{fields}\n"));
        (deck.solid_properties[&2].points, deck.solid_properties[&2].shear)
    };
    for fields in ["", "0,,0", "bubble,GRID,Reduced"] {
        assert_eq!(said(fields), (SolidPoints::Usual, SolidShear::Reduced), "{fields}");
    }
    assert_eq!(said("2,,1"), (SolidPoints::Two, SolidShear::Full));
    assert_eq!(said("TWO,GAUSS,FULL"), (SolidPoints::Two, SolidShear::Full));
    assert_eq!(said("THREE"), (SolidPoints::Three, SolidShear::Reduced));
    assert_eq!((said("3").0, said("1").0), (SolidPoints::Three, SolidPoints::One));
}

#[test]
fn bushes() {
    let deck = parse(concat!(
        "CBUSH,1,2,1,,,,,0\nCBUSH,3,2,1,2\nCBUSH,4,2,1,2,9\n,.25,,1.\nCBUSH,5,2,1,2,0.,1.,0.\n,,7,.1,.2,.3\n",
        "PBUSH,2,GE,.01\n,,K,1.,2.,3.,4.,5.,6.\n,,B,7.\n"
    ));
    assert_eq!((deck.bushes[&1].grids, &deck.bushes[&1].axes), ((1, None), &BushAxes::System(0)));
    assert_eq!((&deck.bushes[&3].axes, deck.bushes[&3].location), (&BushAxes::Line, 0.5));
    assert_eq!(deck.bushes[&4].axes, BushAxes::Oriented(Orientation::Grid(9)));
    assert_eq!((deck.bushes[&4].location, deck.bushes[&4].offset), (0.25, None));
    assert_eq!(deck.bushes[&5].offset, Some((7, [0.1, 0.2, 0.3].into())));
    assert_eq!(deck.bush_properties[&2].stiffness, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
}

#[test]
fn scalar_elements_and_their_properties() {
    let deck = parse(concat!(
        "CELAS1,1,7,1,3,2,3\nCELAS2,2,5.,1,3\nCMASS1,3,,,,2,1\nCMASS2,4,5.,1,3,0\n",
        "PELAS,7,1.,,,8,2.\nPMASS,7,1.,8,2.,9,3.\n"
    ));
    assert_eq!(deck.springs[&1].value, ScalarValue::Property(7));
    assert_eq!(deck.springs[&1].ends, [Some((1, 3)), Some((2, 3))]);
    assert_eq!(
        (deck.springs[&2].value, deck.springs[&2].ends),
        (ScalarValue::Given(5.0), [Some((1, 3)), None])
    );
    assert_eq!(deck.scalar_masses[&3].ends, [None, Some((2, 1))]);
    assert_eq!(deck.scalar_masses[&4].ends, [Some((1, 3)), None]);
    assert_eq!((deck.spring_properties[&7].value, deck.spring_properties[&8].value), (1.0, 2.0));
    assert_eq!(deck.mass_properties.keys().copied().collect::<Vec<_>>(), [7, 8, 9]);
}

#[test]
fn genel_lists_the_lower_triangle_column_by_column() {
    // The layout of the example in Nastran's Quick Reference Guide: scalar points replaced by grids.
    let deck = parse(concat!(
        "GENEL,629,,1,1,13,4,42,5\n,24,2\n,UD,,6,2,33,1\n",
        ",Z,1.,2.,3.,4.,5.,6.,7.\n,8.,9.,10.\n,S,1.5,2.5,3.5,4.5,5.5,6.5,7.5\n,8.5\n"
    ));
    let element = &deck.general[&629];
    assert_eq!(element.ui, [(1, 1), (13, 4), (42, 5), (24, 2)]);
    assert_eq!(element.ud, [(6, 2), (33, 1)]);
    assert!(element.is_flexibility);
    let expected = [[1.0, 2.0, 3.0, 4.0], [2.0, 5.0, 6.0, 7.0], [3.0, 6.0, 8.0, 9.0], [4.0, 7.0, 9.0, 10.0]];
    assert_eq!(element.matrix, expected);
    assert_eq!(element.s, [[1.5, 2.5], [3.5, 4.5], [5.5, 6.5], [7.5, 8.5]]);
}

#[test]
fn the_six_by_six_mass_is_its_lower_triangle_row_by_row() {
    let deck = parse("CONM1,1,2,,1.,.2,2.,.3,.4\n,3.\n");
    let mass = deck.mass_matrices[&1].mass;
    assert_eq!(mass[0][..3], [1.0, 0.2, 0.3]);
    assert_eq!(mass[1][..3], [0.2, 2.0, 0.4]);
    assert_eq!(mass[2][..3], [0.3, 0.4, 3.0]);
}

#[test]
fn rigid_elements() {
    let deck = parse(concat!(
        "RBAR,1,1,2,123456,,,123\n",
        "RBE3,2,,100,123456,1.,123,1,2\n,3,.5,123456,4,THRU,6\n,UM,100,456,1,3\n,ALPHA,1.-5\n"
    ));
    let bar = &deck.rigid_bodies[&1];
    assert_eq!(bar.independent, [(1, vec![1, 2, 3, 4, 5, 6])]);
    assert_eq!(bar.dependent, [(2, vec![1, 2, 3])]);
    let mean = &deck.averages[&2];
    assert_eq!((mean.reference, mean.components.len()), (100, 6));
    assert_eq!((mean.groups[0].weight, &mean.groups[0].grids), (1.0, &vec![1, 2, 3]));
    assert_eq!((mean.groups[1].components.len(), &mean.groups[1].grids), (6, &vec![4, 5, 6]));
    assert_eq!(mean.um, [(100, vec![4, 5, 6]), (1, vec![3])]);
}

#[test]
fn equations_and_constraints() {
    let deck = parse("MPC,9,1,3,1.,2,3,-.5\n,,4,1,.25\nSPC,2,5,126,,6,3,0.\n");
    assert_eq!(deck.equations[0].terms, [((1, 3), 1.0), ((2, 3), -0.5), ((4, 1), 0.25)]);
    assert_eq!((deck.constraints[0].set, &deck.constraints[0].components), (2, &vec![1, 2, 6]));
    assert_eq!((&deck.constraints[1].grids, &deck.constraints[1].components), (&vec![6], &vec![3]));
}

#[test]
fn materials() {
    let deck = parse(concat!(
        "MAT2,1,1.,2.,3.,4.,5.,6.,7.\nMAT8,2,1.+11,1.+10,.3,5.+9,4.+9,3.+9,1600.\n",
        "MAT9,3,11.,12.,13.,14.,15.,16.,22.\n,23.,24.,25.,26.,33.,34.,35.,36.\n,44.,45.,46.,55.,56.,66.,.5\n"
    ));
    assert_eq!((deck.plane_materials[&1].g[4], deck.plane_materials[&1].rho), (5.0, 7.0));
    let ply = &deck.ply_materials[&2];
    assert_eq!((ply.e1, ply.e2, ply.nu12, ply.g12, ply.g1z, ply.g2z), (1e11, 1e10, 0.3, 5e9, 4e9, 3e9));
    assert_eq!(ply.rho, 1600.0);
    let solid = &deck.solid_materials[&3];
    assert_eq!((solid.g[5], solid.g[6], solid.g[15], solid.g[20], solid.rho), (16.0, 22.0, 44.0, 66.0, 0.5));
}

/// As in pyNastran's `shock_analysis` (free fields behind a blank) and `thcylq4` (fields of eight).
#[test]
fn parameters_of_the_case_control_hold_and_contradictions_are_refused() {
    let deck = |parameter: &str, bulk: &str| {
        parse_deck(
            "t.bdf",
            &format!("SOL 103\nCEND\nSPC = 1\n{parameter}METHOD = 2\nBEGIN BULK\n{bulk}GRID,1\n"),
        )
    };
    for (parameter, name, value) in [
        (" PARAM,K6ROT,7.\n", "K6ROT", 7.0),
        ("PARAM   K6ROT   7.\n", "K6ROT", 7.0),
        ("param, coupmass, 1\n", "COUPMASS", 1.0),
        ("PARAM,AUTOSPC,NO\n", "AUTOSPC", 0.0),
    ] {
        let deck = deck(parameter, "").unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(deck.parameters.get(name), Some(&value), "{parameter}");
        assert_eq!((deck.subcases.len(), deck.subcases[0].method), (1, Some(2)), "{parameter}");
    }
    assert!(deck("PARAMETER = 5\n", "").expect("another command").parameters.is_empty());
    assert!(deck("PARAM,K6ROT,7.\n", "PARAM,K6ROT,7.\n").is_ok(), "the same twice");
    let refused = deck("PARAM,K6ROT,7.\n", "PARAM,K6ROT,1.\n").unwrap_err().to_string();
    assert!(refused.contains("t.bdf:7") && refused.contains("K6ROT is 1 here and 7 before"), "{refused}");
    let refused = deck("PARAM,WTMASS,-1.\n", "").unwrap_err().to_string();
    assert!(refused.contains("t.bdf:4"), "{refused}");
}

#[test]
fn parameters_of_shells_are_looked_at() {
    let shell = "GRID,1\nGRID,2,,1.\nGRID,3,,0.,1.\nCTRIA3,1,1,1,2,3\n";
    let given = |parameters: &str| {
        let deck = parse(&format!("{parameters}{shell}"));
        let found = deck.shell_parameters().map(|found| (found.k6rot, found.snorm_deg));
        (found.map_err(|error| error.to_string()), deck.shell_remark().is_some())
    };
    assert_eq!(given(""), (Ok((100.0, 20.0)), true));
    assert_eq!(given("PARAM,K6ROT,1.\nPARAM,SNORM,-1.\n"), (Ok((1.0, -1.0)), false));
    assert!(parse("GRID,1\n").shell_remark().is_none(), "there is no shell");
    assert!(
        parse(&shell.replace("CTRIA3", "CTRIAR")).shell_remark().is_none(),
        "it has rotations of its own"
    );
    for (bad, what) in [("PARAM,K6ROT,-1.\n", "K6ROT is -1"), ("PARAM,SNORM,90.\n", "SNORM is 90")] {
        assert!(given(bad).0.unwrap_err().contains(what));
    }
}

#[test]
fn splines_and_parameters() {
    let deck = parse(concat!(
        "SPLINE1,1,1001,1001,1020,5\nSPLINE2,2,1001,1021,1040,6,0.,,9\n",
        "PARAM,wtmass,.00259\nPARAM,POST,-1\nPARAM,AUTOSPC,YES\nPARAM,W,1.,2.\n"
    ));
    assert_eq!((deck.splines[&1].kind, deck.splines[&1].boxes), (SplineKind::Plate, (1001, 1020)));
    assert_eq!(
        deck.splines[&2].kind,
        SplineKind::Beam { system: 9, torsional_ratio: 1.0, attachment: [0.0; 2] }
    );
    assert_eq!((deck.parameters["WTMASS"], deck.parameters["POST"]), (0.002_59, -1.0));
    assert_eq!(
        (deck.parameters.len(), deck.unknown["PARAM"].count),
        (3, 1),
        "complex numbers and words other than those of AUTOSPC are counted"
    );
}
