//! Laws on random elements: symmetry, rigid motions without strain, exact mass, indifference to frames and to units.

use crate::contract::{Specimen, contract, rigid};
use nalgebra::{DMatrix, Matrix3, Point3, Rotation3, Vector3};
use nastran::{BeamProperty, BeamStation, Mat1, Mat8, Span, parse_deck};
use proptest::prelude::*;
use std::sync::Arc;
use structure::{
    Beam, BeamPlacement, Element, Model, PlacedPly, PlaneMaterial, ShearModel, Shell, ShellSection,
};

fn span() -> Span {
    Span::generated("test")
}

/// Lengths times `length`, forces times `force`: 1000 and 1 for N and mm.
#[derive(Debug, Clone, Copy)]
struct Units {
    length: f64,
    force: f64,
}

const SI: Units = Units { length: 1.0, force: 1.0 };

impl Units {
    /// A modulus.
    fn stress(self, value: f64) -> f64 {
        value * self.force / self.length.powi(2)
    }

    /// A length to a power.
    fn length(self, value: f64, power: i32) -> f64 {
        value * self.length.powi(power)
    }

    /// Mass has the unit force times s² over length.
    fn density(self, value: f64) -> f64 {
        value * self.force / self.length.powi(4)
    }

    /// What a stiffness or mass of SI is: rows and columns of rotations carry a length each.
    fn matrix(self, si: &DMatrix<f64>) -> DMatrix<f64> {
        let arm = |i: usize| if i % 6 < 3 { 1.0 } else { self.length };
        DMatrix::from_fn(si.nrows(), si.ncols(), |i, j| {
            si[(i, j)] * arm(i) * arm(j) * self.force / self.length
        })
    }
}

/// A tapered beam with offsets, shear, product of inertia and masses beside its axis.
#[derive(Debug, Clone)]
struct RandomBeam {
    ends: [[f64; 3]; 2],
    orientation: [f64; 3],
    offsets: [[f64; 3]; 2],
    taper: f64,
    shear: [f64; 2],
    beside: [f64; 8],
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    [-size..size, -size..size, -size..size]
}

fn beams() -> impl Strategy<Value = RandomBeam> {
    let cross = |a: [f64; 3], b: [f64; 3]| Vector3::from(a).cross(&Vector3::from(b)).norm();
    (
        vector(1.0),
        vector(1.0),
        vector(1.0),
        [vector(0.05), vector(0.05)],
        0.4..2.0,
        [0.3..1.0, 0.3..1.0],
        [
            -0.02..0.02,
            -0.02..0.02,
            -0.02..0.02,
            -0.02..0.02,
            -0.02..0.02,
            -0.02..0.02,
            -0.02..0.02,
            -0.02..0.02,
        ],
    )
        .prop_filter_map(
            "long, and not along its orientation",
            move |(a, along, orientation, offsets, taper, shear, beside)| {
                let length = Vector3::from(along).norm();
                let sound = length > 0.5
                    && cross(along, orientation) > 0.2 * length * Vector3::from(orientation).norm()
                    && Vector3::from(orientation).norm() > 0.1;
                let b = std::array::from_fn(|k| a[k] + along[k]);
                sound.then_some(RandomBeam { ends: [a, b], orientation, offsets, taper, shear, beside })
            },
        )
}

impl RandomBeam {
    fn build(&self, rotation: &Rotation3<f64>, units: Units) -> Specimen<Beam> {
        let material = Mat1 {
            id: 1,
            e: units.stress(70e9),
            g: units.stress(27e9),
            nu: 0.3,
            rho: units.density(2700.0),
            expansion: nastran::Expansion::default(),
            span: span(),
        };
        let station = |x_over_l: f64, size: f64| BeamStation {
            x_over_l,
            area: units.length(1e-3 * size, 2),
            i1: units.length(4e-7 * size, 4),
            i2: units.length(1e-7 * size, 4),
            i12: units.length(0.5e-7 * size, 4),
            j: units.length(2e-7 * size, 4),
            // mass per length
            nsm: units.density(units.length(0.3 * size, 2)),
        };
        let [a, b, c, d, e, f, g, h] = self.beside.map(|value| units.length(value, 1));
        let property = BeamProperty {
            id: 1,
            material: 1,
            stations: vec![station(0.0, 1.0), station(1.0, self.taper)],
            shear_factors: self.shear,
            nsi: [1e-4, 2e-4].map(|value| units.density(units.length(value, 4))),
            nsm_offset: [[a, b], [c, d]],
            neutral_axis: [[e, f], [g, h]],
            is_beam: true,
            span: span(),
        };
        let turned = |v: &[f64; 3]| rotation * (Vector3::from(*v) * units.length);
        let placement = BeamPlacement {
            grids: self.ends.map(|end| turned(&end).into()),
            offsets: self.offsets.map(|offset| turned(&offset)),
            orientation: turned(&self.orientation),
            pins: [Vec::new(), Vec::new()],
        };
        let element =
            Beam::new(7, [0, 1], &placement, &property, &material, &span()).expect("a possible beam");
        let mean = 0.5 * (1.0 + self.taper);
        Specimen {
            mass_kg: (2700.0 * 1e-3 + 0.3) * mean * element.length_m(),
            element,
            points: self.ends.map(Point3::from).to_vec(),
            inertia: None,
        }
    }
}

/// A shell of two unlike plies, corners near those of a unit square, and out of the plane.
#[derive(Debug, Clone)]
struct RandomShell {
    corners: Vec<[f64; 3]>,
    angles_deg: [f64; 2],
    offset: f64,
    turn: f64,
}

fn shells() -> impl Strategy<Value = RandomShell> {
    let off = || [-0.2..0.2, -0.2..0.2, -0.1..0.1];
    ([off(), off(), off(), off()], any::<bool>(), [-90.0..90.0, -90.0..90.0], -0.05..0.05, -3.0..3.0)
        .prop_map(|(off, triangle, angles_deg, offset, turn)| {
            let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
            let corners = square.iter().zip(off).take(if triangle { 3 } else { 4 });
            let corners = corners.map(|(at, off)| [at[0] + off[0], at[1] + off[1], off[2]]).collect();
            RandomShell { corners, angles_deg, offset, turn }
        })
}

impl RandomShell {
    fn build(&self, rotation: &Rotation3<f64>, units: Units) -> Specimen<Shell> {
        let gpa = |value: f64| units.stress(value * 1e9);
        let card = Mat8 {
            id: 1,
            e1: gpa(138.0),
            e2: gpa(9.0),
            nu12: 0.3,
            g12: gpa(5.0),
            g1z: gpa(5.0),
            g2z: gpa(3.0),
            rho: units.density(1600.0),
            expansion: nastran::Expansion::default(),
            span: span(),
        };
        let material = PlaneMaterial::ply(&card).expect("a sound material");
        let ply = |angle_deg: f64, low: f64, high: f64| PlacedPly {
            material,
            angle_rad: angle_deg.to_radians(),
            z_low_m: units.length(low, 1),
            z_high_m: units.length(high, 1),
        };
        let plies = [ply(self.angles_deg[0], -0.01, 0.005), ply(self.angles_deg[1], 0.005, 0.02)];
        let section = Arc::new(ShellSection::laminate(&plies, 0.0, ShearModel::Equilibrium));
        let points: Vec<Point3<f64>> = self.corners.iter().copied().map(Point3::from).collect();
        let turned: Vec<Point3<f64>> = points.iter().map(|point| rotation * (point * units.length)).collect();
        let nodes = (0..points.len()).collect();
        let offset = units.length(self.offset, 1);
        let element =
            Shell::new(3, nodes, &turned, offset, section, self.turn, &span()).expect("a possible shell");
        let per_area = 1600.0 * 0.03;
        Specimen { mass_kg: per_area * element.area_m2(), element, points, inertia: None }
    }
}

fn same_in_other_units<E: Element>(si: &E, other: &E, units: Units) {
    for (si, other) in [(si.stiffness(), other.stiffness()), (si.mass(), other.mass())] {
        let expected = units.matrix(&si.expect("has both"));
        let other = other.expect("has both");
        // entries by the size of their rows and columns, as units mix lengths
        for i in 0..expected.nrows() {
            for j in 0..expected.ncols() {
                let scale = (expected[(i, i)] * expected[(j, j)]).abs().sqrt();
                let error = (expected[(i, j)] - other[(i, j)]).abs();
                assert!(
                    error <= 1e-9 * scale,
                    "entry {i} {j}: {} beside {}",
                    other[(i, j)],
                    expected[(i, j)]
                );
            }
        }
    }
}

const MILLIMETRES: Units = Units { length: 1000.0, force: 1.0 };
const FEET_AND_POUNDS: Units = Units { length: 1.0 / 0.3048, force: 1.0 / 4.448_221_615_260_5 };

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_random_beam_keeps_the_contract_in_any_units(beam in beams()) {
        contract(|rotation| beam.build(rotation, SI));
        let si = beam.build(&Rotation3::identity(), SI).element;
        for units in [MILLIMETRES, FEET_AND_POUNDS] {
            same_in_other_units(&si, &beam.build(&Rotation3::identity(), units).element, units);
        }
    }

    #[test]
    fn a_random_shell_keeps_the_contract_in_any_units(shell in shells()) {
        contract(|rotation| shell.build(rotation, SI));
        let si = shell.build(&Rotation3::identity(), SI).element;
        for units in [MILLIMETRES, FEET_AND_POUNDS] {
            same_in_other_units(&si, &shell.build(&Rotation3::identity(), units).element, units);
        }
    }

    #[test]
    fn a_weighted_mean_follows_every_rigid_motion_of_its_group(
        places in prop::collection::vec(vector(2.0), 4..8),
        weights in prop::collection::vec(0.1..5.0, 8),
        reference in vector(3.0),
    ) {
        // not all near one line: the least moment of inertia of the points
        let points: Vec<Vector3<f64>> = places.iter().map(|p| Vector3::from(*p)).collect();
        let mean = points.iter().sum::<Vector3<f64>>() / points.len() as f64;
        let spread: Matrix3<f64> = points.iter().map(|p| (p - mean) * (p - mean).transpose()).sum();
        let mut sizes: Vec<f64> = spread.symmetric_eigenvalues().iter().copied().collect();
        sizes.sort_by(f64::total_cmp);
        prop_assume!(sizes[1] > 0.1);
        let mut deck = format!("GRID,99,,{:?},{:?},{:?}\nRBE3,1,,99,123456", reference[0], reference[1], reference[2]);
        for (k, weight) in weights.iter().take(places.len()).enumerate() {
            let start = if k == 0 { "," } else { "\n," };
            deck = format!("{deck}{start}{weight:?},123,{}", k + 1);
        }
        for (k, place) in places.iter().enumerate() {
            deck = format!("{deck}\nGRID,{},,{:?},{:?},{:?}", k + 1, place[0], place[1], place[2]);
        }
        let model = Model::from_bulk(&parse_deck("test.bdf", &(deck + "\n")).expect("a deck")).expect("a model");
        let nodes: Vec<Point3<f64>> = model.nodes.iter().map(|node| node.point).collect();
        let motions = rigid(&nodes);
        prop_assert_eq!(model.dependents.len(), 6);
        for dependent in &model.dependents {
            for motion in 0..6 {
                let follows: f64 = dependent.row.iter().map(|(dof, f)| f * motions[(*dof, motion)]).sum();
                let own = motions[(dependent.dof, motion)];
                prop_assert!((follows - own).abs() < 1e-8, "motion {motion} of {}: {follows} beside {own}", dependent.dof);
            }
        }
    }
}
