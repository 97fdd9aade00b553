//! The tests of `structure` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod averages;
mod beam_loads;
mod broken_decks;
mod cards_of_a_cantilever;
mod common;
mod composites;
mod contract;
mod contract_of_a_shell;
mod contract_of_an_element;
mod curved_shells;
mod effective_mass;
mod large;
mod large_deflections;
mod large_laws;
mod large_limits;
mod large_modes;
mod large_pazy;
mod large_shells;
mod load_cards;
mod membrane_with_drilling;
mod meshed;
mod modes_closed_forms;
mod parts;
#[path = "large/pazy_beam.rs"]
mod pazy_beam;
mod properties;
mod quadratic_solids;
mod refused;
mod solids_bending;
mod solids_contract;
mod solids_patch;
mod solids_refused;
mod static_closed_forms;
mod update;
mod users_decks;
