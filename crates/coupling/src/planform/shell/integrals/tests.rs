//! Sections beside sums over a curve that is given by formulas, and single plies beside the moduli of Jones' book.

use super::super::samples::{Folder, heights, planform, ply, shell};
use super::*;
use crate::planform::shell::LineMass;
use nalgebra::{Matrix3, Vector3};

fn same(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found} beside {expected}");
}

/// The section at 1 m, chord 0.6 m.
fn with_cut<T>(test: &str, shell: &ShellSolid, of: impl Fn(&Cut<'_>) -> T) -> T {
    let folder = Folder::new(test);
    let planform = planform(shell.clone());
    let contour = Contour::read(&planform, &folder.0).expect("the section");
    let layup = Layup { settings: shell, planform: &planform };
    of(&Cut { layup, contour, y_m: 1.0, chord_m: planform.chord_m(1.0) })
}

/// Jones, Mechanics of Composite Materials, eqs. 2.97: moduli of a layer turned by an angle.
#[test]
fn a_turned_ply_has_the_moduli_of_a_turned_layer() {
    let (e1, e2, g12, nu12, t) = (40e9, 9e9, 4e9, 0.3, 0.7e-3);
    for angle in [0.0, 20.0, 45.0, -65.0, 90.0_f64] {
        let mut wing = shell();
        wing.plies = vec![ply("uni", &[Surface::Webs], t, angle)];
        let (axial, shear, mass) =
            with_cut(&format!("ply{angle}"), &wing, |cut| cut.laminate(Surface::Webs, [0.0, 1.0]));
        let (s, c) = angle.to_radians().sin_cos();
        let (s2, c2) = (s * s, c * c);
        let ex = 1.0 / (c2 * c2 / e1 + (1.0 / g12 - 2.0 * nu12 / e1) * s2 * c2 + s2 * s2 / e2);
        let mixed = 2.0 * (2.0 / e1 + 2.0 / e2 + 4.0 * nu12 / e1 - 1.0 / g12) * s2 * c2;
        let gxy = 1.0 / (mixed + (s2 * s2 + c2 * c2) / g12);
        same(axial, ex * t, 1e-9, "along");
        same(shear, gxy * t, 1e-9, "in shear");
        same(mass, 1900.0 * t, 1e-12, "mass");
    }
    // A pair at opposite angles does not shear under tension: A11 - A12^2/A22, and A66.
    let mut wing = shell();
    wing.plies = vec![ply("uni", &[Surface::Upper], t, 30.0), ply("uni", &[Surface::Upper], t, -30.0)];
    let (axial, shear, _) = with_cut("pair", &wing, |cut| cut.laminate(Surface::Upper, [0.2, 0.3]));
    let (s2, c2) = (0.25, 0.75);
    let scale = 1.0 / (1.0 - nu12 * nu12 * e2 / e1);
    let (q11, q22, q12) = (scale * e1, scale * e2, scale * nu12 * e2);
    // Eq. 2.80.
    let a11 = q11 * c2 * c2 + 2.0 * (q12 + 2.0 * g12) * s2 * c2 + q22 * s2 * s2;
    let a22 = q11 * s2 * s2 + 2.0 * (q12 + 2.0 * g12) * s2 * c2 + q22 * c2 * c2;
    let a12 = (q11 + q22 - 4.0 * g12) * s2 * c2 + q12 * (s2 * s2 + c2 * c2);
    let a66 = (q11 + q22 - 2.0 * q12 - 2.0 * g12) * s2 * c2 + g12 * (s2 * s2 + c2 * c2);
    same(axial, 2.0 * t * (a11 - a12 * a12 / a22), 1e-9, "a pair along");
    same(shear, 2.0 * t * a66, 1e-9, "a pair in shear");
    wing.plies.clear();
    assert_eq!(with_cut("none", &wing, |cut| cut.laminate(Surface::Upper, [0.2, 0.3])), (0.0, 0.0, 0.0));
}

/// Sums by hand: `[ea, ea_x, ea_z, ea_xx, ea_zz, mass, mass_x]`.
struct ByHand {
    sums: [f64; 7],
    /// Lengths over shear stiffness of the skin, and areas, of the three cells.
    walls: [f64; 3],
    areas: [f64; 3],
}

const CHORD: f64 = 0.6;
const STEPS: u32 = 20_000;
const WEBS: [f64; 2] = [0.25, 0.75];

fn by_hand(caps: bool) -> ByHand {
    let mut all = ByHand { sums: [0.0; 7], walls: [0.0; 3], areas: [0.0; 3] };
    let add = |sums: &mut [f64; 7], [x, z]: [f64; 2], ea: f64, zz: f64, mass: f64| {
        let own = [ea, ea * x, ea * z, ea * x * x, ea * z * z + zz, mass, mass * x];
        sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
    };
    let place = |step: u32| (f64::from(step) / f64::from(STEPS)).powi(2);
    for step in 0..STEPS {
        let (from, to) = (place(step), place(step + 1));
        let x = 0.5 * (from + to);
        let cell = WEBS.iter().filter(|web| x > **web).count();
        let t = 0.3e-3 + if caps && (0.03..0.23).contains(&x) { 0.9e-3 } else { 0.0 };
        let (low, high) = (heights(from), heights(to));
        for side in 0..2 {
            let length = CHORD * (to - from).hypot(high[side] - low[side]);
            let z = 0.5 * (low[side] + high[side]) * CHORD;
            add(&mut all.sums, [x * CHORD, z], 20e9 * t * length, 0.0, (1800.0 * t + 0.5) * length);
            all.walls[cell] += length / (5e9 * t);
        }
        // Foam: a strip from surface to surface.
        let [z_low, z_high] = [0, 1].map(|side| 0.5 * (low[side] + high[side]) * CHORD);
        let (width, height) = ((to - from) * CHORD, z_high - z_low);
        let middle = [x * CHORD, 0.5 * (z_low + z_high)];
        let ea = 4e7 * width * height;
        add(&mut all.sums, middle, ea, ea * height * height / 12.0, 40.0 * width * height);
        all.areas[cell] += width * height;
    }
    for x in WEBS {
        let [low, high] = heights(x).map(|z| z * CHORD);
        let (height, t) = (high - low, 2e-3);
        let ea = 40e9 * t * height;
        let middle = [x * CHORD, 0.5 * (low + high)];
        add(&mut all.sums, middle, ea, ea * height * height / 12.0, 1900.0 * t * height);
    }
    add(&mut all.sums, [0.9 * CHORD, 0.0], 0.0, 0.0, 0.2);
    all
}

#[test]
fn a_section_of_skin_caps_webs_and_core_is_the_sum_over_its_curve() {
    let (shell, hand, folder) = (shell(), by_hand(true), Folder::new("whole"));
    let got = shell.section_integrals(&planform(shell.clone()), &folder.0, 1.0).expect("a section");
    let [ea, ea_x, ea_z, ea_xx, ea_zz, mass, mass_x] = hand.sums;
    same(got.mass_kg_m, mass, 1e-4, "mass");
    same(got.centre_of_gravity, mass_x / mass / CHORD, 1e-4, "centre of gravity");
    same(got.tension_centre, ea_x / ea / CHORD, 1e-4, "tension centre");
    same(got.ei_flap_nm2, ea_zz - ea_z * ea_z / ea, 1e-4, "flap");
    same(got.ei_lag_nm2, ea_xx - ea_x * ea_x / ea, 1e-4, "lag");
    // Three cells: flows q under a unit twist. Each wall between two is passed by both.
    let web = |x: f64| (heights(x)[1] - heights(x)[0]) * CHORD / (4e9 * 2e-3);
    let [w1, w2] = WEBS.map(web);
    let [s1, s2, s3] = hand.walls;
    let walls = Matrix3::new(s1 + w1, -w1, 0.0, -w1, s2 + w1 + w2, -w2, 0.0, -w2, s3 + w2);
    let areas = Vector3::from(hand.areas);
    let flows = walls.try_inverse().expect("cells") * areas * 2.0;
    let bredt = 2.0 * flows.dot(&areas);
    // Without webs one cell: less, as the stiff nose helps less.
    let single = 4.0 * areas.sum().powi(2) / (s1 + s2 + s3);
    assert!(bredt > 1.1 * single, "{bredt} beside {single}");
    let cubed: f64 = (0..STEPS)
        .map(|step| {
            let x = (f64::from(step) + 0.5) / f64::from(STEPS);
            (heights(x)[1] - heights(x)[0]).powi(3) / f64::from(STEPS)
        })
        .sum();
    let core = 4e7 / (2.0 * 1.25) * cubed * CHORD.powi(4) / 3.0;
    same(got.gj_nm2, bredt + core, 2e-3, "torsion");
    let (own, own_core) = with_cut("torsion", &shell, |cut| (cut.bredt(), cut.core_torsion()));
    same(own, bredt, 2e-3, "Bredt");
    same(own_core, core, 1e-4, "the core's torsion");
}

#[test]
fn one_cell_without_webs_has_bredts_torsion_and_lines_carry_no_load() {
    let mut wing = shell();
    wing.webs_over_c.clear();
    wing.plies.truncate(1);
    let hand = by_hand(false);
    let (own, none) = with_cut("single", &wing, |cut| (cut.bredt(), cut.webs()));
    assert!(none.is_empty());
    let area: f64 = hand.areas.iter().sum();
    same(own, 4.0 * area * area / hand.walls.iter().sum::<f64>(), 2e-4, "one cell");
    let (webs, chord_m) = with_cut("webs", &shell(), |cut| (cut.webs(), cut.chord_m));
    assert_eq!(webs, WEBS);
    assert!((chord_m - CHORD).abs() < 1e-12);
    let (folder, planform) = (Folder::new("lines"), planform(wing.clone()));
    let before = wing.section_integrals(&planform, &folder.0, 1.0).expect("a section");
    wing.line_masses.push(LineMass { name: "more".to_owned(), x_over_c: 0.1, mass_kg_m: 1.0 });
    let after = wing.section_integrals(&planform, &folder.0, 1.0).expect("a section");
    assert!((after.mass_kg_m - before.mass_kg_m - 1.0).abs() < 1e-12);
    let moment = |of: &SectionIntegrals| of.mass_kg_m * of.centre_of_gravity;
    assert!((moment(&after) - moment(&before) - 0.1).abs() < 1e-12);
    assert!((after.ei_flap_nm2 / before.ei_flap_nm2 - 1.0).abs() < 1e-12);
}
