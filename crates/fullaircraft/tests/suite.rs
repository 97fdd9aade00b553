//! The tests of `fullaircraft` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod assembly;
mod bah_gust;
mod cases;
mod common;
mod deck_cards;
mod deck_flutter;
mod deck_gust;
mod deck_plan;
mod deck_plan_gusts;
mod deck_trim;
mod derivatives;
mod envelope;
mod flight;
mod flight_nonlinear;
mod general_trim;
mod gust_signals;
mod large_trim;
mod mirror;
mod net_monitors;
mod package;
mod pratt;
mod rectangular_wing;
mod stations;
mod trim;
mod turbulence;
mod unstable;
