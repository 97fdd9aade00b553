//! The house rules hold: the same checks as `cargo xtask tidy`.

#[test]
fn the_repository_keeps_its_house_rules() {
    let complaints = xtask::tidy::check(&xtask::repository::root()).expect("the checks run");
    let list: Vec<String> = complaints.iter().map(ToString::to_string).collect();
    assert!(list.is_empty(), "{} complaints\n{}", list.len(), list.join("\n"));
}
