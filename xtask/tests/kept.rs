//! What must be kept up: licences, sources and bans of `deny.toml`, and the oldest compiler.
//!
//! `cargo deny check` does more (advisories, which need the network); this needs only cargo.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn text(name: &str) -> String {
    std::fs::read_to_string(repository().join(name)).expect("a file of the repository")
}

/// All packages that are built on, from cargo: for every platform, or for this one if others are not downloaded.
fn packages() -> Vec<Value> {
    let run = |more: &[&str]| {
        Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["metadata", "--offline", "--locked", "--format-version", "1"])
            .args(more)
            .current_dir(repository())
            .output()
            .expect("cargo runs")
    };
    let compiler = Command::new("rustc").arg("-vV").output().expect("rustc runs").stdout;
    let compiler = String::from_utf8_lossy(&compiler).into_owned();
    let host = compiler.lines().find_map(|line| line.strip_prefix("host: ")).expect("rustc names its host");
    let all = run(&[]);
    let output = if all.status.success() { all } else { run(&["--filter-platform", host]) };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo writes JSON");
    metadata["packages"].as_array().expect("packages").clone()
}

/// The quoted words of `key = [...]` in deny.toml.
fn list(deny: &str, key: &str) -> Vec<String> {
    let after = deny.split(&format!("\n{key} = [")).nth(1).expect("deny.toml has the key");
    let inside = after.split(']').next().unwrap_or_default();
    inside.split('"').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Whether a licence expression (SPDX, and the older slash for OR) can be met with the allowed ones.
fn is_allowed(expression: &str, allowed: &[String]) -> bool {
    let spaced = expression.replace('/', " OR ").replace('(', " ( ").replace(')', " ) ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let (met, rest) = any_of(&words, allowed);
    met && rest.is_empty()
}

fn any_of<'a>(words: &'a [&'a str], allowed: &[String]) -> (bool, &'a [&'a str]) {
    let (mut met, mut rest) = all_of(words, allowed);
    while let Some(("OR", after)) = rest.split_first().map(|(first, after)| (*first, after)) {
        let (other, left) = all_of(after, allowed);
        (met, rest) = (met || other, left);
    }
    (met, rest)
}

fn all_of<'a>(words: &'a [&'a str], allowed: &[String]) -> (bool, &'a [&'a str]) {
    let (mut met, mut rest) = one(words, allowed);
    while let Some(("AND", after)) = rest.split_first().map(|(first, after)| (*first, after)) {
        let (other, left) = one(after, allowed);
        (met, rest) = (met && other, left);
    }
    (met, rest)
}

fn one<'a>(words: &'a [&'a str], allowed: &[String]) -> (bool, &'a [&'a str]) {
    match words {
        ["(", inside @ ..] => {
            let (met, rest) = any_of(inside, allowed);
            (met, rest.get(1..).unwrap_or_default())
        }
        // A licence with an exception must be listed as such.
        [name, "WITH", exception, rest @ ..] => (allowed.contains(&format!("{name} WITH {exception}")), rest),
        [name, rest @ ..] => (allowed.iter().any(|other| other == name), rest),
        [] => (false, words),
    }
}

#[test]
fn licence_expressions_are_understood() {
    let allowed = ["MIT", "Unicode-3.0"].map(str::to_owned);
    for good in ["MIT", "MIT/Apache-2.0", "GPL-3.0 OR MIT", "(MIT OR X) AND Unicode-3.0", "X WITH Y OR MIT"] {
        assert!(is_allowed(good, &allowed), "{good}");
    }
    for bad in ["", "GPL-3.0", "MIT AND GPL-3.0", "MIT WITH exception", "(MIT OR X) AND Y"] {
        assert!(!is_allowed(bad, &allowed), "{bad}");
    }
}

#[test]
fn every_library_has_an_accepted_licence_and_comes_from_the_registry() {
    let allowed = list(&text("deny.toml"), "allow");
    assert!(allowed.len() >= 4, "{allowed:?}");
    for package in packages() {
        let name = package["name"].as_str().expect("a name");
        let Some(source) = package["source"].as_str() else { continue };
        assert_eq!(source, "registry+https://github.com/rust-lang/crates.io-index", "{name}");
        let licence = package["license"].as_str().unwrap_or_default();
        assert!(
            is_allowed(licence, &allowed),
            "{name} has the licence `{licence}`, which deny.toml does not accept"
        );
    }
}

#[test]
fn no_dependency_of_ours_is_a_wildcard_and_banned_versions_are_not_there() {
    for package in packages() {
        let version = package["version"].as_str().expect("a version");
        if package["name"] == "faer" {
            assert!(version.starts_with("0.24."), "faer {version}: deny.toml bans another matrix library");
        }
        if package["source"].is_null() {
            for dependency in package["dependencies"].as_array().expect("dependencies") {
                assert!(
                    dependency["req"] != "*" || !dependency["path"].is_null(),
                    "{}: {dependency}",
                    package["name"]
                );
            }
        }
    }
}

#[test]
fn the_oldest_compiler_is_stated_and_enough_for_every_library() {
    let manifest = text("Cargo.toml");
    let stated =
        manifest.split("rust-version = \"").nth(1).and_then(|rest| rest.split('"').next()).expect("stated");
    assert!(
        text("README.md").contains(&format!("({stated} or later)")),
        "README.md says another version than {stated}"
    );
    let number = |version: &str| {
        let mut parts = version.split('.').map(|part| part.parse::<u32>().unwrap_or(0));
        (parts.next().unwrap_or(0), parts.next().unwrap_or(0))
    };
    for package in packages() {
        if let Some(needed) = package["rust_version"].as_str() {
            assert!(
                number(needed) <= number(stated),
                "{} needs Rust {needed}, {stated} is stated",
                package["name"]
            );
        }
    }
}
