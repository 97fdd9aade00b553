//! Packs each example folder, and the documents, into one compressed archive each.

use std::fs::File;
use std::path::{Path, PathBuf};

use flate2::Compression;
use flate2::write::GzEncoder;

/// What is packed: folders of the repository.
const FOLDERS: [&str; 7] =
    ["data/bristol", "data/mav", "data/own_wing", "data/pazy", "data/tuflex", "data/weber_brebner", "docs"];
/// What measurements were generated from stays out of a wing of one's own.
const LEFT_OUT: &str = "made_with";

fn main() -> std::io::Result<()> {
    let out = std::env::var_os("OUT_DIR").map(PathBuf::from).unwrap_or_default();
    println!("cargo::rerun-if-changed=build.rs");
    for packed in FOLDERS {
        let folder = in_repository(packed);
        let name = packed.rsplit('/').next().unwrap_or(packed);
        println!("cargo::rerun-if-changed={}", folder.display());
        let packed =
            GzEncoder::new(File::create(out.join(format!("{name}.tar.gz")))?, Compression::default());
        let mut archive = tar::Builder::new(packed);
        // Neither times nor owners, so that the same files give the same program.
        archive.mode(tar::HeaderMode::Deterministic);
        for file in files_below(&folder)? {
            if let Ok(inside) = file.strip_prefix(&folder) {
                archive.append_path_with_name(&file, inside)?;
            }
        }
        archive.into_inner()?.finish()?;
    }
    Ok(())
}

/// `data` and `docs` are links to the repository's folders, and folders in a published package; a checkout without links
/// (Windows) has neither.
fn in_repository(folder: &str) -> PathBuf {
    // asked when it runs: a folder that was moved brings the script compiled at its former place
    let here = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let linked = here.join(folder);
    if linked.is_dir() { linked } else { here.join("../..").join(folder) }
}

fn files_below(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next)? {
            let path = entry?.path();
            if !path.is_dir() {
                files.push(path);
            } else if !path.ends_with(LEFT_OUT) {
                folders.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}
