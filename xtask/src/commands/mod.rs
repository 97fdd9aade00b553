//! One file per command.

pub(crate) mod bench;
mod bench_dlm;
mod bench_general;
mod bench_structure;
pub(crate) mod calibrate;
mod calibrate_common;
mod calibrate_figures;
mod calibrate_strips;
pub(crate) mod deck;
pub(crate) mod flutter;
mod flutter_figures;
pub(crate) mod fullaircraft;
mod fullaircraft_figures;
pub(crate) mod modes;
mod modes_pictures;
mod modes_update;
pub(crate) mod pipeline;
pub(crate) mod simulate;
pub(crate) mod tidy;
pub(crate) mod tunnel;
pub(crate) mod validate;
