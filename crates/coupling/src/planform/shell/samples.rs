//! A small shell-and-solid wing for the tests of this folder, its section given by formulas.

use super::settings::{
    Band, Foam, LineMass, MeshSettings, PlyMaterial, PlySettings, Profile, ShellSolid, Surface,
};
use crate::planform::{Boxes, Planform, PointMass, Structure};
use std::path::PathBuf;

/// Heights of lower and upper surface over the chord: a parabola as camber line, thickness with a round nose.
pub(super) fn heights(x: f64) -> [f64; 2] {
    let (camber, half) = (0.12 * x * (1.0 - x), 0.15 * x.sqrt() * (1.0 - x));
    [camber - half, camber + half]
}

/// A folder with that section, removed when it is dropped.
pub(super) struct Folder(pub(super) PathBuf);

impl Folder {
    pub(super) fn new(test: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-section-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        let places: Vec<f64> = (0..=80).map(|k| (f64::from(k) / 80.0).powi(2)).collect();
        let point = |x: f64, side: usize| format!("{x:.12} {:.12}\n", heights(x)[side]);
        let upper: String = places.iter().rev().map(|x| point(*x, 1)).collect();
        let lower: String = places.iter().skip(1).map(|x| point(*x, 0)).collect();
        std::fs::write(folder.join("formula.dat"), format!("formula\n{upper}{lower}")).expect("a section");
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// 2 m from root to tip, chord 0.8 to 0.4 m, two strips of two boxes.
pub(super) fn planform(shell: ShellSolid) -> Planform {
    Planform {
        semispan_m: 2.0,
        root_chord_m: 0.8,
        tip_chord_m: 0.4,
        quarter_chord_sweep_deg: 0.0,
        dihedral_deg: 0.0,
        twist_deg: (0.0, 0.0),
        root_leading_edge_x_m: 0.0,
        airfoil: Some("formula.dat".to_owned()),
        boxes: Boxes { chordwise: 4, spanwise: 2, strip_edges: None },
        fairing: None,
        controls: Vec::new(),
        structure: Some(Structure::ShellSolid(Box::new(shell))),
    }
}

/// A ply of one thickness.
pub(super) fn ply(material: &str, on: &[Surface], thickness_m: f64, angle_deg: f64) -> PlySettings {
    PlySettings {
        material: material.to_owned(),
        on: on.to_vec(),
        thickness_m: Profile(vec![(0.0, thickness_m)]),
        angle_deg,
        band: None,
    }
}

/// Two materials, a skin with a cap near the nose, webs at a quarter and three quarters.
pub(super) fn shell() -> ShellSolid {
    let material = |name: &str, e1_pa: f64, e2_pa: f64, g12_pa: f64, rho_kg_m3: f64| PlyMaterial {
        name: name.to_owned(),
        e1_pa,
        e2_pa,
        nu12: 0.3,
        g12_pa,
        rho_kg_m3,
    };
    let mut cap = ply("cloth", &[Surface::Upper, Surface::Lower], 0.9e-3, 0.0);
    // From 0.03 to 0.23 of every chord.
    cap.band = Some(Band { centre_over_c: 0.13, width_m: Profile(vec![(0.0, 0.16), (2.0, 0.08)]) });
    ShellSolid {
        mesh: MeshSettings::default(),
        elastic_axis_over_c: 0.4,
        materials: vec![material("cloth", 20e9, 20e9, 5e9, 1800.0), material("uni", 40e9, 9e9, 4e9, 1900.0)],
        foam: Foam { e_pa: 4e7, nu: 0.25, rho_kg_m3: 40.0 },
        plies: vec![
            ply("cloth", &[Surface::Upper, Surface::Lower], 0.3e-3, 0.0),
            cap,
            ply("uni", &[Surface::Webs], 2e-3, 0.0),
            ply("uni", &[Surface::LeadingEdge, Surface::TrailingEdge], 0.1e-3, 0.0),
        ],
        webs_over_c: vec![0.74, 0.26],
        finish_kg_m2: 0.5,
        line_masses: vec![LineMass { name: "cable".to_owned(), x_over_c: 0.9, mass_kg_m: 0.2 }],
        point_masses: Vec::new(),
        sensors: vec![PointMass { name: "imu".to_owned(), y_m: 1.0, x_over_c: 0.5, mass_kg: 0.1 }],
        balance_stiffness: (1e8, 1e8, 1e8, 1e7, 1e7, 1e7),
    }
}
