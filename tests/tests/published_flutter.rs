//! Flutter beside published, measured and independently computed results: one test a case of data/published.

#[test]
fn flutter_typical_section_theodorsen() {
    validation::check("flutter__typical_section_theodorsen");
}

#[test]
fn flutter_goland_wing() {
    validation::check("flutter__goland_wing");
}

#[test]
fn flutter_measured_papa_0012_a() {
    validation::check("flutter_measured__papa_0012_a");
}

#[test]
fn flutter_swept15_d10023a() {
    validation::check("flutter__swept15_d10023a");
}

#[test]
fn flutter_0012_pknl() {
    validation::check("flutter__flutter_0012_pknl");
}

#[test]
fn flutter_ha145e_modes() {
    validation::check("flutter__ha145e_modes");
}
