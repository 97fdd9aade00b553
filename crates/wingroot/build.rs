//! Tells the program which commit it is built from.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // The log of HEAD grows with every commit; a path that is not there would make cargo run this always.
    for file in ["../../.git/logs/HEAD", "../../.git/HEAD", ".cargo_vcs_info.json"] {
        if Path::new(file).exists() {
            println!("cargo::rerun-if-changed={file}");
        }
    }
    println!("cargo::rustc-env=WINGROOT_COMMIT={}", commit().unwrap_or_else(|| "no commit known".to_owned()));
}

/// From git in a checkout, from cargo's note in a published package.
fn commit() -> Option<String> {
    let published = std::fs::read_to_string(".cargo_vcs_info.json").ok();
    let sha =
        published.and_then(|text| Some(text.split("\"sha1\": \"").nth(1)?.split('"').next()?.to_owned()));
    let sha = sha.or_else(|| {
        let git = Command::new("git").args(["rev-parse", "HEAD"]).output().ok()?;
        git.status.success().then(|| String::from_utf8_lossy(&git.stdout).trim().to_owned())
    })?;
    sha.get(..10).map(|short| format!("commit {short}"))
}
