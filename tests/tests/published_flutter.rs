//! Flutter beside published, measured and independently computed results: one test a case of data/published.

#[test]
fn flutter_typical_section_theodorsen() {
    validation::check("flutter__typical_section_theodorsen");
}
