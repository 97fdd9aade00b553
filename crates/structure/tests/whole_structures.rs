//! Assembled structures: changes of mass, parts of motions, pictures, forms of mass, scalings.

use crate::common::{beam, close, section, system};
use faer::Mat;
use nalgebra::DMatrix;
use nastran::parse_deck;
use std::fmt::Write as _;
use structure::mesh::{CellShape, cells};
use structure::{MassForm, Model, ModesError, System, normal_modes};

/// A beam with a body on an arm, a turned grid among its own.
fn winged(mass: &str) -> String {
    beam(1, 3, 2.0, 0.0)
        + &section()
        + "CORD2R,5,,0.,0.,0.,1.,2.,2.,\n,1.,0.,0.\nGRID,9,,.5,2.,.3,5\nRBE2,9,4,123456,9\nSPC1,1,123456,1\n"
        + mass
}

/// Frequencies and masses alike.
#[track_caller]
fn same(one: &System, other: &System) {
    let [a, b] = [one, other].map(|system| normal_modes(system, 6).expect("modes").omega_rad_s);
    a.iter().zip(&b).for_each(|(a, b)| close(*a, *b, 1e-8, "frequency"));
    let n = 6 * one.node_count();
    let motion = Mat::from_fn(n, 1, |i, _| (1.3 * i as f64).sin());
    let [a, b] = [one, other].map(|system| system.inertia_loads(motion.as_ref()));
    assert!((0..n).all(|i| (a[(i, 0)] - b[(i, 0)]).abs() < 1e-12 * a.norm_max()));
}

#[test]
fn a_change_of_mass_is_the_structure_with_the_other_mass() {
    // At a grid of its own, at one that follows, at one that is partly held.
    for (grid, held) in [(3, ""), (9, ""), (2, "SPC1,1,26,2\n")] {
        let body = |m: f64| format!("CONM2,20,{grid},,{m:?},.1,-.2,.3\n,.4,.01,.5,.02,.03,.6\n{held}");
        let before = system(&winged(&body(2.0)));
        let node = before.node_index(grid).expect("it is there");
        // One more kilogramme at the same arm: m E, m r x and m (r.r - r r).
        let arm = nalgebra::Vector3::new(0.1, -0.2, 0.3);
        let cross = arm.cross_matrix();
        let mut change = DMatrix::zeros(6, 6);
        change.view_mut((0, 0), (3, 3)).fill_with_identity();
        change.view_mut((0, 3), (3, 3)).copy_from(&-cross);
        change.view_mut((3, 0), (3, 3)).copy_from(&cross);
        change.view_mut((3, 3), (3, 3)).copy_from(&(-cross * cross));
        let dofs: Vec<usize> = (6 * node..6 * node + 6).collect();
        let changed = before.with_mass_change(&dofs, &change).expect("one body joins them");
        same(&changed, &system(&winged(&body(3.0))));
    }
    // The mass alone at a grid that follows a turned arm.
    let body = |m: f64| format!("CONM2,20,9,,{m:?}\n");
    let before = system(&winged(&body(2.0)));
    let node = before.node_index(9).expect("it is there");
    let changed = before.with_mass_change(&[6 * node, 6 * node + 1, 6 * node + 2], &DMatrix::identity(3, 3));
    same(&changed.expect("one body joins them"), &system(&winged(&body(3.0))));
    // Nothing joins the root and the tip.
    assert!(before.with_mass_change(&[6, 20], &DMatrix::identity(2, 2)).is_none());
}

#[test]
fn rows_of_all_motions_are_those_of_some() {
    let system = system(&winged(""));
    let free = Mat::from_fn(system.free_count(), 2, |i, j| (1.3 * i as f64 + j as f64).sin());
    let all = system.expand(free.as_ref());
    let dofs = [7, 29, 24, 0];
    let some = system.expand_at(free.as_ref(), &dofs);
    assert_eq!((some.nrows(), some.ncols(), all.nrows()), (4, 2, 30));
    for (row, dof) in dofs.into_iter().enumerate() {
        assert!((0..2).all(|j| some[(row, j)] == all[(dof, j)]));
    }
    // Free motions are those of the middle of the beam and its tip.
    assert_eq!(system.free_dofs(), (6..24).collect::<Vec<_>>());
    assert_eq!((system.name(0), system.name(17)), ((2, 1), (4, 6)));
    assert_eq!(
        (system.node_index(9), system.node_index(7), system.node_ids()),
        (Some(4), None, &[1, 2, 3, 4, 9][..])
    );
    assert!((0..5).all(|node| system.is_attached(node)) && system.auto_held().is_empty());
}

#[test]
fn stiffness_and_mass_of_elements_scale_one_by_one() {
    let deck = winged("CONM2,20,4,,2.\n");
    let model = Model::from_bulk(&parse_deck("t.bdf", &deck).expect("a deck")).expect("a model");
    let scaled =
        System::assemble_scaled(&model, |at| if at == 1 { [4.0, 9.0] } else { [1.0, 1.0] }).expect("sound");
    let plain = System::assemble(&model).expect("sound");
    let all = System::assemble_scaled(&model, |_| [4.0, 9.0]).expect("sound");
    let n = 6 * plain.node_count();
    let motion = Mat::from_fn(n, 1, |i, _| (1.7 * i as f64).sin());
    let own = DMatrix::from_fn(12, 1, |i, _| motion[(6 + i, 0)]);
    let [k, m] = [model.elements[1].stiffness(), model.elements[1].mass()]
        .map(|matrix| &*matrix.expect("both") * &own);
    let sides =
        |system: &System| [system.elastic_loads(motion.as_ref()), system.inertia_loads(motion.as_ref())];
    for (at, (([one, other], extra), factor)) in sides(&scaled)
        .into_iter()
        .zip(sides(&plain))
        .map(|(a, b)| [a, b])
        .zip([k * 3.0, m * 8.0])
        .zip([4.0, 9.0])
        .enumerate()
    {
        let whole = &sides(&all)[at];
        for i in 0..n {
            let added = if (6..18).contains(&i) { extra[(i - 6, 0)] } else { 0.0 };
            assert!((one[(i, 0)] - other[(i, 0)] - added).abs() < 1e-9 * one.norm_max(), "{at} {i}");
            assert!((whole[(i, 0)] - factor * other[(i, 0)]).abs() < 1e-9 * whole.norm_max(), "{at} {i}");
        }
    }
}

#[test]
fn forms_of_mass_are_those_that_parameters_name() {
    let form = |parameter: &str, as_nastran: bool| {
        let bulk = parse_deck("t.bdf", &(parameter.to_owned() + &winged(""))).expect("a deck");
        let model = if as_nastran { Model::from_deck(&bulk, None) } else { Model::from_bulk(&bulk) };
        let model = model.expect("a model");
        (model.mass_form, model.holds_loose)
    };
    for (parameter, own, of_deck) in [
        ("", MassForm::Consistent, MassForm::Lumped),
        ("PARAM,COUPMASS,1\n", MassForm::Consistent, MassForm::Consistent),
        ("PARAM,COUPMASS,0\n", MassForm::Consistent, MassForm::Lumped),
        ("PARAM,COUPMASS,-1\n", MassForm::Lumped, MassForm::Lumped),
    ] {
        assert_eq!(
            (form(parameter, false), form(parameter, true)),
            ((own, false), (of_deck, true)),
            "{parameter}"
        );
    }
    assert_eq!(form("PARAM,AUTOSPC,NO\n", true), (MassForm::Lumped, false));
}

/// Nastran's bars have no twisting inertia, its beams have (MSC.Nastran Quick Reference Guide, NASTRAN statement, BARMASS = 0; a modes deck of
/// pyYeti with the print of NX Nastran has its four digits only without).
#[test]
fn a_bar_of_a_deck_has_no_twisting_inertia() {
    let twisting = |cards: &str, as_nastran: bool| {
        let deck =
            format!("PARAM,COUPMASS,1\nGRID,1,,0.,0.,0.\nGRID,2,,3.,0.,0.\nMAT1,1,7.+10,,.3,2700.\n{cards}");
        let bulk = parse_deck("t.bdf", &deck).expect("a deck");
        let model = if as_nastran { Model::from_deck(&bulk, None) } else { Model::from_bulk(&bulk) };
        let mass =
            model.expect("a model").elements().next().expect("a bar").mass().expect("mass").into_owned();
        mass[(3, 3)]
    };
    let bar = "CBAR,1,1,1,2,0.,0.,1.\nPBAR,1,1,.01,2.-5,1.-5,1.-5\n";
    let beam = "CBEAM,1,1,1,2,0.,0.,1.\nPBEAM,1,1,.01,2.-5,1.-5,,1.-5\n";
    // rho (I1 + I2) L / 3
    let own = 2700.0 * 3e-5;
    assert_eq!(twisting(bar, true), 0.0);
    for (cards, as_nastran) in [(bar, false), (beam, true), (beam, false)] {
        assert!((twisting(cards, as_nastran) - own).abs() < 1e-9 * own, "{cards}");
    }
}

/// Eight straight legs of five bars, free, bars of a tenth beside others: grids whose bars lie in one line have no mass in twisting. There are as
/// many modes as the mass has rank, six of them rigid, and the lowest twenty are those of another way to compute them.
#[test]
fn all_modes_of_a_free_frame_of_bars_are_found() {
    const LEGS: usize = 8;
    const BARS: usize = 5;
    let mut deck = "PARAM,COUPMASS,1\nMAT1,1,7.+10,,.3,2700.\nGRID,1,,0.,0.,0.\n".to_owned();
    let (mut place, mut grid) = ([0.0; 3], 1);
    for leg in 0..LEGS {
        let along = [[0.6, 0.5, 0.3], [-0.2, 0.7, 0.5], [0.5, -0.3, 0.8]][leg % 3];
        let [area, inertia] = [[0.01, 2e-5], [1e-3, 2e-7], [1e-4, 2e-9], [1e-5, 2e-11]][leg % 4];
        let section = leg + 1;
        let _ = writeln!(deck, "PBAR,{section},1,{area:?},{inertia:?},{inertia:?},{inertia:?}");
        for _ in 0..BARS {
            (0..3).for_each(|axis| place[axis] += along[axis]);
            let ([x, y, z], next) = (place, grid + 1);
            let _ = writeln!(deck, "GRID,{next},,{x:.6},{y:.6},{z:.6}");
            let _ = writeln!(deck, "CBAR,{grid},{section},{grid},{next},.3,-.4,.5");
            grid = next;
        }
    }
    let bulk = parse_deck("t.bdf", &deck).expect("a deck");
    let system = System::assemble(&Model::from_deck(&bulk, None).expect("a model")).expect("a system");
    // the two ends, and the grids within a leg
    let rank = 6 * grid - 2 - LEGS * (BARS - 1);
    let too_many = normal_modes(&system, 6 * grid).expect_err("too many");
    assert_eq!(too_many, ModesError::TooMany { asked: 6 * grid, available: rank });
    let modes = normal_modes(&system, rank).expect("all");
    assert_eq!(modes.omega_rad_s.iter().filter(|omega| **omega == 0.0).count(), 6);
    let few = normal_modes(&system, 20).expect("twenty");
    // Rounding the entries of the stiffness alone moves each eigenvalue by so much.
    let rounding = f64::EPSILON * modes.omega_rad_s[rank - 1].powi(2);
    for (all, few) in modes.omega_rad_s.iter().zip(&few.omega_rad_s) {
        assert!((all * all - few * few).abs() <= rounding.max(1e-6 * few * few), "{all} {few}");
    }
}

/// Lumped, a rod has half of its mass at each end and a plate a quarter at each corner; rotations have none.
#[test]
fn lumped_masses_are_the_sums_of_rows_of_displacements() {
    let deck = "PARAM,COUPMASS,-1\nGRID,1,,0.,0.,0.\nGRID,2,,3.,0.,4.\nCROD,1,1,1,2\nPROD,1,1,.01,.02,,5.\n\
        MAT1,1,7.+10,,.3,2700.\n\
        GRID,3,,9.,0.,0.\nGRID,4,,11.,0.,0.\nGRID,5,,11.,1.,0.\nGRID,6,,9.,1.,0.\nCQUAD4,2,2,3,4,5,6\n\
        PSHELL,2,1,.01,1,,1\n";
    let system = system(deck);
    let unit = Mat::<f64>::identity(36, 36);
    let mass = system.inertia_loads(unit.as_ref());
    for (i, j) in (0..36).flat_map(|i| (0..36).map(move |j| (i, j))) {
        let expected = if i != j || i % 6 > 2 {
            0.0
        } else if i < 12 {
            0.5 * 5.0 * (27.0 + 5.0)
        } else {
            0.25 * 2.0 * 27.0
        };
        assert!((mass[(i, j)] - expected).abs() < 1e-9, "{i} {j}: {}", mass[(i, j)]);
    }
}

#[test]
fn elements_are_drawn_by_their_corners_lines_first_and_arms_last() {
    let deck = "GRID,1\nGRID,2,,1.\nGRID,3,,1.,1.\nGRID,4,,0.,1.\nGRID,5,,0.,0.,1.\nGRID,6,,1.,0.,1.\n\
        GRID,7,,1.,1.,1.\nGRID,8,,0.,1.,1.\n\
        GRID,9,,.5,0.,0.\nGRID,10,,2.,2.,2.\nGRID,11,,3.,2.,2.\n\
        CHEXA,21,1,1,2,3,4,5,6\n,7,8\nCPENTA,22,1,1,2,4,5,6,8\nCTETRA,23,1,1,2,3,5,9\nPSOLID,1,1\n\
        MAT1,1,7.+10,,.3,2700.\n\
        CQUAD4,31,2,1,2,3,4\nCTRIA3,32,2,1,2,3\nCTRIA6,33,2,1,2,3,9\nPSHELL,2,1,.01,1,,1\nCSHEAR,34,3,1,2,6,5\n\
        PSHEAR,3,1,.01\n\
        CBAR,41,4,1,2,0.,1.,0.\nPBAR,4,1,1.,1.,1.,1.\nCROD,42,5,2,3\nPROD,5,1,1.\nCONROD,43,3,4,1,1.\n\
        CTUBE,44,6,4,1\nPTUBE,6,1,.1\n\
        CBUSH,45,7,1,10,,,,0\nCBUSH,46,7,10,,,,,0\nPBUSH,7,K,1.\nCELAS2,47,1.,1,1,5,1\nCELAS2,48,1.,1,1\n\
        CMASS2,49,1.,1,1,5,1\n\
        CONM2,50,1,,1.\nRBE2,61,10,123456,11\nRBE3,62,,9,123,1.,123,5,6\n,7\nMPC,63,8,1,1.,7,1,-1.\n";
    let bulk = parse_deck("t.bdf", deck).expect("a deck");
    let model = Model::from_bulk(&bulk).expect("a model");
    let system = System::assemble(&model).expect("a structure");
    let own: Vec<(u32, CellShape, Vec<usize>, bool)> = cells(&bulk, &system)
        .into_iter()
        .map(|cell| (cell.id, cell.shape, cell.nodes, cell.is_rigid))
        .collect();
    let (line, triangle, square) = (CellShape::Line, CellShape::Triangle, CellShape::Quadrilateral);
    let (tetrahedron, wedge, hexahedron) = (CellShape::Tetrahedron, CellShape::Wedge, CellShape::Hexahedron);
    let expected = [
        (41, line, vec![0, 1], false),
        (42, line, vec![1, 2], false),
        (43, line, vec![2, 3], false),
        (44, line, vec![3, 0], false),
        (45, line, vec![0, 9], false),
        (47, line, vec![0, 4], false),
        (34, square, vec![0, 1, 5, 4], false),
        (31, square, vec![0, 1, 2, 3], false),
        (32, triangle, vec![0, 1, 2], false),
        (33, triangle, vec![0, 1, 2], false),
        (21, hexahedron, vec![0, 1, 2, 3, 4, 5, 6, 7], false),
        (22, wedge, vec![0, 1, 3, 4, 5, 7], false),
        (23, tetrahedron, vec![0, 1, 2, 4], false),
        (61, line, vec![9, 10], true),
        (62, line, vec![8, 4], true),
        (62, line, vec![8, 5], true),
        (62, line, vec![8, 6], true),
    ];
    assert_eq!(own, expected);
    // Of a structure without some grids what they belong to is not drawn.
    let few = "GRID,1\nGRID,2,,1.\nGRID,3,,1.,1.\nCELAS2,1,1.,1,1\n";
    let few =
        System::assemble(&Model::from_bulk(&parse_deck("t.bdf", few).expect("a deck")).expect("a model"));
    let drawn: Vec<u32> = cells(&bulk, &few.expect("a structure")).iter().map(|cell| cell.id).collect();
    assert_eq!(drawn, [41, 42, 32, 33]);
}

/// F1 on the sides 1-2 and 3-4, F2 on the others: rods of half the factor times the thickness times the mean width
/// across.
#[test]
fn factors_of_a_panel_are_rods_along_its_sides() {
    let corners = [[0.0_f64, 0.0_f64], [1.2, 0.0], [1.0, 0.7], [0.1, 0.5]];
    let trace = |factors: &str| {
        let grid = |(id, [x, y]): (u32, [f64; 2])| format!("GRID,{id},,{x:?},{y:?}\n");
        let grids: String = (1..).zip(corners).map(grid).collect();
        let deck =
            format!("{grids}CSHEAR,1,1,1,2,3,4\nPSHEAR,1,1,.002,,{factors}\nMAT1,1,7.02+10,2.7+10,.3\n");
        let model = Model::from_bulk(&parse_deck("t.bdf", &deck).expect("a deck")).expect("a model");
        assert!(model.elements[0].mass().is_none(), "nothing weighs");
        model.elements[0].stiffness().expect("stiff").trace()
    };
    let length = |at: usize| {
        let ([a, b], [c, d]) = (corners[at % 4], corners[(at + 1) % 4]);
        (c - a).hypot(d - b)
    };
    let around: f64 = (0..4)
        .map(|at| {
            let ([a, b], [c, d]) = (corners[at], corners[(at + 1) % 4]);
            0.5 * (a * d - b * c)
        })
        .sum();
    // A rod's stiffness has the trace 2 E A / L.
    let rods = |first: usize, areas: &dyn Fn(f64) -> f64| -> f64 {
        let width = around / (0.5 * (length(first) + length(first + 2)));
        [first, first + 2].map(|side| 2.0 * 7.02e10 * areas(width) / length(side)).iter().sum()
    };
    let plain = trace("0.,0.");
    let share = |width: f64| 0.5 * 0.8 * 0.002 * width;
    let thick = |_: f64| 0.5 * 5.0 * 0.002 * 0.002;
    close(trace("0.8,0.") - plain, rods(0, &share), 1e-8, "F1 as a share of the width");
    close(trace("0.,0.8") - plain, rods(1, &share), 1e-8, "F2 as a share of the width");
    close(trace("5.,0.") - plain, rods(0, &thick), 1e-6, "F1 as a width in thicknesses");
    close(trace("0.8,5.") - plain, rods(0, &share) + rods(1, &thick), 1e-8, "both");
}

/// Masses of 1 and 2 kg on springs of 3 and 5 N/m to the ground, made to move as one: omega^2 = 8 / 3.
#[test]
fn a_motion_that_follows_another_one_to_one_brings_its_spring_and_its_mass() {
    let tied = system(
        "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nSPC1,1,12456,1,2\nCELAS2,1,3.,1,3\nCELAS2,2,5.,2,3\n\
         CONM2,3,1,,1.\nCONM2,4,2,,2.\nMPC,1,2,3,1.,1,3,-1.\n",
    );
    assert_eq!(tied.free_count(), 1);
    let omega = normal_modes(&tied, 1).expect("one mode").omega_rad_s[0];
    assert!((omega.powi(2) - 8.0 / 3.0).abs() < 1e-14, "{omega}");
}
