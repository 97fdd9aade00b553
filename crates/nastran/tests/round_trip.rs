//! What is written is read as it was: every card of general finite elements with random values.

use crate::common::content;
use nastran::{
    BulkData, BushAxes, Cbush, Conm1, Coord, CoordDefinition, CoordKind, CornerThickness, Crod, Expansion,
    Genel, LaminateOption, Mat2, Mat8, Mat9, MaterialDirection, Motion, Mpc, Orientation, Pbush, Pcomp, Ply,
    Prod, Pshell, Psolid, Rbe3, Rbe3Group, RigidBody, ScalarElement, ScalarKind, ScalarProperty, ScalarValue,
    ShellElement, SolidElement, SolidPoints, SolidShear, Span, SplineCard, SplineKind, parse_deck, real,
    write_deck,
};
use proptest::prelude::*;

/// Values out of a pool of random numbers, which proptest can shrink.
struct Dice {
    pool: Vec<u64>,
    next: usize,
    last_id: u32,
}

impl Dice {
    fn roll(&mut self) -> u64 {
        self.next += 1;
        let (round, index) = (self.next / self.pool.len(), self.next % self.pool.len());
        self.pool[index].wrapping_add(round as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 11
    }

    fn up_to(&mut self, end: u64) -> usize {
        usize::try_from(self.roll() % end).expect("small")
    }

    fn yes(&mut self) -> bool {
        self.up_to(2) == 1
    }

    /// A number above zero that 16 characters hold, of any size from 1e-12 to 1e12.
    fn positive(&mut self) -> f64 {
        let size = i32::try_from(self.up_to(25)).expect("small") - 12;
        let digits = [1.0, 0.5, 1.25, 1.0 + self.roll() as f64 / (1_u64 << 53) as f64][self.up_to(4)];
        real::parse(&real::format(digits * 10_f64.powi(size), 16)).expect("a number")
    }

    fn real(&mut self) -> f64 {
        let size = self.positive();
        let signed = [size, -size, 0.0][self.up_to(3)];
        real::parse(&real::format(signed, 16)).expect("a number")
    }

    fn point(&mut self) -> nalgebra::Point3<f64> {
        self.reals::<3>().into()
    }

    fn reals<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.real())
    }

    /// A number that no other card has.
    fn id(&mut self) -> u32 {
        self.last_id += 1 + u32::try_from(self.up_to(3_000)).expect("small");
        self.last_id
    }

    fn grids(&mut self, count: usize) -> Vec<u32> {
        let first = self.up_to(99_000_000) + 1;
        let step = self.up_to(50) + 1;
        (0..count).map(|i| u32::try_from(first + (i * step)).expect("below 1e8")).collect()
    }

    fn some_reals(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.real()).collect()
    }

    fn components(&mut self) -> Vec<u8> {
        let mask = self.up_to(63) + 1;
        (1..=6).filter(|digit| mask & (1 << (digit - 1)) != 0).collect()
    }

    fn motions(&mut self, count: usize) -> Vec<Motion> {
        self.grids(count)
            .into_iter()
            .map(|grid| (grid, u8::try_from(self.up_to(6) + 1).expect("a digit")))
            .collect()
    }

    fn optional<T>(&mut self, value: T) -> Option<T> {
        self.yes().then_some(value)
    }
}

fn span() -> Span {
    Span::generated("test")
}

fn coordinates(dice: &mut Dice, deck: &mut BulkData) {
    for kind in [CoordKind::Rectangular, CoordKind::Cylindrical, CoordKind::Spherical] {
        let (id, other) = (dice.id(), dice.id());
        let points = CoordDefinition::Points { rid: 7, a: dice.point(), b: dice.point(), c: dice.point() };
        let grids = dice.grids(3).try_into().expect("three");
        deck.coords.insert(id, Coord { id, kind, definition: points, span: span() });
        let definition = CoordDefinition::Grids(grids);
        deck.coords.insert(other, Coord { id: other, kind, definition, span: span() });
    }
}

fn shells_and_solids(dice: &mut Dice, deck: &mut BulkData) {
    for corners in [3, 4] {
        let id = dice.id();
        let (system, angle) = (dice.id(), dice.real());
        let direction = match dice.optional(system) {
            Some(system) => MaterialDirection::System(system),
            None => MaterialDirection::AngleDeg(angle),
        };
        let (property, grids, offset) = (dice.id(), dice.grids(corners), dice.real());
        deck.shells.insert(
            id,
            ShellElement {
                id,
                property,
                grids,
                midsides: Vec::new(),
                direction,
                is_r: false,
                thickness: CornerThickness::default(),
                offset,
                span: span(),
            },
        );
    }
    for corners in [4, 6, 8] {
        let (id, property, grids) = (dice.id(), dice.id(), dice.grids(corners));
        deck.solids.insert(id, SolidElement { id, property, grids, midsides: Vec::new(), span: span() });
    }
    let (id, property, grids) = (dice.id(), dice.id(), dice.grids(2).try_into().expect("two"));
    deck.rods.insert(id, Crod { id, property, grids, span: span() });
}

fn springs_and_masses(dice: &mut Dice, deck: &mut BulkData) {
    for axes in [
        BushAxes::System(dice.id()),
        BushAxes::Oriented(Orientation::Vector([dice.real(), dice.positive(), dice.real()].into())),
        BushAxes::Oriented(Orientation::Grid(dice.id())),
        BushAxes::Line,
    ] {
        let (id, a, b) = (dice.id(), dice.id(), dice.id());
        let may_be_grounded = matches!(axes, BushAxes::System(_));
        let grids = (a, if may_be_grounded { dice.optional(b) } else { Some(b) });
        let place = (dice.id(), dice.point());
        let (property, location, offset) = (dice.id(), [0.0, 0.25, 1.0][dice.up_to(3)], dice.optional(place));
        deck.bushes.insert(id, Cbush { id, property, grids, axes, location, offset, span: span() });
    }
    for (map, kind) in [
        (&mut deck.springs, ScalarKind::Spring),
        (&mut deck.scalar_masses, ScalarKind::Mass),
        (&mut deck.scalar_dampers, ScalarKind::Damper),
    ] {
        for grounded in [None, Some(0), Some(1)] {
            let (id, motions) = (dice.id(), dice.motions(2));
            let mut ends = [Some(motions[0]), Some(motions[1])];
            if let Some(end) = grounded {
                ends[end] = None;
            }
            let property = ScalarValue::Property(dice.id());
            let value = if dice.yes() { property } else { ScalarValue::Given(dice.real()) };
            map.insert(id, ScalarElement { id, value, ends, kind, span: span() });
        }
    }
    let (id, grid, cid) = (dice.id(), dice.id(), dice.id());
    let mut mass = [[0.0; 6]; 6];
    for (row, column) in (0..6).flat_map(|row| (0..=row).map(move |column| (row, column))) {
        mass[row][column] = dice.real();
        mass[column][row] = mass[row][column];
    }
    deck.mass_matrices.insert(id, Conm1 { id, grid, cid, mass, span: span() });
}

fn general(dice: &mut Dice, deck: &mut BulkData) {
    let (id, size, with_support) = (dice.id(), dice.up_to(7) + 1, dice.yes());
    let supports = if with_support { 6 } else { 0 };
    let mut motions = dice.motions(size + supports);
    let ud = motions.split_off(size);
    let mut matrix = vec![vec![0.0; size]; size];
    for (row, column) in (0..size).flat_map(|row| (0..=row).map(move |column| (row, column))) {
        matrix[row][column] = dice.real();
        matrix[column][row] = matrix[row][column];
    }
    let with_s = with_support && dice.yes();
    let s = if with_s { (0..size).map(|_| dice.some_reals(6)).collect() } else { Vec::new() };
    let is_flexibility = dice.yes();
    deck.general.insert(id, Genel { id, ui: motions, ud, is_flexibility, matrix, s, span: span() });
}

fn constraints(dice: &mut Dice, deck: &mut BulkData) {
    for count in [2, 3, 5] {
        let (id, grids, split) = (dice.id(), dice.grids(count), dice.components());
        let rest: Vec<u8> = (1..=6).filter(|digit| !split.contains(digit)).collect();
        let independent = [(grids[0], split.clone()), (grids[1], rest.clone())];
        let independent = independent.into_iter().filter(|(_, digits)| !digits.is_empty()).collect();
        let both = dice.yes() || split.is_empty();
        let mut dependent = vec![(grids[1], split)];
        if both {
            dependent.insert(0, (grids[0], rest));
        }
        dependent.retain(|(_, digits)| !digits.is_empty());
        dependent.extend(grids[2..].iter().map(|grid| (*grid, dice.components())));
        deck.rigid_bodies.insert(id, RigidBody { id, independent, dependent, span: span() });
    }
    let (id, reference, components) = (dice.id(), dice.id(), dice.components());
    let (group_count, um_count) = (dice.up_to(3) + 1, dice.up_to(9));
    let groups = (0..group_count)
        .map(|_| {
            let count = dice.up_to(12) + 1;
            Rbe3Group { weight: dice.positive(), components: dice.components(), grids: dice.grids(count) }
        })
        .collect();
    let um = dice.grids(um_count).into_iter().map(|grid| (grid, dice.components())).collect();
    deck.averages.insert(id, Rbe3 { id, reference, components, groups, um, span: span() });
    let term_count = dice.up_to(7) + 1;
    let mut terms: Vec<_> =
        dice.motions(term_count).into_iter().map(|motion| (motion, dice.real())).collect();
    terms[0].1 = dice.positive();
    deck.equations.push(Mpc { set: dice.id(), terms, span: span() });
}

fn properties(dice: &mut Dice, deck: &mut BulkData) {
    let (id, material) = (dice.id(), dice.id());
    let other = dice.optional(material);
    let shell = Pshell {
        id,
        membrane: Some(material),
        thickness: dice.positive(),
        bending: other,
        bending_ratio: dice.positive(),
        shear: other.filter(|_| id % 2 == 0),
        shear_ratio: dice.positive(),
        nsm: dice.real(),
        coupling: other.filter(|_| id % 3 == 0),
        span: span(),
    };
    deck.shell_properties.insert(id, shell);
    for is_global in [false, true] {
        let (id, ply_count) = (dice.id(), dice.up_to(9) + 1);
        let plies = (0..ply_count)
            .map(|_| Ply {
                material: dice.id(),
                thickness: dice.positive(),
                angle_deg: dice.real(),
                global_id: is_global.then(|| dice.id()),
            })
            .collect();
        let z0 = dice.real();
        let options = [LaminateOption::All, LaminateOption::Symmetric, LaminateOption::Smeared];
        let (z0, nsm, option) = (dice.optional(z0), dice.real(), options[dice.up_to(3)]);
        deck.laminates
            .insert(id, Pcomp { id, z0, nsm, reference: 0.0, plies, option, is_global, span: span() });
    }
    let (id, material, cordm) = (dice.id(), dice.id(), i32::try_from(dice.up_to(9)).expect("small") - 1);
    let points = [SolidPoints::Usual, SolidPoints::One, SolidPoints::Two, SolidPoints::Three][dice.up_to(4)];
    let shear = if dice.yes() { SolidShear::Full } else { SolidShear::Reduced };
    deck.solid_properties.insert(id, Psolid { id, material, cordm, points, shear, span: span() });
    let (id, material, area, j, nsm) = (dice.id(), dice.id(), dice.positive(), dice.positive(), dice.real());
    deck.rod_properties.insert(id, Prod { id, material, area, j, nsm, span: span() });
    let (id, stiffness) = (dice.id(), std::array::from_fn(|_| dice.positive()));
    let (damping, mass) = (std::array::from_fn(|_| dice.positive()), dice.positive());
    deck.bush_properties.insert(id, Pbush { id, stiffness, damping, mass, span: span() });
    for map in [&mut deck.spring_properties, &mut deck.mass_properties] {
        let (id, value) = (dice.id(), dice.real());
        map.insert(id, ScalarProperty { id, value, span: span() });
    }
}

fn materials(dice: &mut Dice, deck: &mut BulkData) {
    let (id, g, rho) = (dice.id(), dice.reals(), dice.positive());
    deck.plane_materials.insert(id, Mat2 { id, g, rho, expansion: Expansion::default(), span: span() });
    let (id, e2) = (dice.id(), dice.positive());
    let [g12, g1z, g2z, rho] = std::array::from_fn(|_| dice.positive());
    deck.ply_materials.insert(
        id,
        Mat8 {
            id,
            e1: e2,
            e2,
            nu12: 0.25,
            g12,
            g1z,
            g2z,
            rho,
            expansion: Expansion::default(),
            span: span(),
        },
    );
    let (id, g, rho) = (dice.id(), dice.reals(), dice.positive());
    deck.solid_materials.insert(id, Mat9 { id, g, rho, expansion: Expansion::default(), span: span() });
}

fn others(dice: &mut Dice, deck: &mut BulkData) {
    for kind in [
        SplineKind::Plate,
        SplineKind::Beam { system: dice.id(), torsional_ratio: dice.positive(), attachment: [0.0, -1.0] },
    ] {
        let (id, panel, set, first) = (dice.id(), dice.id(), dice.id(), dice.id());
        let boxes = (first, dice.id());
        let (flexibility, is_finite_plate) = (0.25, false);
        let list = None;
        let card =
            SplineCard { id, panel, boxes, list, set, kind, flexibility, is_finite_plate, span: span() };
        deck.splines.insert(id, card.clone());
        let (id, list) = (dice.id(), Some(dice.id()));
        deck.splines.insert(id, SplineCard { id, boxes: (panel, panel), list, ..card });
    }
    for name in ["WTMASS", "POST", "K6ROT"] {
        deck.parameters.insert(name.into(), dice.positive());
    }
    deck.parameters.insert("GRDPNT".into(), 0.0);
}

#[test]
fn the_comparison_sees_every_number_and_no_place() {
    let of = |text: &str| content(&parse_deck("t.bdf", text).expect("a good deck"));
    assert_eq!(
        of("MPC,9,1,3,1.,2,3,-.5\n"),
        of("$\n\nMPC     9       1       3       1.0     2       3       -.5\n")
    );
    assert_ne!(of("MPC,9,1,3,1.,2,3,-.5\n"), of("MPC,9,1,3,1.,2,3,-.6\n"));
    assert_ne!(of("MPC,9,1,3,1.\n"), of("MPC,9,1,3,1.\nPROD,1,2,3.\n"));
}

proptest! {
    #[test]
    fn what_is_written_is_read_as_it_was(pool in prop::collection::vec(any::<u64>(), 1..200)) {
        let mut dice = Dice { pool, next: 0, last_id: 0 };
        let mut deck = BulkData::default();
        for part in [
            coordinates, shells_and_solids, springs_and_masses, general, constraints, properties, materials, others,
        ] {
            part(&mut dice, &mut deck);
        }
        let text = write_deck(&deck);
        prop_assert!(text.lines().all(|line| line.len() <= 72));
        let back = parse_deck("t.bdf", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        prop_assert_eq!(content(&back), content(&deck));
        prop_assert_eq!(write_deck(&back), text);
    }
}
