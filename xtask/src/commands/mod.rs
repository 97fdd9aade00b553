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
pub(crate) mod fullaircraft;
mod fullaircraft_figures;
pub(crate) mod modes;
mod modes_pictures;
mod modes_update;
pub(crate) mod pipeline;
pub(crate) mod response;
mod response_asymmetry;
mod response_figures;
mod response_files;
mod response_points;
mod response_source;
mod response_text;
pub(crate) mod simulate;
pub(crate) mod tidy;
pub(crate) mod tunnel;
pub(crate) mod validate;
