//! The elastic wing on its balance: lattice, spline, structure and root-load rows, assembled once.

use crate::case::CorrectableBoxes;
use crate::error::CouplingError;
use crate::load_rows::{Balance, root_rows};
use crate::spline::Spline;
use crate::supported::SupportedStructure;
use crate::suspicion;
use crate::wing_file::{Geometry, Mount, WingFile};
use crate::wing_parts::{WingParts, correctable_boxes, wing_parts};
use aero::{AeroError, ControlSurface, Corrections, Integration, Lattice, MirrorPlane, SteadyAero};
use faer::{Mat, MatRef};
use nalgebra::Point3;
use nastran::{BulkData, InputError};
use std::path::Path;
use structure::System;

/// Standard gravity, m/s².
pub const GRAVITY_M_S2: f64 = 9.806_65;

/// A wing on a balance in steady flow, rigid if it has no structure.
///
/// Everything that depends on neither airspeed nor corrections is here, computed once: the pressures per unit
/// angle of attack, camber, control deflection and per unit displacement of the structure.
#[derive(Debug, Clone)]
pub struct ElasticWing {
    /// All boxes, fairing included.
    pub lattice: Lattice,
    /// Control surfaces.
    pub controls: Vec<ControlSurface>,
    /// Balance point and metric boxes.
    pub balance: Balance,
    /// The plane at the root.
    pub plane: MirrorPlane,
    /// Mach number of the air.
    pub mach: f64,
    /// Boxes that corrections are found for.
    pub correctable: CorrectableBoxes,
    /// Box areas and arms (paper 1, Eq. 4).
    pub integration: Integration,
    /// R, 3 by 2 a box: root loads of box loads.
    pub root_rows: Mat<f64>,
    /// Incidence of camber and twist (w^g), rad, one a box.
    pub camber: Vec<f64>,
    /// The reduced structure; none for a rigid wing.
    pub supported: Option<SupportedStructure>,
    /// The assembled structure and its spline, for what needs more than steady loads.
    pub structure: Option<(System, Spline)>,
    /// Gravity the weight is computed with, m/s².
    pub gravity_m_s2: f64,
    pub(crate) aero: SteadyAero,
    /// Cp per rad of angle of attack, n by 1.
    pub(crate) cp_alpha: Mat<f64>,
    /// Cp of camber and twist, n by 1.
    pub(crate) cp_camber: Mat<f64>,
    /// Cp per rad of each control, n by controls.
    pub(crate) cp_controls: Mat<f64>,
    /// Q D G: Cp per unit displacement of the s-set, n by s.
    pub(crate) cp_displacement: Mat<f64>,
}

/// Reads a wing's file and everything it names, assembles the wing in the tunnel, and says what was not read of it and what is
/// suspicious.
pub(crate) fn read_wing<W>(
    path: &Path,
    assemble: impl FnOnce(&WingFile, &BulkData) -> Result<W, CouplingError>,
) -> Result<(WingFile, W), CouplingError> {
    let file = WingFile::read(path)?;
    let bulk = file.bulk(Mount::Tunnel)?;
    if let Some(cards) = bulk.unread_cards() {
        tracing::warn!("{}: cards that are not read: {cards}", file.path.display());
    }
    // before it is assembled: a wing in wrong units may not carry its own weight
    for said in suspicion::of_wing(&bulk, &Lattice::from_bulk(&bulk)?) {
        tracing::warn!("{}: {said}", file.path.display());
    }
    let wing = assemble(&file, &bulk).map_err(|error| blame_root_plane(error, &file))?;
    Ok((file, wing))
}

impl ElasticWing {
    /// Names of the control surfaces, in their order.
    pub fn control_names(&self) -> Vec<String> {
        self.controls.iter().map(|control| control.name.clone()).collect()
    }

    /// Assembles a wing from its parts; solves for the unit pressures (one factorisation of the AIC).
    ///
    /// # Errors
    /// If a box crosses the root plane or sizes differ.
    pub fn new(parts: WingParts) -> Result<Self, CouplingError> {
        let boxes = parts.lattice.len();
        for (what, got) in
            [("camber and twist", parts.camber.len()), ("metric flags", parts.balance.metric.len())]
        {
            if got != boxes {
                return Err(CouplingError::Size { what, got, expected: boxes });
            }
        }
        // A wing of ours has no fin in the plane of its root.
        parts.plane.refuse_within(&parts.lattice)?;
        let aero = SteadyAero::new(&parts.lattice, parts.plane, parts.mach)?;
        let s_size = parts.supported.as_ref().map_or(0, SupportedStructure::size);
        let controls = parts.controls.len();
        let mut w = Mat::zeros(boxes, 2 + controls + s_size);
        for j in 0..boxes {
            w[(j, 0)] = parts.lattice.boxes[j].normal().z;
            w[(j, 1)] = parts.camber[j];
        }
        for (column, control) in parts.controls.iter().enumerate() {
            for (&j, slope) in control.boxes.iter().zip(&control.slope) {
                w[(j, 2 + column)] = *slope;
            }
        }
        if let Some(structure) = &parts.supported {
            for j in 0..boxes {
                for &(dof, value) in &structure.spline_rows[2 * j + 1] {
                    w[(j, 2 + controls + dof)] += value;
                }
            }
        }
        let cp = aero.pressures(w.as_ref());
        let columns = |from: usize, count: usize| cp.as_ref().subcols(from, count).to_owned();
        Ok(Self {
            correctable: correctable_boxes(&parts.lattice, &parts.fairing_surfaces),
            integration: Integration::new(&parts.lattice),
            root_rows: root_rows(&parts.lattice, &parts.balance),
            cp_alpha: columns(0, 1),
            cp_camber: columns(1, 1),
            cp_controls: columns(2, controls),
            cp_displacement: columns(2 + controls, s_size),
            lattice: parts.lattice,
            controls: parts.controls,
            balance: parts.balance,
            plane: parts.plane,
            mach: parts.mach,
            camber: parts.camber,
            supported: parts.supported,
            structure: parts.structure,
            gravity_m_s2: GRAVITY_M_S2,
            aero,
        })
    }

    /// The same wing in the same air with other masses: `supported` has the s-set, the spline and the flexibility of before, its loads
    /// are about another point.
    ///
    /// # Errors
    /// If it follows the structure otherwise.
    pub fn with_masses(
        &self,
        point: Point3<f64>,
        supported: SupportedStructure,
    ) -> Result<Self, CouplingError> {
        let before = self.supported.as_ref().map_or(0, SupportedStructure::size);
        if self.supported.as_ref().is_none_or(|own| own.spline_rows != supported.spline_rows) {
            let got = supported.size();
            return Err(CouplingError::Size { what: "motions of the structure", got, expected: before });
        }
        let balance = Balance { point, metric: self.balance.metric.clone() };
        let root_rows = root_rows(&self.lattice, &balance);
        Ok(Self { root_rows, balance, supported: Some(supported), ..self.clone() })
    }

    /// Reads a wing's RON file and everything it names, and assembles the wing as it stands in the tunnel.
    ///
    /// # Errors
    /// Bad input, a structure that is not held, a box across the root plane.
    pub fn read(path: &Path) -> Result<(WingFile, Self), CouplingError> {
        let (file, wing) = read_wing(path, Self::from_bulk)?;
        if file.geometry == Geometry::Nonlinear {
            tracing::warn!(
                "{}: geometry is Nonlinear, but deflections are taken as small here; `wingroot statics --wing`, `flutter`, `calibrate`, static cases of `tunnel` and the steady points of `fullaircraft` have them large",
                file.path.display()
            );
        }
        Ok((file, wing))
    }

    /// Assembles the wing that a file describes from its deck.
    ///
    /// # Errors
    /// As [`ElasticWing::read`].
    pub fn from_bulk(file: &WingFile, bulk: &BulkData) -> Result<Self, CouplingError> {
        Self::new(wing_parts(file, bulk)?)
    }

    /// Corrections of the correctable boxes spread over the whole lattice, neutral elsewhere.
    ///
    /// # Errors
    /// If there is not one entry for each correctable box.
    pub fn padded(&self, corrections: &Corrections) -> Result<Corrections, CouplingError> {
        if corrections.len() != self.correctable.len() {
            return Err(CouplingError::Size {
                what: "corrections (one for each box of the wing, fairing excluded)",
                got: corrections.len(),
                expected: self.correctable.len(),
            });
        }
        Ok(corrections.padded(self.lattice.len(), &self.correctable.places))
    }

    /// Pressure coefficients of any incidence, columns one by one: `cp = Q w`.
    pub fn pressures(&self, w: MatRef<'_, f64>) -> Mat<f64> {
        self.aero.pressures(w)
    }

    /// Q D G: pressure coefficients per unit displacement of the s-set, boxes by s.
    pub fn pressures_by_displacement(&self) -> MatRef<'_, f64> {
        self.cp_displacement.as_ref()
    }

    /// Pressure coefficients per rad of each control, boxes by controls.
    pub fn pressures_by_control(&self) -> MatRef<'_, f64> {
        self.cp_controls.as_ref()
    }

    /// Pressure coefficients per rad of angle of attack, one a box.
    pub fn pressures_by_alpha(&self) -> &[f64] {
        self.cp_alpha.col_as_slice(0)
    }

    /// Pressure coefficients of camber and twist, one a box.
    pub fn pressures_of_camber(&self) -> &[f64] {
        self.cp_camber.col_as_slice(0)
    }
}

/// A plane that does not fit the boxes is the file's `root_plane`.
fn blame_root_plane(error: CouplingError, file: &WingFile) -> CouplingError {
    match error {
        CouplingError::Aero(
            plane
            @ (AeroError::CrossesPlane { .. } | AeroError::InPlane { .. } | AeroError::BothSides { .. }),
        ) => InputError::in_field(&file.path, "root_plane", plane.to_string())
            .with_help("all boxes, the fairing's included, lie on one side of root_plane: check its y")
            .into(),
        other => other,
    }
}
