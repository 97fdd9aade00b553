//! A wing as matrices.

use std::path::PathBuf;

use pyo3::prelude::*;
use pyo3::types::PyDict;
use wingroot::aero::{Corrections, Flow};
use wingroot::calibrate::Schedule;
use wingroot::coupling::{ElasticWing, WingFile};
use wingroot::failure::Failure;
use wingroot::maneuver::Rig;
use wingroot::matrices;

use crate::arrays::{Sparse, dict, sparse};
use crate::raised::checked;

/// The elastic wing of a file, with what every airspeed has in common.
#[pyclass(frozen)]
pub(crate) struct Model {
    file: WingFile,
    wing: ElasticWing,
}

#[pymethods]
impl Model {
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let read = py.detach(|| ElasticWing::read(&path).map_err(Failure::from));
        checked(py, read).map(|(file, wing)| Self { file, wing })
    }

    /// Boxes: corners, normals, pressures per incidence, camber.
    fn boxes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let group = py.detach(|| matrices::boxes(&self.wing));
        dict(py, checked(py, group)?)
    }

    /// Grids and modes; None for a rigid wing.
    fn structure<'py>(&self, py: Python<'py>, modes: usize) -> PyResult<Option<Bound<'py, PyDict>>> {
        let group = py.detach(|| matrices::structure(&self.wing, modes));
        checked(py, group)?.map(|group| dict(py, group)).transpose()
    }

    /// Stiffness, mass, and grid and component (1 to 6) of each row; None for a rigid wing.
    #[expect(clippy::type_complexity, reason = "a tuple that Python unpacks")]
    fn stiffness_and_mass<'py>(&self, py: Python<'py>) -> Option<(Sparse<'py>, Sparse<'py>, Vec<(u32, u8)>)> {
        let (system, _) = self.wing.structure.as_ref()?;
        let names = (0..system.free_count()).map(|free| system.name(free)).collect();
        Some((sparse(py, system.stiffness()), sparse(py, system.mass()), names))
    }

    /// The linear systems that `simulate` flies at these airspeeds; without a file of corrections those of theory.
    fn state_spaces<'py>(
        &self,
        py: Python<'py>,
        v_m_s: Vec<f64>,
        rho_kg_m3: f64,
        corrections: Option<PathBuf>,
    ) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let schedule = corrections.map(|path| checked(py, Schedule::read(&path))).transpose()?;
        let at = |rig: &Rig<'_>, v_m_s: f64| {
            let corrections = match &schedule {
                Some(schedule) => schedule.at(v_m_s)?,
                None => Corrections::neutral(self.wing.correctable.len()),
            };
            Ok(matrices::linear_system("", &rig.at(Flow { v_m_s, rho_kg_m3 }, &corrections)?))
        };
        let systems = py.detach(|| {
            let rig = Rig::new(&self.wing, matrices::rig_settings(&self.file, &self.wing))?;
            v_m_s.iter().map(|&v_m_s| at(&rig, v_m_s)).collect::<Result<Vec<_>, Failure>>()
        });
        checked(py, systems)?.into_iter().map(|group| dict(py, group)).collect()
    }
}
