//! The cards a deck is made of, as plain data, by family: one struct a card, every number as the deck gives it, and
//! beside it how it is read, written, numbered and mirrored.
//!
//! Numbers are in the deck's own units (SI for wingroot's wings) and, for points, in the coordinate system the
//! card names; [`crate::geometry`] resolves them to the basic system.

mod beam;
mod beam_load;
mod beam_property;
mod bush;
mod conrod;
mod constraint;
mod eigen;
mod flutter;
mod force;
mod genel;
mod gravity;
mod grid;
mod gust;
pub(crate) mod kind;
mod laminate;
mod mass;
mod material;
mod monitor;
mod named_section;
mod panel;
mod prelude;
mod pressure;
mod rigid;
mod rod;
mod scalar;
mod scalar_point;
mod section_shapes;
mod shear;
mod shell;
mod solid;
mod spectral;
mod spline;
mod surface;
mod system;
mod trim;
mod tube;

pub use beam::{BeamElement, Offt, Orientation};
pub use beam_load::BeamLoad;
pub use beam_property::{BeamProperty, BeamStation};
pub use bush::{BushAxes, Cbush, Pbush};
pub use conrod::Conrod;
pub use constraint::{Mpc, SetUnion, Spc1};
pub use eigen::EigenMethod;
pub use flutter::{Aero, DampingKind, Flfact, Flutter, FlutterMethod, Mkaero, Tabdmp1};
pub use force::{CrossLoad, LineLoad, PointLoad};
pub use genel::Genel;
pub use gravity::{Gravity, LoadSum};
pub use grid::{Grid, Set1};
pub use gust::{Darea, Dmig, DynamicLoad, Gust, LoadFunction, TableOr};
pub use kind::{CardKind, Family, Step};
pub use laminate::{Pcomp, Ply};
pub use mass::{Conm1, Conm2};
pub use material::{Mat1, Mat2, Mat8, Mat9};
pub use monitor::MonitorPoint;
pub use panel::{Aefact, Caero1, Divisions, Paero1};
pub use pressure::{Pressed, Pressure};
pub use rigid::{Rbar, Rbe2, Rbe3, Rbe3Group};
pub use rod::{Crod, Prod};
pub use scalar::{ScalarElement, ScalarProperty, ScalarValue};
pub use scalar_point::Spoint;
pub use shear::{Cshear, Pshear};
pub use shell::{CornerThickness, MaterialDirection, Pshell, ShellElement};
pub use solid::{Psolid, SolidElement};
pub use spectral::{FrequencyList, FunctionTable, Randps, SpectrumShape, SpectrumTable, TimeSteps};
pub use spline::{SplineCard, SplineKind};
pub use surface::{Aelist, Aesurf};
pub use system::{Coord, CoordDefinition, CoordKind};
pub use trim::{Aecomp, Aecompl, Aelink, Aeros, Aestat, ComponentOf, Suport, Trim};
pub use tube::{Ctube, Ptube};
