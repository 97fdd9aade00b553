//! Decks as Nastran reads them: lumped mass, boundary conditions of a subcase, scalar points, displacement systems, AUTOSPC.

use nastran::parse_deck;
use std::f64::consts::TAU;
use structure::{Model, System, normal_modes};

fn deck_system(deck: &str, subcase: Option<u32>) -> System {
    let bulk = parse_deck("deck.bdf", deck).unwrap_or_else(|error| panic!("{error}"));
    let model = Model::from_deck(&bulk, subcase).unwrap_or_else(|error| panic!("{error}"));
    System::assemble(&model).unwrap_or_else(|error| panic!("{error}"))
}

fn hertz(deck: &str, subcase: Option<u32>, count: usize) -> Vec<f64> {
    let modes = normal_modes(&deck_system(deck, subcase), count).unwrap_or_else(|error| panic!("{error}"));
    modes.omega_rad_s.iter().map(|omega| omega / TAU).collect()
}

fn assert_near(ours: &[f64], reference: &[f64], relative: f64, what: &str) {
    assert_eq!(ours.len(), reference.len(), "{what}");
    for (ours, reference) in ours.iter().zip(reference) {
        assert!((ours - reference).abs() <= relative * reference, "{what}: {ours} beside {reference}");
    }
}

/// A card a number.
fn cards(numbers: std::ops::RangeInclusive<u32>, card: impl Fn(u32) -> String) -> String {
    numbers.map(card).collect::<Vec<_>>().concat()
}

/// A cantilever of nine CBAR and one CBEAM of a round section with a mass at its tip, as the deck `beam_modes` of pyNastran's models.
fn bars_and_a_beam(parameters: &str) -> String {
    let grids = cards(1..=11, |grid| format!("GRID,{grid},,{}.\n", grid - 1));
    let bars = cards(1..=9, |bar| format!("CBAR,{bar},1,{bar},{},0.,1.,0.\n", bar + 1));
    format!(
        "SOL SEMODES\nCEND\nSPC = 1\nMETHOD = 1\nBEGIN BULK\n{parameters}{grids}{bars}CBEAM,10,3,10,11,0.,1.,0.\n\
         CONM2,21,11,,2.59-3\n,2.59-3,,2.59-3,,,2.59-3\nMAT1,2,3.+7,1.1628+7,.29,7.4851-4\n\
         PBARL,1,2,,ROD\n,1.\nPBEAML,3,2,,ROD\n,1.\nSPC,1,1,123456\n"
    )
}

#[test]
fn lumped_mass_gives_the_frequencies_that_simcenter_nastran_prints() {
    // pyNastran, models/beam_modes/beam_modes.f06 (Simcenter Nastran 2019): bending in pairs, then twist and stretch.
    let print =
        [456.6603, 456.6603, 2674.588, 2674.588, 3554.923, 4507.487, 6626.104, 6626.104, 11111.59, 11111.59];
    assert_near(&hertz(&bars_and_a_beam(""), None, 10), &print, 5e-7, "lumped, the default");
    let consistent = hertz(&bars_and_a_beam("PARAM,COUPMASS,1\n"), None, 10);
    assert!(
        (consistent[8] / print[8] - 1.0).abs() > 1e-3,
        "PARAM COUPMASS 1 is another mass: {}",
        consistent[8]
    );
}

/// Half of a free beam of twenty elements, its plane of symmetry at the first grid.
fn half_beam(subcases: &str) -> String {
    let grids = cards(1..=11, |grid| format!("GRID,{grid},,{:.1},,,,1246\n", f64::from(grid - 1) / 10.0));
    let bars = cards(1..=10, |bar| format!("CBAR,{bar},1,{bar},{},0.,0.,1.\n", bar + 1));
    format!(
        "CEND\n{subcases}BEGIN BULK\n{grids}{bars}PBAR,1,1,1.-4,1.-10,1.-10,2.-10\nMAT1,1,7.+10,,.3,2700.\nSPC1,1,5,1\nSPC1,2,3,1\n"
    )
}

#[test]
fn symmetric_and_antisymmetric_sets_are_kept_apart_and_give_the_modes_of_the_whole_free_beam() {
    let deck = half_beam("SUBCASE 1\nSPC=1\nSUBCASE 2\nSPC=2\n");
    let omega = |root: f64| (root / 2.0_f64).powi(2) * (70e9 * 1e-10 / (2700.0 * 1e-4_f64)).sqrt() / TAU;
    // Roots of cos(x) cosh(x) = 1 (Blevins, Formulas for Natural Frequency and Mode Shape, table 8-1).
    let symmetric = hertz(&deck, Some(1), 3);
    let antisymmetric = hertz(&deck, Some(2), 3);
    assert!(symmetric[0] < 1e-3 && antisymmetric[0] < 1e-3, "one rigid motion each");
    assert_near(&symmetric[1..], &[omega(4.730_041), omega(10.995_608)], 0.03, "symmetric");
    assert_near(&antisymmetric[1..], &[omega(7.853_205), omega(14.137_165)], 0.03, "antisymmetric");
    let open = Model::from_deck(&parse_deck("deck.bdf", &deck).unwrap(), None).unwrap_err().to_string();
    assert!(open.starts_with("the subcases differ in boundary conditions"), "{open}");
}

#[test]
fn scalar_points_carry_masses_and_springs_without_a_place() {
    // Ground, spring, mass, spring, mass: omega^2 = (3 -+ sqrt 5)/2.
    let golden =
        [(3.0 - 5.0_f64.sqrt()) / 2.0, f64::midpoint(3.0, 5.0_f64.sqrt())].map(|square| square.sqrt() / TAU);
    let by_points = "CELAS4,1,1.,7\nCELAS4,2,1.,7,9\nCMASS4,3,1.,7\nCMASS4,4,1.,9\n";
    assert_near(&hertz(by_points, None, 2), &golden, 1e-9, "CELAS4 and CMASS4");
    let mixed =
        "SPOINT,7,9\nPELAS,5,1.\nPMASS,6,1.\nCELAS1,1,5,7\nCELAS2,2,1.,7,,9\nCMASS3,3,6,7\nCMASS2,4,1.,9\n";
    assert_near(&hertz(mixed, None, 2), &golden, 1e-9, "CELAS1, CELAS2, CMASS3 and CMASS2");
    let held = "SPOINT,7,8,9\nCELAS4,1,1.,7,8\nCELAS4,2,1.,8,9\nCMASS4,3,1.,8\nCMASS4,4,1.,9\nSPC1,1,,7\n";
    assert_near(&hertz(held, None, 2), &golden, 1e-9, "SPC1 at a scalar point");
    let mass = deck_system(mixed, None).mass_properties().mass_kg;
    assert_eq!(mass, 0.0, "a scalar mass moves in no direction of space");
    let twice = parse_deck("d", "GRID,7\nCELAS4,1,1.,7\n").unwrap_err().to_string();
    assert!(twice.starts_with("d:2:1: 7 is a scalar point here and a GRID"), "{twice}");
}

#[test]
fn components_in_a_cylindrical_system_follow_the_place_of_the_grid() {
    // A mass at 30 degrees with springs of 400 along r, 100 along theta and 900 along z.
    let deck = "CORD2C,5,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRID,1,5,2.,30.,0.,5,456\nCONM2,1,1,,1.\n\
                CELAS2,1,400.,1,1\nCELAS2,2,100.,1,2\nCELAS2,3,900.,1,3\n";
    let modes = normal_modes(&deck_system(deck, None), 3).unwrap();
    assert_near(&modes.omega_rad_s, &[10.0, 20.0, 30.0], 1e-9, "springs along r, theta, z");
    let system = deck_system(deck, None);
    let shape = system.expand(modes.shapes.as_ref());
    let (x, y) = (shape[(0, 0)], shape[(1, 0)]);
    assert!(
        (x * 30.0_f64.to_radians().cos() + y * 30.0_f64.to_radians().sin()).abs() < 1e-9,
        "the softest moves along theta"
    );
}

#[test]
fn vectors_in_basic_and_element_axes_say_what_those_in_displacement_axes_say() {
    let beam = |vectors: &str| {
        let deck = format!(
            "CORD2R,5,,0.,0.,0.,0.,0.,1.\n,0.,1.,0.\nGRID,1,,0.,0.,0.,5\nGRID,2,,0.,2.,0.,5\n\
             CBAR,1,1,1,2,{vectors}\nPBAR,1,1,1.-4,3.-9,1.-9,2.-9\nMAT1,1,7.+10,,.3,2700.\nSPC1,1,123456,1\nCONM2,9,2,,1.\n"
        );
        hertz(&deck, None, 3)
    };
    // Displacement axes: x along basic y, y along basic -x. The bar goes along basic y; element y is basic z, element z basic x.
    let displacement = beam("0.,0.,1.,GGG\n,,,.1,0.,.2,.1,0.,.2");
    let basic = beam("0.,0.,1.,BGG\n,,,.1,0.,.2,.1,0.,.2");
    assert_near(&basic, &displacement, 1e-12, "z is z in both");
    let turned = beam("1.,0.,1.,BGG\n,,,.1,0.,.2,.1,0.,.2");
    let same_turned = beam("0.,-1.,1.,GGG\n,,,.1,0.,.2,.1,0.,.2");
    assert_near(&turned, &same_turned, 1e-12, "basic x is displacement -y");
    let element = beam("0.,0.,1.,GOO\n,,,.1,.2,0.,.1,.2,0.");
    assert_near(&element, &displacement, 1e-12, "element x along the bar, y up");
    assert!(
        (element[0] / beam("0.,0.,1.,GOO\n,,,.1,0.,.2,.1,0.,.2")[0] - 1.0).abs() > 1e-6,
        "and not the same with y and z exchanged"
    );
}

#[test]
fn motions_without_stiffness_at_their_grid_are_held_and_named() {
    // Two rods in a line: only the motion along them has stiffness. Fixed ends, k = 2 E A / L, half of each rod's mass at the middle.
    let deck = |parameter: &str| {
        format!(
            "{parameter}GRID,1,,0.,0.,0.\nGRID,2,,1.,1.,0.\nGRID,3,,2.,2.,0.\nCROD,1,1,1,2\nCROD,2,1,2,3\nPROD,1,1,1.-4\n\
                 MAT1,1,7.+10,,.3,2700.\nSPC1,1,123456,1,3,77\n"
        )
    };
    let system = deck_system(&deck(""), None);
    assert_eq!(system.auto_held().len(), 2, "{:?}", system.auto_held());
    assert!(system.auto_held().iter().all(|(grid, _)| *grid == 2), "{:?}", system.auto_held());
    let bulk = parse_deck("deck", &deck("PARAM,AUTOSPC,NO\n")).unwrap();
    assert!(System::assemble(&Model::from_deck(&bulk, None).unwrap()).unwrap().auto_held().is_empty());
}

#[test]
fn a_mass_that_nothing_holds_moves_only_where_autospc_is_off_as_msc_nastran_prints() {
    // pyNastran, models/transfer_function/actuator_tf_modeling.f06 (MSC Nastran 2005): its table of singularities names grid 3
    // component 1, its case control has AUTOSPC = NO, its modes are these.
    let print = [0.079_577_47, 0.275_664_4];
    let deck = |control: &str| {
        format!(
            "SOL 110\nCEND\n{control}BEGIN BULK\nGRID,1,,1.,0.,0.,,23456\nGRID,2,,2.,0.,0.,,23456\nGRID,3,,3.,0.,0.,,23456\n\
             CELAS2,21,1.0,1,1\nCELAS2,22,1.5,1,1,2,1\nCONM2,11,1,,1.\nCONM2,12,2,,2.\nCONM2,13,3,,.4\n"
        )
    };
    let free = hertz(&deck("AUTOSPC = NO\n"), None, 3);
    assert_eq!(free[0], 0.0, "the third mass flies away");
    assert_near(&free[1..], &print, 1e-6, "with AUTOSPC = NO");
    let system = deck_system(&deck(""), None);
    assert_eq!(system.auto_held(), [(3, 1)]);
    assert_near(&hertz(&deck(""), None, 2), &print, 1e-6, "held by AUTOSPC");
}

/// A strip pulled along its length is longer by F L / (E A), whatever transverse shear modulus its ply has: beside 1e15 Pa AUTOSPC held the membrane.
#[test]
fn a_huge_transverse_modulus_does_not_take_the_membrane_away() {
    let deck = "CEND\nSPC=1\nBEGIN BULK\nGRID,1\nGRID,2,,2.\nGRID,3,,2.,1.\nGRID,4,,0.,1.\nCQUAD4,1,1,1,2,3,4\nPCOMP,1\n,2,.1,0.\n\
                MAT8,2,2.+7,2.+7,0.,1.+7,1.+15,1.+15\nSPC1,1,13456,1,4\nSPC1,1,2,1\nFORCE,1,2,,500.,1.\nFORCE,1,3,,500.,1.\n";
    let system = deck_system(deck, None);
    assert!(!system.auto_held().iter().any(|(_, component)| *component < 3), "{:?}", system.auto_held());
    let bulk = parse_deck("deck.bdf", deck).expect("a deck");
    let loads = structure::loads_of(&bulk, 1).expect("loads");
    let load = system.reduce(system.forces_of(&loads).as_ref());
    let moved = system
        .expand(structure::Flexibility::new(&system).expect("held").displacements(load.as_ref()).as_ref());
    assert_near(&[moved[(6, 0)]], &[1000.0 * 2.0 / (2e7 * 0.1)], 1e-9, "longer");
}

#[test]
fn elements_whose_motions_follow_one_motion_store_nothing() {
    // MYSTRAN's benchmark SB-RBE2-01-CROD-05-MPC-03: five rods of E A / L = 1e4 in a row, grids 2 to 5 moving as one, 6 with 1, which is held:
    // the 1400 on them stretch the first rod and press the last, 1400 / 2e4 = .07 as MYSTRAN 18 prints.
    let rods = cards(1..=5, |rod| format!("CROD,{rod},20,{rod},{}\n", rod + 1));
    let grids = cards(1..=6, |grid| format!("GRID,{grid},,{}.,0.,0.,,23456\n", 10 * (grid - 1)));
    let forces = cards(2..=5, |grid| format!("FORCE,1,{grid},,{}.,1.,0.,0.\n", 100 * grid));
    let ties = "MPC,34,3,1,1.,4,1,-1.\nMPC,34,4,1,1.,5,1,-1.\nMPC,34,6,1,1.,1,1,-1.\nRBE2,32,3,1,2\n";
    let row = format!(
        "{grids}{rods}{forces}{ties}PROD,20,10,.01\nMAT1,10,1.+7,,.33,3.\nSPC1,1,1,1\nPARAM,COUPMASS,1\n"
    );
    assert_near(&moved(&row)[6..7], &[0.07], 1e-12, "the rods in the middle do not stretch");
    // They weigh: three whole ones, and a third of each of the two outside.
    let mass = 3.0 * 0.01 * 10.0 * (3.0 + 2.0 / 3.0);
    assert_near(&hertz(&row, None, 1), &[(2e4_f64 / mass).sqrt() / TAU], 1e-9, "nor do they oscillate");
    // A bush between two grids at one place that follow a third one does not hold it.
    let bush = "GRID,1,,0.,0.,0.,,3456\nGRID,2,,0.,0.,0.\nGRID,3,,0.,0.,0.\nRBE2,9,1,123456,2,3\nCBUSH,4,5,2,3,,,,0\n\
                PBUSH,5,K,7.+6,7.+6,7.+6,7.+6,7.+6,7.+6\nCELAS2,6,50.,1,1\nCELAS2,7,20.,1,2\nFORCE,1,2,,1.,1.,1.,0.\n";
    assert_near(&moved(bush)[..2], &[0.02, 0.05], 1e-12, "only the springs to the ground do");
}

/// Displacements of all grids under load set 1.
fn moved(deck: &str) -> Vec<f64> {
    let system = deck_system(deck, None);
    let bulk = parse_deck("deck.bdf", deck).expect("read before");
    let forces = system.forces_of(&structure::loads_of(&bulk, 1).expect("loads"));
    let held = structure::Flexibility::new(&system).expect("held");
    let u = system.expand(held.displacements(system.reduce(forces.as_ref()).as_ref()).as_ref());
    u.col(0).iter().copied().collect()
}

#[test]
fn a_stiffened_strip_bends_as_its_beams_do_however_few_the_elements() {
    // Beam theory: P L^3 / 3 E I with I of the bars and of the strip together (no lateral contraction), P L / (5/6 G A) by the strip's shear alone.
    // Elements without residual bending flexibility hold the bars to straight rotations: a third more stiffness with one of them.
    let (length, width, t, e) = (3.0_f64, 0.4_f64, 0.01_f64, 7e10);
    let strip = e * width * t.powi(3) / 12.0;
    for (count, shells, bars) in
        [(1, "CQUAD4", 0.0), (1, "CQUAD4", 2.0), (3, "CQUAD4", 2.0), (2, "CTRIA3", 1.0)]
    {
        let step = length / f64::from(count);
        let inertia = bars * strip / e;
        let section = format!(
            "PSHELL,1,1,{t},1,,1\nMAT1,1,{e:?},,0.,2700.\nPBAR,2,1,0.,{inertia:?},{inertia:?}\nSPC1,1,123456,100,200\n"
        );
        let grids = cards(0..=count, |at| {
            let x = f64::from(at) * step;
            format!("GRID,{},,{x:?},0.,0.\nGRID,{},,{x:?},{width:?},0.\n", 100 + at, 200 + at)
        });
        let elements = cards(0..=count - 1, |at| {
            let [a, b, c, d] = [100 + at, 101 + at, 201 + at, 200 + at];
            let shell = match shells {
                "CQUAD4" => format!("CQUAD4,1{at},1,{a},{b},{c},{d}\n"),
                _ => format!("CTRIA3,1{at},1,{a},{b},{c}\nCTRIA3,2{at},1,{a},{c},{d}\n"),
            };
            let pair = format!("CBAR,3{at},2,{a},{b},0.,0.,1.\nCBAR,4{at},2,{d},{c},0.,0.,1.\n");
            if bars > 0.0 { shell + &pair } else { shell }
        });
        let tip = [100 + count, 200 + count];
        let forces = tip.map(|grid| format!("FORCE,1,{grid},,.5,0.,0.,1.\n")).concat();
        let u = moved(&(section + &grids + &elements + &forces));
        let nodes = usize::try_from(count).expect("few");
        let rise = 0.5 * (u[6 * nodes + 2] + u[6 * (2 * nodes + 1) + 2]);
        let expected = length.powi(3) / (3.0 * strip * (1.0 + 2.0 * bars));
        let within = if shells == "CQUAD4" { 1e-4 } else { 0.03 };
        assert_near(&[rise], &[expected], within, &format!("{count} {shells}, bars {bars}"));
    }
}

/// A square of one element, its corners' moments as case control selects them.
fn plate(parameters: &str, constraint: &str, loads: &str) -> String {
    format!(
        "CEND\nSPC = 1\nBEGIN BULK\n{parameters}GRID,1\nGRID,2,,2.\nGRID,3,,2.,2.\nGRID,4,,0.,2.\nCQUAD4,1,1,1,2,3,4\nPSHELL,1,1,.01,1\n\
         MAT1,1,7.+10,3.5+10,,2700.\n{constraint}{loads}"
    )
}

fn displaced(deck: &str) -> impl Fn(u32, usize) -> f64 + use<> {
    let bulk = parse_deck("deck.bdf", deck).expect("a deck");
    let system = deck_system(deck, None);
    let loads = system.forces_of(&structure::loads_of(&bulk, 1).expect("loads"));
    let flexibility = structure::Flexibility::new(&system).expect("held");
    let u = system.expand(flexibility.displacements(system.reduce(loads.as_ref()).as_ref()).as_ref());
    move |grid, component| u[(6 * system.node_index(grid).expect("a grid") + component - 1, 0)]
}

/// The energy of rotations about the normal beyond the membrane's own is K6ROT / 2e6 of G t times the area and the sum of their squares at the corners
/// (found from MSC's print of `plate`, see `prints_of_nastran.rs`).
#[test]
fn rotations_about_the_normal_of_a_shell_have_the_stiffness_of_k6rot() {
    let moments = cards(1..=4, |grid| format!("MOMENT,1,{grid},,5.,0.,0.,1.\n"));
    let turned = |parameters: &str| displaced(&plate(parameters, "SPC1,1,12345,1,THRU,4\n", &moments))(1, 6);
    for (parameters, k6rot) in [("", 100.0), ("PARAM,K6ROT,100.\n", 100.0), ("PARAM,K6ROT,7.\n", 7.0)] {
        let expected = 5.0 / (k6rot * 1e-6 * 3.5e10 * 0.01 * 4.0);
        assert!((turned(parameters) / expected - 1.0).abs() < 1e-9, "{parameters}: {}", turned(parameters));
    }
    let held = deck_system(&plate("PARAM,K6ROT,0.\n", "SPC1,1,12345,1,THRU,4\n", ""), None);
    assert_eq!(held.auto_held(), [(1, 6), (2, 6), (3, 6), (4, 6)], "without it AUTOSPC holds them");
}

/// One element is a cantilever: P L^3 / 3 E I, without shear flexibility as MID3 is empty (linear rotations alone have a quarter for a third).
#[test]
fn a_strip_of_one_shell_bends_as_a_beam() {
    let tip =
        displaced(&plate("", "SPC1,1,123456,1,4\n", "FORCE,1,2,,1.,0.,0.,1.\nFORCE,1,3,,1.,0.,0.,1.\n"));
    let expected = 2.0 * 8.0 / (3.0 * 7e10 * 2.0 * 1e-6 / 12.0);
    assert!((tip(2, 3) / expected - 1.0).abs() < 1e-4, "{} beside {expected}", tip(2, 3));
}

/// Two shells that meet at a fold of less than SNORM share a normal there, about which turning costs only the tie; with SNORM of less than the fold each
/// resists by its own.
#[test]
fn shells_share_the_normal_of_a_grid_up_to_the_angle_of_snorm() {
    // Each stands off the plane by 5 degrees, 5 of them from the mean.
    let folded = |parameters: &str, reversed: &str| {
        let deck = format!(
            "CEND\nSPC = 1\nBEGIN BULK\nPARAM,K6ROT,.001\n{parameters}GRID,1,,-1.,0.,-.0874887\nGRID,2\nGRID,3,,1.,0.,-.0874887\n\
             GRID,4,,-1.,1.,-.0874887\nGRID,5,,0.,1.\nGRID,6,,1.,1.,-.0874887\nCQUAD4,1,1,1,2,5,4\n{reversed}PSHELL,1,1,.01,1\n\
             MAT1,1,7.+10,3.5+10,,2700.\nSPC1,1,123456,1,3,4,6\nSPC1,1,12345,5\nSPC1,1,12345,2\nMOMENT,1,2,,1.,0.,0.,1.\n"
        );
        displaced(&deck)(2, 6)
    };
    for second in ["CQUAD4,2,1,2,3,6,5\n", "CQUAD4,2,1,5,6,3,2\n"] {
        let (shared, own) = (folded("", second), folded("PARAM,SNORM,4.\n", second));
        assert!(shared > 100.0 * own, "{shared} {own}");
        assert!(
            (folded("PARAM,SNORM,6.\n", second) / shared - 1.0).abs() < 1e-9,
            "20 degrees is the default"
        );
        assert!((folded("PARAM,SNORM,0.\n", second) / own - 1.0).abs() < 1e-9, "zero: no shared normals");
    }
}

/// MAT1 with E alone has NU and G of zero (QRG, MAT1, remark 2): bars of it bend, and AUTOSPC holds their twist; a wing is not left without.
#[test]
fn bars_without_a_shear_modulus_bend_and_do_not_twist() {
    let bar = |material: &str, kind: &str| {
        format!(
            "GRID,1,,0.,0.,0.,,123456\nGRID,2,,1.,0.,0.\n{kind}\nPBAR,1,1,1.-4,1.-8,2.-8,1.-8\nPBEAM,2,1,1.-4,1.-8,2.-8,,1.-8\n\
             CONM2,3,2,,3.\n{material}\n"
        )
    };
    for kind in ["CBAR,1,1,1,2,0.,0.,1.", "CBEAM,1,2,1,2,0.,0.,1."] {
        let bare = bar("MAT1,1,7.+10", kind);
        assert_eq!(deck_system(&bare, None).auto_held(), [(2, 4)], "{kind}");
        // A shear modulus that is too large to be felt.
        assert_near(&hertz(&bare, None, 3), &hertz(&bar("MAT1,1,7.+10,7.+13", kind), None, 3), 1e-6, kind);
        let error = Model::from_bulk(&parse_deck("deck.bdf", &bare).expect("a deck")).expect_err("refused");
        assert!(error.to_string().contains("material 1 has G = 0, and beam property"), "{error}");
    }
}
