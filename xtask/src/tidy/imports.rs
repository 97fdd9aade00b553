//! Who may import whom. The direction of the imports is the architecture: the physics cannot learn of the
//! optimiser, nor any analysis of the virtual wind tunnel's answers, if their manifests do not list them.

use std::path::Path;

use serde_json::Value;

use super::cargo;
use super::complaint::Complaint;
use wingroot::failure::Failure;

/// Every package of ours and the packages of ours it may depend on, in code and tests.
const MAY_IMPORT: &[(&str, &[&str])] = &[
    ("nastran", &[]),
    ("fourier", &[]),
    ("report", &[]),
    ("shipped", &[]),
    ("truth", &[]),
    ("loads", &["nastran"]),
    ("response", &["nastran"]),
    ("structure", &["nastran"]),
    ("aero", &["nastran"]),
    ("coupling", &["nastran", "structure", "aero"]),
    ("calibrate", &["nastran", "structure", "aero", "coupling"]),
    ("maneuver", &["nastran", "fourier", "structure", "aero", "coupling"]),
    ("fullaircraft", &["nastran", "loads", "structure", "aero", "coupling", "maneuver"]),
    ("free", &["nastran", "response"]),
    ("discover", &["nastran", "fourier", "aero", "coupling", "calibrate", "maneuver", "response"]),
    ("tunnel", &["nastran", "structure", "aero", "coupling", "calibrate", "maneuver"]),
    ("hidden", &["nastran", "structure", "aero", "coupling", "maneuver", "tunnel", "discover", "truth"]),
    (
        "validation",
        &["nastran", "structure", "aero", "coupling", "calibrate", "maneuver", "fullaircraft", "response"],
    ),
    (
        "wingroot",
        &[
            "nastran",
            "loads",
            "structure",
            "aero",
            "coupling",
            "calibrate",
            "maneuver",
            "fullaircraft",
            "tunnel",
            "report",
            "response",
            "discover",
            "free",
            "hidden",
            "shipped",
        ],
    ),
    ("python", &["wingroot"]),
    (
        "xtask",
        &[
            "nastran",
            "loads",
            "structure",
            "aero",
            "coupling",
            "calibrate",
            "maneuver",
            "fullaircraft",
            "report",
            "truth",
            "validation",
            "discover",
            "hidden",
            "response",
            "tunnel",
            "wingroot",
        ],
    ),
];

/// Libraries that only the named packages may use: each has one seam.
const ONLY_IN: &[(&str, &[&str])] = &[
    ("clarabel", &["calibrate"]),
    ("kuva", &["report"]),
    ("plotly", &["report"]),
    (
        "rand_chacha",
        &["calibrate", "tunnel", "loads", "response", "discover", "free", "hidden", "truth", "xtask"],
    ),
    ("rand_distr", &["calibrate", "tunnel", "loads", "response", "discover", "hidden", "truth", "xtask"]),
    ("rustfft", &["fourier"]),
    ("flate2", &["shipped"]),
    ("tar", &["shipped"]),
    ("ode_solvers", &["fullaircraft"]),
    ("clap", &["wingroot", "xtask"]),
    ("codespan-reporting", &["wingroot"]),
    ("hdf5-pure", &["wingroot"]),
    ("parquet", &["wingroot"]),
    ("indicatif", &["wingroot"]),
    ("tracing-subscriber", &["wingroot"]),
    ("numpy", &["python"]),
    ("pyo3", &["python"]),
    ("pythonize", &["python"]),
];

/// A package of the workspace and what it depends on directly.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Package {
    /// Its name.
    pub name: String,
    /// Names of the packages of ours it depends on.
    pub ours: Vec<String>,
    /// Names of the libraries of others it depends on.
    pub theirs: Vec<String>,
}

/// The packages of the workspace, from `cargo metadata`.
///
/// # Errors
/// If cargo does not run or answers something unexpected.
pub fn packages(root: &Path) -> Result<Vec<Package>, Failure> {
    let said = cargo::said(root, &["metadata", "--no-deps", "--offline", "--format-version", "1"])?;
    let metadata: Value = serde_json::from_slice(&said).map_err(Failure::computation)?;
    let list = metadata["packages"]
        .as_array()
        .ok_or_else(|| Failure::computation("cargo metadata lists no packages"))?;
    Ok(list.iter().map(package).collect())
}

/// The name by which our code imports a package: published names have a prefix that library names do not have.
fn library(package: &str) -> String {
    package.strip_prefix("wingroot-").unwrap_or(package).to_owned()
}

fn package(value: &Value) -> Package {
    let dependencies = value["dependencies"].as_array().map_or(&[][..], Vec::as_slice);
    // A dependency of ours has a path, one of others a registry.
    let names = |ours: bool| {
        let chosen = dependencies.iter().filter(|d| d["path"].is_string() == ours);
        chosen.filter_map(|d| d["name"].as_str().map(library)).collect()
    };
    Package {
        name: library(value["name"].as_str().unwrap_or_default()),
        ours: names(true),
        theirs: names(false),
    }
}

/// Complaints about imports against the direction, and about packages the table does not know.
pub fn check(packages: &[Package]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for package in packages {
        let name = package.name.as_str();
        let Some((_, allowed)) = MAY_IMPORT.iter().find(|(known, _)| *known == name) else {
            complaints
                .push(Complaint::new(name, "the package is not in the table of xtask/src/tidy/imports.rs"));
            continue;
        };
        for import in package.ours.iter().filter(|import| !allowed.contains(&import.as_str())) {
            complaints
                .push(Complaint::new(name, format!("imports `{import}`, against the direction of imports")));
        }
        for (library, users) in ONLY_IN {
            if package.theirs.iter().any(|used| used == library) && !users.contains(&name) {
                let message = format!("uses `{library}`, which only {} may use", users.join(", "));
                complaints.push(Complaint::new(name, message));
            }
        }
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    fn package(name: &str, ours: &[&str], theirs: &[&str]) -> Package {
        let owned = |list: &[&str]| list.iter().map(ToString::to_string).collect();
        Package { name: name.into(), ours: owned(ours), theirs: owned(theirs) }
    }

    #[test]
    fn an_import_against_the_direction_is_found() {
        let packages = [
            package("maneuver", &["coupling", "calibrate"], &[]),
            package("validation", &["tunnel"], &[]),
            package("coupling", &["aero"], &["clarabel", "faer"]),
            package("novel", &[], &[]),
            package("aero", &["nastran"], &["faer"]),
        ];
        let places: Vec<String> = check(&packages).into_iter().map(|c| c.place).collect();
        assert_eq!(places, ["maneuver", "validation", "coupling", "novel"]);
    }

    #[test]
    fn the_truth_of_vortices_knows_nothing_of_ours_and_no_analysis_knows_it() {
        for (name, imports) in MAY_IMPORT {
            assert!(*name != "truth" || imports.is_empty(), "the truth imports {imports:?}");
            assert!(
                ["hidden", "xtask"].contains(name) || !imports.contains(&"truth"),
                "{name} imports the truth"
            );
            let analyses = !["hidden", "wingroot", "python", "xtask"].contains(name);
            assert!(!analyses || !imports.contains(&"hidden"), "{name} imports the truth by `hidden`");
        }
    }

    #[test]
    fn the_table_itself_has_no_circle() {
        let mut done: Vec<&str> = Vec::new();
        for (name, imports) in MAY_IMPORT {
            assert!(imports.iter().all(|import| done.contains(import) || *import == "report"), "{name}");
            done.push(name);
        }
    }
}
