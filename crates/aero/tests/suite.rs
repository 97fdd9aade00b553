//! The tests of `aero` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod airfoil;
mod boxes;
mod closed_forms;
mod decks;
mod dlm_laws;
mod hinges;
mod lattice_laws;
mod load_laws;
mod random_lattices;
mod seams;
