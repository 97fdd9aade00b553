//! The wing of the truth: the model's planform with about twice as many boxes, its structure with more elements, and
//! the same structure slightly changed, from which the matrices' derivatives are taken.

use coupling::planform::{Mesh, Planform, Structure};
use coupling::{ByLoad, WingFile};
use nastran::InputError;
use std::path::Path;
use tunnel::{BeamChange, Blocks, Noise, Statics, Truth, TruthSettings, TunnelError, TunnelFile};

/// Elements of the true beam for every element of the modelled one.
const ELEMENTS: f64 = 1.5;

/// A beam like the model's.
pub(crate) fn same_beam(elements: usize, damping_ratio: f64) -> BeamChange {
    BeamChange {
        elements,
        bending: (1.0, 1.0),
        torsion: (1.0, 1.0),
        mass: (1.0, 1.0),
        axis_aft_over_c: 0.0,
        mass_aft_over_c: 0.0,
        damping_ratio,
    }
}

/// Number of elements of the true beam.
pub(crate) fn elements(planform: &Planform) -> usize {
    let modelled = match &planform.structure {
        Some(Structure::Beam(beam)) => beam.elements,
        _ => 0,
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
    let elements = (modelled as f64 * ELEMENTS).round() as usize;
    elements
}

/// The wing's file, whose planform the truth needs.
///
/// # Errors
/// A file that cannot be read, or a wing that is a deck or rigid.
pub(crate) fn file(path: &Path) -> Result<(WingFile, Planform), InputError> {
    let file = WingFile::read(path)?;
    let beam = |planform: &&Planform| matches!(planform.structure, Some(Structure::Beam(_)));
    let planform = file.planform().filter(beam).cloned().ok_or_else(|| {
        InputError::in_file(
            path,
            "the benchmark hides effects in a parametric wing with a beam, and this is none",
        )
        .with_help("give a wing file with `source: Parametric((...))` and `structure: Beam((...))`")
    })?;
    Ok((file, planform))
}

/// Lattice, beam and all else of a truth.
///
/// # Errors
/// As [`Truth::build`].
pub(crate) fn wing(path: &Path, mesh: Mesh, beam: BeamChange) -> Result<Truth, TunnelError> {
    let none = ByLoad::default();
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    Truth::build(&TunnelFile {
        name: String::new(),
        wing: name,
        seed: 0,
        rho_kg_m3: crate::design::RHO_KG_M3,
        curvature: false,
        truth: TruthSettings { mesh: Some(mesh), beam: Some(beam), sections: None },
        statics: Statics {
            airspeeds_m_s: Vec::new(),
            angles_deg: Vec::new(),
            blocks: Blocks { replicates: Vec::new(), offset_sigma: none },
            tilt_deg: Vec::new(),
            tip_z_sigma_m: 0.0,
        },
        noise: Noise { sample: none, static_point: none },
        dynamics: None,
        runs: Vec::new(),
        split: None,
        path: path.to_path_buf(),
    })
}
