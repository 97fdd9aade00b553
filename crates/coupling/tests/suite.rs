//! The tests of `coupling` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod beam_structure;
mod deck;
mod deflection_table;
mod exchange;
mod given_structures;
mod large;
mod large_adjoint;
mod large_motion;
mod large_pazy;
mod large_wing_laws;
mod laws;
mod mistaken_units;
mod nastran_deck;
mod planform;
mod planform_laws;
mod planform_shell;
mod planform_shell_errors;
mod planform_shell_sections;
mod random_splines;
mod shell_mesh;
mod shell_wing_modes;
mod small_parts;
mod straight_wing;
