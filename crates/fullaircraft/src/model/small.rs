//! The cards of a small aircraft: numbers of its parts, beams of tail and fuselage, the body that closes its totals.

use crate::aircraft::file::RoundBeam;
use crate::aircraft::small;
use crate::model::{beam, cards, closing, fuselage, tail};
use coupling::wing_file::StationAt;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{BulkData, Conm2, Divisions, Span, Step};
use structure::{MassProperties, Model};

fn assert_same(what: &str, ours: f64, law: f64) {
    assert!((ours - law).abs() <= 1e-8 * law.abs().max(1e-6), "{what}: {ours}, the law says {law}");
}

#[test]
fn parts_have_a_step_of_numbers_each_and_the_wings_keep_theirs() {
    let (file, wing) = small::files();
    let cards = cards::build(&file, &wing).expect("cards");
    let (step, part) = (cards.step, |id: u32| id / cards.step.boxes);
    assert!(cards.right.grids.keys().chain(cards.right.masses.keys()).all(|id| *id < step.cards));
    for id in cards.right.grids.keys() {
        let (right, left) = (&cards.bulk.grids[id].xyz, &cards.bulk.grids[&(id + step.cards)].xyz);
        assert_eq!([left.x, left.y, left.z], [right.x, -right.y, right.z]);
    }
    // right and left wing, both halves of the horizontal tail, the vertical, four panels of the fuselage
    let mut parts: Vec<u32> = cards.bulk.panels.keys().map(|id| part(*id)).collect();
    parts.dedup();
    assert_eq!(parts, [0, 1, 2, 3, 4, 5]);
    let wings = cards.bulk.panels.keys().filter(|id| cards.is_wing_panel(**id)).count();
    assert_eq!(
        (wings, cards.bulk.panels.len()),
        (2 * cards.right.panels.len(), 2 * cards.right.panels.len() + 7)
    );
    assert!(!cards.is_wing_panel(2 * step.boxes) && cards.is_wing_panel(2 * step.boxes - 1));
    let images: Vec<u32> = cards.wing_spline.iter().map(|id| id + step.cards).collect();
    assert_eq!(cards.spline_of_panel(1), cards.wing_spline);
    assert_eq!(cards.spline_of_panel(step.boxes + 1), images);
    for (at, own) in cards.tail_splines.iter().enumerate() {
        let first = (2 + u32::try_from(at).expect("three")) * step.cards + 1;
        assert_eq!(own[..], (first..first + 5).collect::<Vec<_>>()[..]);
        assert_eq!(cards.spline_of_panel((2 + u32::try_from(at).expect("three")) * step.boxes + 1), *own);
    }
    assert_eq!(cards.spline_of_panel(5 * step.boxes + 1), cards.fuselage_spline);
    assert!(cards.bulk.grids.keys().all(|id| *id < cards.closing) && cards.closing > 6 * step.cards);
    assert_eq!(cards.bulk.grids[&cards.centre].xyz.x, cards.bulk.grids[&cards.wing_spline[0]].xyz.x);
    // the tail is tied to the fuselage's grid that is nearest to its root
    for tie in cards.bulk.rigid.values().filter(|tie| tie.id > 6 * step.cards) {
        let at = |id: u32| cards.bulk.grids[&id].xyz;
        for tied in &tie.dependent {
            let away = |id: &u32| (at(*id).x - at(*tied).x).abs();
            let nearest = cards.fuselage_spline.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
            assert_eq!(nearest, Some(&tie.independent), "tie {}", tie.id);
        }
    }
    let flow = cards.wings_in_flow();
    assert!(flow.panels.keys().all(|id| cards.is_wing_panel(*id)) && flow.panels.len() == wings);
    assert_eq!(flow.surfaces.len(), 4, "two pairs of ailerons");
    assert_eq!((flow.matrices["W2GJ"].rows, flow.matrices["W2GJ"].columns[0].len()), (24, 24));
    assert_eq!(cards.bulk.matrices["W2GJ"].rows, 42);
    assert_eq!(flow.grids.len(), cards.bulk.grids.len(), "the structure stays whole");
}

#[test]
fn a_beam_s_masses_are_those_of_half_an_element_each_way_and_its_section_has_its_stiffness() {
    let mut bulk = BulkData::default();
    let points = [0.0, 0.5, 2.0].map(|x| Point3::new(x, 0.0, 0.0));
    let of = RoundBeam { ei_nm2: 140.0, gj_nm2: 54.0, mass_kg_m: 3.0 };
    let ids = beam::add(&mut bulk, 11, &points, &of, &Vector3::z(), &Span::generated("t"));
    assert_eq!(ids, [11, 12, 13]);
    let masses: Vec<f64> = bulk.masses.values().map(|mass| mass.mass).collect();
    assert_eq!(masses, [0.75, 3.0, 2.25]);
    let model = MassProperties::of_model(&Model::from_bulk(&bulk).expect("a model"));
    assert_same("mass", model.mass_kg, 6.0);
    assert_eq!(bulk.beams.len(), 2);
}

#[test]
fn a_tail_has_its_taper_its_hinge_between_boxes_and_a_control_behind_it() {
    let (mut file, _) = small::files();
    let of = &mut file.htp;
    (of.boxes.chordwise, of.boxes.spanwise, of.control.chord_boxes, of.control.chord_share) = (5, 3, 2, 0.3);
    let bulk = tail::cards(of, &Vector3::y(), Step { cards: 1001, boxes: 5001 }, &Span::generated("t"));
    let panel = &bulk.panels[&5001];
    let sweep = 0.45 * 15.0_f64.to_radians().tan();
    assert_same("root", panel.point_1.x, 1.4265);
    assert_same("tip", panel.point_4.x, 1.4265 + sweep);
    assert_eq!([panel.point_4.y, panel.point_4.z], [0.45, 0.05]);
    assert_eq!((panel.chord_1, panel.chord_4, &panel.span_divisions), (0.17, 0.11, &Divisions::Equal(3)));
    let edges = &bulk.factors[&1001].values;
    let law = [0.0, 0.7 / 3.0, 1.4 / 3.0, 0.7, 0.85, 1.0];
    edges.iter().zip(law).for_each(|(edge, law)| assert!((edge - law).abs() < 1e-14, "{edges:?}"));
    assert_eq!(edges.len(), 6);
    assert_eq!(bulk.box_lists[&1001].boxes, [5004, 5005, 5009, 5010, 5014, 5015]);
    assert_eq!((bulk.surfaces[&1001].label.as_str(), bulk.matrices["W2GJ"].rows), ("elevator", 15));
    // grids along the quarter chord
    for (at, grid) in bulk.grids.values().enumerate() {
        let eta = at as f64 / 4.0;
        let chord = 0.17 - 0.06 * eta;
        assert_same("a grid", grid.xyz.x, 1.4265 + eta * sweep + 0.25 * chord);
        assert_same("a grid", grid.xyz.y, 0.45 * eta);
    }
    // the hinge's y axis runs along 70 % of the chord, z along the normal
    let nastran::CoordDefinition::Points { a, b, c, .. } = bulk.coords[&1001].definition.clone() else {
        panic!("three points")
    };
    assert_same("hinge", a.x, 1.4265 + 0.7 * 0.17);
    let along = (Vector3::new(sweep + 0.7 * (0.11 - 0.17), 0.45, 0.0)).normalize();
    assert!((b - a - Vector3::z()).norm() < 1e-12, "{b:?}");
    assert!(((c - a) - along.cross(&Vector3::z())).norm() < 1e-12, "{c:?}");
}

#[test]
fn a_fuselage_s_grids_are_a_decimetre_apart_and_one_is_at_the_wing_s_root() {
    let (file, _) = small::files();
    let x_m = fuselage::stations(&file.fuselage, 0.13);
    assert_eq!(x_m.len(), 24);
    for (at, x) in x_m.iter().enumerate() {
        // the ninth, at 0.1 m, is nearest to the root
        let law = if at == 8 { 0.13 } else { -0.7 + 0.1 * at as f64 };
        assert!((x - law).abs() < 1e-12, "{at}: {x}");
    }
    let mut short = file.fuselage.clone();
    short.x_m = (0.0, 0.2);
    assert_eq!(fuselage::stations(&short, 0.0).len(), 5, "four elements at least");
    let first = Step { cards: 2001, boxes: 6001 };
    let bulk = fuselage::cards(&file.fuselage, &x_m, 0.3, first, &Span::generated("t"));
    // horizontal arm ahead (one box, two strips) and behind (two), then the vertical one
    let panels: Vec<(u32, [f64; 3], [f64; 3], f64)> = bulk
        .panels
        .values()
        .map(|panel| (panel.id, panel.point_1.into(), panel.point_4.into(), panel.chord_1))
        .collect();
    let law = [
        (6001, [-0.7, -0.3, 0.0], [-0.7, 0.3, 0.0], 0.7),
        (6003, [0.45, -0.3, 0.0], [0.45, 0.3, 0.0], 1.15),
        (6007, [-0.7, 0.0, -0.08], [-0.7, 0.0, 0.08], 0.7),
        (6009, [0.45, 0.0, -0.08], [0.45, 0.0, 0.08], 1.15),
    ];
    for (panel, law) in panels.iter().zip(law) {
        assert_eq!((panel.0, panel.1, panel.2), (law.0, law.1, law.2));
        assert_same("chord", panel.3, law.3);
    }
    assert_eq!((panels.len(), bulk.matrices["W2GJ"].rows, bulk.masses.len()), (4, 12, 24));
}

#[test]
fn the_closing_body_brings_mass_centre_and_inertia_to_the_totals() {
    let aircraft = small::aircraft();
    let (total, mass) = (aircraft.file.total, &aircraft.mass);
    assert_same("mass", mass.mass_kg, total.mass_kg);
    assert!((mass.centre - Point3::new(total.x_cg_m, 0.0, 0.0)).norm() < 1e-9, "{:?}", mass.centre);
    assert_same("Ixx", mass.inertia_kg_m2[(0, 0)], total.ixx_kg_m2);
    assert_same("Iyy", mass.inertia_kg_m2[(1, 1)], total.iyy_kg_m2);
    assert_same("Izz", mass.inertia_kg_m2[(2, 2)], total.izz_kg_m2);
}

#[test]
fn a_closing_body_that_cannot_be_is_refused_and_one_that_can_has_steiners_share() {
    let aircraft = small::aircraft();
    let mut file = aircraft.file.clone();
    let rest = MassProperties {
        mass_kg: 5.0,
        centre: Point3::new(0.6, 0.0, 0.2),
        inertia_kg_m2: Matrix3::from_diagonal(&Vector3::new(0.1, 0.2, 0.3)),
    };
    let mut of = |mass_kg: f64, inertia: [f64; 3]| {
        file.total.mass_kg = mass_kg;
        [file.total.ixx_kg_m2, file.total.iyy_kg_m2, file.total.izz_kg_m2] = inertia;
        closing::mass(&file, &rest, 9, 8, &Point3::origin()).map_err(|error| error.to_string())
    };
    // of 20 kg at 0.4 m: 15 kg at 1/3 m, z = -1/15 m; arms from the totals' centre
    let share = [
        0.1 + 5.0 * 0.04 + 15.0 / 225.0,
        0.2 + 5.0 * 0.08 + 15.0 * (2.0 / 225.0),
        0.3 + 5.0 * 0.04 + 15.0 / 225.0,
    ];
    let with = |own: [f64; 3]| [0, 1, 2].map(|axis| share[axis] + own[axis]);
    let body = of(20.0, with([1.0, 1.5, 2.0])).expect("a body");
    let [x, xy, y, xz, yz, z] = body.inertia;
    for (own, law) in [(x, 1.0), (y, 1.5), (z, 2.0)] {
        assert_same("inertia", own, law);
    }
    assert_eq!([xy, xz, yz], [0.0; 3]);
    for possible in [[1.0, 1.0, 1.99], [1.99, 1.0, 1.0], [1.0, 1.99, 1.0]] {
        assert!(of(20.0, with(possible)).is_ok(), "{possible:?}");
    }
    for none in [[1.0, 1.0, 2.01], [2.01, 1.0, 1.0], [1.0, 2.01, 1.0], [-0.01, 1.0, 1.0], [1.0, 1.0, -0.01]] {
        assert!(of(20.0, with(none)).expect_err("no body").contains("which no body has"), "{none:?}");
    }
    for mass_kg in [5.0, 4.0] {
        assert!(of(mass_kg, [1.0; 3]).expect_err("too light").contains("weigh 5.000 kg already"));
    }
}

#[test]
fn a_body_s_mass_matrix_resists_the_six_motions_of_its_grid_as_a_body_beside_it_does() {
    let body = Conm2 {
        id: 1,
        grid: 2,
        cid: 0,
        mass: 3.0,
        offset: Vector3::new(0.2, 0.0, -0.1),
        inertia: [0.5, 0.0, 0.6, 0.0, 0.0, 0.7],
        span: Span::generated("t"),
    };
    let mass = closing::inertia(&body).expect("it has inertia");
    let r = body.offset;
    for j in 0..6 {
        let unit = Vector3::ith(j % 3, 1.0);
        let (v, w) = if j < 3 { (unit, Vector3::zeros()) } else { (Vector3::zeros(), unit) };
        let momentum = (v + w.cross(&r)) * 3.0;
        let spin = Matrix3::from_diagonal(&Vector3::new(0.5, 0.6, 0.7)) * w + r.cross(&momentum);
        for axis in 0..3 {
            assert!((mass[(axis, j)] - momentum[axis]).abs() < 1e-14, "{axis} {j}");
            assert!((mass[(3 + axis, j)] - spin[axis]).abs() < 1e-14, "{axis} {j}");
        }
    }
    let none = Conm2 { inertia: [0.0; 6], offset: Vector3::zeros(), ..body };
    assert!(closing::inertia(&none).is_none(), "a point does not resist turning");
}

#[test]
fn other_totals_make_the_aircraft_that_is_assembled_with_them() {
    let (mut file, wing) = small::files();
    (file.total.mass_kg, file.total.x_cg_m) = (22.0, 0.42);
    (file.total.ixx_kg_m2, file.total.iyy_kg_m2, file.total.izz_kg_m2) = (2.5, 3.2, 5.2);
    let moved = small::aircraft().of_totals(file.clone(), &()).expect("an aircraft");
    let built = crate::Aircraft::new(file, wing).expect("an aircraft");
    for aircraft in [&moved, &built] {
        assert_same("mass", aircraft.mass.mass_kg, 22.0);
    }
    assert!((moved.mass.centre - built.mass.centre).norm() < 1e-12);
    assert!((moved.mass.inertia_kg_m2 - built.mass.inertia_kg_m2).norm() < 1e-9);
    let [one, other] = [&moved, &built].map(|aircraft| {
        let trimmed = aircraft.uncorrected().trim("trim", &aircraft.file.trim).expect("it is trimmed");
        [trimmed.alpha_rad, trimmed.elevator_rad, trimmed.tip_deflection_m[0], trimmed.fz_n]
    });
    one.iter().zip(other).for_each(|(one, other)| assert_same("the trim", *one, other));
}

#[test]
fn stations_are_of_all_nodes_outboard_of_their_point_on_either_side() {
    let aircraft = small::aircraft();
    let points = aircraft.free.points();
    // exactly at a node of the beam: that node is not outboard of it
    let y_m = points[aircraft.right.nodes[aircraft.right.nodes.len() / 2]].y;
    let of = |y_m: f64| {
        let at = StationAt { name: "cut".to_owned(), x_m: None, y_m, z_m: Some(0.2) };
        aircraft.wing_stations(&[at]).map(|mut all| all.split_off(4))
    };
    let both = of(y_m).expect("stations");
    for (station, sign, wing) in [(&both[0], 1.0, &aircraft.right), (&both[1], -1.0, &aircraft.left)] {
        let law: Vec<usize> =
            wing.nodes.iter().copied().filter(|node| sign * points[*node].y > y_m).collect();
        assert_eq!(station.nodes, law);
        assert!(law.len() < wing.nodes.iter().filter(|node| sign * points[**node].y >= y_m).count());
        assert_eq!([station.point.x, station.point.y, station.point.z], [0.075, sign * y_m, 0.2]);
    }
    assert_eq!((both[0].channel.as_str(), both[1].name.as_str()), ("cut_right", "left cut"));
    assert!(of(1.8).expect_err("the tip").to_string().contains("nothing of the wing outboard"));
    let twice = StationAt { name: "half".to_owned(), x_m: None, y_m: 0.5, z_m: None };
    assert!(aircraft.wing_stations(&[twice]).expect_err("twice").to_string().contains("called half"));
    let root = StationAt { name: "root".to_owned(), x_m: None, y_m: 0.5, z_m: None };
    assert!(aircraft.wing_stations(&[root]).is_err());
    let bodies = aircraft.body_stations();
    let (centre, fuselage) = (points[aircraft.centre], &aircraft.fuselage);
    let ahead = fuselage.iter().filter(|node| points[**node].x < centre.x).count();
    assert_eq!(
        bodies.iter().map(|station| station.name.as_str()).collect::<Vec<_>>()[3..],
        ["fuselage ahead", "fuselage behind", "whole"]
    );
    assert_eq!((bodies[3].nodes.len(), bodies[4].nodes.len()), (ahead, fuselage.len() - 1 - ahead + 15));
    assert_eq!(bodies[5].nodes.len(), points.len());
}
