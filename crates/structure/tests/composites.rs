//! Laminates and their directions as the cards say them: symmetric lists, reference planes, material axes, and transverse
//! shear by the equilibrium of unlike plies.

use crate::common::{close, displaced, system};
use nalgebra::{DMatrix, DVector};
use nastran::{Mat8, Span, parse_deck};
use structure::{Model, PlacedPly, PlaneMaterial, ShearModel, ShellSection};

const GRIDS: &str = "GRID,1,,0.,0.,0.\nGRID,2,,.5,0.,0.\nGRID,3,,.6,.4,0.\nGRID,4,,0.,.3,0.\n";
const MATERIALS: &str = "MAT8,1,138.+9,9.+9,.3,5.+9,5.+9,3.+9,1600.\nMAT8,2,40.+9,12.+9,.2,4.+9,4.+9,3.5+9,2000.\n\
                         MAT1,3,70.+9,,.3,2700.\n";

/// Stiffness and mass of the one element of a deck.
fn matrices(cards: &str) -> [DMatrix<f64>; 2] {
    let bulk = parse_deck("test.bdf", &format!("{GRIDS}{MATERIALS}{cards}")).expect("a deck");
    let model = Model::from_bulk(&bulk).expect("a model");
    let element = &model.elements[0];
    [element.stiffness(), element.mass()].map(|matrix| matrix.expect("a shell has both").into_owned())
}

#[track_caller]
fn same(one: &str, other: &str, what: &str) {
    for (a, b) in matrices(one).iter().zip(&matrices(other)) {
        assert!((a - b).amax() < 1e-12 * a.amax(), "{what}: {:e} of {:e}", (a - b).amax(), a.amax());
    }
}

#[test]
fn a_symmetric_list_of_plies_is_the_list_followed_by_itself_backwards() {
    let element = "CQUAD4,1,1,1,2,3,4\n";
    let half = format!("{element}PCOMP,1,,,,,,,SYM\n,1,.001,30.,,2,.002,-70.\n,1,.003,0.\n");
    let whole = format!(
        "{element}PCOMP,1\n,1,.001,30.,,2,.002,-70.\n,1,.003,0.,,1,.003,0.\n,2,.002,-70.,,1,.001,30.\n"
    );
    same(&half, &whole, "plies 1 2 3 3 2 1");
}

/// One ply of an isotropic material is a plate, and what LAM leaves out of it is a material that PSHELL leaves empty (Nastran Quick
/// Reference Guide, PCOMP).
#[test]
fn lam_computes_what_a_plate_without_some_materials_does() {
    let element = "CQUAD4,1,1,1,2,3,4\n";
    for (option, plate) in [
        ("", "PSHELL,1,3,.004,3,,3\n"),
        ("MEM", "PSHELL,1,3,.004\n"),
        ("BEND", "PSHELL,1,,.004,3\n"),
        ("SMEAR", "PSHELL,1,3,.004,3\n"),
    ] {
        let laminate = format!("{element}PCOMP,1,,,,,,,{option}\n,3,.001,,,3,.003\n");
        same(&laminate, &format!("{element}{plate}"), option);
    }
}

#[test]
fn smeared_plies_have_the_membrane_of_any_sequence_and_bend_as_one_plate_of_it() {
    let element = "CQUAD4,1,1,1,2,3,4\n";
    let [one, other] = ["1,.001,0.,,1,.003,90.", "1,.003,90.,,1,.001,0."]
        .map(|plies| format!("{element}PCOMP,1,,,,,,,SMEAR\n,{plies}\n"));
    same(&one, &other, "0/90 and 90/0");
    // Thin layers that change often approach it.
    let mut many = format!("{element}PCOMP,1\n");
    for _ in 0..100 {
        many.push_str(",1,1.-5,0.,,1,3.-5,90.\n");
    }
    let bent = DVector::from_iterator(
        24,
        [0.0, 0.5, 0.6, 0.0].into_iter().flat_map(|x| [0.0, 0.0, -x * x, 0.0, 2.0 * x, 0.0]),
    );
    let energy = |deck: &str| bent.dot(&(&matrices(deck)[0] * &bent));
    close(energy(&one), energy(&many), 2e-3, "bending of one and of two hundred layers");
}

#[test]
fn a_core_has_half_of_the_mean_of_its_faces_on_either_side() {
    let element = "CQUAD4,1,1,1,2,3,4,15.\n";
    let given = format!("{element}PCOMP,1,,,,,,,SMCORE\n,1,.002,,,2,.01,30.\n");
    let whole = format!("{element}PCOMP,1\n,1,.001,,,2,.01,30.\n,1,.001\n");
    same(&given, &whole, "one ply in the faces");
    // A plate of two materials in its faces has the mean of their stiffness there.
    let mixed = |plies: &str| format!("{element}PCOMP,1,,,,,,,SMCORE\n,{plies}\n,3,.01\n");
    same(&mixed("1,.001,20.,,2,.003"), &mixed("2,.003,,,1,.001,20."), "the sequence of the faces' plies");
    let refused = |cards: &str| {
        let bulk = parse_deck("test.bdf", &format!("{GRIDS}{MATERIALS}{element}{cards}")).expect("a deck");
        Model::from_bulk(&bulk).expect_err("refused").to_string()
    };
    let error = refused("PCOMP,1,0.,,,,,,SMEAR\n,1,.001\n");
    assert!(
        error.contains("PCOMP 1 has Z0 0 with LAM SMEAR, which stands on its middle (Z0 -0.0005)"),
        "{error}"
    );
    let error = refused("PCOMP,1,,,,,,,SMCORE\n,1,.001\n");
    assert!(error.contains("PCOMP 1 with LAM SMCORE has no faces"), "{error}");
}

#[test]
fn z0_is_the_height_of_the_lowest_face_over_the_grids() {
    let (t, z0) = (0.004, 0.01);
    // One isotropic ply whose lowest face is z0 above the grids is a plate offset by z0 + t/2 along the normal.
    let ply = format!("CQUAD4,1,1,1,2,3,4\nPCOMP,1,{z0:?}\n,3,{t:?},0.\n");
    let plate = format!("CQUAD4,1,1,1,2,3,4,,{:?}\nPSHELL,1,3,{t:?},3,,3\n", z0 + 0.5 * t);
    let [ply_mass, plate_mass] = [&ply, &plate].map(|deck| {
        let bulk = parse_deck("test.bdf", &format!("{GRIDS}{MATERIALS}{deck}")).expect("a deck");
        structure::MassProperties::of_model(&Model::from_bulk(&bulk).expect("a model"))
    });
    close(ply_mass.centre.z, z0 + 0.5 * t, 1e-12, "height of the ply's centre");
    close(plate_mass.centre.z, z0 + 0.5 * t, 1e-12, "height of the plate's centre");
    // Energy of the strain e along x and the curvature k at once, over the area of the grids' quadrilateral:
    // E t/(1 - nu²) (e + z k)² + E t³/12/(1 - nu²) k², z the height of the middle.
    let (e, k) = (2e-3, 0.3);
    let motion = |x: f64| [e * x, 0.0, -0.5 * k * x * x, 0.0, k * x, 0.0];
    let u = DVector::from_iterator(24, [0.0, 0.5, 0.6, 0.0].into_iter().flat_map(motion));
    let share = 70e9 * t / (1.0 - 0.3 * 0.3);
    let area = 0.5 * (0.6 * 0.3 + 0.5 * 0.4);
    let expected = area * share * ((e + (z0 + 0.5 * t) * k).powi(2) + t * t / 12.0 * k * k);
    for (what, deck) in [("ply", &ply), ("plate", &plate)] {
        close(u.dot(&(&matrices(deck)[0] * &u)), expected, 1e-10, what);
    }
}

/// Off-axis plies under tension shear: gamma = S16 sigma (Jones, "Mechanics of Composite Materials", eq. 2.83).
fn shear_compliance(angle_deg: f64) -> f64 {
    let (s, c) = angle_deg.to_radians().sin_cos();
    let (s11, s22, s12, s66) = (1.0 / 138e9, 1.0 / 9e9, -0.3 / 138e9, 1.0 / 5e9);
    (2.0 * s11 - 2.0 * s12 - s66) * s * c.powi(3) - (2.0 * s22 - 2.0 * s12 - s66) * s.powi(3) * c
}

#[test]
fn material_directions_turn_from_the_first_side_towards_the_normal_cross_it() {
    let (a, b, t, force) = (0.5, 0.3, 0.002, 1000.0);
    let plate = "GRID,1,,0.,0.,0.\nGRID,2,,.5,0.,0.\nGRID,3,,.5,.3,0.\nGRID,4,,0.,.3,0.\n\
                 SPC1,1,12345,1\nSPC1,1,1345,4\nSPC1,1,345,2,3\nPCOMP,1\n,1,.002,0.\n";
    // x axes of system 7: 25 degrees from basic x towards y; of system 8: the same, 60 degrees out of the plane
    let systems = "CORD2R,7,,0.,0.,0.,0.,0.,1.\n,.906307787,.422618262,.5\n\
                   CORD2R,8,,0.,0.,0.,.784885568,.365998151,-.5\n,.453153894,.211309131,.866025404\n";
    for (what, angle_deg, direction) in [
        ("THETA", 25.0, "25."),
        ("THETA", -40.0, "-40."),
        ("MCID", 25.0, "7"),
        ("MCID out of plane", 25.0, "8"),
    ] {
        let element = format!("CQUAD4,1,1,1,2,3,4,{direction}\n");
        let system = system(&format!("{plate}{systems}{MATERIALS}{element}"));
        let u = displaced(&system, &[(2, 1, 0.5 * force), (3, 1, 0.5 * force)]);
        // the side at x = 0 stays where it is along x, so the shear strain is the slope of v
        let gamma = crate::common::at(&system, &u, 2, 2) / a;
        close(gamma, shear_compliance(angle_deg) * force / (b * t), 1e-8, what);
    }
}

fn ply_of(e: f64, g: f64) -> PlaneMaterial {
    let span = Span::generated("test");
    let card = Mat8 {
        id: 1,
        e1: e,
        e2: e,
        nu12: 0.0,
        g12: e / 2.0,
        g1z: g,
        g2z: g,
        rho: 1000.0,
        expansion: nastran::Expansion::default(),
        span,
    };
    PlaneMaterial::ply(&card).expect("a sound material")
}

/// Shear stiffness by equilibrium of layers (E, G, thickness) from `z0` up, in both planes.
fn shear(layers: &[(f64, f64, f64)], z0: f64) -> [f64; 2] {
    let mut low = z0;
    let place = |&(e, g, t): &(f64, f64, f64)| {
        let ply = PlacedPly { material: ply_of(e, g), angle_rad: 0.0, z_low_m: low, z_high_m: low + t };
        low += t;
        ply
    };
    let plies: Vec<PlacedPly> = layers.iter().map(place).collect();
    let section = ShellSection::laminate(&plies, 0.0, ShearModel::Equilibrium);
    [section.shear[(0, 0)], section.shear[(1, 1)]]
}

#[test]
fn a_layer_in_slices_of_any_height_has_five_sixths_of_its_shear_stiffness() {
    let slices = [(70e9, 26e9, 0.001), (70e9, 26e9, 0.004), (70e9, 26e9, 0.002)];
    for stiffness in shear(&slices, 0.003) {
        close(stiffness, 5.0 / 6.0 * 26e9 * 0.007, 1e-12, "5/6 G t");
    }
}

/// A core without bending stiffness carries one shear stress between its faces; with faces that do not shear, the energy
/// is the core's: 1/S = c (Q/R)²/G (Allen, "Analysis and Design of Structural Sandwich Panels", 1969, ch. 2).
#[test]
fn a_sandwich_of_unlike_faces_has_the_shear_stiffness_of_its_core() {
    let (e1, t1, e2, t2, core, g) = (70e9, 0.002_f64, 210e9, 0.0005_f64, 0.02, 80e6);
    let rigid = 0.0; // MAT8: a modulus of zero is no shear flexibility
    let (d, ea1, ea2) = (core + 0.5 * (t1 + t2), e1 * t1, e2 * t2);
    let arm = d * ea2 / (ea1 + ea2);
    let q = ea1 * arm;
    let r = ea1 * arm * arm + ea2 * (d - arm).powi(2) + (e1 * t1.powi(3) + e2 * t2.powi(3)) / 12.0;
    let expected = g * r * r / (core * q * q);
    for z0 in [-0.01, 0.0, 0.05] {
        for stiffness in shear(&[(e1, rigid, t1), (1.0, g, core), (e2, rigid, t2)], z0) {
            close(stiffness, expected, 1e-6, "sandwich");
        }
    }
}

/// Jourawski: tau(z) = (1/R) int E (z - z_n) dz from the lowest face, 1/S = int tau²/G dz, here by a fine sum over layers
/// (E, G, thickness).
fn by_a_fine_sum(layers: &[(f64, f64, f64)]) -> f64 {
    let count = 60_000;
    let total: f64 = layers.iter().map(|layer| layer.2).sum();
    let dz = total / f64::from(count);
    let moduli = |z: f64| {
        let mut top = 0.0;
        let found = layers.iter().find(|layer| {
            top += layer.2;
            z < top
        });
        found.map_or((0.0, 1.0), |layer| (layer.0, layer.1))
    };
    let points = || (0..count).map(|k| (f64::from(k) + 0.5) * dz);
    let sum = |f: &dyn Fn(f64) -> f64| points().map(|z| moduli(z).0 * f(z) * dz).sum::<f64>();
    let neutral = sum(&|z| z) / sum(&|_| 1.0);
    let rigidity = sum(&|z| (z - neutral).powi(2));
    let (mut flow, mut flexibility) = (0.0, 0.0);
    for z in points() {
        let (e, g) = moduli(z);
        let half = 0.5 * e * (z - neutral) * dz;
        flexibility += ((flow + half) / rigidity).powi(2) / g * dz;
        flow += 2.0 * half;
    }
    1.0 / flexibility
}

#[test]
fn unlike_plies_shear_as_the_balance_of_their_bending_stresses_asks() {
    let layers = [(138e9, 5e9, 0.001), (9e9, 3e9, 0.003), (40e9, 4e9, 0.002)];
    for stiffness in shear(&layers, -0.004) {
        close(stiffness, by_a_fine_sum(&layers), 1e-6, "three unlike plies");
    }
}

/// In plane xz a ply turned by an angle has the modulus Q11 c⁴ + 2 (Q12 + 2 Q66) s² c² + Q22 s⁴ (Jones, eq. 2.85) and the shear
/// modulus G1z c² + G2z s²; in plane yz those at 90 degrees less.
#[test]
fn turned_plies_shear_in_each_plane_by_their_own_moduli() {
    let span = Span::generated("test");
    let (e1, e2, nu12, g12, g1z, g2z) = (138e9, 9e9, 0.3, 5e9, 5e9, 3e9);
    let card = Mat8 {
        id: 1,
        e1,
        e2,
        nu12,
        g12,
        g1z,
        g2z,
        rho: 1600.0,
        expansion: nastran::Expansion::default(),
        span,
    };
    let material = PlaneMaterial::ply(&card).expect("a sound material");
    let (angles_deg, edges) = ([0.0, 90.0, 30.0], [-0.002, -0.001, 0.001, 0.004]);
    let plies: Vec<PlacedPly> = (0..3)
        .map(|k| PlacedPly {
            material,
            angle_rad: f64::to_radians(angles_deg[k]),
            z_low_m: edges[k],
            z_high_m: edges[k + 1],
        })
        .collect();
    let section = ShellSection::laminate(&plies, 0.0, ShearModel::Equilibrium);
    let share = 1.0 - nu12 * nu12 * e2 / e1;
    let (q11, q22) = (e1 / share, e2 / share);
    for (plane, turn_deg) in [(0, 0.0), (1, 90.0)] {
        let layers: Vec<(f64, f64, f64)> = (0..3)
            .map(|k| {
                let (s, c) = f64::to_radians(angles_deg[k] - turn_deg).sin_cos();
                let (s2, c2) = (s * s, c * c);
                let e = q11 * c2 * c2 + 2.0 * (nu12 * q22 + 2.0 * g12) * s2 * c2 + q22 * s2 * s2;
                (e, g1z * c2 + g2z * s2, edges[k + 1] - edges[k])
            })
            .collect();
        close(section.shear[(plane, plane)], by_a_fine_sum(&layers), 1e-6, "plane");
    }
}

#[test]
fn with_a_factor_plies_shear_side_by_side_each_in_its_own_direction() {
    let span = Span::generated("test");
    let card = Mat8 {
        id: 1,
        e1: 138e9,
        e2: 9e9,
        nu12: 0.3,
        g12: 5e9,
        g1z: 5e9,
        g2z: 3e9,
        rho: 1600.0,
        expansion: nastran::Expansion::default(),
        span,
    };
    let material = PlaneMaterial::ply(&card).expect("a sound material");
    let ply = |angle_deg: f64, z_low_m: f64, z_high_m: f64| PlacedPly {
        material,
        angle_rad: angle_deg.to_radians(),
        z_low_m,
        z_high_m,
    };
    let plies = [ply(0.0, 0.0, 0.001), ply(90.0, 0.001, 0.003), ply(30.0, 0.003, 0.006)];
    let section = ShellSection::laminate(&plies, 0.0, ShearModel::Factor(5.0 / 6.0));
    // components of a tensor of second rank: G1z c² + G2z s², G1z s² + G2z c², (G1z - G2z) s c
    let (s, c) = 30.0_f64.to_radians().sin_cos();
    let k = 5.0 / 6.0;
    close(
        section.shear[(0, 0)],
        k * (5e9 * 1e-3 + 3e9 * 2e-3 + (5e9 * c * c + 3e9 * s * s) * 3e-3),
        1e-12,
        "xz",
    );
    close(
        section.shear[(1, 1)],
        k * (3e9 * 1e-3 + 5e9 * 2e-3 + (5e9 * s * s + 3e9 * c * c) * 3e-3),
        1e-12,
        "yz",
    );
    close(section.shear[(0, 1)], k * 2e9 * s * c * 3e-3, 1e-9, "xz with yz");
}

/// A strip that has MID2 alone bends without shear: P L³/(3 E I), thick or thin, whatever the unit of length.
#[test]
fn a_plate_that_only_bends_is_rigid_in_shear() {
    for (length, t) in [(1.0, 0.05), (1.0, 0.0005), (1000.0, 50.0), (0.01, 0.0005)] {
        let (count, width, e, p) = (20_u32, 0.1 * length, 210e9, 3.0);
        let mut deck = format!("MAT1,1,{e:?},,0.,7800.\nPSHELL,1,,{t:?},1\nSPC1,1,12345,1,101\n");
        for k in 0..=count {
            let x = length * f64::from(k) / f64::from(count);
            let (a, b) = (k + 1, k + 101);
            deck = format!("{deck}GRID,{a},,{x:?},0.,0.\nGRID,{b},,{x:?},{width:?},0.\nSPC1,1,126,{a},{b}\n");
        }
        for k in 1..=count {
            deck = format!("{deck}CQUAD4,{k},1,{k},{},{},{}\n", k + 1, k + 101, k + 100);
        }
        let system = system(&deck);
        let u = displaced(&system, &[(count + 1, 3, 0.5 * p), (count + 101, 3, 0.5 * p)]);
        let inertia = width * t * t * t / 12.0;
        // linear rotations over n elements: 1 - 1/(4 n²) of the beam
        let expected = p * length.powi(3) / (3.0 * e * inertia) * (1.0 - 0.25 / f64::from(count * count));
        close(
            crate::common::at(&system, &u, count + 1, 3),
            expected,
            1e-4,
            &format!("{length} m long, {t} m thick"),
        );
    }
}
