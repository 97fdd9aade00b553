//! The rules on their pages.

use discover::rules::{Origin, Rules};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn the_pages_of_the_documents_are_those_of_the_rules() {
    let rules = Rules::default();
    for (name, page) in [("discover_rules.md", rules.page()), ("discover_settings.md", rules.settings_page())]
    {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name);
        if std::env::var_os("WRITE_RULES").is_some() {
            std::fs::write(&path, &page).expect("the page is written");
        }
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let again = "WRITE_RULES=1 cargo test --workspace --test discover rules";
        assert!(text == page, "docs/{name} is not what the rules are: {again}");
    }
}

#[test]
fn every_rule_says_what_it_means_and_where_it_comes_from() {
    let themes = Rules::default().themes();
    let mut names = BTreeSet::new();
    for (theme, _, rules) in &themes {
        for rule in rules {
            assert!(rule.meaning.split_whitespace().count() >= 3, "{theme}.{}: {}", rule.name, rule.meaning);
            let said = match rule.origin {
                Origin::Formula(of) | Origin::Physical(of) | Origin::Measured(of) => !of.is_empty(),
                Origin::Unknown => true,
            };
            assert!(said, "{theme}.{}", rule.name);
            assert!(names.insert((theme, rule.name)));
        }
    }
    assert!(names.len() > 100, "{}", names.len());
}

#[test]
fn rules_are_read_where_some_are_given_and_unknown_ones_are_refused() {
    let rules: Rules = serde_json::from_str(r#"{ "naming": { "most_effects": 2 } }"#).expect("rules");
    let mut expected = Rules::default();
    expected.naming.most_effects = 2;
    assert_eq!(rules, expected);
    assert!(serde_json::from_str::<Rules>(r#"{ "naming": { "most_efects": 2 } }"#).is_err());
    let text = serde_json::to_string(&expected).expect("text");
    assert_eq!(serde_json::from_str::<Rules>(&text).expect("the same"), expected);
}
