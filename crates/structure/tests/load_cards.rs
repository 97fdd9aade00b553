//! Loads of a deck's cards, against closed forms and equilibrium.

use faer::Mat;
use nalgebra::Vector3;
use nastran::{BulkData, parse_deck};
use structure::nonlinear::{Loads, reactions_of};
use structure::{Flexibility, Model, System, load_sets, loads_of};

fn deck(cards: &str) -> BulkData {
    parse_deck("test.bdf", cards).expect("a deck")
}

/// Sum of forces and of moments about the origin.
fn resultant(system: &System, forces: &Mat<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let mut sum = (Vector3::zeros(), Vector3::zeros());
    for (node, point) in system.points().iter().enumerate() {
        let of = |first: usize| Vector3::from_fn(|i, _| forces[(6 * node + first + i, 0)]);
        sum.0 += of(0);
        sum.1 += point.coords.cross(&of(0)) + of(3);
    }
    sum
}

/// A box of 2 x 3 x 4 as one solid, and a plate of 2 x 3 on its top.
const BOX: &str = "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nGRID,3,,2.,3.,0.\nGRID,4,,0.,3.,0.\nGRID,5,,0.,0.,4.\n\
    GRID,6,,2.,0.,4.\nGRID,7,,2.,3.,4.\nGRID,8,,0.,3.,4.\nCHEXA,1,1,1,2,3,4,5,6\n,7,8\nPSOLID,1,1\n\
    MAT1,1,7.+10,,.3,100.\nCQUAD4,2,2,5,6,7,8\nPSHELL,2,1,.1,1,,1\nSPC1,1,123456,1,2,3,4\n";

fn summed(cards: &str, set: u32) -> (Vector3<f64>, Vector3<f64>) {
    let bulk = deck(&(BOX.to_owned() + cards));
    let system = System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a system");
    resultant(&system, &system.forces_of(&loads_of(&bulk, set).expect("loads")))
}

#[track_caller]
fn near(own: Vector3<f64>, expected: [f64; 3], what: &str) {
    let expected = Vector3::from(expected);
    assert!((own - expected).norm() < 1e-9 * (1.0 + expected.norm()), "{what}: {own} for {expected}");
}

#[test]
fn sums_of_loads_may_be_summed_but_not_in_a_circle() {
    let cards = "FORCE,1,7,,2.,1.,0.,3.\nFORCE,2,6,,1.,0.,1.,0.\nLOAD,3,2.,1.,1,.5,2\nLOAD,4,3.,1.,3,-1.,2\n";
    // 3 (2 (F1 + .5 F2) - F2) = 6 F1
    near(summed(cards, 4).0, [12.0, 0.0, 36.0], "twice");
    // Each sums the one before it twice, sixty times over; and one within the other a hundred thousand times.
    let sums = |sets: std::ops::Range<u32>, parts: &dyn Fn(u32) -> String| {
        sets.map(|set| format!("LOAD,{},1.,{}\n", set + 1, parts(set))).collect::<Vec<_>>().concat()
    };
    let doubled = sums(10..70, &|set| format!(".5,{set},.5,{set}"));
    near(summed(&format!("FORCE,10,7,,2.,1.,0.,3.\n{doubled}"), 70).0, [2.0, 0.0, 6.0], "doubled");
    let deep = sums(10..100_010, &|set| format!("1.,{set}"));
    assert_eq!(deck(&deep).summed_sets(100_010), Ok(vec![(1.0, 10)]));
    let circle = deck(&format!("{BOX}{cards}LOAD,5,1.,1.,6\nLOAD,6,1.,1.,5,1.,1\n"));
    let error = loads_of(&circle, 6).expect_err("refused").to_string();
    assert!(error.contains("LOAD 6 is a part of itself"), "{error}");
}

#[test]
fn accelerated_grids_push_the_masses_that_they_carry() {
    // Eighths of the box's 2400 kg at its corners, quarters of the plate's 60 kg at the upper ones (.1 m of 100 kg/m³), and a body.
    let at = |cards: &str| summed(&format!("CONM2,9,7,,5.,.5,0.,0.\n{cards}"), 1);
    near(at("ACCEL1,1,,2.,1.,0.,3.\n,1\n").0, [600.0, 0.0, 1800.0], "a corner below");
    let (force, moment) = at("ACCEL1,1,,2.,0.,0.,1.\n,7\n");
    near(force, [0.0, 0.0, 640.0], "a corner above");
    near(moment, [3.0 * 640.0, -2.0 * 630.0 - 2.5 * 10.0, 0.0], "the body stands beside its grid");
    // All of them are weight.
    let all = at("ACCEL1,1,,2.,1.,0.,3.\n,1,THRU,8\n");
    let weight = at("GRAV,1,,2.,1.,0.,3.\n");
    near(all.0, weight.0.into(), "force");
    near(all.1, weight.1.into(), "moment");
    let error = loads_of(&deck(&format!("{BOX}ACCEL1,1,,2.,1.\n,77\n")), 1).unwrap_err().to_string();
    assert!(error.contains("ACCEL1 of set 1 refers to GRID 77"), "{error}");
}

/// Springs of 2 and 3 N/m in a row from the ground, loaded by 6 and 1.5 N: u1 = 7.5/2, u2 = u1 + 1.5/3.
#[test]
fn loads_of_scalar_points_act_on_their_one_motion() {
    let chain = "CELAS4,1,2.,7\nCELAS4,2,3.,7,9\nGRID,1,,0.,0.,0.,,123456\n";
    let bulk = deck(&(chain.to_owned() + "SLOAD,5,7,6.,9,1.5\nLOAD,6,2.,1.,5\n"));
    let system = System::assemble(&Model::from_deck(&bulk, None).expect("a model")).expect("a system");
    for (set, times) in [(5, 1.0), (6, 2.0)] {
        let loads = system.forces_of(&loads_of(&bulk, set).expect("loads"));
        let held = Flexibility::new(&system).expect("it is held");
        let u = system.expand(held.displacements(system.reduce(loads.as_ref()).as_ref()).as_ref());
        for (point, expected) in [(7, 3.75), (9, 4.25)] {
            let own = u[(6 * system.node_index(point).expect("a point"), 0)];
            assert!((own - times * expected).abs() < 1e-12, "{point}: {own}");
        }
    }
    let wrong = loads_of(&deck(&(chain.to_owned() + "SLOAD,5,1,6.\n")), 5).unwrap_err().to_string();
    assert!(
        wrong.contains("1 is a GRID, not a scalar point (hint: load a GRID by FORCE or MOMENT)"),
        "{wrong}"
    );
}

#[test]
fn pressures_push_along_the_normal_of_shells_and_into_solids() {
    // The plate's grids run so that its normal is +z: 6 m^2 at the middle (1, 1.5).
    // Ranges run over the shells that there are.
    let ranges = ["PLOAD2,5,10.,2,THRU,9\n", "PLOAD4,5,2,10.,,,,THRU,9\n"];
    for card in ranges.into_iter().chain(["PLOAD2,5,10.,2\n", "PLOAD4,5,2,10.\n", "PLOAD,5,10.,5,6,7,8\n"]) {
        let (force, moment) = summed(card, 5);
        near(force, [0.0, 0.0, 60.0], card);
        near(moment, [90.0, -60.0, 0.0], card);
    }
    // Into the solid: its side x = 2 is pushed along -x, its bottom along +z, and the top along -z.
    near(summed("PLOAD4,5,1,10.,,,,2,7\n", 5).0, [-120.0, 0.0, 0.0], "the side");
    near(summed("PLOAD4,5,1,10.,,,,1,3\n", 5).0, [0.0, 0.0, 60.0], "the bottom");
    near(summed("PLOAD4,5,1,10.,,,,8,6\n", 5).0, [0.0, 0.0, -60.0], "the top");
    // Linear between the corners: 0 at y = 0, 12 at y = 3: its centre is at y = 2.
    let (force, moment) = summed("PLOAD4,5,2,0.,0.,12.,12.\n", 5);
    near(force, [0.0, 0.0, 36.0], "the mean");
    near(moment, [72.0, -36.0, 0.0], "the centre of pressure");
}

#[test]
fn sums_scale_their_sets_and_weight_is_that_of_the_mass() {
    // 100 kg/m^3 in 24 m^3 and in .6 m^3.
    let cards = "FORCE,1,7,,2.,1.,0.,3.\nMOMENT,1,7,,1.,0.,4.,0.\nGRAV,2,,10.,0.,0.,-1.\nLOAD,9,2.,3.,1,.5,2\n\
        FORCE1,3,6,5.,6,7\n";
    let (force, moment) = summed(cards, 1);
    near(force, [2.0, 0.0, 6.0], "FORCE");
    near(moment, [18.0, 0.0, -6.0], "its moment and MOMENT");
    near(summed(cards, 2).0, [0.0, 0.0, -24_600.0], "GRAV");
    near(summed(cards, 9).0, [12.0, 0.0, 36.0 - 24_600.0], "LOAD");
    near(summed(cards, 3).0, [0.0, 5.0, 0.0], "FORCE1 along y");
    assert_eq!(load_sets(&deck(cards)), [1, 2, 3, 9]);
}

#[test]
fn reactions_of_ties_arrive_at_the_clamps() {
    let cards = "GRID,9,,1.,1.5,9.\nRBE3,20,,9,123456,1.,123,5,6\n,7,8\nFORCE,1,9,,5.,1.,2.,3.\n\
        GRID,10,,7.,7.,7.\nRBE2,21,9,123456,10\nMOMENT,1,10,,1.,6.,5.,4.\nFORCE,1,10,,1.,0.,0.,8.\n";
    let bulk = deck(&(BOX.to_owned() + cards));
    let model = Model::from_bulk(&bulk).expect("a model");
    let system = System::assemble(&model).expect("a system");
    let forces = system.forces_of(&loads_of(&bulk, 1).expect("loads"));
    let u_f = Flexibility::new(&system).expect("held").displacements(system.reduce(forces.as_ref()).as_ref());
    let unbalanced = system.elastic_loads(system.expand(u_f.as_ref()).as_ref()) - &forces;
    let unbalanced: Vec<f64> = unbalanced.col(0).iter().copied().collect();
    let given = reactions_of(&model, &unbalanced).expect("reactions");
    let (force, moment) = resultant(&system, &forces);
    let (own, turning) = resultant(&system, &Mat::from_fn(given.len(), 1, |i, _| given[i]));
    assert!((own + force).norm() < 1e-8 * force.norm(), "{own} {force}");
    assert!((turning + moment).norm() < 1e-8 * moment.norm(), "{turning} {moment}");
}

#[test]
fn what_is_not_read_or_not_there_is_said() {
    let said =
        |cards: &str, set: u32| loads_of(&deck(&(BOX.to_owned() + cards)), set).unwrap_err().to_string();
    for (cards, set, expected) in [
        ("FORCE,1,7,,2.,1.,0.,3.\n", 2, "no loads of set 2 (hint: there are 1)"),
        ("FORCE,1,77,,2.,1.,0.,3.\n", 1, "FORCE of set 1 refers to GRID 77"),
        ("FORCE,1,7,,2.,1.,0.,3.\nACCEL,1,7,,2.,0.,0.,1.\n", 1, "ACCEL is a load that is not read"),
        ("RFORCE,1,77,,2.,0.,0.,1.\n", 1, "RFORCE of set 1 refers to GRID 77"),
        ("PLOAD2,1,2.,1\n", 1, "PLOAD2 of set 1 presses on element 1"),
        ("PLOAD4,1,1,2.,,,,1,2\n", 1, "name no face of a solid 1"),
        ("LOAD,1,1.,1.,4\n", 1, "no loads of set 4"),
    ] {
        let own = said(cards, set);
        assert!(own.contains(expected), "{own}");
    }
    assert_eq!(Loads::default().times(3.0), Loads::default());
}

#[test]
fn forces_across_two_lines_are_those_along_their_normal_and_follow_it() {
    // Along x by 2, along y by 3: the normal is +z, and -z the other way round.
    for (cards, expected) in [
        ("FORCE2,5,7,40.,5,6,5,8\n", "FORCE,5,7,,40.,0.,0.,1.\n"),
        ("FORCE2,5,7,40.,5,8,5,6\n", "FORCE,5,7,,40.,0.,0.,-1.\n"),
        ("MOMENT2,5,7,40.,6,7,6,2\n", "MOMENT,5,7,,40.,-1.,0.,0.\n"),
        ("FORCE2,4,7,40.,5,6,5,8\nLOAD,5,2.,1.5,4\n", "FORCE,5,7,,120.,0.,0.,1.\n"),
    ] {
        let ((force, moment), (f, m)) = (summed(cards, 5), summed(expected, 5));
        near(force, f.into(), cards);
        near(moment, m.into(), cards);
    }
    // Turned by a quarter about y, +z becomes +x.
    let bulk = deck(&(BOX.to_owned() + "FORCE2,5,7,40.,5,6,5,8\n"));
    let wing = structure::nonlinear::LargeDeflection::new(&Model::from_bulk(&bulk).expect("a model"))
        .expect("a structure");
    let quarter = nalgebra::Rotation3::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
    let forces = wing.load_forces(&wing.undeformed().turned(&quarter), &loads_of(&bulk, 5).expect("loads"));
    let total = forces.chunks_exact(6).map(|six| Vector3::from_column_slice(&six[..3])).sum::<Vector3<f64>>();
    near(total, [40.0, 0.0, 0.0], "turned");
    for (card, said) in [("FORCE2,5,7,40.,5,6,8,7\n", "parallel"), ("FORCE2,5,7,40.,5,6,5,99\n", "99")] {
        let error = loads_of(&deck(&(BOX.to_owned() + card)), 5).expect_err("refused").to_string();
        assert!(error.contains(said), "{error}");
    }
}

#[test]
fn a_rotation_pushes_masses_outward_as_particles_are() {
    // Closed form: m w^2 r from the axis; A is in revolutions, as Nastran's and NASTRAN-95's manuals say.
    let w2 = (2.0 * std::f64::consts::PI * 3.0).powi(2);
    // About z through grid 5, (0, 0, 4): a body of 2 kg at (2, 3, 4).
    let (force, moment) = summed("CONM2,9,7,,2.\nRFORCE,1,5,,3.,0.,0.,1.\n", 1);
    let (whole, _) = summed("RFORCE,1,5,,3.,0.,0.,1.\n", 1);
    near((force - whole) / w2, [4.0, 6.0, 0.0], "a body");
    assert!((moment.z / w2).abs() < 1e-6, "no force turns the axis: {moment}");
    // The box of 24 m^3 with 100 kg/m^3, the plate of .6 m^3: all of it at its middle, whatever the mass's form.
    near(whole / w2, [2460.0, 3690.0, 0.0], "the box and the plate");
    // About x through the origin, the vector along another system's axis.
    let turned = "CORD2R,3,,0.,0.,0.,1.,0.,0.\n,0.,1.,0.\nRFORCE,1,,3,1.5,0.,0.,2.\n";
    near(summed(turned, 1).0 / w2, [0.0, 3690.0, 2400.0 * 2.0 + 60.0 * 4.0], "turned");
    // A body beside its grid is two particles on a rod: the middle at (3, 3, 6), .5 along (1, 1, 0) and back.
    let body = "CONM2,9,7,,8.,1.,0.,2.\n,2.,2.,2.,0.,0.,4.\nRFORCE,1,5,,3.,1.,2.,.5\n";
    let pair = "GRID,11,,3.5,3.5,6.\nGRID,12,,2.5,2.5,6.\nCONM2,9,11,,4.\nCONM2,10,12,,4.\nRBE2,9,7,123456,11,12\n\
        RFORCE,1,5,,3.,1.,2.,.5\n";
    let ((force, moment), (f, m)) = (summed(body, 1), summed(pair, 1));
    assert!((force - f).norm() < 1e-9 * f.norm(), "{force} for {f}");
    assert!((moment - m).norm() < 1e-9 * m.norm(), "{moment} for {m}");
}
