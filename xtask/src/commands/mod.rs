//! One file per command.

pub(crate) mod bench;
mod bench_dlm;
mod bench_general;
pub(crate) mod calibrate;
mod calibrate_figures;
mod calibrate_strips;
pub(crate) mod fullaircraft;
mod fullaircraft_figures;
pub(crate) mod pipeline;
pub(crate) mod simulate;
pub(crate) mod tidy;
pub(crate) mod tunnel;
