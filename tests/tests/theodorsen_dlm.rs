//! Strip theory from the doublet lattice, in frequency and in time, beside closed forms: one test a case.

#[test]
fn unsteady2d_theodorsen() {
    validation::check("unsteady2d__theodorsen");
}

#[test]
fn unsteady2d_wagner_kussner() {
    validation::check("unsteady2d__wagner_kussner");
}
