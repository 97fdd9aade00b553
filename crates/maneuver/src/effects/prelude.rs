//! What every effect's file needs.

pub(super) use super::declaration::Declaration;
pub(super) use super::flight_air::Flight;
pub(super) use super::place::{Forces, Inputs, Loads, Needs, Place, REFERENCE_V_M_S, WingState};
pub(super) use super::spec::{Calibration, Parameter, Side, Spec, Stage};
pub(super) use super::{separation, signal};
pub(super) use crate::rig::Actuator;
pub(super) use crate::rom::PointMass;
