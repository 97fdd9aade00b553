//! Beams beside integrals along them: kinetic energies of consistent and lumped mass, turned principal axes, released
//! ends.

use crate::common::{at, close, displaced, system};
use nalgebra::{DVector, Point3, Vector3};
use nastran::{BeamProperty, BeamStation, Mat1, Span, parse_deck};
use structure::{Beam, BeamPlacement, Element, Model};

fn span() -> Span {
    Span::generated("test")
}

const LENGTH: f64 = 1.6;
const RHO: f64 = 3.0;

/// Values at both ends: area, I1, I2, non-structural mass and its inertia; lines of the material's and of the other
/// mass.
const ENDS: [[f64; 5]; 2] = [[0.5, 0.3, 0.2, 0.7, 0.4], [0.2, 0.1, 0.15, 0.3, 0.1]];
const NEUTRAL: [[f64; 2]; 2] = [[0.1, -0.2], [0.3, 0.15]];
const BESIDE: [[f64; 2]; 2] = [[-0.25, 0.1], [0.05, 0.3]];

/// Along x, its plane 1 the plane of x and y.
fn beam(is_beam: bool) -> Beam {
    let station = |x_over_l: f64, [area, i1, i2, nsm, _]: [f64; 5]| BeamStation {
        x_over_l,
        area,
        i1,
        i2,
        i12: 0.0,
        j: 0.1,
        nsm,
    };
    let property = BeamProperty {
        id: 1,
        material: 1,
        stations: vec![station(0.0, ENDS[0]), station(1.0, ENDS[1])],
        shear_factors: [0.0; 2],
        nsi: [ENDS[0][4], ENDS[1][4]],
        nsm_offset: BESIDE,
        neutral_axis: NEUTRAL,
        is_beam,
        span: span(),
    };
    let expansion = nastran::Expansion::default();
    let material = Mat1 { id: 1, e: 7.0, g: 3.0, nu: 0.3, rho: RHO, expansion, span: span() };
    let placement = BeamPlacement {
        grids: [Point3::origin(), Point3::new(LENGTH, 0.0, 0.0)],
        offsets: [Vector3::zeros(); 2],
        orientation: Vector3::y(),
        pins: [Vec::new(), Vec::new()],
    };
    Beam::new(7, [0, 1], &placement, &property, &material, &span()).expect("a possible beam")
}

fn between<const N: usize>(ends: [[f64; N]; 2], t: f64) -> [f64; N] {
    std::array::from_fn(|i| ends[0][i] * (1.0 - t) + ends[1][i] * t)
}

/// Mass per length and its line (y, z), of the material and of the rest; the inertia about the axis per length.
fn masses(t: f64) -> ([(f64, [f64; 2]); 2], f64) {
    let [area, i1, i2, nsm, nsi] = between(ENDS, t);
    ([(RHO * area, between(NEUTRAL, t)), (nsm, between(BESIDE, t))], RHO * (i1 + i2) + nsi)
}

/// Simpson's rule over the beam, exact for what the integrals here are made of but for 1e-10.
fn integral(of: impl Fn(f64) -> f64) -> f64 {
    let parts = 2000;
    let weight = |at: usize| {
        if at == 0 || at == parts {
            1.0
        } else if at % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    (0..=parts).map(|at| weight(at) * of(at as f64 / parts as f64)).sum::<f64>() * LENGTH
        / (3.0 * parts as f64)
}

/// Motions of the axis at x: u linear, v and w of third degree, twist linear; with the slopes v' and w'.
struct Wave {
    u: [f64; 2],
    v: [f64; 4],
    w: [f64; 4],
    twist: [f64; 2],
}

impl Wave {
    fn cubic(c: [f64; 4], x: f64) -> (f64, f64) {
        (c[0] + c[1] * x + c[2] * x * x + c[3] * x.powi(3), c[1] + 2.0 * c[2] * x + 3.0 * c[3] * x * x)
    }

    /// Displacement and rotation of the axis.
    fn at(&self, x: f64) -> (Vector3<f64>, Vector3<f64>) {
        let ((v, dv), (w, dw)) = (Self::cubic(self.v, x), Self::cubic(self.w, x));
        let line = |[a, b]: [f64; 2]| a + b * x;
        (Vector3::new(line(self.u), v, w), Vector3::new(line(self.twist), -dw, dv))
    }

    fn ends(&self) -> DVector<f64> {
        let of = |x: f64| {
            let (moved, turned) = self.at(x);
            [moved.x, moved.y, moved.z, turned.x, turned.y, turned.z]
        };
        DVector::from_column_slice(&[of(0.0), of(LENGTH)].concat())
    }
}

fn waves() -> Vec<Wave> {
    let still = || Wave { u: [0.0; 2], v: [0.0; 4], w: [0.0; 4], twist: [0.0; 2] };
    vec![
        Wave { u: [0.3, 0.7], ..still() },
        Wave { v: [0.1, -0.4, 0.5, 0.2], ..still() },
        Wave { w: [-0.2, 0.6, 0.3, -0.4], ..still() },
        Wave { twist: [0.5, -0.3], ..still() },
        Wave { u: [0.3, 0.7], v: [0.1, -0.4, 0.5, 0.2], w: [-0.2, 0.6, 0.3, -0.4], twist: [0.5, -0.3] },
        Wave { u: [-0.1, 0.2], v: [0.0, 0.0, 0.0, 1.0], w: [0.0, 0.0, 1.0, 0.0], twist: [0.0, 1.0] },
    ]
}

/// Particles on lines beside the axis move by u + theta x r; the section itself has only its inertia about the axis.
#[test]
fn consistent_mass_has_the_kinetic_energy_of_lines_beside_the_axis() {
    for is_beam in [true, false] {
        let beam = beam(is_beam);
        let mass = beam.mass().expect("massive");
        for (number, wave) in waves().iter().enumerate() {
            let expected = integral(|t| {
                let ((moved, turned), (lines, about)) = (wave.at(t * LENGTH), masses(t));
                let of_line = |(mass, [y, z]): (f64, [f64; 2])| {
                    mass * (moved + turned.cross(&Vector3::new(0.0, y, z))).norm_squared()
                };
                lines.into_iter().map(of_line).sum::<f64>() + about * turned.x * turned.x
            });
            let ends = wave.ends();
            close(ends.dot(&(&*mass * &ends)), expected, 1e-9, &format!("motion {number}"));
        }
    }
}

/// Every particle is shared between the ends by its lever, beside the axis as it stands; a beam has the sections'
/// inertia there, a bar not.
#[test]
fn lumped_mass_has_the_kinetic_energy_of_particles_at_the_ends() {
    for is_beam in [true, false] {
        let lumped = beam(is_beam).lumped_mass().expect("massive");
        for number in 0..4 {
            let motion: Vec<f64> =
                (0..12).map(|at| (1.3 * f64::from(at) + 0.7 * f64::from(number)).sin()).collect();
            let expected = integral(|t| {
                let (lines, about) = masses(t);
                let end = |first: usize, share: f64| {
                    let three = |at: usize| Vector3::from_column_slice(&motion[first + at..first + at + 3]);
                    let (moved, turned) = (three(0), three(3));
                    let of_line = |(mass, [y, z]): (f64, [f64; 2])| {
                        mass * (moved + turned.cross(&Vector3::new(0.0, y, z))).norm_squared()
                    };
                    let twisting = if is_beam { about * turned.x * turned.x } else { 0.0 };
                    share * (lines.into_iter().map(of_line).sum::<f64>() + twisting)
                };
                end(0, 1.0 - t) + end(6, t)
            });
            let ends = DVector::from_vec(motion.clone());
            close(ends.dot(&(&lumped * &ends)), expected, 1e-9, &format!("motion {number}, {is_beam}"));
        }
    }
}

/// A section seen from axes turned by an angle from its principal ones: I1 and I2 as those of a tensor, I12 the
/// integral of y z.
#[test]
fn a_section_turned_in_its_card_is_the_beam_turned_by_its_orientation() {
    let stiffness = |orientation: [f64; 3], [i1, i2, i12]: [f64; 3]| {
        let [x, y, z] = orientation;
        let deck = format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,1.7,0.,0.\nCBAR,1,1,1,2,{x:.12},{y:.12},{z:.12}\nMAT1,1,70.,27.\n\
             PBAR,1,1,.1,{i1:.12},{i2:.12},.04\n,,,,,,,,\n,,,{i12:.12}\n"
        );
        let model = Model::from_bulk(&parse_deck("t.bdf", &deck).expect("a deck")).expect("a model");
        model.elements[0].stiffness().expect("stiff").into_owned()
    };
    let (large, small) = (0.05, 0.02);
    for degrees in [30.0_f64, -50.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        // The principal direction of the larger inertia stands at this angle from y.
        let principal = stiffness([0.0, cos, sin], [large, small, 0.0]);
        let i1 = large * cos * cos + small * sin * sin;
        let i2 = large * sin * sin + small * cos * cos;
        let turned = stiffness([0.0, 1.0, 0.0], [i1, i2, (large - small) * sin * cos]);
        assert!((&principal - &turned).amax() < 1e-9 * principal.amax(), "{degrees}: {}", principal - turned);
    }
}

/// A bar of L between walls, released at one end: a propped cantilever bends under a force in its middle by 7 P L^3 /
/// 768 E I.
#[test]
fn released_ends_turn_freely() {
    let deck = |pins: &str| {
        format!(
            "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nCBAR,1,1,1,2,0.,1.,0.\n{pins}CBAR,2,1,2,3,0.,1.,0.\n\
             PBAR,1,1,.1,.02,.03,.04\nMAT1,1,70.,27.\nSPC1,1,123456,1,3\n"
        )
    };
    let sag = |pins: &str, component: usize| {
        let system = system(&deck(pins));
        at(&system, &displaced(&system, &[(2, component, 1.0)]), 2, component)
    };
    let (plane_1, plane_2) = (8.0 / (70.0 * 0.02), 8.0 / (70.0 * 0.03));
    close(sag("", 2), plane_1 / 192.0, 1e-9, "clamped");
    close(sag(",6\n", 2), 7.0 * plane_1 / 768.0, 1e-9, "released about z at A");
    close(sag(",5\n", 2), plane_1 / 192.0, 1e-9, "released about y: nothing in plane 1");
    close(sag(",5\n", 3), 7.0 * plane_2 / 768.0, 1e-9, "released about y at A");
    close(sag(",456\n", 3), 7.0 * plane_2 / 768.0, 1e-9, "about all axes");
    // Torsion by one half alone, stretch by one half alone.
    close(sag(",4\n", 4), 1.0 / (27.0 * 0.04), 1e-9, "released in twist");
    close(sag(",1\n", 1), 1.0 / (70.0 * 0.1), 1e-9, "released along");
    close(sag("", 1), 0.5 / (70.0 * 0.1), 1e-9, "both halves hold");
    // Released at B of the first, both halves are cantilevers, of which the second turns.
    close(sag(",,6\n", 2), plane_1 / 8.0 / 6.0, 1e-9, "a hinge in the middle");
    // Released along y at A, the first half carries only its moment.
    close(sag(",,2\n", 2), plane_1 / 8.0 * (1.0 / 3.0 - 1.0 / 4.0 / 2.0), 1e-9, "no force across the middle");
}
