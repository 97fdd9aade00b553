//! A deck's content: every card that is read, by kind.

use crate::cards::{
    Aefact, Aelist, Aesurf, BeamElement, BeamProperty, Caero1, Conm2, Coord, Grid, Mat1, MonitorPoint, Rbe2,
    Set1, Spc1,
};
use crate::case_control::Subcase;
use crate::dmi::Dmi;
use crate::fe_cards::{
    Cbush, Conm1, Crod, Genel, Mat2, Mat8, Mat9, Mpc, Pbush, Pcomp, Prod, Pshell, Psolid, Rbar, Rbe3,
    ScalarElement, ScalarProperty, ShellElement, SolidElement, SplineCard,
};
use crate::source::Span;
use crate::trim_cards::{Aecomp, Aelink, Aeros, Aestat, Suport, Trim};
use std::collections::BTreeMap;

/// What a deck says. Maps are in ascending identification numbers, which is Nastran's own order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BulkData {
    /// GRID.
    pub grids: BTreeMap<u32, Grid>,
    /// CORD1R, CORD1C, CORD1S, CORD2R, CORD2C, CORD2S.
    pub coords: BTreeMap<u32, Coord>,
    /// CBAR, CBEAM.
    pub beams: BTreeMap<u32, BeamElement>,
    /// PBAR, PBEAM.
    pub beam_properties: BTreeMap<u32, BeamProperty>,
    /// MAT1.
    pub materials: BTreeMap<u32, Mat1>,
    /// CONM2.
    pub masses: BTreeMap<u32, Conm2>,
    /// RBE2.
    pub rigid: BTreeMap<u32, Rbe2>,
    /// SPC1, in file order.
    pub constraints: Vec<Spc1>,
    /// SPCADD: the sets that a set unites.
    pub constraint_unions: BTreeMap<u32, Vec<u32>>,
    /// MPCADD: the sets that a set unites.
    pub equation_unions: BTreeMap<u32, Vec<u32>>,
    /// CQUAD4, CTRIA3.
    pub shells: BTreeMap<u32, ShellElement>,
    /// PSHELL.
    pub shell_properties: BTreeMap<u32, Pshell>,
    /// PCOMP, PCOMPG.
    pub laminates: BTreeMap<u32, Pcomp>,
    /// CHEXA, CPENTA, CTETRA.
    pub solids: BTreeMap<u32, SolidElement>,
    /// PSOLID.
    pub solid_properties: BTreeMap<u32, Psolid>,
    /// CROD.
    pub rods: BTreeMap<u32, Crod>,
    /// PROD.
    pub rod_properties: BTreeMap<u32, Prod>,
    /// CBUSH.
    pub bushes: BTreeMap<u32, Cbush>,
    /// PBUSH.
    pub bush_properties: BTreeMap<u32, Pbush>,
    /// CELAS1, CELAS2.
    pub springs: BTreeMap<u32, ScalarElement>,
    /// PELAS.
    pub spring_properties: BTreeMap<u32, ScalarProperty>,
    /// CMASS1, CMASS2.
    pub scalar_masses: BTreeMap<u32, ScalarElement>,
    /// PMASS.
    pub mass_properties: BTreeMap<u32, ScalarProperty>,
    /// GENEL.
    pub general: BTreeMap<u32, Genel>,
    /// CONM1.
    pub mass_matrices: BTreeMap<u32, Conm1>,
    /// RBAR.
    pub rigid_bars: BTreeMap<u32, Rbar>,
    /// RBE3.
    pub averages: BTreeMap<u32, Rbe3>,
    /// MPC, in file order.
    pub equations: Vec<Mpc>,
    /// MAT2.
    pub plane_materials: BTreeMap<u32, Mat2>,
    /// MAT8.
    pub ply_materials: BTreeMap<u32, Mat8>,
    /// MAT9.
    pub solid_materials: BTreeMap<u32, Mat9>,
    /// SPLINE1, SPLINE2, SPLINE4, SPLINE5.
    pub splines: BTreeMap<u32, SplineCard>,
    /// PARAM with a number, by name in capitals.
    pub parameters: BTreeMap<String, f64>,
    /// CAERO1.
    pub panels: BTreeMap<u32, Caero1>,
    /// PAERO1 (bodies are not read).
    pub panel_properties: BTreeMap<u32, Span>,
    /// AEFACT.
    pub factors: BTreeMap<u32, Aefact>,
    /// AESURF.
    pub surfaces: BTreeMap<u32, Aesurf>,
    /// AELIST.
    pub box_lists: BTreeMap<u32, Aelist>,
    /// SET1.
    pub sets: BTreeMap<u32, Set1>,
    /// MONPNT1, MONPNT3, in file order.
    pub monitors: Vec<MonitorPoint>,
    /// DMI matrices by name.
    pub matrices: BTreeMap<String, Dmi>,
    /// AEROS.
    pub aero_reference: Option<Aeros>,
    /// AESTAT.
    pub trim_variables: BTreeMap<u32, Aestat>,
    /// TRIM.
    pub trims: BTreeMap<u32, Trim>,
    /// AELINK, in file order.
    pub aero_links: Vec<Aelink>,
    /// AECOMP by name.
    pub aero_components: BTreeMap<String, Aecomp>,
    /// Subcases of the case control.
    pub subcases: Vec<Subcase>,
    /// SUPORT, in file order.
    pub supports: Vec<Suport>,
    /// Cards that are not read, with how often each occurs.
    pub unknown: BTreeMap<String, usize>,
}
